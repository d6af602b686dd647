"""Motions seen once a period of the forcing: along a parameter, and from a grid of starts."""

import math
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import Executor
from itertools import repeat

import numpy as np

from .arrays import Integers, Matrix, Vector
from .results.strobe import Attractor, Basins, Diagram
from .scenes.case import Case, check_case, index_of
from .scenes.ordered import of_all_phases
from .scenes.parameter_error import is_number, several, whole
from .simulation.bodies.machine import BodyMachine
from .simulation.bodies.units import state_of, units_of
from .simulation.machine import Machine
from .simulation.machines import machine_of
from .simulation.repeats import slowest_decay
from .simulation.simulate import cycle
from .simulation.steps.state import AnyState, State

#: Periods that are left to a transient, and that are kept; of a basin, those in all.
TRANSIENT, KEPT, CYCLES = 200, 50, 100

#: How often a motion of a basin is followed again as long, if it has not settled.
FURTHER = 3

#: Most periods of an attractor.
LONGEST = 16

#: Differences of states of one attractor, and of states a period of it apart, as parts of its
#: largest: the second where a transient decays in a period, less where it lasts; and rounding.
ONE, AGAIN, ROUNDING = 1e-3, 1e-6, 1e-10

#: By which factor a difference of states is at least reduced that is left of a transient.
LESS = 0.999

#: Least size of a displacement or a velocity, as a part of the other over a turn by 1 rad.
LEAST = 1e-3

#: Most values, most periods, and most starts.
MOST_VALUES, MOST_CYCLES, MOST_STARTS = 10_000, 100_000, 4_000_000


def diagram(
    case: Case, parameter: str, values: Iterable[float], transient: int = TRANSIENT,
    cycles: int = KEPT, progress: Callable[[float], None] = lambda value: None,
) -> Diagram:  # fmt: skip
    """Return a bifurcation diagram: the states once a period of the forcing, at each value.

    The motion at a value starts from the last state at the value before.  At the first value,
    and where the motion before ended or its last state is in no phase, it starts from rest.  Of
    a body the states are those of its first contact.

    Parameters
    ----------
    case : Case
    parameter : str
        The name of the parameter.
    values : iterable of float
        Its values in SI units, in this order.
    transient, cycles : int
        How many periods of the forcing are dropped first, and how many are kept.
    progress : callable
        Called with each value when it is done.

    Raises
    ------
    TypeError
        If `case` is not a `Case`.
    ParameterError
        If the scene has no such parameter, or a value is out of its bounds.
    ValueError
        If the scene has no forcing, or a number is out of range.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> found = diagram(registry.load("impact")(), "frequency", [1.8, 2.0], 50, 4)
    >>> found.states[0].shape, np.ptp(found.states[0][:, 0]) < 1e-9
    ((4, 2), np.True_)
    """
    _check_forced(case)
    index_of(case, parameter)
    numbers = several("values", values, "numbers")
    cases = [of_all_phases(case.with_value(parameter, value)) for value in numbers]
    whole("values", len(cases), 1, MOST_VALUES)
    whole("transient", transient, 0, MOST_CYCLES)
    whole("cycles", cycles, 1, MOST_CYCLES)
    states: list[Matrix] = []
    last: Vector | None = None
    for each in cases:
        machine = machine_of(each.cell)
        start = _taken(each, machine, last)
        strobed, last = _followed(each, machine, start, transient + cycles)
        states.append(strobed[transient + 1 :])
        progress(each.values[parameter])
    return Diagram(case, parameter, tuple(q.values[parameter] for q in cases), tuple(states))


def basins(
    case: Case, x: Sequence[float], v: Sequence[float], cycles: int = CYCLES,
    executor: Executor | None = None,
    progress: Callable[[float], None] = lambda value: None,
) -> Basins:  # fmt: skip
    """Return the basins of attraction: the attractor that each state of a grid leads to.

    Parameters
    ----------
    case : Case
    x, v : sequence of float
        Displacements in m and velocities in m/s at the start, at phase 0 of the forcing.  Of a
        body they are those of its first contact, in the state nearest to rest.
    cycles : int
        For how many periods of the forcing each motion is followed; one that has not settled
        then is followed again as long, up to three times.
    executor : Executor, optional
        Where the rows of the grid are computed: a pool of `concurrent.futures`, or what has
        its ``map``.  Default: this process.
    progress : callable
        Called with the velocity of each row when it is done.

    Raises
    ------
    TypeError
        If `case` is not a `Case`.
    ValueError
        If the scene has no forcing, or a number is out of range.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> spring = registry.load("clearance")(force=0.3, damping=0.1, gap=1.0, frequency=1.2)
    >>> print(basins(spring, [-3.0, 0.0], [0.0, 3.0], 200))
      starts  attractor
           3  x = 0.0656078 m, x' = 2.66716 m/s, each period
           1  x = -0.634615 m, x' = 0.207692 m/s, each period
    """
    _check_forced(case)
    whole("cycles", cycles, 2 * LONGEST + 1, MOST_CYCLES)
    xs, vs = map(_axis, ("x", "v"), (x, v), _units(of_all_phases(case))[:2])
    whole("starts", len(xs) * len(vs), 1, MOST_STARTS)
    every, mapping = of_all_phases(case), map if executor is None else executor.map
    decay = slowest_decay(every.cell) * cycle(every.cell)
    speed = every.units.of_motion(1) / every.units.length * every.cell.omega
    settling = float(decay), float(speed)
    rows = mapping(_tails, repeat(every), repeat(xs), vs, repeat(cycles), repeat(settling))
    tails = []
    for value, row in zip(vs, rows, strict=True):
        tails.append(row)
        progress(float(value))
    attractors, index = _classified(np.array(tails), *settling)
    return Basins(case, xs, vs, attractors, index)


def _tails(
    case: Case, xs: Vector, v: float, cycles: int, settling: tuple[float, float]
) -> Matrix:
    """Return the last states of the motions from a row of a grid, in SI units.

    Not a number where no phase takes the start, or the motion ends.  `settling` has the last
    arguments of `_repeated`.
    """
    machine, units, count = machine_of(case.cell), _units(case)[:2], 2 * LONGEST + 1
    tails = np.full((len(xs), count, 2), np.nan)
    for i, x in enumerate(xs):
        start: AnyState = machine.released(float(x / units[0]), float(v / units[1]), 0.0)
        for _ in range(1 + FURTHER if machine.begin(start) is not None else 0):
            states, last = _followed(case, machine, start, cycles)
            if last is None:
                break
            tails[i] = states[-count:, :2]
            if _repeated(tails[i], *settling)[0] is not None:
                break
            start = _taken(case, machine, last)
    return tails


def _classified(
    tails: Matrix, decay: float, omega: float
) -> tuple[tuple[Attractor, ...], Integers]:
    """Return the attractors of motions by their last states, and the number of that of each.

    It is -1 where a motion does not repeat itself, and -2 where there is none.  A transient
    may decay by as little as `decay` in a period of the forcing.
    """
    rows, columns, _, _ = tails.shape
    attractors: list[Attractor] = []
    every_size: list[Vector] = []
    least = ROUNDING * np.nanmax(np.abs(tails), axis=(0, 1, 2), initial=0.0)
    index = np.full((rows, columns), -2, dtype=np.int64)
    for i in range(rows):
        for j in range(columns):
            if np.isnan(tails[i, j]).any():
                continue
            period, sizes = _repeated(tails[i, j], decay, omega)
            if period is None:
                index[i, j] = -1
                continue
            alike = (
                k
                for k, (other, size) in enumerate(zip(attractors, every_size, strict=True))
                if other.cycles == period
                and _apart(tails[i, j, -1], other.states, np.maximum(sizes, size)) <= ONE
            )
            index[i, j] = next(alike, len(attractors))
            if index[i, j] == len(attractors):
                states = tails[i, j][-period:]
                attractors.append(Attractor(period, tuple(map(tuple, states.tolist()))))
                every_size.append(np.maximum(sizes, least))
    return tuple(attractors), index


def _repeated(tail: Matrix, decay: float, omega: float) -> tuple[int | None, Vector]:
    """Return after how many periods states repeat, None if never, and sizes to compare them."""
    x, v = np.abs(tail).max(axis=0)
    sizes = np.array([max(x, LEAST * v / omega), max(v, LEAST * x * omega)])
    return _period(tail / np.where(sizes == 0, 1.0, sizes), decay), sizes


def _apart(state: Vector, states: Sequence[Sequence[float]], sizes: Vector) -> float:
    """Return how far a state is from the nearest of others, for given sizes; 0 where alike."""
    differences = np.abs(np.array(states) - state)
    return float((differences / np.where(sizes == 0, 1.0, sizes)).max(axis=1).min())


def _period(tail: Matrix, decay: float) -> int | None:
    """Return after how many periods of the forcing states repeat, twice; None if never.

    What is left of a transient may change its sign, or turn, within a few periods: states that
    differ little, and ever less, are one.
    """
    turns = range(1, LONGEST + 1)
    for period in turns:
        if _off(tail, period) <= max(-AGAIN * math.expm1(-decay * period), ROUNDING):
            before = tail[:-period]
            parts = (
                q for q in turns[: period // 2] if period % q == 0 and _off(tail, q) <= ONE
            )
            less = (q for q in parts if _off(tail, q) <= max(LESS * _off(before, q), 2 * AGAIN))
            return next(less, period)
    return None


def _off(tail: Matrix, period: int) -> float:
    """Return how much the last states differ from those some periods before."""
    return float(np.abs(tail[-period:] - tail[-2 * period : -period]).max())


def _followed(
    case: Case, machine: Machine, start: AnyState, cycles: int
) -> tuple[Matrix, Vector | None]:
    """Return what is seen at each whole turn that is reached, and the last state, in SI units.

    That is None where the motion ends before.
    """
    shown = _units(case)
    if start is None:
        return np.empty((0, len(shown))), None
    units = units_of(case, machine) if isinstance(machine, BodyMachine) else shown
    states = machine.strobed(start, cycles)[0] * units
    return states[:, : len(shown)], states[-1] if len(states) == cycles + 1 else None


def _taken(case: Case, machine: Machine, last: Vector | None) -> AnyState:
    """Return the last state of the motion before, if a phase takes it; else one at rest."""
    if last is not None:
        if isinstance(machine, BodyMachine):
            start: AnyState = state_of(case, machine, last)
        else:
            x, v, *memory = (last / _units(case)).tolist()
            start = State(x, v, 0.0, memory=tuple(memory))
        if machine.begin(start) is not None:
            return start
    return machine.at_rest(0.0)


def _units(case: Case) -> Vector:
    """Return the units of displacement, velocity and memory."""
    powers = (0, 1, *(memory.power for memory in case.cell.memory))
    return np.array([case.units.of_motion(power) for power in powers])


def _check_forced(case: Case) -> None:
    check_case(case)
    if case.scene.frequency is None:
        words = "there is no period at which its states could be looked at"
        raise ValueError(f"scene: nothing forces {case.scene.name}: {words}")


def _axis(name: str, values: Sequence[float], unit: float) -> Vector:
    items = several(name, values, "numbers")
    within = (is_number(value) and math.isfinite(float(value) / float(unit)) for value in items)
    if not all(within):
        expected = "finite numbers, within float64 in the units of the scene"
        raise ValueError(f"{name}: got {values!r:.80}, expected {expected}")
    return np.array(items, dtype=float)
