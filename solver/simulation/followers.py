"""Which phases may follow others, and whether those of an orbit do."""

from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Matrix, Vector
from ..scenes.cell import Form
from ..scenes.classes import generator
from ..scenes.orders import OrderedScene, Step, pairs
from .machine import Machine
from .nodes import Node
from .steps.state import State

if TYPE_CHECKING:
    from ..orbit.motion import Motion

#: What is rounding of what is left of a form, as a part of its factors.
ROUNDING = 1e-10

#: Derivatives of a demand that are looked at behind a switch.
HIGHEST = 4


def may_follow(machine: Machine, one: Step, other: Step) -> bool:
    """Whether a phase may begin where another ends by its event.

    Something must change there: the equation or the velocity.  And just behind the event each
    demand, or its first derivative that does not vanish there for every state, must not be a
    negative number.

    Parameters
    ----------
    machine : Machine
        Of the cell that the phases are of.
    one, other : Step
        The phase that ends, and that which begins.
    """
    before, after = machine.node(one), machine.node(other)
    known = _known(before)
    if not before.changes_velocity and _numbers(before) == _numbers(after):
        return False
    if after.phase.held:
        row = np.zeros(known.shape[1])
        row[1:3] = 1.0, -after.phase.speed
        if _constant(row, known) != 0.0:
            return False
        known = np.vstack([known, row])
    A = generator(machine.cell, after.phase, 1)
    for _, form in after.phase.demands:
        row = _in_state(form)
        for _ in range(HIGHEST):
            left = _constant(row, known)
            if left is None or left > 0:
                break
            if left < 0:
                return False
            row = row @ A
    return True


def _in_state(form: Form) -> Vector:
    """Return a linear form in (x, x', 1, cos, sin, memory)."""
    x, v, cos, constant, *memory = form
    return np.array([x, v, constant, cos, 0.0, *memory])


def _known(node: Node) -> Matrix:
    """Return the forms that vanish behind the event of a phase, in (x, x', 1, cos, ...)."""
    phase, rows = node.phase, []
    event, jumps = _in_state(phase.event), node.changes_velocity
    if not (jumps and phase.event[1]):
        rows.append(event)
    speed = np.zeros(len(event))
    if phase.held or (phase.rho == 0 and jumps):
        speed[1:3] = 1.0, -(phase.rho * phase.speed + phase.d if phase.held else phase.d)
        rows.append(speed)
    return np.array(rows or [np.zeros(len(event))])


def _constant(row: Vector, known: Matrix) -> float | None:
    """Return what known forms leave of a form: a number, or None if it depends on the state."""
    moving = [i for i in range(len(row)) if i != 2]
    sizes = np.abs(known).max(axis=1, keepdims=True)
    scaled = known / np.where(sizes > 0, sizes, 1.0)
    weights = np.linalg.lstsq(scaled[:, moving].T, row[moving])[0]
    left = row - weights @ scaled
    size = max(float(np.abs(row).max()), float(np.abs(weights).max()))
    if np.abs(left[moving]).max() > ROUNDING * size:
        return None
    return 0.0 if abs(left[2]) <= ROUNDING * size else float(left[2])


def not_followed(orbit: "Motion") -> tuple[str, ...]:
    """Return where another phase than that of its order follows in an orbit, in words.

    What the phases of a declared order demand says that already; of another order, the rules
    of a simulation do.
    """
    scene = orbit.case.scene
    if not isinstance(scene, OrderedScene) or scene.has_body:
        return ()
    machine = Machine.of(scene.base.cell(orbit.case.numbers))
    found, total = [], np.cumsum(orbit.cell_durations)
    for p, (one, other) in enumerate(pairs(machine.cell, scene.order)):
        assert other is not None  # else its cell is refused
        node, expected = machine.node(one), machine.node(other)
        x, v = (float(orbit.part(p, np.ones(1), j)[0]) for j in (0, 1))
        angle = orbit.angle + machine.cell.omega * float(total[p])
        memory = scene.remembered(orbit.memory_values, p)
        after = machine.after(one, State(x, v, angle, memory=memory))
        if after is None or _numbers(after) != _numbers(expected):
            name = "no phase" if after is None else _name(after)
            found.append(f"where {_name(node)} ends, {name} follows, not {_name(expected)}")
    return tuple(found)


def _numbers(node: Node) -> tuple[object, ...]:
    phase = node.phase
    return phase.m, phase.c, phase.k, phase.f, phase.g, phase.held, phase.speed, phase.memory


def _name(node: Node) -> str:
    return f"{'-' * node.mirrored}{node.phase.name}"
