"""The exact motion of a case, made of the closed-form flow of its phases."""

from dataclasses import dataclass
from functools import cached_property

from ..arrays import Vector
from ..case.case import Case
from ..case.kernel import SceneKernel
from ..iteration.newton import Outcome
from ..orbit import admissible
from ..orbit.motion import SceneMotion
from .exact_system import exact_kernel


@dataclass(frozen=True, eq=False, repr=False)
class ExactSceneOrbit(SceneMotion):
    """The exact periodic orbit of a case, from the closed-form flow of its phases.

    Parameters
    ----------
    case : Case
        The oscillator.
    outcome : Outcome
        States and times without units, and how Newton's method found them.
    """

    case: Case
    outcome: Outcome

    @cached_property
    def _kernel(self) -> SceneKernel:
        return exact_kernel(self.case.cell)

    @property
    def cell_durations(self) -> Vector:
        """Durations of the phases of the cell, without units."""
        return self._kernel.split(self.outcome.unknowns)[0]

    @property
    def times(self) -> Vector:
        """Durations and, if something forces, the phase of the forcing; without units."""
        return self._kernel.times(self.outcome.unknowns)

    @property
    def angle(self) -> float:
        """Phase of the forcing at the first switch."""
        return self._kernel.split(self.outcome.unknowns)[1]

    @property
    def memory_values(self) -> tuple[float, ...]:
        """What the switches of the cell set, without units."""
        count = len(self.case.cell.phases)
        found = self.outcome.unknowns[2 * count : 2 * count + len(self.case.cell.memory)]
        return tuple(map(float, found))

    def part(self, p: int, u: Vector, derivative: int) -> Vector:
        """Return a derivative of the displacement on phase `p` of the cell, without units."""
        return self._kernel.motion(self.case.cell, self.outcome.unknowns, p, u, derivative)

    @cached_property
    def violations(self) -> tuple[str, ...]:
        """What keeps the solution from being an orbit, in words."""
        return admissible.violations(self)

    @property
    def admissible(self) -> bool:
        """Whether the solution is an orbit: nothing in `violations`."""
        return not self.violations

    def __repr__(self) -> str:
        return f"<exact orbit of {self.case.scene.label}: T = {self.period:.10g} s>"
