"""The command line where its surroundings are hostile: closed streams, pipes, full disks."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(os.name != "posix", reason="shells and devices are POSIX")

NONSMOOTH = f"{sys.executable} -m nonsmooth"


def shell(command: str, folder: Path) -> "subprocess.CompletedProcess[str]":
    """Run a command of the shell, whose status is that of the first that failed."""
    arguments = ["bash", "-o", "pipefail", "-c", command.replace("nonsmooth", NONSMOOTH, 1)]
    return subprocess.run(arguments, cwd=folder, capture_output=True, text=True, check=False)


@pytest.mark.parametrize(
    "command",
    [
        "solve --method c1 --order 5",
        "sweep --methods c1 --orders 3,5",
        "scenes stick-slip",
        "--version",
    ],
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
    [
        "sweep --methods c1 --orders 1-20",
        "scenes impact --json",
        "sweep --vary mass=1:2:5000 --json",
    ],
)
def test_a_reader_that_leaves_at_once_is_no_error(command: str, tmp_path: Path) -> None:
    done = shell(f"nonsmooth {command} | head -c 1", tmp_path)
    assert done.returncode == 0, done.stderr
    assert len(done.stdout) == 1
    assert "Traceback" not in done.stderr


@pytest.fixture(scope="module")
def caches(tmp_path_factory) -> None:
    """Write what is kept between runs: a full disk would not take it."""
    before = shell("nonsmooth solve --method c1 --order 5", tmp_path_factory.mktemp("caches"))
    assert before.returncode == 0


@pytest.mark.usefixtures("caches")
@pytest.mark.parametrize("name", ["orbit.json", "orbit.nc", "orbit.csv", "orbit.png"])
def test_a_full_disk_leaves_nothing(name: str, tmp_path: Path) -> None:
    if name.endswith(".nc"):
        pytest.importorskip("netCDF4")
    limit = 1 if name.endswith(".json") else 10  # KiB
    order = 60 if name.endswith(".json") else 5
    command = f"ulimit -f {limit}; nonsmooth solve --method c1 --order {order} -o {name}"
    done = shell(command, tmp_path)
    assert done.returncode == 2, done.stderr
    assert f"nonsmooth: -o: cannot write {name}: " in done.stderr
    assert "Traceback" not in done.stderr
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("command", ["solve --method c1 --order 5", "equations"])
def test_a_pipe_is_not_replaced_by_a_file(command: str, tmp_path: Path) -> None:
    pipe = tmp_path / "orbit.json"
    os.mkfifo(pipe)
    name = pipe.name if command.startswith("solve") else "text"
    if name != pipe.name:
        pipe.rename(tmp_path / name)
    done = shell(f"nonsmooth {command} -o {name}", tmp_path)
    assert done.returncode == 2
    assert done.stderr == f"nonsmooth: -o: {name} is a device or a pipe, expected a file\n"
    assert (tmp_path / name).is_fifo()


@pytest.mark.parametrize("there", [True, False])
def test_what_a_link_points_to_is_written(there: bool, tmp_path: Path) -> None:
    target, link = tmp_path / "results" / "orbit.json", tmp_path / "orbit.json"
    target.parent.mkdir()
    if there:
        target.write_text("old")
    link.symlink_to(target)
    done = shell("nonsmooth solve --method c1 --order 5 -o orbit.json", tmp_path)
    assert done.returncode == 0, done.stderr
    assert link.is_symlink()
    assert '"c1"' in target.read_text()
    assert [path.name for path in target.parent.iterdir()] == [target.name]


def test_a_link_into_no_folder_is_said_before_the_work(tmp_path: Path) -> None:
    (tmp_path / "orbit.json").symlink_to("results/orbit.json")
    done = shell("nonsmooth solve --method c1 --order 5 -o orbit.json", tmp_path)
    assert done.returncode == 2
    assert done.stdout == ""
    assert "-o: the folder " in done.stderr
    assert "results does not exist" in done.stderr
