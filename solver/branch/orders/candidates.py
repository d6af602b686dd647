"""The orders of phases in which the orbit at an event can also be read.

A phase of duration zero is inserted or removed, by the rules of which phase may follow another.
"""

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import replace
from itertools import islice, product

import numpy as np

from ...scenes.orders import Step, image
from ...scenes.parameter_error import ParameterError
from ...simulation.followers import may_follow
from ...simulation.machine import Machine
from ..course import ROUNDING
from ..events.locate import Found
from ..watch import END, LEAST, START, WITHIN
from .candidate import Candidate, Slot

#: How far beside an event its rules and surfaces are looked at, as a part of an interval.
BESIDE = 1e-6

#: Parts of a phase that is divided without another one between.
INTO_TWO = 2


class AtEvent:
    """An orbit at an event, and its candidates for the order of phases beyond."""

    def __init__(self, event: Found) -> None:
        piece, y = event.piece, event.place.y
        numbers = piece.numbers(y)
        self.event, self.course, self.z = event, piece.course, y[:-1]
        self.equations = piece.equations(y)
        self.cell, self.machine = self.course.cell(numbers), self.course.machine(numbers)
        self.steps = [node.step for node in self.machine.nodes]
        self.angle = float(y[-2]) if self.cell.forced else 0.0
        self.half = self.course.order.half_period
        states, durations = self.course.states(self.equations, y), piece.durations(y).tolist()
        self.slots = list(map(Slot, self.course.order.steps, states, durations))
        endless = self.course.endless
        self.orbit = Candidate(tuple(self.slots), self.half, self.angle, endless=endless)

    def candidates(self) -> Iterator[Candidate]:
        """Yield the candidates, those of fewer phases first."""
        p, column = self.event.phase, self.event.column
        assert p is not None
        if column is None:
            yield from self._without_all() if self.event.at_once else ()
            yield from self._without(self.orbit, p, p)
            yield from self._all_swapped(self.orbit, (self.event, *self.event.at_once))
            return
        row = self.event.piece.rows[self.event.row]
        within = row.kind == WITHIN
        if within and self.course.endless:
            yield from self._touched_at_last(row.number, column)
        elif within and column == LEAST:
            yield from self._touched(self.event, *self.event.at_once)
            yield from self._touched(self.event) if self.event.at_once else ()
        elif within and column == START:
            yield from self._between((p - 1) % len(self.slots))
        elif within and column == END:
            yield from self._uncrossed(p)
            yield from self._visited(p, row.number)
        else:
            yield from self._between(p)

    def as_declared(self, candidate: Candidate) -> Candidate:
        """Return a candidate rotated to begin as an order that the scene declares.

        If none fits, it begins with a phase that is not mirrored, if there is one.
        """
        rotations = list(self.rotations(candidate))
        plain = (each for each in rotations if not each.slots[0].step.mirrored)
        declared = (each for each in rotations if each.course(self.course).declared is not None)
        return next(declared, next(plain, candidate))

    def rotations(self, candidate: Candidate) -> Iterator[Candidate]:
        """Yield a candidate, begun at each of its phases in turn."""
        yield candidate
        count = len(candidate.slots) * (2 if candidate.half else 1)
        for _ in range(0 if candidate.endless else count - 1):
            candidate = self._turned(candidate)
            yield candidate

    def _turned(self, candidate: Candidate) -> Candidate:
        """Return a candidate rotated by one phase."""
        first, *rest = candidate.slots
        last = self.next_cell(first, candidate.half)
        angle = candidate.angle + self.cell.omega * first.s
        grows = tuple((i - 1) % len(candidate.slots) for i in candidate.grows)
        return Candidate((*rest, last), candidate.half, angle, grows)

    def next_cell(self, slot: Slot, half: bool | None = None) -> Slot:
        """Return a phase a cell later: the same, or mirrored if cells are half periods."""
        if not (self.half if half is None else half):
            return slot
        mirrored = image(self.machine.cell, slot.step)
        assert mirrored is not None
        return replace(slot, step=mirrored, state=tuple(-component for component in slot.state))

    def _from(self, p: int) -> tuple[list[Slot], float]:
        """Return the phases of one cell from phase p on, and the angle where p begins."""
        begun = next(islice(self.rotations(self.orbit), p, None))
        return list(begun.slots), begun.angle

    def _without(self, orbit: Candidate, i: int, p: int) -> Iterator[Candidate]:
        """Yield an order without its phase i, the orbit's phase p.

        Its neighbours become one if they are alike, or the one before ends by another event.
        """
        if len(orbit.slots) > 1:
            begun = next(islice(self.rotations(orbit), i, None))
            slots, angle = list(begun.slots), begun.angle
            if self._leaps(p):
                yield Candidate(tuple(slots[1:]), self.half, angle)
            else:
                yield from self._joined(slots[1:], angle)
            yield from self._ended_otherwise(slots[1:], angle)

    def _without_all(self) -> Iterator[Candidate]:
        """Yield the order without all phases that vanish at once."""
        orbit = self.orbit
        for event in (self.event, *self.event.at_once):
            vanished = self.slots[event.phase or 0]
            places = [i for i, slot in enumerate(orbit.slots) if slot is vanished]
            orbits = [q for i in places for q in self._without(orbit, i, event.phase or 0)]
            if not orbits or orbits[0].endless:
                return
            orbit = orbits[0]
        yield orbit
        yield from self._ended_otherwise(list(orbit.slots), orbit.angle)

    def _all_swapped(self, orbit: Candidate, events: tuple[Found, ...]) -> Iterator[Candidate]:
        """Yield orders in which the events about each vanished phase are swapped."""
        event, *others = events
        vanished = self.slots[event.phase or 0]
        places = [i for i, slot in enumerate(orbit.slots) if slot is vanished]
        for swapped in (q for i in places for q in self._swapped(orbit, i, event.phase or 0)):
            if others:
                yield from self._all_swapped(swapped, tuple(others))
            else:
                yield swapped

    def _swapped(self, orbit: Candidate, i: int, p: int) -> Iterator[Candidate]:
        """Yield orders in which the events before and behind a phase happen in the other order.

        Of a body two contacts may switch at once.  The phase is phase i of an order, and the
        orbit's phase p.
        """
        begun = next(islice(self.rotations(orbit), (i - 1) % len(orbit.slots), None))
        slots, angle = list(begun.slots), begun.angle
        first, last, *rest = slots if len(slots) > 1 else slots * 2
        state = self.course.state(self.equations, self.z, (p - 1) % len(self.slots), first.s)
        for step in self.steps:
            if step == first.step or not self._alike(step, first.step):
                continue
            ended = replace(first, step=step)
            after = rest[0] if rest else self.next_cell(ended)
            if self.machine.node(step).changes_velocity:
                state = after.state
            for other in self.steps:
                between = other != last.step and self._may(step, other)
                if between and self._may(other, after.step):
                    swapped = (ended, Slot(other, state, 0.0), *rest)
                    yield Candidate(swapped, self.half, angle, (*begun.grows, 1))

    def _leaps(self, p: int) -> bool:
        """Whether the velocity jumps where phase p begins."""
        last, orbit = (p - 1) % len(self.slots), (self.equations, self.z)
        before = self.course.moving_at(*orbit, last, self.slots[last].s)[1]
        before *= self.cell.sign if p == 0 else 1
        after = self.course.moving_at(*orbit, p, 0.0)[1]
        fastest = float(np.abs(self.event.place.extremes[1]).max())
        return abs(after - before) > ROUNDING * fastest

    def _uncrossed(self, p: int) -> Iterator[Candidate]:
        """Yield orders in which phase p goes on at its event, or ends by another."""
        slots, angle = self._from((p + 1) % len(self.slots))
        if self._alike(slots[-1].step, self.next_cell(slots[0]).step):
            yield from self._joined(slots, angle)
        yield from self._ended_otherwise(slots, angle)

    def _visited(self, p: int, demand: int) -> Iterator[Candidate]:
        """Yield orders in which a demand ends phase p, and one phase or two lie beyond it."""
        slots, angle = self._from((p + 1) % len(self.slots))
        last, after = slots[-1], self.next_cell(slots[0])
        ended = self._ended_by(last.step, demand)
        if ended is None:
            return
        first = [(step,) for step in self.steps if self._may(ended, step)]
        pairs = [(one, two) for (one,) in first for two in self.steps if self._may(one, two)]
        for beyond in (*first, *pairs):
            if self._may(beyond[-1], after.step):
                new = [Slot(step, after.state, 0.0) for step in beyond]
                grows = tuple(range(len(slots), len(slots) + len(new)))
                visited = (*slots[:-1], replace(last, step=ended), *new)
                yield Candidate(visited, self.half, angle, grows)

    def _ended_otherwise(self, slots: list[Slot], angle: float) -> Iterator[Candidate]:
        """Yield orders in which the last phase ends by another of its events."""
        last, after = slots[-1], self.next_cell(slots[0]).step
        for step in self.steps:
            if step != last.step and self._alike(step, last.step) and self._may(step, after):
                ended = replace(last, step=step)
                yield Candidate((*slots[:-1], ended), self.half, angle)

    def _joined(self, slots: list[Slot], angle: float) -> Iterator[Candidate]:
        """Yield an order in which the last and the first phase become one, if they are alike.

        If no other phase is left, the motion never ends.  A rest for ever is not followed, nor
        a motion with a memory, which any value of that memory satisfies.
        """
        last, first = slots[-1], self.next_cell(slots[0])
        if not self._alike(last.step, first.step):
            yield Candidate(tuple(slots), self.half, angle)
        elif len(slots) > 1:
            joined = Slot(first.step, last.state, last.s + first.s)
            angle += self.cell.omega * slots[0].s
            yield Candidate((*slots[1:-1], joined), self.half, angle)
        elif self._goes_on(last.step):
            yield self._endless(last, angle)

    def _endless(self, slot: Slot, angle: float) -> Candidate:
        """Return a motion of one phase that fills the cell."""
        whole = replace(slot, s=slot.s * (2 if self.half else 1))
        return Candidate((whole,), False, angle, endless=True)

    def _goes_on(self, step: Step) -> bool:
        """Whether a phase that never ends is an isolated motion."""
        held = self.course.base.kinds[step.phase][1]
        return self.cell.forced and not held and not self.cell.memory

    def _between(self, p: int) -> Iterator[Candidate]:
        """Yield orders with one more phase behind phase p."""
        before, after = (*self.slots, self.next_cell(self.slots[0]))[p : p + 2]
        for step in self.steps:
            if self._may(before.step, step) and self._may(step, after.step):
                inserted = Slot(step, after.state, 0.0)
                slots = (*self.slots[: p + 1], inserted, *self.slots[p + 1 :])
                yield Candidate(slots, self.half, self.angle, (p + 1,))

    def _touched(self, *events: Found) -> Iterator[Candidate]:
        """Yield orders in which phases end at demands that vanish inside them."""
        divided = {event.phase: list(self._divided(event)) for event in events}
        for every in product(*divided.values()):
            parts = dict(zip(divided, every, strict=True))
            slots: list[Slot] = []
            grows: list[int] = []
            for p, slot in enumerate(self.slots):
                own = parts.get(p, [slot])
                grows += [len(slots) + 1] if len(own) > INTO_TWO else []
                slots += own
            yield Candidate(tuple(slots), self.half, self.angle, tuple(grows))

    def _divided(self, event: Found) -> Iterator[list[Slot]]:
        """Yield the parts of a phase that a touch divides, with a phase between or without."""
        slot, row = self.slots[event.phase or 0], event.piece.rows[event.row]
        arguments = self.equations, event.piece.table, self.z, event.row
        time = float(self.course.by("when_least", *arguments))
        state = self.course.state(self.equations, self.z, event.phase or 0, time)
        for ended, inserted in self._ways_on(slot.step, row.number, state):
            first = replace(slot, step=ended, s=time)
            yield [first, *inserted, Slot(slot.step, state, slot.s - time)]

    def _touched_at_last(self, demand: int, column: int) -> Iterator[Candidate]:
        """Yield orders for a motion that never ended, cut where it touches a surface.

        Its start counts as inside.
        """
        arguments = self.equations, self.event.piece.table, self.z, self.event.row
        time = 0.0 if column != LEAST else float(self.course.by("when_least", *arguments))
        state = self.course.state(self.equations, self.z, 0, time)
        angle, slot = self.angle + self.cell.omega * time, self.slots[0]
        for ended, inserted in self._ways_on(slot.step, demand, state):
            yield from self._cut(inserted, Slot(ended, state, slot.s), angle)

    def _ways_on(
        self, step: Step, demand: int, state: tuple[float, ...]
    ) -> Iterator[tuple[Step, list[Slot]]]:
        """Yield how a phase goes on behind a touch: which ended, a phase between or none."""
        ended = self._ended_by(step, demand)
        if ended is None:
            return
        if self.machine.node(ended).changes_velocity and self._may(ended, step):
            yield ended, []
        for between in self.steps:
            if self._may(ended, between) and self._may(between, step):
                yield ended, [Slot(between, state, 0.0)]

    def _ended_by(self, step: Step, demand: int) -> Step | None:
        """Return the phase of the same equation that ends where a demand vanishes."""
        surface = self.machine.node(step).demands[demand]
        return self.machine.ending(self.machine.number(step), surface)

    def _cut(self, new: list[Slot], rest: Slot, angle: float) -> Iterator[Candidate]:
        """Yield orders for a motion that never ended, cut where it touches a surface."""
        grows = (0,) if new else ()
        for step in self.steps if self._symmetric(q.step for q in (*new, rest)) else ():
            other = image(self.machine.cell, new[0].step if new else step)
            if self._alike(step, rest.step) and other is not None and self._may(step, other):
                half = Slot(step, rest.state, rest.s / 2)
                yield Candidate((*new, half), True, angle, grows)
        yield Candidate((*new, rest), False, angle, grows)

    def _symmetric(self, steps: Iterable[Step]) -> bool:
        """Whether the mirror image of each phase is a phase of the scene."""
        return all(image(self.machine.cell, step) is not None for step in steps)

    def _alike(self, one: Step, other: Step) -> bool:
        """Whether two phases have the same law."""
        return self.machine.node(one).law == self.machine.node(other).law

    def _may(self, one: Step, other: Step) -> bool:
        """Whether a phase may follow another at the event, or a little beside it.

        At the event a demand behind a switch in a known place may vanish.
        """
        return any(may_follow(machine, one, other) for machine in self._machines())

    def _machines(self) -> Iterator[Machine]:
        """Yield the rules at the event, and a little beside it to either side."""
        yield self.machine
        for aside in (BESIDE, -BESIDE):
            y = self.event.place.y.copy()
            y[-1] += aside
            with suppress(ParameterError):  # there is no such oscillator
                yield self.course.machine(self.event.piece.numbers(y))
