"""What the documentation shows is what the program does: doctests and README."""

import doctest
import importlib
import pkgutil
import re
import shlex
from pathlib import Path

import pytest

import nonsmooth

ROOT = Path(__file__).resolve().parent.parent
README = (ROOT / "README.md").read_text("utf-8")


def modules() -> list[str]:
    found = pkgutil.walk_packages(nonsmooth.__path__, "nonsmooth.")
    return ["nonsmooth", *(m.name for m in found if not m.name.endswith("__main__"))]


@pytest.mark.parametrize("name", modules())
def test_examples_in_docstrings_run(name: str) -> None:
    result = doctest.testmod(importlib.import_module(name))
    assert result.failed == 0


def test_some_docstrings_have_examples() -> None:
    finder = doctest.DocTestFinder(exclude_empty=True)
    names = ("solver.solve", "solver.sweep", "solver.belt", "solver.motion", "cli.orders")
    for name in names:
        module = importlib.import_module(f"nonsmooth.{name}")
        assert any(test.examples for test in finder.find(module)), name


def test_python_examples_of_the_readme_run() -> None:
    result = doctest.testfile(str(ROOT / "README.md"), module_relative=False)
    assert result.attempted > 3
    assert result.failed == 0


def blocks() -> list[tuple[str, str]]:
    """Return each command of the README's console blocks with the output shown."""
    text = "\n".join(re.findall(r"```console\n(.*?)```", README, flags=re.DOTALL))
    parts = re.split(r"^\$ ", text, flags=re.MULTILINE)[1:]
    commands = [part.partition("\n") for part in parts]
    return [(line, out) for line, _, out in commands if line.startswith("nonsmooth ")]


def same(shown: str, printed: str) -> bool:
    """Whether two words are the same, or the same number to rounding."""
    if shown == printed:
        return True
    try:
        return float(printed) == pytest.approx(float(shown), rel=1e-2, abs=1e-13)
    except ValueError:
        return False


@pytest.mark.parametrize(("command", "output"), [b for b in blocks() if b[1].strip()])
def test_output_in_the_readme_is_what_the_command_prints(
    run, command: str, output: str
) -> None:
    _, out, err = run(*shlex.split(command)[1:])
    shown, printed = output.split(), (out + err).split()
    assert len(shown) == len(printed)
    different = [pair for pair in zip(shown, printed, strict=True) if not same(*pair)]
    assert different == []


def test_the_readme_shows_real_output() -> None:
    assert sum(bool(output.strip()) for _, output in blocks()) >= 2


def test_every_place_that_the_readme_names_exists() -> None:
    for path in re.findall(r"`((?:codegen|solver|generated|tests|docs)/[\w./]+)`", README):
        assert (ROOT / path).exists(), path
    for path, name in re.findall(r"`((?:codegen|generated|solver)/\w+\.py)`: `(\w+)`", README):
        assert re.search(
            rf"(def |class |^){name}\b", (ROOT / path).read_text(), re.MULTILINE
        ), (
            path,
            name,
        )


def test_every_equation_of_the_paper_is_in_the_readmes_index() -> None:
    index = README.split("## Where each equation is")[1].split("\n## ")[0]
    numbers = {int(n) for row in re.findall(r"^\| ([\d, -]+) \|", index, re.MULTILINE)
               for n in expand(row)}  # fmt: skip
    assert numbers == set(range(1, 23))


def expand(row: str) -> list[str]:
    numbers = []
    for part in row.split(","):
        first, _, last = part.strip().partition("-")
        numbers += [str(n) for n in range(int(first), int(last or first) + 1)]
    return numbers
