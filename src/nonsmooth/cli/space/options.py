"""The flags of a structure, and what they and a case file describe; the modes wanted."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import click

from ..about import PREFIX, CommandAbout, Given, Output, flag
from ..problems import Problem, as_problems

if TYPE_CHECKING:
    from nonsmooth.solver.space.attached import Attached
    from nonsmooth.solver.space.modes import Modes
    from nonsmooth.solver.space.structure import Structure


def command_of(
    structure: "Structure", said: str, run: Callable[..., int],
    options: list[click.Parameter], output: Output, help_: str, epilog: str,
) -> click.Command:  # fmt: skip
    """Return a command of a structure, which the user called so; see `CommandAbout`."""
    words = {"structure": said, "k": structure.k, "flag": flag(structure.attached.name)}
    place = click.Option(
        ["--position", f"{PREFIX}position"],
        help="a: place of the attachment as a part of the length, a fraction or a decimal; of "
        "a fraction nodes are recognised exactly.  [default: 3/10]",
    )
    flags = (
        click.Option(
            [flag(q.name), PREFIX + q.name],
            type=float,
            help=f"{q.symbol} in {q.unit}: {q.what}, {_range(structure, q.name)}.  "
            f"[default: {q.default:g}]",
        )
        for q in structure.parameters
    )
    return CommandAbout(structure, run, options, [place, *flags], output, help_, epilog, words)


def _range(structure: "Structure", name: str) -> str:
    spring = structure.kind == "stiffness" and name == structure.attached.name
    return "above the critical one, not 0" if spring else "above 0"


def attached_from(given: "Given[Structure]") -> "Attached":
    """Return the structure that the command line describes.

    What neither a flag nor the case file gives has its default.  A `Problem` has all mistakes
    at once.
    """
    from nonsmooth.solver.scenes.parameter_error import ParameterError
    from nonsmooth.solver.space.attached import attach

    values: dict[str, Any] = {**given.table(), **given.flags}
    try:
        return attach(given.about, **values)
    except ParameterError as error:
        said = (_as_flag(each) if given.file is None else each for each in error.errors)
        raise Problem(given.where + "; ".join(said)) from error


def _as_flag(error: str) -> str:
    name, colon, rest = error.partition(": ")
    return f"{flag(name)}{colon}{rest}" if colon and " " not in name else error


#: What asks for every expansion.
ALL = "all"


def compute(attached: "Attached", wanted: dict[str, Any]) -> "list[Modes]":
    """Return the modes by the method that is wanted, or by each.

    A `Problem` is raised if there are none such; with status 1 if no order is within the
    tolerance.
    """
    from nonsmooth.solver.space.expansions.methods import METHODS
    from nonsmooth.solver.space.modes import modes
    from nonsmooth.solver.space.tolerance import ToleranceNotMet

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
