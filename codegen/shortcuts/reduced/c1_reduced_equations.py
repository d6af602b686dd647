"""The equations of `c1_reduced` as a reader is shown them, dimensionless.

Input: what the derivation found.  Output: Section 3.3 as one scalar equation in ``s``.
"""

import sympy as sp

from ...system import Equation
from ..paper.c1_legendre import s, u
from ..paper.inner_product import N
from ..paper.oscillator import T, V, omega_n, t, t1, x_s

n, m, j = sp.symbols("n m j", integer=True, nonnegative=True)
lambda_, mu = sp.symbols("lambda mu", real=True)
x, y = sp.Function("x"), sp.Function("y")
J, L, c = (sp.IndexedBase(name) for name in "JLc")


def _part(name: str, end: int, shift: int) -> Equation:
    """Return the even or the odd part of the series at one end."""
    index = 2 * m + shift
    part = sp.Sum((-1) ** m * c[index] * s**index, (m, 0, n))
    title = f"{name} part of J_n and its derivatives at u = {end}"
    return Equation("", title, (sp.Symbol(f"{name}_{end}"), part), "c_0 = 1, none beyond c_n")


def equations(
    ratios: tuple[sp.Expr, sp.Expr], scalar: sp.Expr, stick_duration: sp.Expr
) -> tuple[Equation, ...]:
    """Return the way from (18) to the scalar equation, and t1.

    Parameters
    ----------
    ratios : tuple of Expr
        ``c_{j+1}/c_j`` at u = 1 and at u = 0, in ``n`` and ``j``.
    scalar, stick_duration : Expr
        What is zero, and t1, in the parts for an even and an odd ``n``.
    """
    load = lambda_ * J[N + 1] + mu * J[N + 2]
    solution = sp.Sum((-1) ** m * s ** (-2 * m) * L[2 * m], (m, 0, N))
    coefficients = (
        "at u = 1, c_j: derivative n - j of J_n over its derivative n",
        "at u = 0 the same, its sign changed where j is odd",
    )
    return (
        Equation("", "dimensionless displacement", (y(u), omega_n * (x(t) - x_s) / V)),
        Equation("", "slip duration, in 1/omega_n as all times", (s, T - t1)),
        Equation("", "time in slip, from 0 to 1", (u, (t - t1) / s)),
        Equation("", "Jacobi polynomial", (J[n], sp.jacobi(n, 0, 2, 2 * u - 1))),
        Equation(
            "18",
            "orthogonality: the residual has the last two polynomials alone",
            (y(u).diff(u, 2) / s**2 + y(u), load),
        ),
        Equation(
            "",
            "the polynomial that solves it",
            (y(u), solution),
            "L_m: derivative m of the right side",
        ),
        *(
            Equation("", title, (c[j + 1] / c[j], ratio), "", (f"ratio_at_{end}",))
            for end, title, ratio in zip((1, 0), coefficients, ratios, strict=True)
        ),
        *(_part(("even", "odd")[shift], end, shift) for end in (1, 0) for shift in (0, 1)),
        Equation(
            "19",
            "with (20), the scalar equation; e, o: for the even and the odd n",
            (scalar, sp.Integer(0)),
            "",
            ("scalar_equation",),
        ),
        Equation("", "stick duration", (t1, stick_duration), "", ("stick_duration",)),
    )
