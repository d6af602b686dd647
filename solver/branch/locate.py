"""The events in a step of a branch: where, the orbit there, and the error of the parameter."""

from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np

from ..arrays import Vector
from .along import of_velocity, returns
from .piece import NoStepError, Piece, Place
from .walk import FLIP, FOLD, MEETS, NEUTRAL, OUTSIDE, OWN
from .watch import BEGINS

#: How far behind the end of a step an event in it is located again, in steps.
BACK = 1.25

#: Value of a monitor at its located root, as a part of its change, beyond which it is a pole.
ZERO = 1e-6

#: Rounding of monitors without units.
ROUNDING = 4 * float(np.finfo(float).eps)

#: Tolerance of the root of a monitor, as a part of a step.
NEAR = 1e-14

#: Where a monitor is this small, as a part of its values at the ends of the step, and so many
#: values in turn have not halved it, the rest is rounding.
SMALL, STALLED = 1e-7, 2

#: Part of a step beside a fold or a flip in which no torus is looked for; and those tried where
#: branches meet, next to which no step succeeds.
SHORT = 1e-6
SIDES = SHORT, 1e-5, 1e-4, 1e-3

#: Least imaginary part of a complex multiplier, relative.
TURNED = 1e-7

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
    """

    kind: str
    phase: int | None
    column: int | None
    piece: Piece
    place: Place
    monitor: int = -1
    estimate: float = 0.0

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


@dataclass
class Search:
    """The lowest value of a monitor in the search for its root.

    Parameters
    ----------
    size, small : float
        The larger value at the ends; and what is small beside both.
    at, least : float
        Where it was lowest, and how low.
    stalls : int
        How many values in turn have not halved it.
    """

    size: float
    small: float
    at: float = np.nan
    least: float = np.inf
    stalls: int = 0

    @classmethod
    def between(cls, one: float, other: float) -> "Search":
        """Return a search from the values at both ends; one of them may be NaN."""
        return cls(float(np.fmax(one, other)), SMALL * float(np.fmin(one, other)))

    def is_over(self, at: float, value: float) -> bool:
        """Whether all beyond the next value is rounding."""
        self.stalls = 0 if value <= self.least / 2 else self.stalls + 1
        if value < self.least:
            self.at, self.least = at, value
        is_settled = self.least <= self.small and self.stalls >= STALLED
        return value <= ROUNDING * self.size or is_settled


def root(piece: Piece, before: Place, ends: tuple[float, float], i: int) -> tuple[float, Place]:
    """Return where in a part of a step a monitor vanishes, and the orbit there (Brent).

    Where branches meet, the equations are singular: then between the orbits on either side.

    Raises
    ------
    NoStepError
        If it is not found.
    """
    from scipy.optimize import brentq  # noqa: PLC0415  (300 ms)

    @cache
    def place_at(at: float) -> Place:
        return piece.stepped(before, at) if at else before

    def of_monitor(place: Place) -> float:
        return float(place.monitors[i])

    own = i - (len(before.monitors) - OWN)
    try:
        monitor = beyond_circle(piece, *map(place_at, ends)) if own == OUTSIDE else of_monitor
        search = Search.between(*(abs(monitor(place_at(at))) for at in ends))

        def value(at: float) -> float:
            try:
                height = monitor(place_at(at))
            except NoStepError:
                if own != MEETS or at in ends:
                    raise
                return 0.0
            if np.isnan(height):  # no orbit there that has it
                return search.size
            return 0.0 if search.is_over(at, abs(height)) else height

        at = float(
            brentq(value, *ends, xtol=NEAR * max(map(abs, ends)), rtol=NEAR, maxiter=200)
        )
    except (ValueError, RuntimeError):  # no change of the sign, or too many trials
        raise NoStepError from None
    at = search.at if search.least <= search.small else at
    try:
        return at, place_at(at)
    except NoStepError:
        low, high = either_side(piece, before, at, ends[1] - ends[0])
        return _between(low, high, i)


def either_side(
    piece: Piece, before: Place, at: float, length: float
) -> list[tuple[float, Place]]:
    """Return the nearest orbits on either side of a place in a step, each with where.

    Raises
    ------
    NoStepError
        If there are none.
    """
    for part in SIDES:
        with suppress(NoStepError):
            sides = at - part * length, at + part * length
            return [(side, piece.stepped(before, side)) for side in sides]
    raise NoStepError


def _between(
    low: tuple[float, Place], high: tuple[float, Place], i: int
) -> tuple[float, Place]:
    """Return where between two near orbits a monitor vanishes, and the orbit there, linearly.

    Raises
    ------
    NoStepError
        If it has one sign.
    """
    (start, one), (end, other) = low, high
    first, last = float(one.monitors[i]), float(other.monitors[i])
    if not first * last < 0:
        raise NoStepError
    part = first / (first - last)
    y, maps = (q + part * (r - q) for q, r in ((one.y, other.y), (one.maps, other.maps)))
    monitors = one.monitors.copy()
    monitors[i] = 0.0
    return start + part * (end - start), replace(one, y=y, monitors=monitors, maps=maps)


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
    return replace(event, estimate=max(least, abs(piece.value(place.y) - value)))


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
    if i < forms:
        row, column = piece.rows[i // 3], i % 3
        word = piece.course.word(row, column, int(piece.table[i // 3, BEGINS]))
        yield at, Found(word, row.phase, column, piece, place, i)
    elif i < forms + phases:
        p = i - forms
        yield at, Found(_kind_of_vanishing(piece, p), p, None, piece, place, i)
    else:
        kind = OF_THE_ORBIT[i - forms - phases]
        if kind == "flip" and piece.cell.sign < 0:  # of half a period: the symmetry is lost
            kind = "branch-point"
        yield at, Found(kind, None, None, piece, place, i)


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
    place, i = replace(before, y=y), 3 * len(piece.table) + p
    event = Found(_kind_of_vanishing(piece, p), p, None, piece, place, i)
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


def beyond_circle(piece: Piece, one: Place, other: Place) -> Callable[[Place], float]:
    """Return a monitor of the next multiplier that leaves the unit circle between two orbits.

    It is the modulus less 1 of the largest one that is inside at one of them.  If that is on
    the circle there, as without damping, the monitor vanishes where it is off by rounding.
    """
    k, inside = _first_leaving(one, other)
    size = abs(multipliers(piece, inside)[k]) - 1
    least = NEUTRAL if abs(size) <= NEUTRAL else 0.0
    return lambda place: float(abs(multipliers(piece, place)[k]) - 1 - least)


def _first_leaving(one: Place, other: Place) -> tuple[int, Place]:
    """Return the smaller number of multipliers outside at two orbits, and that orbit."""
    counts = [place.monitors[len(place.monitors) - OWN + OUTSIDE] for place in (one, other)]
    return int(min(counts)), (one, other)[int(np.argmin(counts))]


def _crosses_as_pair(piece: Piece, place: Place, one: Place, other: Place) -> bool:
    """Whether a multiplier that crosses the unit circle between two orbits is complex.

    False as well where it comes back from infinity.
    """
    k, inside = _first_leaving(one, other)
    value, *sides = (multipliers(piece, each)[k] for each in (place, one, other))
    offsets = [abs(abs(each) - 1) for each in (value, *sides)]
    near = ZERO if abs(abs(multipliers(piece, inside)[k]) - 1) > NEUTRAL else np.sqrt(ZERO)
    return bool(abs(value.imag) > TURNED * abs(value) and offsets[0] <= near * max(offsets))


def multipliers(piece: Piece, place: Place) -> Any:
    """Return the multipliers of a cell, not mirrored, by descending modulus."""
    values = np.linalg.eigvals(piece.maps(place)[0])
    return values[np.argsort(-np.abs(values), kind="stable")]


def _kind_of_vanishing(piece: Piece, p: int) -> str:
    """Return the kind of the event at which the duration of a phase vanishes."""
    phase, returned = piece.cell.phases[p], returns(piece.cell, p)
    # it begins without speed: a rest could
    without_speed = piece.along.divided[p] > 1 or (returned and of_velocity(phase.event))
    if phase.held or (without_speed and piece.course.can_rest):
        return "sticking"
    return "grazing" if returned else "vanishing"
