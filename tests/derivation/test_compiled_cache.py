"""An edit of Newton's method or its linear algebra is never answered by old machine code."""

import importlib
import os
import shutil
import sys
import types
from collections.abc import Iterator
from pathlib import Path

import numba
import numpy as np
import pytest

from nonsmooth.solver.shortcuts.search import kernels

SOLVER = Path(kernels.__file__).parents[2]

#: Where the files of the driver stand in the solver.
PLACES = {
    "linear": "iteration/linear.py",
    "newton": "shortcuts/search/newton.py",
    "kernels": "shortcuts/search/kernels.py",
}

#: A module as ``generated/`` has them, with one function.
GENERATED = types.ModuleType("generated")
exec("BODY = 'the text of this module'\ndef size(N):\n    return N + 3\n", vars(GENERATED))

#: The file, its function, an edit of the same length, and arguments of which it changes the
#: result.
EDITS = {
    "linear": (
        "factorise",
        ("factor = A[i, k] / A[k, k]", "factor = A[k, k] / A[i, k]"),
        lambda: (np.array([[4.0, 1.0], [2.0, 3.0]]), np.zeros(2, dtype=np.int64)),
    ),
    "newton": (
        "largest",
        ("size = abs(value)", "size = 2.0*value "),
        lambda: (np.arange(3.0),),
    ),
}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Return the folder of a copy of the solver that can be edited and imported anew."""
    package = tmp_path / "edited"
    copied = package / "solver"
    shutil.copytree(SOLVER, copied, ignore=shutil.ignore_patterns("__pycache__"))
    for place in PLACES.values():
        os.utime(copied / place, ns=(10**18, 10**18))
    (package / "__init__.py").touch()
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path / "cache"))
    yield package
    for name in [name for name in sys.modules if name.partition(".")[0] == "edited"]:
        del sys.modules[name]


def run(edited: str) -> tuple[list, int]:
    """Compile a function of the copy as a new process would; its results and cache hits."""
    for name in [name for name in sys.modules if name.partition(".")[0] == "edited"]:
        del sys.modules[name]
    importlib.invalidate_caches()
    copy = importlib.import_module("edited.solver.shortcuts.search.kernels")
    name, _, arguments = EDITS[edited]
    function, values = copy.compile_functions(GENERATED)[name], arguments()
    result = function(*values)
    return [result, *(v.tolist() for v in values)], sum(function.stats.cache_hits.values())


@pytest.mark.parametrize("edited", EDITS)
def test_an_edit_of_the_driver_is_compiled_anew(folder: Path, edited: str) -> None:
    """Even one that changes neither the size of the file nor its time."""
    path = folder / "solver" / PLACES[edited]
    before, hits = run(edited)
    assert hits == 0
    again, hits = run(edited)
    assert (again, hits) == (before, 1)
    old, new = EDITS[edited][1]
    text = path.read_text("utf-8")
    assert text.count(old) == 1
    assert len(old) == len(new)
    path.write_text(text.replace(old, new), "utf-8")
    os.utime(path, ns=(10**18, 10**18))
    after, hits = run(edited)
    assert hits == 0
    assert after != before
    path.write_text(text, "utf-8")
    os.utime(path, ns=(10**18, 10**18))
    assert run(edited) == (before, 1)


def test_all_that_is_compiled_is_in_the_fingerprint(monkeypatch: pytest.MonkeyPatch) -> None:
    """The files of the driver's functions, and the text of the generated module."""
    text = kernels._driver_text()
    for function in kernels.DRIVER:
        assert Path(function.__code__.co_filename).read_bytes() in text
    found = {kernels.fingerprint(kernels.module(method)) for method in kernels.MODULES}
    assert len(found) == len(kernels.MODULES)
    before = kernels.fingerprint(kernels.module("c1"))
    monkeypatch.setattr(kernels, "_driver_text", lambda: text + b"#")
    assert kernels.fingerprint(kernels.module("c1")) != before
