"""Orders of phases that a scene does not declare, each as a scene of one motion.

An order is a list of phases of a scene, each as declared or mirrored, that makes a period or
half of an antisymmetric one.  Each phase ends by its own event.  A phase that may end in two
ways is declared twice with different events, or has a mirror image that differs in its event.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

from ...nearest import numbered
from .cell import Cell, Form, Memory, Phase
from .classes import HIGHEST, classes
from .dimensionless import Units
from .loaded import LoadedScene, UnknownScene
from .mirror import is_image, mirror
from .parameter_error import ParameterError

#: Last word in the name of an order whose other half is the mirror image.
MIRRORED = "mirrored"

#: How the name of a motion begins whose one phase nothing ends; the name of the phase follows.
ONLY = "only "


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


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class OrderedScene(LoadedScene):
    """A scene of one motion with the phases of `base`, another one, in an undeclared order."""

    base: LoadedScene
    order: Order

    def __reduce__(self) -> tuple[object, ...]:
        return in_order, (self.base, self.order)

    @property
    def _identity(self) -> tuple[object, ...]:
        return *self.base._identity, self.order

    @property
    def motion(self) -> str:
        """Its phases, joined by commas; a minus says that one is mirrored.

        ``mirrored`` at the end says that the other half of the period is the mirror image.
        """
        words = [step.called(self.base.phases) for step in self.order.steps]
        return ",".join([*words, MIRRORED] if self.half_period else words)

    @property
    def fullest(self) -> LoadedScene:
        """The motion whose phases these are."""
        return self.base

    @property
    def whole(self) -> LoadedScene:
        """The scene with all motions that it declares."""
        return self.base.whole

    @property
    def half_period(self) -> bool:
        """Whether its cell is half a period."""
        return self.order.half_period

    @property
    def has_start(self) -> bool:
        """False: the condition of a start holds for the declared order only."""
        return False

    @property
    def phases(self) -> tuple[str, ...]:
        """The names of the phases of its cell."""
        return tuple(phase.name for phase in self._generic_cell.phases)

    @property
    def kinds(self) -> tuple[tuple[str, bool], ...]:
        """Unique name of each phase, and whether a constraint holds its velocity."""
        held = (phase.held for phase in self._generic_cell.phases)
        return tuple(zip(numbered(self.phases), held, strict=True))

    @property
    def classes(self) -> tuple[int, ...]:
        """The k of the switch that begins each phase."""
        return self._generic_cell.classes

    @property
    def k(self) -> int:
        """Class of its motion."""
        return min(self.classes)

    @property
    def memory(self) -> tuple[tuple[str, int, int, str], ...]:
        """One memory for each switch that sets one, as in `LoadedScene.memory`."""
        steps = self.order.steps
        meanings = [q[3] for q in self.base.memory for step in steps if step.phase == q[1]]
        return tuple(
            (q.name, q.phase, q.power, meaning)
            for q, meaning in zip(self._generic_cell.memory, meanings, strict=True)
        )

    def remembered(self, values: Sequence[float], p: int) -> tuple[float, ...]:
        """Return the memories of the declared cell on phase `p`, from those of this cell."""
        columns = _columns([phase for _, phase, *_ in self.base.memory], self.order, p)
        return tuple(sign * values[column] for column, sign in columns)

    @cached_property
    def _generic_cell(self) -> Cell:
        """Its cell for generic parameters, with the classes at its switches."""
        numbers = tuple(0.4 + 0.4 * (0.618034 * i % 1) for i in range(len(self.parameters)))
        cell = in_cell(self.base.cell(numbers), self.order)
        cell = replace(cell, classes=classes(cell))
        for p, k in enumerate(cell.classes):
            if k == HIGHEST:
                before, after = cell.phases[p - 1].name, cell.phases[p].name
                raise UnknownScene(
                    f"phases: got {self.motion}, but nothing changes where {before} ends and "
                    f"{after} begins"
                )
        return cell

    def cell(
        self, numbers: tuple[float, ...], cycles: int = 1, units: Units | None = None
    ) -> Cell:
        """Return its cell for parameters in given units; see `LoadedScene.cell`.

        Raises
        ------
        ParameterError
            If it is half a period, and the scene is not odd for these parameters.
        """
        declared = self.base.cell(numbers, 1, units)
        if self.half_period and not is_odd(declared):
            what = f"the mirror image of {self.motion} is not a motion"
            problem = f"phases: {what} for these parameters"
            raise ParameterError([problem])
        cell = in_cell(declared, self.order)
        return replace(cell, classes=self.classes, k=self.k, cycles=cycles)


def declared_as(base: LoadedScene, order: Order) -> LoadedScene | None:
    """Return the declared motion of a scene whose phases have this order; None without one."""
    names = [step.called(base.phases) for step in order.steps]
    every = (q for q in base.whole.each_motion if q.half_period == order.half_period)
    return next((q for q in every if [*q.phases] == names), None)


def in_order(base: LoadedScene, order: Order) -> OrderedScene:
    """Return a scene of one motion with its phases in another order."""
    return OrderedScene(base.module, base.folder, base.kept, base=base, order=order)


def declared_order(cell: Cell) -> Order:
    """Return the order of phases that a cell has."""
    return Order(tuple(map(Step, range(len(cell.phases)))), cell.sign < 0)


def in_cell(cell: Cell, order: Order) -> Cell:
    """Return a cell with its phases in another order, without classes.

    Each phase of the order that sets a memory has a memory of its own.
    """
    setters = [memory.phase for memory in cell.memory]
    slots = [(q, tuple(_columns(setters, order, p))) for p, q in enumerate(order.steps)]
    memory = [
        _set_in(p, cell.memory[i], _begins_mirrored(cell, order, p))
        for i, p in _settings(setters, order)
    ]
    variants = {
        (step, columns): _with_columns(_phase_of(cell, step), columns, len(memory))
        for step, columns in set(slots)
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
        start=(),
    )


def _phase_of(cell: Cell, step: Step) -> Phase:
    """Return the phase of a step of an order, mirrored if the step is."""
    phase = cell.carrying(step.phase)
    return mirror(phase) if step.mirrored else phase


def _begins_mirrored(cell: Cell, order: Order, p: int) -> bool:
    """Return whether phase `p` of an order begins as the mirror image of the declared phase.

    A phase with the same equation as its image is mirrored or not by its end.  If it follows
    its declared predecessor, or the image of that, it begins as that one was mirrored.
    """
    step, before = order.steps[p], order.steps[p - 1]
    phase = cell.phases[step.phase]
    elsewhere = before.phase != (step.phase - 1) % len(cell.phases)
    if elsewhere or mirror(phase).equation != phase.equation:
        return step.mirrored
    turned = (p == 0 and order.half_period) != (step.phase == 0 and cell.sign < 0)
    return before.mirrored != turned


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


def _columns(setters: Sequence[int], order: Order, p: int) -> list[tuple[int, int]]:
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

    def put(factors: Sequence[float]) -> tuple[float, ...]:
        moved = [0.0] * count
        for factor, (column, sign) in zip(factors, columns, strict=False):
            moved[column] += sign * factor
        return tuple(moved)

    width = phase.width

    def form(row: Form) -> Form:
        return (*row[:width], *put(row[width:]))

    return replace(phase.with_forms(form), memory=put(phase.memory))
