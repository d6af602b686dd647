"""Orders of phases: lists of phases of a cell, and the cells that have them.

An order is a list of phases, each as declared or mirrored, that makes a period or half of an
antisymmetric one.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import NamedTuple, TypeAlias

from ...nearest import numbered
from .cell import Cell, Form, Memory, Phase
from .loaded import UnknownScene
from .mirror import alike, mirror


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
    return images(cell)[step.phase]


@lru_cache(maxsize=8)
def images(cell: Cell) -> tuple[Step | None, ...]:
    """Return for each phase of a cell the phase that is its mirror image; None without one."""
    return tuple(_alike_in(cell, mirror(phase)) for phase in cell.phases)


def _alike_in(cell: Cell, phase: Phase) -> Step | None:
    places = (q for q, candidate in enumerate(cell.phases) if alike(phase, candidate))
    return next(map(Step, places), None)


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
    if all(cell.phases[step.phase].rests for step in order.steps):
        what = "in all of them the mass is held, expected one that moves freely"
        raise UnknownScene(f"phases: {what}")
    setters = tuple(memory.setter for memory in cell.memory)
    slots = [
        (q, columns, after == _first_follower(cell, q))
        for (q, after), columns in zip(
            pairs(cell, order), memory_columns(setters, order), strict=True
        )
    ]
    memory = [_set_in(cell, order, p, cell.memory[i]) for i, p in settings(setters, order)]
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
        to=(),
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


def _set_in(cell: Cell, order: Order, p: int, memory: Memory) -> Memory:
    """Return a memory as phase `p` of an order sets it, mirrored or not."""
    if not memory.within:
        x, v, cos, constant, *factors = memory.value
        sign = -1 if _begins_mirrored(cell, order, p) else 1
        return replace(memory, phase=p, value=(x, v, cos, sign * constant, *factors))
    before = _phase_of(cell, order.steps[p - 1], False)
    before = mirror(before) if p == 0 and order.half_period else before
    value = before.lawful(memory.value)
    if any(value[before.width :]):
        what = f"{memory.name} is set by a force that depends on a memory"
        raise UnknownScene(f"phases: {what} where {before.name} ends")
    return replace(memory, phase=p, within=(), value=value[: before.width])


def is_odd(cell: Cell) -> bool:
    """Return whether the mirror image of each phase of a cell is a phase of it.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> [is_odd(registry.load(name)().cell) for name in ("backlash", "clearance")]
    [True, False]
    """
    return cell.sign < 0 or None not in images(cell)


#: What sets a memory of the declared cell: see `Memory.setter`.
Setter: TypeAlias = int | tuple[int, ...]

#: Where a phase of an order finds a declared memory: index among `settings`, and sign.  None
#: for a memory that holds in no phase of the order.
Column: TypeAlias = tuple[int, int] | None

#: That of each declared memory.
Columns: TypeAlias = tuple[Column, ...]


@lru_cache(maxsize=64)
def settings(setters: tuple[Setter, ...], order: Order) -> tuple[tuple[int, int], ...]:
    """Return pairs ``(i, p)``: phase `p` of an order sets memory `i` of the declared cell."""
    places = range(len(order.steps))
    found = [(i, p) for i, q in enumerate(setters) for p in places if _is_set(q, order, p)]
    return tuple(found)


def _is_set(setter: Setter, order: Order, p: int) -> bool:
    """Return whether phase `p` of an order sets a memory."""
    phase, before = order.steps[p].phase, order.steps[p - 1].phase
    if isinstance(setter, int):
        return phase == setter
    return phase in setter and before not in setter


@lru_cache(maxsize=64)
def memory_columns(setters: tuple[Setter, ...], order: Order) -> tuple[Columns, ...]:
    """Return for each phase of an order the columns of the declared memories.

    The latest setting holds; before the first, the last one of the cell before.
    """
    all_settings, columns = settings(setters, order), []
    for i, setter in enumerate(setters):
        of_memory = [(at, column) for column, (q, at) in enumerate(all_settings) if q == i]
        if not of_memory and isinstance(setter, int):
            expected = f"expected phase {setter + 1} of the scene among them"
            raise UnknownScene(f"phases: {expected}: it sets a memory")
        if not (of_memory or isinstance(setter, int)) and order.steps[0].phase in setter:
            what = "phases: none of them sets a memory, which may have any of many values"
            raise UnknownScene(what)
        columns.append([_column(of_memory, order, p) for p in range(len(order.steps))])
    return tuple(tuple(column[p] for column in columns) for p in range(len(order.steps)))


def _column(of_memory: Sequence[tuple[int, int]], order: Order, p: int) -> Column:
    """Return the column of a memory on phase `p`, of those that phases up to P set."""
    before = [column for at, column in of_memory if at <= p]
    sign = 1 if before or not order.half_period else -1
    latest = before or [column for _, column in of_memory]
    return (latest[-1], sign) if latest else None


def _with_columns(phase: Phase, columns: Columns, count: int) -> Phase:
    """Return a phase with its factors of declared memories moved to `columns` of `count`."""

    def put(factors: Form) -> Form:
        moved = [0.0] * count
        for factor, place in zip(factors, columns, strict=False):
            if place is not None:
                moved[place[0]] += place[1] * factor
        return tuple(moved)

    return phase.with_factors(put)
