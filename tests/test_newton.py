"""Newton's method: converges where it should, and says so where it does not."""

import numpy as np
import pytest

from nonsmooth.solver.kernels import plain_iteration
from nonsmooth.solver.newton import newton


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
    assert outcome.reason == "no step reduces the correction"


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
