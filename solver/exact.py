"""The exact orbit of a scene of linear phases: the reference of every error."""

from collections.abc import Iterator, Sequence
from itertools import islice

import numpy as np

from .any_motion import of_any_motion
from .existence.known import known, known_orbits
from .existence.reasons import not_decided, shown_to_be_none, without_switches
from .kernels.start import PATIENCE, RoughTimes, rough_times
from .no_orbit import NoOrbit
from .orbit.exact_orbit import ExactOrbit, from_times
from .scenes.case import Case
from .simulation.settle import FEW, PHASES, rough_times_by_simulation

__all__ = ["ExactOrbit", "exact_orbit"]


def exact_orbit(
    case: Case, durations: Sequence[float] = (), forcing_phase: float = 0.0
) -> ExactOrbit:
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
    if not len(durations):
        for orbit in known_orbits(case):
            return orbit
    if case.scene.motions:
        return of_any_motion(case, exact_orbit)
    given = _given(case, durations, forcing_phase)
    tried: list[str] = []
    iterations = 0
    for start in [given] if given else _starts(case, tried):
        orbit = from_times(case, start)
        iterations += orbit.outcome.iterations
        if not orbit.outcome.converged:
            tried.append(f"from {start.words}: {orbit.outcome.reason}")
        elif orbit.violations:
            tried.append(f"from {start.words}: {'; '.join(orbit.violations)}")
        else:
            return orbit
    shown = None if given else shown_to_be_none(case, tried)
    reason = f"{case.scene.label}: no admissible exact orbit was found"
    words = "; ".join([reason, *not_decided(case), *without_switches(case)])
    error = shown or NoOrbit(words, False, tuple(tried))
    error.iterations = iterations
    raise error


def _starts(case: Case, tried: list[str]) -> Iterator[RoughTimes]:
    """Yield rough times, then those on which a simulation settles; why not goes to `tried`.

    Where it is shown that there is no orbit, a simulation says what there is instead.
    """
    found = known(case)
    if not found.none:
        yield from islice(rough_times(case.cell), PATIENCE if found.listed else None)
    for settled in rough_times_by_simulation(case, FEW if found.listed else PHASES):
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
