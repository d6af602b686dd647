"""Motion of a case from a given state, from event to event by the exact flow of each phase."""

import math
from collections.abc import Sequence

from ..scenes.case import Case, check_case
from ..scenes.cell import Cell
from ..scenes.ordered import of_all_phases
from ..scenes.parameter_error import is_number, repeated
from .machines import machine_of
from .record import Simulation
from .steps.state import AnyState
from .walk import follow

#: Cycles that are simulated where neither cycles nor a time is given.
CYCLES = 20

#: Most cycles of one motion.
MOST_CYCLES = 100_000


def simulate(
    case: Case,
    state: Sequence[float] | None = None,
    cycles: float | None = None,
    *,
    time: float | None = None,
    forcing_phase: float = 0.0,
) -> Simulation:
    """Return the motion of an oscillator from a given state, from event to event.

    Each phase is integrated exactly, and no event can be stepped over: see `locate`.  The next
    phase is one whose demands hold just behind the switch.

    Parameters
    ----------
    case : Case
        The oscillator.
    state : (float, float), optional
        Displacement in m and velocity in m/s at the start.  Default: at rest at 0 or, if the
        scene does not admit that, at or next to the nearest limit.  For a body: those of its
        first contact, in the state nearest to rest; default: at rest at 0, or in the
        equilibrium of a phase.
    cycles : float, optional
        Duration in periods of the forcing; without forcing, in multiples of 2 pi of the
        scene's unit of time.  Default 20.
    time : float, optional
        Duration in s, in place of `cycles`.
    forcing_phase : float
        Phase of the forcing at the start, in rad.

    Returns
    -------
    Simulation
        If the motion ends early, `ended` says why: chatter, or a state that no phase of the
        scene admits.

    Raises
    ------
    TypeError
        If `case` is not a `Case`.
    ValueError
        If a number is out of range, or no phase admits the state at the start.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> motion = ns.simulate(ns.scene("impact")(), cycles=3)
    >>> motion
    <impact simulated for 10.472 s: 4 phases>
    >>> [round(phase.start, 6) for phase in motion.phases]
    [0.0, 0.468885, 4.237267, 7.641]
    >>> print(motion.displacement([0, 1, 2]).round(6))
    [ 0.        0.023297 -0.395435]
    """
    check_case(case)
    case = of_all_phases(case)
    turn = _number("forcing_phase", forcing_phase, "a finite number of rad")
    if turn and case.scene.frequency is None:
        expected = f"0: nothing forces {case.scene.name}"
        raise ValueError(f"forcing_phase: got {forcing_phase!r}, expected {expected}")
    duration = _duration(case, cycles, time)
    machine = machine_of(case.cell)
    start: AnyState
    if state is None:
        start = machine.at_rest(turn)
        if start is None:
            raise ValueError(
                "state: got none, expected displacement and velocity: no phase of "
                f"{case.scene.name} takes a state at rest"
            )
    else:
        start = machine.released(*_given(case, state), turn)
    if machine.begin(start) is None:
        raise ValueError(
            f"state: got {tuple(state or ())!r}, expected one that a phase of "
            f"{case.scene.name} takes; {machine.unmet(start)}"
        )
    return follow(case, machine, start, duration)


def _given(case: Case, state: Sequence[float]) -> tuple[float, float]:
    """Return displacement and velocity without units."""
    try:
        x, v = state
    except (TypeError, ValueError):
        raise ValueError(
            f"state: got {state!r:.80}, expected displacement and velocity"
        ) from None
    place = _number("state", x, "a finite displacement in m")
    speed = _number("state", v, "a finite velocity in m/s")
    units = case.units
    numbers = place / units.length, speed / units.of_motion(1)
    if not all(map(math.isfinite, numbers)):
        expected = (
            f"numbers within float64 in units of {units.length:.3g} m, {units.time:.3g} s"
        )
        raise ValueError(f"state: got {(place, speed)!r}, expected {expected}")
    return numbers


def _duration(case: Case, cycles: float | None, time: float | None) -> float:
    """Return the duration asked for, without units."""
    if cycles is not None and time is not None:
        raise ValueError(f"time: got {time!r} beside cycles, expected one of them")
    if time is not None:
        duration = _number("time", time, "a positive number of s") / case.units.time
        name, value = "time", time
    else:
        count = CYCLES if cycles is None else cycles
        duration = _number("cycles", count, "a positive number") * cycle(case.cell)
        name, value = "cycles", count
    if not duration > 0:
        raise ValueError(f"{name}: got {value!r}, expected a positive number")
    if duration > MOST_CYCLES * cycle(case.cell):
        seconds = MOST_CYCLES * cycle(case.cell) * case.units.time
        expected = f"at most {MOST_CYCLES} cycles, which are {seconds:.6g} s"
        raise ValueError(f"{name}: got {value!r}, expected {expected}")
    return duration


def cycle(cell: Cell) -> float:
    """Return the duration of a cycle, without units: a period of the forcing, or 2 pi."""
    return 2 * math.pi / (cell.omega or 1.0)


def _number(name: str, value: object, expected: str) -> float:
    if not is_number(value):
        raise ValueError(f"{name}: got {repeated(value)}, expected {expected}")
    return float(value)  # type: ignore[arg-type]
