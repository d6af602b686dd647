"""The oscillators of the cookbook: short files, stable orbits within a tolerance."""

from pathlib import Path

import numpy as np
import pytest
from shown import ROOT

import nonsmooth as ns

FILES = [
    ROOT / "examples" / "bouncing_ball.py",
    *sorted((ROOT / "examples/scenes").glob("*.py")),
]
TOLERANCE, OF_BODIES = 1e-9, 1e-6


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_its_orbit_is_stable_and_as_exact_as_asked(file: Path) -> None:
    text = file.read_text("utf-8")
    assert 20 <= len(text.splitlines()) <= 90
    tolerance = OF_BODIES if "Body(" in text else TOLERANCE
    orbit = ns.solve(ns.scene(str(file))(), tol=tolerance)
    assert orbit.stable
    assert orbit.errors.times < tolerance
    start, exact = (
        np.array([(phase.displacement, phase.velocity) for phase in motion.phases])
        for motion in (orbit, orbit.exact)
    )
    # of a motion whose switches a clock sets the times alone say nothing
    assert np.abs(start - exact).max() < 100 * tolerance * np.abs(exact).max()


def test_a_phase_that_goes_on_behind_its_event_is_one() -> None:
    """Free of the stop, the mass passes the gap on its way back, and nothing happens there."""
    stop = ns.scene(str(ROOT / "examples/scenes/pushing_stop.py"))(frequency=0.6)
    orbit = ns.solve(stop, tol=1e-8)
    assert orbit.stable
    names = [phase.name for phase in orbit.phases]
    assert names == ["contact", "free"] * (len(names) // 2)
    assert len(names) > 2
    motion = ns.simulate(stop, cycles=60)
    whole = [part.duration for part in motion.phases if part.name == "contact"][-8:-1]
    for phase in orbit.phases[::2]:
        assert np.abs(np.array(whole) - phase.duration).min() < 1e-8 * orbit.period


def test_a_declared_order_that_is_asked_for_has_the_guess_of_its_scene() -> None:
    clock = ns.scene(str(ROOT / "examples/scenes/escapement.py"))()
    asked = ns.solve(clock, phases="swing", order=12)
    assert asked.durations == pytest.approx(ns.solve(clock, order=12).durations, rel=1e-14)
