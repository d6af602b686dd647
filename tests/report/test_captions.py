"""What stands beside the figures: every sentence, and every number in it against the rows."""

import math
import re
from functools import cache
from types import SimpleNamespace

import numpy as np
import pytest

pytest.importorskip("matplotlib")
pytest.importorskip("jinja2")

from computed import LIGHT, ODD, Exact, acceleration_errors, case, period_errors, rate
from fakes import Fake
from paper import METHODS
from written import value

import nonsmooth as ns
from nonsmooth.report.captions import PLATES, other_tests, reading
from nonsmooth.report.case import DEFAULT

BELTS = pytest.mark.parametrize("belt", [DEFAULT, ODD, LIGHT], ids=["default", "odd", "light"])

#: Three digits are shown.
SHOWN = 5.001e-3

#: How (22) is read, before the order and what the other reading gives.
READING = (
    "(22) is over normalised time t/T, our reading of (21); compared at equal times t it would "
    "be, at N ="
)


@cache
def at_equal_times(belt: ns.StickSlip, method: str, order: int) -> float:
    """Return (22) at equal times, by midpoints: far more of them than the harmonics resolve."""
    orbit, reference = ns.solve(belt, method, order), Exact(belt)
    part = (np.arange(20_000) + 0.5) / 20_000
    expected = reference.motion(part, 2)
    found = orbit.acceleration(part * reference.period % orbit.period)
    return float(np.linalg.norm(found - expected) / np.linalg.norm(expected))


def numbers(text: str, sentence: str) -> list[float]:
    """Return the numbers in a text, which is this sentence with a # for each of them."""
    pattern = re.escape(sentence).replace(r"\#", r"(\S+?)").replace("#", r"(\S+?)")
    found = re.fullmatch(pattern, text)
    assert found, text
    return [value(group) for group in found.groups()]


def close(*expected: float):
    return pytest.approx(expected, rel=SHOWN)


def percent(part: float) -> float:
    """Return a part of one in percent."""
    return 100 * part


@BELTS
def test_the_oscillator_and_its_exact_orbit_are_described(belt: ns.StickSlip) -> None:
    sentence = (
        "A mass M = # kg on a spring K = # N/m lies on a belt that moves at V = # m/s, and is "
        "pressed to it by F_N = # N. It sticks until the spring pulls with μ_s F_N = # N; "
        "then it slips back, held by no more than μ_k F_N = # N, until it is as fast as the "
        "belt again."
    )
    parameters = (belt.mass, belt.stiffness, belt.belt_speed, belt.normal_force)
    static, kinetic = belt.mu_s * belt.normal_force, belt.mu_k * belt.normal_force
    assert numbers(PLATES[0].text(case(belt)), sentence) == close(*parameters, static, kinetic)
    sentence = (
        "From A to B the mass sticks, for # s, # % of the period of # s; from B back to A it "
        "slips. The displacement is smooth, the velocity has two kinks, and the acceleration "
        "jumps there, by # m/s². That is what a series of smooth functions cannot do."
    )
    orbit = Exact(belt)
    t1, share, period, jump = numbers(PLATES[1].text(case(belt)), sentence)
    assert (t1, period, jump) == close(orbit.t1, orbit.period, orbit.jump)
    assert share == pytest.approx(percent(orbit.t1 / orbit.period), rel=0.05)  # two digits


@BELTS
def test_the_overshoot_of_many_harmonics_is_described(belt: ns.StickSlip) -> None:
    sentence = (
        "Even with N = 40 harmonics the series overshoots beside each jump, in stick by # % of "
        "it, # s before stick ends. More harmonics make the ripple narrower, not lower: Gibbs' "
        "phenomenon. Only the mean square of the error, (22), goes to zero; here it is # %. "
        f"{READING} 40, hb # % instead of # %."
    )
    orbit = ns.solve(belt, "hb", 40)
    times = np.linspace(orbit.t1 / 2, orbit.t1, 4_001)
    ripple = orbit.acceleration(times)
    over, before, error, other, same = numbers(PLATES[2].text(case(belt)), sentence)
    expected = ripple.max() / Exact(belt).jump, at_equal_times(belt, "hb", 40)
    known = acceleration_errors(belt, "hb")[40]
    assert (over, other, error) == close(*map(percent, (*expected, known)))
    assert same == error
    # the report takes it from half as many times
    ended = orbit.t1 - times[ripple.argmax()]
    assert before == pytest.approx(ended, rel=SHOWN, abs=orbit.t1 / 4000)


#: From which order on each method is within 0.1 % (41: not by 40), and how that is said.
BAND = "within 0.1 % of the exact period (grey band)"
INSIDE = {
    DEFAULT: (
        (41, 4, 4),
        f"hb-c1 and c1 stay {BAND} from N = 4 on; hb is still outside at N = 40.",
    ),
    ODD: (
        (41, 6, 4),
        f"c1 stays {BAND} from N = 4 on; hb-c1 from N = 6 on; hb is still outside at N = 40.",
    ),
    LIGHT: ((1, 1, 7), f"hb and hb-c1 stay {BAND} from N = 1 on; c1 from N = 7 on."),
}


def first_inside(belt: ns.StickSlip, method: str) -> int:
    """Return from which order on the period is within 0.1 %, from the rows."""
    errors = period_errors(belt, method)
    outside = [N for N in range(1, 41) if abs(errors.get(N, math.inf)) > 1e-3]
    return max(outside, default=0) + 1


@BELTS
def test_the_convergence_of_the_period_is_described(belt: ns.StickSlip) -> None:
    ours, theirs = (period_errors(belt, method) for method in ("c1", "hb-c1"))
    behind = [N for N in range(1, 13) if abs(ours.get(N, math.inf)) >= abs(theirs[N])]
    assert tuple(first_inside(belt, method) for method in METHODS) == INSIDE[belt][0]
    sentence = (
        f"{INSIDE[belt][1]} The C¹ series stays ahead from N = {behind[-1] + 1} on, and it "
        "gains # digits with each order, until rounding stops it. The second picture (not in "
        "the paper) has a logarithmic scale: on a linear one all three look converged."
    )
    (gain,) = numbers(PLATES[3].text(case(belt)), sentence)
    assert gain == pytest.approx(rate(belt, "period", "c1"), rel=0.05)  # two digits
    assert gain == pytest.approx(math.log10(abs(ours[7] / ours[11])) / 4, rel=0.2)


def test_a_period_that_stays_behind_or_ahead_is_said_to() -> None:
    def text(error: float) -> str:
        errors = {"hb": 0.1, "hb-c1": 0.01, "c1": error}
        made = {("period", method): lambda N, e=e: e for method, e in errors.items()}
        return PLATES[3].text(Fake(made))

    outside = "are still outside 0.1 % of the exact period (grey band) at N = 40. "
    assert f"hb, hb-c1 and c1 {outside}The C¹ series does not overtake" in text(0.02)
    ahead = f"c1 stays {BAND} from N = 1 on; hb and hb-c1 are still outside at N = 40. "
    assert f"{ahead}The C¹ series is ahead at every order" in text(0.001)


def test_an_orbit_that_is_missing_is_said_to_be() -> None:
    without = Fake(missing=[("hb", 40)])
    assert PLATES[2].text(without) == "In this case hb has no orbit at N = 40."
    assert reading(without, 40) == f"{READING.partition(';')[0]}."


@BELTS
def test_the_errors_of_the_three_methods_at_one_order_are_described(
    belt: ns.StickSlip,
) -> None:
    errors = {m: acceleration_errors(belt, m).get(3) for m in METHODS}
    *first, last = [f"{m} # %" for m in METHODS if errors[m] is not None]
    other = ", ".join(f"{text} instead of # %" for text in first)
    sentence = (
        "At the same order N = 3 the harmonics alone cannot jump at all; those with one C¹ "
        "function can, and so can the C¹ series, whose stick is exact. Error (22): "
        f"{', '.join(first)} and {last}. {READING} 3, {other} and {last} instead of # %."
    )
    expected = [percent(error) for error in errors.values() if error is not None]
    for method, error in errors.items():
        if error is not None:
            expected += [percent(at_equal_times(belt, method, 3)), percent(error)]
    assert numbers(PLATES[4].text(case(belt)), sentence) == close(*expected)


def rises(belt: ns.StickSlip, method: str) -> int:
    """Return how often (22) is larger than at the order before, and not by rounding."""
    errors = acceleration_errors(belt, method)
    return sum(errors[N] > max(errors.get(N - 1, math.inf), 1e-6) for N in errors)


@BELTS
def test_the_convergence_of_the_acceleration_is_described(belt: ns.StickSlip) -> None:
    up = [f"{method} {rises(belt, method)}" for method in METHODS]
    sentence = (
        "The error falls slowly in Fourier series, hb like N# and hb-c1 like N#; in the C¹ "
        "series it goes down in stairs, two orders to a step. Number of orders from N = 2 to "
        "40 at which it is larger than at the order before: "
        f"{up[0]}, {up[1]} and {up[2]}. {READING} 40, hb # % instead of # %."
    )
    *fall, other, same = numbers(PLATES[5].text(case(belt)), sentence)
    assert (other, same) == close(
        percent(at_equal_times(belt, "hb", 40)), percent(acceleration_errors(belt, "hb")[40])
    )
    rates = [-rate(belt, "acceleration", method) for method in ("hb", "hb-c1")]
    assert fall == pytest.approx(rates, abs=0.00501)


@BELTS
def test_the_command_of_a_plate_draws_this_oscillator(belt: ns.StickSlip) -> None:
    flags = [
        f"--{name.replace('_', '-')} {value:g}"
        for name, value in belt.values.items()
        if value != getattr(DEFAULT, name)
    ]
    for number, plate in enumerate(PLATES, 1):
        words = ["nonsmooth report --figure", str(number), *flags, f"-o fig{number}.pdf"]
        assert plate.command(belt) == " ".join(words)
        assert plate.title.startswith(f"Fig. {number}: ")


@BELTS
def test_the_series_that_is_ours_is_told_from_the_papers(belt: ns.StickSlip) -> None:
    sentence = "At N = 8 the period is # % off with its tests and # % with these."
    generic = ns.solve(belt, "ck-tau", 8)
    errors = period_errors(belt, "c1")[8], generic.period / Exact(belt).period - 1
    expected = [percent(abs(error)) for error in errors]
    assert numbers(other_tests(case(belt)), sentence) == close(*expected)


@pytest.mark.parametrize("missing", ["c1", "c1-tau"])
def test_a_series_without_an_orbit_is_told_instead(missing: str) -> None:
    orbit = SimpleNamespace(period=0.6)
    text = other_tests(Fake(orbit=lambda method, N: orbit, missing=[(missing, 8)]))
    assert text == f"In this case {missing} has no orbit at N = 8."


def test_an_error_that_rises_is_not_said_to_fall() -> None:
    """So does that with one C1 function, where slip is too short for its harmonics."""
    by_order = {"hb": lambda N: N**-0.5, "hb-c1": lambda N: 0.01 * N, "c1": lambda N: 0.1**N}
    kinds = ("acceleration", "acceleration at equal times")
    made = Fake({(kind, m): error for m, error in by_order.items() for kind in kinds})
    text = PLATES[5].text(made)
    assert "hb like N" in text
    assert "hb-c1 like" not in text
