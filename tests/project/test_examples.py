"""Every script of examples/ runs, and prints what its docstring says that it prints."""

import ast
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from shown import ROOT, differences

#: A scene file is not a script: it is tested where its page is.
SCRIPTS = [
    path
    for path in sorted((ROOT / "examples").glob("*.py"))
    if "\nSCENE = " not in path.read_text("utf-8")
]

#: Errors, but for what matplotlib 3.10 calls and pyparsing 3.3 deprecates.
WARNINGS = (
    "error",
    "ignore::DeprecationWarning:matplotlib._fontconfig_pattern",
    "ignore::DeprecationWarning:matplotlib._mathtext",
    "ignore:'parseAll' argument:DeprecationWarning",
)


def promised(script: Path) -> tuple[str, str]:
    """Return what the docstring says of the script, and the output that it promises."""
    docstring = ast.get_docstring(ast.parse(script.read_text("utf-8"))) or ""
    words, _, output = docstring.partition("Prints::")
    return words, output


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda script: script.stem)
def test_an_example_prints_and_writes_what_it_says(script: Path, tmp_path: Path) -> None:
    words, output = promised(script)
    result = subprocess.run(
        [sys.executable, *(f"-W{rule}" for rule in WARNINGS), str(script)],
        check=False,
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env=os.environ | {"MPLBACKEND": "Agg"},
    )
    assert result.stderr == ""
    assert result.returncode == 0
    assert differences(output, result.stdout) == []
    for name in re.findall(r"``(\w+\.(?:csv|png|pdf|tex))``", words):
        assert (tmp_path / name).stat().st_size > 100, name


def test_there_are_examples() -> None:
    assert len(SCRIPTS) >= 5
    assert all(len(promised(script)[1].split()) > 5 for script in SCRIPTS)
