"""The phases that a motion repeats at its end, or almost repeats anywhere.

A motion has settled if its last phases repeat those before twice in succession, with a
remaining transient below `NEAR`.  One that does not settle comes near to orbits again and
again: where its state returns closest after a period, an orbit is close, stable or not (the
method of close returns, Lathrop and Kostelich 1989).
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from ..flow import flow
from ..scenes.bodies.cell import BodyCell
from ..scenes.cell import Cell
from ..scenes.orders import Step
from .bodies import regime
from .machine import Machine
from .machines import machine_of
from .segment import Segment
from .simulate import cycle

#: Most cycles of the forcing in the period of a settled motion.
MOST = 8

#: Largest distance of a settled motion from its limit, in units of time and length and relative
#: to its size; and rounding of a state.
NEAR, ROUNDING = 1e-3, 1e-10

#: Farthest of a return: of the state, as a part of its spread, and of the time, of the period.
#: Most phases of a return without a forcing, and with one.
CLOSE, TIMELY, LONGEST, LONGEST_FORCED = 1.0, 0.15, 24, 200

#: Rounding of a duration, in units of time: a square root of it where two events meet.
NO_TIME = 1e-7


def slowest_decay(cell: Cell) -> float:
    """Return the least rate at which a transient of a damped phase decays; infinite if none."""
    if isinstance(cell, BodyCell):
        return regime.slowest_decay(cell)
    damped = [phase for phase in cell.phases if not phase.held and phase.c > 0]
    rates = [-root.real for phase in damped for root in flow.roots(phase)]
    return min((rate for rate in rates if rate > 0), default=math.inf)


def whole(machine: Machine, repeated: tuple[Segment, ...]) -> tuple[Segment, ...]:
    """Return repeated phases, joined where nothing changes at the event between two.

    Empty if nothing ever changes.
    """
    pairs = zip((repeated[-1], *repeated[:-1]), repeated, strict=True)
    begins = [i for i, (one, two) in enumerate(pairs) if not _goes_on(machine, one, two)]
    if not begins:
        return ()
    joined: list[Segment] = []
    for i in range(begins[0], begins[0] + len(repeated)):
        segment = repeated[i % len(repeated)]
        if i % len(repeated) in begins:
            joined.append(segment)
        else:
            joined[-1] = replace(joined[-1], s=joined[-1].s + segment.s, step=segment.step)
    return tuple(joined)


def _goes_on(machine: Machine, one: Segment, two: Segment) -> bool:
    """Whether nothing changes where one phase ends and the next begins."""
    if one.step is None or any(memory.phase == two.index for memory in machine.cell.memory):
        return False
    node = machine.node(one.step)
    return node.goes_on_as(machine.node(two.began)) and not node.changes_velocity


def repeated(cell: Cell, segments: tuple[Segment, ...]) -> tuple[Segment, ...] | None:
    """Return the phases that a motion repeats at its end, twice; None if there are none.

    A transient whose slowest decay rate is r leaves, after a repeat of duration T that changes
    the phases by d, at most ``d / (1 - exp(-r T))``: this must be below `NEAR`.
    """
    *done, cut = segments
    for length in range(1, len(done) // 3 + 1):
        tail = tuple(done[-length:])
        passed = done[-1].t - done[-1 - length].t
        turns = passed / cycle(cell)
        if cell.forced and turns > MOST + NEAR:
            return None
        is_whole = abs(turns - round(turns)) <= NEAR
        if cell.forced and not (round(turns) and is_whole):
            continue
        tolerance = NEAR * -math.expm1(-slowest_decay(cell) * passed)
        size = min(1.0, max(max(map(abs, q.state)) for q in tail))
        pairs = zip(done[-2 * length :], done[-3 * length : -length], strict=True)
        if all(_same(one, two, tolerance, size) for one, two in pairs) and (
            _law(cell, cut) == _law(cell, tail[0]) and cut.s <= tail[0].s + NEAR
        ):
            return tail
    return None


def shortest(cell: Cell, again: tuple[Segment, ...]) -> tuple[Segment, ...]:
    """Return the first of the copies of fewer phases that repeated ones are; else all of them.

    A motion that winds about its orbit as it comes near is back sooner after several periods
    than after one: all copies are within `NEAR` of the orbit.
    """
    for length in range(1, len(again) // 2 + 1):
        turns = (again[length].t - again[0].t) / cycle(cell)
        is_whole = not cell.forced or abs(turns - round(turns)) <= NEAR
        pairs = zip(again[length:], again, strict=False)
        if len(again) % length == 0 and is_whole and all(_near(one, two) for one, two in pairs):
            return again[:length]
    return again


def _near(one: Segment, two: Segment) -> bool:
    """Whether two segments that are within `NEAR` of their limits may have the same limit."""
    return _same(one, two, 2 * NEAR, min(1.0, max(map(abs, one.state))))


def returns(
    cell: Cell, segments: tuple[Segment, ...], cycles: int
) -> Iterator[tuple[Segment, ...]]:
    """Yield phases after which a motion is almost back, of each order the closest ones.

    The closest of all come first.  With a forcing they take `cycles` of its periods, and their
    durations are scaled to do so exactly.
    """
    done, period = segments[:-1], cycle(cell) * cycles if cell.forced else math.inf
    if not done:
        return
    states, times = np.array([q.state for q in done]), np.array([float(q.t) for q in done])
    spread = states.std(axis=0)
    states = states / np.where(spread > 0, spread, 1.0)
    found: list[tuple[float, int, int]] = []
    for i in range(len(done)):
        following = slice(i + 1, i + 1 + (LONGEST_FORCED if cell.forced else LONGEST))
        off = np.abs(states[following] - states[i]).max(axis=1)
        if cell.forced:
            late = np.abs(times[following] - times[i] - period) / period
            off += np.where(late <= TIMELY, late, math.inf)
        found += [(float(off[j]), i, i + 1 + j) for j in map(int, np.flatnonzero(off <= CLOSE))]
    orders: set[tuple[Step, ...]] = set()
    for _, i, j in sorted(found):
        first, back = done[i], done[j]
        if (back.began, back.named) == (first.began, first.named):
            again = done[i:j]
            for each in (again,) if cell.forced else (_mean(again), again):
                order = _from_the_least([q.named for q in each])
                if order not in orders:
                    yield _lasting(each, period)
                orders.add(order)


def _mean(again: tuple[Segment, ...]) -> tuple[Segment, ...]:
    """Return phases that are repeated in turn once, with the means of their durations."""
    names = [q.named for q in again]
    for count in range(1, len(again)):
        if names[count:] + names[:count] == names:
            durations = np.reshape([q.s for q in again], (-1, count)).mean(axis=0)
            pairs = zip(again, durations.tolist(), strict=False)
            return tuple(replace(q, s=s) for q, s in pairs)
    return again


def _from_the_least(steps: Sequence[Step]) -> tuple[Step, ...]:
    """Return a cyclic order, begun so that it comes first of all its rotations."""
    return min((*steps[i:], *steps[:i]) for i in range(len(steps)))


def _lasting(again: tuple[Segment, ...], period: float) -> tuple[Segment, ...]:
    """Return phases with durations scaled to a period, if that is finite."""
    factor = period / sum(q.s for q in again) if math.isfinite(period) else 1.0
    return tuple(replace(q, s=q.s * factor) for q in again)


def _same(one: Segment, two: Segment, near: float, size: float) -> bool:
    """Whether two segments agree in phase, duration and state, this relative to `size`."""
    off = max(abs(a - b) for a, b in zip(one.state, two.state, strict=True))
    return (
        one.named == two.named
        and abs(one.s - two.s) <= max(near, NO_TIME)
        and off <= max(near * size, ROUNDING)
    )


def _law(cell: Cell, segment: Segment) -> tuple[object, ...]:
    return machine_of(cell).node(segment.began).law
