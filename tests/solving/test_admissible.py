"""What friction demands, one demand at a time: motions made to break this one alone."""

import math

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.solver.shortcuts.orbit.admissible import violations
from nonsmooth.solver.shortcuts.orbit.methods import METHODS
from nonsmooth.solver.shortcuts.polynomials import c1_roots
from nonsmooth.solver.shortcuts.series.fourier import from_symmetric


def belt_at(alpha: float) -> ns.StickSlip:
    return ns.StickSlip(
        mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
    )


def of_sines(b: list[float], t1: float, T: float) -> tuple[str, ...]:
    """Return the violations of sines about mid-stick, at the alpha that they reach at t1."""
    n = np.arange(1, len(b) + 1)
    alpha = float(np.array(b) @ np.sin(n * math.pi * t1 / T))
    z = from_symmetric(np.array([*b, t1, T]), len(b))
    return violations(METHODS["hb"], len(b), belt_at(alpha), z)


def of_parts(p: list[float], alpha: float, T: float) -> tuple[str, ...]:
    """Return the violations of an acceleration in slip with these parts in P_n*."""
    z = np.array([*p, 2 * alpha, T])
    return violations(METHODS["c1"], len(p) - 1, belt_at(alpha), z)


def test_a_motion_that_breaks_nothing_is_an_orbit() -> None:
    assert of_sines([1.3], 1.6, 6.4) == ()
    assert of_parts([0.0, 1.0, 0.0], 1.0, 6.7) == ()


def test_the_static_limit_holds_inside_stick_too() -> None:
    """The spring force is at the limit where stick ends, and was above it before."""
    (found,) = of_sines([2.47], 5.6, 8.0)
    assert "the spring force in stick exceeds the static limit by 0.118" in found


@pytest.mark.parametrize(
    ("b", "t1", "T"),
    [([2.0], 1.2, 6.0), ([3.5, 0.0, -1.75], 3.92, 8.0)],
    ids=["start", "middle"],
)
def test_the_belt_is_not_overtaken_inside_slip(b: list[float], t1: float, T: float) -> None:
    (found,) = of_sines(b, t1, T)
    assert "the velocity in slip exceeds V" in found


def test_the_belt_is_not_overtaken_by_a_polynomial() -> None:
    """At both ends of slip the velocity is V; between them it is 1.1 V."""
    (found,) = of_parts([0.0, -0.1, 0.0], 1.0, 6.0)
    assert found == "the velocity in slip exceeds V by 0.1 of it"


def test_slip_lasts_no_longer_than_a_natural_period() -> None:
    """A second turn: the equations hold, and so does the limit where stick ends."""
    turns = [
        violations(METHODS["c1"], 23, belt_at(0.01), z) for z in c1_roots.solutions(23, 0.01)
    ]
    longer = [found for found in turns if found and found[0].startswith("slip lasts 1.997")]
    assert [len(found) for found in longer] == [1]


@pytest.mark.parametrize(("miss", "words"), [(0.3, "beyond"), (-0.3, "short of")])
def test_stick_ends_at_the_static_limit(miss: float, words: str) -> None:
    z = np.array([0.0, 1.0, 0.0, 2.0 + 2 * miss, 6.7])
    (found,) = violations(METHODS["c1"], 2, belt_at(1.0), z)
    assert f"stick ends 0.3 of its travel {words} the static limit" in found
    assert "allowed at order 2: 0.25" in found


@pytest.mark.parametrize(("t1", "T"), [(-0.1, 6.0), (0.0, 6.0), (6.0, 6.0), (7.0, 6.0)])
def test_times_are_in_order(t1: float, T: float) -> None:
    (found,) = violations(METHODS["c1"], 1, belt_at(1.0), np.array([0.0, 1.0, t1, T]))
    assert "is not between 0 and T" in found


def test_stick_has_something_like_the_velocity_of_the_belt() -> None:
    """Sines whose stick is a hundred times too short, with nothing else against them."""
    (found,) = of_sines([0.2], 5.7, 11.8)
    assert "the mean velocity in stick is 0.0" in found
