"""The force series: the response of a pole to a contact force in Legendre polynomials.

The motion of a body is by its poles, ``z' = s z + force``.  On a phase of duration tau, with
``kappa = s tau`` and the force ``sum l_n P_n*(u)``, two integrals are needed:

    ``a_m(kappa) = int_0^1 P_m*(u) e^(kappa u) du``
    ``Z_mn(kappa) = int_0^1 P_m*(u) int_0^u e^(kappa (u - y)) P_n*(y) dy du``

Recurrences for the first follow from two identities of Legendre polynomials,

    ``(P_(n+1)* - P_(n-1)*)' = 2 (2 n + 1) P_n*``,
    ``(2 u - 1) P_n* = ((n + 1) P_(n+1)* + n P_(n-1)*)/(2 n + 1)``,

the first by integration by parts, as the difference vanishes at both ends; the second for
derivatives by kappa.

The inner integral of the second is ``b_n(kappa) e^(kappa u)`` plus a polynomial of degree n, to
which ``P_m*`` is orthogonal for m > n.  So ``Z_mn = a_m b_n`` for m > n.  The substitution
``y -> 1 - u`` gives ``Z_nm = (-1)^(m + n) Z_mn``, and integration by parts the diagonal from
its neighbours.

``a_m`` decreases with m like ``kappa^m``, and ``b_n`` increases as fast.  For ``|kappa|`` up to
twice the highest degree both are computed without these powers: ``a_m = w_m A_m`` by downward
recurrence, which is stable, and ``b_n = B_n/((2 n + 1) w_n kappa)`` by upward recurrence, where
w_m is the product of the weights ``kappa/(2 (2 m + 1))``.
"""

from collections.abc import Iterator
from typing import NamedTuple

import sympy as sp

kappa, before, here, after = sp.symbols("kappa before here after")

#: e^kappa, and 1/kappa, which are computed once.
grown, inverse = sp.symbols("grown inverse")
m, n = sp.symbols("m n", integer=True, nonnegative=True)


class Formula(NamedTuple):
    """A closed form: name of its function, arguments, meaning in words, value."""

    name: str
    arguments: tuple[sp.Symbol, ...]
    what: str
    value: sp.Expr


def formulas() -> Iterator[Formula]:
    """Yield the recurrences of both integrals, and of their derivatives by kappa.

    Examples
    --------
    >>> next(formulas()).value
    (grown - 1)/kappa
    """
    u = sp.Symbol("u")
    a_0 = sp.integrate(sp.exp(kappa * u), (u, 0, 1), conds="none")
    a_0 = sp.piecewise_fold(a_0).args[0][0] if a_0.has(sp.Piecewise) else a_0
    a_0 = sp.factor(a_0).subs(sp.exp(kappa), grown)
    yield Formula("moment_0", (kappa, grown), "``a_0`` by ``e^kappa``", a_0)
    # (2 u - 1) e^(kappa u) by parts: its ends less what differentiating leaves
    a_1 = (grown + 1 - 2 * here) / kappa
    yield Formula("moment_1", (kappa, grown, here), "``a_1`` from ``a_0``", a_1)
    unknown = sp.Symbol("unknown")
    by_parts = 2 * (2 * m + 1) * here + kappa * (unknown - before)
    (next_moment,) = sp.solve(by_parts, unknown)
    words = "``a_(m+1)`` from ``a_(m-1)`` and ``a_m``, by 1/kappa"
    value = before + sp.factor(next_moment - before).subs(kappa, 1 / inverse)
    yield Formula("next_moment", (m, inverse, before, here), words, value)
    rate = (here + _shifted(m, before, after)) / 2
    words = "the derivative of ``a_m`` by kappa, from its neighbours"
    yield Formula("moment_rate", (m, before, here, after), words, rate)
    yield from _answers()
    yield from _weighted(next_moment)
    sides = sp.symbols("left right")
    rate = (_shifted(m, *sides) - _shifted(n, before, after)) / 2
    words = "the derivative of ``Z_mn`` by kappa, from neighbours in m (left, right) and in n"
    yield Formula("response_rate", (m, n, *sides, before, after), words, rate)


def _answers() -> Iterator[Formula]:
    """Yield the recurrence of ``b_n``, and the second integral from it."""
    # int_0^u e^(kappa (u - y)) dy = (e^(kappa u) - 1)/kappa, and of (2 y - 1) by parts
    yield Formula("answer_0", (kappa,), "``b_0``", 1 / kappa)
    words = "``b_1`` from ``b_0``"
    yield Formula("answer_1", (kappa, here), words, (2 * here - 1) / kappa)
    words = "``b_(n+1)`` from ``b_(n-1)`` and ``b_n``, by 1/kappa"
    next_answer = before + 2 * (2 * n + 1) * here * inverse
    yield Formula("next_answer", (n, inverse, before, here), words, next_answer)
    words = "``Z_00`` from ``a_0`` and ``a_1``"
    yield Formula("response_0", (here, after), words, (here - after) / 2)
    # 2 (2 n + 1) Z_nn = kappa (Z_n(n+1) - Z_n(n-1)) by parts, and Z_n(n+1) = - Z_(n+1)n
    words = "``Z_nn`` from ``Z_n(n-1)`` and ``Z_(n+1)n``, n > 0"
    diagonal = -kappa * (before + after) / (2 * (2 * n + 1))
    yield Formula("same_response", (n, kappa, before, after), words, diagonal)


def _weighted(up: sp.Expr) -> Iterator[Formula]:
    """Yield the recurrences of ``A_m`` and ``B_n``, from that of ``a_m``."""
    weight = kappa / (2 * (2 * m + 1))
    yield Formula("weight", (m, kappa), "``w_m`` over ``w_(m-1)``", weight)
    ratios = {here: weight * here, after: weight * weight.subs(m, m + 1) * after}
    (down,) = sp.solve(up - after, before)
    down = down.subs(ratios, simultaneous=True)
    down = sp.collect(sp.expand(down), (here, after), sp.factor)
    words = "``A_(m-1)`` from ``A_m`` and ``A_(m+1)``"
    yield Formula("weighted_moment", (m, kappa, here, after), words, down)
    # kappa a_0 = e^kappa - 1 and kappa a_1 = e^kappa + 1 - 2 a_0
    words = "1 from ``A_0`` and ``A_1``"
    unity = (1 - kappa / 2) * here + kappa * weight.subs(m, 1) * after / 2
    yield Formula("unity", (kappa, here, after), words, unity)
    yield Formula("weighted_answer_1", (kappa,), "``B_1``, ``B_0`` being 1", 1 - kappa / 2)
    words = "``B_(n+1)`` from ``B_(n-1)`` and ``B_n``"
    upward = here + weight.subs(m, n) * weight.subs(m, n - 1) * before
    yield Formula("weighted_answer", (n, kappa, before, here), words, upward)
    words = "``Z_(n+1)n`` over ``A_(n+1) B_n``"
    response = weight.subs(m, n + 1) / ((2 * n + 1) * kappa)
    yield Formula("weighted_response", (n,), words, sp.factor(response))


def _shifted(m: sp.Expr, before: sp.Expr, after: sp.Expr) -> sp.Expr:
    """Return ``(2 u - 1) P_m*`` from symbols for ``P_(m-1)*`` and ``P_(m+1)*``."""
    return ((m + 1) * after + m * before) / (2 * m + 1)
