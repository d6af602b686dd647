"""Rough times of a body with contacts, by homotopy from its linear response.

In the contact laws ``F force + rest = 0`` the rest is multiplied by a part from 0 to 1.  At 0
no contact force acts: the body moves in its linear response, whose crossings of the events are
known in closed form.  From there the part grows in steps, with a secant predictor and
Newton's method on the exact equations as corrector.

This needs laws of forces alone: no impacts, no memory, no held contact.
"""

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import product

import numpy as np

from ..arrays import Complex, Vector
from ..bodies.laws import free, places
from ..bodies.systems import BodyError
from ..iteration.newton import newton
from ..kernels.bodies import exact_kernel
from ..kernels.start import RoughTimes
from ..scenes.bodies.cell import BodyCell, BodyPhase
from ..scenes.cell import Form

#: Words for the source of these times.
WORDS = "the linear response, by homotopy"

#: The part is this power of the homotopy parameter: stiff contacts need small parts first.
POWER = 3

#: First step of the homotopy parameter, least step, and most steps that are tried.
FIRST, LEAST, MOST = 1 / 8, 1 / 2048, 60

#: Most Newton iterations of a step; those up to which the next step is doubled; and largest
#: correction of the predicted durations, relative to the cell.
ITERATIONS, EASY, ASIDE = 8, 4, 0.1

#: Rounding of an angle, and of a form relative to its size.
ROUNDING = 1e-9


def from_linear_response(cell: BodyCell) -> RoughTimes | None:
    """Return times of a cell by homotopy from its linear response; None if it fails."""
    times = next(_crossings(cell), None) if _shrinks(cell) else None
    if times is None:
        return None
    done, step, slope = 0.0, FIRST, np.zeros(len(times))
    for _ in range(MOST):
        part = min(1.0, done + step)
        following, easy = _newton(under_part(cell, part**POWER), times + (part - done) * slope)
        if following is None:
            step /= 2
            if step < LEAST:
                return None
            continue
        if part == 1:
            return RoughTimes(tuple(map(float, following[:-1])), float(following[-1]), WORDS)
        slope, times = (following - times) / (part - done), following
        done, step = part, step * (2 if easy else 1)
    return None


def under_part(cell: BodyCell, part: float) -> BodyCell:
    """Return a cell in whose laws all terms but the contact forces are multiplied by a part."""
    force = _force(cell)

    def weaker(law: Form) -> Form:
        return tuple(q if i in force else part * q for i, q in enumerate(law))

    phases = (replace(q, laws=tuple(map(weaker, q.laws))) for q in cell.phases)
    return replace(cell, phases=tuple(phases))


def _force(cell: BodyCell) -> list[int]:
    """Return the indices of the contact forces in a form."""
    return places(cell.body.at.shape[1])[2]


def _shrinks(cell: BodyCell) -> bool:
    """Whether the motion tends to the linear response as the part tends to 0."""
    force = _force(cell)
    return (cell.forced and cell.cycles == 1 and not cell.memory) and all(
        not phase.held
        and set(phase.jumps) == {(1.0, 0.0)}
        and np.linalg.matrix_rank(np.array(phase.laws)[:, force]) == len(force)
        for phase in cell.phases
    )


def _newton(cell: BodyCell, guess: Vector) -> tuple[Vector | None, bool]:
    """Return the times near a guess, or None, and whether few iterations sufficed."""
    if guess[:-1].min() <= 0:
        return None, False
    kernel = exact_kernel(cell)
    start = np.append(np.zeros(kernel.size(0) - len(guess)), guess)
    try:
        outcome = newton(kernel.iterate, cell, start, ITERATIONS)
    except BodyError:  # there is no eigenbasis
        return None, False
    times = kernel.times(outcome.unknowns)
    is_near = np.abs(times - guess)[:-1].max() < ASIDE * cell.duration
    succeeded = outcome.converged and is_near and times[:-1].min() > 0
    return times if succeeded else None, outcome.iterations <= EASY


def _crossings(cell: BodyCell) -> Iterator[Vector]:
    """Yield times at which the linear response crosses the events, in their order.

    In the middle of each phase the response meets its demands.
    """
    system, total = free(cell.body, cell.omega, 0), cell.omega * cell.duration
    matrix = 1j * cell.omega * np.eye(len(system.A)) - system.A
    try:
        y = np.linalg.solve(matrix, system.inputs[:, 0].astype(complex))
    except np.linalg.LinAlgError:  # resonance
        return
    waves = system.rows @ np.array([*y, 1, -1j, 0])  # cos and sin as parts of e^(i theta)
    response = np.column_stack([waves, system.rows[:, -1]])
    ends, force = [], _force(cell)
    for phase in cell.phases:
        wave, constant = _at_no_part(phase, phase.event, force) @ response
        if abs(wave) <= abs(constant):
            return
        half = math.acos(-constant.real / abs(wave))
        ends.append((-half - np.angle(wave), half - np.angle(wave)))
    for angles in product(*ends):
        first = angles[-1] - total
        spans = np.mod(np.diff([first, *angles]), 2 * math.pi)
        if spans.min() <= ROUNDING or abs(spans.sum() - total) > ROUNDING:
            continue
        middles = first + np.cumsum(spans) - spans / 2
        if all(
            _keeps(q, response, at, force) for q, at in zip(cell.phases, middles, strict=True)
        ):
            yield np.array([*(spans / cell.omega), first % (2 * math.pi)])


def _keeps(phase: BodyPhase, response: Complex, angle: float, force: list[int]) -> bool:
    """Whether the linear response meets the demands of a phase at an angle of the forcing."""
    forms = [_at_no_part(phase, form, force) @ response for _, form in phase.demands]
    turn = np.exp(1j * angle)
    return all(
        (wave * turn + constant).real >= -ROUNDING * (abs(wave) + abs(constant))
        for wave, constant in forms
    )


def _at_no_part(phase: BodyPhase, form: Form, force: list[int]) -> Vector:
    """Return the leading term of a form as the part tends to 0; forces by their laws."""
    laws, row = np.array(phase.laws), np.array(form)
    other_laws, other_terms = laws.copy(), row.copy()
    other_laws[:, force] = other_terms[force] = 0
    if other_terms.any():
        return other_terms
    return np.asarray(-row[force] @ np.linalg.solve(laws[:, force], other_laws))
