"""The two scenes that are timed, simulated to steady state: `solve_ivp`, DOP853, events."""

import math

import numpy as np
from scipy.integrate import solve_ivp

from .scene_rivals import ROUGH_SPEED

#: Digits of the tolerance are the setting.
TINY = 1e-13


def _until(rates, state, begin, event, tolerance, cycle):
    """Return time and state at the first event after the start."""
    event.terminal, event.direction = True, 1
    run = solve_ivp(
        rates,
        (begin, begin + 4 * cycle),
        state,
        method="DOP853",
        events=event,
        rtol=max(tolerance, TINY),
        atol=tolerance,
        max_step=cycle / 6,  # a longer one may pass two events
    )
    return float(run.t_events[0][0]), run.y_events[0][0]


def impact(case, digits, flight, phi):
    """Return the times of the impacts to which the motion settles."""
    m, c, k, F, Omega, gap, r = case
    tolerance = 10.0**-digits

    def rates(t, state):
        force = F * math.cos(Omega * t) - c * state[1] - k * state[0]
        return state[1], force / m

    t, state = phi / Omega, np.array([gap, -ROUGH_SPEED])
    for _ in range(200):
        end, state = _until(
            rates, state, t, lambda t, state: state[0] - gap, tolerance, 2 * math.pi / Omega
        )
        # back to the limit, or the next event would be the rounding of this one
        state = np.array([np.nextafter(gap, -1), -r * state[1]])
        lasted, moved, t = end - t, Omega * (end - t) - 2 * math.pi, end
        if abs(moved) < tolerance:
            break
    return lasted, Omega * t % (2 * math.pi)


def belt(case, digits, stick, slip):
    """Return stick and slip after a start far out, at rest: the first cycle is the orbit."""
    M, K, V, mu_s, mu_k, F_N, c, w = case
    begin, tolerance = (F_N * mu_s - c * V) / K, 10.0**-digits
    cycle = 2 * math.pi * math.sqrt(M / K)

    def rates(t, state):
        force = F_N * (mu_k + w * (state[1] - V)) - c * state[1] - K * state[0]
        return state[1], force / M

    state = np.array([-2 * begin, 0.0])
    for _ in range(2):
        t, end = _until(rates, state, 0.0, lambda t, state: state[1] - V, tolerance, cycle)
        stick, state = (begin - end[0]) / V, np.array([begin, np.nextafter(V, 0)])
    return stick, t
