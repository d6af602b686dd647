"""``nonsmooth roots`` and the report on the figures of the paper; the report on any scene."""

from collections.abc import Iterator
from dataclasses import asdict
from typing import TYPE_CHECKING, Any, cast

import click

from nonsmooth.files.json_text import as_json

from ..about import Given, Verb, option
from ..output import (
    FOR_REPORTS,
    PICTURES,
    Destination,
    check_folder,
    check_target,
    write_folder,
    write_whole,
)
from ..problems import as_problems
from ..progress import busy, progress

if TYPE_CHECKING:
    from nonsmooth.all_solutions import RealSolution
    from nonsmooth.kim_perkins import StickSlip

    from ..columns import Piece

#: The figures of the paper.
FIGURES = ("1", "2", "3", "4", "5", "6")
OF_FIGURE = "Draw only this figure of the paper, into the file -o."

#: Columns of what is said of a solution: the numbers beside it take at most 46.
VERDICT = 34

#: Highest order of `roots`: the polynomial has twice as many coefficients, of many digits.
MOST = 40

ROOTS = Verb(
    ".commands.paper.roots",
    """List all real solutions of the paper's C1 series.

Those of its equations (18) to (20), and which one is the orbit. With the coefficients
eliminated they are the positive roots of one polynomial in the slip duration,
alpha D(s**2) = s E(s**2), isolated in exact arithmetic.""",
    """  nonsmooth roots --order 7
  nonsmooth roots --order 4 --normal-force 100
""",
    lambda _: [option("--order", click.IntRange(1, MOST), "N of (15).", required=True)],
)

REPORT = Verb(
    ".commands.paper.report",
    """Write a page that recomputes the paper, or about a scene.

For the parameters given: Figs. 2 to 6 of the paper, its equations, and its claims one by one,
each with the normal forces for which it holds. With another SCENE: its orbit, its equations,
and how fast each expansion converges. The page needs no network.""",
    """  nonsmooth report -o report
  nonsmooth report --normal-force 98.1 -o report
  nonsmooth report --figure 5 -o fig5.pdf
  nonsmooth report impact --gap 0.2 -o impact
""",
    lambda _: [option("--figure", click.Choice(FIGURES), OF_FIGURE)],
    folder="Folder to make: index.html, and every figure as .svg and .pdf; with --figure a "
    "picture: .png, .svg, .pdf.",
    needs=FOR_REPORTS,
)


def _belt(given: Given[Any]) -> "StickSlip":
    """Return the oscillator that the command line describes."""
    from ..scenes.case import case_from

    belt = case_from(given)
    return cast("StickSlip", belt)


def roots(given: Given[Any], to: Destination, order: int) -> int:
    """Isolate the solutions, show them; the exit status."""
    from nonsmooth.all_solutions import solutions

    belt = _belt(given)
    with busy(f"all solutions of order {order}"):
        isolated = solutions(belt, order)
    rows = [asdict(root) | {"admissible": not root.violations} for root in isolated]
    document = {"order": order, "parameters": dict(belt.values), "roots": rows}
    to.show(lambda: f"{as_json(document)}\n", _pieces(belt, isolated))
    return 0 if any(not root.violations for root in isolated) else 1


def _pieces(belt: "StickSlip", isolated: "list[RealSolution]") -> "Iterator[Piece]":
    """Show one row a solution; a long verdict goes on in the next line."""
    from ..columns import table_of
    from ..scenes.captions import caption

    yield caption(belt)
    table = table_of("slip [s]", "t1 [s]", "T [s]", "mismatch")
    table.add_column("verdict", overflow="fold", max_width=VERDICT)
    for root in isolated:
        numbers = (f"{number:.6g}" for number in (root.slip, root.t1, root.period))
        verdict = root.violations[0] if root.violations else "the orbit"
        mismatch = root.transition_mismatch
        table.add_row(*numbers, "" if mismatch is None else f"{mismatch:.1e}", verdict)
    yield table


def report(given: Given[Any], to: Destination, figure: str | None) -> int:
    """Recompute the paper, write the page or one figure; the exit status."""
    folder = to.file
    assert folder is not None
    if figure is not None:
        check_target(folder, PICTURES)
    belt = _belt(given)
    from nonsmooth.report.build import FILES, STEPS, build, write_plate

    if figure is not None:
        write_whole(folder, lambda target: write_plate(belt, int(figure), target))
        return 0
    check_folder(folder, FILES)
    with progress(STEPS, "report") as done:
        write_folder(folder, lambda target: build(belt, target, done))
    return 0


def report_on(given: Given[Any], to: Destination) -> int:
    """Compute what a page on any scene says, write it; the exit status."""
    from nonsmooth.report.scenes.scene_page import FILES, build, count
    from nonsmooth.solver.exact import exact_orbit

    from ..scenes.case import case_from

    case = case_from(given)
    folder = to.file
    assert folder is not None
    check_folder(folder, FILES)
    with as_problems():
        exact = exact_orbit(case)
    case = exact.case  # of the motion that occurs, where the scene has several
    with progress(count(case), "report") as done:
        write_folder(folder, lambda target: build(case, exact, given.said, target, done))
    return 0
