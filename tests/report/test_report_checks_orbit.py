"""The checks of the exact orbit and of g1: each on a motion where it does not hold."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from fakes import Fake

from nonsmooth.report.case import Case
from nonsmooth.report.checks import orbit as checks
from nonsmooth.report.claims import CLAIMS
from nonsmooth.report.finding import Finding
from nonsmooth.solver.shortcuts.orbit import exact
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT

ALPHAS = (0.01, 1.0, 50.0)

Wrong = Callable[[float, np.ndarray, int], np.ndarray]


@pytest.fixture
def with_motion(monkeypatch) -> Callable[..., Finding]:
    """Return a caller of a check on the exact motion and something added to it."""

    def call(check, added: Wrong, alpha: float = 1.0) -> Finding:
        right = exact.evaluate

        def wrong(alpha: float, t: np.ndarray, derivative: int) -> np.ndarray:
            return right(alpha, t, derivative) + added(alpha, t, derivative)

        with monkeypatch.context() as patch:
            patch.setattr(exact, "evaluate", wrong)
            return check(Fake(alpha=alpha))

    return call


def step(of: int, height: float) -> Wrong:
    """Return a jump of one derivative at the end of stick, gone when slip ends."""

    def added(alpha: float, t: np.ndarray, derivative: int) -> np.ndarray:
        t1, T = exact.times(alpha)
        inside = (t >= t1) & (t < (t1 + T) / 2)
        return height * inside * (derivative == of)

    return added


def slope_at_end(alpha: float, t: np.ndarray, derivative: int) -> np.ndarray:
    """Return what takes away the jump of the acceleration at the end of slip."""
    t1, T = exact.times(alpha)
    return -alpha * (t > (t1 + T) / 2) * (derivative == 2)


@pytest.mark.parametrize("alpha", ALPHAS)
def test_the_exact_orbit_passes(alpha: float) -> None:
    for check in (checks.smooth, checks.never_faster, checks.centred, checks.g1_is_c1):
        assert check(Fake(alpha=alpha)).holds


@pytest.mark.parametrize("added", [step(0, 1e-9), step(1, -1e-9), step(2, 0.1), slope_at_end])
def test_an_orbit_that_is_not_c1_or_smoother_is_found(with_motion, added: Wrong) -> None:
    assert not with_motion(checks.smooth, added).holds


def test_the_jump_of_the_acceleration_is_given_in_si() -> None:
    numbers = checks.smooth(Fake(alpha=0.5)).numbers
    assert numbers == "the acceleration falls by 5.00 m/s² at both"  # 0.25 x 200 N / 10 kg


def test_a_mass_that_is_faster_than_the_belt_is_found(with_motion) -> None:
    assert not with_motion(checks.never_faster, lambda alpha, t, d: 1e-9 * (d == 1)).holds
    assert with_motion(checks.never_faster, step(0, 1.0)).holds


def test_an_orbit_about_another_place_is_found(with_motion) -> None:
    assert not with_motion(checks.centred, lambda alpha, t, d: 1e-9 * (d == 0)).holds
    assert checks.centred(Fake()).numbers == "x_s = 0.100 m"


@pytest.mark.parametrize(
    ("mu_k", "holds", "least"), [(0.25, True, "0"), (0.24, False, "−8.00"), (0.4, True, "120")]
)
def test_friction_against_the_belt_is_found(mu_k: float, holds: bool, least: str) -> None:
    found = checks.friction_drives(Case(replace(DEFAULT, mu_k=mu_k)))
    assert found == Finding(holds, f"least friction in stick, K x(0): {least} N")


@pytest.mark.parametrize("of", [0, 1])
def test_a_g1_that_is_not_c1_is_found(of: int, monkeypatch) -> None:
    right = checks.smoothstep

    def wrong(t1: float, T: float, t: np.ndarray, derivative: int) -> np.ndarray:
        return right(t1, T, t, derivative) + 1e-9 * (t >= t1) * (derivative == of)

    assert checks.g1_is_c1(Fake()).holds
    monkeypatch.setattr(checks, "smoothstep", wrong)
    assert not checks.g1_is_c1(Fake()).holds


@pytest.mark.parametrize(("last", "holds"), [(40, True), (41, False)])
def test_a_sum_of_40_harmonics_is_told_from_one_of_41(
    last: int, holds: bool, monkeypatch
) -> None:
    def harmonics(t1: float, T: float, t: np.ndarray, derivative: int) -> np.ndarray:
        phase = 2 * np.pi * t / T
        return 5 + sum(np.sin(n * phase + n) / n for n in (1, 7, last))

    assert not checks.in_span_of_harmonics(Fake()).holds
    monkeypatch.setattr(checks, "smoothstep", harmonics)
    found = checks.in_span_of_harmonics(Fake())
    assert found.holds is holds
    share = (1 / 41) / (1 + 1 / 49 + 1 / 41**2) ** 0.5
    if not holds:
        assert found.numbers.startswith(f"{100 * share:.2f} % of g₁")


def test_no_check_of_the_claims_is_left_out() -> None:
    used = {part.check for claim in CLAIMS for part in claim.parts}
    assert {check for check in used if check.__module__ == checks.__name__} == {
        checks.smooth,
        checks.never_faster,
        checks.centred,
        checks.friction_drives,
        checks.g1_is_c1,
        checks.in_span_of_harmonics,
    }
