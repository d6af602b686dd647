"""The phases that a motion repeats at its end.

A motion has settled if its last phases repeat those before twice in succession, with a
remaining transient below `NEAR`.
"""

import math
from dataclasses import replace

from ..flow import flow
from ..scenes.bodies.cell import BodyCell
from ..scenes.cell import Cell
from .bodies import regime
from .machine import Machine
from .machines import machine_of
from .segment import Segment
from .simulate import cycle

#: Most cycles in the period of a settled motion.
MOST = 8

#: Largest distance of a settled motion from its limit, in units of time and length and relative
#: to its size; and rounding of a state.
NEAR, ROUNDING = 1e-3, 1e-10

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
    equal = node.law == machine.node(two.began).law
    return equal and not node.changes_velocity


def repeated(
    cell: Cell, segments: tuple[Segment, ...], rough: float = 0.0
) -> tuple[Segment, ...] | None:
    """Return the phases that a motion repeats at its end, twice; None if there are none.

    A transient whose slowest decay rate is r leaves, after a repeat of duration T that changes
    the phases by d, at most ``d / (1 - exp(-r T))``: this must be below `NEAR`.  If `rough` is
    not 0, d must be below `rough` instead.
    """
    *done, cut = segments
    for length in range(1, len(done) // 3 + 1):
        tail = tuple(done[-length:])
        passed = done[-1].t - done[-1 - length].t
        turns = passed / cycle(cell)
        if turns > MOST + NEAR:
            return None
        is_whole = abs(turns - round(turns)) <= max(NEAR, rough)
        if cell.forced and not (round(turns) and is_whole):
            continue
        tolerance = rough or NEAR * -math.expm1(-slowest_decay(cell) * passed)
        size = min(1.0, max(max(map(abs, q.state)) for q in tail))
        pairs = zip(done[-2 * length :], done[-3 * length : -length], strict=True)
        if all(_same(one, two, tolerance, size) for one, two in pairs) and (
            _law(cell, cut) == _law(cell, tail[0]) and cut.s <= tail[0].s + NEAR
        ):
            return tail
    return None


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
