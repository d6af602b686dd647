"""A scene of a user with several motions: its kernels are kept, a folder a motion."""

from dataclasses import replace

import pytest

from nonsmooth.codegen import generate
from nonsmooth.codegen.expansions import ck_tau
from nonsmooth.codegen.scenes import dry_friction
from nonsmooth.scene_files import store
from nonsmooth.scene_files.find import find_scene
from nonsmooth.solver.solve import solve_case


@pytest.fixture
def one_expansion(monkeypatch, tmp_path):
    """Derive one expansion alone, into a cache of the test."""
    monkeypatch.setattr(generate, "kernels", lambda scene: {"ck_tau": ck_tau.derive})
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))


@pytest.mark.usefixtures("one_expansion")
def test_motions_are_derived_and_kept(tmp_path):
    said = []
    scene = find_scene(replace(dry_friction.SCENE, name="rough-ground"), said.append)
    assert scene.motions == ("sliding", "two-stops")
    assert solve_case(scene(frequency=0.4), order=6).case.scene.motion == "two-stops"
    assert scene.folder.is_relative_to(tmp_path)
    assert {path.parent.name for path in scene.folder.glob("*/ck_tau.py")} == {
        "sliding",
        "two_stops",
    }
    assert store.stored(scene.folder.name) == scene.folder
    assert said[0] == "deriving the equations of rough-ground, this once"
