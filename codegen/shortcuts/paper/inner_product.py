"""Stage 2a: the inner product (8) of harmonics, in closed form with symbolic indices.

Input: an integrand that is a sum of products of harmonics, one for each phase.
Output: the same as a linear combination of the tabulated slip integrals ``C[k]`` and
``S[k]``, where ``k`` is a sum or a difference of the indices.

Products are reduced to sums first, so one primitive serves them all, and ``k = 0`` (the
diagonal) is its own branch: SymPy on the product itself returns a Piecewise of 190
operations.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache

import sympy as sp
from sympy.simplify.fu import TR8

from .oscillator import T, t, t1

N, n, j, k = sp.symbols("N n j k", integer=True, positive=True)
omega_0 = sp.Symbol("omega_0", positive=True)

#: The fundamental frequency in terms of the unknown period.
FREQUENCY = {omega_0: 2 * sp.pi / T}

C = sp.IndexedBase("C")
S = sp.IndexedBase("S")

#: ``cos`` and ``sin`` of ``k omega_0 t1``, tabulated once for every ``k``.
cos_k, sin_k = sp.symbols("cos_k sin_k", real=True)


@dataclass(frozen=True)
class SlipIntegral:
    """``C_k`` or ``S_k``: the integral of one harmonic over slip, and both branches."""

    table: sp.IndexedBase
    harmonic: sp.Expr
    generic: sp.Expr
    zero: sp.Expr


def _slip_integral(table: sp.IndexedBase, function: type[sp.Function]) -> SlipIntegral:
    harmonic = function(k * omega_0 * t)
    generic = sp.integrate(harmonic.subs(FREQUENCY), (t, t1, T))
    zero = sp.integrate(harmonic.subs(k, 0), (t, t1, T))
    return SlipIntegral(table, harmonic, sp.expand(generic), zero)


@cache
def slip_cosine() -> SlipIntegral:
    """Return ``C_k``."""
    return _slip_integral(C, sp.cos)


@cache
def slip_sine() -> SlipIntegral:
    """Return ``S_k``."""
    return _slip_integral(S, sp.sin)


@dataclass(frozen=True)
class Entry:
    """One inner product in closed form: for ``n != j``, and for ``n == j``."""

    generic: sp.Expr
    diagonal: sp.Expr

    @property
    def diagonal_term(self) -> sp.Expr:
        """What the diagonal has beside the generic form at ``n = j`` (``S_0 = 0``)."""
        difference = self.diagonal - self.generic.subs(n, j)
        return sp.expand(difference).subs(S[0], slip_sine().zero)


def _harmonics(integrand: sp.Expr) -> Iterator[tuple[sp.Expr, type, sp.Expr]]:
    """Yield ``(factor, sin or cos, k)`` for each harmonic ``k`` of `integrand`."""
    for term in sp.Add.make_args(sp.expand(TR8(sp.expand(integrand)))):
        waves = term.atoms(sp.sin, sp.cos)
        if not waves:
            yield term, sp.cos, sp.Integer(0)
            continue
        (wave,) = waves
        index = sp.expand(wave.args[0] / (omega_0 * t))
        yield term / wave, wave.func, index


def _table(function: type, index: sp.Expr) -> sp.Expr:
    """Return the tabulated integral over slip of the harmonic `index`."""
    return (S if function is sp.sin else C)[index]


def _full_period(function: type, index: sp.Expr) -> sp.Expr:
    """Integral over ``(0, T)``: nothing unless the harmonic is the constant.

    An index that is not identically zero, such as ``j - n``, is taken as non-zero:
    the diagonal is derived by a call of its own.
    """
    return T if index == 0 and function is sp.cos else sp.Integer(0)


def inner_product(stick: sp.Expr, slip: sp.Expr, test: sp.Expr) -> sp.Expr:
    """Return (8) for ``a(t)`` given in stick and in slip and the test function ``b(t)``.

    Raises
    ------
    ValueError
        If an integrand is not a sum of products of harmonics.
    """
    total = sp.Integer(0)
    for factor, function, index in _harmonics(stick * test):
        total += factor * (_full_period(function, index) - _table(function, index))
    for factor, function, index in _harmonics(slip * test):
        total += factor * _table(function, index)
    return sp.expand(total)


def entry(stick: sp.Expr, slip: sp.Expr, test: sp.Expr) -> Entry:
    """Return (8) as an `Entry`: indices ``n`` and ``j`` different, and equal."""
    on_diagonal = [expression.subs(n, j) for expression in (stick, slip, test)]
    return Entry(inner_product(stick, slip, test), inner_product(*on_diagonal))
