"""An orbit at an event, and the rules of what may follow what there."""

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import replace
from itertools import islice

import numpy as np

from ...scenes.orders import Step, image
from ...scenes.parameter_error import ParameterError
from ...simulation.followers import may_follow
from ...simulation.machine import Machine
from ..course import ROUNDING
from ..events.locate import Found
from .candidate import Candidate, Slot

#: How far beside an event its rules and surfaces are looked at, as a part of an interval.
BESIDE = 1e-6


class Reading:
    """An orbit at an event: its phases with their states, begun at any of them."""

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

    def begun_at(self, orbit: Candidate, p: int) -> tuple[list[Slot], float]:
        """Return the phases of a cell of an orbit from phase p on, and the angle there."""
        begun = next(islice(self.rotations(orbit), p, None))
        return list(begun.slots), begun.angle

    def leaps(self, p: int) -> bool:
        """Whether the velocity jumps where phase p begins."""
        last, orbit = (p - 1) % len(self.slots), (self.equations, self.z)
        before = self.course.moving_at(*orbit, last, self.slots[last].s)[1]
        before *= self.cell.sign if p == 0 else 1
        after = self.course.moving_at(*orbit, p, 0.0)[1]
        fastest = float(np.abs(self.event.place.extremes[1]).max())
        return abs(after - before) > ROUNDING * fastest

    def goes_on(self, step: Step) -> bool:
        """Whether a phase that never ends is an isolated motion."""
        held = self.course.base.kinds[step.phase][1]
        return self.cell.forced and not held and not self.cell.memory

    def ended_by(self, step: Step, demand: int) -> Step | None:
        """Return the phase of the same equation that ends where a demand vanishes."""
        surface = self.machine.node(step).demands[demand]
        return self.machine.ending(self.machine.number(step), surface)

    def symmetric(self, steps: Iterable[Step]) -> bool:
        """Whether the mirror image of each phase is a phase of the scene."""
        return all(image(self.machine.cell, step) is not None for step in steps)

    def alike(self, one: Step, other: Step) -> bool:
        """Whether two phases have the same law."""
        return self.machine.node(one).law == self.machine.node(other).law

    def allows(self, one: Step, other: Step) -> bool:
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
