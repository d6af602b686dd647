"""What the command line says of itself: help, version, completion."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from nonsmooth.cli import cli

COMMANDS = (
    "scenes", "generate", "equations", "solve", "sweep", "branch", "map", "simulate", "roots",
    "digits", "tradeoff", "report", "modes",
)  # fmt: skip


@pytest.mark.parametrize("command", COMMANDS)
def test_help_has_examples(run, command: str) -> None:
    status, out, _ = run(command, "--help")
    assert status == 0
    assert f"Usage: nonsmooth {command}" in out
    assert "Example" in out
    assert max(map(len, out.splitlines())) <= 80


def test_help_names_every_command(run) -> None:
    status, out, _ = run()
    assert status == 0
    assert "Examples:" in out
    assert {name for name, q in cli.commands.items() if not q.hidden} == set(COMMANDS)
    assert all(f"\n  {command} " in out for command in COMMANDS)


def test_the_version_says_what_a_bug_report_needs(run) -> None:
    status, out, _ = run("--version")
    assert status == 0
    assert out.startswith("nonsmooth 0.")
    for name in ("mathematics", "Python 3.", "cores", "numba ", "sympy ", "python-flint"):
        assert name in out


@pytest.mark.parametrize(
    ("words", "completed"),
    [
        ("nonsmooth so", ["solve"]),
        ("nonsmooth solve stick", ["stick-slip", "stick-slip-damped"]),
    ],
)
def test_a_shell_completes_commands_and_scenes(words: str, completed: list[str]) -> None:
    words = {"COMP_WORDS": words, "COMP_CWORD": str(words.count(" "))}
    environment = os.environ | words | {"_NONSMOOTH_COMPLETE": "bash_complete"}
    program = "from nonsmooth.__main__ import main; main()"
    command = [sys.executable, "-c", program]
    found = subprocess.run(
        command, check=False, env=environment, capture_output=True, text=True
    )
    assert found.stdout.split() == [f"plain,{word}" for word in completed]


def test_the_module_is_a_command(tmp_path: Path) -> None:
    command = [sys.executable, "-W", "error", "-m", "nonsmooth", "solve", "--order", "3"]
    result = subprocess.run(command, capture_output=True, text=True, check=True, cwd=tmp_path)
    assert "hb-c1" in result.stdout
