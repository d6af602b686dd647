"""Motion of a case from a given state, from event to event by the exact flow of each phase."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np

from ..scenes.case import Case
from ..scenes.cell import Cell, Form, Phase
from ..scenes.orders import Step
from ..scenes.parameter_error import is_number
from .bounds import local, window
from .chatter import accumulates, end_of, time_left
from .clock import Clock
from .locate import Reached, first_event
from .machine import Machine, State
from .nodes import Node
from .record import Segment, Simulation

#: Cycles that are simulated where neither cycles nor a time is given.
CYCLES = 20

#: How far from a limit a mass that is pressed against it is put, in units of length.
ASIDE = 0.1

#: Most phases, and most cycles, of one motion.
MOST_PHASES = MOST_CYCLES = 100_000

#: Windows of a search for events that take about as long as what else a phase takes.
STRETCH = 10


def simulate(
    case: Case,
    state: Sequence[float] | None = None,
    cycles: float | None = None,
    *,
    time: float | None = None,
    forcing_phase: float = 0.0,
) -> Simulation:
    """Return the motion of a case from a given state.

    Events are located so that none can be stepped over: see `locate`.  Which phase follows is
    decided by the demands of the scene's phases.

    Parameters
    ----------
    case : Case
        The oscillator.
    state : (float, float), optional
        Displacement in m and velocity in m/s at the start; without it at rest at 0 or, if
        the scene does not admit that, at or next to the nearest limit.
    cycles : float, optional
        How many periods of the forcing or, where nothing forces, how many times 2 pi of the
        scene's unit of time; 20 without it and without `time`.
    time : float, optional
        How long in s, in place of `cycles`.
    forcing_phase : float
        Phase of the forcing at the start, in rad; 0 where nothing forces.

    Returns
    -------
    Simulation
        Its `ended` says why where it ends before its time: chatter, or a state that no phase of
        the scene takes.

    Raises
    ------
    TypeError
        If `case` is not a `Case`.
    ValueError
        If a number is not one that can be simulated, or no phase takes the state at the start.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> motion = simulate(registry.load("impact")(), cycles=3)
    >>> [f"{phase.start:.6f}" for phase in motion.phases]
    ['0.000000', '0.468885', '4.237267', '7.641000']
    """
    if not isinstance(case, Case):
        raise TypeError(f"case: got {case!r:.80}, expected a Case")
    case = case.of_fullest()
    turn = _number("forcing_phase", forcing_phase, "a finite number of rad")
    if turn and case.scene.frequency is None:
        expected = f"0: nothing forces {case.scene.name}"
        raise ValueError(f"forcing_phase: got {forcing_phase!r}, expected {expected}")
    duration = _duration(case, cycles, time)
    machine = Machine.of(case.cell)
    if state is None:
        start = at_rest(machine, turn)
        if start is None:
            raise ValueError("state: no displacement at rest is admitted, expected one")
    else:
        start = machine.remembered(_given(case, state, turn))
    if machine.first(start) is None:
        raise ValueError(
            f"state: got {tuple(state or ())!r}, expected one that a phase of "
            f"{case.scene.name} takes; {machine.unmet(start)}"
        )
    return follow(case, machine, start, duration)


@dataclass(frozen=True)
class Place:
    """Where a phase of a motion begins: the phase, the state, and when, without units."""

    node: Node
    state: State
    clock: Clock

    @classmethod
    def first(cls, machine: Machine, state: State) -> "Place":
        """Return where the motion from a state begins that a phase takes."""
        node = machine.first(state)
        assert node is not None
        return cls(node, state, Clock.of(state.angle, machine.cell.omega))


def follow(case: Case, machine: Machine, start: State, duration: float) -> Simulation:
    """Return the motion of a case from a state that a phase takes, all without units."""
    segments, _, ended = walk(case, machine, Place.first(machine, start), duration)
    return Simulation(case, tuple(segments), ended)


def effort(phase: Phase, omega: float, s: float) -> float:
    """Return what it takes to follow a phase for a time: 1, and more for a long one."""
    return 1 + s / (STRETCH * window(phase, omega))


def walk(
    case: Case, machine: Machine, place: Place, until: float, most: float = math.inf
) -> tuple[list[Segment], Place, str]:
    """Return the phases of a motion from the beginning of one on, the last one cut off.

    Parameters
    ----------
    case : Case
    machine : Machine
        Of its cell.
    place : Place
        Where to begin.
    until : float
        The time at which it ends, without units.
    most : float
        The `effort` after which it ends earlier.

    Returns
    -------
    segments : list of Segment
    place : Place
        Where the last of them begins, to go on from.
    ended : str
        Why the motion ends before, where it does.
    """
    omega, whole = case.cell.omega, Fraction(until)
    node, state, clock = place.node, place.state, place.clock
    segments: list[Segment] = []
    while True:
        state = node.begun(state)
        place, phase = Place(node, state, clock), node.at(state)
        end, on = _end(
            machine, node, state, min(float(whole - clock.t), _reach(phase, omega, most))
        )
        ending = None if on is None else machine.ending(node, on[0])
        step = None if ending is None else ending.step
        segments.append(_segment(node, state, clock, end.s, step))
        most -= effort(phase, omega, end.s)
        if on is None or most < 1:
            return segments, place, end.ended
        clock = clock.later(end.s)
        before = State(end.x, end.v, clock.angle, memory=state.memory)
        surface, state = on[0], machine.crossed(node, *on, before)
        after = machine.next(node, surface, before, state)
        if after is None:
            when = f"at t = {float(clock.t) * case.units.time:.6g} s"
            words = (
                f"no phase of the scene takes the state {when}, where {node.phase.name} ends; "
                f"{machine.unmet(state)}"
            )
            return segments, place, words
        left = _time_left(machine, node, surface, after, state)
        still = replace(state, v=0.0, angle=clock.later(left).angle)
        rest = machine.rest(node, surface, still) if left else None
        if rest is not None:  # its last flight stands for all that are left
            left = min(left, float(whole - clock.t))
            segments.append(_segment(after, state, clock, left))
            clock, after, state = clock.later(left), rest, still
        elif accumulates(segments) and (left or not machine.has_rest(surface)):
            return segments, place, f"chatter: {_chatter(case, segments)}"
        if len(segments) >= MOST_PHASES:
            words = f"{MOST_PHASES} phases are the most that one motion may have"
            return segments, place, words
        node, state = after, machine.entered(after, state)


def _reach(phase: Phase, omega: float, most: float) -> float:
    """Return for how long a phase is followed by an effort."""
    return max(most - 1, 0.0) * STRETCH * window(phase, omega) if most < math.inf else most


def _end(
    machine: Machine, node: Node, state: State, most: float
) -> tuple[Reached, tuple[int, Form] | None]:
    """Return where a phase ends, and the surface and the form that end it."""
    watched = machine.watched(node, state)
    end = first_event(
        node.at(state), np.array([state.x, state.v]), machine.cell.omega, state.angle,
        [form for _, form in watched], most,
        [i for i, (surface, _) in enumerate(watched) if surface == state.surface],
        state.placed,
    )  # fmt: skip
    return end, None if end.form is None else watched[end.form]


def _segment(
    node: Node, state: State, clock: Clock, s: float, step: Step | None = None
) -> Segment:
    place = (node.index, node.mirrored, clock.t, state.angle)
    return Segment(node.at(state), *place, state.x, state.v, s, step)


def _time_left(machine: Machine, node: Node, surface: int, after: Node, state: State) -> float:
    """Return how long jumps go on behind that which ends a phase; 0 if not known."""
    phase, (rho, d) = after.at(state), machine.law(node, surface)
    if phase.held or d:
        return 0.0
    at = local(phase, state.x, state.v, machine.cell.omega, state.angle, state.placed)
    return time_left(at, rho)


def _chatter(case: Case, segments: list[Segment]) -> str:
    """Return in words where the switches accumulate."""
    when = f"t = {end_of(segments) * case.units.time:.9g} s"
    return (
        f"{segments[-1].phase.name} ends ever sooner, the switches accumulate at {when}, "
        "and the scene does not say what follows"
    )


def at_rest(machine: Machine, angle: float) -> State | None:
    """Return the admissible state at rest that is nearest to 0."""
    cosine = math.cos(angle)
    places = [0.0]
    for node in machine.nodes:
        for x, _, cos, constant, *_ in (form for _, form in node.phase.demands):
            if x:
                limit = -(constant + cos * cosine) / x
                places += [limit, limit - ASIDE, limit + ASIDE]
    speeds = [0.0, *(q.phase.speed for q in machine.nodes if q.phase.held)]
    for speed in speeds:
        for place in sorted(places, key=abs):
            state = machine.remembered(State(place, speed, angle))
            if machine.first(state) is not None:
                return state
    return None


def _given(case: Case, state: Sequence[float], angle: float) -> State:
    try:
        x, v = state
    except (TypeError, ValueError):
        raise ValueError(
            f"state: got {state!r:.80}, expected displacement and velocity"
        ) from None
    place = _number("state", x, "a finite displacement in m")
    speed = _number("state", v, "a finite velocity in m/s")
    units = case.units
    found = State(place / units.length, speed / units.of_motion(1), angle)
    if not (math.isfinite(found.x) and math.isfinite(found.v)):
        expected = (
            f"numbers within float64 in units of {units.length:.3g} m, {units.time:.3g} s"
        )
        raise ValueError(f"state: got {(place, speed)!r}, expected {expected}")
    return found


def _duration(case: Case, cycles: float | None, time: float | None) -> float:
    """Return how long a motion is to be, without units."""
    if cycles is not None and time is not None:
        raise ValueError(f"time: got {time!r} beside cycles, expected one of them")
    if time is not None:
        found = _number("time", time, "a positive number of s") / case.units.time
        name, value = "time", time
    else:
        wanted = CYCLES if cycles is None else cycles
        found = _number("cycles", wanted, "a positive number") * cycle(case.cell)
        name, value = "cycles", wanted
    if not found > 0:
        raise ValueError(f"{name}: got {value!r}, expected a positive number")
    if found > MOST_CYCLES * cycle(case.cell):
        seconds = MOST_CYCLES * cycle(case.cell) * case.units.time
        expected = f"at most {MOST_CYCLES} cycles, which are {seconds:.6g} s"
        raise ValueError(f"{name}: got {value!r}, expected {expected}")
    return found


def cycle(cell: Cell) -> float:
    """Return the duration that is called a cycle, without units: a period of the forcing."""
    return 2 * math.pi / (cell.omega or 1.0)


def _number(name: str, value: object, expected: str) -> float:
    if not is_number(value):
        raise ValueError(f"{name}: got {value!r:.80}, expected {expected}")
    return float(value)  # type: ignore[arg-type]
