"""``nonsmooth modes STRUCTURE``: the lowest modes by one expansion, or by all three."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..about import Given, Output
from ..named import STRUCTURES, NamedCommand
from ..output import DATA, PICTURES, drawn_by, write_result
from ..problems import Problem, as_problems
from .options import ALL, attached_from, command_of, compute

if TYPE_CHECKING:
    from nonsmooth.solver.space.attached import Attached
    from nonsmooth.solver.space.modes import Modes
    from nonsmooth.solver.space.structure import Structure

OUTPUT = Output(
    "Write the modes: .json, .csv, .nc; or a picture .png, .svg, .pdf.", (*DATA, *PICTURES)
)

EPILOG = """\b
Examples:
  nonsmooth modes
  nonsmooth modes beam-rotational-spring --position 3/10 --stiffness 10
  nonsmooth sweep beam-crack --orders 1-40
  nonsmooth equations beam-mass
"""

HELP = """Compute the lowest modes of {name}.

{title}; its modes are of class C{k}. The methods are those of the paper, in space: ritz has
sines, ritz-ck sines and forced modes, ck functions of class C{k} only. Every mode comes with
its error against the exact one and, where they hold, with proved bounds."""

EPILOG_OF = """\b
Examples:
  nonsmooth modes {structure} --position 3/10 {flag} 10
  nonsmooth modes {structure} --method all --order 12 -o modes.png
  nonsmooth modes {structure} --forced 2 --tol 1e-12 --count 3
  nonsmooth modes {structure} --vary position=1/20:1/2:10
  nonsmooth modes {structure} --shapes 101 -o shapes.csv
"""


@click.command(cls=NamedCommand, kinds=(STRUCTURES,), default=None, epilog=EPILOG)
@click.option("--json", "json_", is_flag=True, help="Print one JSON document.")
def modes(json_: bool) -> None:
    """Compute the lowest modes of a beam or a string with something attached.

    STRUCTURE is one of those that are listed without it; 'nonsmooth modes STRUCTURE --help'
    has its parameters.
    """
    from nonsmooth.solver.space.structure import load

    from ..scenes.shown.listing import columns

    structures = [load(name) for name in STRUCTURES.known()]
    if json_:
        from nonsmooth.files.json_text import as_json

        listed = [
            {"name": q.name, "class": f"C{q.k}", "what": q.title, "source": q.source}
            for q in structures
        ]
        click.echo(as_json({"structures": listed}))
        return
    rows = [(q.name, f"C{q.k}", f"--{q.attached.name}", q.title) for q in structures]
    click.echo(columns(("structure", "class", "attached", "what it is"), rows))


def command(structure: "Structure", said: str) -> click.Command:
    """Return ``nonsmooth modes`` of a structure, which the user called so."""
    k, most = structure.k, structure.most_forced
    options: list[click.Parameter] = [
        click.Option(
            ["--method"], help=f"ritz, ritz-c{k}, c{k}, or all.  [default: ritz-c{k}]"
        ),
        click.Option(["--order"], type=int, help="N, the size.  [default: 8]"),
        click.Option(
            ["--forced"], type=int, metavar="K",
            help=f"Forced modes of ritz-c{k}, 1 to {most}.  [default: 1]",
        ),
        click.Option(["--count"], type=int, help="How many modes.  [default: 6]"),
        click.Option(
            ["--tol"], type=float, help="Choose N: largest relative error of a frequency."
        ),
        click.Option(
            ["--vary"], metavar="NAME=FROM:TO:POINTS",
            help="Modes over a parameter or the position.",
        ),
        click.Option(["--log"], is_flag=True, help="With --vary: points by a constant factor."),
        click.Option(
            ["--shapes"], type=int, metavar="POINTS",
            help="Mass-normalised shapes at so many places, to -o FILE or as --json.",
        ),
    ]  # fmt: skip
    return command_of(structure, said, run, options, OUTPUT, HELP, EPILOG_OF)


def run(
    given: "Given[Structure]", vary: str | None, log: bool, shapes: int | None, json_: bool,
    output: Path | None, **wanted: Any,
) -> int:  # fmt: skip
    """Compute the modes, or those over a parameter; the exit status."""
    attached = attached_from(given)
    if vary is None and log:
        raise Problem("--log: expected --vary with it")
    if shapes is not None:
        _check_shapes(shapes, vary, wanted["method"], json_, output)
    if vary is not None:
        from . import family

        return family.run(attached, wanted, vary, log, json_, output)
    return _run_once(attached, wanted, shapes, json_, output)


def _check_shapes(
    points: int, vary: str | None, method: str | None, json_: bool, output: Path | None
) -> None:
    if points < 2:
        raise Problem(f"--shapes: got {points}, expected a whole number from 2")
    if vary is not None:
        raise Problem("--shapes: got --vary with it, expected one structure")
    if method == ALL:
        raise Problem("--shapes: got --method all with it, expected one method")
    if not json_ and (output is None or output.suffix.lower() in PICTURES):
        raise Problem(f"--shapes: expected -o FILE that ends in one of {', '.join(DATA)}")


def _run_once(
    attached: "Attached", wanted: dict[str, Any], shapes: int | None, json_: bool,
    output: Path | None,
) -> int:  # fmt: skip
    """Compute the modes, show them, write them; the exit status."""
    from nonsmooth.files import documents
    from nonsmooth.files.json_text import sealed

    from . import mode_tables

    found = compute(attached, wanted)
    kind, data = ("modes", found) if shapes is None else ("shapes", [found[0].shapes(shapes)])
    text = sealed(documents.document_of(kind, data))
    if json_:
        click.echo(text, nl=False)
    else:
        click.echo(mode_tables.caption(attached))
        mode_tables.modes(found)
        click.echo(f"\n{mode_tables.legend(attached.structure)}")
    _warn(found)
    with as_problems():
        written = found if shapes is None else data[0]
        write_result(output, text, drawn_by("modes.modes_figure", found), written)
    return 0


def _warn(found: "list[Modes]") -> None:
    for expansion in found:
        if expansion.structure.kind == "compliance" and expansion.method == "ritz":
            words = "sines have no jump: these are the modes of the sound beam"
            click.echo(f"nonsmooth: ritz: {words}", err=True)
