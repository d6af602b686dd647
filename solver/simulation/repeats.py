"""The phases that a motion repeats at its end.

A motion has settled if its last phases are two successive repeats of those before, to what is
left of a transient that is `NEAR`.
"""

import math
from dataclasses import replace

from ..flow import flow
from ..scenes.bodies.cell import BodyCell
from ..scenes.cell import Cell
from .bodies import regime
from .machine import Machine
from .machines import machine_of
from .record import Segment
from .simulate import cycle

#: How many cycles a settled motion may take to repeat.
MOST = 8

#: How far from its limit a settled motion may be, in units of time and length, and as a part of
#: its size; and what is rounding there.
NEAR, ROUNDING = 1e-3, 1e-10

#: What is rounding of a duration, in units of time: of two events that meet, its square root.
NO_TIME = 1e-7


def slowest_decay(cell: Cell) -> float:
    """Return the least rate at which a transient of a damped phase decays; infinite if none."""
    if isinstance(cell, BodyCell):
        return regime.slowest_decay(cell)
    damped = [phase for phase in cell.phases if not phase.held and phase.c > 0]
    rates = [-root.real for phase in damped for root in flow.roots(phase)]
    return min((rate for rate in rates if rate > 0), default=math.inf)


def whole(machine: Machine, repeated: tuple[Segment, ...]) -> tuple[Segment, ...]:
    """Return the phases that a motion repeats, each that goes on behind its event as one.

    None where nothing ever changes.
    """
    pairs = zip((repeated[-1], *repeated[:-1]), repeated, strict=True)
    begins = [i for i, (one, two) in enumerate(pairs) if not _goes_on(machine, one, two)]
    if not begins:
        return ()
    found: list[Segment] = []
    for i in range(begins[0], begins[0] + len(repeated)):
        own = repeated[i % len(repeated)]
        if i % len(repeated) in begins:
            found.append(own)
        else:
            found[-1] = replace(found[-1], s=found[-1].s + own.s, step=own.step)
    return tuple(found)


def _goes_on(machine: Machine, one: Segment, two: Segment) -> bool:
    """Whether nothing changes where one phase ends and the next begins."""
    if one.step is None or any(each.phase == two.index for each in machine.cell.memory):
        return False
    node = machine.node(one.step)
    same = node.equation == machine.node(two.began).equation
    return same and not node.changes_velocity


def repeated(
    cell: Cell, segments: tuple[Segment, ...], rough: float = 0.0
) -> tuple[Segment, ...] | None:
    """Return the phases that a motion repeats at its end, twice; None if there are none.

    What is left of a transient that decays no slower than those of the phases is the change
    from one repeat to the next over what decays in that time.  Where phases may differ by as
    much as is `rough`, that is not asked.
    """
    *done, cut = segments
    for length in range(1, len(done) // 3 + 1):
        again = tuple(done[-length:])
        passed = done[-1].t - done[-1 - length].t
        turns = passed / cycle(cell)
        if turns > MOST + NEAR:
            return None
        full = abs(turns - round(turns)) <= max(NEAR, rough)
        if cell.forced and not (round(turns) and full):
            continue
        near = rough or NEAR * -math.expm1(-slowest_decay(cell) * passed)
        size = min(1.0, max(max(map(abs, q.state)) for q in again))
        pairs = zip(done[-2 * length :], done[-3 * length : -length], strict=True)
        if all(_same(one, two, near, size) for one, two in pairs) and (
            _equation(cell, cut) == _equation(cell, again[0]) and cut.s <= again[0].s + NEAR
        ):
            return again
    return None


def _same(one: Segment, two: Segment, near: float, size: float) -> bool:
    """Whether two phases are the same, in times and states."""
    off = max(abs(a - b) for a, b in zip(one.state, two.state, strict=True))
    return (
        one.named == two.named
        and abs(one.s - two.s) <= max(near, NO_TIME)
        and off <= max(near * size, ROUNDING)
    )


def _equation(cell: Cell, segment: Segment) -> tuple[object, ...]:
    return machine_of(cell).node(segment.began).equation
