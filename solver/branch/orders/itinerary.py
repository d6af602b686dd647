"""An order of phases of a scene: its names, its cells, and what it is a case of."""

from dataclasses import dataclass, field, replace
from functools import cached_property

from ...scenes.case import Case
from ...scenes.cell import Cell
from ...scenes.dimensionless import Units
from ...scenes.loaded import LoadedScene
from ...scenes.ordered import ONLY, OrderedScene, declared_as, in_order
from ...scenes.orders import Columns, Order, image, in_cell, is_odd, memory_columns
from ...simulation.machine import Machine
from ...simulation.machines import machine_of


@dataclass(frozen=True)
class Itinerary:
    """An order of phases of a scene; or the motion of one phase that nothing ends.

    Parameters
    ----------
    base : LoadedScene
        Of one motion, of which the phases are.
    order : Order
    cycles : int
        Periods of the forcing in a period.
    endless : bool
        Whether its one phase never ends: its cell is cut where the velocity is zero.
    units : Units, optional
        Of the numbers that it is asked with.
    """

    base: LoadedScene
    order: Order
    cycles: int = 1
    endless: bool = False
    units: Units | None = field(default=None, compare=False)

    @cached_property
    def _scene(self) -> OrderedScene:
        return in_order(self.base, self.order)

    @cached_property
    def declared(self) -> LoadedScene | None:
        """The scene of one motion that declares this order, if one does."""
        return None if self.endless else declared_as(self.base, self.order)

    @property
    def motion(self) -> str | None:
        """What users call it: as the scene does, or its phases in order; see `orders`."""
        if self.endless:
            return ONLY + self.order.steps[0].called(self.base.phases)
        if self.declared is not None:
            return self.declared.motion
        return self._scene.motion

    @cached_property
    def called(self) -> str:
        """What a map calls it: by its first phase in the scene, as orbits that settle begin."""
        if self.endless or self.declared is not None:
            return self.motion or self._scene.motion
        half, cell = self.order.half_period, self.base.cell(self._numbers)
        period = list(self.order.steps)
        if half:
            period += [image(cell, step) or step for step in period]
        first = min(tuple(period[i:] + period[:i]) for i in range(len(period)))
        return in_order(self.base, Order(first[: len(self.order.steps)], half)).motion

    def case(self, case: Case) -> Case:
        """Return a case of the same parameters whose motion has this order."""
        scene = self.declared or self._scene
        is_own = scene == case.scene and case.cycles == self.cycles
        return case if is_own else Case(scene, case.values, self.cycles)

    def declares(self, numbers: tuple[float, ...]) -> Cell:
        """Return the cell of the phases that there are, for parameters without units."""
        return self.base.cell(numbers, 1, self.units)

    def cell(self, numbers: tuple[float, ...]) -> Cell:
        """Return its cell for parameters without units."""
        if not self.endless:
            return self._scene.cell(numbers, self.cycles, self.units)
        cell = in_cell(self.declares(numbers), self.order)
        return replace(cell, phases=(cell.phases[0].cut(),), cycles=self.cycles)

    def exists(self, case: Case) -> bool:
        """Whether it is a motion of a case: if it is half a period, the scene must be odd."""
        return not self.order.half_period or is_odd(self.base.cell(case.numbers))

    @cached_property
    def _generic(self) -> Cell:
        """Its cell for them, whether or not it would be a motion there."""
        cell = in_cell(self.base.cell(self._numbers), self.order)
        return replace(cell, phases=(cell.phases[0].cut(),)) if self.endless else cell

    @property
    def _numbers(self) -> tuple[float, ...]:
        """Parameters of which none is special."""
        return tuple(0.4 + 0.3 * j / 7 for j in range(len(self.base.parameters)))

    def columns(self, p: int) -> Columns:
        """Return where its cell has the memories that the scene declares, on phase p."""
        setters = tuple(memory.setter for memory in self.base.cell(self._numbers).memory)
        return memory_columns(setters, self.order)[p]

    @property
    def can_rest(self) -> bool:
        """Whether some phase holds the velocity."""
        return any(held for _, held in self.base.kinds)

    def machine(self, numbers: tuple[float, ...]) -> Machine:
        """Return the phases that there are, and the rules by which they follow each other."""
        return machine_of(self.declares(numbers))
