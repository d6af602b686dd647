"""Functions of class C^k only (Section 3.3): Legendre polynomials on each side, integrated.

``u^(m)`` is a polynomial on each segment, in shifted Legendre polynomials ``P_l*`` made
orthonormal: the stiffness matrix of the bare structure is the identity.  Continuity of what
lies between ``u^(m)`` and ``u^(k)`` at `a` is a row a derivative, the conditions at the ends
another; ``u`` follows by `m` integrations, each with two entries a polynomial.

Output: the two closed forms of which the numeric stage makes its matrices.
"""

import sympy as sp

from ..system import require_zero

l, h, v = sp.symbols("l h v", positive=True)

#: Degrees at which the closed forms are checked against integration.
CHECKED = range(1, 5)


def legendre(degree: int, argument: sp.Expr) -> sp.Expr:
    """Return ``P_l*``, the Legendre polynomial of a segment ``0 <= v <= 1``."""
    return sp.legendre(degree, 2 * argument - 1)


def norm_squared() -> sp.Expr:
    """Return the integral of ``(P_l*)^2`` over a segment of length `h`."""
    norm = h / (2 * l + 1)
    require_zero(
        (f"norm of P_{n}*",
         h * sp.integrate(sp.expand(legendre(n, v) ** 2), (v, 0, 1)) - norm.subs(l, n))
        for n in CHECKED
    )  # fmt: skip
    return norm


def integral_factor() -> sp.Expr:
    """Return the factor in ``integral of P_l* = factor (P_(l+1)* - P_(l-1)*)``."""
    factor = h / (2 * (2 * l + 1))
    w = sp.Symbol("w", positive=True)
    require_zero(
        (f"integral of P_{n}*",
         h * sp.integrate(sp.expand(legendre(n, w)), (w, 0, v))
         - factor.subs(l, n) * (legendre(n + 1, v) - legendre(n - 1, v)))
        for n in CHECKED
    )  # fmt: skip
    return factor
