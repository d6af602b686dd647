"""What several tests share: the default oscillator, and a command line to call."""

import os
import subprocess
import sys
from collections.abc import Callable

# Before NumPy: on small arrays the threads of its BLAS cost more than they give.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
if "PYTEST_XDIST_WORKER" in os.environ:  # the cores are taken by the workers
    os.environ.setdefault("NUMBA_NUM_THREADS", "1")

import pytest
from hypothesis import settings

import nonsmooth as ns
from nonsmooth.cli import main
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT

# The same examples in every run: a change that fails is a change, not a throw of dice.
settings.register_profile("fixed", deadline=None, derandomize=True)
settings.load_profile("fixed")

#: Rooms whose tests share what they derive: one process runs them.
SHARED = {
    "derivation": "paper",
    "shown": "paper",
    "galerkin": "machine",
    "show": "machine",
    "space": "space",
}


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Keep the tests of a derivation in one process, where several run side by side."""
    for item in items:
        group = SHARED.get(item.path.parent.name)
        if group is not None:
            item.add_marker(pytest.mark.xdist_group(group))


Outcome = tuple[int, str, str]

#: The command line as a terminal starts it.  What runs in the background of a script inherits
#: that Ctrl-C is ignored.
_PROGRAM = (
    "import signal; signal.signal(signal.SIGINT, signal.default_int_handler); "
    "from nonsmooth.__main__ import main; main()"
)


@pytest.fixture
def interruptible() -> Callable[..., "subprocess.Popen[str]"]:
    """Return a starter of the command line in a process that takes Ctrl-C."""

    def start(*arguments: object) -> "subprocess.Popen[str]":
        command = [sys.executable, "-c", _PROGRAM, *map(str, arguments)]
        pipe = subprocess.PIPE
        return subprocess.Popen(command, stdout=pipe, stderr=pipe, text=True)

    return start


@pytest.fixture
def belt() -> ns.StickSlip:
    return DEFAULT


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Callable[..., Outcome]:
    """Return a caller of the command line: exit status, stdout, stderr."""

    def call(*arguments: object) -> Outcome:
        with pytest.raises(SystemExit) as caught:
            main([str(argument) for argument in arguments])
        out, err = capsys.readouterr()
        return int(caught.value.code or 0), out, err

    return call


@pytest.fixture
def python() -> Callable[[str], str]:
    """Return a caller of a fresh interpreter: its stdout."""

    def call(code: str) -> str:
        command = [sys.executable, "-W", "error", "-c", code]
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout

    return call
