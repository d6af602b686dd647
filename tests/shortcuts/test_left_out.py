"""The house stands without its shortcuts: the tests of scenes and expansions pass in a copy."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from shown import ROOT

#: What is left out of the copy: every room of shortcuts, and the tests of it.
LEFT_OUT = (
    "codegen/shortcuts", "generated/shortcuts", "solver/shortcuts", "src/nonsmooth/shortcuts",
    "src/nonsmooth/cli/shortcuts", "src/nonsmooth/files/shortcuts",
    "src/nonsmooth/plots/shortcuts", "tests/shortcuts",
)  # fmt: skip

#: What the copy is made of.
KEPT = (
    "codegen",
    "generated",
    "solver",
    "src",
    "tests",
    "docs",
    "examples",
    "README.md",
    "CONTRIBUTING.md",
)

#: Tests of scenes and expansions, a few of them and all.
SOME = (
    "tests/scene/test_packages_listed.py",
    "tests/scene/test_scene_units.py",
    "tests/scenes/test_case.py",
    "tests/cli_scenes/test_scene_commands.py::test_the_list_of_scenes",
    "tests/cli_scenes/test_scene_commands.py::test_a_case_file_names_its_scene",
)
ALL = ("tests/scene", "tests/scenes", "tests/galerkin", "tests/cli_scenes", "tests/show")

USE = """
import nonsmooth as ns
for name in ns.scenes():
    case = ns.scene(name)()
    orbit = ns.solve(case, "hb", 6)
    assert orbit.admissible and ns.exact(case).period > 0
    assert ns.sweep(case, ["hb"], [6]).rows[0].period == orbit.period
for wrong in (3, "impact"):
    try:
        ns.solve(wrong)
    except TypeError as error:
        print(error)
from nonsmooth.solver.shortcut import entrances, table
print(table(), entrances())
"""


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a copy of the project without the rooms of shortcuts."""
    copy = tmp_path_factory.mktemp("house")
    away = {ROOT / name for name in LEFT_OUT}

    def ignored(folder: str, names: list[str]) -> list[str]:
        return [q for q in names if Path(folder) / q in away or q == "__pycache__"]

    for name in KEPT:
        source = ROOT / name
        if source.is_dir():
            shutil.copytree(source, copy / name, symlinks=True, ignore=ignored)
        else:
            shutil.copy(source, copy / name)
    rows = (ROOT / "pyproject.toml").read_text("utf-8").splitlines(keepends=True)
    kept = [row for row in rows if not (row.startswith('  "nonsmooth.') and "shortcuts" in row)]
    (copy / "pyproject.toml").write_text("".join(kept), "utf-8")
    return copy


def ran(house: Path, *arguments: str) -> tuple[int, str]:
    """Run Python in the copy; exit status and what it printed."""
    environment = os.environ | {"PYTHONPATH": str(house / "src")}
    for name in ("PYTEST_XDIST_WORKER", "PYTEST_CURRENT_TEST"):
        environment.pop(name, None)
    done = subprocess.run(
        [sys.executable, *arguments],
        cwd=house, env=environment, capture_output=True, text=True, check=False,
    )  # fmt: skip
    return done.returncode, done.stdout + done.stderr


def test_nothing_of_the_rooms_is_left(house: Path) -> None:
    assert all((ROOT / name).is_dir() for name in LEFT_OUT)
    assert not [q for q in house.rglob("shortcuts") if "tests" not in q.parts]
    status, said = ran(house, "-c", "import nonsmooth; print(nonsmooth.__file__)")
    assert (status, said.startswith(str(house))) == (0, True)


def test_every_scene_is_solved_from_python(house: Path) -> None:
    status, said = ran(house, "-c", USE)
    assert (status, said) == (
        0,
        "case: got 3, expected a case of a scene\n"
        "case: got 'impact', expected a case of a scene\n() ()\n",
    )


def test_the_default_scene_is_solved_as_any_other(house: Path) -> None:
    status, said = ran(house, "-m", "nonsmooth", "solve", "--order", "5", "--method", "c1")
    assert status == 0
    assert said.startswith("stick-slip: a mass on a moving belt, stick and slip (C1)\n")
    assert "our choice" not in said
    status, said = ran(house, "-m", "nonsmooth", "solve", "--order", "0", "--method", "c1")
    assert (status, said) == (
        2, "nonsmooth: --order: got 0, expected a whole number from 1 to 400 for ck\n",
    )  # fmt: skip
    status, said = ran(house, "-m", "nonsmooth", "--help")
    assert status == 0
    assert "Compute periodic orbits." in said
    assert "roots" not in said


def tested(house: Path, *places: str) -> tuple[int, str]:
    """Run tests in the copy."""
    options = ("-q", "-rf", "-p", "no:cacheprovider", "-m", "not long")
    return ran(house, "-m", "pytest", *options, *places)


def test_some_tests_of_scenes_pass(house: Path) -> None:
    status, said = tested(house, *SOME)
    assert status == 0, said


@pytest.mark.long
def test_all_tests_of_scenes_and_expansions_pass(house: Path) -> None:
    status, said = tested(house, *ALL)
    assert status == 0, said


@pytest.mark.long
def test_what_is_generated_is_what_the_copy_derives(house: Path) -> None:
    status, said = ran(house, "-m", "nonsmooth", "generate", "--check")
    assert (status, said.splitlines()[0]) == (0, "generated/ is up to date")
