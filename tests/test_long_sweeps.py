"""Long runs of ``sweep --vary``: killed and taken up again, damaged, two at once."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from nonsmooth.cli.family_store import RECORD

COMMAND = [sys.executable, "-m", "nonsmooth", "sweep"]


def started(arguments: list[str], target: Path, more_than: int) -> subprocess.Popen[bytes]:
    """Start a sweep and return it when its file of points has grown beyond so many bytes."""
    process = subprocess.Popen(
        [*COMMAND, *arguments, "-o", str(target)],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    part = target.with_name(target.name + ".part")
    deadline = time.monotonic() + 120
    while not (part.exists() and part.stat().st_size > more_than):
        assert process.poll() is None, "the sweep ended before it could be killed"
        assert time.monotonic() < deadline, "the sweep does not go on"
        time.sleep(0.01)
    return process


LONG = [
    (["--vary", "belt-speed=0.1:10:400000", "--log"], ".csv"),
    (["--vary", "mu-s=0.3:0.9:4000", "--methods", "hb", "--orders", "8"], ".nc"),
]


@pytest.mark.parametrize(("arguments", "suffix"), LONG, ids=["c1 as csv", "hb as netCDF"])
def test_a_sweep_killed_twice_ends_with_the_same_bytes(
    arguments: list[str], suffix: str, tmp_path: Path
) -> None:
    if suffix == ".nc":
        pytest.importorskip("netCDF4")
    whole, killed = tmp_path / f"whole{suffix}", tmp_path / f"killed{suffix}"
    subprocess.run([*COMMAND, *arguments, "-o", str(whole)], check=True, capture_output=True)
    part = killed.with_name(killed.name + ".part")
    for _ in range(2):
        size = part.stat().st_size if part.exists() else 2_000
        process = started(arguments, killed, size)
        process.send_signal(signal.SIGKILL)
        process.wait()
        assert not killed.exists()
    with part.open("ab") as file:  # what a power cut may leave: a part of a point
        file.write(b"\x01" * 33)
    command = [*COMMAND, *arguments, "-o", str(killed)]
    last = subprocess.run(command, check=True, capture_output=True, text=True)
    assert last.stderr.startswith("going on after ")
    assert killed.read_bytes() == whole.read_bytes()
    assert not part.exists()


@pytest.mark.skipif(os.name != "posix", reason="signals are POSIX")
def test_an_interrupted_sweep_says_what_it_keeps(interruptible, tmp_path: Path) -> None:
    target = tmp_path / "family.csv"
    # More points than are ever computed here.
    process = interruptible("sweep", "--vary", "belt-speed=0.1:10:10000000", "-o", target)
    part = target.with_name(target.name + ".part")
    while not (part.exists() and part.stat().st_size > 2_000):
        assert process.poll() is None
        time.sleep(0.01)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "points are kept in" in err
    assert "interrupted" in err
    assert out == ""
    assert not target.exists()


def test_the_file_of_another_sweep_is_left_alone(run, tmp_path: Path) -> None:
    target = tmp_path / "family.csv"
    part = tmp_path / "family.csv.part"
    part.write_bytes(b"something else\n")
    status, _, err = run("sweep", "--vary", "mass=1:2:30", "-o", target)
    assert status == 2
    assert "holds another sweep" in err
    assert part.read_bytes() == b"something else\n"
    assert not target.exists()


def begun(tmp_path: Path) -> tuple[list[str], Path, Path]:
    """Return a sweep that was killed: its arguments, its target, its points."""
    arguments, target = [*LONG[0][0]], tmp_path / "family.csv"
    process = started(arguments, target, 3_000_000)
    process.send_signal(signal.SIGKILL)
    process.wait()
    return arguments, target, target.with_name(target.name + ".part")


@pytest.mark.parametrize("damage", ["zeros", "a bit", "swapped"])
def test_points_that_a_disk_has_lost_are_computed_again(damage: str, tmp_path: Path) -> None:
    arguments, target, part = begun(tmp_path)
    content, size = bytearray(part.read_bytes()), RECORD.itemsize
    first = content.index(b"\n") + 1
    place = first + 700 * size
    if damage == "zeros":
        content[place:] = bytes(len(content) - place)
    elif damage == "a bit":
        content[place + 20] ^= 4
    else:
        content[place : place + 2 * size] = (
            content[place + size : place + 2 * size] + content[place : place + size]
        )
    part.write_bytes(content)
    command = [*COMMAND, *arguments, "-o"]
    last = subprocess.run([*command, target], check=True, capture_output=True, text=True)
    assert last.stderr.startswith("going on after 700 of 400000 points")
    whole = tmp_path / "whole.csv"
    subprocess.run([*command, whole], check=True, capture_output=True)
    assert target.read_bytes() == whole.read_bytes()


@pytest.mark.skipif(os.name != "posix", reason="file locks are POSIX")
def test_two_runs_do_not_write_the_same_file(run, tmp_path: Path) -> None:
    target = tmp_path / "family.csv"
    process = started(["--vary", "mass=1:2:10000000"], target, 2_000)
    try:
        status, _, err = run("sweep", "--vary", "mass=1:3:30", "-o", target)
    finally:
        process.kill()
        process.wait()
    assert status == 2
    assert f"another run is writing {target}.part" in err
