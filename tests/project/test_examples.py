"""Every script of examples/ runs, and prints what its docstring says that it prints."""

import ast
import json
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


#: Runs scripts one after the other, each in a folder, and writes down what they print.
RUN = """
import contextlib, io, json, os, runpy, sys
printed = []
for script, folder in json.loads(sys.argv[1]):
    os.chdir(folder)
    with contextlib.redirect_stdout(io.StringIO()) as out:
        runpy.run_path(script, run_name="__main__")
    printed.append(out.getvalue())
json.dump(printed, sys.stdout)
"""


@pytest.fixture(scope="module")
def ran(tmp_path_factory: pytest.TempPathFactory) -> dict[Path, tuple[str, Path]]:
    """Return what each script prints, and the folder that it ran in; one process runs all."""
    folders = [tmp_path_factory.mktemp(script.stem) for script in SCRIPTS]
    pairs = json.dumps([(str(s), str(f)) for s, f in zip(SCRIPTS, folders, strict=True)])
    result = subprocess.run(
        [sys.executable, *(f"-W{rule}" for rule in WARNINGS), "-c", RUN, pairs],
        check=False,
        capture_output=True,
        text=True,
        env=os.environ | {"MPLBACKEND": "Agg"},
    )
    assert result.stderr == ""
    assert result.returncode == 0
    printed = json.loads(result.stdout)
    return dict(zip(SCRIPTS, zip(printed, folders, strict=True), strict=True))


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda script: script.stem)
def test_an_example_prints_and_writes_what_it_says(
    script: Path, ran: dict[Path, tuple[str, Path]]
) -> None:
    words, output = promised(script)
    printed, folder = ran[script]
    assert differences(output, printed) == []
    for name in re.findall(r"``(\w+\.(?:csv|png|pdf|tex))``", words):
        assert (folder / name).stat().st_size > 100, name


def test_there_are_examples() -> None:
    assert len(SCRIPTS) >= 5
    assert all(len(promised(script)[1].split()) > 5 for script in SCRIPTS)
