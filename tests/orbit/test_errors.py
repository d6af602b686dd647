"""The measure (22) with its floor, and the rule by which it is integrated."""

from types import SimpleNamespace

import numpy as np
import pytest
from computed import Exact

import nonsmooth as ns
from nonsmooth.report.case import DEFAULT
from nonsmooth.solver.orbit import quadrature
from nonsmooth.solver.orbit.errors import acceleration_error

EXACT = Exact(DEFAULT)


@pytest.mark.parametrize("shift", [1e-3, 1e-6, 1e-9])
def test_a_misplaced_jump_contributes_its_root_to_22(shift: float) -> None:
    exact = ns.exact(DEFAULT)
    stick, slip = exact.cell_durations
    moved = np.array([stick + shift, slip - shift])  # without units, as part() is
    late = SimpleNamespace(cell_durations=moved, part=exact.part)
    theta = (np.arange(200_000) + 0.5) / 200_000
    norm2 = float(np.mean(EXACT.motion(theta, 2) ** 2))
    expected = np.sqrt(shift / (stick + slip) * EXACT.jump**2 / norm2)
    assert acceleration_error(late, exact, 24) == pytest.approx(expected, rel=2e-2)


def test_aligned_error_goes_down_to_rounding_and_22_with_times_right_to_the_bit() -> None:
    """Of a jump that is a rounding apart (22) keeps the root."""
    floors = [ns.solve(DEFAULT, "c1", N).errors for N in (24, 28, 29)]
    assert all(floor.acceleration_aligned < 1e-14 for floor in floors)
    assert all(floor.acceleration < 1e-14 or floor.acceleration > 1e-9 for floor in floors)


@pytest.mark.parametrize(("method", "order"), [("hb", 7), ("hb-c1", 7), ("c1", 6)])
def test_both_errors_by_a_fine_midpoint_rule(method: str, order: int) -> None:
    orbit, count = ns.solve(DEFAULT, method, order), 400_000
    theta = (np.arange(count) + 0.5) / count
    reference = EXACT.motion(theta, 2)

    def apart(times: np.ndarray) -> float:
        off = orbit.acceleration(times) - reference
        return float(np.sqrt(np.mean(off**2) / np.mean(reference**2)))

    stick = EXACT.t1 / EXACT.period
    slip = (theta - stick) / (1 - stick) * (orbit.period - orbit.t1)
    aligned = np.where(theta < stick, theta / stick * orbit.t1, orbit.t1 + slip)
    for found, expected in (
        (orbit.errors.acceleration, apart(theta * orbit.period)),
        (orbit.errors.acceleration_aligned, apart(aligned)),
    ):
        # The midpoint rule steps over two jumps: one of its cells each, against the error.
        assert found == pytest.approx(expected, rel=2 / count / expected**2 + 1e-6)


def test_panels_integrate_between_the_breaks() -> None:
    points, weights = quadrature.panels([0.3, 0.7], 5)
    assert weights.sum() == pytest.approx(1, rel=1e-14)
    step = np.where((points > 0.3) & (points < 0.7), 1.0, 0.0)
    assert weights @ step == pytest.approx(0.4, rel=1e-14)
