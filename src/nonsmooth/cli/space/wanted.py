"""The structure that flags and a case file describe, and the modes of it that are wanted."""

from typing import Any

from nonsmooth.solver.scenes.parameter_error import ParameterError
from nonsmooth.solver.space.attached import Attached, attach
from nonsmooth.solver.space.expansions.methods import METHODS
from nonsmooth.solver.space.modes import Modes, modes
from nonsmooth.solver.space.structure import Structure
from nonsmooth.solver.space.tolerance import ToleranceNotMet

from ..about import Given, flag
from ..problems import Problem, as_problems

#: What asks for every expansion.
ALL = "all"


def attached_from(given: Given[Structure]) -> Attached:
    """Return the structure that the command line describes.

    What neither a flag nor the case file gives has its default.  A `Problem` has all mistakes
    at once.
    """
    values: dict[str, Any] = {**given.table(), **given.flags}
    try:
        return attach(given.about, **values)
    except ParameterError as error:
        said = (_as_flag(each) if given.file is None else each for each in error.errors)
        raise Problem(given.where + "; ".join(said)) from error


def _as_flag(error: str) -> str:
    name, colon, rest = error.partition(": ")
    return f"{flag(name)}{colon}{rest}" if colon and " " not in name else error


def compute(attached: Attached, wanted: dict[str, Any]) -> list[Modes]:
    """Return the modes by the method that is wanted, or by each.

    A `Problem` is raised if there are none such; with status 1 if no order is within the
    tolerance.
    """
    given = {name: value for name, value in wanted.items() if value is not None}
    methods = METHODS if given.get("method") == ALL else (given.get("method"),)
    given.pop("method", None)
    forced = given.pop("forced", None)
    found = []
    for method in methods:
        arguments = given | ({} if method is None else {"method": method})
        if forced is not None and (len(methods) == 1 or method == "ritz-ck"):
            arguments["forced"] = forced
        try:
            with as_problems():
                found.append(modes(attached, **arguments))
        except Problem as problem:
            if isinstance(problem.__cause__, ToleranceNotMet):
                raise Problem(str(problem), 1) from problem
            if str(problem).startswith("--method"):
                raise Problem(f"{problem}; or {ALL}") from problem
            raise
    return found
