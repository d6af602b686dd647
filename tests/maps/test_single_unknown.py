"""Newton's method for one unknown, with inverse interpolation where it converges fast."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from nonsmooth.solver.iteration.iteration import (
    CONVERGED,
    DURATION_STEP,
    NO_DESCENT,
    OVERFLOW,
    SINGULAR,
    TOO_MANY,
)
from nonsmooth.solver.iteration.single import FAST, POINTS
from nonsmooth.solver.kernels.compiling import rebuilt
from nonsmooth.solver.kernels.linking import ONE, made


def solve(function, slope, start, limit=40):
    """Return where the iteration ends, and the points at which it evaluates."""
    seen, slopes = [], []

    def residual(work, y):
        seen.append(float(y))
        return function(y)

    def jacobian(work, y):
        slopes.append(float(y))
        return slope(y)

    iterate = made(ONE, {"residual": residual, "jacobian": jacobian}, rebuilt)["iterate_single"]
    with np.errstate(all="ignore"):
        status, iterations, correction, norm, y = iterate(
            None, np.float64(start), limit, np.empty(POINTS), np.empty(POINTS)
        )
    return SimpleNamespace(
        status=status, iterations=iterations, correction=correction, norm=norm,
        y=float(y), seen=seen, slopes=slopes,
    )  # fmt: skip


CASES = {
    "sine": (lambda y: math.sin(y) - 0.5, math.cos, math.pi / 6),
    "cube": (lambda y: y**3 - 2.0, lambda y: 3 * y * y, 2 ** (1 / 3)),
    "exponential": (lambda y: math.exp(y) - 3.0, math.exp, math.log(3.0)),
    "pole": (lambda y: 1 / y - 0.7, lambda y: -1 / y**2, 1 / 0.7),
}


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("off", [0.9, 1.1])
def test_one_derivative_and_few_residuals_from_ten_percent_off(case, off) -> None:
    """Newton's method alone takes four or five derivatives, and as many residuals."""
    function, slope, root = CASES[case]
    found = solve(function, slope, off * root)
    assert found.status == CONVERGED
    assert found.y == pytest.approx(root, rel=4e-16)
    assert len(found.slopes) == found.iterations == 1
    assert len(found.seen) <= 6


@pytest.mark.parametrize("case", CASES)
def test_errors_fall_as_the_product_of_those_before(case) -> None:
    function, slope, root = CASES[case]
    e = [abs(y - root) / root for y in solve(function, slope, 1.1 * root).seen]
    assert e[2] < 3 * e[0] ** 2 * e[1]
    assert e[3] < 9 * e[0] ** 2 * e[1] * e[2]


@pytest.mark.parametrize("case", CASES)
def test_the_last_evaluation_is_at_what_is_returned(case) -> None:
    """The unknowns of the bands are those of the last evaluation."""
    function, slope, root = CASES[case]
    found = solve(function, slope, 0.8 * root)
    assert found.seen[-1] == found.y
    assert found.norm == abs(function(found.y))
    assert found.correction <= 4 * np.finfo(float).eps


def test_the_last_correction_is_added() -> None:
    """Of what is off by little more than rounding, it leaves less."""
    starts = np.linspace(1.2, 1.8, 201)
    found = [
        solve(lambda y: (y - 1.5) * (y - 0.5), lambda y: 2 * y - 2.0, start) for start in starts
    ]
    before = [abs(q.seen[-2] - 1.5) for q in found]
    assert sum(before) > 0
    assert sum(abs(q.y - 1.5) for q in found) < 0.1 * sum(before)


@given(st.floats(0.1, 5.0), st.floats(0.05, 10.0), st.floats(-3.0, 3.0), st.floats(0.3, 3.0))
def test_any_rising_cubic_is_solved_to_the_last_digits(root, a, b, off) -> None:
    """``d (a d^2 + b d + b^2/(2 a) + 0.1)`` with ``d = y - r``: its slope has no root."""

    def function(y):
        d = y - root
        return d * (a * d * d + b * d + b * b / (2 * a) + 0.1)

    def slope(y):
        d = y - root
        return 3 * a * d * d + 2 * b * d + b * b / (2 * a) + 0.1

    found = solve(function, slope, off * root)
    assert found.status == CONVERGED
    assert abs(found.y - root) <= 4 * np.finfo(float).eps * root


def test_steps_are_limited() -> None:
    duration = solve(math.log, lambda y: 1 / y, 1e4)
    assert duration.status == CONVERGED
    for before, after in zip(duration.slopes, duration.slopes[1:], strict=False):
        assert abs(after - before) <= (1 + 1e-12) * DURATION_STEP * before


def test_it_begins_anew_where_corrections_do_not_shrink_fast() -> None:
    """A slope that changes at once: the points are those of two functions."""

    def function(y):
        return (y - 1) * (4.0 if y > 1 else 1.0) + 0.3

    found = solve(function, lambda y: 4.0 if y > 1 else 1.0, 1.5)
    assert found.status == CONVERGED
    assert found.y == pytest.approx(0.7, rel=1e-15)
    assert len(found.slopes) > 1
    steps = np.abs(np.diff(found.seen))
    for before, step, y in zip(steps, steps[1:], found.seen[1:], strict=False):
        assert y in found.slopes or step <= FAST * before


def test_a_step_that_reduces_nothing_is_halved() -> None:
    seen = solve(lambda y: math.atan(y - 10.0), lambda y: 1 / (1 + (y - 10.0) ** 2), 12.0).seen
    assert abs(seen[1] - 10.0) > 2.0  # too far
    assert seen[2] == pytest.approx((seen[1] + 12.0) / 2)


@pytest.mark.parametrize(
    ("function", "slope", "start", "statuses"),
    [
        (lambda y: y * y + 1.0, lambda y: 2 * y, 1.0, {NO_DESCENT, TOO_MANY}),
        (lambda y: y * y + 1.0, lambda y: 2 * y, 0.0, {SINGULAR}),
        (lambda y: math.nan, lambda y: 1.0, 1.0, {OVERFLOW}),
        (lambda y: 1.0, lambda y: math.nan, 1.0, {OVERFLOW}),
        (lambda y: math.exp(-y), lambda y: -math.exp(-y), 1.0, {TOO_MANY}),
    ],
)
def test_what_has_no_root_is_said_to_have_failed(function, slope, start, statuses) -> None:
    found = solve(function, slope, start)
    assert found.status in statuses
    assert found.status != CONVERGED


def test_where_only_rounding_is_left_it_ends() -> None:
    """A residual that is known to a few digits of its terms: corrections no longer fall."""
    large = 1e6
    found = solve(lambda y: (y + large) - large - 0.7, lambda y: 1.0, 0.5)
    assert found.status == CONVERGED
    assert found.y == pytest.approx(0.7, abs=1e-9)
    exact = solve(lambda y: y - 2.0, lambda y: 1.0, 2.0)
    assert (exact.status, exact.y, exact.norm) == (CONVERGED, 2.0, 0.0)
