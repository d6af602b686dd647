"""The periodic motion that a simulation comes to, as times from which Newton's method starts.

What Newton's method misses from rough times, a long simulation may find: the order of the
phases, their durations and the phase of the forcing.  It comes to stable orbits only.  It goes
on while the damping lets transients last, up to a number of phases.  Where it settles on an
order of phases that the scene does not declare, that is said in words.

A motion has settled if its last phases are two successive repeats of those before, to what is
left of a transient that is `NEAR`.  That it has no more switches is said if it is shown.
"""

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache

from ..flow import flow
from ..kernels.start import RoughTimes
from ..scenes.bodies.cell import BodyCell
from ..scenes.case import Case
from ..scenes.cell import Cell
from ..scenes.orders import Order, OrderedScene, Step, half_if_mirrored
from .bodies import regime
from .machine import Machine
from .machines import machine_of
from .record import Segment, Simulation
from .simulate import cycle
from .steps.state import AnyState
from .walk import Place, effort, walk

#: Cycles that are simulated at first, and by which factor more each time that was too short;
#: and how many a settled motion may take to repeat.
CYCLES, LONGER, MOST = 100, 1.5, 8

#: A transient is followed for so many of the times in which it decays by a factor e.
DECAYS = 10

#: Phases that are simulated from all starts, at most; long ones count as several: some 3 s.
PHASES = 4000

#: As many, where a simulation only says what there is instead of an orbit.
FEW = 500

#: Phases of the forcing from which motions start at rest, where those from 0 come to nothing:
#: all around, each far from those before.
ANGLES = tuple(2.4 * j % (2 * math.pi) for j in range(1, 6))

#: How far from its limit a settled motion may be, in units of time and length, and as a part of
#: its size; and what is rounding there.
NEAR, ROUNDING = 1e-3, 1e-10

#: By how much the last phases of a motion that has not settled may differ, that Newton's method
#: is to start from them.
ROUGH = 0.03

#: What is rounding of a duration, in units of time: of two events that meet, its square root.
NO_TIME = 1e-7

#: What is said of a motion that nothing changes any more.
WITHOUT_SWITCHES = "a simulation comes to a motion without switches"


@dataclass(frozen=True)
class Settled:
    """What a simulation came to, in words; with times of a cell of the declared order, if any.

    `other` is another order on which it settled; `conclusive` whether it came to anything: a
    periodic motion, or one without switches.
    """

    times: RoughTimes | None
    words: str
    other: "Other | None" = None
    conclusive: bool = True


@dataclass(frozen=True)
class Other:
    """An order of phases that is not the declared one, with times of a cell.

    Its motion takes so many `cycles` of the forcing.
    """

    order: Order
    times: RoughTimes
    cycles: int


def rough_times_by_simulation(case: Case, phases: int = PHASES) -> Iterator[Settled]:
    """Yield what simulations of a case come to, from rest and from each constraint.

    At most so many phases are simulated; see `PHASES`.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> found = next(rough_times_by_simulation(registry.load("impact")()))
    >>> f"{found.times.angle:.6f}", found.words
    ('0.929644', 'a simulation settles on flight')
    """
    base = case.of_fullest() if isinstance(case.scene, OrderedScene) else case
    machine = machine_of(base.cell)
    for settled in _followed_from(base, machine, machine.starts(0.0), phases):
        yield settled if base is case else _in_that(case, settled)


def _in_that(case: Case, settled: Settled) -> Settled:
    """Return what a simulation came to, as it is seen from an order that is not declared."""
    assert isinstance(case.scene, OrderedScene)
    other, base = settled.other, case.scene.base
    declared = Order(tuple(Step(p) for p in range(len(base.phases))), base.half_period)
    if case.scene.order == declared:
        return replace(settled, other=None)
    same = other is not None and (other.order, other.cycles) == (case.scene.order, case.cycles)
    return replace(settled, times=other.times if other and same else None, other=None)


def from_several_states(case: Case, phases: int = PHASES) -> Iterator[Settled]:
    """Yield what simulations of a case come to: see `rough_times_by_simulation`.

    Where they all end, or come to nothing, those from rest at other phases of the forcing
    follow.
    """
    nothing = True
    for settled in rough_times_by_simulation(case, phases):
        nothing = nothing and not settled.conclusive
        yield settled
    if nothing and case.cell.forced:
        machine = machine_of(case.cell)
        starts = [machine.at_rest(angle) for angle in ANGLES]
        yield from _followed_from(case, machine, starts, FEW * len(ANGLES))


def _followed_from(
    case: Case, machine: Machine, starts: Iterable[AnyState | None], phases: int
) -> Iterator[Settled]:
    """Yield what simulations come to from each of several states that a phase takes."""
    possible = [q for q in dict.fromkeys(starts) if q is not None and machine.first(q)]
    for start in possible:
        yield _followed(case, start, phases // len(possible))


@lru_cache(maxsize=16)
def _followed(case: Case, start: AnyState, most: int) -> Settled:
    """Return what the simulation from one state comes to; every method asks for the same."""
    machine, cell = machine_of(case.cell), case.cell
    place, cycles, spent = Place.first(machine, start), float(CYCLES), 0.0
    segments: list[Segment] = []
    while True:
        # the phase that was cut off is followed anew, to its end
        more, place, ended = walk(case, machine, place, cycles * cycle(cell), most - spent)
        segments = segments[:-1] + more
        motion = Simulation(case, tuple(segments), ended)
        windows = (machine.window(machine.number(Step(q.index, q.mirrored))) for q in more)
        spent += sum(effort(window, q.s) for window, q in zip(windows, more, strict=True))
        found = _came_to(cell, motion)
        if found or cycles >= _lasting(cell) or spent > most - 1:
            return found or _unsettled(cell, motion)
        cycles = min(LONGER * cycles, _lasting(cell))


def _lasting(cell: Cell) -> float:
    """Return for how many cycles transients may last by the damping; `CYCLES` at least."""
    return max(CYCLES, DECAYS / (slowest_decay(cell) * cycle(cell)))


def slowest_decay(cell: Cell) -> float:
    """Return the least rate at which a transient of a damped phase decays; infinite if none."""
    if isinstance(cell, BodyCell):
        return regime.slowest_decay(cell)
    damped = [phase for phase in cell.phases if not phase.held and phase.c > 0]
    rates = [-root.real for phase in damped for root in flow.roots(phase)]
    return min((rate for rate in rates if rate > 0), default=math.inf)


def settled(cell: Cell, motion: Simulation) -> Settled:
    """Return what a motion of a cell came to, by its last phases."""
    return _came_to(cell, motion) or _unsettled(cell, motion)


def _unsettled(cell: Cell, motion: Simulation) -> Settled:
    """Return that a motion has not settled; with its last phases, where they almost repeat."""
    last = motion.segments[-1]
    cycles = round((last.t + last.s) / cycle(cell))
    words = f"a simulation of {cycles} cycles does not settle"
    repeated = None if motion.ended else _repeated(cell, motion.segments, ROUGH)
    if repeated is None:
        return Settled(None, words, conclusive=False)
    return replace(_settled_on(cell, repeated), words=words, conclusive=False)


def _came_to(cell: Cell, motion: Simulation) -> Settled | None:
    """Return what a motion came to; None if it has not settled yet."""
    if motion.ended:
        return Settled(None, f"a simulation ends: {motion.ended}", conclusive=False)
    last = motion.segments[-1]
    if last.lasts(cell.omega):
        return Settled(None, WITHOUT_SWITCHES)
    repeated = _repeated(cell, motion.segments)
    return None if repeated is None else _settled_on(cell, repeated)


def _settled_on(cell: Cell, repeated: tuple[Segment, ...]) -> Settled:
    """Return on what a motion settles that repeats some phases."""
    whole = _whole(machine_of(cell), repeated)
    if not whole:
        return Settled(None, WITHOUT_SWITCHES)
    return _declared(cell, whole) or _other(cell, whole)


def _whole(machine: Machine, repeated: tuple[Segment, ...]) -> tuple[Segment, ...]:
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
    same = node.equation == machine.node(Step(two.index, two.mirrored)).equation
    return same and not node.changes_velocity


def _repeated(
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
        whole = abs(turns - round(turns)) <= max(NEAR, rough)
        if cell.forced and not (round(turns) and whole):
            continue
        near = rough or NEAR * -math.expm1(-slowest_decay(cell) * passed)
        size = min(1.0, max(max(map(abs, q.state)) for q in again))
        pairs = zip(done[-2 * length :], done[-3 * length : -length], strict=True)
        if all(_same(one, two, near, size) for one, two in pairs) and (
            (cut.index, cut.mirrored) == (again[0].index, again[0].mirrored)
            and cut.s <= again[0].s + NEAR
        ):
            return again
    return None


def _same(one: Segment, two: Segment, near: float, size: float) -> bool:
    """Whether two phases are the same, in times and states."""
    off = max(abs(a - b) for a, b in zip(one.state, two.state, strict=True))
    return (
        (one.index, one.mirrored) == (two.index, two.mirrored)
        and abs(one.s - two.s) <= max(near, NO_TIME)
        and off <= max(near * size, ROUNDING)
    )


def _alike(one: float, two: float) -> bool:
    """Whether two durations are the same as far as a motion has settled."""
    return abs(one - two) <= NEAR * max(one, two, 1.0)


def _declared(cell: Cell, repeated: tuple[Segment, ...]) -> Settled | None:
    """Return the times of a cell of the declared order, if the phases that repeat are one."""
    count, one = len(cell.phases), repeated
    for _ in repeated:
        own = one[:count]
        declared = [q.step or Step(q.index, q.mirrored) for q in own] == [
            *map(Step, range(count))
        ]
        whole = not cell.forced or abs(sum(q.s for q in own) - cell.duration) <= NEAR
        if len(one) == count * cell.cells and declared and whole:
            words = f"a simulation settles on {', '.join(q.phase.name for q in own)}"
            return Settled(RoughTimes(tuple(q.s for q in own), own[0].angle, words), words)
        one = (*one[1:], one[0])
    return None


def _other(cell: Cell, repeated: tuple[Segment, ...]) -> Settled:
    """Return on which other order of phases a motion settles, and that in words."""
    steps = tuple(q.step or Step(q.index, q.mirrored) for q in repeated)
    count = round(sum(q.s for q in repeated) / cycle(cell))
    other = _in_order(cell, repeated, count if cell.forced else 1)
    if other is not None:  # named from where it begins, so that it can be asked for
        own, turned = other.order.steps, (steps[i:] + steps[:i] for i in range(len(steps)))
        steps = next(each for each in turned if each[: len(own)] == own)
    names = ", ".join("-" * q.mirrored + cell.phases[q.phase].name for q in steps)
    every = "each period" if count == 1 else f"every {count} periods"
    within = f", in {every} of the forcing" if cell.forced else ""
    words = f"a simulation settles on another order of phases: {names}{within}"
    return Settled(None, words, other)


def _in_order(cell: Cell, repeated: tuple[Segment, ...], cycles: int) -> Other | None:
    """Return the phases that repeat as an order, and the times of its cell.

    It begins with the first of them that the scene has, as it is and not mirrored if it can.
    """
    steps = tuple(q.step for q in repeated if q.step is not None)
    set_by = {memory.phase for memory in cell.memory}
    if len(steps) < len(repeated) or not set_by <= {step.phase for step in steps}:
        return None
    turned = [steps[i:] + steps[:i] for i in range(len(steps))]
    turns = [i for i, each in enumerate(turned) if each == min(turned)]
    i = max(turns, key=lambda turn: repeated[turn].s)  # of several, by the longest phase
    order, own = Order(steps[i:] + steps[:i]), repeated[i:] + repeated[:i]
    half = len(own) // 2  # of a motion that is its own mirror image, and not only its order
    if all(_alike(one.s, two.s) for one, two in zip(own[:half], own[half:], strict=False)):
        order = half_if_mirrored(cell, order)
    own = own[: len(order.steps)]
    times = RoughTimes(tuple(q.s for q in own), own[0].angle, "the times of a simulation")
    return Other(order, times, cycles)
