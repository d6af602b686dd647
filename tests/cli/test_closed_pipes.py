"""A reader that has left, as that of ``| head -1``: status 0, and no message."""

import os
import subprocess
import sys

import pytest
from refusals import refused


@pytest.mark.parametrize("arguments", [("--version",), ("--help",), ("scenes",)])
def test_a_reader_that_leaves_is_no_error(arguments: tuple[str, ...]) -> None:
    reader, writer = os.pipe()
    os.close(reader)
    command = [sys.executable, "-m", "nonsmooth", *arguments]
    try:
        ended = subprocess.run(
            command, stdout=writer, stderr=subprocess.PIPE, text=True, check=False
        )
    finally:
        os.close(writer)
    assert (ended.returncode, ended.stderr) == (0, "")


@pytest.mark.parametrize("command", ["equations", "solve", "simulate"])
def test_a_scene_of_no_letters_is_not_the_default(run, command: str) -> None:
    assert "got '', expected one of" in refused(run, command, "")
