"""``nonsmooth sweep SCENE --vary``: the orbit of a scene along one of its parameters."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..about import Given
from ..output import drawn_by, write_result
from ..problems import PLURAL, Problem, as_problems
from ..progress import progress
from ..values import Vary, is_whole, values_of
from .options import check_not_given, vary_from

if TYPE_CHECKING:
    from nonsmooth.solver.results.family import FamilyRow
    from nonsmooth.solver.scenes.case import Case
    from nonsmooth.solver.scenes.loaded import LoadedScene


def vary_of(given: "Given[LoadedScene]", text: str, log: bool) -> Vary[float]:
    """Return what ``--vary`` asks for; a `Problem` if a flag gives the parameter as well."""
    from nonsmooth.solver.family import MOST_VALUES

    vary = vary_from(given, text, MOST_VALUES, ":20", log)
    check_not_given(given, vary)
    return vary


def run(
    case: "Case", vary: Vary[float], methods: str | None, orders: str | None,
    functions: int | None, json_: bool, output: Path | None,
) -> int:  # fmt: skip
    """Follow the orbit, show it, write it; the exit status.

    A `Problem` is raised if an argument is wrong; or after Ctrl-C, once what was computed is
    shown and written.
    """
    from nonsmooth.files import documents
    from nonsmooth.solver.family import ORDER, family_case
    from nonsmooth.solver.results.family import FamilyInterrupted
    from nonsmooth.solver.scenes.methods import FIRST
    from nonsmooth.solver.scenes.parameter_error import ParameterError

    if orders is not None and not is_whole(orders):
        raise Problem(f"--orders: got {orders!r} beside --vary, expected one order")
    if methods is not None and "," in methods:
        raise Problem(f"--methods: got {methods!r} beside --vary, expected one method")
    order = ORDER if orders is None else int(orders)
    name = FIRST if methods is None else methods.strip()
    values = values_of(vary)
    interrupted = False
    with as_problems(PLURAL), progress(vary.count, "sweep") as advance:

        def told(row: "FamilyRow") -> None:
            advance(f"{vary.flag} = {row.value:g}")

        try:
            result = family_case(case, vary.parameter, values, name, order, functions, told)
        except ParameterError as error:
            raise Problem(f"--vary: {error}") from error
        except FamilyInterrupted as interrupt:
            result, interrupted = interrupt.done, True
    text = documents.text(case, result.as_dict(), [result.method])
    if json_:
        click.echo(text, nl=False)
    else:
        from .shown import captions, tables

        click.echo(captions.caption_of_family(result))
        tables.family(result)
    write_result(output, text, drawn_by("families.family_figure", result, vary.log), result)
    if interrupted:
        done = len(set(result["value"]))
        raise Problem(f"interrupted: {done} of {vary.count} values are done", 130)
    return 0 if all(row.status == "ok" for row in result.rows) else 1
