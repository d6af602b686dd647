"""Exact times of the two scenes that are timed, in SI units: what errors are measured against.

python -m benchmarks.scene_references      # to 30 digits, by mpmath
"""

import math

import mpmath

#: Duration of flight and phase of the forcing at the impact.  S1 of the references of this
#: project: Newton's method on matrix exponentials in 60 digits, and by simulation (DOP853 with
#: events, to 5e-12).
IMPACT = 3.4906585039886591538473815369772, 0.92964398603332421612843096007677

#: The parameters that IMPACT belongs to: m, c, k, F, Omega, gap, restitution.
IMPACT_CASE = (1.0, 0.1, 1.0, 1.0, 1.8, 0.1, 0.6)

#: M, K, V, mu_s, mu_k, F_N, c, w of the damped belt.
BELT_CASE = (10.0, 1000.0, 1.0, 0.5, 0.25, 400.0, 5.0, 0.0)

#: Rough times, a part of the exact durations and an angle, from which all of Newton's methods
#: start: 10 % too long and too short by turns, 0.3 rad.
OFF, ANGLE_OFF = 0.1, 0.3


def belt(digits: int = 30) -> tuple[mpmath.mpf, mpmath.mpf]:
    """Return durations of stick and slip of the damped belt: the closed form, and its root."""
    with mpmath.workdps(digits + 10):
        M, K, V, mu_s, mu_k, F_N, c, w = map(mpmath.mpf, BELT_CASE)
        middle, damping = F_N * (mu_k - V * w) / K, (c - F_N * w) / M
        begin = (F_N * mu_s - c * V) / K
        rate = mpmath.sqrt(K / M - damping**2 / 4)

        def state(t: mpmath.mpf) -> tuple[mpmath.mpf, mpmath.mpf]:
            """Return displacement and velocity in slip."""
            x, v = begin - middle, V
            cos, sin = mpmath.cos(rate * t), mpmath.sin(rate * t) / rate
            decay = mpmath.exp(-damping * t / 2)
            y = decay * (x * (cos + damping / 2 * sin) + v * sin)
            return middle + y, decay * (v * (cos - damping / 2 * sin) - x * K / M * sin)

        # from three quarters of a turn on the velocity rises, and reaches the belt's once
        slip = mpmath.findroot(lambda t: state(t)[1] - V, 4.7 / rate)
        return +((begin - state(slip)[0]) / V), +slip


def rough(scene: str) -> tuple[float, float]:
    """Return the times in SI units from which all start."""
    if scene == "impact":
        return IMPACT[0], IMPACT[1] + ANGLE_OFF
    stick, slip = belt()
    return float(stick) * (1 + OFF), float(slip) * (1 - OFF)


def error(scene: str, times: tuple[float, float]) -> float:
    """Return the largest error of times in SI units, as a part of the period."""
    if scene == "impact":
        turn = math.remainder(times[1] - IMPACT[1], 2 * math.pi)
        return max(abs(times[0] - IMPACT[0]), abs(turn) / IMPACT_CASE[4]) / IMPACT[0]
    exact = belt()
    off = max(abs(mpmath.mpf(t) - e) for t, e in zip(times, exact, strict=True))
    return float(off / sum(exact))


if __name__ == "__main__":
    print("impact, flight and phase:", *IMPACT)
    print("stick-slip-damped, stick and slip:", *(mpmath.nstr(t, 30) for t in belt()))
