"""The force series: what a pole answers to a contact force in Legendre polynomials.

A body answers by its poles, ``z' = s z + force``.  On a phase of duration tau, with
``kappa = s tau`` and the force ``sum l_n P_n*(u)``, two integrals say all:

    ``a_m(kappa) = int_0^1 P_m*(u) e^(kappa u) du``
    ``Z_mn(kappa) = int_0^1 P_m*(u) int_0^u e^(kappa (u - y)) P_n*(y) dy du``

The recurrences follow from two facts of Legendre polynomials,

    ``(P_(n+1)* - P_(n-1)*)' = 2 (2 n + 1) P_n*``,
    ``(2 u - 1) P_n* = ((n + 1) P_(n+1)* + n P_(n-1)*)/(2 n + 1)``,

the first by parts, where the difference vanishes at both ends, the second for the rates.
"""

from collections.abc import Iterator
from typing import NamedTuple

import sympy as sp

from .legendre import integrated

kappa, before, here, after = sp.symbols("kappa before here after")
m, n = sp.symbols("m n", integer=True, nonnegative=True)

#: ``a_m``, and whether two degrees are the same and differ by one, in the formulas.
moment, same, above, below = sp.symbols("moment same above below")


class Formula(NamedTuple):
    """One formula: the name of its function, its arguments, what it is, its value."""

    name: str
    arguments: tuple[sp.Symbol, ...]
    what: str
    value: sp.Expr


def formulas() -> Iterator[Formula]:
    """Yield the recurrences of both integrals, of their rates, and of integration.

    Examples
    --------
    >>> next(formulas()).value
    (exp(kappa) - 1)/kappa
    """
    u = sp.Symbol("u")
    zero = sp.integrate(sp.exp(kappa * u), (u, 0, 1), conds="none")
    zero = sp.piecewise_fold(zero).args[0][0] if zero.has(sp.Piecewise) else zero
    yield Formula("moment_0", (kappa,), "``a_0``", sp.factor(zero))
    # (2 u - 1) e^(kappa u) by parts: its ends less what differentiating leaves
    first = (sp.exp(kappa) + 1 - 2 * here) / kappa
    yield Formula("moment_1", (kappa, here), "``a_1`` from ``a_0``", first)
    unknown = sp.Symbol("unknown")
    by_parts = 2 * (2 * m + 1) * here + kappa * (unknown - before)
    (up,) = sp.solve(by_parts, unknown)
    words = "``a_(m+1)`` from ``a_(m-1)`` and ``a_m``"
    yield Formula(
        "next_moment", (m, kappa, before, here), words, before + sp.factor(up - before)
    )
    rate = (here + _shifted(m, before, after)) / 2
    words = "the derivative of ``a_m`` by kappa, from its neighbours"
    yield Formula("moment_rate", (m, before, here, after), words, rate)
    # int_0^u e^(kappa (u - y)) dy = (e^(kappa u) - 1)/kappa, and of (2 y - 1) by parts
    yield Formula("response_0", (kappa, moment, same), "``Z_m0``", (moment - same) / kappa)
    first = (2 * here - moment - same / 3) / kappa
    words = "``Z_m1`` from ``Z_m0``; `same` is 1 for m = 1"
    yield Formula("response_1", (kappa, here, moment, same), words, first)
    ends = (above - below) / (2 * m + 1)
    by_parts = 2 * (2 * n + 1) * here - ends - kappa * (unknown - before)
    (up,) = sp.solve(by_parts, unknown)
    words = "``Z_m(n+1)``; `above` is 1 for m = n + 1, `below` for m = n - 1"
    arguments = (m, n, kappa, before, here, above, below)
    yield Formula("next_response", arguments, words, before + sp.factor(up - before))
    sides = sp.symbols("left right")
    rate = (_shifted(m, *sides) - _shifted(n, before, after)) / 2
    words = "the derivative of ``Z_mn`` by kappa, from neighbours in m (left, right) and in n"
    yield Formula("response_rate", (m, n, *sides, before, after), words, rate)
    one = integrated(lambda l: sp.Symbol(f"c_{l}"), m)
    coefficient = sp.together(one.coeff(sp.Symbol(f"c_{m - 1}")))
    words = "the coefficient of ``P_m*`` in the integral of ``P_(m-1)*``, m > 0"
    yield Formula("integral", (m,), words, coefficient)


def _shifted(m: sp.Expr, before: sp.Expr, after: sp.Expr) -> sp.Expr:
    """Return ``(2 u - 1) P_m*`` by what stands for the neighbours of ``P_m*``."""
    return ((m + 1) * after + m * before) / (2 * m + 1)
