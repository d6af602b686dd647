"""``nonsmooth sweep SCENE --vary``: the orbit of a scene along one of its parameters."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..output import DATA, write_file, write_picture, write_text
from ..problems import Problem, as_problems
from ..progress import progress
from ..values.orders import is_whole
from ..values.vary import Vary, parse_vary

if TYPE_CHECKING:
    from nonsmooth.solver.family import Family, FamilyRow
    from nonsmooth.solver.scenes.case import Case
    from nonsmooth.solver.scenes.loaded import LoadedScene


def vary_of(scene: "LoadedScene", text: str, log: bool, given: dict[str, Any]) -> Vary:
    """Return what ``--vary`` asks for, of a scene.

    Raises
    ------
    Problem
        If it cannot be computed, or a flag gives the parameter as well.
    """
    from nonsmooth.solver.family import MOST_VALUES

    names = [q.name for q in scene.parameters]
    last = scene.parameters[-1]
    example = f"{last.name.replace('_', '-')}={last.default / 2:g}:{last.default:g}:20"
    vary = parse_vary(text, log, names, MOST_VALUES, example)
    if given.get(vary.parameter) is not None:
        raise Problem(f"--{vary.flag}: given beside --vary {vary.flag}, which sets it")
    return vary


def run(
    case: "Case", vary: Vary, methods: str | None, orders: str | None, functions: int | None,
    json_: bool, output: Path | None,
) -> int:  # fmt: skip
    """Follow the orbit, show it, write it; the exit status.

    Raises
    ------
    Problem
        If an argument is wrong; or after Ctrl-C, once what was computed is shown and written.
    """
    from nonsmooth.files import documents
    from nonsmooth.solver.family import (
        ORDER,
        FamilyInterrupted,
        family_case,
    )
    from nonsmooth.solver.scenes.methods import FIRST
    from nonsmooth.solver.scenes.parameter_error import ParameterError

    if orders is not None and not is_whole(orders):
        raise Problem(f"--orders: got {orders!r} beside --vary, expected one order")
    if methods is not None and "," in methods:
        raise Problem(f"--methods: got {methods!r} beside --vary, expected one method")
    order = ORDER if orders is None else int(orders)
    values = vary.values(0, vary.count).tolist()
    name = FIRST if methods is None else methods.strip()
    interrupted = False
    with as_problems(plural=True), progress(vary.count, "sweep") as advance:

        def done(row: "FamilyRow") -> None:
            advance(f"{vary.flag} = {row.value:g}")

        try:
            result = family_case(case, vary.parameter, values, name, order, functions, done)
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
    if output is not None:
        _write(output, text, result, vary.log)
    if interrupted:
        raise Problem(f"interrupted: {len(result)} of {vary.count} values are done", 130)
    return 0 if all(row.status == "ok" for row in result.rows) else 1


def _write(output: Path, text: str, result: "Family", log: bool) -> None:
    suffix = output.suffix.lower()
    if suffix == ".json":
        write_text(output, text)
    elif suffix in DATA:
        write_file(output, result)
    else:
        from nonsmooth.plots.families import family_figure

        write_picture(output, lambda: family_figure(result, log))
