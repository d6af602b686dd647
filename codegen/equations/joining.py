"""What joins the phases, as statements on the motion: the left sides of conditions, by name."""

import sympy as sp

from ..galerkin.closure import START, differentiated, law
from ..scene import v, x
from .functions import state
from .notation import Notation
from .switching import event, event_after, set_to

#: The name of a condition, and the statement: zero.
Statements = dict[str, sp.Expr]


def statements(notation: Notation) -> Statements:
    """Return continuity, laws of the velocity, events and memory."""
    found: Statements = {}
    about = notation.scene, notation.times
    for p, switch in enumerate(notation.found):
        sign = notation.scene.sign if p == 0 else 1
        name, velocity = (
            switch.before,
            notation.start(p, 1) - law(notation.scene, p, notation.end),
        )
        found[f"impact_{name}"] = velocity
        found[f"velocity_{name}"] = (
            velocity if switch.k == 0 else _difference(notation, p, 1, sign)
        )
        for order in (0, *range(2, switch.k + 1)):
            key = f"derivative_{order}_{name}" if order else f"displacement_{name}"
            found[key] = _difference(notation, p, order, sign)
        for order in range(switch.jumps, switch.jumps + 9):
            found[f"jump_{order}_{name}"] = differentiated(
                *about, p, order, notation.start, notation.end, notation.at
            )
    for p, phase in enumerate(notation.scene.phases):
        found[f"event_{phase.name}"] = event(notation, p)
        found[f"event_{phase.name}_after"] = event_after(notation, p)
    for symbol, value in notation.scene.start.items():
        found[START] = notation.start(0, (x, v).index(symbol)) - value
    for memory in notation.scene.memory:
        found[f"memory_{memory.symbol}"] = memory.symbol - set_to(notation, memory)
    return found


def _difference(notation: Notation, p: int, order: int, sign: int) -> sp.Expr:
    """Return a derivative where phase `p` begins, less that where the one before it ends."""
    if p == 0:
        return notation.start(p, order) - sign * notation.end(len(notation.found) - 1, order)
    return state(order, notation.side(p, "+")) - state(order, notation.side(p, "-"))
