"""Scenes in orders of phases that are not declared, and the phases that such orders are of.

Each phase ends by its own event.  A phase that may end in two ways is two phases with different
events, or has a mirror image that differs in its event.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from ...nearest import numbered
from .case import Case
from .cell import Cell
from .classes import HIGHEST, classes
from .dimensionless import Units
from .loaded import LoadedScene, UnknownScene
from .mirror import mirror, opposed
from .orders import Order, Step, image, in_cell, is_odd, memory_columns, settings
from .parameter_error import ParameterError

#: Last word in the name of an order whose other half is the mirror image.
MIRRORED = "mirrored"

#: How the name of a motion begins whose one phase nothing ends; the name of the phase follows.
ONLY = "only "


@dataclass(frozen=True, eq=False, repr=False)
class AllPhases(LoadedScene):
    """The phases of all motions of a scene, of which other orders are made.

    Its cell is no motion: the phases stand side by side.
    """

    def __reduce__(self) -> tuple[object, ...]:
        return all_phases, (self.whole,)

    @property
    def _identity(self) -> tuple[object, ...]:
        return *super()._identity, "all phases"

    @property
    def motions(self) -> tuple[str, ...]:
        """None: it is asked for its phases."""
        return ()

    @property
    def classes(self) -> tuple[int, ...]:
        """None: it has no switches."""
        return ()

    def called(self, name: str) -> list[int]:
        """Return the phases that have a name, in any motion; that of its own name first."""
        names = getattr(self.module, "LISTED", ())
        found = [*super().called(name), *(p for p, q in enumerate(names) if q == name)]
        for motion, order in zip(self.whole.each_motion, self.orders, strict=True):
            for (p, mirrored), phase in zip(order, motion.phases, strict=False):
                found += [p] if phase == name and not mirrored else []
        return list(dict.fromkeys(found))

    @property
    def whole(self) -> LoadedScene:
        """The scene with its motions."""
        return LoadedScene(self.module, self.folder, self.kept)


def all_phases(scene: LoadedScene) -> LoadedScene:
    """Return the phases of all motions of a scene as one; of one motion, the scene itself.

    Of an undeclared order, the scene whose phases it has.
    """
    if isinstance(scene, OrderedScene):
        return scene.base
    return AllPhases(scene.module, scene.folder, scene.kept) if scene.motions else scene


def of_all_phases(case: Case) -> Case:
    """Return the case of the phases of all motions of a scene, of which a case may name one.

    Of a scene of one motion it is the case itself.
    """
    scene = case.scene
    every = all_phases(scene) if scene.motion is None else placed(scene)[0]
    if every == scene:
        return case
    odd = case.cycles % 2 == 1 or not every.half_period
    return Case(every, case.values, case.cycles if odd else 1)


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
    def motions(self) -> tuple[str, ...]:
        """None: it is one motion."""
        return ()

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
    def class_at_start(self) -> dict[int, int]:
        """As in `LoadedScene`; of a phase that occurs again, the least."""
        least: dict[int, int] = {}
        for step, k in zip(self.order.steps, self.classes, strict=True):
            least[step.phase] = min(k, least.get(step.phase, k))
        return least

    @property
    def default_classes(self) -> dict[int, int]:
        """None: they are those of another order."""
        return {}

    @property
    def k(self) -> int:
        """Class of its motion."""
        return min(self.classes)

    @property
    def memory(self) -> tuple[tuple[str, int, int, str], ...]:
        """One memory for each switch that sets one, as in `LoadedScene.memory`."""
        declared = self.base.memory
        meanings = [
            declared[i][3] for i, _ in settings(tuple(q[1] for q in declared), self.order)
        ]
        return tuple(
            (q.name, q.phase, q.power, meaning)
            for q, meaning in zip(self._generic_cell.memory, meanings, strict=True)
        )

    def remembered(self, values: Sequence[float], p: int) -> tuple[float, ...]:
        """Return the memories of the declared cell on phase `p`, from those of this cell."""
        setters = tuple(setter for _, setter, *_ in self.base.memory)
        columns = memory_columns(setters, self.order)[p]
        return tuple(0.0 if q is None else q[1] * values[q[0]] for q in columns)

    @cached_property
    def _generic_cell(self) -> Cell:
        """Its cell for generic parameters, with the classes at its switches."""
        numbers = tuple(0.4 + 0.4 * (0.618034 * i % 1) for i in range(len(self.parameters)))
        cell = in_cell(self.base.cell(numbers), self.order)
        cell = replace(cell, classes=classes(cell))
        for p, k in enumerate(cell.classes):
            before, after = cell.phases[p - 1], cell.phases[p]
            before = mirror(before) if p == 0 and cell.sign < 0 else before
            held = after.held and before.demands != after.demands
            if k == HIGHEST and not held and not opposed(before, after):
                raise UnknownScene(
                    f"phases: got {self.motion}, but nothing changes where {before.name} ends "
                    f"and {after.name} begins"
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


def names_of_period(case: Case) -> list[str]:
    """Return the names of the phases of one period of a case.

    In the second half of a period, a phase that is the mirror image of one of another name has
    its own name.
    """
    cell, scene = case.cell, case.scene
    names = [phase.name for phase in cell.phases]
    if cell.cells == 1 or not isinstance(scene, OrderedScene):
        return names * cell.cells
    declared = scene.base.cell(case.numbers)
    for step, name in zip(scene.order.steps, tuple(names), strict=True):
        other = image(declared, step) or step
        names.append(name if other.phase == step.phase else declared.phases[other.phase].name)
    return names


def order_in(base: LoadedScene, motion: LoadedScene) -> Order | None:
    """Return the order in which a declared motion has phases of a base; None if it has others.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> scene = registry.load("dry-friction")
    >>> order_in(all_phases(scene), scene.of_motion("sliding"))
    Order(steps=(Step(phase=0, mirrored=False),), half_period=True)
    """
    if base.orders:
        places = base.orders[base.whole.motions.index(str(motion.motion))]
    else:
        places = tuple((p, False) for name in motion.phases for p in base.called(name))
    complete = len(places) == len(motion.phases)
    return Order(tuple(map(Step._make, places)), motion.half_period) if complete else None


def declared_as(base: LoadedScene, order: Order) -> LoadedScene | None:
    """Return the declared motion of a scene whose phases have this order; None without one."""
    return next((q for q in base.whole.each_motion if order_in(base, q) == order), None)


def placed(scene: LoadedScene) -> tuple[LoadedScene, Order]:
    """Return the scene of all phases that a scene of one motion is of, and its order there."""
    if isinstance(scene, OrderedScene):
        return scene.base, scene.order
    every = all_phases(scene.whole)
    order = order_in(every, scene)
    if order is None:
        return scene, Order(tuple(map(Step, range(len(scene.phases)))), scene.half_period)
    return every, order


def in_order(base: LoadedScene, order: Order) -> OrderedScene:
    """Return a scene of one motion with its phases in another order."""
    return OrderedScene(base.module, base.folder, base.kept, base=base, order=order)
