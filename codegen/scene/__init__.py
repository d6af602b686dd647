"""An oscillator as data, with what SymPy checks and deduces of it.

Input: a scene file's parameters, phases and events.  Output: a checked `Scene`: units balance,
events and demands are linear in the state, every symbol is a parameter, and the class of
continuity at each switch is deduced from the equations of motion.

No expansion is known here, and no oscillator is named.
"""

from .bodies.body import Body
from .data import Event, Memory, Parameter, Phase, a, forcing, t, v, x
from .error import SceneError
from .linear import LinearPhase, linear_phase, state_row
from .orders import in_order
from .saltation import saltations
from .scene import Scene
from .smoothness import Switch, switches

__all__ = [
    "Body",
    "Event",
    "LinearPhase",
    "Memory",
    "Parameter",
    "Phase",
    "Scene",
    "SceneError",
    "Switch",
    "a",
    "forcing",
    "in_order",
    "linear_phase",
    "saltations",
    "state_row",
    "switches",
    "t",
    "v",
    "x",
]
