"""``nonsmooth digits SCENE``: digits that float64 keeps of orbits at a scene's extremes."""

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..about import Given, Output
from ..output import PICTURES, need, write_result
from ..problems import PLURAL, Problem, as_problems
from ..progress import progress
from ..values import parse_orders
from .options import case_from, command_of, method_names, motion_options

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from nonsmooth.solver.precision.digits import Kept
    from nonsmooth.solver.scenes.case import Case
    from nonsmooth.solver.scenes.loaded import LoadedScene

OUTPUT = Output("Write the digits: .json, or a picture .png, .svg, .pdf.", (".json", *PICTURES))

HELP = """Measure the digits that float64 keeps of the times of orbits of {name}.

{title}. At the given parameters and at each extreme that the scene names, the exact equations
and those of each method are solved in float64, and the same equations again in ball arithmetic.
Needs python-flint."""

EPILOG = """\b
Examples:
  nonsmooth digits {scene}
  nonsmooth digits {scene} --methods {best} --orders 5,10,20 -o digits.png
"""


def command(scene: "LoadedScene", said: str) -> click.Command:
    """Return ``nonsmooth digits`` of a scene, which the user called so."""
    names = ",".join(method_names(scene))
    options: list[click.Parameter] = [
        click.Option(["--methods"], help=f"By commas.  [default: {names}]"),
        click.Option(["--orders"], help="Numbers, ranges.  [default: 5,10,20,40]"),
        click.Option(["--quick"], is_flag=True, help="One order, 10."),
        *motion_options(scene),
    ]
    return command_of(scene, said, run, options, OUTPUT, HELP, EPILOG)


def run(
    given: "Given[LoadedScene]", methods: str | None, orders: str | None, quick: bool,
    json_: bool, output: Path | None,
) -> int:  # fmt: skip
    """Measure, show, write; the exit status."""
    need("flint", "digits", "precise", "python-flint")
    case = case_from(given)
    from nonsmooth.solver.kernels import registry
    from nonsmooth.solver.precision.digits import (
        ORDERS,
        QUICK_ORDERS,
        extremes,
        measure,
    )
    from nonsmooth.solver.scenes.methods import shown
    from nonsmooth.solver.scenes.parameter_error import ParameterError
    from nonsmooth.solver.search import HIGHEST_ORDER

    if quick and orders is not None:
        raise Problem(f"--quick: got --orders {orders} beside it, expected one of them")
    numbers = QUICK_ORDERS if quick else ORDERS
    if orders is not None:
        numbers = tuple(parse_orders(orders))
    if max(numbers) > HIGHEST_ORDER:
        raise Problem(f"--orders: got {max(numbers)}, expected at most {HIGHEST_ORDER}")
    with as_problems(PLURAL):
        names = list(registry.methods(case.scene))
        if methods is not None:
            parts = (part.strip() for part in methods.split(","))
            names = list(dict.fromkeys(registry.generic_method(case.scene, q) for q in parts))
    try:
        cases = extremes(case)
    except ParameterError as error:
        raise Problem(f"an extreme of {case.scene.name}: {error}") from error
    if len(cases) == 1:
        hint = "its field `extremes` names none, so that only these parameters are measured"
        click.echo(f"nonsmooth: {case.scene.name}: {hint}", err=True)
    with progress(len(cases) * (1 + len(names) * len(numbers)), "digits") as advance:

        def done(kept: "Kept") -> None:
            order = "" if kept.order is None else f", N = {kept.order}"
            advance(f"{kept.extreme or 'given'}: {shown(case.scene, kept.method)}{order}")

        try:
            found = measure(case, numbers, names, done)
        except ParameterError as error:
            raise Problem(str(error)) from None
    text = _text(case, found, names)
    if json_:
        click.echo(text, nl=False)
    else:
        from .shown import captions, digits_table

        click.echo(captions.caption(case))
        digits_table.print_digits(case, found)
    write_result(output, text, lambda: _figure(case, found))
    return 1 if any(kept.lost for kept in found) else 0


def _figure(case: "Case", found: "list[Kept]") -> "Figure":
    from .shown.digits_picture import digits_figure

    return digits_figure(case, found)


def _text(case: "Case", found: "list[Kept]", names: list[str]) -> str:
    from nonsmooth.files import documents

    rows = [
        asdict(kept) | {"digits": kept.digits, "met": kept.met, "conditioned": kept.conditioned}
        for kept in found
    ]
    head = {"scene": case.scene.name, "parameters": dict(case.values)}
    whole = head | {"lost": any(kept.lost for kept in found), "rows": rows}
    return documents.text(case, whole, names)
