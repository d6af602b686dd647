"""A phase ends where its event is first met, whether or not a demand says so."""

import numpy as np
import pytest
from made_scenes import Given, made
from numpy.polynomial import Polynomial

from nonsmooth.solver.orbit import admissible

#: x of a free mass; the event of a phase is x - 1 = 0.
FREE, AT_ONE = (1, 0, 0, 0, 0), (1, 0, 0, -1)


def through(*roots: float) -> Polynomial:
    """Return an x that is 1 at these local times."""
    return Polynomial.fromroots(roots) + 1


def found(motion: Polynomial, count: int = 1, **more) -> tuple[str, ...]:
    case = made([FREE] * count, [AT_ONE] * count, **more)()
    return admissible.violations(Given(case, (2.0,) * count, motion))


@pytest.mark.parametrize("jump", [(1, 0), (-0.5, 0), (1, 0.1)])
def test_an_event_that_is_met_on_the_way_ends_the_phase(jump) -> None:
    assert not found(through(0, 1), jumps=[jump])
    (line,) = found(through(0, 0.3, 1), jumps=[jump])
    assert line.startswith("phase 0 would end at t = 0.6 s, where x = 1 m")
    assert "its event is met there" in line


@pytest.mark.parametrize(("jump", "ends"), [((1, 0), False), ((-0.5, 0), True)])
def test_an_impact_needs_no_phase_that_can_begin(jump, ends: bool) -> None:
    # the second phase cannot begin at x = 1; no mass goes on through an impact for that
    demands = ({}, {"x is large": (1, 0, 0, -9)})
    lines = found(through(0, 0.3, 1), count=2, demands=demands, jumps=[jump, (1, 0)])
    assert any(line.startswith("phase 0 would end at t = 0.6 s") for line in lines) == ends


def test_an_event_that_is_touched_is_not_crossed() -> None:
    assert not found(through(0.3, 0.3, 1))
    assert not found(through(0, 0.3, 0.3 + 1e-10, 1))  # by rounding
    assert found(through(0.3, 0.31, 1))


@pytest.mark.parametrize(
    ("demand", "begins"),
    [
        ((1, 0, 0, -0.5), True),
        ((-1, 0, 0, 0.5), False),
        ((0, 1, 0, 0), True),  # x' > 0 at the first crossing, of 0.3
        ((0, -1, 0, 0), False),
        ((1, 0, 0, -1), True),  # 0 there, and rises
        ((-1, 0, 0, 1), False),
    ],
)
def test_where_the_velocity_goes_on_the_next_phase_must_be_able_to_begin(
    demand, begins: bool
) -> None:
    # x - 1 = u (u - 0.3)(1 - u) rises through 0 at 0.3, where the first phase may end
    motion = through(0, 0.3, 1) * -1 + 2
    lines = found(motion, count=2, demands=({}, {"what the second asks": demand}))
    assert any(line.startswith("phase 0 would end at t = 0.6 s") for line in lines) == begins


@pytest.mark.parametrize(("constant", "begins"), [(1.5, True), (0.5, False)])
def test_over_half_a_period_the_next_phase_is_the_mirror_image(constant, begins: bool) -> None:
    # x = 1 where the event is met, so x = -1 where the next cell would begin
    motion = through(0, 0.3, 1) * -1 + 2
    demands = ({"x is large enough": (1, 0, 0, constant)}, {})
    lines = found(motion, count=2, half=True, omega=1.0, demands=demands)
    assert any(line.startswith("phase 1 would end at t = 2.6 s") for line in lines) == begins


def test_a_demand_that_ends_with_the_phase_speaks_for_its_event() -> None:
    demands = ({"x is below 1": (-1, 0, 0, 1)},)
    (line,) = found(through(0, 0.3, 1) * -1 + 2, demands=demands)
    assert line.startswith("in phase 0, not true that x is below 1")


def test_small_crossings_may_be_allowed() -> None:
    case = made([FREE], [AT_ONE])()
    motion = Given(case, (2.0,), through(0, 0.3, 1))
    size = float(np.abs(motion.sizes[0] @ np.abs(AT_ONE)))
    assert admissible.violations(motion, lambda p, form: 0.01 / size)
    assert not admissible.violations(motion, lambda p, form: 0.1 / size)
