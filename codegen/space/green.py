"""The exact response of the bare structure to a load at one place, in closed form.

Input: a structure.  Output: its Green's function, the response to the unit load that works on
the felt derivative at `a`, and the receptance: the felt derivative of that response.
"""

from functools import cache

import sympy as sp

from ..system import require_zero
from .data import Structure, a, b, beta, lam, x, xi


def string(k: sp.Expr) -> sp.Expr:
    """Return the response of a string at ``x <= xi`` to a unit force at ``xi``.

    ``-g'' - k^2 g = delta(x - xi)``, ``g = 0`` at both ends: sines from either end, of which
    SymPy finds the factors from continuity and from the unit drop of the slope.
    """
    left, right = sp.symbols("left right")
    before, after = left * sp.sin(k * x), right * sp.sin(k * (1 - x))
    joined = [(after - before).subs(x, xi), sp.diff(after - before, x).subs(x, xi) + 1]
    solution = sp.solve(joined, [left, right], dict=True)[0]
    wronskian = sp.sin(k * xi) * sp.cos(k * (1 - xi)) + sp.cos(k * xi) * sp.sin(k * (1 - xi))
    numerator = sp.simplify(solution[left] * wronskian)
    require_zero([("the Wronskian is sin k", wronskian - sp.sin(k))])
    return sp.sin(k * x) * numerator / sp.sin(k)


@cache
def green(m: int) -> tuple[sp.Expr, sp.Expr]:
    """Return the parts of ``sum of phi_n(x) phi_n(xi)/(mu_n - lambda)`` at ``x <= xi``.

    The first has ``sin beta`` as its denominator, the second ``sinh beta``; a string has no
    second.  Of a beam they are two strings, ``mu_n - lambda`` being
    ``(n^2 pi^2 - beta^2)(n^2 pi^2 + beta^2)``, taken apart into partial fractions.
    """
    if m == 1:
        return string(beta), sp.Integer(0)
    half = 1 / (2 * beta**2)
    hyperbolic = sp.sinh(beta * x) * sp.sinh(beta * (1 - xi)) / (beta * sp.sinh(beta))
    difference = (string(beta).subs(beta, sp.I * beta) - hyperbolic).rewrite(sp.exp)
    require_zero([("it is the string of an imaginary wave number", difference)])
    return string(beta) * half, -hyperbolic * half


def response(structure: Structure, derivative: int = 0) -> tuple[sp.Expr, sp.Expr]:
    """Return the parts of a derivative of the response at ``x <= a``, ``b`` for ``1 - a``."""
    parts = (sp.diff(part, xi, structure.felt, x, derivative) for part in green(structure.m))
    first, second = (sp.expand(p.subs(xi, a).subs(1 - a, b).subs(a - 1, -b)) for p in parts)
    return first, second


def receptance(structure: Structure) -> tuple[sp.Expr, sp.Expr]:
    """Return the parts of ``G``, the felt derivative of the response at ``a``.

    With ``r_n = phi_n^(j)(a)`` it is the sum of ``r_n^2/(mu_n - lambda)``; of a compliance
    that sum diverges, and the classical derivative on either side leaves
    ``lambda phi_n(a)^2`` for ``r_n^2``.
    """
    first, second = (part.subs(x, a) for part in response(structure, structure.felt))
    return first, second


def regular_receptance(structure: Structure) -> tuple[sp.Expr, sp.Expr]:
    """Return the receptance, of a compliance over ``lambda``: finite at ``beta = 0``."""
    divisor = beta ** (2 * structure.m) if structure.kind == "compliance" else sp.Integer(1)
    first, second = (sp.expand(part / divisor) for part in receptance(structure))
    return first, second


def characteristic(structure: Structure) -> sp.Expr:
    """Return the left side of the characteristic equation, without denominators.

    The equation of the attached structure times ``sin beta``, of a beam ``sinh beta``, and the
    lowest power of ``beta`` that leaves no denominator.
    """
    left = structure.equation(sum(receptance(structure))).subs(lam, beta ** (2 * structure.m))
    factor = sp.sin(beta) * (sp.sinh(beta) if structure.m == 2 else 1)
    cleared = sp.expand(sp.expand(left) * factor)
    numerator, denominator = sp.fraction(sp.together(cleared))
    divisor = sp.Poly(denominator, beta)
    return sp.expand(numerator) if divisor.is_monomial else sp.expand(cleared)
