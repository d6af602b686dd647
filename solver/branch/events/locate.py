"""The events in a step of a branch: where, the orbit there, and the error of the parameter."""

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from ...arrays import Vector
from ..along import of_velocity, returns
from ..piece import Piece
from ..place import NoStepError, Place
from ..walk import FLIP, FOLD, MEETS, NEUTRAL, OUTSIDE, OWN
from .circle import first_leaving, multipliers
from .root import ROUNDING, either_side, root

#: How far behind the end of a step an event in it is located again, in steps.
BACK = 1.25

#: Value of a monitor at its located root, as a part of its change, beyond which it is a pole.
ZERO = 1e-6

#: Part of a step in which no further torus is looked for.
SHORT = 1e-6

#: Least imaginary part of a complex multiplier, relative.
TURNED = 1e-7

#: Safety factor of the estimate where branches meet: both interpolations may err alike.
SAFETY = 4.0

#: The kinds of events of the orbit as a whole, by the last monitors.
OF_THE_ORBIT = {FOLD: "fold", FLIP: "flip", MEETS: "branch-point", OUTSIDE: "torus"}


@dataclass(frozen=True, eq=False)
class Found:
    """An event on a branch.

    Parameters
    ----------
    kind : str
        The word that users read.
    phase : int or None
        The phase in which it happens; None of the orbit as a whole.
    column : int or None
        Of `watch`: where in the phase; None if its duration vanishes.
    piece : Piece
    place : Place
    monitor : int
        Which of `Place.monitors` vanishes.
    estimate : float
        Of the error of the parameter: the difference if it is located from the other side.
    at_once : tuple of Found
        Other changes of the order of phases at the same place.
    """

    kind: str
    phase: int | None
    column: int | None
    piece: Piece
    place: Place
    monitor: int = -1
    estimate: float = 0.0
    at_once: tuple["Found", ...] = ()

    @property
    def row(self) -> int:
        """The row of the table of the form that vanishes, if it is one."""
        return self.monitor // 3

    @property
    def changes(self) -> bool:
        """Whether the order of the phases changes there."""
        return self.phase is not None

    @property
    def value(self) -> float:
        """The parameter, in SI units."""
        return self.piece.value(self.place.y)


def estimated(event: Found, after: Place, length: float) -> Found:
    """Return an event with its estimate, by locating it again from the end of the step."""
    piece, value = event.piece, event.value
    least, ends = float(np.spacing(abs(value))), (0.0, -BACK * length)
    if event.kind == "torus":  # other multipliers may cross the circle in the same step
        at = float(after.tangent @ ((event.place.y - after.y) * piece.along.weights))
        ends = at - SHORT * length, at + SHORT * length
    try:
        _, place = root(piece, after, ends, event.monitor)
    except NoStepError:  # behind a phase that has no duration nothing is smooth
        return replace(event, estimate=max(least, event.estimate))
    factor = SAFETY if event.monitor - len(place.monitors) + OWN == MEETS else 1.0
    return replace(event, estimate=max(least, factor * abs(piece.value(place.y) - value)))


def located(
    piece: Piece, before: Place, after: Place, length: float, i: int
) -> Iterator[tuple[float, Found | None]]:
    """Yield the event at which monitor i vanishes; None where no orbit is beyond."""
    end = float(after.monitors[i])
    forms, phases = 3 * len(piece.table), len(piece.along.kinds)
    at, place = root(piece, before, (0.0, length), i)
    ends = end, 0.0 if i < forms + phases else float(before.monitors[i])
    if not abs(float(place.monitors[i])) <= ZERO * max(map(abs, ends)):
        if i < forms + phases and abs(end) > ROUNDING:  # there is no orbit beyond
            yield at, None
        return
    if i < forms + phases:
        yield at, change_at(piece, place, i)
    else:
        kind = OF_THE_ORBIT[i - forms - phases]
        if kind == "flip" and piece.cell.sign < 0:  # of half a period: the symmetry is lost
            kind = "branch-point"
        yield at, Found(kind, None, None, piece, place, i)


def change_at(piece: Piece, place: Place, i: int) -> Found:
    """Return the change of the order of phases at an orbit where monitor i vanishes."""
    p = i - 3 * len(piece.table)
    if p >= 0:
        return Found(_kind_of_vanishing(piece, p), p, None, piece, place, i)
    row, column = piece.rows[i // 3], i % 3
    word = piece.course.word(row, column, piece.table[i // 3])
    return Found(word, row.phase, column, piece, place, i)


def by_cubic(
    piece: Piece, before: Place, after: Place, length: float, p: int
) -> tuple[float, Found]:
    """Return where the duration of a phase vanishes in a step, by cubic Hermite interpolation.

    The orbit is a smooth function of the duration, also through zero.  The cubic over twice the
    step gives the estimate.

    Raises
    ------
    NoStepError
        If there is no orbit twice as far.
    """
    part, y = _cubic(piece, before, after, p)
    event = change_at(piece, replace(before, y=y), 3 * len(piece.table) + p)
    _, coarser = _cubic(piece, before, piece.stepped(before, 2 * length), p)
    return part * length, replace(event, estimate=abs(piece.value(coarser) - event.value))


def _cubic(piece: Piece, before: Place, after: Place, p: int) -> tuple[float, Vector]:
    """Return at which part of a step a duration vanishes, and the unknowns there."""
    j = piece.along.before + p
    first, last = float(before.y[j]), float(after.y[j])
    span, part = last - first, first / (first - last)
    slopes = [q.tangent / piece.along.weights for q in (before, after)]
    first_tangent, last_tangent = (span * slope / slope[j] for slope in slopes)
    chord = after.y - before.y
    bent = (1 - part) * (first_tangent - chord) - part * (last_tangent - chord)
    return part, before.y + part * (chord + (1 - part) * bent)


def torus_crossings(
    piece: Piece, before: Place, after: Place, length: float, real: Iterable[float]
) -> Iterator[tuple[float, Found]]:
    """Yield where a pair of complex multipliers crosses the unit circle in a step.

    Their number outside changes by two.  At `real`, the places of folds and flips, where it
    changes by one, the step is divided.
    """
    monitor = len(before.monitors) - OWN + OUTSIDE
    ends = [(0.0, before)]
    for at in sorted(real, key=lambda at: at / length):
        ends += either_side(piece, before, at, length)
    ends.append((length, after))
    parts = [(*ends[i], *ends[i + 1]) for i in range(0, len(ends), 2)]
    while parts:
        low, start, high, end = parts.pop()
        if not abs(end.monitors[monitor] - start.monitors[monitor]) > 1:
            continue
        with suppress(NoStepError):
            at, place = root(piece, before, (low, high), monitor)
            if _crosses_as_pair(piece, place, start, end):
                yield at, Found("torus", None, None, piece, place, monitor)
                continue
        if abs(high - low) > SHORT * abs(length):
            at = (low + high) / 2
            middle = piece.stepped(before, at)
            parts += [(low, start, at, middle), (at, middle, high, end)]


def _crosses_as_pair(piece: Piece, place: Place, one: Place, other: Place) -> bool:
    """Whether a multiplier that crosses the unit circle between two orbits is complex.

    False as well where it comes back from infinity.
    """
    k, inside = first_leaving(one, other)
    value, *sides = (multipliers(piece, each)[k] for each in (place, one, other))
    offsets = [abs(abs(each) - 1) for each in (value, *sides)]
    near = ZERO if abs(abs(multipliers(piece, inside)[k]) - 1) > NEUTRAL else np.sqrt(ZERO)
    return bool(abs(value.imag) > TURNED * abs(value) and offsets[0] <= near * max(offsets))


def _kind_of_vanishing(piece: Piece, p: int) -> str:
    """Return the kind of the event at which the duration of a phase vanishes."""
    phase, returned = piece.cell.phases[p], returns(piece.cell, p)
    # it begins without speed: a rest could
    without_speed = piece.along.divided[p] > 1 or (returned and of_velocity(phase.event))
    if phase.held or (without_speed and piece.course.can_rest):
        return "sticking"
    return "grazing" if returned else "vanishing"
