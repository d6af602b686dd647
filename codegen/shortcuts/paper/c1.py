"""Stage 3, Section 3.3: the expansion in C1 functions, equations (15) to (20).

Input: the oscillator and the acceleration (15), a polynomial in slip.
Output: `derive`, the record of the method.

The paper's monomials are what a reader is shown.  They are hopeless as a basis for numbers
beyond ``N`` about 9, so the kernel spans the same space by shifted Legendre polynomials
``P_n*(u)``, ``u = (t - t1)/s``; integrated twice they have three terms, and the matrices
are banded.
"""

from dataclasses import dataclass
from functools import cache

import sympy as sp

from ...system import Equation, GalerkinSystem, Inner, require_zero
from . import c1_legendre
from .c1_legendre import s
from .inner_product import N
from .oscillator import INITIAL_STATE, PHASES, SLIP, STICK, T, t, t1

n, k = sp.symbols("n k", integer=True, nonnegative=True)
d = sp.IndexedBase("d", real=True)
e0, e1 = sp.symbols("e_0 e_1", real=True)
tau = sp.Symbol("tau", nonnegative=True)
x = sp.Function("x")
R3 = sp.Function("R3")(t)
H = sp.Heaviside(t - t1)

#: One term of (15) in slip, and of (16): the same integrated twice from ``t1``.
MONOMIAL = tau**n
_inner = sp.Symbol("tau_", nonnegative=True)


def integrate(rate: sp.Expr) -> sp.Expr:
    """Return the integral of `rate` over ``tau`` from 0, where slip starts."""
    return sp.factor(sp.integrate(rate.subs(tau, _inner), (_inner, 0, tau)))


@cache
def term_velocity() -> sp.Expr:
    """Return the velocity of a term of (16)."""
    return integrate(MONOMIAL)


@cache
def trial() -> sp.Expr:
    """Return a term of (16)."""
    return integrate(term_velocity())


#: Displacement (16): a line, and in slip the series besides.
LINE = e0 * t + e1
START = {e0: INITIAL_STATE[1], e1: INITIAL_STATE[0]}


def check_c1() -> None:
    """Check that (16) is C1: its terms and their velocities vanish where slip starts.

    Raises
    ------
    DerivationError
        If a term of (16) has a jump, or does not have (15) as its acceleration.
    """
    require_zero(
        [
            ("displacement at t1", trial().subs(tau, 0)),
            ("velocity at t1", term_velocity().subs(tau, 0)),
            ("velocity of (16)", trial().diff(tau) - term_velocity()),
            ("acceleration of (16)", term_velocity().diff(tau) - MONOMIAL),
            ("residual of the line in stick", STICK.residual(LINE)),
        ]
    )


def _slip_residual() -> tuple[sp.Expr, sp.Expr]:
    """Return the residual (17) in slip: the factor of ``d_n``, and the rest.

    Slip is linear with constant coefficients, so a term of (16) may start at 0 instead of
    at ``t1``.
    """
    force = SLIP.residual(sp.Integer(0))
    factor = sp.expand(SLIP.residual(trial().subs(tau, t)) - force).subs(t, tau)
    terms = (sp.powsimp(sp.factor(term)) for term in sp.Add.make_args(factor))
    return sp.Add(*terms), SLIP.residual(LINE)


def _tidy(expression: sp.Expr) -> sp.Expr:
    """Return a sum of terms ``coefficient * s**power``, each factored and merged."""
    terms = (
        term.as_independent(s, as_Add=False)
        for term in sp.Add.make_args(sp.expand_mul(expression, deep=False))
    )
    return sp.Add(*(sp.factor(c) * sp.powsimp(power) for c, power in terms))


def _over_slip(expression: sp.Expr) -> sp.Expr:
    """Return the integral of a sum of powers of ``tau`` over slip, term by term."""
    terms = sp.Add.make_args(sp.expand(expression, power_exp=False))
    return _tidy(sp.Add(*(sp.integrate(sp.powsimp(q), (tau, 0, s)) for q in terms)))


@dataclass(frozen=True)
class Condition:
    """A condition linear in the ``d_n``: ``weight * (sum d_n entry + load) = 0``."""

    number: str
    weight: sp.Expr
    entry: sp.Expr
    load: sp.Expr

    @property
    def closed(self) -> sp.Expr:
        """The left side in closed form, in ``s = T - t1``."""
        return self._weighted(self.entry, self.load)

    def by_coefficient(self, m: sp.Symbol) -> sp.Expr:
        """Return the derivative with respect to ``d_m``."""
        return self.weight * self.entry.subs(n, m)

    def by_time(self, time: sp.Symbol) -> sp.Expr:
        """Return the derivative by ``t1`` or ``T``, through ``s`` as well."""
        entry, load = (
            _tidy(value.diff(time) + value.diff(s) * (T - t1).diff(time))
            for value in (self.entry, self.load)
        )
        return self._weighted(entry, load)

    def _weighted(self, entry: sp.Expr, load: sp.Expr) -> sp.Expr:
        terms = (self.weight * term for term in sp.Add.make_args(load))
        return sp.Add(sp.Sum(self.weight * entry * d[n], (n, 0, N)), *terms)


def conditions() -> tuple[Condition, Condition, Condition]:
    """Return (18) for the test function of index ``k``, (19) and (20), in closed form.

    The test function is `trial` of index ``k``: a constant times ``tau**(k + 2)``.
    """
    factor, rest = _slip_residual()
    power = tau ** (k + 2)
    weight = trial().subs(n, k) / power
    load = _over_slip(rest.subs(t, t1 + tau).subs(START) * power)
    one = sp.Integer(1)
    return (
        Condition("18", sp.powsimp(weight), _over_slip(factor * power), load),
        Condition("19", one, trial().subs(tau, s), START[e0] * T),
        Condition("20", one, term_velocity().subs(tau, s), sp.Integer(0)),
    )


#: How the kernel puts (17) together, in Legendre polynomials.
RESIDUAL = ("line_constant", "line_slope", "time_scale", "add_integral", "slip_residual")


def _equations() -> tuple[Equation, ...]:
    """Return (15) to (20) as the paper has them, with (18) in closed form."""
    factor, rest = _slip_residual()
    shifted = {tau: t - t1}
    series = sp.Sum(d[n] * trial().subs(shifted), (n, 0, N))
    acceleration = sp.Sum(d[n] * MONOMIAL.subs(shifted), (n, 0, N))
    slip = sp.Sum(d[n] * factor.subs(shifted), (n, 0, N)) + rest
    orthogonality, displacement, velocity = conditions()
    zero = sp.Integer(0)
    x_T, v_T = (f(t + T) - f(t) for f in (x, sp.Function("xdot")))
    test = Inner(R3, H * trial().subs(shifted).subs(n, k))
    stick_t, slip_t = (f"{q.start} <= t < {q.end}" for q in PHASES)
    return (
        Equation("15", "acceleration", (x(t).diff(t, 2), H * acceleration)),
        Equation("16", "expansion", (x(t), H * series + LINE)),
        Equation("", "constants of integration", (e0, START[e0])),
        Equation("", "constants of integration", (e1, START[e1])),
        Equation("17", "residual in stick", (R3, STICK.residual(LINE)), stick_t),
        Equation("17", "residual in slip", (R3, slip), slip_t, RESIDUAL),
        Equation(
            "18",
            "orthogonality",
            (test, orthogonality.closed, zero),
            "k = 0, ..., N",
            ("twice_integrated", "norm", "project"),
        ),
        Equation("", "slip duration", (s, T - t1)),
        Equation(
            "19",
            "periodic displacement",
            (x_T, displacement.closed, zero),
            functions=("displacement_gain", "displacement_weights"),
        ),
        Equation(
            "20",
            "periodic velocity",
            (v_T, velocity.closed, zero),
            functions=("velocity_gain", "velocity_weight"),
        ),
    )


def _jacobian() -> tuple[Equation, ...]:
    """Return the derivatives of (18), (19), (20) with respect to ``d_m``, ``t1``, ``T``."""
    m = sp.Symbol("m", integer=True, nonnegative=True)
    rows = []
    for condition in conditions():
        derivatives = {d[m]: condition.by_coefficient(m)}
        derivatives |= {time: condition.by_time(time) for time in (t1, T)}
        for unknown, derivative in derivatives.items():
            label = sp.Symbol(f"R_{condition.number}")
            sides = (sp.Derivative(label, unknown, evaluate=False), derivative)
            rows.append(Equation("", f"({condition.number}) by {unknown}", sides))
    return tuple(rows)


def derive() -> GalerkinSystem:
    """Derive Section 3.3 from (1), (2) and the acceleration (15).

    Returns
    -------
    GalerkinSystem
        With the ``N + 3`` conditions (18), (19), (20); `equations` in the paper's
        monomials, `forms` in shifted Legendre polynomials.

    Raises
    ------
    DerivationError
        If (16) is not C1, or if the Legendre polynomials are not integrated right.
    """
    check_c1()
    c1_legendre.check_integrals()
    return GalerkinSystem(
        method="c1",
        section="3.3",
        title="C1 expansion",
        unknowns="p_0..p_N (acceleration in slip, in P_n*(u)), t1, T",
        coefficients=(d[n],),
        equations=(*_equations(), *c1_legendre.equations(d, LINE.subs(START))),
        jacobian=_jacobian(),
        forms=c1_legendre.closed_forms(LINE.subs(START)),
    )
