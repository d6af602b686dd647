"""Orders of phases that a scene does not declare, each as a scene of one motion.

An order is a list of phases of a scene, as they are or mirrored.  Each ends by its own event: a
phase that may end in two ways stands in the scene twice, with another event, or its mirror
image is the same with another event.  The list is a period or, where the other half is the
mirror image, half of one.
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

#: Behind the phases of half a period, of which the other half is the mirror image.
MIRRORED = "mirrored"


class Step(NamedTuple):
    """One phase of an order: which of the scene's cell, and whether it is mirrored."""

    phase: int
    mirrored: bool = False

    def called(self, names: Sequence[str]) -> str:
        """Return the name of the phase, by those of all, with a minus if it is mirrored."""
        return f"{'-' * self.mirrored}{names[self.phase]}"


@dataclass(frozen=True)
class Order:
    """An order of phases: the steps of one cell of the motion.

    Of `half_period` the next cell is the mirror image of this one.
    """

    steps: tuple[Step, ...]
    half_period: bool = False


def image(cell: Cell, step: Step) -> Step | None:
    """Return the mirror image of a phase of a cell; None if the cell has none."""
    if cell.sign < 0:
        return Step(step.phase, not step.mirrored)
    one = cell.phases[step.phase]
    found = (q for q, other in enumerate(cell.phases) if is_image(one, other))
    return next(map(Step, found), None)


def pairs(cell: Cell, order: Order) -> list[tuple[Step, Step | None]]:
    """Return each phase of an order, and the one that follows it."""
    first = order.steps[0]
    after = image(cell, first) if order.half_period else first
    return list(zip(order.steps, (*order.steps[1:], after), strict=True))


def half_if_mirrored(cell: Cell, order: Order) -> Order:
    """Return half of an order of phases whose other half is its image; else the order.

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
    """A scene whose motion has its phases in another order than those that are declared.

    They are those of `base`, a scene of one motion.
    """

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
        """The motion of which the phases are."""
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
        """No: what is known of a start is of the declared order."""
        return False

    @property
    def phases(self) -> tuple[str, ...]:
        """The names of the phases of its cell."""
        return tuple(phase.name for phase in self._in_general.phases)

    @property
    def kinds(self) -> tuple[tuple[str, bool], ...]:
        """Name of each phase, which it has alone, and whether a constraint holds it."""
        held = (phase.held for phase in self._in_general.phases)
        return tuple(zip(numbered(self.phases), held, strict=True))

    @property
    def classes(self) -> tuple[int, ...]:
        """The k of the switch that begins each phase."""
        return self._in_general.classes

    @property
    def k(self) -> int:
        """Class of its motion."""
        return min(self.classes)

    @property
    def memory(self) -> tuple[tuple[str, int, int, str], ...]:
        """What its switches set, each time that they do."""
        steps = self.order.steps
        what = [q[3] for q in self.base.memory for step in steps if step.phase == q[1]]
        return tuple(
            (q.name, q.phase, q.power, words)
            for q, words in zip(self._in_general.memory, what, strict=True)
        )

    def remembered(self, values: Sequence[float], p: int) -> tuple[float, ...]:
        """Return the memory of the declared cell on a phase of this one, from its own."""
        columns = _columns([phase for _, phase, *_ in self.base.memory], self.order, p)
        return tuple(sign * values[column] for column, sign in columns)

    @cached_property
    def _in_general(self) -> Cell:
        """Its cell for parameters of which nothing is special."""
        numbers = tuple(0.4 + 0.4 * (0.618034 * i % 1) for i in range(len(self.parameters)))
        found = in_cell(self.base.cell(numbers), self.order)
        found = replace(found, classes=classes(found))
        for p, k in enumerate(found.classes):
            if k == HIGHEST:
                one, other = found.phases[p - 1].name, found.phases[p].name
                raise UnknownScene(
                    f"phases: got {self.motion}, but nothing changes where {one} ends and "
                    f"{other} begins"
                )
        return found

    def cell(
        self, numbers: tuple[float, ...], cycles: int = 1, units: Units | None = None
    ) -> Cell:
        """Return its cell for parameters in some units; see `LoadedScene.cell`.

        Raises
        ------
        ParameterError
            If it is half a period, and the scene is not odd for these parameters.
        """
        declared = self.base.cell(numbers, 1, units)
        if self.half_period and not is_odd(declared):
            problem = f"parameters: the mirror image of {self.motion} is no motion for these"
            raise ParameterError([problem])
        found = in_cell(declared, self.order)
        return replace(found, classes=self.classes, k=self.k, cycles=cycles)


def declared_as(base: LoadedScene, order: Order) -> LoadedScene | None:
    """Return the motion of a scene that declares an order of the phases of one, if one does."""
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
    """Return a cell with its phases in another order; its classes are not known."""
    at = [each.phase for each in cell.memory]
    places = [(step, tuple(_columns(at, order, p))) for p, step in enumerate(order.steps)]
    memory = [
        _set_by(cell.memory[i], _begun_mirrored(cell, order, p), p)
        for i, p in _settings(at, order)
    ]
    made = {
        (step, columns): _with_columns(_taken(cell, step), columns, len(memory))
        for step, columns in set(places)
    }
    named = numbered([q.name for q in memory])
    return replace(
        cell,
        phases=tuple(made[place] for place in places),
        sign=-1 if order.half_period else 1,
        guess=cell.guess if order == declared_order(cell) else (),
        cycles=1,
        memory=tuple(replace(q, name=name) for q, name in zip(memory, named, strict=True)),
        classes=(),
        start=(),
    )


def _taken(cell: Cell, step: Step) -> Phase:
    """Return the phase of a cell that a step of an order is."""
    phase = cell.carrying(step.phase)
    return mirror(phase) if step.mirrored else phase


def _begun_mirrored(cell: Cell, order: Order, p: int) -> bool:
    """Whether a phase of an order begins as the mirror image of one does.

    Of the same equation as its image it is named by how it ends. It begins as the phase before
    it leaves it, if that is the one before it in the scene or the mirror image of that.
    """
    step, before = order.steps[p], order.steps[p - 1]
    phase = cell.phases[step.phase]
    named = before.phase != (step.phase - 1) % len(cell.phases)
    if named or mirror(phase).equation != phase.equation:
        return step.mirrored
    turned = (p == 0 and order.half_period) != (step.phase == 0 and cell.sign < 0)
    return before.mirrored != turned


def _set_by(memory: Memory, mirrored: bool, p: int) -> Memory:
    """Return a memory that a phase of an order sets, which may begin mirrored."""
    x, v, cos, constant, *others = memory.value
    if mirrored:
        constant = -constant
    return replace(memory, phase=p, value=(x, v, cos, constant, *others))


def is_odd(cell: Cell) -> bool:
    """Whether the mirror image of each phase is a phase.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> [is_odd(registry.load(name)().cell) for name in ("backlash", "clearance")]
    [True, False]
    """
    return None not in [image(cell, Step(p)) for p in range(len(cell.phases))]


def _settings(at: Sequence[int], order: Order) -> list[tuple[int, int]]:
    """Return which memory is set, and by which phase of an order, each time that one is.

    `at` has the phase of a cell that sets each.
    """
    steps = order.steps
    return [(i, p) for i, q in enumerate(at) for p, step in enumerate(steps) if step.phase == q]


def _columns(at: Sequence[int], order: Order, p: int) -> list[tuple[int, int]]:
    """Return which setting each memory has on a phase of an order, and its sign there."""
    settings, found = _settings(at, order), []
    for i, phase in enumerate(at):
        own = [(where, column) for column, (q, where) in enumerate(settings) if q == i]
        if not own:
            expected = f"expected phase {phase + 1} of the scene among them"
            raise UnknownScene(f"phases: {expected}: it sets a memory")
        before = [column for where, column in own if where <= p]
        sign = 1 if before or not order.half_period else -1
        found.append((before[-1] if before else own[-1][1], sign))
    return found


def _with_columns(phase: Phase, columns: Sequence[tuple[int, int]], count: int) -> Phase:
    """Return a phase whose factors of the memory are those of the settings of an order."""

    def put(factors: Sequence[float]) -> tuple[float, ...]:
        found = [0.0] * count
        for factor, (column, sign) in zip(factors, columns, strict=False):
            found[column] += sign * factor
        return tuple(found)

    width = phase.width

    def form(row: Form) -> Form:
        return (*row[:width], *put(row[width:]))

    return replace(phase.with_forms(form), memory=put(phase.memory))
