"""The exact orbit of a scene of linear phases: the reference of every error."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import chain, islice

import numpy as np

from .existence.known import are_one, known, known_orbits, searched
from .existence.reasons import not_decided, shown_to_be_none, without_switches
from .in_order import settled_cases
from .kernels.start import PATIENCE, RoughTimes, rough_times
from .no_orbit import NoOrbit, of_any_motion
from .orbit.exact_orbit import ExactOrbit, from_times
from .orbit.motion import Motion
from .scenes.case import Case, check_case
from .scenes.ordered import OrderedScene, declared_as, in_order
from .scenes.orders import half_if_mirrored
from .simulation.settle import FEW, PHASES, rough_times_by_simulation

__all__ = ["ExactOrbit", "exact_orbit"]

#: Largest difference of durations, relative to the cell, of two halves that are mirror images.
SAME = 1e-9


def exact_orbit(
    case: Case, durations: Sequence[float] = (), forcing_phase: float = 0.0
) -> ExactOrbit:
    """Return the exact periodic orbit of an oscillator.

    Parameters
    ----------
    case : Case
        The oscillator.
    durations : sequence of float
        Rough durations of the phases of one cell in s, to start from.  Default: the scene's
        guess, then equal durations, then those on which a simulation settles.  The simulation
        may settle on an undeclared order of phases, if no other orbit is stable.
    forcing_phase : float
        Rough phase of the forcing in rad; used with `durations` only.

    Returns
    -------
    ExactOrbit
        Period, times and motion, from the closed-form flow of each phase.

    Raises
    ------
    TypeError
        If `case` is not a `Case`.
    ValueError
        If there are not as many durations as phases, or they are not positive.
    NoOrbit
        If no start leads to an admissible orbit; with the outcome of each.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> belt = ns.StickSlip(mass=10, stiffness=1000, belt_speed=1,
    ...                     mu_s=0.5, mu_k=0.25, normal_force=400)
    >>> print(f"{ns.exact(belt).period:.10f} s")
    0.6712388980 s
    >>> print(f"{ns.exact(ns.scene('impact')()).forcing_phase:.10f} rad")
    0.9296439860 rad
    """
    check_case(case)
    if len(durations):
        return _of_motion(case, _given(case, durations, forcing_phase))
    try:
        orbit = next(iter(known_orbits(case)), None) or of_any_motion(case, _of_motion)
    except NoOrbit:
        settled = settled_orbit(case)
        if settled is None:
            raise
        return settled
    unstable = case.scene.motion is None and orbit.stable is False
    return (settled_orbit(case, beside=True) if unstable else None) or orbit


def settled_orbit(case: Case, *, beside: bool = False) -> ExactOrbit | None:
    """Return the exact orbit on which a simulation settles, in an undeclared order of phases.

    None if there is none, or if the case names a motion.  A stable one, if any is found.  With
    `beside`, next to an orbit known to be unstable, declared orders count too, and unstable
    orbits do not.
    """
    if case.scene.motion is not None:
        return None
    of_declared = _admissible(_declared(case)) if beside else ()
    unstable = None
    for orbit in chain(of_declared, settled_orbits(case, patiently=not beside)):
        if orbit.stable is not False:
            return orbit
        unstable = unstable or orbit
    return None if beside else unstable


def settled_orbits(
    case: Case, *, patiently: bool = False, as_declared: bool = False
) -> Iterator[ExactOrbit]:
    """Yield the exact orbits on which simulations settle; none if the case names a motion.

    After an unstable one, the others of the same order of phases follow, if they can be listed.
    For `patiently` and `as_declared` see `settled_cases`.
    """
    if case.scene.motion is not None:
        return
    settled = settled_cases(case, patiently=patiently, as_declared=as_declared)
    for orbit in _admissible(settled):
        yield orbit
        if orbit.stable is False:
            yield from (q for q in known(orbit.case).orbits if not are_one(q, orbit))


def _admissible(starts: Iterable[tuple[Case, RoughTimes]]) -> Iterator[ExactOrbit]:
    """Yield the exact orbits to which times lead, those that are admissible."""
    trials = (from_times(case, times) for case, times in starts)
    return (_by_half(q) for q in trials if q.outcome.converged and q.admissible)


def _by_half(orbit: ExactOrbit) -> ExactOrbit:
    """Return an orbit with half a period as its cell, if the other half is the mirror image.

    A simulation that settles slowly does not show the symmetry.
    """
    scene, durations = orbit.case.scene, orbit.cell_durations
    if not isinstance(scene, OrderedScene) or orbit.case.cycles % 2 == 0:
        return orbit
    order = half_if_mirrored(scene.base.cell(orbit.case.numbers), scene.order)
    first, second = durations[: len(order.steps)], durations[len(order.steps) :]
    if order == scene.order or np.abs(first - second).max() > SAME * durations.sum():
        return orbit
    half = declared_as(scene.base, order) or in_order(scene.base, order)
    case = Case(half, orbit.case.values, orbit.case.cycles)
    half_orbit = from_times(
        case, RoughTimes(tuple(map(float, first)), orbit.angle, "half of its times")
    )
    return half_orbit if half_orbit.outcome.converged and half_orbit.admissible else orbit


def _declared(case: Case) -> Iterator[tuple[Case, RoughTimes]]:
    """Yield times on which simulations settle in motions whose orbits cannot be listed."""
    for each in case.each_motion:
        if not known(each).listed:
            for settled in rough_times_by_simulation(each):
                if settled.times is not None:
                    yield each, settled.times


def _of_motion(case: Case, guess: RoughTimes | None = None) -> ExactOrbit:
    """Return the exact orbit of a case of one motion; see `exact_orbit`.

    In an undeclared order a stable one, if simulations lead to one.
    """
    tried: list[str] = []
    iterations, unstable = 0, None
    rough = islice(rough_times(case.cell), PATIENCE if known(case).listed else None)
    guesses = starts(case, rough, tried, lambda: unstable is not None)
    for start in [guess] if guess else (times for _, times in guesses):
        orbit = from_times(case, start)
        iterations += orbit.outcome.iterations
        if not orbit.outcome.converged:
            tried.append(f"from {start.words}: {orbit.outcome.reason}")
        elif orbit.violations:
            tried.append(f"from {start.words}: {'; '.join(orbit.violations)}")
        elif guess or not prefers_stable(case, orbit):
            return orbit
        else:
            unstable = unstable or orbit
    if unstable is not None:
        return unstable
    proven = None if guess else shown_to_be_none(case, tried)
    reason = f"{case.scene.label}: no admissible exact orbit was found"
    words = "; ".join([reason, *not_decided(case), *without_switches(case)])
    error = proven or NoOrbit(words, False, tuple(tried))
    error.iterations = iterations
    raise error


def prefers_stable(case: Case, orbit: Motion) -> bool:
    """Whether an orbit is unstable in an undeclared order, which may have a stable one."""
    return isinstance(case.scene, OrderedScene) and orbit.stable is False


def starts(
    case: Case,
    rough: Iterable[RoughTimes],
    tried: list[str],
    enough: Callable[[], bool] = lambda: False,
) -> Iterator[tuple[str, RoughTimes]]:
    """Yield rough times, then those on which simulations settle; with words for each.

    In an undeclared order those of simulations come first.  Else, where provably no orbit is,
    and for bodies, whose rough times `known` has tried, they come alone.  Of a body in an
    undeclared order `searched` comes in place of rough times.  After simulations in such an
    order it is asked whether that was `enough`.  The reason why a simulation gives no times is
    added to `tried`.
    """
    knowledge, undeclared = known(case), isinstance(case.scene, OrderedScene)
    is_body = case.scene.has_body
    if not (undeclared or knowledge.none or is_body):
        yield from ((times.words, times) for times in rough)
    phases = (FEW, PHASES) if knowledge.listed else (PHASES,)
    for settled in rough_times_by_simulation(case, *phases, widely=undeclared):
        if settled.times is not None:
            yield settled.times.words, settled.times
        elif settled.words:
            tried.append(settled.words)
    if undeclared and not enough():
        further = rough if not is_body else () if knowledge.listed else searched(case)
        yield from ((times.words, times) for times in further)


def _given(case: Case, durations: Sequence[float], angle: float) -> RoughTimes:
    """Return the given times in SI units without units."""
    count = len(case.cell.phases)
    if len(durations) != count or not all(0 < s < np.inf for s in durations):
        expected = f"{count} positive number{'s' if count > 1 else ''}, one a phase of a cell"
        raise ValueError(f"durations: got {tuple(durations)!r}, expected {expected}")
    dimensionless = tuple(float(s / case.units.time) for s in durations)
    return RoughTimes(dimensionless, float(angle), "the given times")
