"""Functions of class C^k, tested with themselves: Section 3.3 for any class (`ck`).

On a phase that begins at a switch of class C^k, the functions that begin there are ``P_l*``
integrated k + 1 times from the switch: (18) has them for k = 1.  They are ``u^(k + 1)`` times
all polynomials of low degree, so what is orthogonal to them are the polynomials of Jacobi that
belong to this weight.
"""

import sympy as sp

from ..galerkin import GalerkinConditions, polynomials
from ..galerkin.legendre import repeated_integral
from ..scene import Scene
from . import About

METHOD = "ck"
TITLE = "functions of class C^k, tested with themselves"
ABOUT = About(place=4, colour="#009E73", marker="o", line=(0, (1.5, 1)))


def test(l: sp.Expr, k: int) -> dict[sp.Expr, sp.Expr]:
    """Return ``P_l*`` integrated k + 1 times from the switch, in Legendre polynomials."""
    return repeated_integral(l, k + 1)


def rest(m: sp.Expr, l: sp.Expr, k: int) -> sp.Expr:
    """Return the weight of ``P_l*``, l at most m, in Jacobi's ``P_m^(0, k + 1)(2 u - 1)``."""
    norm = sp.factorial(k) * sp.rf(m + 1, k + 1)
    return (-1) ** (m - l) * (2 * l + 1) * sp.rf(m - l + 1, k) * sp.rf(m + l + 2, k) / norm


def derive(scene: Scene) -> GalerkinConditions:
    """Return the conditions of a scene in this expansion."""
    return polynomials.derive(scene, METHOD, TITLE, test, rest)
