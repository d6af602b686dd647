"""Section 3.3 reduced to one scalar equation in the slip duration ``s``, for any order.

Input: the equations of `c1_legendre`, as a tau method.
Output: `derive`, the record of the reduced kernel.

By (18) the residual is orthogonal to ``u**2`` times every polynomial of degree ``N``, and it
is a polynomial of degree ``N + 2``: so ``y'' + y = lambda J_{N+1}(u) + mu J_{N+2}(u)`` with the
Jacobi polynomials of weight ``u**2`` on (0, 1).  The polynomial that solves it is known,

    y = sum_k (-1)**k s**(-2 k) (lambda J_{N+1} + mu J_{N+2})**(2 k)(u),

and with ``y' = 1`` at both ends of slip and ``y = -alpha`` at the second, two conditions give
``lambda`` and ``mu``, and the third is the equation.  At the ends all derivatives of a Jacobi
polynomial are products; taken from the highest down, their sums are truncated exponential
series in ``i s``, which neither overflow nor cancel.
"""

from dataclasses import dataclass
from functools import cache

import sympy as sp

from ...system import ClosedForm, GalerkinSystem, require_zero
from ..paper.c1_legendre import s, u
from ..paper.oscillator import alpha
from .c1_reduced_equations import equations
from .elimination import condition

n, m, j = sp.symbols("n m j", integer=True, nonnegative=True)

#: ``J_n**(m)`` at u = 1 and u = 0, where ``J_n(u) = P_n^(0,2)(2 u - 1)``.
AT_1 = sp.factorial(n + 2 + m) / sp.factorial(n + 2) * sp.binomial(n, m)
AT_0 = (
    (-1) ** (n - m) * sp.factorial(n + 2 + m) / sp.factorial(n + 2) * sp.binomial(n + 2, n - m)
)


def jacobi(degree: int) -> sp.Expr:
    """Return ``J_degree(u)``, orthogonal on (0, 1) with the weight ``u**2``."""
    return sp.expand(sp.jacobi(degree, 0, 2, 2 * u - 1))


def _ratio(values: sp.Expr) -> sp.Expr:
    """Return term ``j + 1`` over term ``j``, without sign, from the highest derivative down."""
    ratio = sp.combsimp(values.subs(m, n - j - 1) / values.subs(m, n - j))
    return sp.factor(sp.simplify(ratio))


@cache
def ratio_at_1() -> sp.Expr:
    """Return ``c_{j+1}/c_j`` of ``sum_j c_j (-i s)**j`` at u = 1."""
    return _ratio(AT_1)


@cache
def ratio_at_0() -> sp.Expr:
    """Return ``c_{j+1}/c_j`` of ``sum_j c_j (i s)**j`` at u = 0."""
    return -_ratio(AT_0)


@dataclass(frozen=True)
class Ends:
    """Even and odd parts, in ``j``, of the series of one Jacobi polynomial at both ends.

    With an even index the even part is the displacement and the odd part the velocity; with
    an odd index the other way round.
    """

    even_1: sp.Symbol
    odd_1: sp.Symbol
    even_0: sp.Symbol
    odd_0: sp.Symbol

    @classmethod
    def named(cls, letter: str) -> "Ends":
        """Return the parts as symbols that end in `letter`."""
        names = " ".join(f"{part}_{letter}" for part in ("even_1", "odd_1", "even_0", "odd_0"))
        return cls(*sp.symbols(names, real=True))


#: Of ``J_{N+1}``, ``J_{N+2}`` the one with an even index, and the one with an odd index.
EVEN, ODD = Ends.named("e"), Ends.named("o")


def _motions() -> dict[str, tuple[sp.Expr, sp.Expr]]:
    """Return displacement and velocity at both ends for the even and for the odd index.

    Up to a common factor: ``i**n sum_j c_j (-+ i s)**j``, real part and imaginary part.
    """
    return {
        "y1": (EVEN.even_1, ODD.odd_1),
        "v1": (-EVEN.odd_1, ODD.even_1),
        "y0": (EVEN.even_0, -ODD.odd_0),
        "v0": (EVEN.odd_0, ODD.even_0),
    }


def determinants() -> tuple[sp.Expr, sp.Expr]:
    """Return ``D`` and ``M`` with ``alpha = -M/D``.

    ``lambda`` and ``mu`` follow from ``y' = 1`` at both ends, by Cramer's rule; then
    ``y = -alpha`` at ``u = 1``.
    """
    at = _motions()
    (v1_e, v1_o), (v0_e, v0_o) = at["v1"], at["v0"]
    weights = (v1_o - v0_o, v0_e - v1_e)
    D = sp.expand(v0_e * v1_o - v1_e * v0_o)
    return D, sp.Add(*(w * y for w, y in zip(weights, at["y1"], strict=True)))


def stick_duration() -> sp.Expr:
    """Return ``t1 = alpha + y(t1)``.

    Here ``lambda`` and ``mu`` follow from ``y = -alpha`` and ``y' = 1`` at ``u = 1``: their
    determinant is a cosine squared plus a sine squared, and ``D`` is small for small alpha.
    """
    at = _motions()
    (y1_e, y1_o), (v1_e, v1_o), (y0_e, y0_o) = at["y1"], at["v1"], at["y0"]
    for_lambda, for_mu = -alpha * v1_o - y1_o, y1_e + alpha * v1_e
    return alpha + (for_lambda * y0_e + for_mu * y0_o) / (y1_e * v1_o - y1_o * v1_e)


def series(degree: int) -> dict[sp.Symbol, sp.Expr]:
    """Return the parts of `Ends` for the Jacobi polynomial of `degree`, in ``s``."""
    ends = EVEN if degree % 2 == 0 else ODD
    parts = {ends.even_1: 0, ends.odd_1: 0, ends.even_0: 0, ends.odd_0: 0}
    for ratio, targets in (
        (ratio_at_1(), (ends.even_1, ends.odd_1)),
        (ratio_at_0(), (ends.even_0, ends.odd_0)),
    ):
        c = sp.Integer(1)
        for term in range(degree + 1):
            parts[targets[term % 2]] += (-1) ** (term // 2) * c * s**term
            c *= ratio.subs({n: degree, j: term})
    return parts


def check_jacobi() -> None:
    """Check orthogonality and the derivatives at the ends for a few degrees.

    Raises
    ------
    DerivationError
        If a Jacobi polynomial is not orthogonal, or a derivative at an end is wrong.
    """
    for degree in (1, 2, 5):
        J = jacobi(degree)
        claims = [
            (
                f"J_{degree} orthogonal to u**2 u**{i}",
                sp.integrate(sp.expand(J * u ** (i + 2)), (u, 0, 1)),
            )
            for i in range(degree)
        ]
        for order in range(degree + 1):
            at = {n: degree, m: order}
            derivative = J.diff(u, order)
            claims.append((f"J_{degree} at 1", derivative.subs(u, 1) - AT_1.subs(at)))
            claims.append((f"J_{degree} at 0", derivative.subs(u, 0) - AT_0.subs(at)))
        require_zero(claims)


def _other_stick_duration() -> sp.Expr:
    """Return ``t1`` with ``lambda`` and ``mu`` from the velocities, as in `determinants`."""
    at = _motions()
    (v1_e, v1_o), (v0_e, v0_o) = at["v1"], at["v0"]
    y0_e, y0_o = at["y0"]
    D, _ = determinants()
    return alpha + ((v1_o - v0_o) * y0_e + (v0_e - v1_e) * y0_o) / D


def check_elimination() -> None:
    """Check that the scalar equation is the one that elimination in Legendre parts gives.

    And that ``t1`` is the same from either pair of conditions.

    Raises
    ------
    DerivationError
        If it differs at one of the orders that are compared.
    """
    D, M = determinants()
    for order in (1, 2, 3, 4):
        parts = series(order + 1) | series(order + 2)
        reduced = (-M / D).subs(parts)
        require_zero([(f"elimination at order {order}", sp.cancel(reduced - condition(order)))])
        t1 = (stick_duration() - _other_stick_duration()).subs(alpha, -M / D).subs(parts)
        require_zero([(f"stick duration at order {order}", sp.cancel(t1))])


def _with_derivatives(value: sp.Expr) -> sp.Expr:
    """Return the derivative of a bilinear form by ``s``; a part's derivative is ``d_part``."""
    parts = sorted(value.free_symbols - {alpha}, key=str)
    return sp.Add(*(value.diff(part) * sp.Symbol(f"d_{part}", real=True) for part in parts))


def closed_forms() -> tuple[ClosedForm, ...]:
    """Return the closed forms of the scalar equation, for emission."""
    D, M = determinants()
    equation = alpha * D + M
    slope = _with_derivatives(equation)
    used = sorted(equation.free_symbols - {alpha}, key=str)
    rates = [sp.Symbol(f"d_{part}", real=True) for part in used]
    travel = stick_duration()
    ends = sorted(travel.free_symbols - {alpha}, key=str)
    return (
        ClosedForm(
            "ratio_at_1",
            "Coefficient j + 1 over coefficient j at u = 1.",
            (j, n),
            (ratio_at_1(),),
        ),
        ClosedForm(
            "ratio_at_0",
            "Coefficient j + 1 over coefficient j at u = 0.",
            (j, n),
            (ratio_at_0(),),
        ),
        ClosedForm(
            "scalar_equation",
            "alpha D + M, which is zero, and its derivative by s.",
            (alpha, *used, *rates),
            (equation, slope),
        ),
        ClosedForm(
            "stick_duration",
            "t1 = alpha + y(t1).",
            (alpha, *ends),
            (travel,),
        ),
    )


def derive() -> GalerkinSystem:
    """Derive the scalar equation of Section 3.3.

    Raises
    ------
    DerivationError
        If a Jacobi polynomial or the elimination is wrong.
    """
    check_jacobi()
    check_elimination()
    D, M = determinants()
    return GalerkinSystem(
        method="c1-reduced",
        section="3.3",
        title="C1 expansion, reduced to one scalar equation",
        unknowns="s = T - t1",
        equations=equations((ratio_at_1(), ratio_at_0()), alpha * D + M, stick_duration()),
        jacobian=(),
        forms=closed_forms(),
    )
