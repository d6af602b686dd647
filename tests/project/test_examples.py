"""Every script of examples/ runs, and prints what its docstring says that it prints."""

import ast
import re
import runpy
from pathlib import Path

import pytest
from shown import ROOT, differences

#: A scene file is not a script: it is tested where its page is.
SCRIPTS = [
    path
    for path in sorted((ROOT / "examples").glob("*.py"))
    if "\nSCENE = " not in path.read_text("utf-8")
]


def promised(script: Path) -> tuple[str, str]:
    """Return what the docstring says of the script, and the output that it promises."""
    docstring = ast.get_docstring(ast.parse(script.read_text("utf-8"))) or ""
    words, _, output = docstring.partition("Prints::")
    return words, output


@pytest.mark.filterwarnings("ignore::DeprecationWarning:matplotlib")
@pytest.mark.parametrize("script", SCRIPTS, ids=lambda script: script.stem)
def test_an_example_prints_and_writes_what_it_says(
    script: Path, tmp_path: Path, monkeypatch, capsys
) -> None:
    monkeypatch.chdir(tmp_path)
    words, output = promised(script)
    runpy.run_path(str(script), run_name="__main__")
    printed, err = capsys.readouterr()
    assert (differences(output, printed), err) == ([], "")
    for name in re.findall(r"``(\w+\.(?:csv|png|pdf|tex))``", words):
        assert (tmp_path / name).stat().st_size > 100, name


def test_there_are_examples() -> None:
    assert len(SCRIPTS) >= 5
    assert all(len(promised(script)[1].split()) > 5 for script in SCRIPTS)
