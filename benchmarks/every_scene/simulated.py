"""Simulation to steady state: `solve_ivp`, DOP853, events, one run a phase."""

import math

import numpy as np
from scipy.integrate import solve_ivp

from .problem import STATE_OFF, Problem

#: Cells after which a motion that has not settled is given up.
MOST = 1000

#: scipy takes no smaller relative tolerance.
TINY = 1e-13


def solver(which: Problem):
    """Return ``solve(digits)``: the times of the cell to which the motion settles."""
    cell, exact, times = which.case.cell, which.state, which.rough
    count = len(cell.phases)
    first = np.array([STATE_OFF * q for q in exact])
    longest = 4 * times[:count].sum()

    def run(phase, t, state, turn, tolerance):
        ex, ev, ec, e0 = phase.event
        omega = cell.omega

        def rates(t, state):
            x, v = state
            force = phase.f + phase.g * math.cos(omega * t + turn)
            return v, 0.0 if phase.held else (force - phase.c * v - phase.k * x) / phase.m

        def event(t, state):
            return ex * state[0] + ev * state[1] + ec * math.cos(omega * t + turn) + e0

        event.terminal = True
        start = times[:count].min() / 100  # past the event in which the phase begins
        options = {"method": "DOP853", "rtol": max(tolerance, TINY), "atol": tolerance}
        before = solve_ivp(rates, (t, t + start), state, **options)
        options["max_step"] = times[:count].min() / 3  # a longer one may pass two events
        found = solve_ivp(
            rates, (t + start, t + longest), before.y[:, -1], events=event, **options
        )
        return float(found.t_events[0][0]), found.y_events[0][0]

    def solve(digits: int) -> np.ndarray:
        tolerance, state, seen = 10.0**-digits, first, np.full(len(times), np.inf)
        angle = times[-1] if cell.forced else 0.0
        for _ in range(MOST):
            t, found, there = 0.0, [], cell.remembering([state[0]] * len(cell.memory))
            for phase in there.phases:
                if phase.held:
                    state = np.array([state[0], phase.speed])
                end, state = run(phase, t, state, angle, tolerance)
                found.append(end - t)
                state, t = np.array([state[0], phase.rho * state[1] + phase.d]), end
            settled = np.array([*found, *([angle] if cell.forced else [])])
            if np.max(np.abs(settled - seen)) < tolerance:
                return settled
            seen, state = settled, cell.sign * state
            if cell.forced:
                angle = angle + cell.omega * t - math.pi * (1 if cell.sign < 0 else 2)
        return np.full(len(times), np.nan)

    return solve
