"""What a contact does, as functions of time: its displacement, velocity, force."""

import sympy as sp

from ...scene import Scene, forcing
from ...scene.bodies.law import body_of
from ..functions import state
from ..notation import Notation


def displacement(scene: Scene, c: int, order: int, time: sp.Expr) -> sp.Expr:
    """Return the displacement of a contact, or a derivative of it; that of the first is x."""
    if c == 0:
        return state(order, time)
    name = list(body_of(scene).at)[c]
    return sp.Function(f"x_{name}" + "'" * order)(time)


def force(scene: Scene, c: int, time: sp.Expr) -> sp.Expr:
    """Return the force at a contact; where there is one alone it is f."""
    names = list(body_of(scene).at)
    return sp.Function("f" if len(names) == 1 else f"f_{names[c]}")(time)


def at(notation: Notation, expression: sp.Expr, time: sp.Expr, angle: sp.Expr) -> sp.Expr:
    """Return a linear form of the contacts at a time, the forcing at another."""
    scene = notation.scene
    values: dict[sp.Expr, sp.Expr] = {forcing: notation.times.forcing(angle)}
    for c, contact in enumerate(body_of(scene).at.values()):
        for order, symbol in enumerate((contact.x, contact.v, contact.a)):
            values[symbol] = displacement(scene, c, order, time)
        values[contact.force] = force(scene, c, time)
    return sp.sympify(expression).subs(values, simultaneous=True)
