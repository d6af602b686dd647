"""The events in a step of a branch, in order, up to the first change of the order of phases."""

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import replace

import numpy as np

from ..piece import Piece
from ..place import NoStepError, Place
from ..walk import FOLD, MEETS, OUTSIDE, OWN, happens
from ..watch import END, LEAST, START
from .locate import Found, by_cubic, change_at, located, torus_crossings

#: Relative distance of two events that are one; and of the vanishing of a phase and an event in
#: a phase next to it, whose place is known less well there.
SAME, JOINT = 1e-9, 1e-7

#: Length of a step that is short enough for a cubic to be exact to rounding.
CLOSE = 1e-3

#: Parts of the way to a change of the order up to which multipliers are monitored, tried in
#: turn: they may be infinite at the change, and the equations singular.
BEFORE = 1 - 1e-6, 1 - 1e-3, 0.5

#: Which of several monitors that vanish together stands for all: first a duration, then the
#: value at the end.  (A minimum that enters at the start or the end vanishes there as well.)
TURNS = None, END, START, LEAST

#: The kind of where the parameter leaves its interval, which is no event.
EDGE = "edge"

#: Rounding of monitors there, without units.
AT_EDGE = 1e-12


def in_turn(entries: Iterable[tuple[float, Found | None]]) -> list[Found]:
    """Return the events of a step in order, each once, up to the first change of the order.

    Where several monitors vanish at one place, one event stands for all: a change of the order
    of phases before others, and among these that of `TURNS`.  It has those of other phases.
    """
    ordered = sorted(entries, key=lambda each: each[0])
    events = [(at, event) for at, event in ordered if event is not None]
    first = next((at for at, event in events if event.changes), None)
    no_orbit = next((at for at, event in ordered if event is None), None)
    if no_orbit is not None and (first is None or no_orbit <= first):
        raise NoStepError
    if first is None:
        return [event for _, event in events]
    joint = [event for at, event in events if event.changes and at - first <= SAME * first]
    vanish = (event for _, event in events if event.changes and event.column is None)
    count = len(joint[0].piece.along.kinds)
    beside = {((event.phase or 0) + i) % count for event in joint for i in (-1, 0, 1)}
    alike = (q for q in vanish if abs(q.value - joint[0].value) <= JOINT * abs(q.value))
    joint += [q for q in alike if q.phase in beside]
    change = min(joint, key=lambda each: TURNS.index(each.column))
    error = SAME * abs(change.value)
    before = (event for at, event in events if at < first and not event.changes)
    alike = (q for _, q in events if q.changes and q.column == change.column)
    others = {q.phase: q for q in alike if abs(q.value - change.value) <= error}
    others.pop(change.phase, None)
    change = replace(change, at_once=tuple(others.values())) if others else change
    return [*(q for q in before if abs(q.value - change.value) > error), change]


def events_in(
    piece: Piece, before: Place, after: Place, length: float
) -> list[tuple[float, Found | None]]:
    """Return the events of a step, each with where in it; None for one that cannot be passed.

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
        If an event is not located.
    """
    events: list[tuple[float, Found | None]] = []
    edge = _edge(piece, before, after)
    if edge is not None:  # no more counts than what is on the way to it
        events.append(edge)
        length, after = edge[0], edge[1].place
        if length <= 0:  # there the step begins
            return events
    start, end = before.monitors, after.monitors
    watched = len(start) - OWN
    events += _watched(piece, before, after, length)
    changes = [at for at, event in events if event is not None and event.changes]
    if changes:
        length, after = _before(piece, before, min(changes, key=abs))
        end = after.monitors
    own = [i for i in range(watched, len(start)) if happens(start[i], end[i], i - watched)]
    real: list[tuple[float, Found | None]] = []
    for i in (q for q in own if q - watched != OUTSIDE):
        try:
            real += located(piece, before, after, length, i)
        except NoStepError:  # beside where branches meet, the fold of one of them
            if i - watched != FOLD or watched + MEETS not in own:
                raise
    if own:
        events += torus_crossings(piece, before, after, length, [at for at, _ in real])
    kept = [entry for entry in events + real if entry[1] is None or _is_within(entry[1])]
    if len(kept) < len(events + real):  # the step turns back beyond the range
        raise NoStepError
    return kept


def shows_event(before: Place, after: Place) -> bool:
    """Whether the monitors at the ends of a step show an event in it."""
    start, end = before.monitors, after.monitors
    watched = len(start) - OWN
    return any(happens(start[i], end[i], i - watched) for i in range(len(start)))


def _is_within(event: Found) -> bool:
    """Whether an event is within the range of the parameter, which a step may leave."""
    return abs(float(event.place.y[-1])) <= 1 + SAME


def _watched(
    piece: Piece, before: Place, after: Place, length: float
) -> Iterator[tuple[float, Found | None]]:
    """Yield the events of a step at which durations vanish, and then those of forms.

    What happens beyond a change of the order of phases that was found does not count.

    Where two phases vanish together, the equations are singular and the event is found by
    `by_cubic`.  The demands that these phases violate there are the same event.
    """
    forms, together, end = 3 * len(piece.table), False, after
    watched = len(before.monitors) - OWN
    in_turn_of_columns = (i for column in (END, START, LEAST) for i in range(column, forms, 3))
    for i in (*range(forms, watched), *in_turn_of_columns):
        height = float(end.monitors[i])
        if abs(height) <= SAME * abs(after.monitors[i]) and end is not after:
            if happens(before.monitors[i], after.monitors[i], i - watched):
                yield length, change_at(piece, end, i)  # where the order changes anyway
            continue
        if not happens(before.monitors[i], height, i - watched):
            continue
        try:
            for at, event in located(piece, before, end, length, i):
                yield at, event
                if event is not None and event.changes and abs(at) < abs(length):
                    length, end = at, event.place
        except NoStepError:
            if abs(length) > CLOSE or (i < forms and not together):
                raise
            if i >= forms:
                together = True
                yield by_cubic(piece, before, after, length, i - forms)


def _before(piece: Piece, before: Place, at: float) -> tuple[float, Place]:
    """Return how far in a step there is a regular orbit before a change, and that orbit.

    Raises
    ------
    NoStepError
        If there is none.
    """
    for part in BEFORE:
        with suppress(NoStepError):
            return part * at, piece.stepped(before, part * at)
    raise NoStepError


def _edge(piece: Piece, before: Place, after: Place) -> tuple[float, Found] | None:
    """Return where the parameter leaves its interval in a step; None if it stays inside."""
    edge = float(after.y[-1])
    if abs(edge) <= 1:
        return None
    bound = float(np.copysign(1.0, edge))
    part = (bound - float(before.y[-1])) / (edge - float(before.y[-1]))
    y = before.y + part * (after.y - before.y)
    y[-1] = bound
    unknowns = piece.corrected(y, np.append(np.zeros(len(y) - 1), 1.0))
    length = float(before.tangent @ ((unknowns - before.y) * piece.along.weights))
    place = piece.place(unknowns, before.tangent)
    place.monitors[np.abs(place.monitors) <= AT_EDGE] = 0.0  # nothing happens there by rounding
    return length, Found(EDGE, None, None, piece, place)
