"""What is imported when: in fresh interpreters."""

from collections.abc import Callable


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
