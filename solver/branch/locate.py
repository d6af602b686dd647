"""Where in a step of a branch something happens, the orbit there, and how well it is known."""

import math
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..arrays import Vector
from .along import of_velocity, returns
from .piece import NoStepError, Piece, Place
from .walk import FLIP, FOLD, MEETS, NEUTRAL, OUTSIDE, OWN
from .watch import BEGINS

#: How far back what happens in a step is looked for again, in steps.
BACK = 1.25

#: Beyond it a value where an event was located is a pole, not a zero, as a part of its change.
ZERO = 1e-6

#: What is watched, without units, may be below zero by this: it is rounding.
ROUNDING = 4 * float(np.finfo(float).eps)

#: How near to an event its root is found, as a part of a step.
NEAR = 1e-14

#: Part of a step within which it is no torus that two more multipliers are outside the circle;
#: least imaginary part of a complex one, as a part of it.
SHORT, TURNED = 1e-6, 1e-7

#: The words for what happens to an orbit itself, by gauges behind its forms and durations.
OF_THE_ORBIT = {FOLD: "fold", FLIP: "flip", MEETS: "branch-point", OUTSIDE: "torus"}


@dataclass(frozen=True, eq=False)
class Found:
    """Something that happens on a branch.

    Parameters
    ----------
    kind : str
        The word for it.
    phase : int or None
        The phase that it happens in; None where it is of the whole orbit.
    column : int
        Of `watch`: where in the phase; its duration, without one.
    piece : Piece
    place : Place
    gauge : int
        Which of `Place.gauges` vanishes.
    estimate : float
        Of the error of the parameter: what finding it from the other side gives otherwise.
    """

    kind: str
    phase: int | None
    column: int | None
    piece: Piece
    place: Place
    gauge: int = -1
    estimate: float = 0.0

    @property
    def row(self) -> int:
        """Of the form that vanishes among those that are watched, if it is one."""
        return self.gauge // 3

    @property
    def changes(self) -> bool:
        """Whether the order of the phases is another one beyond."""
        return self.phase is not None

    @property
    def value(self) -> float:
        """The parameter, in SI units."""
        return self.piece.value(self.place.y)


def root(piece: Piece, before: Place, ends: tuple[float, float], i: int) -> tuple[float, Place]:
    """Return where in a part of a step a gauge vanishes, and the orbit there.

    Raises
    ------
    NoStepError
        If it is not found.
    """
    from scipy.optimize import brentq  # noqa: PLC0415  (300 ms)

    def place_at(at: float) -> Place:
        return piece.stepped(before, at) if at else before

    def own(place: Place) -> float:
        return float(place.gauges[i])

    try:
        turns = i - (len(before.gauges) - OWN) == OUTSIDE
        gauge = leaving(piece, *map(place_at, ends)) if turns else own

        sizes = [abs(gauge(place_at(at))) for at in ends]
        no_orbit, rounding = np.isnan(sizes).any(), ROUNDING * max(sizes)

        def value(at: float) -> float:
            found = gauge(place_at(at))
            if np.isnan(found):
                return 1.0
            if no_orbit:  # what vanishes where orbits end does so like a square
                return math.copysign(math.sqrt(abs(found)), found)
            return 0.0 if abs(found) <= rounding else found

        at = float(
            brentq(value, *ends, xtol=NEAR * max(map(abs, ends)), rtol=NEAR, maxiter=200)
        )
    except (ValueError, RuntimeError):  # no change of the sign, or too many trials
        raise NoStepError from None
    return at, piece.stepped(before, at)


def estimated(event: Found, after: Place, length: float) -> Found:
    """Return something that happens in a step, with what finding it from behind changes."""
    piece, value = event.piece, event.value
    least = float(np.spacing(abs(value)))
    try:
        _, place = root(piece, after, (0.0, -BACK * length), event.gauge)
    except NoStepError:  # behind a phase that has no duration nothing is smooth
        return replace(event, estimate=max(least, event.estimate))
    return replace(event, estimate=max(least, abs(piece.value(place.y) - value)))


def located(
    piece: Piece, before: Place, after: Place, length: float, i: int
) -> Iterator[tuple[float, Found | None]]:
    """Yield where something that is watched vanishes in a step, if it does."""
    end = float(after.gauges[i])
    forms, phases = 3 * len(piece.table), len(piece.along.kinds)
    at, place = root(piece, before, (0.0, length), i)
    ends = end, 0.0 if i < forms + phases else float(before.gauges[i])
    if not abs(float(place.gauges[i])) <= ZERO * max(map(abs, ends)):
        if i < forms + phases and abs(end) > ROUNDING:  # there is no orbit beyond
            yield at, None
        return
    if i < forms:
        row, column = piece.rows[i // 3], i % 3
        word = piece.course.word(row, column, int(piece.table[i // 3, BEGINS]))
        yield at, Found(word, row.phase, column, piece, place, i)
    elif i < forms + phases:
        p = i - forms
        yield at, Found(_word_of_duration(piece, p), p, None, piece, place, i)
    else:
        kind = OF_THE_ORBIT[i - forms - phases]
        if kind == "flip" and piece.cell.sign < 0:  # of half a period: the symmetry is lost
            kind = "branch-point"
        yield at, Found(kind, None, None, piece, place, i)


def through(
    piece: Piece, before: Place, after: Place, length: float, p: int
) -> tuple[float, Found]:
    """Return where the duration of a phase vanishes in a step, by the cubic between its ends.

    An orbit is a smooth function of a duration, through zero as well.  The cubic to a place
    twice as far says how well that is known.

    Raises
    ------
    NoStepError
        If there is no orbit twice as far.
    """
    part, y = _cubic(piece, before, after, p)
    place, i = replace(before, y=y), 3 * len(piece.table) + p
    found = Found(_word_of_duration(piece, p), p, None, piece, place, i)
    _, other = _cubic(piece, before, piece.stepped(before, 2 * length), p)
    return part * length, replace(found, estimate=abs(piece.value(other) - found.value))


def _cubic(piece: Piece, before: Place, after: Place, p: int) -> tuple[float, Vector]:
    """Return at which part of a step a duration vanishes, and the unknowns by a cubic in it."""
    j = piece.along.before + p
    first, last = float(before.y[j]), float(after.y[j])
    span, part = last - first, first / (first - last)
    slopes = [q.direction / piece.along.weights for q in (before, after)]
    one, other = (span * slope / slope[j] for slope in slopes)
    chord = after.y - before.y
    bent = (1 - part) * (one - chord) - part * (other - chord)
    return part, before.y + part * (chord + (1 - part) * bent)


def turning(
    piece: Piece, before: Place, after: Place, length: float, real: Iterable[float]
) -> Iterator[tuple[float, Found]]:
    """Yield where a pair of complex multipliers crosses the unit circle in a step.

    That two more are outside is seen beside the places where one alone, which is `real`, comes
    or goes: at folds and flips.
    """
    which = len(before.gauges) - OWN + OUTSIDE
    ends, beside = [(0.0, before)], SHORT * length
    for at in sorted(real, key=lambda at: at / length):
        ends += [(q, piece.stepped(before, q)) for q in (at - beside, at + beside)]
    ends.append((length, after))
    parts = [(*ends[i], *ends[i + 1]) for i in range(0, len(ends), 2)]
    while parts:
        low, one, high, other = parts.pop()
        if not abs(other.gauges[which] - one.gauges[which]) > 1:
            continue
        with suppress(NoStepError):
            at, place = root(piece, before, (low, high), which)
            if _turns(piece, place, one, other):
                yield at, Found("torus", None, None, piece, place, which)
                continue
        if abs(high - low) > SHORT * abs(length):
            at = (low + high) / 2
            middle = piece.stepped(before, at)
            parts += [(low, one, at, middle), (at, middle, high, other)]


def leaving(piece: Piece, one: Place, other: Place) -> Callable[[Place], float]:
    """Return what vanishes between two orbits where more multipliers come to be outside.

    It is how far outside the unit circle the first is that is not at both.  Where that is on
    the circle at one of them, since nothing is lost, it is how far beyond rounding.
    """
    k, inside = _first(one, other)
    size = abs(multipliers(piece, inside)[k]) - 1
    least = NEUTRAL if abs(size) <= NEUTRAL else 0.0
    return lambda place: float(abs(multipliers(piece, place)[k]) - 1 - least)


def _first(one: Place, other: Place) -> tuple[int, Place]:
    """Return how many multipliers are outside at the one of two orbits with fewer, and it."""
    counts = [place.gauges[len(place.gauges) - OWN + OUTSIDE] for place in (one, other)]
    return int(min(counts)), (one, other)[int(np.argmin(counts))]


def _turns(piece: Piece, place: Place, one: Place, other: Place) -> bool:
    """Whether a complex multiplier crosses the unit circle at a place between two orbits.

    It does not if it is real, or comes back from infinity.
    """
    k, inside = _first(one, other)
    value, *sides = (multipliers(piece, each)[k] for each in (place, one, other))
    apart = [abs(abs(each) - 1) for each in (value, *sides)]
    near = ZERO if abs(abs(multipliers(piece, inside)[k]) - 1) > NEUTRAL else np.sqrt(ZERO)
    return bool(abs(value.imag) > TURNED * abs(value) and apart[0] <= near * max(apart))


def multipliers(piece: Piece, place: Place) -> Any:
    """Return the multipliers of a cell before it is mirrored, the largest first."""
    values = np.linalg.eigvals(piece.maps(place)[0])
    return values[np.argsort(-np.abs(values), kind="stable")]


def _word_of_duration(piece: Piece, p: int) -> str:
    """Return what it is called where a phase of a cell gets no duration."""
    phase, back = piece.cell.phases[p], returns(piece.cell, p)
    # it begins without speed: a rest could
    still = piece.along.divided[p] > 1 or (back and of_velocity(phase.event))
    if phase.held or (still and piece.course.can_rest):
        return "sticking"
    return "grazing" if back else "vanishing"
