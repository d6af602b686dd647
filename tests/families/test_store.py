"""The points of a long sweep on disk: what is damaged is found, in whatever block it stands."""

import json
import os
from pathlib import Path

import numpy as np
import pytest

from nonsmooth.cli.problems import Problem
from nonsmooth.cli.shortcuts.families import family_store
from nonsmooth.cli.shortcuts.families.family_store import (
    LINE,
    RECORD,
    beside,
    check_room,
    opened,
)
from nonsmooth.solver.shortcuts.search.family_points import POINT

PLAN = {"parameter": "mass", "version": "1"}

#: Points of the tests, and how many the store looks at together: three blocks, one not full.
COUNT, BLOCK = 10, 4


@pytest.fixture(autouse=True)
def small_blocks(monkeypatch) -> None:
    monkeypatch.setattr(family_store, "BLOCK", BLOCK)


@pytest.fixture
def target(tmp_path: Path) -> Path:
    return tmp_path / "family.csv"


def some(count: int) -> np.ndarray:
    """Return points of random numbers."""
    points = np.zeros(count, dtype=POINT)
    rng = np.random.default_rng(3)
    for name in POINT.names[1:]:
        points[name] = rng.normal(size=count)
    return points


def filled(target: Path) -> int:
    """Write `COUNT` points and return how many bytes stand before them."""
    with opened(target, PLAN) as store:
        store.write(0, some(COUNT))
        return store.offset


def changed(target: Path, place: int, old: bytes) -> None:
    with beside(target).open("r+b") as file:
        file.seek(place)
        file.write(old)


def sound(target: Path) -> int:
    with opened(target, PLAN) as store:
        return store.sound()


@pytest.mark.parametrize("where", ["disk", "nowhere"])
def test_points_are_read_as_they_were_written(where: str, target: Path) -> None:
    points = some(COUNT)
    with opened(target if where == "disk" else None, PLAN) as store:
        for start, stop in ((0, 3), (3, 4), (4, 9), (9, 10)):
            store.write(start, points[start:stop])
            assert len(store) == store.sound() == stop
        for start in range(COUNT):
            for stop in range(start + 1, COUNT + 1):
                assert store.read(start, stop).tobytes() == points[start:stop].tobytes()


def test_what_was_written_is_there_when_it_is_opened_again(target: Path) -> None:
    filled(target)
    with opened(target, PLAN) as store:
        assert len(store) == store.sound() == COUNT
        assert store.read(0, COUNT).tobytes() == some(COUNT).tobytes()
        store.write(COUNT, some(2))
    assert sound(target) == COUNT + 2


@pytest.mark.parametrize("number", range(COUNT))
def test_points_are_sound_up_to_the_first_that_is_damaged(number: int, target: Path) -> None:
    place = filled(target) + number * RECORD.itemsize
    changed(target, place, bytes(RECORD.itemsize))
    assert sound(target) == number
    changed(target, place + 2 * RECORD.itemsize, b"\x01" * RECORD.itemsize)
    assert sound(target) == number


@pytest.mark.parametrize("other", [4, 8])
def test_points_that_changed_places_are_damaged(other: int, target: Path) -> None:
    offset, size = filled(target), RECORD.itemsize
    content = beside(target).read_bytes()[offset:]
    for place, number in ((3, other), (other, 3)):
        changed(target, offset + place * size, content[number * size : (number + 1) * size])
    assert sound(target) == 3


def test_no_bit_of_a_point_changes_unnoticed(target: Path) -> None:
    first = filled(target) + 5 * RECORD.itemsize
    content = beside(target).read_bytes()
    for bit in range(8 * RECORD.itemsize):
        place = first + bit // 8
        changed(target, place, bytes([content[place] ^ 1 << bit % 8]))
        assert sound(target) == 5, f"bit {bit}"
        changed(target, place, content[place : place + 1])
    assert sound(target) == COUNT


def test_a_part_of_a_point_is_none(target: Path) -> None:
    filled(target)
    with beside(target).open("ab") as file:
        file.write(b"\x01" * (RECORD.itemsize - 1))
    with opened(target, PLAN) as store:
        assert len(store) == store.sound() == COUNT


def test_points_are_on_the_disk_when_they_are_written(target: Path, monkeypatch) -> None:
    sizes = []
    monkeypatch.setattr(os, "fsync", lambda file: sizes.append(os.fstat(file).st_size))
    with opened(target, PLAN) as store:
        sizes.clear()
        for start in (0, 3, 6):
            store.write(start, some(3))
        whole = [store.offset + stop * RECORD.itemsize for stop in (3, 6, 9)]
    assert sizes == whole


@pytest.mark.parametrize("kept", [0, 1, 20, LINE - 1])
def test_a_first_line_that_was_cut_is_written_again(kept: int, target: Path) -> None:
    with opened(target, PLAN):
        first = beside(target).read_bytes()
    beside(target).write_bytes(first[:kept])
    with opened(target, PLAN) as store:
        assert len(store) == 0
        store.write(0, some(COUNT))
    assert beside(target).read_bytes()[: len(first)] == first
    assert sound(target) == COUNT


@pytest.mark.parametrize("length", [1, LINE - 30, LINE, 3 * LINE])
def test_a_plan_of_any_length_is_one_line(length: int, target: Path) -> None:
    plan = PLAN | {"generated": "x" * length}
    with opened(target, plan) as store:
        store.write(0, some(COUNT))
        assert store.offset % LINE == 0
    line = beside(target).read_bytes()[: store.offset]
    assert line.index(b"\n") == store.offset - 1
    assert json.loads(line) == plan
    with opened(target, plan) as store:
        assert store.sound() == COUNT


@pytest.mark.parametrize(
    "other", [PLAN | {"version": "2"}, PLAN | {"version": "10"}, {"parameter": "mass"}]
)
def test_the_points_of_another_plan_are_left_alone(other: dict, target: Path) -> None:
    filled(target)
    before = beside(target).read_bytes()
    with pytest.raises(Problem, match="holds another sweep"), opened(target, other):
        pass
    assert beside(target).read_bytes() == before


@pytest.mark.skipif(os.name != "posix", reason="file locks are POSIX")
def test_two_do_not_write_at_once(target: Path) -> None:
    with opened(target, PLAN) as store:
        store.write(0, some(2))
        for plan in (PLAN, {"version": "other"}):
            with (
                pytest.raises(Problem, match=r"another run is writing .*family\.csv\.part"),
                opened(target, plan),
            ):
                pass
        store.write(2, some(2))
    assert sound(target) == 4


def test_what_is_there_needs_no_more_room(target: Path, monkeypatch) -> None:
    usage = family_store.shutil.disk_usage(target.parent)
    offset = filled(target)
    each = RECORD.itemsize + 230  # bytes of a row of a CSV
    needed = 100 * each - offset - COUNT * RECORD.itemsize
    for free in (needed - 1, needed):
        monkeypatch.setattr(
            "shutil.disk_usage", lambda folder, free=free: usage._replace(free=free)
        )
        if free == needed:
            check_room(target, 100)
        else:
            with pytest.raises(Problem, match="100 points need about"):
                check_room(target, 100)


@pytest.mark.skipif(os.name != "posix", reason="links, pipes and limits are POSIX")
@pytest.mark.parametrize("kind", ["link", "dangling", "pipe", "folder"])
def test_what_is_no_file_is_left_as_it_is(kind: str, target: Path) -> None:
    """A link may lead into any file, an empty one among them, which would be written into."""
    other, path = target.with_name("other"), beside(target)
    if kind == "link":
        other.touch()
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "folder":
        path.mkdir()
    else:
        path.symlink_to(other)
    with pytest.raises(Problem, match=f"-o: .*{path.name}") as caught, opened(target, PLAN):
        pass
    assert caught.value.status == 2
    said = {"pipe": "a device or a pipe", "folder": "directory"}.get(kind, "a symbolic link")
    assert said in str(caught.value)
    assert other.exists() == (kind == "link")
    assert not other.exists() or other.read_bytes() == b""


@pytest.mark.parametrize("room", [LINE // 2, LINE + 100])
def test_a_full_disk_is_said_of_the_file(room: int, target: Path) -> None:
    resource = pytest.importorskip("resource")
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (room, before[1]))
    try:
        with (
            pytest.raises(Problem, match=rf"-o: cannot write .*{beside(target).name}: "),
            opened(target, PLAN) as store,
        ):
            store.write(0, some(COUNT))
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert beside(target).stat().st_size == room
