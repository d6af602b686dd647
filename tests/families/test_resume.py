"""``sweep --vary`` taken up again: after any chunk, with what is lost, and by nothing else."""

import json
import os
from collections.abc import Callable, Iterator
from pathlib import Path

import numba
import pytest

import nonsmooth as ns
from nonsmooth.cli.shortcuts.families import family_job, family_shown, family_store
from nonsmooth.cli.shortcuts.families.family_store import RECORD, Store, beside
from nonsmooth.files.shortcuts import points
from nonsmooth.solver.shortcuts.search import kernels

C1 = ("--vary", "belt-speed=0.1:10:50", "--log", "--orders", 8)
BOTH = ("--vary", "mu-s=0.3:0.9:19", "--methods", "c1,hb", "--orders", 8)

#: Points of a chunk; a block of the store, of a file and of a summary.
CHUNK, BLOCK = 7, 16

#: Of each sweep: the file and what is printed, computed once.
UNINTERRUPTED: dict[tuple[object, ...], tuple[bytes, str]] = {}


@pytest.fixture(autouse=True)
def small_chunks(monkeypatch) -> Iterator[None]:
    """Cut everything small, and let one thread compute it: of more, see `test_long_sweeps`."""
    monkeypatch.setattr(family_job, "C1_CHUNK", CHUNK)
    monkeypatch.setattr(family_job, "FOURIER_CHUNK", CHUNK)
    monkeypatch.setattr(family_store, "BLOCK", BLOCK)
    monkeypatch.setattr(family_shown, "BLOCK", BLOCK)
    monkeypatch.setattr(points, "CHUNK", BLOCK)
    monkeypatch.setattr(family_job, "in_order", family_job._one_by_one)
    threads = numba.get_num_threads()
    numba.set_num_threads(1)
    yield
    numba.set_num_threads(threads)


@pytest.fixture
def target(tmp_path: Path) -> Path:
    return tmp_path / "family.csv"


@pytest.fixture
def stopped(run, monkeypatch) -> Callable[..., Path]:
    """Return what interrupts a sweep after some chunks, and returns the file of its points."""

    def stop(chunks: int, target: Path, *arguments: object) -> Path:
        write, left = Store.write, chunks

        def interrupted(store: Store, start: int, found: object) -> None:
            nonlocal left
            if not left:
                raise KeyboardInterrupt
            left -= 1
            write(store, start, found)

        with monkeypatch.context() as patch:
            patch.setattr(Store, "write", interrupted)
            status, out, err = run("sweep", *arguments, "-o", target)
        assert status == 130
        assert out == ""
        assert not target.exists()
        assert f"points are kept in {beside(target)}; the same command goes on" in err
        return beside(target)

    return stop


@pytest.fixture
def computed(monkeypatch) -> list[tuple[str, int, int]]:
    """Return the list to which each chunk that is computed is added."""
    chunks, compute = [], family_job.Chunk.compute

    def listed(chunk: family_job.Chunk) -> object:
        chunks.append((chunk.method, chunk.start, chunk.stop))
        return compute(chunk)

    monkeypatch.setattr(family_job.Chunk, "compute", listed)
    return chunks


@pytest.fixture
def whole(run, tmp_path: Path) -> Callable[..., tuple[bytes, str]]:
    """Return what gives file and output of a sweep that nothing interrupts."""

    def look(*arguments: object) -> tuple[bytes, str]:
        if arguments not in UNINTERRUPTED:
            path = tmp_path / "whole.csv"
            status, out, _ = run("sweep", *arguments, "-o", path)
            assert status == 0
            UNINTERRUPTED[arguments] = path.read_bytes(), out
            path.unlink()
        return UNINTERRUPTED[arguments]

    return look


@pytest.mark.parametrize("chunks", range(6))
def test_it_goes_on_after_whatever_chunk(
    chunks: int, run, whole, stopped, computed: list, target: Path
) -> None:
    content, shown = whole(*BOTH)
    cuts = ((0, 7), (7, 14), (14, 19))
    every = [(method, *cut) for method in ("c1", "hb") for cut in cuts]
    stopped(chunks, target, *BOTH)
    computed.clear()
    status, out, err = run("sweep", *BOTH, "-o", target)
    assert status == 0
    assert target.read_bytes() == content
    assert out == shown
    assert not beside(target).exists()
    assert computed == every[chunks:]
    done = (0, 7, 14, 19, 26, 33)[chunks]
    assert ("going on" in err) == bool(done)
    assert not done or err.startswith(f"going on after {done} of 38 points\n")


def test_it_may_be_stopped_again_and_again(run, whole, stopped, target: Path) -> None:
    for _ in range(3):
        part = stopped(2, target, *C1)
        with part.open("ab") as file:  # what a power cut may leave: a part of a point
            file.write(b"\x01" * 33)
    status, _, err = run("sweep", *C1, "-o", target)
    assert status == 0
    assert err.startswith("going on after 42 of 50 points\n")
    assert target.read_bytes() == whole(*C1)[0]


@pytest.mark.parametrize(
    ("damage", "number"), [("zeros", 20), ("a bit", 3), ("a bit", 40), ("swapped", 31)]
)
def test_points_that_a_disk_has_lost_are_computed_again(
    damage: str, number: int, run, whole, stopped, target: Path
) -> None:
    part = stopped(6, target, *C1)
    content, size = bytearray(part.read_bytes()), RECORD.itemsize
    place = content.index(b"\n") + 1 + number * size
    if damage == "zeros":
        content[place:] = bytes(len(content) - place)
    elif damage == "a bit":
        content[place + 20] ^= 4
    else:
        content[place : place + 2 * size] = (
            content[place + size : place + 2 * size] + content[place : place + size]
        )
    part.write_bytes(content)
    status, _, err = run("sweep", *C1, "-o", target)
    assert status == 0
    assert err.startswith(f"going on after {number} of 50 points\n")
    assert target.read_bytes() == whole(*C1)[0]


def refuses(run, target: Path, *arguments: object) -> None:
    """Check that a sweep does not go on from the points of another one."""
    before = beside(target).read_bytes()
    status, out, err = run("sweep", *arguments, "-o", target)
    assert (status, out) == (2, "")
    assert f"-o: {beside(target)} holds another sweep; finish it by its own command" in err
    assert beside(target).read_bytes() == before
    assert not target.exists()


@pytest.mark.parametrize(
    "other",
    [
        ("--vary", "mass=0.1:10:50", "--log", "--orders", 8),
        ("--vary", "belt-speed=0.2:10:50", "--log", "--orders", 8),
        ("--vary", "belt-speed=0.1:11:50", "--log", "--orders", 8),
        ("--vary", "belt-speed=0.1:10:51", "--log", "--orders", 8),
        ("--vary", "belt-speed=0.1:10:50", "--orders", 8),
        (*C1[:-1], 9),
        (*C1, "--methods", "hb"),
        (*C1, "--methods", "c1,hb"),
        *((*C1, f"--{name}", 0.3) for name in ("mass", "stiffness", "mu-s", "mu-k")),
        (*C1, "--normal-force", 401),
    ],
    ids=lambda other: " ".join(map(str, other)),
)
def test_it_does_not_go_on_from_another_sweep(other, run, stopped, target: Path) -> None:
    stopped(3, target, *C1)
    refuses(run, target, *other)


def test_it_does_not_go_on_from_another_version(
    run, stopped, target: Path, monkeypatch
) -> None:
    part = stopped(3, target, *C1)
    plan = json.loads(part.read_bytes().partition(b"\n")[0])
    assert plan["version"] == ns.__version__
    monkeypatch.setattr(ns, "__version__", f"{ns.__version__}.1")
    refuses(run, target, *C1)


@pytest.mark.parametrize("method", kernels.MODULES)
def test_it_does_not_go_on_from_other_equations(
    method: str, run, stopped, target: Path, monkeypatch
) -> None:
    stopped(3, target, *C1)
    monkeypatch.setattr(kernels.module(method), "BODY", "other")
    refuses(run, target, *C1)


def test_a_file_that_is_no_sweep_is_left_alone(run, target: Path) -> None:
    beside(target).write_bytes(b"something else\n")
    refuses(run, target, *C1)


def test_where_the_file_cannot_be_written_the_points_are_kept(
    run, whole, computed: list, target: Path, tmp_path: Path, monkeypatch
) -> None:
    def fail(*arguments: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr("nonsmooth.files.shortcuts.tables.write_points", fail)
        status, _, err = run("sweep", *C1, "-o", target)
    assert status == 2
    assert f"cannot write {target}: No space left on device" in err
    assert [path.name for path in tmp_path.iterdir()] == ["family.csv.part"]
    computed.clear()
    status, _, err = run("sweep", *C1, "-o", target)
    assert status == 0
    assert "going on after 50 of 50 points" in err
    assert computed == []
    assert target.read_bytes() == whole(*C1)[0]


@pytest.mark.skipif(os.name != "posix", reason="file locks are POSIX")
def test_two_runs_do_not_write_the_same_file(run, target: Path) -> None:
    with family_store.opened(target, {}):
        status, out, err = run("sweep", *C1, "-o", target)
    assert (status, out) == (2, "")
    assert f"another run is writing {target}.part" in err


@pytest.mark.parametrize("suffix", [".csv", ".json", ".nc", ".svg"])
def test_without_a_stop_the_points_go_when_the_file_is_there(
    suffix: str, run, tmp_path: Path
) -> None:
    pytest.importorskip({".nc": "netCDF4", ".svg": "matplotlib"}.get(suffix, "json"))
    status, _, err = run("sweep", *C1, "-o", tmp_path / f"family{suffix}")
    assert status == 0
    assert "going on" not in err
    assert [path.name for path in tmp_path.iterdir()] == [f"family{suffix}"]


def test_a_file_of_many_chunks_holds_every_point(run, tmp_path: Path) -> None:
    """Blocks of the file, of the store and of the summary end where no method does."""
    pytest.importorskip("netCDF4")
    for suffix in (".csv", ".json", ".nc"):
        path = tmp_path / f"family{suffix}"
        status, out, _ = run("sweep", *BOTH, "-o", path)
        assert status == 0
        assert "38 ok;" in out
        for found, method in zip(ns.load(path), ("c1", "hb"), strict=True):
            expected = ns.family(found.belt, "mu_s", found["value"], method, 8)
            assert len(found) == 19
            assert found.points.tobytes() == expected.points.tobytes()


@pytest.mark.parametrize("ends", ["0.1:10", "10:0.1"])
def test_the_largest_error_is_that_of_all_points(ends: str, run) -> None:
    """It stands in the last block, or in the first."""
    _, out, _ = run("sweep", "--vary", f"belt-speed={ends}:50", "--log", "--orders", 8)
    assert " ".join(out.split()).endswith(", at belt-speed = 10")
