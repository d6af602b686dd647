"""The exact orbit of a scene of linear phases: the reference of every error."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..arrays import Vector
from ..case.case import Case
from ..case.kernel import SceneKernel
from ..iteration.newton import Outcome, newton
from ..iteration.start import RoughTimes, rough_times, with_coefficients
from ..motions import of_any_motion
from ..no_orbit import NoOrbit
from ..orbit import admissible
from ..orbit.motion import SceneMotion
from ..stability.words import in_words
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

    @property
    def label(self) -> str:
        """What a legend calls it."""
        return "exact"

    @property
    def look(self) -> None:
        """Of its curves in pictures: None, those of every exact orbit."""

    @property
    def facts(self) -> dict[str, str]:
        """What a notebook shows."""
        found = super().facts
        head = {name: found.pop(name) for name in ("scene", "parameters")}
        return head | {"orbit": "exact"} | found | {"stability": in_words(self)}

    @property
    def _identity(self) -> tuple[object, ...]:
        return self.case, self.outcome.unknowns.tobytes()

    def __repr__(self) -> str:
        return f"<exact orbit of {self.case.scene.label}: {self._times}>"


def exact_orbit(
    case: Case, durations: Sequence[float] = (), forcing_phase: float = 0.0
) -> ExactSceneOrbit:
    """Return the exact orbit of a case.

    Parameters
    ----------
    case : Case
        The oscillator.
    durations : sequence of float
        Rough durations of the phases of one cell in s, to start from; without them, the
        scene's guess, equal durations, and at last those on which a simulation settles.
    forcing_phase : float
        Rough phase of the forcing, with them.

    Raises
    ------
    ValueError
        If there are not as many durations as phases, or they are not positive.
    NoOrbit
        If no start leads to an admissible orbit; with what each led to.
    """
    if case.scene.motions:
        return of_any_motion(case, exact_orbit)
    given = _given(case, durations, forcing_phase)
    tried: list[str] = []
    iterations = 0
    for start in [given] if given else _starts(case, tried):
        orbit = _from(case, start)
        iterations += orbit.outcome.iterations
        if not orbit.outcome.converged:
            tried.append(f"from {start.words}: {orbit.outcome.reason}")
        elif orbit.violations:
            tried.append(f"from {start.words}: {'; '.join(orbit.violations)}")
        else:
            return orbit
    name = case.scene.label
    error = NoOrbit(f"{name}: no admissible exact orbit was found", False, tuple(tried))
    error.iterations = iterations
    raise error


def _starts(case: Case, tried: list[str]) -> Iterator[RoughTimes]:
    """Yield rough times, then those on which a simulation settles; why not goes to `tried`."""
    from ..simulation.settle import rough_times_by_simulation  # noqa: PLC0415  (by this flow)

    yield from rough_times(case.cell)
    for settled in rough_times_by_simulation(case):
        if settled.times is None:
            tried.append(settled.words)
        else:
            yield settled.times


def _given(case: Case, durations: Sequence[float], angle: float) -> RoughTimes | None:
    if not len(durations):
        return None
    count = len(case.cell.phases)
    if len(durations) != count or not all(0 < s < np.inf for s in durations):
        expected = f"{count} positive number{'s' if count > 1 else ''}, one a phase of a cell"
        raise ValueError(f"durations: got {tuple(durations)!r}, expected {expected}")
    dimensionless = tuple(float(s / case.units.time) for s in durations)
    return RoughTimes(dimensionless, float(angle), "the given times")


def _from(case: Case, start: RoughTimes) -> ExactSceneOrbit:
    kernel = exact_kernel(case.cell)
    times = [*start.durations, start.angle] if kernel.forced else [*start.durations]
    z = with_coefficients(kernel, case.cell, kernel.size(1), np.array(times))
    return ExactSceneOrbit(case, newton(kernel.iterate, case.cell, z))
