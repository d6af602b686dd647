"""Stage 3, Section 3.1: classical harmonic balance, equations (3) to (10).

Input: the oscillator and the Fourier series.  Output: `derive`, the record of the method.
"""

import sympy as sp

from ...system import Equation, GalerkinSystem, Inner
from . import fourier
from .inner_product import FREQUENCY, N, n, omega_0
from .oscillator import INITIAL_STATE, PHASES, t

x = sp.Function("x")
R1 = sp.Function("R1")(t)
v0 = sp.Derivative(x(t), t).subs(t, 0)

COEFFICIENTS = (fourier.a0, fourier.a[n], fourier.b[n])


def frequency_row() -> Equation:
    """Return what ``omega_0`` is."""
    return Equation("", "frequency", (omega_0, FREQUENCY[omega_0]), functions=("angle",))


def residual() -> tuple[Equation, ...]:
    """Return (4) phase by phase, with the friction force of (2) substituted."""
    rows = []
    for position, phase in enumerate(PHASES):
        sine, cosine, constant = (
            sp.expand(fourier.homogeneous(phi)[position] / phi) * phi
            for phi in (fourier.SINE, fourier.COSINE, fourier.CONSTANT)
        )
        total = fourier.a0 * constant + phase.residual(sp.Integer(0))
        total += sp.Sum(fourier.a[n] * sine + fourier.b[n] * cosine, (n, 1, N))
        where = f"{phase.start} <= t < {phase.end}"
        rows.append(Equation("4", f"residual in {phase.name}", (R1, total), where))
    return tuple(rows)


def _orthogonality(number: str) -> Equation:
    title = {"5": "the constant", "6": "sin(j omega_0 t)", "7": "cos(j omega_0 t)"}
    inner = Inner(R1, fourier.TEST[number])
    closed = fourier.orthogonality(number)
    where = "" if number == "5" else "j = 1, ..., N"
    sides = (inner, closed, sp.Integer(0))
    functions = fourier.functions(number)
    return Equation(number, f"orthogonal to {title[number]}", sides, where, functions)


def inner_product_statement() -> tuple[sp.Expr, sp.Expr]:
    """Return the two sides of (8): the inner product, and its split over the phases."""
    first, second = sp.Function("a")(t), sp.Function("b")(t)
    parts = (sp.Integral(first * second, (t, p.start, p.end)) for p in PHASES)
    return Inner(first, second), sp.Add(*parts, evaluate=False)


def derive() -> GalerkinSystem:
    """Derive Section 3.1 from (1), (2) and the expansion (3).

    Returns
    -------
    GalerkinSystem
        With the ``2 N + 3`` conditions (5), (6), (7), (9), (10).
    """
    return GalerkinSystem(
        method="hb",
        section="3.1",
        title="Classical harmonic balance (Fourier series)",
        unknowns="a0, a_1..a_N, b_1..b_N, t1, T",
        coefficients=COEFFICIENTS,
        equations=(
            Equation("3", "expansion", (x(t), fourier.SERIES)),
            frequency_row(),
            *residual(),
            *(_orthogonality(number) for number in ("5", "6", "7")),
            Equation(
                "8", "inner product", inner_product_statement(), functions=("slip_integrals",)
            ),
            *fourier.definitions(),
            Equation(
                "9",
                "displacement at t = 0",
                (x(0), fourier.DISPLACEMENT_AT_0, INITIAL_STATE[0]),
                functions=("initial_state", "initial_residual"),
            ),
            Equation(
                "10",
                "velocity at t = 0",
                (v0, fourier.velocity_at_0(), INITIAL_STATE[1]),
                functions=("velocity_weight", "initial_state", "initial_residual"),
            ),
        ),
        jacobian=(*fourier.jacobian(), *fourier.closure_jacobian(fourier.velocity_at_0())),
        forms=fourier.closed_forms(),
    )
