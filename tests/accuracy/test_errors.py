"""The error measures: (22) with its floor, and the aligned one without."""

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.solver.shortcuts.accuracy import errors
from nonsmooth.solver.shortcuts.orbit import exact
from nonsmooth.solver.shortcuts.orbit.methods import METHODS
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT


def exact_but_for(shift: float, order: int = 24) -> np.ndarray:
    """Return a C1 solution of high order with its end of stick moved."""
    z = ns.solve(DEFAULT, "c1", order).unknowns.copy()
    z[-2] += shift
    return z


@pytest.mark.parametrize("shift", [1e-3, 1e-6, 1e-9])
def test_a_misplaced_jump_contributes_its_root_to_22(shift: float) -> None:
    method, z = METHODS["c1"], exact_but_for(shift)
    _, T = exact.times(1.0)
    # The jump of alpha = 1, over the normalised time in between, against the norm.
    theta = np.linspace(0, 1, 200001)[:-1] + 0.5 / 200000
    norm2 = float(np.mean(exact.evaluate(1.0, theta * T, 2) ** 2))
    expected = np.sqrt(shift / T / norm2)
    found = errors.acceleration_error(method, 24, 1.0, z)
    assert found == pytest.approx(expected, rel=2e-2)
    # Aligned, the shift shows as a stretch of slip: in proportion, not by its root.
    assert errors.aligned_acceleration_error(method, 24, 1.0, z) < 2 * shift + 1e-13


def test_aligned_error_goes_down_to_rounding_and_22_does_not() -> None:
    floors = [ns.solve(DEFAULT, "c1", n).errors for n in (24, 28, 29)]
    assert all(floor.acceleration_aligned < 1e-14 for floor in floors)
    assert any(floor.acceleration > 1e-9 for floor in floors)


@pytest.mark.parametrize(("method", "order"), [("hb", 7), ("hb-c1", 7), ("c1", 6)])
def test_both_errors_by_a_fine_midpoint_rule(method: str, order: int) -> None:
    orbit = ns.solve(DEFAULT, method, order)
    z, evaluate = orbit.unknowns, METHODS[method].evaluate
    exact_t1, exact_T = exact.times(1.0)
    count = 400_000
    theta = (np.arange(count) + 0.5) / count
    reference = exact.evaluate(1.0, theta * exact_T, 2)
    found = evaluate(z, order, theta * z[-1], 2, 1.0)
    expected = np.sqrt(np.mean((found - reference) ** 2) / np.mean(reference**2))
    # The midpoint rule steps over two jumps: one of its cells each, against the error.
    cells = 2 / count / expected**2
    assert orbit.errors.acceleration == pytest.approx(expected, rel=cells + 1e-6)
    stick = exact_t1 / exact_T
    aligned = np.where(
        theta < stick,
        theta / stick * z[-2],
        z[-2] + (theta - stick) / (1 - stick) * (z[-1] - z[-2]),
    )
    found = evaluate(z, order, aligned, 2, 1.0)
    expected = np.sqrt(np.mean((found - reference) ** 2) / np.mean(reference**2))
    cells = 2 / count / expected**2
    assert orbit.errors.acceleration_aligned == pytest.approx(expected, rel=cells + 1e-6)


def test_panels_integrate_between_the_breaks() -> None:
    points, weights = errors.panels([0.3, 0.7], 5)
    assert weights.sum() == pytest.approx(1, rel=1e-14)
    step = np.where((points > 0.3) & (points < 0.7), 1.0, 0.0)
    assert weights @ step == pytest.approx(0.4, rel=1e-14)
