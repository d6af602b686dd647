"""A scene of a user with several motions: its numbers are kept, a folder a motion."""

from dataclasses import replace

from nonsmooth.codegen.scenes import dry_friction
from nonsmooth.scene_files import store
from nonsmooth.scene_files.find import find_scene
from nonsmooth.solver.solve import solve_case


def test_motions_are_derived_and_kept(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    said = []
    scene = find_scene(replace(dry_friction.SCENE, name="rough-ground"), said.append)
    assert scene.motions == ("sliding", "two-stops")
    assert solve_case(scene(frequency=0.4), order=6).case.scene.motion == "two-stops"
    assert scene.folder.is_relative_to(tmp_path)
    assert {path.parent.name for path in scene.folder.glob("*/scene.py")} == {
        "sliding",
        "two_stops",
    }
    assert store.stored(scene.folder.name) == scene.folder
    assert said[0] == "deriving the equations of rough-ground, this once"
