"""The command line where its surroundings are hostile: closed streams, pipes, full disks."""

import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from every_run import tried

pytestmark = pytest.mark.skipif(os.name != "posix", reason="shells and devices are POSIX")

NONSMOOTH = f"{sys.executable} -m nonsmooth"


def shell(command: str, folder: Path) -> "subprocess.CompletedProcess[str]":
    """Run a command of the shell, whose status is that of the first that failed."""
    arguments = ["bash", "-o", "pipefail", "-c", command.replace("nonsmooth", NONSMOOTH, 1)]
    return subprocess.run(arguments, cwd=folder, capture_output=True, text=True, check=False)


@pytest.mark.parametrize(
    "command",
    tried(
        [
            "solve --method c1 --order 5",
            "sweep --methods c1 --orders 3,5",
            "scenes stick-slip",
            "--version",
        ],
        every_run=["sweep --methods c1 --orders 3,5", "scenes stick-slip", "--version"],
    ),
)
@pytest.mark.parametrize("stream", ["1", "2"])
def test_a_stream_that_is_closed_takes_nothing_away(
    command: str, stream: str, tmp_path: Path
) -> None:
    done = shell(f"nonsmooth {command} {stream}>&-", tmp_path)
    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stderr
    assert bool(done.stdout) == (stream == "2")


@pytest.mark.parametrize(
    "command",
    tried(
        [
            "sweep --methods c1 --orders 1-20",
            "scenes impact --json",
            "modes beam-mass --shapes 2000 --json",
        ],
        every_run=["scenes impact --json", "modes beam-mass --shapes 2000 --json"],
    ),
)
def test_a_reader_that_leaves_at_once_is_no_error(command: str, tmp_path: Path) -> None:
    done = shell(f"nonsmooth {command} | head -c 1", tmp_path)
    assert done.returncode == 0, done.stderr
    assert len(done.stdout) == 1
    assert "Traceback" not in done.stderr


@contextmanager
def full_disk(room: int) -> Iterator[None]:
    """Let no file become longer than this, in bytes: a write beyond it fails."""
    import resource

    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (room, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


@pytest.mark.parametrize("name", ["orbit.json", "orbit.nc", "orbit.csv", "orbit.png"])
def test_a_full_disk_leaves_nothing(name: str, run, tmp_path: Path, monkeypatch) -> None:
    if name.endswith(".nc"):
        pytest.importorskip("netCDF4")
    monkeypatch.chdir(tmp_path)
    room, order = (1024, 60) if name.endswith(".json") else (10 * 1024, 5)
    command = ("solve", "--method", "c1", "--order", order)
    assert run(*command)[0] == 0  # what is kept between runs would not find room either
    with full_disk(room):
        status, _, err = run(*command, "-o", name)
    assert status == 2
    assert f"nonsmooth: -o: cannot write {name}: " in err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("command", ["solve --method c1 --order 5", "equations"])
def test_a_pipe_is_not_replaced_by_a_file(
    command: str, run, tmp_path: Path, monkeypatch
) -> None:
    monkeypatch.chdir(tmp_path)
    name = "orbit.json" if command.startswith("solve") else "text"
    os.mkfifo(name)
    status, _, err = run(*command.split(), "-o", name)
    assert status == 2
    assert err == f"nonsmooth: -o: {name} is a device or a pipe, expected a file\n"
    assert Path(name).is_fifo()


@pytest.mark.parametrize("there", [True, False])
def test_what_a_link_points_to_is_written(
    there: bool, run, tmp_path: Path, monkeypatch
) -> None:
    monkeypatch.chdir(tmp_path)
    target, link = tmp_path / "results" / "orbit.json", tmp_path / "orbit.json"
    target.parent.mkdir()
    if there:
        target.write_text("old")
    link.symlink_to(target)
    status, _, err = run("solve", "--method", "c1", "--order", 5, "-o", "orbit.json")
    assert status == 0, err
    assert link.is_symlink()
    assert '"c1"' in target.read_text()
    assert [path.name for path in target.parent.iterdir()] == [target.name]


def test_a_link_into_no_folder_is_said_before_the_work(
    run, tmp_path: Path, monkeypatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("orbit.json").symlink_to("results/orbit.json")
    status, out, err = run("solve", "--method", "c1", "--order", 5, "-o", "orbit.json")
    assert status == 2
    assert out == ""
    assert "-o: the folder " in err
    assert "results does not exist" in err
