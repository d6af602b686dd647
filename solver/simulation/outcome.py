"""What a simulated motion settles on: an order of phases with times, or words on why on none.

If it settles on an order of phases that the scene does not declare, words say so.  That no
switch follows any more is said only if it is proven.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import islice

import numpy as np

from ..kernels.start import RoughTimes
from ..scenes.cell import Cell, Memory
from ..scenes.orders import Order, declared_order, half_if_mirrored, image, orders_of_motions
from .machines import machine_of
from .nodes import firsts
from .record import Simulation
from .repeats import NEAR, repeated, returns, shortest, whole
from .segment import Segment
from .simulate import cycle

#: Most orders of phases in which an unsettled motion almost returns, that are tried.
RETURNS = 4

#: Cycles without a switch at the end of a simulation that are told.
SILENT = 10

#: Words for a motion without any further switch.
WITHOUT_SWITCHES = "a simulation comes to a motion without switches"


@dataclass(frozen=True)
class Settled:
    """The outcome of a simulation: in words, and as times of a cell of the declared order.

    `times` is None if it did not settle on that order; `other` is another order on which it
    settled.  It is `conclusive` if it became periodic, or has no more switches.  There are no
    words where it almost returned on the way: see `nearly`.
    """

    times: RoughTimes | None
    words: str
    other: "Other | None" = None
    conclusive: bool = True


@dataclass(frozen=True)
class Other:
    """An order of phases that is not the declared one, with times of a cell.

    The period of its motion is `cycles` periods of the forcing.
    """

    order: Order
    times: RoughTimes
    cycles: int

    def within(self, cycles: int) -> "Other | None":
        """Return the order of `cycles` cycles that the phases repeat; None if there is none.

        A motion that approaches an orbit from alternating sides is first seen to repeat after
        two of its periods.
        """
        parts, remainder = divmod(self.cycles, cycles)
        if remainder or parts < 2:
            return None if remainder else self
        count = len(self.order.steps) // parts
        steps = self.order.steps[:count]
        if self.order.half_period or steps * parts != self.order.steps:
            return None
        means = np.reshape(self.times.durations, (parts, count)).mean(axis=0)
        times = replace(self.times, durations=tuple(means.tolist()))
        return Other(Order(steps), times, cycles)

    def times_in(self, order: Order, cell: Cell) -> RoughTimes | None:
        """Return the times from where the motion begins as an order; None if it never does."""
        steps, durations = self.order.steps, self.times.durations
        count = len(steps)
        if self.order.half_period:
            images = (image(cell, step) for step in steps)
            steps, durations = (*steps, *filter(None, images)), durations * 2
        for i in range(len(steps) if order.half_period == self.order.half_period else 0):
            if (steps[i:] + steps[:i])[:count] == order.steps:
                angle = self.times.angle + cell.omega * sum(durations[:i])
                turned = (durations[i:] + durations[:i])[:count]
                return replace(self.times, durations=turned, angle=angle)
        return None


def outcome_of(cell: Cell, motion: Simulation) -> Settled:
    """Return the outcome of a motion of a cell, from its last phases."""
    if motion.ended:
        return Settled(None, f"a simulation ends: {motion.ended}", conclusive=False)
    last = motion.segments[-1]
    if machine_of(cell).lasts(last):
        return Settled(None, WITHOUT_SWITCHES)
    again = repeated(cell, motion.segments)
    if again is not None:
        return _settled_on(cell, shortest(cell, again))
    cycles, silent = (round(float(t) / cycle(cell)) for t in (last.t + last.s, last.s))
    words = f"a simulation of {cycles} cycles does not settle"
    if silent >= SILENT:
        words += f": without a switch in the last {silent}, it may stay in {last.phase.name}"
    return Settled(None, words, conclusive=False)


def as_copies(cell: Cell, motion: Simulation) -> tuple[Settled, ...]:
    """Return what a motion repeats with all copies, where `outcome_of` takes them for one.

    Without words: it may be tried, but most likely it is that one.
    """
    again = repeated(cell, motion.segments)
    are_copies = again is not None and shortest(cell, again) != again
    return (replace(_settled_on(cell, again), words=""),) if again and are_copies else ()


def nearly(cell: Cell, motion: Simulation, cycles: int) -> Iterator[Settled]:
    """Yield times near to which a motion may have orbits, of `cycles` periods of the forcing.

    They are those of its closest `returns`: for a motion that has not settled on such a period.
    """
    where = "a simulation that almost returns"
    for again in islice(returns(cell, motion.segments, cycles), RETURNS):
        found = _settled_on(cell, again)
        times = found.times and replace(found.times, words=where)
        if times or found.other:
            yield replace(found, times=times, words="", conclusive=False)


def _settled_on(cell: Cell, again: tuple[Segment, ...]) -> Settled:
    """Return the outcome of a motion that repeats some phases."""
    phases = whole(machine_of(cell), again)
    if not phases:
        return Settled(None, WITHOUT_SWITCHES)
    phases = _from_the_first(cell, phases)
    return _declared(cell, phases) or _other(cell, phases)


def _from_the_first(cell: Cell, again: tuple[Segment, ...]) -> tuple[Segment, ...]:
    """Return repeated phases, rotated to begin as the motion that declares them.

    Else with the one that comes first in the scene; if this leaves a choice, with the longest.
    """
    rotations = [again[i:] + again[:i] for i in range(len(again))]
    rotations = [each for each in rotations if _of_a_motion(cell, each)] or rotations
    first = min([q.named for q in each] for each in rotations)
    candidates = (each for each in rotations if [q.named for q in each] == first)
    return max(candidates, key=lambda each: each[0].s)


def _of_a_motion(cell: Cell, again: tuple[Segment, ...]) -> bool:
    """Whether one of several motions declares the order of repeated phases."""
    motions = orders_of_motions(cell)
    if all(len(again) not in (len(q.steps), 2 * len(q.steps)) for q in motions):
        return False
    order = Order(tuple(q.named for q in again))
    return order in motions or half_if_mirrored(cell, order) in motions


def _declared(cell: Cell, again: tuple[Segment, ...]) -> Settled | None:
    """Return the times of a cell if the repeated phases have the declared order, else None."""
    segments = again[: len(cell.phases)]
    order = declared_order(cell)
    if order is None or tuple(q.named for q in segments) != order.steps:
        return None
    if len(again) != len(segments) * cell.cells:
        return None
    if cell.forced and abs(sum(q.s for q in segments) - cell.duration) > NEAR:
        return None
    names = ", ".join(q.phase.name for q in segments)
    where = f"a simulation that settles on {names}"
    times = RoughTimes(tuple(q.s for q in segments), segments[0].angle, where)
    return Settled(times, f"a simulation settles on {names}")


def _other(cell: Cell, again: tuple[Segment, ...]) -> Settled:
    """Return the outcome of a motion that settles on another order of phases."""
    count = round(sum(q.s for q in again) / cycle(cell))
    if not _of_a_motion(cell, again):
        again = _from_the_first(cell, _each_by_one_name(cell, again))
    called = [phase.name for phase in cell.phases]
    names = ", ".join(q.named.called(called) for q in again)
    every = "each period" if count == 1 else f"every {count} periods"
    within = f", in {every} of the forcing" if cell.forced else ""
    why = _no_order(cell, again)
    if why:
        what = f"phases that cannot be solved for: {names}{within}; {why}"
        return Settled(None, f"a simulation settles on {what}")
    other = _in_order(cell, again, count if cell.forced else 1)
    if other.order in orders_of_motions(cell):
        names = ", ".join(step.called(called) for step in other.order.steps)
    else:
        names = f"another sequence of phases: {names}{within}"
    return Settled(None, f"a simulation settles on {names}", other)


def _each_by_one_name(cell: Cell, segments: tuple[Segment, ...]) -> tuple[Segment, ...]:
    """Return phases named by the first of those that are the same."""
    machine = machine_of(cell)
    first = firsts(cell, machine.nodes)
    return tuple(replace(q, step=q.step and first[machine.number(q.step)]) for q in segments)


def _no_order(cell: Cell, segments: tuple[Segment, ...]) -> str:
    """Return in words why repeated phases are no order of a scene; empty if they are one."""
    called = [phase.name for phase in cell.phases]
    for q in segments:
        if q.step is None:
            return f"{q.began.called(called)} ends by a demand there, not by its event"
    if all(q.phase.rests for q in segments):
        return "in all of them the mass is held, wherever it is"
    memory = unset(cell, {q.named.phase for q in segments})
    if memory is None:
        return ""
    if memory.within:
        return f"none of them sets {memory.name}, which may have any of many values"
    return f"{called[memory.phase]}, which sets a memory, is not among them"


def unset(cell: Cell, phases: set[int]) -> Memory | None:
    """Return a memory that none of some phases of a cell sets, if they alone take turns."""
    for memory in cell.memory:
        if phases <= {*memory.within} if memory.within else memory.phase not in phases:
            return memory
    return None


def _in_order(cell: Cell, segments: tuple[Segment, ...], cycles: int) -> Other:
    """Return repeated phases as an order, with the times of its cell."""
    order, half = Order(tuple(q.named for q in segments)), len(segments) // 2
    if all(
        _alike(one.s, two.s) for one, two in zip(segments[:half], segments[half:], strict=False)
    ):
        order = half_if_mirrored(cell, order)  # the motion, not only its order
    segments = segments[: len(order.steps)]
    times = RoughTimes(
        tuple(q.s for q in segments), segments[0].angle, "the times of a simulation"
    )
    return Other(order, times, cycles)


def _alike(one: float, two: float) -> bool:
    """Whether two durations agree to the tolerance of a settled motion."""
    return abs(one - two) <= NEAR * max(one, two, 1.0)
