"""Stage 2d: the series of Section 3.3 in shifted Legendre polynomials, twice integrated.

Input: the line that stick continues into slip.
Output: (18), (19), (20) in the coefficients ``p_n`` of the slip acceleration
``sum p_n P_n*(u)``, ``u = (t - t1)/s``: the space of (15) in a basis that keeps its digits.

Two facts suffice, both with a symbolic index: ``P_n*`` integrates to
``(P_{n+1}* - P_{n-1}*)/(2 (2 n + 1))`` from 0, and ``int_0^1 P_n*^2 du = 1/(2 n + 1)``.
With ``P_{-1} = -P_0`` and ``P_{-2} = -P_1`` the first holds for ``n = 0`` as well.
"""

from collections.abc import Mapping
from functools import cache
from types import MappingProxyType

import sympy as sp

from ...functions import ShiftedLegendre, TwiceIntegrated
from ...system import ClosedForm, Equation, require_zero
from .inner_product import N
from .oscillator import T, dimensionless, t, t1
from .slip_moments import legendre_coefficients

n, l = sp.symbols("n l", integer=True, nonnegative=True)
s = sp.Symbol("s", positive=True)
u = sp.Symbol("u", nonnegative=True)
p = sp.IndexedBase("p", real=True)
p0, p1 = sp.symbols("p0 p1", real=True)


#: A combination of ``P_{n+shift}*``, by `shift`.
Combination = dict[int, sp.Expr]


def integrate(series: Combination) -> Combination:
    """Return the integral from 0 of a combination of shifted Legendre polynomials."""
    result: Combination = {}
    for shift, coefficient in series.items():
        half = coefficient / (2 * (2 * (n + shift) + 1))
        result[shift + 1] = result.get(shift + 1, 0) + half
        result[shift - 1] = result.get(shift - 1, 0) - half
    return result


def _reciprocal(value: sp.Expr) -> sp.Expr:
    """Return `value` as one over a polynomial: then exact for a `Fraction`, too."""
    return 1 / sp.expand(1 / sp.factor(value))


@cache
def twice() -> Mapping[int, sp.Expr]:
    """Return ``Q_n``: its second derivative is ``P_n*``, and it is zero with its slope at 0."""
    found = integrate(integrate({0: sp.Integer(1)}))
    return MappingProxyType({shift: _reciprocal(value) for shift, value in found.items()})


def reflected(index: int) -> tuple[int, int]:
    """Return (sign, index) of the polynomial that stands for ``P_index``."""
    return (1, index) if index >= 0 else (-1, -1 - index)


def twice_integrated(degree: int) -> sp.Expr:
    """Return ``Q_degree(u)`` from `twice`, as a polynomial."""
    total = sp.Integer(0)
    for shift, value in twice().items():
        sign, index = reflected(degree + shift)
        total += sign * value.subs(n, degree) * sp.legendre(index, 2 * u - 1)
    return sp.expand(total)


def check_integrals() -> None:
    """Check `twice` against SymPy's own polynomials, the first two and a few besides.

    Raises
    ------
    DerivationError
        If ``Q_n''`` is not ``P_n*`` or ``Q_n`` does not start from zero with slope zero.
    """
    for degree in (0, 1, 2, 3, 7):
        Q = twice_integrated(degree)
        polynomial = sp.legendre(degree, 2 * u - 1)
        name = f"Q_{degree}"
        require_zero(
            [
                (f"acceleration of {name}", Q.diff(u, 2) - polynomial),
                (f"{name} at t1", Q.subs(u, 0)),
                (f"slope of {name} at t1", Q.diff(u).subs(u, 0)),
            ]
        )
    end = sp.Add(*twice().values())
    require_zero([("Q_n(1) for n >= 2", end)])


def line_coefficients(line: sp.Expr) -> tuple[sp.Expr, ...]:
    """Return the line ``V t + x_0`` over slip in ``P_0*, P_1*``, dimensionless."""
    over_slip = dimensionless(line).subs(t, t1 + (T - t1) * u)
    coefficients = legendre_coefficients(over_slip, u)
    return tuple(sp.expand(coefficients[degree]) for degree in (0, 1))


def _with_derivatives(value: sp.Expr) -> tuple[sp.Expr, ...]:
    """Return `value` and its derivatives by ``t1`` and ``T``, with ``s = T - t1``."""
    by_s = value.diff(s)
    return value, value.diff(t1) - by_s, value.diff(T) + by_s


def end_displacement() -> tuple[sp.Expr, sp.Expr]:
    """Return ``Q_0(1)`` and ``Q_1(1)``; for higher ``n`` both ends are zero."""
    return tuple(twice_integrated(degree).subs(u, 1) for degree in (0, 1))


def closed_forms(line: sp.Expr) -> tuple[ClosedForm, ...]:
    """Return the closed forms of Section 3.3, for emission."""
    by = "and its derivatives by t1 and T."
    constant, slope = line_coefficients(line)
    alpha = next(iter(constant.free_symbols - {t1, T}))
    Q0, Q1 = end_displacement()
    gain = T + s**2 * (Q0 * p0 + Q1 * p1)
    return (
        ClosedForm(
            "twice_integrated",
            "P_n* integrated twice: its parts P_{n-2}*, P_n*, P_{n+2}*.",
            (n,),
            tuple(twice()[shift] for shift in (-2, 0, 2)),
        ),
        ClosedForm(
            "norm",
            "Integral of (P_l*)**2 over slip, in u.",
            (l,),
            (1 / (2 * l + 1),),
        ),
        ClosedForm(
            "time_scale",
            f"s**2, what integrating twice in u leaves, {by}",
            (s,),
            _with_derivatives(s**2),
        ),
        ClosedForm(
            "line_constant",
            f"Part P_0* of the line V t + x_0 over slip, {by}",
            (T, alpha, t1),
            (constant, constant.diff(t1), constant.diff(T)),
        ),
        ClosedForm(
            "line_slope",
            f"Part P_1* of the line V t + x_0 over slip, {by}",
            (T, t1),
            (slope, slope.diff(t1), slope.diff(T)),
        ),
        ClosedForm(
            "displacement_gain",
            f"Left side of (19), {by}",
            (T, p0, p1, s),
            _with_derivatives(gain),
        ),
        ClosedForm(
            "displacement_weights",
            "Coefficients of p_0 and p_1 in (19); the others are zero.",
            (s,),
            (gain.diff(p0), gain.diff(p1)),
        ),
        ClosedForm(
            "velocity_gain",
            f"Left side of (20), {by}",
            (p0, s),
            _with_derivatives(s * p0),
        ),
        ClosedForm("velocity_weight", "Coefficient of p_0 in (20).", (s,), (s,)),
    )


def equations(d: sp.IndexedBase, line: sp.Expr) -> tuple[Equation, ...]:
    """Return the change of basis and (18), (19), (20) in it, for the reader."""
    P, Q = ShiftedLegendre, TwiceIntegrated
    rho, q = sp.IndexedBase("rho"), sp.Function("q")
    k = sp.Symbol("k", integer=True, nonnegative=True)
    constant, slope = line_coefficients(line)
    Q0, Q1 = end_displacement()
    monomials = sp.Sum(d[n] * (t - t1) ** n, (n, 0, N))
    title = "dimensionless, in Legendre polynomials"
    parts = sum(twice()[shift] * P(n + shift, u) for shift in (-2, 0, 2))
    projected = sp.Sum(q(k, l) * rho[l] / (2 * l + 1), (l, sp.Max(0, k - 2), k + 2))
    return (
        Equation("", "change of basis", (monomials, sp.Sum(p[n] * P(n, u), (n, 0, N)))),
        Equation("", "integrated twice", (Q(n, u), parts), "P_{-1} = -P_0, P_{-2} = -P_1"),
        Equation(
            "",
            f"residual (17), {title}",
            (
                sp.Sum(rho[l] * P(l, u), (l, 0, N + 2)),
                sp.Sum(p[n] * (P(n, u) + s**2 * Q(n, u)), (n, 0, N))
                + constant * P(0, u)
                + slope * P(1, u),
            ),
        ),
        Equation("", f"(18) {title}", (projected, sp.Integer(0)), "q(k, l): part P_l of Q_k"),
        Equation("", f"(19) {title}", (T + s**2 * (Q0 * p[0] + Q1 * p[1]), sp.Integer(0))),
        Equation("", f"(20) {title}", (s * p[0], sp.Integer(0))),
    )
