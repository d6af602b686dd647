"""Orders of phases: lists of phases of a cell, and the cells that have them.

An order is a list of phases, each as declared or mirrored, that makes a period or half of an
antisymmetric one.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from ...nearest import numbered
from .cell import Cell, Form, Memory, Phase
from .loaded import UnknownScene
from .mirror import is_image, mirror


class Step(NamedTuple):
    """One phase of an order: its index in the scene's cell, and whether it is mirrored."""

    phase: int
    mirrored: bool = False

    def called(self, names: Sequence[str]) -> str:
        """Return the phase's name among `names` of the cell, with a minus if mirrored."""
        return f"{'-' * self.mirrored}{names[self.phase]}"


@dataclass(frozen=True)
class Order:
    """An order of phases: the steps of one cell of the motion.

    If `half_period`, the next cell is the mirror image of this one.
    """

    steps: tuple[Step, ...]
    half_period: bool = False


def image(cell: Cell, step: Step) -> Step | None:
    """Return the mirror image of a phase of a cell; None if the cell has none."""
    if cell.sign < 0:
        return Step(step.phase, not step.mirrored)
    phase = cell.phases[step.phase]
    images = (q for q, candidate in enumerate(cell.phases) if is_image(phase, candidate))
    return next(map(Step, images), None)


def pairs(cell: Cell, order: Order) -> list[tuple[Step, Step | None]]:
    """Return each phase of an order with the phase that follows it in the motion."""
    first = order.steps[0]
    after = image(cell, first) if order.half_period else first
    return list(zip(order.steps, (*order.steps[1:], after), strict=True))


def half_if_mirrored(cell: Cell, order: Order) -> Order:
    """Return the first half of an order if the other half is its mirror image; else the order.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> steps = Step(0), Step(1), Step(0, True), Step(1, True)
    >>> half_if_mirrored(registry.load("backlash")().cell, Order(steps)).half_period
    True
    """
    half = len(order.steps) // 2
    first, second = order.steps[:half], order.steps[half:]
    mirrored = tuple(image(cell, step) for step in first) == second
    return Order(first, True) if mirrored and not order.half_period else order


def declared_order(cell: Cell) -> Order | None:
    """Return the order of phases that a cell has; None if it has those of several motions."""
    steps = tuple(map(Step, range(len(cell.phases))))
    return None if cell.orders else Order(steps, cell.sign < 0)


def orders_of_motions(cell: Cell) -> list[Order]:
    """Return the orders of several motions whose phases a cell has; none for one motion."""
    return [Order(tuple(map(Step._make, places)), cell.sign < 0) for places in cell.orders]


def in_cell(cell: Cell, order: Order) -> Cell:
    """Return a cell with its phases in another order, without classes.

    Each phase of the order that sets a memory has a memory of its own.
    """
    setters = [memory.phase for memory in cell.memory]
    slots = [
        (q, tuple(memory_columns(setters, order, p)), after == _first_follower(cell, q))
        for p, (q, after) in enumerate(pairs(cell, order))
    ]
    memory = [
        _set_in(p, cell.memory[i], _begins_mirrored(cell, order, p))
        for i, p in _settings(setters, order)
    ]
    variants = {
        slot: _with_columns(_phase_of(cell, slot[0], slot[2]), slot[1], len(memory))
        for slot in set(slots)
    }
    names = numbered([q.name for q in memory])
    return replace(
        cell,
        phases=tuple(variants[slot] for slot in slots),
        sign=-1 if order.half_period else 1,
        guess=cell.guess if order == declared_order(cell) else (),
        cycles=1,
        memory=tuple(replace(q, name=name) for q, name in zip(memory, names, strict=True)),
        classes=(),
        orders=(),
        start=(),
    )


def _first_follower(cell: Cell, step: Step) -> Step | None:
    """Return the phase that the demands at the end of another one are for; None without any."""
    for follower, turned in cell.followers(step.phase):
        return Step(follower, turned != step.mirrored)
    return None


def _phase_of(cell: Cell, step: Step, demanding: bool) -> Phase:
    """Return the phase of a step, mirrored if the step is; `demanding` at its end, or not."""
    phase = cell.carrying(step.phase)
    phase = phase if demanding else replace(phase, switch_demands=())
    return mirror(phase) if step.mirrored else phase


def _begins_mirrored(cell: Cell, order: Order, p: int) -> bool:
    """Return whether phase `p` of an order begins as the mirror image of the declared phase.

    A phase with the same equation as its image is mirrored or not by its end.  If it follows a
    declared predecessor, or the image of one, it begins as that one was mirrored.
    """
    step, before = order.steps[p], order.steps[p - 1]
    phase = cell.phases[step.phase]
    behind = [turned for q, turned in cell.followers(before.phase) if q == step.phase]
    if not behind or mirror(phase).equation != phase.equation:
        return step.mirrored
    return before.mirrored != ((p == 0 and order.half_period) != behind[0])


def _set_in(p: int, memory: Memory, mirrored: bool) -> Memory:
    """Return a memory as phase `p` of an order sets it, mirrored or not."""
    x, v, cos, constant, *factors = memory.value
    if mirrored:
        constant = -constant
    return replace(memory, phase=p, value=(x, v, cos, constant, *factors))


def is_odd(cell: Cell) -> bool:
    """Return whether the mirror image of each phase of a cell is a phase of it.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> [is_odd(registry.load(name)().cell) for name in ("backlash", "clearance")]
    [True, False]
    """
    return None not in [image(cell, Step(p)) for p in range(len(cell.phases))]


def _settings(setters: Sequence[int], order: Order) -> list[tuple[int, int]]:
    """Return pairs ``(i, p)``: phase `p` of an order sets memory `i` of the declared cell.

    `setters` are the phases of the declared cell that set its memories.
    """
    steps = order.steps
    return [
        (i, p) for i, q in enumerate(setters) for p, step in enumerate(steps) if step.phase == q
    ]


def memory_columns(setters: Sequence[int], order: Order, p: int) -> list[tuple[int, int]]:
    """Return index among `_settings`, and sign, of each declared memory on phase `p`.

    The latest setting holds; before the first, the last one of the cell before.
    """
    settings, columns = _settings(setters, order), []
    for i, phase in enumerate(setters):
        of_memory = [(where, column) for column, (q, where) in enumerate(settings) if q == i]
        if not of_memory:
            expected = f"expected phase {phase + 1} of the scene among them"
            raise UnknownScene(f"phases: {expected}: it sets a memory")
        before = [column for where, column in of_memory if where <= p]
        sign = 1 if before or not order.half_period else -1
        columns.append((before[-1] if before else of_memory[-1][1], sign))
    return columns


def _with_columns(phase: Phase, columns: Sequence[tuple[int, int]], count: int) -> Phase:
    """Return a phase with its factors of declared memories moved to `columns` of `count`."""

    def put(factors: Form) -> Form:
        moved = [0.0] * count
        for factor, (column, sign) in zip(factors, columns, strict=False):
            moved[column] += sign * factor
        return tuple(moved)

    return phase.with_factors(put)
