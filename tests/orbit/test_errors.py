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


def test_panels_integrate_between_the_breaks() -> None:
    points, weights = quadrature.panels([0.3, 0.7], 5)
    assert weights.sum() == pytest.approx(1, rel=1e-14)
    step = np.where((points > 0.3) & (points < 0.7), 1.0, 0.0)
    assert weights @ step == pytest.approx(0.4, rel=1e-14)
