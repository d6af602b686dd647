"""What was compiled is never found again once a kernel, or the driver beside it, is another."""

import importlib
import importlib.util
import os
import shutil
import sys
import types
from collections.abc import Iterator
from pathlib import Path

import numba
import numpy as np
import pytest

from nonsmooth.solver.kernels import series

SOLVER = Path(series.__file__).parents[1]

#: A module as ``generated/`` has them: ``z0 z1 = 2`` and ``z0 + 3 z1 = 7``.
SMALL = """
def size(case, N):
    return 2

def residual(case, z, R):
    R[0], R[1] = z[0]*z[1] - 2, z[0] + 3*z[1] - 7

def jacobian(case, z, J):
    J[0, 0], J[0, 1], J[1, 0], J[1, 1] = z[1], z[0], 1, 3

def motion(case, z, p, u, derivative):
    return u
"""

#: Files of the driver, and edits of the same length by which it solves worse or not at all.
EDITS = {
    "linear": ("factor = A[i, k] / A[k, k]", "factor = A[k, k] / A[i, k]"),
    "iteration": ("factor = 1.0 / scales[i]", "factor = 3.0 / scales[i]"),
}


def touch(path: Path) -> None:
    os.utime(path, ns=(10**18, 10**18))


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Keep what is compiled in a folder of the test, and no bytecode."""
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path / "cache"))


def imported(path: Path) -> types.ModuleType:
    """Return a file as a module of its own, as a new process has it."""
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def forget() -> None:
    """Forget the copy of the solver."""
    for name in [name for name in sys.modules if name.partition(".")[0] == "edited"]:
        del sys.modules[name]
    importlib.invalidate_caches()


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Return a copy of the solver that can be edited and imported anew."""
    copied = tmp_path / "edited" / "solver"
    shutil.copytree(SOLVER, copied, ignore=shutil.ignore_patterns("__pycache__"))
    for name in EDITS:
        touch(copied / "iteration" / f"{name}.py")
    (tmp_path / "edited" / "__init__.py").touch()
    shutil.copy(SOLVER.parent / "nearest.py", tmp_path / "edited")
    for name in ("__init__.py", "methods.py", "ck.py", "hb.py", "hb_c1.py"):
        (tmp_path / "edited" / "generated").mkdir(exist_ok=True)
        shutil.copy(SOLVER.parent / "generated" / name, tmp_path / "edited" / "generated")
    (tmp_path / "small.py").write_text(SMALL)
    monkeypatch.syspath_prepend(tmp_path)
    yield copied
    forget()


#: Arrays of one phase, which nothing forces: what is looked at for the number of the durations.
CASE = tuple(np.zeros(shape) for shape in ((1, 5), (1, 11), (0,), (0, 4), (3,)))


def compiled(family, path: Path):
    """Return the functions of a file, compiled as those of a generated module are."""
    module = imported(path)
    sys.modules[module.__name__] = module
    for kept in ("inner", "compiled", "account_of"):
        getattr(family.__class__, kept).cache_clear()
    return family.compiled(module.__name__)


def solved(folder: Path) -> tuple[tuple[object, ...], int]:
    """Solve with the copy as a new process would; what is found, and hits of the cache."""
    forget()
    copy = importlib.import_module("edited.solver.kernels.series")
    iterate = compiled(copy.FAMILY, folder.parents[1] / "small.py")["iterate"]
    z = np.array([1.5, 1.0])
    found = iterate(CASE, z, 20)
    return (*found, *z), sum(iterate.stats.cache_hits.values())


@pytest.mark.long  # in every run the key is looked at: test_iteration_scenes.py
@pytest.mark.parametrize("edited", EDITS)
def test_an_edit_of_the_driver_is_compiled_anew(folder: Path, edited: str) -> None:
    """Even one that changes neither the size of the file nor its time."""
    path, (old, new) = folder / "iteration" / f"{edited}.py", EDITS[edited]
    before, hits = solved(folder)
    assert (hits, before[0]) == (0, 0)
    assert solved(folder) == (before, 1)
    text = path.read_text("utf-8")
    assert text.count(old) == 1
    assert len(old) == len(new)
    path.write_text(text.replace(old, new), "utf-8")
    touch(path)
    after, hits = solved(folder)
    assert hits == 0
    assert after != before
    path.write_text(text, "utf-8")
    touch(path)
    assert solved(folder) == (before, 1)


def test_a_cached_kernel_never_survives_a_regeneration(tmp_path: Path) -> None:
    """A file with other mathematics, but the same size and time, is compiled anew."""
    path = tmp_path / "regenerated.py"

    def start(text: str) -> tuple[list[float], int]:
        path.write_text(text)
        touch(path)
        residual, R = compiled(series.FAMILY, path)["residual"], np.empty(2)
        residual(CASE, np.array([3.0, 0.5]), R)
        return R.tolist(), sum(residual.stats.cache_hits.values())

    before, hits = start(SMALL)
    assert hits == 0
    assert start(SMALL) == (before, 1)
    other = SMALL.replace("z[0]*z[1] - 2", "z[0]*z[1] - 3")
    assert len(other) == len(SMALL)
    assert start(other) == ([before[0] - 1, before[1]], 0)
