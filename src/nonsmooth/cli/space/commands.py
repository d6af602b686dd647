"""The commands about a structure as the command line shows them; `scenes.commands` is alike."""

from typing import TYPE_CHECKING

import click

from ..about import PREFIX, CommandAbout, Output, Verb, flag
from ..aliases import Once
from ..output import DATA, PICTURES

if TYPE_CHECKING:
    from nonsmooth.solver.space.structure import Structure

#: Orders of a sweep that names none.
ORDERS = "1-20"


def _of_modes(structure: "Structure") -> list[click.Parameter]:
    """Return the options of ``nonsmooth modes``."""
    k, most = structure.k, structure.most_forced
    return [
        click.Option(
            ["--method"], help=f"ritz, ritz-c{k}, c{k}, or all.  [default: ritz-c{k}]"
        ),
        click.Option(
            ["--order"], type=int,
            help="N: number of sines, or degree of polynomials.  [default: 8]",
        ),
        click.Option(
            ["--forced"], type=int, metavar="K",
            help=f"Forced modes of ritz-c{k}, 1 to {most}.  [default: 1]",
        ),
        click.Option(["--count"], type=int, help="How many modes.  [default: 6]"),
        click.Option(
            ["--tol"], type=float, help="Choose N: largest relative error of a frequency."
        ),
        Once(
            ["--vary"], metavar="NAME=FROM:TO:POINTS",
            help="Vary a parameter or the position.",
        ),
        click.Option(["--log"], is_flag=True, help="Space its values by a constant factor."),
        click.Option(
            ["--shapes"], type=int, metavar="POINTS",
            help="Mass-normalised shapes at this number of points, to -o FILE or as --json.",
        ),
    ]  # fmt: skip


def _of_sweep(structure: "Structure") -> list[click.Parameter]:
    """Return the options of ``nonsmooth sweep``."""
    k, most = structure.k, structure.most_forced
    return [
        click.Option(
            ["--methods"],
            help=f"Methods, joined by commas.  [default: ritz,ritz-c{k},c{k}]",
        ),
        click.Option(
            ["--orders"],
            help="Orders N: numbers and ranges, as 4,8-12 or 10,20,...,80.  "
            f"[default: {ORDERS}]",
        ),
        click.Option(
            ["--forced"], metavar="K,K",
            help=f"Numbers of forced modes of ritz-c{k}, 1 to {most}.  [default: 1]",
        ),
        click.Option(["--mode"], type=int, help="Number of the mode.  [default: 1]"),
    ]  # fmt: skip


MODES = Verb(
    ".space.modes",
    _of_modes,
    Output(
        "Write the modes: .json, .csv, .nc; or a picture .png, .svg, .pdf.", (*DATA, *PICTURES)
    ),
    """Compute the lowest modes of {name}.

{title}; its modes are of class C{k}. The methods are those of the paper, in space: ritz has
sines, ritz-c{k} sines and forced modes, c{k} functions of class C{k} only. Every mode comes
with its error against the exact one and, where they are available, with proved bounds.""",
    """\b
Examples:
  nonsmooth modes {said} --position 3/10 {flag} 10
  nonsmooth modes {said} --method all --order 12 -o modes.png
  nonsmooth modes {said} --forced 2 --tol 1e-12 --count 3
  nonsmooth modes {said} --vary position=1/20:1/2:10
  nonsmooth modes {said} --shapes 101 -o shapes.csv
""",
)

SWEEP = Verb(
    ".space.sweep",
    _of_sweep,
    Output(
        "Write the rows: .csv, .json; or a picture .png, .svg, .pdf.",
        (".json", ".csv", *PICTURES),
    ),
    """Compute one mode of {name} for many orders and compare it with the exact one.

{title}; its modes are of class C{k}.""",
    """\b
Examples:
  nonsmooth sweep {said}
  nonsmooth sweep {said} --methods ritz,ritz-c{k} --forced 1,2 --orders 4,8,16,32
  nonsmooth sweep {said} --mode 3 -o convergence.png
""",
)

#: By the name of the command.
VERBS = {"modes": MODES, "sweep": SWEEP}


def command(verb: str, structure: "Structure", said: str) -> click.Command:
    """Return a command of a structure, which the user called so."""
    words = {"k": structure.k, "flag": flag(structure.attached.name)}
    place = click.Option(
        ["--position", f"{PREFIX}position"],
        help="a: place of the attachment divided by the length, as a fraction or a decimal; "
        "with a fraction, nodes are recognised exactly.  [default: 3/10]",
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
    return CommandAbout(structure, said, VERBS[verb], [place, *flags], words)


def _range(structure: "Structure", name: str) -> str:
    spring = structure.kind == "stiffness" and name == structure.attached.name
    return "above the critical one, not 0" if spring else "above 0"
