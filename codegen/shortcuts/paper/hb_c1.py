"""Stage 3, Section 3.2: harmonic balance with one C1 function, equations (11) to (14).

Input: the Fourier series of `fourier` and the function ``g1`` of (12), from `g1`.
Output: `derive`, the record of the method.
"""

import sympy as sp

from ...system import Equation, GalerkinSystem, Inner, require_zero
from . import fourier, hb
from . import g1 as smooth
from .g1 import (
    SCALE,
    SCALE_S,
    SMOOTHSTEP,
    by_cosine,
    by_g1,
    by_one,
    by_sine,
    through_tables,
    u,
)
from .inner_product import N, j, k, n
from .oscillator import INITIAL_STATE, PHASES, SLIP, T, omega_n, t, t1, x_s
from .slip_moments import TABLES, moments, with_derivatives
from .slip_moments import definitions as moment_definitions

c1 = sp.Symbol("c1", real=True)
g1 = sp.Function("g1")(t)
R2 = sp.Function("R2")(t)

#: ``g1`` put through the left side of (1).
through_g1 = sp.Derivative(g1, (t, 2)) + omega_n**2 * g1

#: ``H_0``, ``H^s_j``, ``H^c_j``, ``H_g``: the residual of ``g1``, which is zero in stick,
#: tested by each function.
H0, Hg = sp.symbols("H_0 H_g", real=True)
Hs, Hc = sp.IndexedBase("H^s"), sp.IndexedBase("H^c")


#: Them, and what the kernel calls their test functions.
COLUMNS = {H0: "one", Hs[j]: "sine", Hc[j]: "cosine", Hg: "g1"}


#: What ``c1`` adds to (9).
G1_AT_0 = smooth.G1_STICK.subs(t, 0)

#: Left side of (9).
DISPLACEMENT_AT_0 = fourier.DISPLACEMENT_AT_0 + c1 * G1_AT_0


def velocity_of_g1() -> sp.Expr:
    """Return what ``c1`` adds to (10)."""
    return smooth.G1_STICK.diff(t)


def velocity_at_0() -> sp.Expr:
    """Return the left side of (10)."""
    return fourier.velocity_at_0() + c1 * velocity_of_g1()


def _jacobian() -> tuple[Equation, ...]:
    """Return the derivatives that ``c1`` and (14) add to those of the Fourier series."""
    rows = []
    columns = {"5": H0, "6": Hs[j], "7": Hc[j], "14": Hg, "10": velocity_of_g1()}
    for number, column in columns.items():
        label = sp.Derivative(sp.Symbol(f"R_{number}"), c1, evaluate=False)
        rows.append(Equation("", f"({number}) by c1", (label, column)))
    for unknown, row in ((fourier.a0, H0 / 2), (fourier.a[n], Hs[n]), (fourier.b[n], Hc[n])):
        label = sp.Derivative(sp.Symbol("R_14"), unknown, evaluate=False)
        rows.append(Equation("", "(14) by the series", (label, row)))
    for l, tables in TABLES.items():
        if l == 0:
            continue
        for table, value in zip(tables, moments(l), strict=True):
            for time, derivative in zip((t1, T), with_derivatives(value)[1:], strict=True):
                label = sp.Derivative(table[k], time, evaluate=False)
                rows.append(Equation("", "time derivative", (label, derivative)))
    for name, value in (
        (H0, by_one()),
        (Hs[j], by_sine()),
        (Hc[j], by_cosine()),
        (Hg, by_g1()),
    ):
        scale = SCALE_S**2 if name is Hg else SCALE_S
        for time in (t1, T):
            label = sp.Derivative(name, time, evaluate=False)
            sides = (label, through_tables(scale * value, time))
            rows.append(Equation("", "time derivative", sides))
    return tuple(rows)


def _over_slip(test: sp.Expr) -> sp.Expr:
    return sp.Integral(through_g1 * test, (t, SLIP.start, SLIP.end))


def _definitions() -> tuple[Equation, ...]:
    """Return the inner products of the residual of ``g1``: integrals over slip alone."""
    moments = {
        H0: (_over_slip(sp.Integer(1)), sp.factor(SCALE_S * by_one())),
        Hs[j]: (_over_slip(fourier.TEST["6"]), SCALE_S * by_sine()),
        Hc[j]: (_over_slip(fourier.TEST["7"]), SCALE_S * by_cosine()),
        Hg: (_over_slip(g1), SCALE_S**2 * by_g1()),
    }
    tests = {H0: "1", Hs[j]: "sin(j omega_0 t)", Hc[j]: "cos(j omega_0 t)", Hg: "g1"}
    names = {h: (f"g1_by_{test}", "g1_column") for h, test in COLUMNS.items()}
    return tuple(
        Equation("", f"residual of g1 tested with {tests[h]}", (h, *moments[h]), "", names[h])
        for h in moments
    )


def _tail() -> tuple[Equation, ...]:
    """Return the harmonics that the kernel takes away from ``g1``, leaving its tail."""
    a0_of_g1 = sp.Symbol("gamma_0", real=True)
    sines, cosines = sp.IndexedBase("gamma^s"), sp.IndexedBase("gamma^c")
    of, after = "of g1/(T s**3), which the kernel takes away", "harmonics_of_g1"
    rows = {
        "twice the mean": (a0_of_g1, smooth.mean(), "mean_of_g1"),
        "sine harmonic": (sines[j], smooth.sine_of_g1(), "sine_of_g1"),
        "cosine harmonic": (cosines[j], smooth.cosine_of_g1(), "cosine_of_g1"),
    }
    return tuple(
        Equation("", f"{title} {of}", (name, value), "", (function, after))
        for title, (name, value, function) in rows.items()
    )


#: How the kernel puts the column of ``c1`` together, for the tail of ``g1``.
TAIL = ("g1_column", "tail_column", "c1_product")


def orthogonality() -> tuple[Equation, ...]:
    """Return (5), (6), (7) for ``R2`` and (14)."""
    rows = []
    columns = {"5": H0, "6": Hs[j], "7": Hc[j]}
    for number, column in columns.items():
        sides = (Inner(R2, fourier.TEST[number]), fourier.orthogonality(number) + c1 * column)
        where = "" if number == "5" else "j = 1, ..., N"
        title = f"({number}) for R2"
        functions = (*fourier.functions(number), f"g1_by_{COLUMNS[column]}", *TAIL)
        rows.append(Equation(number, title, (*sides, sp.Integer(0)), where, functions))
    forcing = fourier.forcing() * smooth.slip_integral(smooth.g_in_slip())
    require_zero([("forcing of (14)", forcing + x_s * by_one())])
    series = sp.Sum(fourier.a[n] * Hs[n] + fourier.b[n] * Hc[n], (n, 1, N))
    closed = fourier.a0 * H0 / 2 + series + c1 * Hg - x_s * H0
    last = (Inner(R2, g1), closed, sp.Integer(0))
    functions = ("g1_by_g1", *TAIL, "g1_condition")
    rows.append(Equation("14", "orthogonal to g1", last, functions=functions))
    return tuple(rows)


def derive() -> GalerkinSystem:
    """Derive Section 3.2 from (1), (2) and the expansion (11) with ``g1`` of (12).

    Returns
    -------
    GalerkinSystem
        With the ``2 N + 4`` conditions (5), (6), (7), (14), (9), (10).

    Raises
    ------
    DerivationError
        If `g1` is not periodic, not C1, or not a smoothstep, if (14) is not symmetric,
        or if a harmonic of `g1` is wrong.
    """
    smooth.check_g1()
    smooth.check_symmetry()
    smooth.check_harmonics()
    G1_STICK, G1_SLIP = smooth.G1_STICK, smooth.G1_SLIP
    stick, slip = (f"{p.start} <= t < {p.end}" for p in PHASES)
    R1 = hb.R1
    in_stick, in_slip = (
        ("harmonic_acceleration", f"residual_in_{p.name}", "residual_and_tail") for p in PHASES
    )
    return GalerkinSystem(
        method="hb-c1",
        section="3.2",
        title="Classical harmonic balance with one C1 term",
        unknowns="a0, a_1..a_N, b_1..b_N beside the tail of g1, c1 T s**3, t1, T",
        coefficients=(*hb.COEFFICIENTS, c1),
        equations=(
            Equation("11", "expansion", (hb.x(t), fourier.SERIES + c1 * g1)),
            hb.frequency_row(),
            Equation(
                "12",
                "g1 in stick",
                (g1, G1_STICK, SCALE * smooth.G_STICK),
                stick,
                ("g1_in_stick",),
            ),
            Equation(
                "12",
                "g1 in slip",
                (g1, G1_SLIP, SCALE * (SMOOTHSTEP - t / T)),
                slip,
                ("g1_in_slip",),
            ),
            Equation("", "time in slip", (u, (t - t1) / (T - t1))),
            Equation("13", "residual in stick", (R2, R1), stick, in_stick),
            Equation("13", "residual in slip", (R2, R1 + c1 * through_g1), slip, in_slip),
            *orthogonality(),
            *fourier.definitions(),
            *_definitions(),
            *moment_definitions(),
            *_tail(),
            Equation(
                "9",
                "displacement at t = 0",
                (hb.x(0), DISPLACEMENT_AT_0, INITIAL_STATE[0]),
                functions=("initial_state", "initial_residual", "tail_at_0"),
            ),
            Equation(
                "10",
                "velocity at t = 0",
                (hb.v0, velocity_at_0(), INITIAL_STATE[1]),
                functions=(
                    "velocity_weight",
                    "g1_velocity",
                    "initial_state",
                    "initial_residual",
                    "tail_at_0",
                ),
            ),
        ),
        jacobian=(
            *fourier.jacobian(),
            *fourier.closure_jacobian(velocity_at_0()),
            *_jacobian(),
        ),
        forms=(*fourier.closed_forms(), *smooth.closed_forms()),
    )
