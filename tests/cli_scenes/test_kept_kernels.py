"""Kernels of users that are kept: run as they were written and by their user, or not at all."""

import os
import pickle
import random
import shutil
from collections.abc import Callable
from contextlib import redirect_stderr
from dataclasses import replace
from io import StringIO
from pathlib import Path

import pytest
from user_files import kernels_of_impact, write

import nonsmooth as ns
from nonsmooth.codegen import generate
from nonsmooth.codegen.scenes import dry_friction
from nonsmooth.scene_files import find, store
from nonsmooth.solver.scenes import sealed

HAS_USERS = pytest.mark.skipif(not hasattr(os, "getuid"), reason="no numbers of users")

#: What `find_scene` says in any case of a scene that is not kept.
DERIVING = "deriving the equations of bouncing-ball, this once"


@pytest.fixture
def scene_file(tmp_path: Path, cache: Path, monkeypatch) -> Path:
    """Return a scene file that costs nothing to derive, with a cache of its own."""
    monkeypatch.setattr(generate, "scene_sources", kernels_of_impact)
    return write(tmp_path)


@pytest.fixture
def kept(scene_file: Path) -> Path:
    """Return the folder in which its kernels are kept."""
    return find.find_scene(scene_file).folder


def solved(path: Path) -> tuple[float, list[str]]:
    """Return the phase of the forcing of the orbit of a scene file, and what is said."""
    with redirect_stderr(StringIO()) as text:
        scene = find.find_scene(path)
    said = [line.removeprefix("nonsmooth: ") for line in text.getvalue().splitlines()]
    return ns.solve(scene(), "ck-tau", 8).forcing_phase, said


@pytest.fixture(scope="module")
def right() -> float:
    return ns.solve(ns.scene("impact")(), "ck-tau", 8).forcing_phase


def files_in(folder: Path) -> list[Path]:
    return sorted(path for path in folder.rglob("*") if path.is_file())


def test_one_digit_that_was_changed(scene_file: Path, kept: Path, right: float) -> None:
    path = kept / "scene.py"
    text = path.read_text("utf-8")
    assert text.count("CLASS = 0") == 1
    path.write_text(text.replace("CLASS = 0", "CLASS = 1"), "utf-8")
    derived, replaced = DERIVING, f"{kept} was not as it was written, and is written anew"
    assert solved(scene_file) == (right, [derived, replaced])
    assert path.read_text("utf-8") == text
    assert solved(scene_file) == (right, [])


def damage(folder: Path, dice: random.Random) -> None:
    """Change a file as a disk, a crash or a hand might."""
    first, second = dice.sample(files_in(folder), 2)
    content = bytearray(first.read_bytes())
    kind = dice.choice(("empty", "cut", "flip", "digit", "swap", "remove", "add", "rename"))
    if kind == "swap":
        first.write_bytes(second.read_bytes())
        second.write_bytes(content)
    elif kind == "remove":
        first.unlink()
    elif kind == "add":
        first.with_name("hb_ck_9.py").write_bytes(content)
    elif kind == "rename":
        first.rename(first.with_name(f"a{first.name}"))
    elif kind == "flip":
        content[dice.randrange(len(content))] ^= 1 << dice.randrange(8)
        first.write_bytes(content)
    elif kind == "digit" and (places := [i for i, q in enumerate(content) if 47 < q < 58]):
        place = dice.choice(places)
        content[place] = 48 + (content[place] - 47) % 10
        first.write_bytes(content)
    else:
        first.write_bytes(content[: 0 if kind == "empty" else dice.randrange(len(content))])


@pytest.mark.parametrize(
    "seed", [*range(20), *(pytest.param(n, marks=pytest.mark.long) for n in range(20, 400))]
)
def test_what_was_damaged_is_derived_anew(
    seed: int, scene_file: Path, kept: Path, right: float
) -> None:
    before = {path: path.read_bytes() for path in files_in(kept)}
    damage(kept, random.Random(seed))
    phase, said = solved(scene_file)
    assert phase == right
    assert len(said) == 2
    assert {path: path.read_bytes() for path in files_in(kept)} == before


def test_the_folder_of_another_scene_is_not_taken(scene_file: Path, kept: Path) -> None:
    """Not under the name of this one, and not under one that only ends like it."""
    other = find.find_scene(write(scene_file.parent, scene_file.read_text() + "#"))
    shutil.copytree(kept, kept.with_name(f"a-{kept.name}"))
    shutil.rmtree(kept)
    shutil.copytree(other.folder, kept)
    with pytest.raises(sealed.Damaged):
        sealed.read(kept)
    assert store.stored(kept.name) is None
    assert store.stored(other.folder.name) == other.folder


def foreign(path: Path) -> None:
    if os.getuid() != 0:
        pytest.skip("only root gives files to others")
    os.lchown(path, 12345, -1)


PLACES: dict[str, Callable[[Path], Path]] = {
    "module": lambda kept: kept / "scene.py",
    "seal": lambda kept: kept / sealed.SEAL,
    "folder": lambda kept: kept,
    "folder of all": lambda kept: kept.parent,
    "folder of the program": lambda kept: kept.parent.parent,
}
HOW: dict[str, Callable[[Path], None]] = {
    "may be written by others": lambda path: path.chmod(path.stat().st_mode | 0o002),
    "may be written by others, in the group": lambda path: path.chmod(0o770),
    "belongs to another user": foreign,
}


@HAS_USERS
@pytest.mark.parametrize("how", HOW)
@pytest.mark.parametrize("where", PLACES)
def test_what_others_could_have_written_is_not_run(
    where: str, how: str, scene_file: Path, kept: Path, right: float
) -> None:
    path = PLACES[where](kept)
    HOW[how](path)
    reason = f"{path} {how.partition(',')[0]}, so it is not used; derived for this run only"
    assert solved(scene_file) == (right, [DERIVING, reason])
    assert solved(scene_file) == (right, [])  # from the folder of this process
    (for_now,) = store._FOR_NOW.values()
    assert not for_now.is_relative_to(kept.parent.parent)


@HAS_USERS
def test_another_user_does_not_run_what_this_one_kept(
    scene_file: Path, kept: Path, monkeypatch
) -> None:
    other = os.getuid() + 1
    monkeypatch.setattr(os, "getuid", lambda: other)
    assert store.stored(kept.name) is None
    with pytest.raises(sealed.NotPrivate, match="belongs to another user"):
        sealed.read(kept)


@HAS_USERS
def test_a_link_that_another_user_made_is_not_followed(
    scene_file: Path, kept: Path, right: float
) -> None:
    real = kept.with_name("elsewhere")
    kept.rename(real)
    kept.symlink_to(real)
    foreign(kept)
    phase, said = solved(scene_file)
    assert phase == right
    assert said[1].startswith(f"{kept} belongs to another user")


@HAS_USERS
def test_a_cache_in_a_folder_of_all_users(scene_file: Path, kept: Path, right: float) -> None:
    """Such as /tmp: the folder of the program in it is the user's alone."""
    kept.parents[2].chmod(0o1777)
    assert solved(scene_file) == (right, [])


@HAS_USERS
@pytest.mark.parametrize("mask", [0, 0o002, 0o022, 0o077])
def test_what_is_kept_is_the_users_alone(mask: int, scene_file: Path) -> None:
    before = os.umask(mask)
    try:
        kept = find.find_scene(scene_file).folder
    finally:
        os.umask(before)
    for path in (kept, *kept.parents[:2], *kept.rglob("*")):
        assert path.stat().st_mode & 0o077 == 0, path


def test_without_numbers_of_users_nothing_is_refused(
    scene_file: Path, kept: Path, monkeypatch
) -> None:
    monkeypatch.delattr(os, "getuid", raising=False)
    kept.chmod(0o777)
    assert store.stored(kept.name) == kept


def test_what_cannot_be_read(scene_file: Path, kept: Path, right: float) -> None:
    path = kept / "scene.py"
    path.chmod(0)
    if os.access(path, os.R_OK):
        pytest.skip("this user reads anything")
    phase, said = solved(scene_file)
    assert phase == right
    assert "Permission denied; derived for this run only" in said[1]


def test_what_was_read_is_what_runs(scene_file: Path, right: float) -> None:
    """Whatever the files are when a method is used, and nothing else is kept of them."""
    scene = find.find_scene(scene_file)
    for path in scene.folder.glob("*.py"):
        path.write_text("raise ValueError")
    assert ns.solve(scene(), "ck-tau", 8).forcing_phase == right
    assert not (scene.folder / "__pycache__").exists()


def test_what_is_pickled_is_checked_when_it_is_loaded(scene_file: Path, kept: Path) -> None:
    case = find.find_scene(scene_file)(gap=0.2)
    text = pickle.dumps(case)
    assert pickle.loads(text) == case
    (kept / "scene.py").write_bytes((kept / "scene.py").read_bytes() + b"\n")
    with pytest.raises(sealed.Damaged, match=str(kept)):
        pickle.loads(text)


def test_motions_are_kept_and_checked_as_well(tmp_path: Path, monkeypatch, capsys) -> None:
    """A folder a motion; then a file of one of them is in the place of that of the other."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    scene = find.find_scene(replace(dry_friction.SCENE, name="rough-ground"))
    said = capsys.readouterr().err.splitlines()
    assert said[0] == "nonsmooth: deriving the equations of rough-ground, this once"
    assert scene.motions == ("sliding", "two-stops")
    assert ns.solve(scene(frequency=0.4), order=6).case.scene.motion == "two-stops"
    assert scene.folder.is_relative_to(tmp_path)
    folders = {path.parent.name for path in scene.folder.glob("*/scene.py")}
    assert folders == {"sliding", "two_stops"}
    assert store.stored(scene.folder.name) == scene.folder
    sliding = scene.each_motion[0]
    assert pickle.loads(pickle.dumps(sliding)) == sliding
    shutil.copy(scene.folder / "two_stops" / "scene.py", sliding.folder)
    with pytest.raises(sealed.Damaged):
        pickle.loads(pickle.dumps(sliding))
    assert store.stored(scene.folder.name) is None
