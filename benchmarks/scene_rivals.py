"""What an expert would write for the two scenes that are timed, compiled by numba; SI units.

Each is ``solve(case, setting, a, b)``, from rough times to times: for the impact oscillator the
duration of flight and the phase of the forcing, for the belt the durations of stick and slip.
The setting of RK4 is the number of steps in a cycle; fixed ones, for motions as even as these.
"""

import math
from collections.abc import Callable

import numba

Solve = Callable[[tuple[float, ...], int, float, float], tuple[float, float]]

#: Newton's method stops below this step, whose square is below rounding.
SMALL = 1e-7

#: The step of a difference for a derivative.
STEP = 1e-7

#: Speed after an impact, 10 % off: what maps of states start from beside the phase.
ROUGH_SPEED = 1.1 * 1.4604048587365092

#: No orbit has a flight or slip of so many cycles.
TOO_LONG = 40.0

njit = numba.njit(error_model="numpy")


@njit
def _rk4(m, c, k, x, v, h, f0, f1, f2):
    """Return the state a step of RK4 ahead; the force at its begin, middle and end."""
    a1 = (f0 - c * v - k * x) / m
    v2 = v + h / 2 * a1
    a2 = (f1 - c * v2 - k * (x + h / 2 * v)) / m
    v3 = v + h / 2 * a2
    a3 = (f1 - c * v3 - k * (x + h / 2 * v2)) / m
    v4 = v + h * a3
    a4 = (f2 - c * v4 - k * (x + h * v3)) / m
    return x + h / 6 * (v + 2 * v2 + 2 * v3 + v4), v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)


@njit
def _hermite_root(begin, slope, end, end_slope):
    """Return where the cubic with these values and slopes at 0 and 1 is 0, from the chord."""
    u = begin / (begin - end)
    for _ in range(8):
        w = 1 - u
        value = w * w * ((1 + 2 * u) * begin + u * slope)
        value += u * u * ((3 - 2 * u) * end - w * end_slope)
        rate = 6 * u * w * (end - begin) + w * (1 - 3 * u) * slope + u * (3 * u - 2) * end_slope
        u -= value / rate
        if abs(value) < SMALL * abs(rate):
            break
    return u


@njit
def _to_impact(case, steps, phi, speed):
    """Return what phase and speed miss, at the next impact, of the same again."""
    m, c, k, F, Omega, gap, r = case
    h = 2 * math.pi / Omega / steps
    x, v, f0, t = gap, -speed, F * math.cos(phi), 0.0
    while True:
        f1 = F * math.cos(phi + Omega * (t + h / 2))
        f2 = F * math.cos(phi + Omega * (t + h))
        ahead_x, ahead_v = _rk4(m, c, k, x, v, h, f0, f1, f2)
        if (x < gap <= ahead_x) or not t * Omega < TOO_LONG:
            break
        x, v, f0, t = ahead_x, ahead_v, f2, t + h
    part = h * _hermite_root(x - gap, h * v, ahead_x - gap, h * ahead_v)
    for _ in range(2):  # the cubic is of a lower order than a step: one of that length
        f1 = F * math.cos(phi + Omega * (t + part / 2))
        f2 = F * math.cos(phi + Omega * (t + part))
        end_x, end_v = _rk4(m, c, k, x, v, part, f0, f1, f2)
        part -= (end_x - gap) / end_v
    return Omega * (t + part) - 2 * math.pi, r * end_v - speed


@njit
def _over_a_period(case, steps, phi, speed):
    """Return the same where one impact a period is taken for granted: nothing is located."""
    m, c, k, F, Omega, gap, r = case
    h = 2 * math.pi / Omega / steps
    x, v, f0 = gap, -speed, F * math.cos(phi)
    for i in range(steps):
        f1 = F * math.cos(phi + Omega * h * (i + 0.5))
        f2 = F * math.cos(phi + Omega * h * (i + 1))
        x, v = _rk4(m, c, k, x, v, h, f0, f1, f2)
        f0 = f2
    return x - gap, r * v - speed


def _fixed_point(P) -> Solve:
    """Return Newton's method with differences on a map of phase and speed."""

    @njit
    def solve(case, steps, flight, phi):
        v = ROUGH_SPEED
        for _ in range(20):
            R1, R2 = P(case, steps, phi, v)
            A1, A2 = P(case, steps, phi + STEP, v)
            B1, B2 = P(case, steps, phi, v + STEP)
            a, b, c, d = A1 - R1, B1 - R1, A2 - R2, B2 - R2
            off = STEP / (a * d - b * c)
            step_phi, step_v = off * (d * R1 - b * R2), off * (a * R2 - c * R1)
            phi, v = phi - step_phi, v - step_v
            if max(abs(step_phi), abs(step_v)) < SMALL:
                return 2 * math.pi / case[4], phi
        return math.nan, math.nan

    return solve


#: The map from impact to impact, with event location; and the cheaper one without.
impact_rk4_map = _fixed_point(_to_impact)
impact_rk4_period = _fixed_point(_over_a_period)


@njit
def impact_flow(case, _, T, phi):
    """Newton's method on the closed-form flow over a period, multiplied out by hand."""
    m, c, k, F, Omega, gap, r = case
    speed, damping = ROUGH_SPEED, c / (2 * m)
    rate = math.sqrt(k / m - damping * damping)
    cos, sin, decay = math.cos(rate * T), math.sin(rate * T) / rate, math.exp(-damping * T)
    xx, xv = decay * (cos + damping * sin), decay * sin
    vx, vv = -decay * k / m * sin, decay * (cos - damping * sin)
    stiff = k - m * Omega * Omega
    size = F / (stiff * stiff + c * c * Omega * Omega)
    for _ in range(20):
        C, S = math.cos(phi), math.sin(phi)
        p = size * (stiff * C + c * Omega * S)
        q = size * Omega * (c * Omega * C - stiff * S)
        y, w = gap - p, -speed - q
        R1 = xx * y + xv * w - y
        R2 = r * (vx * y + vv * w + q) - speed
        a, b = -(xx - 1) * q / Omega + xv * Omega * p, -xv
        g = r * (-vx * q / Omega + vv * Omega * p - Omega * p)
        d = -r * vv - 1
        det = a * d - b * g
        step_phi, step_v = (d * R1 - b * R2) / det, (a * R2 - g * R1) / det
        phi, speed = phi - step_phi, speed - step_v
        if max(abs(step_phi), abs(step_v)) < SMALL:
            return T, phi
    return math.nan, math.nan


@njit
def belt_rk4(case, steps, stick, slip):
    """RK4 through slip, which always begins at the same load: the map is a constant."""
    M, K, V, mu_s, mu_k, F_N, c, w = case
    begin, h = (F_N * mu_s - c * V) / K, 2 * math.pi * math.sqrt(M / K) / steps
    f, c = F_N * (mu_k - V * w), c - F_N * w
    x, v = _rk4(M, c, K, begin, V, h, f, f, f)
    t = h
    while True:
        ahead_x, ahead_v = _rk4(M, c, K, x, v, h, f, f, f)
        if v < V <= ahead_v:
            break
        x, v, t = ahead_x, ahead_v, t + h
        if not t < TOO_LONG * steps * h:
            return math.nan, math.nan
    a, ahead_a = (f - c * v - K * x) / M, (f - c * ahead_v - K * ahead_x) / M
    part = h * _hermite_root(v - V, h * a, ahead_v - V, h * ahead_a)
    for _ in range(2):
        end_x, end_v = _rk4(M, c, K, x, v, part, f, f, f)
        part -= (end_v - V) / ((f - c * end_v - K * end_x) / M)
    return (begin - end_x) / V, t + part


@njit
def belt_flow(case, _, stick, slip):
    """Newton's method for the duration of slip on the closed-form flow."""
    M, K, V, mu_s, mu_k, F_N, c, w = case
    middle, damping = F_N * (mu_k - V * w) / K, (c - F_N * w) / (2 * M)
    begin = (F_N * mu_s - c * V) / K
    y, rate = begin - middle, math.sqrt(K / M - damping * damping)
    for _ in range(20):
        cos, sin = math.cos(rate * slip), math.sin(rate * slip) / rate
        decay = math.exp(-damping * slip)
        x = decay * (y * (cos + damping * sin) + V * sin)
        v = decay * (V * (cos - damping * sin) - y * K / M * sin)
        step = (v - V) / (-2 * damping * v - K / M * x)
        slip -= step
        if abs(step) < SMALL * slip:  # the state at the root, by its Taylor series
            return (begin - middle - x + step * v) / V, slip
    return math.nan, math.nan
