"""Newton's method: converges where it should, and says so where it does not."""

import numpy as np
import pytest

from nonsmooth.solver.shortcuts.search.kernels import plain_iteration
from nonsmooth.solver.shortcuts.search.newton import newton


def solve(residual, jacobian, start, **options):
    def fill_residual(case, z, R):
        R[:] = residual(z)

    def fill_jacobian(case, z, J):
        J[:] = jacobian(z)

    iteration = plain_iteration(fill_residual, fill_jacobian)
    return newton(iteration, None, np.array(start, dtype=float), **options)


def quadratic(z):
    return [z[0] ** 2 - 4, z[1] - 1, z[2] - 3]


def quadratic_jacobian(z):
    return np.diag([2 * z[0], 1, 1])


def test_converges_quadratically_to_the_last_digit() -> None:
    outcome = solve(quadratic, quadratic_jacobian, [3, 0.5, 2])
    assert outcome.converged
    np.testing.assert_allclose(outcome.unknowns, [2, 1, 3], rtol=1e-15)
    assert outcome.iterations <= 8
    assert outcome.residual_norm < 1e-15


def test_the_start_is_not_overwritten() -> None:
    start = np.array([3.0, 0.5, 2.0])
    solve(quadratic, quadratic_jacobian, start)
    assert start.tolist() == [3, 0.5, 2]


def test_no_root_is_reported_not_returned() -> None:
    outcome = solve(
        lambda z: [z[0] ** 2 + 1, z[1] - 1, z[2] - 3], quadratic_jacobian, [3, 0.5, 2]
    )
    assert not outcome.converged
    assert outcome.reason == "Newton's method stalled (no damped step reduces the correction)"


def test_a_singular_jacobian_is_reported() -> None:
    outcome = solve(quadratic, lambda z: np.zeros((3, 3)), [3, 0.5, 2])
    assert not outcome.converged
    assert outcome.reason == "the Jacobian is singular"


def test_overflow_is_reported() -> None:
    outcome = solve(lambda z: [np.inf, 0, 0], quadratic_jacobian, [3, 0.5, 2])
    assert not outcome.converged
    assert outcome.reason == "the equations overflow"


def test_the_iteration_limit_is_kept() -> None:
    outcome = solve(quadratic, quadratic_jacobian, [1e6, 0.5, 2], limit=3)
    assert not outcome.converged
    assert outcome.iterations == 3


def test_times_never_leave_their_range() -> None:
    seen = []

    def residual(z):
        seen.append(z[-2:].copy())
        return [z[0] - 1, z[1] + 5, z[2] - 3]  # its root has t1 = -5

    outcome = solve(residual, lambda z: np.eye(3), [0.5, 1, 2])
    assert not outcome.converged
    assert all(0 < t1 < T for t1, T in seen)


def test_a_root_just_beyond_the_range_is_not_stepped_to() -> None:
    """The last step, undamped because it is small, would have led from 5e-10 to -1e-9."""
    outcome = solve(
        lambda z: [z[0] - 1, z[1] + 1e-9, z[2] - 1], lambda z: np.eye(3), [1, 1e-9, 1]
    )
    assert not outcome.converged
    assert outcome.reason == "t1 ran out of (0, T)"
    assert 0 < outcome.unknowns[-2] < outcome.unknowns[-1]


def test_rounding_of_the_residual_ends_the_iteration_where_it_is() -> None:
    """Corrections no longer fall: what is left of them says how large the rounding is."""
    calls = []

    def residual(z):
        calls.append(z)
        return [z[0] - 1, z[1] - 1 + 1e-12 * (-1) ** len(calls), z[2] - 3]

    outcome = solve(residual, lambda z: np.eye(3), [0.5, 0.5, 2])
    assert outcome.converged
    assert 1e-13 < outcome.correction < 1e-11
    np.testing.assert_allclose(outcome.unknowns, [1, 1, 3], rtol=3e-12)


def test_a_step_that_makes_things_worse_is_halved() -> None:
    """Undamped, Newton's method for arctan diverges from 3."""
    outcome = solve(
        lambda z: [np.arctan(z[0] - 9), z[1] - 1, z[2] - 3],
        lambda z: np.diag([1 / (1 + (z[0] - 9) ** 2), 1, 1]),
        [12, 0.5, 2],
    )
    assert outcome.converged
    np.testing.assert_allclose(outcome.unknowns, [9, 1, 3], rtol=1e-15)


@pytest.mark.parametrize("scale", [1e-8, 1e8])
def test_scaling_the_equations_changes_no_step(scale: float) -> None:
    rows = np.array([1.0, scale, 1 / scale])
    plain = solve(quadratic, quadratic_jacobian, [30, 0.5, 2])
    scaled = solve(
        lambda z: rows * quadratic(z),
        lambda z: rows[:, None] * quadratic_jacobian(z),
        [30, 0.5, 2],
    )
    assert scaled.iterations == plain.iterations
    np.testing.assert_allclose(scaled.unknowns, plain.unknowns, rtol=1e-14)
