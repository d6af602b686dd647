"""Reasons why no orbit is found: a proof that there is none, or a motion without switches."""

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arrays import Complex, Vector
from ..bodies.laws import places
from ..bodies.part import parts_of
from ..flow import flow
from ..kernels.registry import names
from ..no_orbit import NoOrbit
from ..orbit.admissible import THROUGHOUT, seen_violated
from ..orbit.exact_orbit import ExactOrbit
from ..scenes.bodies.cell import BodyCell
from ..scenes.case import Case
from ..scenes.cell import Cell, Form, Phase
from ..scenes.ordered import ONLY, placed
from ..simulation.lasting import response
from . import two_phases
from .known import Known, known

#: Most refused solutions that are described, and most among which these are chosen.
TOLD, EXAMINED = 3, 50

#: Relative distance of the ratio of two frequencies from a whole number that is rounding.
NEAR = 1e-9


def shown_to_be_none(case: Case, tried: Iterable[str] = ()) -> NoOrbit | None:
    """Return a `NoOrbit` if it is proved that there is no orbit, else None; see `known`.

    Parameters
    ----------
    case : Case
        Of one motion.
    tried : iterable of str
        The outcomes of starts; those of simulations are repeated.
    """
    solutions = known(case)
    if not solutions.none:
        return None
    settled = (why for why in dict.fromkeys(tried) if why.startswith("a simulation"))
    instead = (*map(str, motions_without_switches(case)), *settled)
    no_orbit = f"{case.scene.label}: no such orbit exists"
    if not solutions.refused:
        return NoOrbit(f"{no_orbit}: {_no_solution(case)}", True, instead)
    count = len(solutions.refused)
    which = "this one solution" if count == 1 else f"these {count} solutions"
    return NoOrbit(
        f"{no_orbit}: its equations have {which} only", True, (*_refusals(solutions), *instead)
    )


def _no_solution(case: Case) -> str:
    """Return in words that the equations have no solution, and why if that is known."""
    first, *further = case.cell.phases
    words = "its equations have no real solution"
    if further:
        return f"{words} at any duration of {first.name}"
    return _resonance(case, first) or words


def _refusals(solutions: Known) -> tuple[str, ...]:
    """Return why each solution is not an orbit, first of those that violate least.

    One that violates one demand alone, from begin to end of its phase, would be an orbit if the
    sign of that demand were the other: in a scene of the user's it may be a mistake.
    """
    several = len(solutions.refused[0].cell_durations) > 1
    likely = sorted(solutions.refused, key=seen_violated)[:EXAMINED]
    reasons = []
    for orbit in sorted(likely, key=lambda q: (len(q.violations), not _by_sign(q))):
        name, own = orbit.case.cell.phases[0].name, orbit.case.scene.name not in names()
        head = f"{name} {orbit.durations[0]:.4g} s, " if several else ""
        question = "; is the sign of this demand right?" if own and _by_sign(orbit) else ""
        reasons.append(head + "; ".join(orbit.violations) + question)
    lines = [f"solution {i}: {why}" for i, why in enumerate(dict.fromkeys(reasons), 1)]
    more = len(lines[TOLD:]) + len(solutions.refused) - len(likely)
    rest = [f"and {more} more"] if more else []
    return (*lines[:TOLD], *rest)


def _by_sign(refused: ExactOrbit) -> bool:
    """Whether a solution violates one demand alone, throughout its phase."""
    return len(refused.violations) == 1 and refused.violations[0].startswith(THROUGHOUT)


def not_decided(case: Case) -> Iterator[str]:
    """Yield reasons why a list of solutions is not complete."""
    solutions = known(case)
    if isinstance(case.cell, BodyCell):
        if not _is_held(case.cell):
            yield "nothing holds the body at one place: an orbit, shifted, would be another one"
        yield from _refusals(solutions) if solutions.refused else ("no solution was found",)
    elif solutions.infinite:
        why = _resonance(case, case.cell.phases[0])
        words = "the equations have infinitely many solutions, none isolated"
        yield f"{words}{why and f': {why}'}"
    elif two_phases.applies(case.cell) and not (solutions.complete or solutions.orbits):
        names = [phase.name for phase in two_phases.vanishing(case.cell)]
        limit = (
            f"; as {' or '.join(names)} lasts no time they hold to rounding" if names else ""
        )
        yield (
            "a scan of the exact equations found none, and cannot decide whether there is one"
            f"{limit}"
        )


def _is_held(cell: BodyCell) -> bool:
    """Whether a body is at one place, by its own stiffness or by a contact."""
    if cell.body.squares.all():
        return True
    displacements = places(len(cell.phases[0].laws))[0]
    forms: list[Form] = []
    for phase in cell.phases:
        demands = (form for _, form in (*phase.demands, *phase.switch_demands))
        forms += [*phase.laws, phase.event, *demands]
    return any(form[x] for form in forms for x in displacements)


@dataclass(frozen=True)
class WithoutSwitches:
    """A periodic motion without switches: the response of one phase to the forcing.

    `least` and `largest` are displacements in m; `stable` is None if perturbations neither grow
    nor decay.
    """

    case: Case
    phase: str
    least: float
    largest: float
    stable: bool | None

    def __str__(self) -> str:
        size = max(-self.least, self.largest)
        what = "contact" if self.case.scene.has_body else "mass"
        return (
            f"the {what} can move in {self.phase} for ever, without switches, "
            f"|x| up to {size:.6g} m"
        )

    def as_dict(self) -> dict[str, Any]:
        """Return the motion as a JSON document."""
        return {
            "motion": ONLY + self.phase,
            "period": 2 * math.pi / self.case.values[str(self.case.scene.frequency)],
            "extremes": {"displacement": [self.least, self.largest]},
            "stable": self.stable,
        }


def motions_without_switches(case: Case) -> list[WithoutSwitches]:
    """Return the motions of a case without switches, for phases of all its motions."""
    motions = {}
    for each in case.each_motion:
        cell, (base, order) = each.cell, placed(each.scene)
        for phase, step in zip(cell.phases, order.steps, strict=True):
            name = base.phases[step.phase]
            if phase.held or name in motions or cell.memory or not cell.forced:
                continue
            within = _within(each, phase)
            if within is not None:
                *ends, stable = within
                least, largest = (end * each.units.length for end in ends)
                motions[name] = WithoutSwitches(each, name, least, largest, stable)
    return list(motions.values())


def without_switches(case: Case) -> Iterator[str]:
    """Yield in words that a phase may last for ever.

    Either it is in resonance, so that amplitudes grow without bound, or the response to the
    forcing meets its demands and is a periodic motion without switches.
    """
    for phase in dict.fromkeys(case.cell.phases if case.cell.forced else ()):
        if phase.g and not phase.held and _order_of_resonance(case, phase) == 1:
            yield _resonance(case, phase)
    yield from map(str, motions_without_switches(case))


def _order_of_resonance(case: Case, phase: Phase) -> int:
    """Return n if an undamped phase has n times the frequency of the forcing; else 0."""
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


def _within(case: Case, phase: Phase) -> tuple[float, float, bool | None] | None:
    """Return the extremes of the response of a phase to the forcing; None if it cannot last.

    Of a body those of its first contact.  The third value is whether it is stable; None if
    perturbations of one mass neither grow nor decay.
    """
    cell, p = case.cell, case.cell.phases.index(phase)
    states = steady(cell, p)
    if states is None or not phase.demands:
        return None
    still, wave = states
    if isinstance(cell, BodyCell):
        part = parts_of(cell)[p]
        rows, decay = part.lawful.rows, float(part.flow.poles.real.max())
    elif phase.g:
        rows, decay = np.delete(np.eye(5), 3, axis=0), flow.roots(phase)[0].real
    else:
        return None
    mean, swing = rows @ [*still, 0, 0, 1], rows @ [*wave, 1, -1j, 0]
    if not all(abs(form @ swing) <= form @ mean for _, form in phase.demands):
        return None
    size = float(abs(swing[0]))
    stable = decay < 0 if decay or case.scene.has_body else None
    return float(mean[0]) - size, float(mean[0]) + size, stable


def steady(cell: Cell, p: int) -> tuple[Vector, Complex] | None:
    """Return mean and complex amplitude of the state in the response of phase p alone.

    None if there is none, or a body moves freely.
    """
    if not isinstance(cell, BodyCell):
        harmonic = response(cell.phases[p], cell.omega)
        if harmonic is None:
            return None
        mean, wave = harmonic
        return np.array([mean, 0.0]), wave * np.array([1.0, 1j * cell.omega])
    lawful = parts_of(cell)[p].lawful
    A, inputs = lawful.A, lawful.inputs
    if lawful.still.shape[1]:
        return None
    try:
        waves = np.linalg.solve(
            1j * cell.omega * np.eye(len(A)) - A, inputs[:, 0] - 1j * inputs[:, 1]
        )
        still = np.linalg.solve(A, -inputs[:, 2])
    except np.linalg.LinAlgError:
        return None
    return np.asarray(still, float), np.asarray(waves, complex)
