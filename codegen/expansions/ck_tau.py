"""Functions of class C^k, tested with Legendre polynomials of each phase (`ck-tau`).

The functions are those of Section 3.3 of the paper: the derivative of order k + 1 is a
polynomial of degree N on each phase.  The tests are all polynomials of low degree (the tau
method of Lanczos), not the functions themselves: then the times converge about twice as fast.
"""

import sympy as sp

from ..galerkin import GalerkinConditions, polynomials
from ..galerkin.bodies import series
from ..galerkin.condition import BodyConditions
from ..scene import Scene
from . import About

METHOD = "ck-tau"
KERNEL = "ck"
TITLE = "functions of class C^k, tested with Legendre polynomials"
ABOUT = About(place=5, first=True, colour="#CC79A7", marker="^", line=(0, (3, 1, 1, 1, 1, 1)))


def test(l: sp.Expr, k: int) -> dict[sp.Expr, sp.Expr]:
    """Return ``P_l*``, scaled by ``1/int P_l*^2``, whatever the class."""
    return {l: 2 * l + 1}


def derive(scene: Scene) -> GalerkinConditions:
    """Return the conditions of a scene in this expansion."""
    return polynomials.derive(scene, METHOD, TITLE, test)


def of_body(scene: Scene) -> BodyConditions:
    """Return the conditions of a body: its contact forces in polynomials, tested with them."""
    title = "contact forces in Legendre polynomials, the laws tested with them"
    return series.derive(scene, METHOD, title)
