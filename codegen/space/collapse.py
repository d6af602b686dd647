"""Ritz and Ritz with forced modes as one scalar equation, and how fast they converge.

With the tails ``t_q = g_q`` less its first N sines, the matrices are diagonal but for a block
of the sums ``s_q`` of ``r_n^2/mu_n^q`` over ``n > N``, and the attachment has rank one: what is
left of the determinant is a scalar equation in the receptance.

Output: the tail of the receptance for `K` forced modes, and the rates.
"""

import sympy as sp

from ..system import require_zero
from .data import Structure, lam


def sums(count: int) -> tuple[sp.Symbol, ...]:
    """Return the symbols ``s_1, ..., s_count``."""
    return tuple(sp.symbols(f"s_1:{count + 1}", positive=True))


def tail(K: int) -> sp.Expr:
    """Return what `K` forced modes make of the sum of ``r_n^2/(mu_n - lambda)`` over ``n > N``.

    ``e^T (H_K - lambda H_M)^(-1) e`` with ``(H_K)_pq = s_(p+q-1)``, ``(H_M)_pq = s_(p+q)``,
    ``e_q = s_q``: the Schur complement of the block.  Checked to be the ``[K-1/K]`` Pade
    approximant: its Taylor series has the first ``2 K`` sums as coefficients.
    """
    if K == 0:
        return sp.Integer(0)
    s = sums(2 * K)
    block = sp.Matrix(K, K, lambda p, q: s[p + q] - lam * s[p + q + 1])
    load = sp.Matrix(s[:K])
    adjugate = block.adjugate()
    numerator = sp.expand((load.T * adjugate * load)[0, 0])
    denominator = sp.expand(block.det(method="berkowitz"))
    _check_pade(numerator, denominator, s)
    return numerator / denominator


def _check_pade(numerator: sp.Expr, denominator: sp.Expr, s: tuple[sp.Symbol, ...]) -> None:
    """Check that the difference from the series begins at ``lambda^(2K)``."""
    series = sum(each * lam**power for power, each in enumerate(s))
    difference = sp.Poly(sp.expand(numerator - denominator * series), lam)
    require_zero(
        (f"moment {power + 1} of the tail", difference.coeff_monomial(lam**power))
        for power in range(len(s))
    )


def rate(structure: Structure, K: int) -> int:
    """Return the power of ``1/N`` of the error of an eigenvalue.

    The broken derivative ``p`` jumps, so sines leave ``N^-(2p + 1 - 2m)``; each forced mode
    takes another jump away, ``2m`` derivatives up, which adds ``4m``.
    """
    return 2 * structure.broken + 1 - 2 * structure.m + 4 * structure.m * K
