"""The checks of the C1 series: each on a case where it holds, and one where it does not."""

from types import SimpleNamespace

import numpy as np
import pytest
from fakes import Fake

import nonsmooth as ns
from nonsmooth.report.checks import c1 as checks
from nonsmooth.report.claims import CLAIMS
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT


def c1(error) -> Fake:
    """Return a case with this period error of the C1 series alone."""
    return Fake(period={"c1": error})


def from_order(first: int, name: str = "period") -> Fake:
    """Return a case where the C1 series is better than hb-c1 from an order on."""
    measured = {"hb-c1": lambda N: -1e-2, "c1": lambda N: 2e-2 if first > N else -5e-3}
    return Fake(**{name: measured})


def only_at(bad: int, ours: float = 2e-2) -> Fake:
    return Fake(
        period={"hb-c1": lambda N: -1e-2, "c1": lambda N: ours if bad == N else 1e-3},
    )


def falling(N: int) -> float:
    return 10.0**-N


def alternating(N: int) -> float:
    return (-0.1) ** N


def except_at(order: int, value: float, error=falling) -> Fake:
    return c1(lambda N: value if order == N else error(N))


def in_band(order: int, error: float) -> Fake:
    return except_at(order, error, lambda N: 1e-3 if N > 3 else 1e-2)


def at_three(hb: float, hb_c1: float, polynomial: float) -> Fake:
    errors = {"hb": hb, "hb-c1": hb_c1, "c1": polynomial}
    return Fake(acceleration={m: {3: error}.__getitem__ for m, error in errors.items()})


def sticking(value: float, missing: tuple[int, ...] = ()) -> Fake:
    def orbit(method: str, order: int) -> SimpleNamespace:
        assert method == "c1"
        moves = value if order == (3 if missing else 1) else 1.0
        values = np.zeros(99)
        values[50] = moves
        return SimpleNamespace(t1=0.2, acceleration=lambda t: values[: len(t)])

    return Fake(orbit=orbit, missing=[("c1", N) for N in missing])


def unseen(*errors: float) -> Fake:
    return Fake(largest={"c1": dict(zip((5, 10), errors, strict=True)).__getitem__})


def derivatives(slow: int | None = None, wrong_jerk: float = 0.0) -> Fake:
    """Return real orbits, one largest error of which falls too slowly, or the last jerk."""

    def largest(N: int, derivative: int = 2) -> float:
        return (0.5 if derivative == slow else 0.1) ** (N - 8)

    def orbit(method: str, order: int) -> SimpleNamespace:
        z = ns.solve(DEFAULT, "c1", order).unknowns.copy()
        if order == 15:
            z[5] += wrong_jerk
        return SimpleNamespace(unknowns=z)

    return Fake(largest={"c1": largest}, orbit=orbit)


def steps(odd: float, even: float, missing: tuple[int, ...] = ()) -> Fake:
    """Return (22) that falls by one factor at odd orders, and by another at even ones."""

    def error(N: int) -> float:
        return float(odd ** -((N - 1) // 2) * even ** -(N // 2))

    return Fake(acceleration={"c1": error}, missing=[("c1", N) for N in missing])


def without_orbit_at_4(alpha: float) -> Fake:
    """Return a case whose only solution at N = 4 is one whose stick ends too early."""
    period = {"c1": lambda N: 1e-4 * 10.0**-N}
    return Fake(alpha=alpha, missing=[("c1", 4)], period=period)


#: A check, cases where it holds, cases where it does not.
CASES = {
    checks.overtakes: ([from_order(20), from_order(1)], [from_order(21), from_order(41)]),
    checks.overtakes_acceleration: (
        [from_order(20, "acceleration")],
        [from_order(21, "acceleration")],
    ),
    checks.beyond_three: ([only_at(3), only_at(1)], [only_at(4), only_at(40)]),
    checks.behind_at_three: ([only_at(3)], [only_at(3, 0.99e-2), only_at(4)]),
    checks.in_band_beyond_three: (
        [in_band(17, -1e-3), in_band(3, 0.5)],
        [in_band(4, -1.01e-3), in_band(17, 1.01e-3)],
    ),
    checks.in_band_from_three: ([in_band(3, -0.99e-3)], [in_band(3, -1.01e-3)]),
    checks.in_band_with_any_solution: (
        [without_orbit_at_4(0.86), in_band(3, 0.5)],
        [without_orbit_at_4(0.85), in_band(4, 1.01e-3), in_band(17, -1.01e-3)],
    ),
    checks.shrinks: (
        [c1(falling), c1(alternating), except_at(3, 1e-6)],
        [except_at(9, 1e-8), except_at(9, -1.1e-8), except_at(4, 1e-6)],
    ),
    checks.one_sided: (
        [c1(falling), except_at(3, -1.0)],
        [c1(alternating), except_at(9, -1e-9)],
    ),
    checks.poorest: (
        [at_three(0.2, 0.19, 0.19)],
        [at_three(0.2, 0.21, 0.1), at_three(0.2, 0.1, 0.21)],
    ),
    checks.stick_is_exact: (
        [sticking(0.0), sticking(0.0, missing=(1, 2))],
        [sticking(1e-300), sticking(-1e-300), sticking(1e-300, missing=(1, 2))],
    ),
    checks.no_ripple: ([unseen(0.5, 0.0099)], [unseen(0.001, 0.0101)]),
    checks.all_derivatives: (
        [derivatives()],
        [*(derivatives(slow=d) for d in (0, 1, 2)), derivatives(wrong_jerk=1e-6)],
    ),
    checks.stairs: (
        [steps(2.1, 1.9), steps(10, 0.9)],
        [steps(1.9, 1.1), steps(10, 2.1), steps(1, 10), steps(10, 1, tuple(range(3, 41)))],
    ),
    checks.even_add_nothing: (
        [steps(10, 1.009), steps(10, 0.991)],
        [steps(10, 1.011), steps(10, 0.989), steps(10, 1, tuple(range(3, 41)))],
    ),
}  # fmt: skip


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
    assert checks.overtakes(from_order(20)).numbers == "from N = 20 on"
    assert checks.overtakes(from_order(41)).numbers == "not by then"
    assert checks.beyond_three(only_at(9)).numbers == "2.00 % off against 1.00 % at N = 9"
    assert checks.behind_at_three(only_at(3)).numbers == "2.00 % off against 1.00 %"
    assert checks.in_band_beyond_three(in_band(17, -0.02)).numbers == (
        "at worst −2.00 %, at N = 17"
    )
    assert checks.shrinks(except_at(9, 1e-8)).numbers == "it grows at N = 9"
    assert checks.shrinks(c1(falling)).numbers == "to rounding at N = 13"
    assert checks.one_sided(except_at(9, -1e-9)).numbers == "it crosses at N = 9 and 10"
    found = checks.in_band_with_any_solution(without_orbit_at_4(0.3)).numbers
    assert found == "at N = 4 there is none of a slip shorter than a natural period"
    assert checks.poorest(at_three(0.2, 0.19, 0.1)).numbers == (
        "hb 20.0 %, hb-c1 19.0 %, c1 10.0 %"
    )
    assert checks.stairs(steps(4, 0.5)).numbers == (
        "by factors of 4.0 to 4.0 at odd orders, 0.50 to 0.50 at even ones"
    )
    found = checks.even_add_nothing(steps(10, 0.5)).numbers
    assert found.startswith("it changes by 100 % at N = ")
    assert " and grows at N = 4, 6" in found
