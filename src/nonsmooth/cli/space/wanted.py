"""The modes that are wanted on the command line: by one expansion, or by all three."""

from typing import Any

from nonsmooth.solver.space.attached import Attached
from nonsmooth.solver.space.expansions.methods import METHODS
from nonsmooth.solver.space.modes import Modes
from nonsmooth.solver.space.modes import modes as modes_of
from nonsmooth.solver.space.tolerance import ToleranceNotMet

from ..problems import Problem, as_problems

#: What asks for every expansion.
ALL = "all"


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
                found.append(modes_of(attached, **arguments))
        except Problem as problem:
            if isinstance(problem.__cause__, ToleranceNotMet):
                raise Problem(str(problem), 1) from problem
            if str(problem).startswith("--method"):
                raise Problem(f"{problem}; or {ALL}") from problem
            raise
    return found
