"""What importing the symbolic stage does: it derives nothing, and makes no record."""

#: Prints who calls SymPy to derive something, or makes a record, while all modules of codegen
#: but those of scenes are imported: a scene file is data, and is checked when it is read.
WATCH = """
import importlib, pkgutil, sys
import sympy as sp

found = set()

def watch(owner, name):
    whole = getattr(owner, name)
    def watched(*arguments, **options):
        caller = sys._getframe(1).f_code.co_filename
        if "/codegen/" in caller:
            found.add(f"{name} in {caller.rpartition('/codegen/')[2]}")
        return whole(*arguments, **options)
    setattr(owner, name, watched)

for name in (
    "integrate", "diff", "simplify", "factor", "solve", "combsimp", "expand", "expand_trig",
    "expand_func", "collect", "powsimp", "cancel", "degree",
):
    watch(sp, name)
for name in ("diff", "simplify", "factor", "expand", "doit"):
    watch(sp.Expr, name)
watch(importlib.import_module("sympy.simplify.fu"), "TR8")

def modules(package):
    for module in pkgutil.iter_modules(package.__path__, f"{package.__name__}."):
        if not module.name.startswith("nonsmooth.codegen.scenes."):
            made = importlib.import_module(module.name)
            if module.ispkg:
                yield from modules(made)
            yield module.name

from nonsmooth.codegen import system
for name in ("Equation", "GalerkinSystem"):
    watch(getattr(system, name), "__init__")
count = len(list(modules(importlib.import_module("nonsmooth.codegen"))))
print(count > 60, sorted(found))
from nonsmooth.codegen import derive
derive("hb-c1")
print(sorted(found))
"""


def test_importing_derives_nothing_and_what_derives_is_seen(python) -> None:
    imported, said = python(WATCH).splitlines()
    assert imported == "True []"
    for name in ("integrate", "expand", "diff", "factor"):
        assert f"'{name} in expansions/hb_c1.py'" in said, name
    assert "'__init__ in equations/" in said
