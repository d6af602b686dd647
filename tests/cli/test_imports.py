"""What is imported when, which is what a command costs: in fresh interpreters."""

import subprocess
import sys
from collections.abc import Callable

import pytest

HEAVY = ("sympy", "numba", "scipy", "numpy", "matplotlib", "nonsmooth.codegen")

#: Of the standard library, what takes longest to import.
SLOW = {"asyncio", "concurrent.futures.process", "email", "http.client", "multiprocessing",
        "sqlite3", "unittest", "xml.etree"}  # fmt: skip

#: A command, and all modules that were not there before.
ALL = """
import sys
before = {*sys.modules}
from nonsmooth.cli import main
try:
    main(sys.argv[1:])
finally:
    print(*{*sys.modules} - before, file=sys.stderr)
"""


def imported(*arguments: str) -> set[str]:
    """Return the modules that a command imports in an interpreter of its own."""
    command = [sys.executable, "-c", ALL, *arguments]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    assert done.stdout
    return set(done.stderr.split())


def test_the_package_and_scenes_by_name_import_nothing_heavy(python) -> None:
    code = "import sys, nonsmooth as ns; ns.scene('impact'); ns.scenes()\n"
    assert python(f"{code}print([m for m in {HEAVY!r} if m in sys.modules])") == "[]\n"


def test_one_solve_imports_neither_sympy_nor_numba(python, tmp_path, monkeypatch) -> None:
    """Of each scene of one mass, where nothing is compiled: else that is loaded in time."""
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    code = "import sys, nonsmooth as ns\nfor scene in map(ns.scene, ns.scenes()):\n"
    code += "    scene.has_body or ns.solve(scene())\n"
    code += f"print([m for m in {HEAVY!r} if m in sys.modules])"
    assert python(code) == "['numpy']\n"


@pytest.mark.parametrize(
    ("arguments", "most"),
    [
        (("--help",), 65), (("solve", "--help"), 65), (("solve", "impact", "--help"), 65),
        (("simulate", "--help"), 65), (("simulate", "impact", "--help"), 65),
        (("scenes",), 110), (("scenes", "--json"), 110), (("scenes", "impact"), 65),
    ],
)  # fmt: skip
def test_lists_and_help_import_little(arguments, most: int) -> None:
    modules = imported(*arguments)
    packages = {name.partition(".")[0] for name in modules} - sys.stdlib_module_names
    ours = {name for name in packages if name.startswith("nonsmooth")}
    assert packages - ours <= {"click", "platformdirs"}
    assert not modules & SLOW
    assert "nonsmooth.codegen" not in modules
    assert len([name for name in modules if name.startswith("nonsmooth")]) <= most


def test_the_package_alone_imports_little(python) -> None:
    code = "import sys; before = {*sys.modules}; import nonsmooth\n"
    modules = set(python(f"{code}print(*{{*sys.modules}} - before)").split())
    assert [q for q in modules if q.partition(".")[0] not in sys.stdlib_module_names] == [
        "nonsmooth"
    ]
    assert not modules & SLOW


def test_the_solver_never_imports_sympy(python: Callable[[str], str]) -> None:
    code = """
import pkgutil, importlib, sys
import nonsmooth.solver
for module in pkgutil.iter_modules(nonsmooth.solver.__path__):
    importlib.import_module(f"nonsmooth.solver.{module.name}")
import nonsmooth as ns
from nonsmooth.kim_perkins import SECTION_4
ns.sweep(ns.StickSlip(**SECTION_4), orders=[2, 3])
print("sympy" in sys.modules, "nonsmooth.codegen" in sys.modules)
"""
    assert python(code) == "False False\n"


def test_the_symbolic_stage_imports_no_solver(python: Callable[[str], str]) -> None:
    code = "import sys, nonsmooth as ns; ns.equations('c1').latex()\n"
    code += "print([m for m in sys.modules if m.startswith(('nonsmooth.so', 'nonsmooth.g'))])"
    assert python(code) == "[]\n"


def test_every_public_name_is_there(python: Callable[[str], str]) -> None:
    code = "import nonsmooth as ns; print(all(getattr(ns, name) for name in ns.__all__))\n"
    code += "print(set(dir(ns)) >= set(ns.__all__))"
    assert python(code) == "True\nTrue\n"
