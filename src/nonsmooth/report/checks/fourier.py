"""Checks of classical harmonic balance (3.1), and of harmonics with one C1 function (3.2)."""

from itertools import pairwise
from typing import Any

from ..case import FLOORS, MOST, Case
from ..words import ROUNDING, number, percent, power_of_order
from . import BAND, DOUBLED, THREE, UNSEEN, Finding, doubled

#: Gibbs' constant: the overshoot of a Fourier series, relative to the jump.
GIBBS = 0.0894898722360836

TOO_FEW = Finding(False, "too few orders have an orbit")


def falls(case: Case, of: str, method: str, factor: float) -> Finding:
    """Check that a measure falls below `factor` times itself each time N is doubled."""
    values, words = doubled(case, of, method)
    return Finding(all(fine < factor * coarse for coarse, fine in pairwise(values)), words)


def never_below(case: Case, of: str, least: float) -> Finding:
    """Check that a measure of harmonics alone stays at least `least` as N is doubled."""
    values, words = doubled(case, of, "hb")
    return Finding(min(values) >= least, words)


def does_not_halve(case: Case, of: str, since: int, least: float = 0.0) -> Finding:
    """Check that a measure at N = 40 is more than half of that at N = `since`."""
    values, words = doubled(case, of, "hb")
    before = values[DOUBLED.index(since)]
    return Finding(values[-1] > max(before / 2, least), words)


def gibbs(case: Case) -> Finding:
    """Check that the overshoot before the jump is Gibbs' constant, within a third."""
    overshoot = case.measured("overshoot", "hb", MOST)
    words = f"{percent(overshoot)} of the jump; Gibbs' limit is {percent(GIBBS)}"
    return Finding(abs(overshoot / GIBBS - 1) < 1 / 3, words)


def half_way(case: Case, end: str) -> Finding:
    """Check that the acceleration is half-way down its jump at the end of stick.

    That is the end in the series or, on normalised time, in the exact orbit.
    """
    orbit = case.orbit("hb", MOST)
    motion: Any = {"series": orbit, "exact": case.exact}[end]
    place = motion.t1 / motion.period * orbit.period
    level = -float(orbit.acceleration(place)) / case.belt.largest_jump
    return Finding(abs(level - 0.5) < 0.1, f"{percent(level)} of the jump at N = {MOST}")


def falls_like(case: Case, of: str, low: float, high: float) -> Finding:
    """Check that an error of harmonics alone falls by a power of N between `low` and `high`."""
    rate = case.rate(of, "hb")
    if rate is None:
        return TOO_FEW
    words = f"like {power_of_order(rate)}"
    if of == "period":
        words += f"; {percent(abs(case.measured(of, 'hb', MOST)))} off at N = {MOST}"
    return Finding(low <= rate <= high, words)


def outside_the_band(case: Case) -> Finding:
    """Check that the period of harmonics alone stays outside the band of Fig. 4."""
    errors = {N: abs(case.measured("period", "hb", N)) for N in case.orders("hb")}
    first = min((N for N in errors if errors[N] <= BAND), default=0)
    words = f"inside from N = {first}" if first else "outside at each"
    return Finding(bool(errors) and not first, words)


def rising(case: Case, method: str) -> list[int]:
    """Return the orders whose (22) is above rounding, and larger than at the order before."""
    errors = {N: case.measured("acceleration", method, N) for N in case.orders(method)}
    above = [N for N in errors if N - 1 in errors and errors[N] > FLOORS["acceleration"]]
    return [N for N in above if errors[N] > errors[N - 1]]


def rises(case: Case, method: str, somewhere: bool) -> Finding:
    """Check that (22) rises at some order; without `somewhere`, that it rises at none."""
    orders = rising(case, method)
    holds = bool(orders) == somewhere and bool(case.orders(method))
    if not orders:
        return Finding(holds, "it never rises")
    first, *rest = orders
    pair = [case.measured("acceleration", method, N) for N in (first - 1, first)]
    digits = next(d for d in range(5, 18) if number(pair[0], d) != number(pair[1], d))
    before, after = (number(error, digits) for error in pair)
    again = f", and {'once' if len(rest) == 1 else f'{len(rest)} times'} more" if rest else ""
    return Finding(holds, f"it rises at N = {first}, from {before} to {after}{again}")


def better_period(case: Case) -> Finding:
    """Check that one C1 function makes the period better at every order."""
    behind = case.behind("period", "hb-c1", "hb")
    if behind:
        return Finding(False, f"not at {len(behind)} of them, N = {behind[0]} the first")
    errors = [percent(abs(case.measured("period", m, MOST))) for m in ("hb-c1", "hb")]
    return Finding(True, f"{' against '.join(errors)} at N = {MOST}")


def falls_faster(case: Case, of: str, powers: float) -> Finding:
    """Check that one C1 function makes an error fall by at least `powers` more powers of N."""
    with_one, without = (case.rate(of, method) for method in ("hb-c1", "hb"))
    if with_one is None or without is None:
        return TOO_FEW
    words = f"{power_of_order(with_one)} against {power_of_order(without)}"
    return Finding(with_one - without >= powers, words)


def ripple_vanishes(case: Case) -> Finding:
    """Check that the overshoot vanishes as N grows with one C1 function, and not without."""
    overshoots, words = doubled(case, "overshoot", "hb-c1")
    return Finding(overshoots[-1] < UNSEEN < case.measured("overshoot", "hb", MOST), words)


def no_ripple_at_3(case: Case) -> Finding:
    """Check that the overshoot with one C1 function is too small to be seen at N = 3."""
    beyond = (case.measured("overshoot", method, THREE) for method in ("hb-c1", "hb"))
    overshoot, without = (part if part > ROUNDING else 0.0 for part in beyond)
    words = f"{percent(overshoot, 2)} of the jump; without g₁ {percent(without, 2)}"
    return Finding(overshoot < UNSEEN, words)
