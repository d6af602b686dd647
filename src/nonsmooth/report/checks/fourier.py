"""Checks of classical harmonic balance (3.1), and of one C1 function beside it (3.2)."""

from itertools import pairwise

from nonsmooth.solver.shortcuts.accuracy.convergence import FLOORS
from nonsmooth.solver.shortcuts.orbit import exact

from ..case import MOST, Case
from ..finding import Finding
from ..words import listed, number, percent, power_of_order, times

#: Gibbs' constant: the overshoot of a Fourier series, in jumps.
GIBBS = 0.0894898722360836

#: The band of the period that the paper names in Fig. 4.
BAND = 1e-3

#: Overshoot, in jumps, that nobody sees in a figure.
UNSEEN = 0.01

ORDERS = range(1, MOST + 1)
DOUBLED = (10, 20, 40)


def over_doubled(values: list[float], of: str = "") -> str:
    """Return three measurements at N = 10, 20 and 40, in words."""
    return f"{listed([percent(value, 2) for value in values])}{of} at N = 10, 20 and 40"


def mean_square(case: Case) -> Finding:
    """Return whether (22) goes to zero, and no slower than ``N**-0.4``."""
    errors = [case.acceleration_error("hb", N) for N in DOUBLED]
    falls = all(fine < coarse * 2**-0.4 for coarse, fine in pairwise(errors))
    return Finding(falls, over_doubled(errors))


def not_uniform(case: Case) -> Finding:
    """Return whether the largest error of the acceleration stays a part of the jump."""
    errors = [case.largest_error("hb", N) for N in DOUBLED]
    return Finding(min(errors) >= 0.4, over_doubled(errors, " of the jump"))


def nowhere(case: Case) -> Finding:
    """Return whether the error stays as large away from the jumps."""
    errors = [case.error_inside("hb", N) for N in DOUBLED]
    return Finding(errors[2] > errors[0] / 2, over_doubled(errors, " of the jump"))


def gibbs(case: Case) -> Finding:
    """Return whether the ripple before the jump is what Gibbs' constant says."""
    over = case.overshoot("hb", MOST)
    words = f"{percent(over)} of the jump; Gibbs' limit is {percent(GIBBS)}"
    return Finding(abs(over / GIBBS - 1) < 1 / 3, words)


def ripple_stays(case: Case) -> Finding:
    """Return whether the ripple does not shrink with N."""
    over = [case.overshoot("hb", N) for N in DOUBLED]
    return Finding(over[2] > max(over[1] / 2, UNSEEN), over_doubled(over, " of the jump"))


def _level(case: Case, part: float) -> Finding:
    """Return whether the acceleration is half-way down its jump at `part` of the period."""
    orbit = case.orbit("hb", MOST)
    jump = case.alpha * case.belt.acceleration_unit
    level = -float(orbit.acceleration(part * orbit.period)) / jump
    return Finding(abs(level - 0.5) < 0.1, f"{percent(level)} of the jump at N = {MOST}")


def half_way_at_own_end(case: Case) -> Finding:
    """Return whether the series takes the mean where its own stick ends."""
    orbit = case.orbit("hb", MOST)
    return _level(case, orbit.t1 / orbit.period)


def half_way_at_exact_end(case: Case) -> Finding:
    """Return whether it takes the mean where the exact stick ends, on normalised time."""
    t1, T = exact.times(case.alpha)
    return _level(case, t1 / T)


def slow(case: Case) -> Finding:
    """Return whether the period error falls about like 1/N."""
    rate = case.rates("hb").period
    if rate is None:
        return Finding(False, "too few orders have an orbit")
    error = abs(case.period_error("hb", MOST))
    words = f"like {power_of_order(rate)}; {percent(error)} off at N = {MOST}"
    return Finding(0.8 <= rate <= 1.2, words)


def visible(case: Case) -> Finding:
    """Return whether the period stays outside the band of Fig. 4."""
    errors = {N: abs(case.period_error("hb", N)) for N in case.orders("hb")}
    inside = min((N for N in errors if errors[N] <= BAND), default=0)
    words = f"inside from N = {inside}" if inside else "outside at each"
    return Finding(bool(errors) and not inside, words)


def slow_acceleration(case: Case) -> Finding:
    """Return whether (22) falls about like the square root of 1/N."""
    rate = case.rates("hb").acceleration
    if rate is None:
        return Finding(False, "too few orders have an orbit")
    return Finding(0.3 <= rate <= 0.7, f"like {power_of_order(rate)}")


def rises(case: Case, method: str) -> list[int]:
    """Return the orders at which (22) is larger than at the order before, not by rounding."""
    errors = {N: case.acceleration_error(method, N) for N in case.orders(method)}
    above = [N for N in errors if N - 1 in errors and errors[N] > FLOORS["acceleration"]]
    return [N for N in above if errors[N] > errors[N - 1]]


def _in_words(case: Case, method: str, orders: list[int]) -> str:
    if not orders:
        return "it never rises"
    pair = [case.acceleration_error(method, N) for N in (orders[0] - 1, orders[0])]
    digits = next(d for d in range(5, 18) if number(pair[0], d) != number(pair[1], d))
    before, after = (number(error, digits) for error in pair)
    words = f"it rises at N = {orders[0]}, from {before} to {after}"
    return words + (f", and {times(len(orders) - 1)} more" if orders[1:] else "")


def monotone(case: Case) -> Finding:
    """Return whether (22) of the harmonics falls at every order."""
    found = rises(case, "hb")
    return Finding(bool(case.orders("hb")) and not found, _in_words(case, "hb", found))


def not_monotone(case: Case) -> Finding:
    """Return whether (22) with one C1 function rises somewhere."""
    found = rises(case, "hb-c1")
    return Finding(bool(found), _in_words(case, "hb-c1", found))


def better_period(case: Case) -> Finding:
    """Return whether one C1 function makes the period better at every order."""
    behind = case.behind("period", "hb-c1", "hb")
    if behind:
        return Finding(False, f"not at {len(behind)} of them, N = {behind[0]} the first")
    errors = [percent(abs(case.period_error(m, MOST))) for m in ("hb-c1", "hb")]
    return Finding(True, f"{' against '.join(errors)} at N = {MOST}")


def _two_rates(case: Case, name: str, least: float) -> Finding:
    rates = [getattr(case.rates(method), name) for method in ("hb", "hb-c1")]
    if None in rates:
        return Finding(False, "too few orders have an orbit")
    words = " against ".join(power_of_order(rate) for rate in reversed(rates))
    return Finding(rates[1] - rates[0] >= least, words)


def faster_period(case: Case) -> Finding:
    """Return whether the period gains an order of convergence."""
    return _two_rates(case, "period", 1.0)


def faster_acceleration(case: Case) -> Finding:
    """Return whether (22) gains half an order of convergence."""
    return _two_rates(case, "acceleration", 0.5)


def ripple_vanishes(case: Case) -> Finding:
    """Return whether one C1 function makes the ripple go away with N."""
    over, without = [case.overshoot("hb-c1", N) for N in DOUBLED], case.overshoot("hb", MOST)
    return Finding(over[2] < UNSEEN < without, over_doubled(over, " of the jump"))


def no_ripple_at_3(case: Case) -> Finding:
    """Return whether it is gone already at the order of Fig. 5."""
    over, without = (max(case.overshoot(method, 3), 0.0) for method in ("hb-c1", "hb"))
    words = f"{percent(over, 2)} of the jump; without g₁ {percent(without, 2)}"
    return Finding(over < UNSEEN, words)


def uniform(case: Case) -> Finding:
    """Return whether the largest error goes to zero, the phases laid over each other."""
    errors = [case.largest_error("hb-c1", N) for N in DOUBLED]
    falls = all(fine < 0.7 * coarse for coarse, fine in pairwise(errors))
    return Finding(falls, over_doubled(errors, " of the jump"))
