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
TOLERANCE = 1e-9


@pytest.fixture(autouse=True)
def _cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_its_orbit_is_stable_and_as_exact_as_asked(file: Path) -> None:
    assert 20 <= len(file.read_text("utf-8").splitlines()) <= 50
    orbit = ns.solve(ns.scene(str(file))(), tol=TOLERANCE)
    assert orbit.stable
    assert orbit.errors.times < TOLERANCE
    start, exact = (
        np.array([(phase.displacement, phase.velocity) for phase in motion.phases])
        for motion in (orbit, orbit.exact)
    )
    # of a motion whose switches a clock sets the times alone say nothing
    assert np.abs(start - exact).max() < 100 * TOLERANCE * np.abs(exact).max()
