"""Which order of phases a branch has beyond a place where its own ends.

A phase is put in with no duration, or taken out.  What is tried is what may follow by the rules
of a simulation; what counts is an orbit a little further on that is admissible.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from ..arrays import Vector
from ..scenes.loaded import UnknownScene
from ..scenes.orders import Order, Step, image
from ..scenes.parameter_error import ParameterError
from ..simulation.followers import may_follow
from .course import ROUNDING, Course, Row
from .locate import Found
from .meeting import halves_apart
from .piece import NoStepError, Piece, Place
from .watch import END, LEAST, START, WITHIN

#: Durations of a phase that is put in, in turn, as parts of a cell; steps of the parameter.
#: Near chatter a fold is as close as the last.
AHEAD = (1e-3, 1e-2, 1e-4, 1e-5)

#: Steps beside a flip, in turn.
ASIDE = (1e-4, 1e-2, 1e-3)


@dataclass(frozen=True)
class Slot:
    """A phase of an orbit.

    Parameters
    ----------
    step : Step
        Which.
    state : tuple of float
        In which it begins.
    s : float
        Its duration.
    """

    step: Step
    state: tuple[float, ...]
    s: float


@dataclass(frozen=True)
class Candidate:
    """An order of phases that an orbit at an event has as well.

    Parameters
    ----------
    slots : tuple of Slot
    half : bool
        Whether they are half a period.
    angle : float
        Of the forcing where the first begins.
    grows : int or None
        The phase that has no duration there; None if no phase was put in.
    endless : bool
        Whether it is one phase that nothing ends.
    """

    slots: tuple[Slot, ...]
    half: bool
    angle: float
    grows: int | None = None
    endless: bool = False


def beyond(found: Found) -> tuple[Piece, Place] | None:
    """Return an orbit beyond a place where the order of the phases changes; None without one.

    Parameters
    ----------
    found : Found
        What happens at that place.
    """
    at = _At(found)
    for candidate in map(at.as_declared, at.candidates()):
        for ahead in AHEAD:
            try:
                return _led(found, candidate, ahead)
            except (NoStepError, ParameterError, UnknownScene, ArithmeticError):
                continue
    return None


def doubled(found: Found) -> tuple[Piece, Place] | None:
    """Return an orbit of twice the period beside a flip; of half a period, without symmetry.

    It is looked for along what the equations of the longer orbit leave free there, but for
    the branch of the shorter one: where its halves differ.  None without one.
    """
    at, old = _At(found), found.piece
    if at.cell.memory or at.course.endless:
        return None
    slots = (*at.slots, *map(at.next_cell, at.slots))
    order = Order(tuple(slot.step for slot in slots))
    cycles = old.course.cycles * (1 if at.half else 2)
    course = replace(old.course, order=order, cycles=cycles)
    z = _unknowns(found, course, Candidate(slots, False, at.angle))
    here = np.append(z, old.number(found.place.y))
    bare = Piece.at(course, old.case, old.index, old.bounds, here, ())
    y, J = bare.of_number(here), np.empty((len(z), len(z) + 1))
    bare.functions["rates"](bare.along, y[:-1], y[-1], J)
    J /= bare.along.weights
    free = np.linalg.svd(J / np.abs(J).max(axis=1, keepdims=True))[2][-2:]
    apart = [halves_apart(bare, each) for each in free]
    border = np.linalg.svd(np.array(apart).T)[2][0] @ free
    for ahead in ASIDE:
        try:
            led = bare.led(y + ahead * border / bare.along.weights, border)
            return _admitted(bare, led, border)
        except (NoStepError, ParameterError, ArithmeticError):
            continue
    return None


def _led(found: Found, candidate: Candidate, ahead: float) -> tuple[Piece, Place]:
    """Return an orbit of another order a little beyond an event.

    Raises
    ------
    NoStepError
        If there is none.
    """
    old = found.piece
    order = Order(tuple(slot.step for slot in candidate.slots), candidate.half)
    course = replace(old.course, order=order, endless=candidate.endless)
    z = _unknowns(found, course, candidate)
    count, forced = len(candidate.slots), old.cell.forced
    at_s = len(z) - count - forced
    border = np.append(np.zeros(len(z)), 1.0)
    if candidate.grows is not None:
        border = np.zeros(len(z) + 1)
        border[at_s + candidate.grows] = 1.0
        z[at_s + candidate.grows] = ahead * z[at_s : at_s + count].sum()
    at = np.append(z, old.number(found.place.y))
    bare = Piece.at(course, old.case, old.index, old.bounds, at, ())
    y = bare.led(bare.of_number(at), border)
    if candidate.grows is not None:
        return _admitted(bare, y, border)
    for side in (ahead, -ahead):
        try:
            return _admitted(bare, bare.led(y + side * border, border), side * border)
        except NoStepError:
            continue
    raise NoStepError


def _admitted(bare: Piece, y: Vector, border: Vector) -> tuple[Piece, Place]:
    """Return an orbit with what is watched there.

    Raises
    ------
    NoStepError
        If it is not admissible.
    """
    own = np.append(y[:-1], bare.number(y))
    piece = Piece.at(bare.course, bare.case, bare.index, bare.bounds, own)
    place = piece.place(piece.of_number(own), border)
    if not piece.admits(place):
        raise NoStepError
    return piece, place


def _unknowns(found: Found, course: Course, candidate: Candidate) -> Vector:
    """Return the unknowns of an order at an event, in the units of its piece."""
    numbers, durations = found.piece.numbers(found.place.y), [q.s for q in candidate.slots]
    states = [slot.state for slot in candidate.slots]
    return course.gathered(numbers, states, np.array(durations), candidate.angle)


class _At:
    """An orbit at an event, and the orders of phases that it may have as well."""

    def __init__(self, found: Found) -> None:
        piece, y = found.piece, found.place.y
        numbers = piece.numbers(y)
        self.found, self.course = found, piece.course
        self.cell = piece.course.cell(numbers)
        self.machine = piece.course.machine(numbers)
        durations, states = piece.durations(y), piece.course.states(piece.equations(y), y)
        self.angle = float(y[-2]) if self.cell.forced else 0.0
        self.half = piece.course.order.half_period
        self.slots = [
            Slot(step, states[p], float(durations[p]))
            for p, step in enumerate(piece.course.order.steps)
        ]

    @property
    def row(self) -> Row:
        """The form that vanishes."""
        return self.found.piece.rows[self.found.row]

    def _when(self) -> float:
        """Return when in its phase the form does."""
        piece, y = self.found.piece, self.found.place.y
        own = piece.equations(y), piece.table, y[:-1], self.found.row
        return float(piece.functions["when_least"](*own))

    def candidates(self) -> Iterator[Candidate]:
        """Yield orders of phases, those of fewer phases first."""
        p, column = self.found.phase, self.found.column
        assert p is not None
        if column is None:
            yield from self._without(p)
            return
        within = self.row.kind == WITHIN
        if within and column == LEAST:
            yield from self._touched(p)
        elif within and column == START:
            yield from self._between((p - 1) % len(self.slots))
        elif within and column == END:
            yield from self._uncrossed(p)
        else:
            yield from self._between(p)

    def as_declared(self, found: Candidate) -> Candidate:
        """Return a candidate that begins where the scene's own order does, if it is one.

        Else with a phase that is not mirrored, if it has one.
        """
        turns = [found]
        for _ in range(0 if found.endless else len(found.slots) * (2 if found.half else 1) - 1):
            turns.append(self._turned(turns[-1]))
        plain = (each for each in turns if not each.slots[0].step.mirrored)
        declared = (each for each in turns if self._course(each).declared is not None)
        return next(declared, next(plain, found))

    def _turned(self, found: Candidate) -> Candidate:
        """Return a candidate that begins with its second phase."""
        first, *rest = found.slots
        last = self.next_cell(first, found.half)
        count, grows = len(found.slots), found.grows
        angle = found.angle + self.cell.omega * first.s
        grows = None if grows is None else (grows - 1) % count
        return Candidate((*rest, last), found.half, angle, grows)

    def _course(self, found: Candidate) -> Course:
        order = Order(tuple(slot.step for slot in found.slots), found.half)
        return replace(self.course, order=order, endless=found.endless)

    def _without(self, p: int) -> Iterator[Candidate]:
        """Yield the order without a phase, its neighbours as one if they are the same."""
        if len(self.slots) > 1:
            slots, angle = self._from(p)
            if self._leaps(p):
                yield Candidate(tuple(slots[1:]), self.half, angle)
            else:
                yield from self._joined(slots[1:], angle)

    def _leaps(self, p: int) -> bool:
        """Whether the velocity jumps where a phase begins."""
        piece, y, last = self.found.piece, self.found.place.y, self.slots[p - 1]
        begun = self.angle + self.cell.omega * sum(each.s for each in self.slots[: p - 1])
        case, z, q = piece.equations(y), y[:-1], (p - 1) % len(self.slots)
        before = self.course.moving_at(case, z, q, begun, last.s)[1]
        before *= self.cell.sign if p == 0 else 1
        after = self.course.moving_at(case, z, p, begun + self.cell.omega * last.s, 0.0)[1]
        return abs(after - before) > ROUNDING * max(abs(before), 1.0)

    def _uncrossed(self, p: int) -> Iterator[Candidate]:
        """Yield the order in which a phase goes on where it ended."""
        slots, angle = self._from((p + 1) % len(self.slots))
        if self._alike(slots[-1].step, self.next_cell(slots[0]).step):
            yield from self._joined(slots, angle)

    def _from(self, p: int) -> tuple[list[Slot], float]:
        """Return the phases from one on, and the angle where it begins."""
        before = [self.next_cell(slot) for slot in self.slots[:p]]
        turned = self.angle + self.cell.omega * sum(slot.s for slot in self.slots[:p])
        return [*self.slots[p:], *before], turned

    def next_cell(self, slot: Slot, half: bool | None = None) -> Slot:
        """Return a phase of the next cell as this one has it, which may be half a period."""
        if not (self.half if half is None else half):
            return slot
        other = image(self.machine.cell, slot.step)
        assert other is not None
        return replace(slot, step=other, state=tuple(-q for q in slot.state))

    def _next(self, slots: list[Slot], p: int) -> Step:
        """Return the phase behind one of a cell."""
        return slots[p + 1].step if p + 1 < len(slots) else self.next_cell(slots[0]).step

    def _joined(self, slots: list[Slot], angle: float) -> Iterator[Candidate]:
        """Yield phases whose last and first meet where nothing may change.

        What would rest for ever is no motion to follow, and of what nothing sets a memory anew
        there is one for each value of that.
        """
        last, first = slots[-1], self.next_cell(slots[0])
        if not self._alike(last.step, first.step):
            yield Candidate(tuple(slots), self.half, angle)
        elif len(slots) > 1:
            joined = Slot(first.step, last.state, last.s + first.s)
            yield Candidate(
                (*slots[1:-1], joined), self.half, angle + self.cell.omega * slots[0].s
            )
        elif self._goes_on(last.step):
            whole = Slot(last.step, slots[0].state, last.s * (2 if self.half else 1))
            yield Candidate((whole,), False, angle, endless=True)

    def _goes_on(self, step: Step) -> bool:
        """Whether a phase that nothing ends is one motion."""
        held = self.course.base.kinds[step.phase][1]
        return self.cell.forced and not held and not self.cell.memory

    def _alike(self, one: Step, other: Step) -> bool:
        """Whether two phases have the same equation."""
        return self.machine.node(one).equation == self.machine.node(other).equation

    def _between(self, p: int) -> Iterator[Candidate]:
        """Yield orders with one phase more behind another."""
        q = self._next(self.slots, p)
        slot = self.slots[p]
        after = self.slots[p + 1] if p + 1 < len(self.slots) else self.next_cell(self.slots[0])
        for step in self._steps():
            if self._may(slot.step, step) and self._may(step, q):
                new = Slot(step, after.state, 0.0)
                slots = (*self.slots[: p + 1], new, *self.slots[p + 1 :])
                yield Candidate(slots, self.half, self.angle, p + 1)

    def _touched(self, p: int) -> Iterator[Candidate]:
        """Yield orders in which a phase ends where a surface is touched inside it."""
        slot, when = self.slots[p], self._when()
        begun = self.angle + self.cell.omega * sum(each.s for each in self.slots[:p])
        piece, y = self.found.piece, self.found.place.y
        state = self.course.state(piece.equations(y), y[:-1], p, begun, when)
        angle = begun + self.cell.omega * when
        ended = self._ended_by(p)
        if ended is None:
            return
        for step in (None, *self._steps()):
            if step is None:
                follows = self._jumps(ended) and self._may(ended, slot.step)
            else:
                follows = self._may(ended, step) and self._may(step, slot.step)
            if not follows:
                continue
            new = [] if step is None else [Slot(step, state, 0.0)]
            if self.course.endless:
                yield from self._cut(new, Slot(ended, state, slot.s), angle)
                continue
            first = replace(slot, step=ended, s=when)
            last = Slot(slot.step, state, slot.s - when)
            slots = (*self.slots[:p], first, *new, last, *self.slots[p + 1 :])
            yield Candidate(slots, self.half, self.angle, p + 1 if new else None)

    def _cut(self, new: list[Slot], rest: Slot, angle: float) -> Iterator[Candidate]:
        """Yield what an endless motion is with a phase where it touches a surface."""
        grows = 0 if new else None
        for step in self._steps():
            other = image(self.machine.cell, new[0].step if new else step)
            if self._alike(step, rest.step) and other is not None and self._may(step, other):
                half = Slot(step, rest.state, rest.s / 2)
                yield Candidate((*new, half), True, angle, grows)
        yield Candidate((*new, rest), False, angle, grows)

    def _ended_by(self, p: int) -> Step | None:
        """Return the phase of the same equation that ends where one touches a surface."""
        number = self.machine.number(self.course.order.steps[p])
        surface = self.machine.nodes[number].demands[self.row.number]
        return self.machine.ending(number, surface)

    def _jumps(self, step: Step) -> bool:
        return self.machine.node(step).changes_velocity

    def _may(self, one: Step, other: Step) -> bool:
        return may_follow(self.machine, one, other)

    def _steps(self) -> list[Step]:
        """Return all phases that there are."""
        return [node.step for node in self.machine.nodes]
