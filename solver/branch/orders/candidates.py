"""The orders of phases in which the orbit at an event can also be read.

A phase of duration zero is inserted or removed, by the rules of which phase may follow another.
"""

from collections.abc import Iterator
from dataclasses import replace
from itertools import product

from ...scenes.orders import Step, image
from ..events.locate import Found
from ..watch import END, LEAST, START, WITHIN
from .candidate import Candidate, Slot
from .reading import Reading

#: Parts of a phase that is divided without another one between.
INTO_TWO = 2


class AtEvent(Reading):
    """An orbit at an event, and its candidates for the order of phases beyond."""

    def candidates(self) -> Iterator[Candidate]:
        """Yield the candidates, those of fewer phases first."""
        p, column = self.event.phase, self.event.column
        assert p is not None
        if column is None:
            yield from self._without_all() if self.event.at_once else ()
            yield from self._without(self.orbit, p, p)
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

    def _without(self, orbit: Candidate, i: int, p: int) -> Iterator[Candidate]:
        """Yield an order without its phase i, the orbit's phase p.

        Its neighbours become one if they are alike, or the one before ends by another event.
        """
        if len(orbit.slots) > 1:
            slots, angle = self.begun_at(orbit, i)
            if self.leaps(p):
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

    def _uncrossed(self, p: int) -> Iterator[Candidate]:
        """Yield orders in which phase p goes on at its event, or ends by another."""
        slots, angle = self.begun_at(self.orbit, (p + 1) % len(self.slots))
        if self.alike(slots[-1].step, self.next_cell(slots[0]).step):
            yield from self._joined(slots, angle)
        yield from self._ended_otherwise(slots, angle)

    def _visited(self, p: int, demand: int) -> Iterator[Candidate]:
        """Yield orders in which a demand ends phase p, and one phase or two lie beyond it."""
        slots, angle = self.begun_at(self.orbit, (p + 1) % len(self.slots))
        last, after = slots[-1], self.next_cell(slots[0])
        ended = self.ended_by(last.step, demand)
        if ended is None:
            return
        state = after.state
        if not self.machine.node(ended).changes_velocity:  # phase p may end by a jump
            at_end = self.course.state(self.equations, self.z, p, last.s)
            state = self.next_cell(replace(self.slots[p], state=at_end)).state
        first = [(step,) for step in self.steps if self.allows(ended, step)]
        pairs = [(one, two) for (one,) in first for two in self.steps if self.allows(one, two)]
        for beyond in (*first, *pairs):
            if self.allows(beyond[-1], after.step):
                new = [Slot(step, state, 0.0) for step in beyond]
                grows = tuple(range(len(slots), len(slots) + len(new)))
                visited = (*slots[:-1], replace(last, step=ended), *new)
                yield Candidate(visited, self.half, angle, grows)

    def _ended_otherwise(self, slots: list[Slot], angle: float) -> Iterator[Candidate]:
        """Yield orders in which the last phase ends by another of its events."""
        last, after = slots[-1], self.next_cell(slots[0]).step
        for step in self.steps:
            if step != last.step and self.alike(step, last.step) and self.allows(step, after):
                ended = replace(last, step=step)
                yield Candidate((*slots[:-1], ended), self.half, angle)

    def _joined(self, slots: list[Slot], angle: float) -> Iterator[Candidate]:
        """Yield an order in which the last and the first phase become one, if they are alike.

        If no other phase is left, the motion never ends.  A rest for ever is not followed, nor
        a motion with a memory, which any value of that memory satisfies.
        """
        last, first = slots[-1], self.next_cell(slots[0])
        if not self.alike(last.step, first.step):
            yield Candidate(tuple(slots), self.half, angle)
        elif len(slots) > 1:
            joined = Slot(first.step, last.state, last.s + first.s)
            angle += self.cell.omega * slots[0].s
            yield Candidate((*slots[1:-1], joined), self.half, angle)
        elif self.goes_on(last.step):
            whole = replace(last, s=last.s * (2 if self.half else 1))  # it fills the cell
            yield Candidate((whole,), False, angle, endless=True)

    def _between(self, p: int) -> Iterator[Candidate]:
        """Yield orders with one more phase behind phase p."""
        before, after = (*self.slots, self.next_cell(self.slots[0]))[p : p + 2]
        for step in self.steps:
            if self.allows(before.step, step) and self.allows(step, after.step):
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
        ended = self.ended_by(step, demand)
        if ended is None:
            return
        if self.machine.node(ended).changes_velocity and self.allows(ended, step):
            yield ended, []
        for between in self.steps:
            if self.allows(ended, between) and self.allows(between, step):
                yield ended, [Slot(between, state, 0.0)]

    def _cut(self, new: list[Slot], rest: Slot, angle: float) -> Iterator[Candidate]:
        """Yield orders for a motion that never ended, cut where it touches a surface."""
        grows = (0,) if new else ()
        for step in self.steps if self.symmetric(q.step for q in (*new, rest)) else ():
            other = image(self.machine.cell, new[0].step if new else step)
            if self.alike(step, rest.step) and other is not None and self.allows(step, other):
                half = Slot(step, rest.state, rest.s / 2)
                yield Candidate((*new, half), True, angle, grows)
        yield Candidate((*new, rest), False, angle, grows)
