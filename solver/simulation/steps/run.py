"""A motion over many phases: several of them in turn, or sampled at whole turns of the forcing.

Functions over `Rules` and states: plain Python, or compiled by numba.
"""

from math import inf

import numpy as np

from ...arrays import Integers, Matrix
from ...flow.responses import state_at
from .chatter import CHATTER, accumulates, put_last
from .clock import Clock, at_start, later, time_to, total
from .column import NONE
from .locate import CUT, EVENT
from .rules import Rules
from .state import AnyState, State, begun, equation_of, window_of
from .step import CHATTERS, MANY, REFUSED, Passed, step
from .switches import first_phase, has_rest

#: Most phases of one motion.
MOST_PHASES = 100_000

#: Number of windows whose search for events costs about as much as the rest of a phase.
STRETCH = 100


def several(
    rules: Rules, p: int, state: AnyState, clock: Clock, until: tuple[float, float],
    most: float, count: int,
) -> list[Passed]:  # fmt: skip
    """Follow a motion from the start of a phase through `count` phases at most.

    It ends earlier behind a phase that no event ends, or that a rest replaces.

    Parameters
    ----------
    until : (float, float)
        The time after which the last phase is cut off, as a sum of two floats.
    most : float
        The `effort` after which it is.
    """
    passed, (high, low) = [], until
    for _ in range(count):
        window = window_of(rules, p, state)
        one = step(rules, p, state, clock, min(max(high + low, 0.0), reach(window, most)))
        passed.append(one)
        most -= effort(window, one.s)
        if one.how != EVENT or one.away != NONE or most < 1:
            break
        high, rest = total(high, -one.s)
        high, low = total(high, low + rest)
        p, state, clock = one.phase, one.state, one.clock
    return passed


def effort(window: float, s: float) -> float:
    """Return the cost of following a phase for a time: 1, and more for a long one."""
    return 1 + s / (STRETCH * window)


def reach(window: float, most: float) -> float:
    """Return how long a phase can be followed at a cost of `most`; inverse of `effort`."""
    return max(most - 1, 0.0) * STRETCH * window if most < inf else most


def run(rules: Rules, state: State, cycles: int) -> tuple[Matrix, Integers, int]:
    """Return a motion at each whole turn of the forcing; without forcing, each 2 pi of time.

    Parameters
    ----------
    cycles : int
        Number of turns for which it is followed.

    Returns
    -------
    states : ndarray, shape (turns, 2 + M)
        Displacement, velocity and memory at the start and after each turn that was reached;
        at a switch, those behind it.  For a body, also its y, after these.
    phases : ndarray of int, shape (turns,)
        The phase at each of these.
    how : int
        Why it ended: `CUT` if it was followed for all the cycles.
    """
    states = np.zeros((cycles + 1, width(rules)))
    phases, count, last = np.zeros(cycles + 1, dtype=np.int64), 0, [inf] * CHATTER
    p, clock = first_phase(rules, state), at_start(state.angle, rules.omega)
    if p == NONE:
        return states[:0], phases[:0], REFUSED
    state = begun(rules, p, state)
    for _ in range(MOST_PHASES):
        passed = step(rules, p, state, clock, time_to(clock, cycles))
        s, how = passed.s, passed.how
        until = inf if how == CUT else s
        count = strobe(rules, p, state, clock, until, states, phases, count)
        put_last(last, s)
        if how != EVENT:
            return states[:count], phases[:count], how
        if passed.away != NONE:
            p, state, clock, left = passed.away, passed.behind, later(clock, s), passed.left
            count = strobe(rules, p, state, clock, left, states, phases, count)
            put_last(last, left)
        elif accumulates(last) and (passed.left > 0 or not has_rest(rules, passed.surface)):
            return states[:count], phases[:count], CHATTERS
        p, state, clock = passed.phase, passed.state, passed.clock
    return states[:count], phases[:count], MANY


def width(rules: Rules) -> int:
    """Return how many numbers `strobe` keeps of a state."""
    return 2 + int(rules.setting.shape[2])


def strobe(
    rules: Rules, p: int, state: State, clock: Clock, s: float,
    states: Matrix, phases: Integers, count: int,
) -> int:  # fmt: skip
    """Fill in the states at the whole turns within a phase of duration `s`.

    `count` states are filled in before; return how many are then.
    """
    phase = equation_of(rules, p, state.memory)
    while count < len(states):
        t = time_to(clock, count)
        if not t < s:
            break
        x, v = state_at(phase, state.x, state.v, state.angle, rules.omega, t)
        states[count, 0], states[count, 1], phases[count] = x, v, p
        for i in range(len(state.memory)):
            states[count, 2 + i] = state.memory[i]
        count += 1
    return count
