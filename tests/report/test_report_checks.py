"""The checks of Fourier series: each on a case where it holds, and one where it does not.

Where a check has a threshold, the two cases lie on its two sides.
"""

from types import SimpleNamespace

import pytest
from fakes import Fake

from nonsmooth.report.case import MOST
from nonsmooth.report.checks import fourier as checks
from nonsmooth.report.claims import CLAIMS

ALL_HB = [("hb", N) for N in range(1, MOST + 1)]


def at(*values: float):
    """Return what is measured at N = 10, 20 and 40, and at no other order."""
    return dict(zip((10, 20, 40), values, strict=True)).__getitem__


def power(exponent: float, factor: float = 1.0):
    return lambda N: factor * N**-exponent


def bump(order: int, size: float = 1.0):
    """Return an error that falls at every order but one."""
    return lambda N: size / N if order != N else 2 * size / N


def mean_square(*errors: float) -> Fake:
    return Fake(acceleration={"hb": at(*errors)})


def largest(method: str, *errors: float) -> Fake:
    return Fake(largest={method: at(*errors)})


def ripple(*over: float) -> Fake:
    return Fake(overshoot={"hb": at(*over)})


def at_40(over: float) -> Fake:
    return Fake(overshoot={"hb": {40: over}.__getitem__})


#: Where stick ends in the exact orbit at alpha = 2, as a part of the period.
END = 4 / (4 + 3.141592653589793 + 2 * 0.4636476090008061)


def level(own: float, exact: float) -> Fake:
    """Return an acceleration of so much of its jump, 20 m/s**2, at the two ends of stick."""
    heights = {0.25: own, END * 0.5: exact}

    def acceleration(t: float) -> float:
        (found,) = (height for time, height in heights.items() if abs(t - time) < 1e-9)
        return -20.0 * found

    def orbit(method: str, order: int) -> SimpleNamespace:
        assert (method, order) == ("hb", 40)
        return SimpleNamespace(t1=0.25, period=0.5, acceleration=acceleration)

    return Fake(alpha=2.0, orbit=orbit)


def two(name: str, hb, hb_c1, missing=()) -> Fake:
    return Fake(missing=missing, **{name: {"hb": hb, "hb-c1": hb_c1}})


def removed(without: float, *over: float) -> Fake:
    return Fake(overshoot={"hb": {40: without}.__getitem__, "hb-c1": at(*over)})


def at_3(over: float) -> Fake:
    return Fake(overshoot={"hb": {3: 0.2}.__getitem__, "hb-c1": {3: over}.__getitem__})


#: A check, cases where it holds, cases where it does not.
CASES = {
    checks.mean_square: (
        [mean_square(1, 0.75, 0.56)],
        [mean_square(1, 0.75, 0.57), mean_square(1, 0.76, 0.1), mean_square(1, 1, 1)],
    ),
    checks.not_uniform: (
        [largest("hb", 0.6, 0.41, 0.40)],
        [largest("hb", 0.6, 0.39, 0.5), largest("hb", 0.6, 0.5, 0.39)],
    ),
    checks.nowhere: (
        [Fake(inside={"hb": at(0.2, 0.1, 0.11)})],
        [Fake(inside={"hb": at(0.2, 0.2, 0.09)})],
    ),
    checks.gibbs: (
        [at_40(0.0895), at_40(0.119), at_40(0.060)],
        [at_40(0.120), at_40(0.059), at_40(0.0), at_40(-0.0895), at_40(0.0179)],
    ),
    checks.ripple_stays: (
        [ripple(0.09, 0.09, 0.046), ripple(0.001, 0.001, 0.011)],
        [ripple(0.09, 0.09, 0.044), ripple(0.09, 0.015, 0.0099)],
    ),
    checks.half_way_at_own_end: (
        [level(0.5, 5), level(0.41, 5), level(0.59, 5)],
        [level(0.39, 0.5), level(0.61, 0.5), level(-0.5, 0.5)],
    ),
    checks.half_way_at_exact_end: (
        [level(5, 0.5), level(5, 0.41), level(5, 0.59)],
        [level(0.5, 0.39), level(0.5, 0.61)],
    ),
    checks.slow: (
        [Fake(period={"hb": power(0.81)}), Fake(period={"hb": power(1.19)})],
        [
            Fake(period={"hb": power(0.79)}),
            Fake(period={"hb": power(1.21)}),
            Fake(period={"hb": power(1)}, missing=ALL_HB),
        ],
    ),
    checks.visible: (
        [Fake(period={"hb": lambda N: -0.00101})],
        [
            Fake(period={"hb": lambda N: -0.00099 if N == 40 else 0.1}),
            Fake(period={"hb": power(1)}, missing=ALL_HB),
        ],
    ),
    checks.slow_acceleration: (
        [Fake(acceleration={"hb": power(0.31)}), Fake(acceleration={"hb": power(0.69)})],
        [
            Fake(acceleration={"hb": power(0.29)}),
            Fake(acceleration={"hb": power(0.71)}),
            Fake(acceleration={"hb": power(0.5)}, missing=ALL_HB),
        ],
    ),
    checks.monotone: (
        [Fake(acceleration={"hb": power(1)})],
        [
            Fake(acceleration={"hb": bump(7)}),
            Fake(acceleration={"hb": bump(40)}),
            Fake(acceleration={"hb": power(1)}, missing=ALL_HB),
        ],
    ),
    checks.not_monotone: (
        [Fake(acceleration={"hb-c1": bump(7)}), Fake(acceleration={"hb-c1": bump(40)})],
        [
            Fake(acceleration={"hb-c1": power(1)}),
            Fake(acceleration={"hb-c1": bump(7, 1e-7)}),  # of rounding
        ],
    ),
    checks.better_period: (
        [two("period", power(1), power(1, -0.9))],
        [
            two("period", power(1), power(1)),
            two("period", power(1), lambda N: 2 if N == 17 else 1e-3),
            two("period", power(1), power(3, 0.5), missing=[("hb-c1", 3)]),
        ],
    ),
    checks.faster_period: (
        [two("period", power(1), power(2.01))],
        [two("period", power(1), power(1.99)), two("period", power(3), power(1))],
    ),
    checks.faster_acceleration: (
        [two("acceleration", power(0.5), power(1.01))],
        [two("acceleration", power(0.5), power(0.99)), two("acceleration", power(1), power(0))],
    ),
    checks.ripple_vanishes: (
        [removed(0.011, 0.05, 0.02, 0.009)],
        [removed(0.09, 0.05, 0.02, 0.011), removed(0.0095, 0.05, 0.02, 0.009)],
    ),
    checks.no_ripple_at_3: ([at_3(0.0099), at_3(-0.1)], [at_3(0.0101)]),
    checks.uniform: (
        [largest("hb-c1", 1, 0.69, 0.48)],
        [largest("hb-c1", 1, 0.71, 0.3), largest("hb-c1", 1, 0.5, 0.36)],
    ),
}


@pytest.mark.parametrize("check", CASES, ids=lambda check: check.__name__)
def test_a_check_holds_where_it_should_and_not_where_it_should_not(check) -> None:
    holds, not_so = CASES[check]
    for number, case in enumerate(holds):
        assert check(case).holds, (number, check(case).numbers)
    for number, case in enumerate(not_so):
        assert not check(case).holds, (number, check(case).numbers)


def test_no_check_of_the_claims_is_left_out() -> None:
    used = {part.check for claim in CLAIMS for part in claim.parts}
    assert {check for check in used if check.__module__ == checks.__name__} == set(CASES)


def test_findings_have_the_numbers_that_were_measured() -> None:
    assert checks.gibbs(at_40(0.12)).numbers == "12.0 % of the jump; Gibbs' limit is 8.95 %"
    found = checks.mean_square(mean_square(1, 0.75, 0.56)).numbers
    assert found == "100 %, 75 % and 56 % at N = 10, 20 and 40"
    assert checks.slow(Fake(period={"hb": power(1, -0.1)})).numbers == (
        "like N⁻¹·⁰⁰; 0.250 % off at N = 40"
    )
    assert checks.visible(Fake(period={"hb": power(2, 0.1)})).numbers == "inside from N = 10"
    assert checks.monotone(Fake(acceleration={"hb": bump(4)})).numbers == (
        "it rises at N = 4, from 0.33333 to 0.50000"
    )
    hardly = {14: 0.033930, 15: 0.033930 * (1 + 2e-6)}
    case = Fake(acceleration={"hb": lambda N: hardly.get(N, 1 / N)})
    assert "from 0.0339300 to 0.0339301, and once more" in checks.monotone(case).numbers
    found = checks.faster_period(two("period", power(1), power(3))).numbers
    assert found == "N⁻³·⁰⁰ against N⁻¹·⁰⁰"
    found = checks.better_period(two("period", power(1), power(1, 0.5))).numbers
    assert found == "1.25 % against 2.50 % at N = 40"
    found = checks.no_ripple_at_3(at_3(0.005)).numbers
    assert found == "0.50 % of the jump; without g₁ 20 %"
    assert checks.half_way_at_own_end(level(0.45, 5)).numbers == "45.0 % of the jump at N = 40"
