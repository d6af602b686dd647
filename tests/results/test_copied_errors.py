"""Errors that go from one process to another, or are copied, say what they said."""

import ast
import copy
import pickle
from pathlib import Path

import pytest
from shown import ROOT

from nonsmooth.cli.problems import Problem
from nonsmooth.codegen.scene.error import SceneError
from nonsmooth.codegen.system import DerivationError
from nonsmooth.files.file_errors import FileError
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.orbit.errors import Errors
from nonsmooth.solver.scenes.parameter_error import ParameterError
from nonsmooth.solver.trade.choice import NotCertified, TooSlow, Trial

TRIAL = Trial("ck", 4, Errors(1e-3, 1e-4, 1e-2, 1e-5), 0.1)

#: What exceptions of the package are derived from.
BASES = {"Exception", "ValueError", "ArithmeticError", "ImportError"}

#: One of each class that has an ``__init__``, and of two that have none.
ERRORS = (
    FileError(Path("a/b.json"), "damaged: not JSON"),
    ParameterError(["mass: got -1", "gapp: not a parameter"]),
    NoOrbit("none exists", True, ("one", "two")),
    TooSlow(1e-9, 0.5),
    NotCertified(1e-20, (TRIAL,), 0.0),
    Problem("--case: no\nsuch file", 1),
    SceneError("phases: none"),
    DerivationError("an integral is left"),
)


def _own() -> set[str]:
    """Return the names of the exceptions of the package that have an ``__init__``."""
    found = set()
    for path in (
        path for top in ("src", "solver", "codegen") for path in (ROOT / top).rglob("*.py")
    ):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.ClassDef) and {ast.unparse(b) for b in node.bases} & BASES:
                functions = (n for n in node.body if isinstance(n, ast.FunctionDef))
                found |= {node.name for each in functions if each.name == "__init__"}
    return found


def _said(error: BaseException) -> tuple[object, ...]:
    return type(error), str(error), repr(error), vars(error)


@pytest.mark.parametrize("error", ERRORS, ids=lambda error: type(error).__name__)
def test_what_is_pickled_or_copied_says_the_same(error: BaseException) -> None:
    error.__dict__["iterations"] = 3  # as the search sets it on its way
    for again in (pickle.loads(pickle.dumps(error)), copy.copy(error), copy.deepcopy(error)):
        assert _said(again) == _said(error)


def test_every_error_of_its_own_is_among_them() -> None:
    assert _own() == {
        type(error).__name__ for error in ERRORS if "__init__" in vars(type(error))
    }
