"""What happens in a step of a branch, in turn, up to where the order of the phases changes."""

from collections.abc import Iterable, Iterator
from contextlib import suppress

import numpy as np

from .locate import Found, located, through, turning
from .piece import NoStepError, Piece, Place
from .walk import OUTSIDE, OWN, happens
from .watch import END, LEAST, START

#: What may be apart of events that are one, as a part of where they are.
SAME = 1e-9

#: Length of a step whose ends give what is between them to rounding, by a cubic.
CLOSE = 1e-3

#: Parts of a step to a change of the order up to which the orbit itself is looked at, in turn:
#: behind it multipliers may come back from infinity, and at it the equations may be singular.
BEFORE = 1 - 1e-6, 1 - 1e-3, 0.5

#: What of a form stands for all that vanishes at one place, in turn; the end of a phase first.
#: A least value that comes in at the beginning or the end vanishes there as well.
TURNS = None, END, START, LEAST

#: Where the parameter leaves its interval: no event.
EDGE = "edge"

#: What is watched there, without units, that is rounding of a sum of terms.
AT_EDGE = 1e-12


def in_turn(found: Iterable[tuple[float, Found | None]]) -> list[Found]:
    """Return what happens in a step in turn, each once, up to where the order changes.

    Where several things are watched that vanish at one place, one of them stands for all: a
    change of the order before others, of those the end of a phase.
    """
    every = sorted(found, key=lambda each: each[0])
    events = [(at, event) for at, event in every if event is not None]
    first = next((at for at, event in events if event.changes), None)
    if any(event is None and (first is None or at <= first) for at, event in every):
        raise NoStepError
    if first is None:
        return [event for _, event in events]
    here = [event for at, event in events if event.changes and at - first <= SAME * first]
    vanish = (event for _, event in events if event.changes and event.column is None)
    own = {event.phase: SAME * abs(event.value) for event in here}
    here += [q for q in vanish if abs(q.value - here[0].value) <= own.get(q.phase, -1.0)]
    change = min(here, key=lambda each: TURNS.index(each.column))
    near = SAME * abs(change.value)
    before = (event for at, event in events if at < first and not event.changes)
    return [*(q for q in before if abs(q.value - change.value) > near), change]


def events_in(
    piece: Piece, before: Place, after: Place, length: float
) -> list[tuple[float, Found | None]]:
    """Return what happens in a step, with where in it; None of what is not seen where it is.

    Parameters
    ----------
    piece : Piece
    before, after : Place
        The orbits at its ends.
    length : float
        Its length.

    Raises
    ------
    NoStepError
        If something is not located.
    """
    found: list[tuple[float, Found | None]] = []
    edge = _edge(piece, before, after)
    if edge is not None:  # no more counts than what is on the way to it
        found.append(edge)
        length, after = edge[0], edge[1].place
        if length <= 0:  # there the step begins
            return found
    start, end = before.gauges, after.gauges
    watched = len(start) - OWN
    found += _watched(piece, before, after, length)
    changes = [at for at, event in found if event is not None and event.changes]
    if changes:
        length, after = _before(piece, before, min(changes, key=abs))
        end = after.gauges
    own = [i for i in range(watched, len(start)) if happens(start[i], end[i], i - watched)]
    real: list[tuple[float, Found | None]] = []
    for i in own:
        if i - watched != OUTSIDE:
            real += located(piece, before, after, length, i)
    if own:
        found += turning(piece, before, after, length, [at for at, _ in real])
    kept = [each for each in found + real if each[1] is None or _is_within(each[1])]
    if len(kept) < len(found + real):  # the step turns back beyond the range
        raise NoStepError
    return kept


def _is_within(event: Found) -> bool:
    """Whether something happens within the range of the parameter, which a step may leave."""
    return abs(float(event.place.y[-1])) <= 1 + SAME


def _watched(
    piece: Piece, before: Place, after: Place, length: float
) -> Iterator[tuple[float, Found | None]]:
    """Yield where durations vanish in a step, and then forms.

    Where two phases vanish together no orbit is isolated, and the equations are singular: there
    nothing is located, and what demands these phases meet no more is the same event.
    """
    forms, together = 3 * len(piece.table), False
    watched = len(before.gauges) - OWN
    for i in (*range(forms, watched), *range(forms)):
        if not happens(before.gauges[i], after.gauges[i], i - watched):
            continue
        try:
            yield from located(piece, before, after, length, i)
        except NoStepError:
            if abs(length) > CLOSE or (i < forms and not together):
                raise
            if i >= forms:
                together = True
                yield through(piece, before, after, length, i - forms)


def _before(piece: Piece, before: Place, at: float) -> tuple[float, Place]:
    """Return how far in a step an orbit can be looked at before a change, and that orbit.

    Raises
    ------
    NoStepError
        If none can.
    """
    for part in BEFORE:
        with suppress(NoStepError):
            return part * at, piece.stepped(before, part * at)
    raise NoStepError


def _edge(piece: Piece, before: Place, after: Place) -> tuple[float, Found] | None:
    """Return where the parameter leaves its interval in a step; None if it does not."""
    edge = float(after.y[-1])
    if abs(edge) <= 1:
        return None
    side = float(np.copysign(1.0, edge))
    part = (side - float(before.y[-1])) / (edge - float(before.y[-1]))
    y = before.y + part * (after.y - before.y)
    y[-1] = side
    there = piece.led(y, np.append(np.zeros(len(y) - 1), 1.0))
    at = float(before.direction @ ((there - before.y) * piece.along.weights))
    place = piece.place(there, before.direction)
    place.gauges[np.abs(place.gauges) <= AT_EDGE] = 0.0  # nothing happens there by rounding
    return at, Found(EDGE, None, None, piece, place)
