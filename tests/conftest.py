"""What several tests share: the default oscillator, and a command line to call."""

import gc
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import PurePosixPath
from tempfile import TemporaryDirectory
from typing import Any

from platformdirs import user_cache_path

# Before NumPy: on small arrays the threads of its BLAS cost more than they give.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
if "PYTEST_XDIST_WORKER" in os.environ:  # the cores are taken by the workers
    os.environ.setdefault("NUMBA_NUM_THREADS", "1")
# Before SymPy, whose cache has a thousand entries otherwise: a derivation has more to keep.
os.environ.setdefault("SYMPY_CACHE_SIZE", "20000")
# Scenes that tests make are derived for all tests at once, and not kept beside those of a user;
# the list of fonts, which takes a second to make, is the user's.
if "PYTEST_XDIST_WORKER" not in os.environ:
    _KEPT = TemporaryDirectory(prefix="nonsmooth-")
    os.environ.setdefault("MPLCONFIGDIR", str(user_cache_path("matplotlib", appauthor=False)))
    os.environ["XDG_CACHE_HOME"] = _KEPT.name

import pytest
from hypothesis import settings

import nonsmooth as ns
from nonsmooth.cli import main

# The same examples in every run: a change that fails is a change, not a throw of dice.
settings.register_profile(
    "fixed",
    deadline=None,
    derandomize=True,
    max_examples=100 if "EXAMPLES" in os.environ else 40,
)
settings.load_profile("fixed")

#: Rooms and files whose tests share what they derive or compile: one process runs them.
SHARED = {
    **dict.fromkeys(("test_command_line", "test_documentation", "report"), "paper"),
    **dict.fromkeys(("accuracy", "test_iteration_scenes"), "paper"),
    **dict.fromkeys(("branch", "charts"), "branches"),
    **{room: room for room in ("equations", "galerkin", "space")},
}


#: Files whose tests take minutes each where EXAMPLES asks for many.
DRAWN = ("test_tolerance",)


def _group(nodeid: str) -> str:
    """Return the group of a test: that of its room or file, or the file itself."""
    file = PurePosixPath(nodeid.partition("::")[0])
    if file.stem in DRAWN and "EXAMPLES" in os.environ:
        return nodeid
    return SHARED.get(file.stem) or SHARED.get(file.parent.name) or str(file)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """Run the tests of a group in one process, the groups of most tests first.

    The marks of xdist would do, but version 3.8 does not see them with pytest 9.2: there each
    test went to a process of its own, and every derivation was done twice.
    """
    if config.getvalue("dist") != "loadgroup":
        return None
    from xdist.scheduler import LoadScopeScheduling

    class Groups(LoadScopeScheduling):
        def _split_scope(self, nodeid: str) -> str:
            return _group(nodeid)

    return Groups(config, log)


def pytest_collection_finish() -> None:
    """Look less often for garbage, and not in what is imported: 8 % of a derivation."""
    gc.freeze()
    gc.set_threshold(10_000, 50, 100)


@pytest.fixture(scope="session", autouse=True)
def one_core() -> Iterator[None]:
    """Let commands that start a process a core start one: each takes a second to begin."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(os, "cpu_count", lambda: 1)
        yield


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
def belt() -> "ns.StickSlip":
    from nonsmooth.kim_perkins import SECTION_4

    return ns.StickSlip(**SECTION_4)


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
