"""The forced modes: the static answers to a unit load at `a`, and to one another.

``g_1`` answers the unit load that works on the felt derivative (of a compliance, a unit jump
of the broken one), ``g_q`` the load ``g_(q-1)``; in the modes ``phi_n = sqrt(2) sin(n pi x)``
of the bare structure, ``g_q = sum of r_n/mu_n^q phi_n`` with ``r_n = phi_n^(j)(a)``.

Input: a structure.  Output: polynomials on each side of `a`, and the sums of
``r_n^2/mu_n^q``, which are Bernoulli polynomials of `a`.

With the tails ``t_q = g_q`` less its first N sines, the matrices are diagonal but for a block
of the sums ``s_q`` of ``r_n^2/mu_n^q`` over ``n > N``, and the attachment has rank one: what is
left of the determinant is a scalar equation in the receptance, with the tail of it for `K`
forced modes.
"""

from functools import cache

import sympy as sp

from ..system import DerivationError, require_zero
from .data import Structure, a, lam, x

#: Forced modes that are emitted: the third leaves no more than rounding of low modes.
MOST = 3

#: Pieces of a function: left of `a` in ``x``, right of it in ``x`` as well.
Pieces = tuple[sp.Expr, sp.Expr]


@cache
def forced_mode(structure: Structure, q: int) -> Pieces:
    """Return the pieces of ``g_q`` by those of the mode before.

    Odd powers of the distance from an end satisfy its conditions; ``(-1)^m g^(2m)`` is the
    mode before, and what is left are ``2m`` constants, which the joints at `a` fix.
    """
    m = structure.m
    c = sp.symbols(f"c0:{2 * m}")
    left = right = sp.Integer(0)
    if q > 1:
        before = forced_mode(structure, q - 1)
        left, right = _integrated(before[0], m), _integrated(before[1].subs(x, 1 - x), m)
    left += sum(c[i] * x ** (2 * i + 1) for i in range(m))
    right = (right + sum(c[m + i] * x ** (2 * i + 1) for i in range(m))).subs(x, 1 - x)
    joints = [
        sp.diff(right - left, x, d).subs(x, a)
        - (structure.jump_of_load if q == 1 and d == structure.broken else 0)
        for d in range(2 * m)
    ]
    solution = sp.solve(list(map(sp.expand, joints)), c, dict=True)[0]
    return sp.expand(left.subs(solution)), sp.expand(right.subs(solution))


def _integrated(load: sp.Expr, m: int) -> sp.Expr:
    """Return what answers a load that is a polynomial, with zeros at ``x = 0``."""
    answer = sp.Poly(load, x)
    for _ in range(2 * m):
        answer = answer.integrate(x)
    return (-1) ** m * answer.as_expr()


def left_coefficients(structure: Structure, q: int) -> tuple[sp.Expr, ...]:
    """Return the coefficients of the left piece of ``g_q``, of ``x, x^3, x^5, ...``.

    The right piece has the same of ``1 - x``, `a` and ``1 - a`` interchanged, with the sign
    ``(-1)^j``: checked here.
    """
    left, right = forced_mode(structure, q)
    mirrored = left.subs({x: 1 - x, a: 1 - a}, simultaneous=True)
    require_zero(
        [(f"g_{q} seen from the other end", mirrored - (-1) ** structure.felt * right)]
    )
    powers = sp.Poly(left, x)
    even = [c for (power,), c in powers.terms() if power % 2 == 0]
    if any(even):
        raise DerivationError(f"g_{q} does not satisfy the conditions at x = 0")
    return tuple(
        sp.factor(powers.coeff_monomial(x**power)) for power in range(1, powers.degree() + 1, 2)
    )


def static_sum(structure: Structure, q: int) -> sp.Expr:
    """Return ``S_q``, the sum of ``r_n^2/mu_n^q``: the felt derivative of ``g_q`` at `a`.

    Of a compliance `q` starts at 2: ``S_1`` diverges.
    """
    if structure.kind == "compliance" and q == 1:
        raise ValueError(f"{structure.name}: S_1 diverges")
    left, _ = forced_mode(structure, q)
    total = sp.diff(left, x, structure.felt).subs(x, a)
    require_zero([(f"S_{q} by Bernoulli polynomials", total - by_bernoulli(structure, q))])
    return sp.factor(total)


def by_bernoulli(structure: Structure, q: int) -> sp.Expr:
    """Return ``S_q`` from the Fourier series of the Bernoulli polynomials, independently.

    ``r_n^2 = (n pi)^(2j) (1 -+ cos(2 pi n a))``, and the sum of ``cos(2 pi n a)/n^(2p)`` is
    ``(-1)^(p+1) (2 pi)^(2p) B_2p(a)/(2 (2p)!)`` for ``0 <= a <= 1``.
    """
    p = structure.m * q - structure.felt
    unit = sp.Integer((-1) ** (p + 1) * 2 ** (2 * p)) / (2 * sp.factorial(2 * p))
    sign = -1 if structure.felt % 2 == 0 else 1
    return unit * (sp.bernoulli(2 * p) + sign * sp.bernoulli(2 * p, a))


def sums(count: int) -> tuple[sp.Symbol, ...]:
    """Return the symbols ``s_1, ..., s_count``."""
    return tuple(sp.symbols(f"s_1:{count + 1}", positive=True))


def tail(K: int) -> sp.Expr:
    """Return what `K` forced modes make of the sum of ``r_n^2/(mu_n - lambda)`` over ``n > N``.

    ``e^T (H_K - lambda H_M)^(-1) e`` with ``(H_K)_pq = s_(p+q-1)``, ``(H_M)_pq = s_(p+q)``,
    ``e_q = s_q``: the Schur complement of the block.  Checked to be the ``[K-1/K]`` Pade
    approximant: its Taylor series has the first ``2 K`` sums as coefficients.
    """
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
    series = sum(coefficient * lam**power for power, coefficient in enumerate(s))
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
