"""What only the paper's oscillator has: ``nonsmooth roots`` and the report on its figures."""

from collections.abc import Callable, Iterator
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nonsmooth.extras import require
from nonsmooth.files.json_text import as_json

from ..about import PREFIX, flag, given
from ..named import DEFAULT, NamedCommand, scene_named
from ..output import (
    FOR_REPORTS,
    PICTURES,
    Destination,
    check_folder,
    check_target,
    write_folder,
    write_whole,
)
from ..progress import busy, progress

if TYPE_CHECKING:
    from nonsmooth.all_solutions import RealSolution
    from nonsmooth.kim_perkins import StickSlip

    from ..columns import Piece

#: Flags, with what their help says.
FLAGS = {
    "mass": "M in kg",
    "stiffness": "K in N/m",
    "belt_speed": "V in m/s",
    "mu_s": "static friction coefficient",
    "mu_k": "kinetic friction coefficient, 0 <= mu_k < mu_s",
    "normal_force": "F_N in N",
}

#: The figures of the paper.
FIGURES = ("1", "2", "3", "4", "5", "6")

#: Columns of what is said of a solution: the numbers beside it take at most 46.
VERDICT = 34

#: Highest order of `roots`: the polynomial has twice as many coefficients, of many digits.
MOST = 40

EPILOG_OF_ROOTS = """\b
Examples:
  nonsmooth roots --order 7
  nonsmooth roots --order 4 --normal-force 100
"""

EPILOG_OF_REPORT = """\b
Examples:
  nonsmooth report -o report
  nonsmooth report --normal-force 98.1 -o report
  nonsmooth report --figure 5 -o fig5.pdf
  nonsmooth report impact --gap 0.2 -o impact
"""


def parameter_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add ``--case`` and one flag a parameter to a command."""
    for name, help_ in reversed(FLAGS.items()):
        command = click.option(flag(name), PREFIX + name, type=float, help=help_)(command)
    help_ = "Case file with a table [stick_slip]; flags override it."
    return click.option("--case", type=click.Path(path_type=Path), help=help_)(command)


def belt_from(case: Path | None, flags: dict[str, Any]) -> "StickSlip":
    """Return the oscillator that the command line describes.

    A `Problem` has all mistakes at once.
    """
    from nonsmooth.kim_perkins import StickSlip

    from ..scenes.case import case_from

    belt = case_from(given(scene_named(DEFAULT), case, flags))
    assert isinstance(belt, StickSlip)
    return belt


@click.command(epilog=EPILOG_OF_ROOTS)
@click.option("--order", type=click.IntRange(1, MOST), required=True, help="N of (15).")
@parameter_options
@click.option("--json", "json_", is_flag=True, help="Print one JSON document.")
def roots(order: int, case: Path | None, json_: bool, **flags: float | None) -> int:
    """List all real solutions of the paper's C1 series.

    Those of its equations (18) to (20), and which one is the orbit. With the coefficients
    eliminated they are the positive roots of one polynomial in the slip duration,
    alpha D(s**2) = s E(s**2), isolated in exact arithmetic.
    """
    from nonsmooth.all_solutions import solutions

    belt = belt_from(case, flags)
    with busy(f"all solutions of order {order}"):
        found = solutions(belt, order)
    rows = [asdict(each) | {"admissible": not each.violations} for each in found]
    document = {"order": order, "parameters": dict(belt.values), "roots": rows}
    Destination(json_, None).show(f"{as_json(document)}\n", _pieces(belt, found))
    return 0 if any(not each.violations for each in found) else 1


def _pieces(belt: "StickSlip", found: "list[RealSolution]") -> "Iterator[Piece]":
    """Show one row a solution; a long verdict goes on in the next line."""
    from ..columns import table_of
    from ..scenes.captions import caption

    yield caption(belt)
    table = table_of("slip [s]", "t1 [s]", "T [s]", "mismatch")
    table.add_column("verdict", overflow="fold", max_width=VERDICT)
    for each in found:
        numbers = (f"{number:.6g}" for number in (each.slip, each.t1, each.period))
        verdict = each.violations[0] if each.violations else "the orbit"
        off = each.transition_mismatch
        table.add_row(*numbers, "" if off is None else f"{off:.1e}", verdict)
    yield table


@click.command(cls=NamedCommand, own=True, epilog=EPILOG_OF_REPORT)
@parameter_options
@click.option(
    "--figure", type=click.Choice(FIGURES),
    help="Draw only this figure of the paper, into the file -o.",
)  # fmt: skip
@click.option(
    "-o", "--output", type=click.Path(path_type=Path), required=True,
    help="Folder to make: index.html, and every figure as .svg and .pdf; with --figure a "
    "picture: .png, .svg, .pdf.",
)  # fmt: skip
def report(case: Path | None, figure: str | None, output: Path, **flags: float | None) -> None:
    """Write a page that recomputes the paper, or about a scene.

    Without SCENE, for the parameters given: Figs. 2 to 6 of the paper, its equations, and its
    claims one by one, each with the normal forces for which it holds. With SCENE: its orbit,
    its equations, and how fast each expansion converges. The page needs no network.
    'nonsmooth report SCENE --help' has the parameters of a scene.
    """
    for library in FOR_REPORTS:
        require(*library)
    if figure is not None:
        check_target(output, PICTURES)
    belt = belt_from(case, flags)
    from nonsmooth.report.build import (
        FILES,
        STEPS,
        build,
        write_plate,
    )

    if figure is not None:
        write_whole(output, lambda target: write_plate(belt, int(figure), target))
        return
    check_folder(output, FILES)
    with progress(STEPS, "report") as done:
        write_folder(output, lambda folder: build(belt, folder, done))
