"""What several tests share: the default oscillator, and a command line to call."""

import subprocess
import sys
from collections.abc import Callable

import pytest
from hypothesis import settings

import nonsmooth as ns
from nonsmooth.cli import main
from nonsmooth.solver.belt import DEFAULT

# The same examples in every run: a change that fails is a change, not a throw of dice.
settings.register_profile("fixed", deadline=None, derandomize=True)
settings.load_profile("fixed")

Outcome = tuple[int, str, str]


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
