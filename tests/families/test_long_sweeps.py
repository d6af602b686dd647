"""Long runs of ``sweep --vary`` as processes: killed, interrupted, on all cores."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from nonsmooth.cli.shortcuts.families import family_job
from nonsmooth.cli.shortcuts.families.family_store import RECORD, beside

pytestmark = pytest.mark.skipif(os.name != "posix", reason="signals are POSIX")

#: The command line in chunks of 32 points, killed during the one after the first
#: so many.  Its workers hold its stdout open as long as they live.
KILLED = """
import os, signal, sys
from nonsmooth.cli.shortcuts.families import family_job
from nonsmooth.cli import main
from nonsmooth.cli.shortcuts.families.family_store import Store

def write(store, start, points):
    global left
    if left:
        left -= 1
        return whole(store, start, points)
    store.file.seek(0, 2)
    store.file.write(b"a part of a point")
    store.file.flush()
    os.kill(os.getpid(), signal.SIGKILL)

if __name__ == "__main__":
    family_job.C1_CHUNK = family_job.FOURIER_CHUNK = 32
    left, whole, Store.write = int(sys.argv[1]), Store.write, write
    main(sys.argv[2:])
"""

C1 = ("--vary", "belt-speed=0.1:10:150", "--log")
HB = ("--vary", "mu-s=0.3:0.9:70", "--methods", "hb", "--orders", "5")


def killed(after: int, *arguments: object) -> str:
    """Kill a sweep after some chunks, wait for the end of its workers, return its stderr."""
    command = [sys.executable, "-c", KILLED, str(after), "sweep", *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == -signal.SIGKILL, done.stderr
    return done.stderr


@pytest.mark.parametrize(
    ("arguments", "suffix", "kills"),
    [
        pytest.param(C1, ".csv", 2, id="c1 as csv"),
        pytest.param(HB, ".nc", 1, id="hb as netCDF"),
    ],
)
def test_a_sweep_killed_once_or_twice_ends_with_the_same_bytes(
    arguments: tuple[str, ...], suffix: str, kills: int, run, tmp_path: Path, monkeypatch
) -> None:
    if suffix == ".nc":
        pytest.importorskip("netCDF4")
    whole, target = tmp_path / f"whole{suffix}", tmp_path / f"killed{suffix}"
    part = beside(target)
    for chunks in range(1, kills + 1):
        killed(1, *arguments, "-o", target)
        assert not target.exists()
        content = part.read_bytes()
        assert len(content) - content.index(b"\n") - 1 == 32 * chunks * RECORD.itemsize + 17
    monkeypatch.setattr(family_job, "FOURIER_CHUNK", 32)
    status, _, err = run("sweep", *arguments, "-o", target)
    assert status == 0
    assert err.startswith(f"going on after {32 * kills} of ")
    assert not part.exists()
    monkeypatch.undo()
    assert run("sweep", *arguments, "-o", whole)[0] == 0
    assert target.read_bytes() == whole.read_bytes()


def test_an_interrupted_sweep_says_what_it_keeps(interruptible, tmp_path: Path) -> None:
    target = tmp_path / "family.csv"
    # More points than are ever computed here.
    process = interruptible("sweep", "--vary", "belt-speed=0.1:10:2000000", "-o", target)
    part = beside(target)
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
