"""``nonsmooth digits SCENE``: digits that float64 keeps of orbits at a scene's extremes."""

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..flint import need_flint
from ..output import PICTURES, check_target, write_text, write_whole
from ..problems import Problem, as_problems
from ..progress import progress
from ..values.orders import parse_orders
from .options import case_from, command_of, motion_options
from .solve import method_names

if TYPE_CHECKING:
    from nonsmooth.solver.precision.digits import Kept
    from nonsmooth.solver.scenes.case import Case
    from nonsmooth.solver.scenes.loaded import LoadedScene

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
    names = method_names(scene)
    options: list[click.Parameter] = [
        click.Option(["--methods"], help=f"By commas.  [default: {','.join(names)}]"),
        click.Option(["--orders"], help="Numbers, ranges.  [default: 5,10,20,40]"),
        click.Option(["--quick"], is_flag=True, help="One order, 10."),
        *motion_options(scene),
        click.Option(["--json", "json_"], is_flag=True, help="Print one JSON document."),
        click.Option(
            ["-o", "--output"], type=click.Path(path_type=Path),
            help="Write the digits: .json, or a picture .png, .svg, .pdf.",
        ),
    ]  # fmt: skip

    def callback(
        methods: str | None, orders: str | None, quick: bool, case: Path | None, json_: bool,
        output: Path | None, **flags: Any,
    ) -> int:  # fmt: skip
        check_target(output, (".json", *PICTURES))
        need_flint("digits")
        return run(case_from(scene, case, flags), methods, orders, quick, json_, output)

    words = {"name": scene.name, "title": scene.title.capitalize()}
    epilog = EPILOG.format(scene=said, best=names[-1])
    return command_of(scene, callback, options, HELP.format(**words), epilog)


def run(
    case: "Case", methods: str | None, orders: str | None, quick: bool, json_: bool,
    output: Path | None,
) -> int:  # fmt: skip
    """Measure, show, write; the exit status."""
    from nonsmooth.solver.kernels import registry
    from nonsmooth.solver.precision.digits import (
        ORDERS,
        QUICK_ORDERS,
        extremes,
        measure,
    )
    from nonsmooth.solver.scenes.method_names import shown
    from nonsmooth.solver.scenes.parameter_error import ParameterError
    from nonsmooth.solver.solve import HIGHEST_ORDER

    if quick and orders is not None:
        raise Problem(f"--quick: got --orders {orders} beside it, expected one of them")
    numbers = QUICK_ORDERS if quick else ORDERS
    if orders is not None:
        numbers = tuple(parse_orders(orders))
    if max(numbers) > HIGHEST_ORDER:
        raise Problem(f"--orders: got {max(numbers)}, expected at most {HIGHEST_ORDER}")
    with as_problems(plural=True):
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

        found = measure(case, numbers, names, done)
    text = _text(case, found, names)
    if json_:
        click.echo(text, nl=False)
    else:
        from .shown import captions, digits

        click.echo(captions.caption(case))
        digits.table(case, found)
    if output is not None and output.suffix.lower() == ".json":
        write_text(output, text)
    elif output is not None:
        from .shown.digits_picture import digits_picture

        write_whole(output, lambda target: digits_picture(case, found, target))
    return 1 if any(kept.lost for kept in found) else 0


def _text(case: "Case", found: "list[Kept]", names: list[str]) -> str:
    from nonsmooth.files import documents

    rows = [
        asdict(kept) | {"digits": kept.digits, "met": kept.met, "conditioned": kept.conditioned}
        for kept in found
    ]
    head = {"scene": case.scene.name, "parameters": dict(case.values)}
    whole = head | {"lost": any(kept.lost for kept in found), "rows": rows}
    return documents.text(case, whole, names)
