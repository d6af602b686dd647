"""Checks of the series of C1 functions (3.3), also against the one C1 function of (3.2)."""

import math
from itertools import pairwise

import numpy as np

from nonsmooth.all_solutions import solutions

from ..case import FLOORS, MOST, Case
from ..words import listed, number, percent
from . import BAND, THREE, UNSEEN, Finding

#: Orders from each of which to the next errors are to fall by a factor `GAIN`.
SOME, GAIN = (9, 12, 15), 10

TOO_FEW = Finding(False, "too few orders are above rounding")


def above_rounding(case: Case, first: int, of: str = "period") -> dict[int, float]:
    """Return the errors by order, from `first` up to the order where they are rounding."""
    errors = {}
    for N in range(first, MOST + 1):
        error = case.measured(of, "c1", N)
        if abs(error) < FLOORS[of]:
            break
        errors[N] = error
    return errors


def overtakes(case: Case, of: str) -> Finding:
    """Check that an error is smaller than with one C1 function from some order up to 20 on."""
    first = max(case.behind(of, "c1", "hb-c1"), default=0) + 1
    words = f"from N = {first} on" if first < MOST else "not by then"
    return Finding(first <= MOST // 2, words)


def beyond_three(case: Case) -> Finding:
    """Check that the period is better than with one C1 function at every order beyond 3."""
    behind = [N for N in case.behind("period", "c1", "hb-c1") if N > THREE]
    N = behind[0] if behind else THREE + 1
    ours, theirs = (abs(case.measured("period", m, N)) for m in ("c1", "hb-c1"))
    words = f"{percent(ours)} off against {percent(theirs)} at N = {N}"
    return Finding(not behind, words)


def behind_at_three(case: Case) -> Finding:
    """Check that the period is still worse than with one C1 function at N = 3."""
    ours, theirs = (abs(case.measured("period", m, THREE)) for m in ("c1", "hb-c1"))
    return Finding(ours > theirs, f"{percent(ours)} off against {percent(theirs)}")


def in_band(case: Case, first: int) -> Finding:
    """Check that the period is in the band of Fig. 4 at every order from `first` on."""
    errors = above_rounding(case, first) or {first: case.measured("period", "c1", first)}
    return _worst(errors)


def _worst(errors: dict[int, float]) -> Finding:
    N = max(errors, key=lambda order: abs(errors[order]))
    words = f"at worst {percent(errors[N])}, at N = {N}"
    return Finding(abs(errors[N]) <= BAND, words)


def in_band_with_any_solution(case: Case) -> Finding:
    """Check the same from N = 4 on, where solutions whose stick ends too early count as well.

    They count at orders without an orbit, if slip is shorter than a natural period.
    """
    errors: dict[int, float] = {}
    for N in range(THREE + 1, MOST + 1):
        if case.has("c1", N):
            errors[N] = abs(case.measured("period", "c1", N))
        else:
            natural = 2 * math.pi / case.belt.omega_n
            short = [root for root in solutions(case.belt, N) if root.slip < natural]
            if not short:
                words = f"at N = {N} there is none of a slip shorter than a natural period"
                return Finding(False, words)
            nearest = min(short, key=lambda root: abs(root.t1 - case.exact.t1))
            errors[N] = abs(nearest.period / case.exact.period - 1)
        if errors[N] < FLOORS["period"]:
            break
    return _worst(errors)


def shrinks(case: Case) -> Finding:
    """Check that the size of the period error falls at every order from 4 on."""
    errors = above_rounding(case, THREE + 1)
    grows = [str(N) for (_, a), (N, b) in pairwise(errors.items()) if abs(b) >= abs(a)]
    if grows:
        return Finding(False, f"it grows at N = {listed(grows)}")
    return Finding(True, f"to rounding at N = {THREE + 1 + len(errors)}")


def one_sided(case: Case) -> Finding:
    """Check that the period approaches the exact one from one side."""
    errors = above_rounding(case, THREE + 1)
    crossings = [str(N) for (_, a), (N, b) in pairwise(errors.items()) if a * b < 0]
    if crossings:
        return Finding(False, f"it crosses at N = {listed(crossings)}")
    return Finding(True, "it never crosses")


def poorest(case: Case) -> Finding:
    """Check that the error (22) at N = 3 is largest for the harmonics alone."""
    errors = {m: case.measured("acceleration", m, THREE) for m in ("hb", "hb-c1", "c1")}
    words = ", ".join(f"{m} {percent(error)}" for m, error in errors.items())
    return Finding(max(errors, key=lambda m: errors[m]) == "hb", words)


def stick_is_exact(case: Case) -> Finding:
    """Check that the acceleration in stick is exactly zero at the lowest order."""
    N = min(case.orders("c1"))
    orbit = case.orbit("c1", N)
    largest = float(np.abs(orbit.acceleration(np.linspace(0, orbit.t1, 100)[:-1])).max())
    return Finding(largest == 0, f"largest acceleration in stick, N = {N}: {number(largest)}")


def no_ripple(case: Case) -> Finding:
    """Check that the largest error of the acceleration is too small to be seen at N = 10."""
    errors = [case.measured("largest acceleration", "c1", N) for N in (5, 10)]
    words = f"{listed([percent(e, 2) for e in errors])} of the jump at N = 5 and 10"
    return Finding(errors[-1] < UNSEEN, words)


def all_derivatives(case: Case) -> Finding:
    """Check that displacement, velocity, acceleration and jerk converge to the exact ones."""
    names = {"x": "displacement", "velocity": "velocity"}
    names |= {"acceleration": "acceleration", "jerk": "jerk"}
    rows = {
        name: [case.measured(f"largest {of}", "c1", N) for N in SOME]
        for name, of in names.items()
    }
    falls = all(b * GAIN < max(a, 1e-11) for row in rows.values() for a, b in pairwise(row))
    latest = ", ".join(f"{name} {number(row[-1], 2)}" for name, row in rows.items())
    return Finding(falls, f"at N = {SOME[-1]}: {latest}")


def _steps(case: Case) -> tuple[dict[int, float], dict[int, float]]:
    """Return the ratio of (22) to that at the order before, at odd and at even orders.

    They begin with the first order, 3 or higher, from which on each has an orbit, and end where
    (22) is rounding.
    """
    missing = [N for N in range(THREE, MOST + 1) if not case.has("c1", N)]
    errors = above_rounding(case, max(missing, default=THREE - 1) + 1, "acceleration")
    steps = {N: after / before for (_, before), (N, after) in pairwise(errors.items())}
    odd, even = ({N: steps[N] for N in steps if parity == N % 2} for parity in (1, 0))
    return odd, even


def stairs(case: Case) -> Finding:
    """Check that (22) falls by more than a factor 2 at odd orders, and by less at even ones."""
    odd, even = ([1 / step for step in steps.values()] for steps in _steps(case))
    if not (odd and even):
        return TOO_FEW
    words = (
        f"by factors of {number(min(odd), 2)} to {number(max(odd), 2)} at odd orders, "
        f"{number(min(even), 2)} to {number(max(even), 2)} at even ones"
    )
    return Finding(min(odd) > 2 > max(even), words)


def even_add_nothing(case: Case) -> Finding:
    """Check that (22) at each even order is that at the odd order before, within 1 %."""
    even = {N: step - 1 for N, step in _steps(case)[1].items()}
    if not even:
        return TOO_FEW
    N = max(even, key=lambda order: abs(even[order]))
    growing = [str(order) for order in even if even[order] > 0.01]
    words = f"it changes by {percent(even[N], 2)} at N = {N}"
    words += f" and grows at N = {listed(growing)}" if growing else ""
    return Finding(abs(even[N]) < 0.01, words)
