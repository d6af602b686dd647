"""The matching conditions at the attachment, and that their determinant is what is solved.

Input: a structure.  Output: the matrix of the conditions, and a proof that its determinant is
a power of `beta` times the characteristic equation.
"""

from functools import cache

import sympy as sp

from ..system import DerivationError
from .data import Structure, a, b, beta, lam, x
from .green import characteristic


def matrix(structure: Structure) -> sp.Matrix:
    """Return the matrix of the conditions on the coefficients, left ones first.

    Each is that of a solution with the conditions at its end.  A row a derivative from 0 to
    ``2m - 1``: its jump is zero, and that of the broken one obeys the law of the attachment.
    """
    left = (sp.sin(beta * x), sp.sinh(beta * x))[: structure.m]
    right = [u.subs(x, 1 - x) for u in left]
    law = structure.law.subs(lam, beta ** (2 * structure.m))
    rows = []
    for d in range(2 * structure.m):
        row = [-sp.diff(u, x, d) for u in left] + [sp.diff(u, x, d) for u in right]
        if d == structure.broken:
            felt = [sp.diff(u, x, structure.felt) for u in left] + [0] * len(right)
            row = [jump - law * u for jump, u in zip(row, felt, strict=True)]
        rows.append([sp.expand(sp.sympify(q).subs(x, a).subs(1 - a, b)) for q in row])
    return sp.Matrix(rows)


@cache
def check_determinant(structure: Structure) -> sp.Expr:
    """Return determinant over characteristic equation: a number times a power of `beta`.

    Sines and cosines are atoms of a polynomial ring, reduced by ``cos^2 = 1 - sin^2`` and the
    like, which decides in a second what `sympy.simplify` does not.  A `DerivationError` is
    raised if the two differ by more than such a factor.
    """
    determinant = _as_polynomial(matrix(structure).det(method="berkowitz"))
    equation = _as_polynomial(characteristic(structure))
    leading = equation.terms()[0]
    for powers, coefficient in determinant.terms():
        if powers[1:] == leading[0][1:]:
            factor = sp.Rational(coefficient, leading[1]) * beta ** (powers[0] - leading[0][0])
            if sp.expand(determinant.as_expr() - factor * equation.as_expr()) == 0:
                return factor
    raise DerivationError(f"{structure.name}: the determinant is not that of the equation")


#: The atoms: `beta` and `s`, then sine and cosine, hyperbolic sine and cosine at a and at b.
_ATOMS = sp.symbols("beta s sin_a sin_b sinh_a sinh_b cos_a cos_b cosh_a cosh_b", positive=True)


def _as_polynomial(expression: sp.Expr) -> sp.Poly:
    """Return an expression in the atoms, no cosine above the first power."""
    be, _, sa, sb, sha, shb, ca, cb, cha, chb = _ATOMS
    words = {
        sp.sin(beta * a): sa, sp.sin(beta * b): sb, sp.cos(beta * a): ca, sp.cos(beta * b): cb,
        sp.sinh(beta * a): sha, sp.sinh(beta * b): shb,
        sp.cosh(beta * a): cha, sp.cosh(beta * b): chb,
        sp.sin(beta): sa * cb + ca * sb, sp.sinh(beta): sha * chb + cha * shb,
    }  # fmt: skip
    poly = sp.Poly(sp.expand(expression.subs(words).subs(beta, be)), *_ATOMS)
    for cosine, sine, sign in ((ca, sa, -1), (cb, sb, -1), (cha, sha, 1), (chb, shb, 1)):
        relation = sp.Poly(cosine**2 - 1 - sign * sine**2, cosine)
        poly = sp.Poly(sp.rem(sp.Poly(poly.as_expr(), cosine), relation).as_expr(), *_ATOMS)
    return poly
