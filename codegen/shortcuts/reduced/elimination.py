"""Section 3.3 with its coefficients eliminated: one rational function of ``s``.

Input: the integrated Legendre polynomials of `c1_legendre`.
Output: `rational_function`, by SymPy in exact rationals.

At given ``s``, (18) and (20) are linear in ``p_1/s .. p_N/s`` and ``y(t1)/s``; (19) gives
``t1``, and ``alpha = t1 - y(t1)``.  Every real solution at order N is a root of
``alpha = s F(s**2)``; the exact orbit has ``alpha = -tan(s/2)``.
"""

import sympy as sp

from ..paper.c1_legendre import n, reflected, s, twice, twice_integrated, u

square = sp.Symbol("sigma", positive=True)


def _parts(degree: int) -> dict[int, sp.Expr]:
    """Return ``Q_degree`` by parts in ``P_l*``."""
    parts: dict[int, sp.Expr] = {}
    for shift, value in twice().items():
        sign, index = reflected(degree + shift)
        parts[index] = parts.get(index, sp.Integer(0)) + sign * value.subs(n, degree)
    return parts


def _project(k: int, rho: dict[int, sp.Expr]) -> sp.Expr:
    return sp.Add(*(q * rho.get(l, 0) / (2 * l + 1) for l, q in _parts(k).items()))


def rational_function(order: int) -> sp.Expr:
    """Return ``F(sigma)`` with ``alpha = s F(s**2)`` at this order, in lowest terms.

    Parameters
    ----------
    order : int
        ``N``; SymPy needs seconds from about 10.

    Examples
    --------
    >>> rational_function(1)
    -3*(sigma - 70)/(20*(2*sigma - 21))
    """
    one, half = sp.Integer(1), sp.Rational(1, 2)
    columns = []
    for degree in range(1, order + 1):
        rho = {l: square * q for l, q in _parts(degree).items()}
        rho[degree] = rho.get(degree, sp.Integer(0)) + one
        columns.append(rho)
    columns.append({0: one})
    line = {0: half, 1: half}
    rows = range(order + 1)
    matrix = sp.Matrix([[_project(k, rho) for rho in columns] for k in rows])
    right = sp.Matrix([-_project(k, line) for k in rows])
    field = sp.QQ.frac_field(square)
    solution = matrix.to_DM(domain=field).lu_solve(right.to_DM(domain=field)).to_Matrix()
    end = twice_integrated(1).subs(u, 1)
    t1 = -end * square * solution[0] - 1
    return sp.factor(t1 - solution[order])


def condition(order: int) -> sp.Expr:
    """Return the right side of ``alpha = s F(s**2)``."""
    return s * rational_function(order).subs(square, s**2)
