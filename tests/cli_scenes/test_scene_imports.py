"""What commands about scenes import, and what they cost: in fresh interpreters."""

import resource
import subprocess
import sys

import pytest

HEAVY = ("sympy", "numba", "scipy", "numpy", "matplotlib", "nonsmooth.codegen")

#: Seconds of CPU above the interpreter's own, and how often the least is looked for.
COST, TRIES = 0.15, 5

RUN = """
import sys
from nonsmooth.cli import main
try:
    main(sys.argv[1:])
finally:
    print([m for m in {heavy!r} if m in sys.modules], file=sys.stderr)
"""


def cost(*arguments: str) -> float:
    """Return the CPU time of an interpreter, the least of some."""
    found = []
    for _ in range(TRIES):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([sys.executable, *arguments], check=True, capture_output=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        found.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return min(found)


@pytest.mark.parametrize(
    "arguments",
    [("--help",), ("scenes",), ("scenes", "impact"), ("solve", "impact", "--help"),
     ("solve", "--help"), ("scenes", "--json"), ("simulate", "--help"),
     ("simulate", "impact", "--help")],
)  # fmt: skip
def test_lists_and_help_import_nothing_heavy(arguments) -> None:
    done = subprocess.run(
        [sys.executable, "-c", RUN.format(heavy=HEAVY), *arguments],
        check=True, capture_output=True, text=True,
    )  # fmt: skip
    assert done.stderr == "[]\n"
    assert done.stdout


def test_the_package_and_scenes_by_name_import_nothing_heavy(python) -> None:
    code = "import sys, nonsmooth as ns; ns.scene('impact'); ns.scenes()\n"
    assert python(f"{code}print([m for m in {HEAVY!r} if m in sys.modules])") == "[]\n"


def test_one_solve_imports_neither_sympy_nor_numba(python) -> None:
    code = "import sys, nonsmooth as ns\nfor name in ns.scenes(): ns.solve(ns.scene(name)())\n"
    code += f"print([m for m in {HEAVY!r} if m in sys.modules])"
    assert python(code) == "['numpy']\n"


@pytest.mark.parametrize("arguments", [("--help",), ("scenes",)])
def test_lists_and_help_are_quick(arguments) -> None:
    assert cost("-m", "nonsmooth", *arguments) - cost("-c", "pass") < COST


def test_the_import_is_quick() -> None:
    assert cost("-c", "import nonsmooth") - cost("-c", "pass") < COST
