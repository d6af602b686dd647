"""Checks of the series of C1 functions (3.3), and of who overtakes whom."""

from itertools import pairwise

import numpy as np
from numpy.polynomial import legendre

from nonsmooth.solver.shortcuts.accuracy.convergence import FLOORS
from nonsmooth.solver.shortcuts.orbit import exact
from nonsmooth.solver.shortcuts.polynomials import c1_roots

from ..case import MOST, SAMPLES, Case
from ..finding import Finding
from ..words import listed, number, percent
from .fourier import BAND, UNSEEN

#: The order after which the paper says things of this series.
THREE = 3

#: Orders, each of which is to gain a factor of `GAIN` on the one before.
SOME, GAIN = (9, 12, 15), 10


def above_rounding(case: Case, first: int, name: str = "period") -> list[tuple[int, float]]:
    """Return orders from `first` on with the error, to the first that is rounding."""
    measure = {"period": case.period_error, "acceleration": case.acceleration_error}[name]
    found = []
    for N in range(first, MOST + 1):
        error = measure("c1", N)
        if abs(error) < FLOORS[name]:
            break
        found.append((N, error))
    return found


def _overtakes(case: Case, name: str) -> Finding:
    behind = case.behind(name, "c1", "hb-c1")
    first = max(behind, default=0) + 1
    words = f"from N = {first} on" if first < MOST else "not by then"
    return Finding(first <= MOST // 2, words)


def overtakes(case: Case) -> Finding:
    """Return whether the period is better than with one C1 function, from some order on."""
    return _overtakes(case, "period")


def overtakes_acceleration(case: Case) -> Finding:
    """Return whether (22) is smaller than with one C1 function, from some order on."""
    return _overtakes(case, "acceleration")


def beyond_three(case: Case) -> Finding:
    """Return whether the period is better at every order beyond 3."""
    behind = [N for N in case.behind("period", "c1", "hb-c1") if N > THREE]
    N = behind[0] if behind else THREE + 1
    ours, theirs = (abs(case.period_error(m, N)) for m in ("c1", "hb-c1"))
    words = f"{percent(ours, 3)} off against {percent(theirs, 3)} at N = {N}"
    return Finding(not behind, words)


def behind_at_three(case: Case) -> Finding:
    """Return whether the period is still worse at N = 3."""
    ours, theirs = (abs(case.period_error(m, THREE)) for m in ("c1", "hb-c1"))
    return Finding(ours > theirs, f"{percent(ours)} off against {percent(theirs)}")


def _in_band(case: Case, first: int) -> Finding:
    errors = above_rounding(case, first) or [(first, case.period_error("c1", first))]
    N, worst = max(errors, key=lambda row: abs(row[1]))
    return Finding(abs(worst) <= BAND, f"at worst {percent(worst)}, at N = {N}")


def in_band_beyond_three(case: Case) -> Finding:
    """Return whether the period is in the band at every order from 4 on."""
    return _in_band(case, THREE + 1)


def in_band_from_three(case: Case) -> Finding:
    """Return whether it is in the band at N = 3 already."""
    return _in_band(case, THREE)


def in_band_with_any_solution(case: Case) -> Finding:
    """Return whether it is, if a solution whose stick ends too early counts as well."""
    t1, T = exact.times(case.alpha)
    errors = {}
    for N in range(THREE + 1, MOST + 1):
        if case.has("c1", N):
            errors[N] = abs(case.period_error("c1", N))
        else:
            short = [z for z in c1_roots.solutions(N, case.alpha) if z[-1] - z[-2] < 2 * np.pi]
            if not short:
                words = f"at N = {N} there is none of a slip shorter than a natural period"
                return Finding(False, words)
            nearest = min(short, key=lambda z: abs(z[-2] - t1))
            errors[N] = abs(float(nearest[-1]) - T) / T
        if errors[N] < FLOORS["period"]:
            break
    worst = max(errors, key=lambda N: errors[N])
    words = f"at worst {percent(errors[worst])}, at N = {worst}"
    return Finding(errors[worst] <= BAND, words)


def shrinks(case: Case) -> Finding:
    """Return whether the size of the period error falls at every order from 4 on."""
    errors = above_rounding(case, THREE + 1)
    grows = [N for (_, a), (N, b) in pairwise(errors) if abs(b) >= abs(a)]
    if grows:
        return Finding(False, f"it grows at N = {listed([str(N) for N in grows])}")
    return Finding(True, f"to rounding at N = {THREE + 1 + len(errors)}")


def one_sided(case: Case) -> Finding:
    """Return whether the period comes to the exact one from one side."""
    errors = above_rounding(case, THREE + 1)
    crossings = [N for (_, a), (N, b) in pairwise(errors) if a * b < 0]
    if not crossings:
        return Finding(True, "it never crosses")
    return Finding(False, f"it crosses at N = {listed([str(N) for N in crossings])}")


def poorest(case: Case) -> Finding:
    """Return whether (22) at N = 3 is largest for the harmonics alone."""
    errors = {m: case.acceleration_error(m, THREE) for m in ("hb", "hb-c1", "c1")}
    words = ", ".join(f"{m} {percent(error)}" for m, error in errors.items())
    return Finding(max(errors, key=lambda m: errors[m]) == "hb", words)


def stick_is_exact(case: Case) -> Finding:
    """Return whether the acceleration in stick is exactly zero, at the lowest order."""
    N = min(case.orders("c1"))
    orbit = case.orbit("c1", N)
    largest = float(np.abs(orbit.acceleration(np.linspace(0, orbit.t1, 100)[:-1])).max())
    return Finding(largest == 0, f"largest acceleration in stick, N = {N}: {number(largest)}")


def no_ripple(case: Case) -> Finding:
    """Return whether nothing is left at the jumps at N = 10."""
    errors = [case.largest_error("c1", N) for N in (5, 10)]
    words = f"{listed([percent(e, 2) for e in errors])} of the jump at N = 5 and 10"
    return Finding(errors[-1] < UNSEEN, words)


def _jerk_error(case: Case, order: int) -> float:
    """Return the largest error of the derivative of the slip acceleration, in amplitudes."""
    z, alpha = case.orbit("c1", order).unknowns, case.alpha
    u = (np.arange(SAMPLES) + 0.5) / SAMPLES
    found = 2 / (z[-1] - z[-2]) * legendre.legval(2 * u - 1, legendre.legder(z[:-2]))
    t1, T = exact.times(alpha)
    tau = (T - t1) * u
    reference = alpha * np.sin(tau) - np.cos(tau)
    return float(np.abs(found - reference).max() / np.hypot(1, alpha))


def all_derivatives(case: Case) -> Finding:
    """Return whether motion and derivatives, the jerk too, go to the exact ones."""
    rows = [[case.largest_error("c1", N, d) for N in SOME] for d in (0, 1, 2)]
    rows.append([_jerk_error(case, N) for N in SOME])
    falls = all(b * GAIN < max(a, 1e-11) for row in rows for a, b in pairwise(row))
    names = ("x", "velocity", "acceleration", "jerk")
    last = ", ".join(f"{n} {number(row[-1], 2)}" for n, row in zip(names, rows, strict=True))
    return Finding(falls, f"at N = {SOME[-1]}: {last}")


def _steps(case: Case) -> dict[int, float]:
    """Return by what factor (22) changes at each order, above rounding.

    From the order, 3 or higher, from which on there is an orbit at each.
    """
    missing = [N for N in range(THREE, MOST + 1) if not case.has("c1", N)]
    first = max(missing, default=THREE - 1) + 1
    errors = above_rounding(case, first, "acceleration")
    return {N: after / before for (_, before), (N, after) in pairwise(errors)}


def stairs(case: Case) -> Finding:
    """Return whether (22) falls at odd orders, and by far less or not at all at even ones."""
    steps = _steps(case)
    odd, even = ([1 / steps[N] for N in steps if rest == N % 2] for rest in (1, 0))
    if not (odd and even):
        return Finding(False, "too few orders are above rounding")
    words = (
        f"by factors of {number(min(odd), 2)} to {number(max(odd), 2)} at odd orders, "
        f"{number(min(even), 2)} to {number(max(even), 2)} at even ones"
    )
    return Finding(min(odd) > 2 > max(even), words)


def even_add_nothing(case: Case) -> Finding:
    """Return whether (22) is the same at an even order as at the odd one before."""
    even = {N: step - 1 for N, step in _steps(case).items() if N % 2 == 0}
    if not even:
        return Finding(False, "too few orders are above rounding")
    N = max(even, key=lambda order: abs(even[order]))
    up = [str(order) for order in even if even[order] > 0.01]
    words = f"it changes by {percent(even[N], 2)} at N = {N}"
    words += f" and grows at N = {listed(up)}" if up else ""
    return Finding(max(map(abs, even.values())) < 0.01, words)
