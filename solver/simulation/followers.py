"""Which phases may follow others, and whether the phases of an orbit follow each other."""

from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Matrix, Vector
from ..bodies.exact import seen
from ..bodies.part import parts_of
from ..scenes.bodies.cell import BodyCell
from ..scenes.case import Case
from ..scenes.cell import Form
from ..scenes.mirror import same, same_demand
from ..scenes.ordered import OrderedScene, in_order, placed
from ..scenes.orders import Step, pairs
from .bodies.state import BodyState, on
from .machine import Machine
from .machines import machine_of
from .nodes import InState, Node, said
from .steps.column import NONE, ROW, WALL
from .steps.state import AnyState, State

if TYPE_CHECKING:
    from ..orbit.motion import Motion

#: Rounding of the remainder of a form in `_constant`, relative to its coefficients.
ROUNDING = 1e-10

#: Difference of a velocity from that of a held phase, relative to it, that is rounding.
ALIKE = 1e-8

#: Number of derivatives of a demand that are checked behind a switch, from order 0; and of an
#: event.
HIGHEST, OF_AN_EVENT = 4, 3


def may_follow(machine: Machine, one: Step, other: Step) -> bool:
    """Whether a phase of a machine may begin where another ends by its event.

    The equation, the velocity or a demand must change there.  And of each demand, the first
    derivative that does not vanish in every state just behind the event must not be a negative
    constant; nor may the demand be one that falls through zero at the event, and falls on.
    """
    before, after = machine.node(one), machine.node(other)
    if not before.changes_velocity and before.goes_on_as(after):
        return False
    laws = said(machine.cell, machine.nodes, one)
    if laws and after.law not in laws:
        return False
    in_state = machine.in_state(machine.number(other))
    known = _known(before, machine.in_state(machine.number(one)))
    if after.phase.held:
        row = _of_velocity(in_state, after.phase.speed)
        if _constant(row, known, in_state.one) != 0.0:
            return False
        known = np.vstack([known, row])
    if _falls_on(machine, one, other):
        return False
    for _, form in after.phase.demands:
        row = _row(in_state, form)
        for _ in range(HIGHEST):
            constant = _constant(row, known, in_state.one)
            if constant is None or constant > 0:
                break
            if constant < 0:
                return False
            row = row @ in_state.generator
    return True


def may_hold(machine: Machine, p: int, ended: Node, v: float) -> bool:
    """Whether phase p of a machine may hold the velocity v behind the event that ended one."""
    node, wall = machine.nodes[p], machine.rules.kinds[p, WALL]
    speed = node.phase.speed
    if not node.phase.held or abs(v - speed) > ALIKE * max(1.0, abs(speed)):
        return False
    if ended.event in node.demands:  # it has just ended so
        return False
    return bool(wall == NONE or machine.nodes[wall].event == ended.event)


def _falls_on(machine: Machine, one: Step, other: Step) -> bool:
    """Whether two phases have a demand that the event of the first ends, at the same rate."""
    before, after = machine.node(one), machine.node(other)
    if before.changes_velocity:
        return False
    fallen = [form for _, form in before.phase.demands if same(form, before.phase.event)]
    for _, form in after.phase.demands:
        for demand in (demand for demand in fallen if same_demand(demand, form)):
            values = _motion_of(machine, one, demand), _motion_of(machine, other, form)
            if all(map(np.any, values)) and np.allclose(*values, rtol=ROUNDING, atol=ROUNDING):
                return True
    return False


def _motion_of(machine: Machine, step: Step, form: Form) -> Matrix:
    """Return a form and its rate in a phase, over its size; nothing if they have a memory."""
    state, memories = machine.in_state(machine.number(step)), len(machine.cell.memory)
    row = _row(state, form)
    rows = np.array([row, row @ state.generator]) / np.abs(row).max()
    by_memory = rows[:, rows.shape[1] - memories :].any()
    return np.zeros_like(rows) if by_memory else rows


def vanishing(machine: Machine, p: int) -> int:
    """Return how many of an event and its first two rates vanish where its phase begins.

    Known there are: the event of the phase before it in the cell is zero; what that phase holds
    is held; a rest ends where it began; and phase p has just set its memory.  Where it is the
    rest that says so, 0 unless all vanish: see `branch.along.divided_phases`.
    """
    cell, state, phase = machine.cell, machine.in_state(p), machine.nodes[p].phase
    before, earlier = (
        machine.node(Step((p - by) % len(cell.phases), p < by and cell.sign < 0))
        for by in (1, 2)
    )
    row, count = _row(state, phase.event), 0
    known = [*_known(before, machine.in_state(machine.number(before.step)))]
    at_rest = before.phase.held and before.phase.speed == 0
    stays = at_rest and earlier.event == machine.nodes[p].event and not any(phase.event[1:3])
    if stays:
        known.append(row)
    for i, memory in enumerate(cell.memory, phase.width):
        if memory.phase == p:
            known.append(state.rows[i] - _row(state, memory.value))
    while count < OF_AN_EVENT and _constant(row, np.array(known), state.one) == 0.0:
        row, count = row @ state.generator, count + 1
    return 0 if stays and count < OF_AN_EVENT else count


def _row(state: InState, form: Form) -> Vector:
    """Return a form in the coordinates of the state; it may lack those of the memory."""
    return np.asarray(np.array(form) @ state.rows[: len(form)], dtype=float)


def _of_velocity(state: InState, speed: float) -> Vector:
    """Return the form that vanishes where the velocity is `speed`."""
    row = state.rows[1].copy()
    row[state.one] -= speed
    return np.asarray(row, dtype=float)


def _known(node: Node, state: InState) -> Matrix:
    """Return the forms that vanish in every state just behind the event of a phase."""
    phase, rows = node.phase, []
    jumps = node.changes_velocity
    if not (jumps and phase.event[1]):
        rows.append(_row(state, phase.event))
    if phase.held or (phase.rho == 0 and jumps):
        after = phase.rho * phase.speed + phase.d if phase.held else phase.d
        rows.append(_of_velocity(state, after))
    return np.array(rows or [np.zeros(state.rows.shape[1])])


def _constant(row: Vector, forms: Matrix, one: int) -> float | None:
    """Return the value of a form where known forms vanish; None if it depends on the state."""
    varying = [i for i in range(len(row)) if i != one]
    sizes = np.abs(forms).max(axis=1, keepdims=True)
    scaled = forms / np.where(sizes > 0, sizes, 1.0)
    weights = np.linalg.lstsq(scaled[:, varying].T, row[varying])[0]
    remainder = row - weights @ scaled
    size = max(float(np.abs(row).max()), float(np.abs(weights).max()))
    if np.abs(remainder[varying]).max() > ROUNDING * size:
        return None
    return 0.0 if abs(remainder[one]) <= ROUNDING * size else float(remainder[one])


def not_followed(orbit: "Motion") -> tuple[str, ...]:
    """Return in words where a phase of an orbit is followed by another than its order says.

    Empty for an order that a scene declares, whose demands check this.  Any other is checked by
    the rules of a simulation.
    """
    scene = orbit.case.scene
    if not isinstance(scene, OrderedScene):
        if scene.motion is None or not scene.whole.to:
            return ()
        scene = in_order(*placed(scene))
    machine = machine_of(Case(scene.base, orbit.case.values).cell)
    reasons, total = [], np.cumsum(orbit.cell_durations)
    for p, (step, follower) in enumerate(pairs(machine.cell, scene.order)):
        assert follower is not None  # else its cell is refused
        node, expected = machine.node(step), machine.node(follower)
        angle = orbit.angle + machine.cell.omega * float(total[p])
        memory = scene.remembered(orbit.memory_values, p)
        end = _end_of(orbit, p, angle, memory)
        if isinstance(end, BodyState):  # on its event without rounding, as in a simulation
            row = machine.rules.kinds[machine.number(step), ROW]
            end = on(machine.rules.forms[[row]], end)
        after, behind = machine.after(step, end)
        if after is None or after.law != expected.law:
            name = "no phase" if after is None else after.name
            words = f"where {node.name} ends, {name} follows, not {expected.name}"
            number = machine.number(step)
            undecided = after is None and machine.undecided(number, node.event, behind)
            reasons.append(undecided or words)
    return tuple(reasons)


def _end_of(orbit: "Motion", p: int, angle: float, memory: tuple[float, ...]) -> AnyState:
    """Return the state in which a phase of an orbit ends."""
    cell, end = orbit.case.cell, np.ones(1)
    if isinstance(cell, BodyCell):
        matrix = parts_of(cell)[p].lawful.A
        rows = np.eye(len(matrix), len(matrix) + 3 + len(cell.memory))
        y = seen(cell, orbit.times, p, end, rows)[:, 0]
        return BodyState(y, angle, memory=memory)
    x, v = (float(orbit.part(p, end, j)[0]) for j in (0, 1))
    place = cell.place(p)  # without rounding, as in a simulation
    return State(x if place is None else place, v, angle, memory=memory)
