"""The checks of the exact orbit and of g1: each on a motion where it does not hold."""

from types import SimpleNamespace

import numpy as np
import pytest
from fakes import Fake
from paper import Problem

import nonsmooth as ns
from nonsmooth.report.case import DEFAULT, Case
from nonsmooth.report.checks import Finding, motion

QUANTITIES = ("displacement", "velocity", "acceleration")


def wrong(alpha: float = 1.0, **added) -> Fake:
    """Return a case whose exact orbit has something added: a function of t, t1 and T."""
    exact = Fake(alpha=alpha).exact

    def changed(quantity: str):
        right = getattr(exact, quantity)
        more = added.get(quantity, lambda t, t1, T: 0)
        return lambda t: right(t) + more(np.asarray(t), exact.t1, exact.period)

    quantities = {quantity: changed(quantity) for quantity in QUANTITIES}
    own = {"t1": exact.t1, "period": exact.period}
    return Fake(alpha=alpha, exact=SimpleNamespace(**own, **quantities))


def step(height: float):
    """Return a jump at the end of stick, gone when slip ends."""
    return lambda t, t1, T: height * ((t >= t1) & (t < (t1 + T) / 2))


@pytest.mark.parametrize("alpha", [1e-8, 0.01, 1.0, 50.0, 1e5, 1e6])
def test_the_exact_orbit_passes(alpha: float) -> None:
    for check in (motion.smooth, motion.never_faster, motion.centred, motion.g1_is_c1):
        assert check(Fake(alpha=alpha)).holds


@pytest.mark.parametrize(
    "added",
    [
        {"displacement": step(1e-10)},
        {"velocity": step(-1e-9)},
        {"acceleration": step(0.1)},
        {"acceleration": lambda t, t1, T: -10 * (t > (t1 + T) / 2)},  # the jump at the end
    ],
)
def test_an_orbit_that_is_not_c1_or_smoother_is_found(added) -> None:
    assert motion.smooth(wrong()).holds
    assert not motion.smooth(wrong(**added)).holds


def test_a_mass_that_is_faster_than_the_belt_is_found() -> None:
    assert motion.never_faster(wrong(displacement=step(1.0))).holds
    assert not motion.never_faster(wrong(velocity=lambda t, t1, T: 1e-9)).holds


def test_an_orbit_about_another_place_is_found() -> None:
    assert not motion.centred(wrong(displacement=lambda t, t1, T: 1e-10)).holds


@pytest.mark.parametrize(
    ("mu_k", "holds", "least"), [(0.25, True, "0"), (0.24, False, "−8.00"), (0.4, True, "120")]
)
def test_friction_against_the_belt_is_found(mu_k: float, holds: bool, least: str) -> None:
    found = motion.friction_drives(Case(ns.StickSlip(**{**DEFAULT.values, "mu_k": mu_k})))
    assert found == Finding(holds, f"least friction in stick, K x(0): {least} N")


@pytest.mark.parametrize("of", [0, 1])
def test_a_g1_that_is_not_c1_is_found(of: int, monkeypatch) -> None:
    right = motion.g1

    def changed(t1: float, T: float, t: np.ndarray, derivative: int) -> np.ndarray:
        return right(t1, T, t, derivative) + 1e-9 * (t >= t1) * (derivative == of)

    monkeypatch.setattr(motion, "g1", changed)
    assert not motion.g1_is_c1(Fake()).holds


def test_g1_is_that_of_an_orbit() -> None:
    """The motion (11) of a large g1 is that function: its harmonics are taken away."""
    orbit = ns.solve(DEFAULT, "hb-c1", 3)
    t = np.linspace(0, orbit.period, 200, endpoint=False)
    own, beside = orbit.coefficients, np.zeros_like(t)
    for n, (a, b) in enumerate(zip(own["a"], own["b"], strict=True), 1):
        angle = 2 * np.pi * n * t / orbit.period
        beside += a * np.sin(angle) + b * np.cos(angle)
    size = own["c1"] * orbit.period * (orbit.period - orbit.t1) ** 3
    found = own["a0"] / 2 + beside + size * motion.g1(orbit.t1, orbit.period, t, 0)
    np.testing.assert_allclose(found, orbit.displacement(t), rtol=1e-9, atol=1e-12)


def test_the_jump_of_the_acceleration_of_g1_is_that_of_the_printed_one() -> None:
    t1, T = Fake().exact.t1, Fake().exact.period
    jump = Problem(t1, T).g1_acceleration(np.array(t1)) / (T * (T - t1) ** 3) * T**2
    assert f"jumps by {jump:.1f} h/T²" in motion.g1_is_c1(Fake()).numbers


@pytest.mark.parametrize(("last", "holds"), [(40, True), (41, False)])
def test_what_harmonics_leave_of_g1_is_found(last: int, holds: bool, monkeypatch) -> None:
    def harmonics(t1: float, T: float, t: np.ndarray, derivative: int) -> np.ndarray:
        phase = 2 * np.pi * t / T
        return 5 + sum(np.sin(n * phase + n) / n for n in (1, 7, last))

    monkeypatch.setattr(motion, "g1", harmonics)
    found = motion.in_span_of_harmonics(Fake())
    assert found.holds is holds
    share = (1 / 41) / (1 + 1 / 49 + 1 / 41**2) ** 0.5
    assert holds or found.numbers.startswith(f"{100 * share:.2f} % of g₁")
