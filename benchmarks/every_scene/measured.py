"""The points of all contenders of a scene, timed in turn."""

import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass

import numba
import numpy as np
from numba.core.dispatcher import Dispatcher

from . import aft, ours, return_map, simulated
from .problem import Problem

#: Rounds, and seconds of work in one round of one contender at one setting.
ROUNDS, SECONDS = 5, 0.005

#: What is compared with everything else, and what is the floor.
MINE, FLOOR = "ck-tau", "exact flow, Python"

#: Orders, steps in a cell, digits of a tolerance, harmonics.
ORDERS = (3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16)
HARMONICS = (4, 8, 16, 32, 64)
STEPS = (16, 32, 64, 128, 256, 512, 1024, 2048)
DIGITS = (3, 6, 9, 11)
SLOW_HARMONICS = (4, 8, 16, 32)


@dataclass(frozen=True)
class Point:
    """One contender at one setting: error of the times, a part of T, and seconds an orbit."""

    scene: str
    name: str
    setting: int
    error: float
    seconds: float


@dataclass(frozen=True)
class Contender:
    """A way to the orbit.

    Parameters
    ----------
    name : str
    function : callable
        Compiled or not; its time is taken.
    arguments : callable
        ``arguments(setting)``: what it is called with.
    settings : tuple of int
    times : callable
        ``times(result)``: what errors are taken of; not timed.
    """

    name: str
    function: Callable[..., np.ndarray]
    arguments: Callable[[int], tuple]
    settings: tuple[int, ...]
    times: Callable[[np.ndarray], np.ndarray] = np.asarray


def contenders(which: Problem) -> list[Contender]:
    """Return all that can be had for a scene, ours first."""
    case, rough = which.case, which.rough
    found = [
        Contender(
            method,
            ours.newton(case.scene, method),
            lambda order, method=method: (*ours.taken(case, method, order), rough),
            ORDERS if method == MINE else HARMONICS,
        )
        for method in (MINE, "hb-ck", "hb")
    ]
    found.append(Contender(FLOOR, ours.exact_flow(which), lambda n: (n,), (0,)))
    fixed = return_map.arguments(which)
    map_of = return_map.fixed_point
    found.append(Contender("RK4 return map, numba", map_of, lambda n: (*fixed, n), STEPS))
    steady = simulated.solver(which)
    found.append(Contender("solve_ivp to steady state", steady, lambda n: (n,), DIGITS))
    for name, make, settings in (
        ("AFT, NumPy", aft.by_hand, HARMONICS),
        ("AFT, harmonicbalance", aft.by_package, SLOW_HARMONICS),
    ):
        solve = make(which)
        if solve is not None:
            located = lambda X: aft.switching_times(which, X)  # noqa: E731
            found.append(Contender(name, solve, lambda n: (n,), settings, located))
    return found


def _repeated(function: Callable[..., np.ndarray]) -> Callable[..., float]:
    """Return a loop over orbits; compiled if the function is."""

    def loop(count, arguments):
        total = 0.0
        for _ in range(count):
            total += function(*arguments)[0]
        return total

    return numba.njit(loop) if isinstance(function, Dispatcher) else loop


def _seconds(loop: Callable[..., float], count: int, arguments: tuple) -> float:
    begin = time.perf_counter()
    loop(count, arguments)
    return (time.perf_counter() - begin) / count


def measure(which: Problem, rounds: int = ROUNDS, fewest: bool = False) -> list[Point]:
    """Return the points of a scene; with `fewest`, of the first setting of each alone."""
    return measured(which.name, contenders(which), which.error, rounds, fewest)


def measured(
    what: str,
    ways: list[Contender],
    error_of: Callable[[np.ndarray], float],
    rounds: int = ROUNDS,
    fewest: bool = False,
) -> list[Point]:
    """Return the points of contenders; `error_of` times says how far off they are."""
    runs = []
    for each in ways:
        loop = _repeated(each.function)
        for setting in each.settings[: 1 if fewest else None]:
            arguments = each.arguments(setting)
            error = error_of(each.times(each.function(*arguments)))
            if not error < 0.1:  # nothing was found, or something else
                continue
            loop(1, arguments)
            once = min(_seconds(loop, 1, arguments) for _ in range(2))
            count = max(1, min(20_000, int(SECONDS / once)))
            runs.append((each.name, setting, error, loop, count, arguments))
    seen: list[list[float]] = [[] for _ in runs]
    for round_ in range(rounds):
        for (_, _, _, loop, count, arguments), times in zip(runs, seen, strict=True):
            if round_ == 0 or count > 1 or times[0] < 20 * SECONDS:  # slow ones once
                times.append(_seconds(loop, count, arguments))
    return [
        Point(what, name, setting, error, statistics.median(times))
        for (name, setting, error, *_), times in zip(runs, seen, strict=True)
    ]
