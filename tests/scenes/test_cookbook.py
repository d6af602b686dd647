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


@pytest.fixture(autouse=True)
def _cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_its_orbit_is_stable_and_as_exact_as_asked(file: Path) -> None:
    text = file.read_text("utf-8")
    assert 20 <= len(text.splitlines()) <= 50
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
