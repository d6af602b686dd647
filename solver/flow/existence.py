"""What can be said where no orbit is found: that there is none, or what moves instead."""

import math
from collections.abc import Iterable, Iterator
from functools import lru_cache

import numpy as np

from ..case.case import Case
from ..case.cell import Form, Phase
from ..iteration.newton import Outcome
from ..iteration.start import RoughTimes
from ..no_orbit import NoOrbit
from . import one_phase, two_phases
from .exact_motion import ExactSceneOrbit, from_times
from .exact_system import residual

#: Solutions of a scan that are told of.
TOLD = 3

#: How far the ratio of two frequencies may be from a whole number, as a part of it.
NEAR = 1e-9


def shown_to_be_none(case: Case, tried: Iterable[str] = ()) -> NoOrbit | None:
    """Return that there is no orbit, where that can be shown: see `one_phase`.

    Parameters
    ----------
    case : Case
        Of one motion.
    tried : iterable of str
        What searches came to: of that, what simulations settle on is repeated.

    Returns
    -------
    NoOrbit or None
        None where nothing is shown: of several phases the durations are unknown, and not all
        solutions can be listed; or there is an orbit.
    """
    if not one_phase.applies(case.cell):
        return None
    (phase,), found = case.cell.phases, one_phase.solutions(case.cell)
    instead = tuple(why for why in dict.fromkeys(tried) if why.startswith("a simulation"))
    no_orbit = f"{case.scene.label}: no such orbit exists"
    if found.none:
        why = _resonance(case, phase) or "its equations have no real solution"
        return NoOrbit(f"{no_orbit}: {why}", True, instead)
    if not found.found:  # infinitely many solutions: some may be orbits
        return None
    orbits = [_orbit(case, each) for each in found.found]
    if any(orbit.admissible for orbit in orbits):
        return None
    whys = dict.fromkeys("; ".join(orbit.violations) for orbit in orbits)
    reasons = tuple(f"solution {i}: {why}" for i, why in enumerate(whys, 1))
    return NoOrbit(
        f"{no_orbit}: its equations have no other solutions than these", True, reasons
    )


def is_in_vain(case: Case) -> bool:
    """Return whether all solutions of the exact equations are known, and none is an orbit.

    Of a cell of one phase that is proved (see `one_phase`), of one of two phases it is what a
    scan of their durations finds (see `two_phases`).  Both need a forcing.
    """
    return bool(scanned_words(case)) or shown_to_be_none(case) is not None


def scanned(case: Case) -> Iterator[str]:
    """Yield what a scan of the durations of two phases finds, if that is no orbit."""
    if scanned_words(case):
        yield scanned_words(case)


@lru_cache(maxsize=16)
def scanned_words(case: Case) -> str:
    """Return in words that a scan finds no orbit; empty if it finds one or decides nothing."""
    found = two_phases.solutions(case.cell) if two_phases.applies(case.cell) else None
    if found is None:
        return ""
    name = case.cell.phases[0].name
    if not found:
        return (
            f"the exact equations have no solution: a scan of the durations of {name}, from 0 "
            f"to the whole cell, finds none that fits the forcing{_in_the_limit(case)}"
        )
    orbits = [from_times(case, RoughTimes(*each, "the scan")) for each in found]
    if not all(orbit.outcome.converged and orbit.violations for orbit in orbits):
        return ""
    said = [
        f"{name} {orbit.durations[0]:.4g} s: {'; '.join(orbit.violations)}"
        for orbit in orbits[:TOLD]
    ]
    more = f"; and {len(orbits) - TOLD} more" if len(orbits) > TOLD else ""
    count = "one solution, which is" if len(orbits) == 1 else f"{len(orbits)} solutions,"
    which = "not an orbit" if len(orbits) == 1 else "none of them an orbit"
    return f"a scan of the durations of {name} finds {count} {which} ({'; '.join(said)}{more})"


def _in_the_limit(case: Case) -> str:
    """Return in words in which limits the equations are satisfied; empty if in none."""
    names = [phase.name for phase in two_phases.vanishing(case.cell)]
    if not names:
        return ""
    return f"; only as {' or '.join(names)} lasts no time do they hold to rounding"


def infinitely_many(case: Case) -> str:
    """Return that the equations of a case have infinitely many solutions, if they do."""
    if not one_phase.applies(case.cell):
        return ""
    found = one_phase.solutions(case.cell)
    if found.none or found.found:
        return ""
    why = _resonance(case, case.cell.phases[0])
    return f"the equations have infinitely many solutions, none isolated{why and f': {why}'}"


def without_switches(case: Case) -> Iterator[str]:
    """Yield what a mass does that moves in one phase for ever, where that explains something.

    In resonance its amplitude has no bound; or the response to the forcing stays within what
    the phase demands, and is itself a periodic motion, one without switches.
    """
    if not case.cell.forced or case.cell.memory:
        return
    for phase in dict.fromkeys(case.cell.phases):
        if phase.held or not phase.g:
            continue
        if _order_of_resonance(case, phase) == 1:
            yield _resonance(case, phase)
            continue
        amplitude = _amplitude_within(case, phase)
        if amplitude is not None:
            size = amplitude * case.units.length
            far = f"|x| up to {size:.6g} m"
            yield f"the mass can move in {phase.name} for ever, without switches, {far}"


def _order_of_resonance(case: Case, phase: Phase) -> int:
    """Return n where an undamped phase has n times the frequency of the forcing; else 0."""
    if phase.c != 0 or phase.k <= 0:
        return 0
    ratio = math.sqrt(phase.k / phase.m) / case.cell.omega
    n = round(ratio)
    return n if n and abs(ratio - n) <= NEAR * n else 0


def _resonance(case: Case, phase: Phase) -> str:
    """Return in words that a phase is in resonance; empty if it is not."""
    n = _order_of_resonance(case, phase)
    if not n:
        return ""
    name = str(case.scene.frequency)
    part = "" if n == 1 else f"1/{n} of "
    return (
        f"resonance: {name} = {case.values[name]:.6g} rad/s is {part}the natural frequency of "
        f"{phase.name}, and nothing damps it"
    )


def _amplitude_within(case: Case, phase: Phase) -> float | None:
    """Return how far the mass gets in a phase for ever, if what it demands allows that."""
    omega = case.cell.omega
    stiffness = complex(phase.k - phase.m * omega**2, phase.c * omega)
    if abs(stiffness) == 0 or (phase.k == 0 and phase.f):
        return None
    wave, mean = phase.g / stiffness, phase.f / phase.k if phase.k else 0.0

    def least(form: Form) -> float:
        ex, ev, ec, e0 = form
        return ex * mean + e0 - abs(ex * wave + ev * 1j * omega * wave + ec)

    if not phase.demands or min(least(form) for _, form in phase.demands) < 0:
        return None
    return abs(wave) + abs(mean)


def _orbit(case: Case, state: tuple[float, float, float]) -> ExactSceneOrbit:
    """Return a solution in closed form as an orbit, admissible or not."""
    x, v, angle = state
    z, R = np.array([x, v, case.cell.duration, angle]), np.empty(4)
    residual(case.cell, z, R)
    norm = float(np.abs(R).max())
    return ExactSceneOrbit(case, Outcome(z, True, 0, 0.0, norm, "converged"))
