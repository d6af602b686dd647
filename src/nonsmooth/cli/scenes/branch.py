"""``nonsmooth branch SCENE --vary``: an orbit followed along a parameter."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..about import Given, Output
from ..aliases import Aliased
from ..output import DATA, PICTURES, drawn_by, write_result
from ..problems import Problem, as_problems
from ..progress import busy
from .options import case_from, command_of, method_names, motion_options, vary_from
from .solve import FUNCTIONS
from .wanted import tell

if TYPE_CHECKING:
    from nonsmooth.solver.branches import Expansion
    from nonsmooth.solver.orbit.exact_orbit import ExactOrbit
    from nonsmooth.solver.results.branch import Branch
    from nonsmooth.solver.results.strobe import Diagram
    from nonsmooth.solver.scenes.case import Case
    from nonsmooth.solver.scenes.loaded import LoadedScene

#: Values of a diagram below a branch.
VALUES = 121

OUTPUT = Output(
    "Write the branch: .csv, .json, .nc; or a picture .png, .svg, .pdf.", (*DATA, *PICTURES)
)

HELP = """Follow the orbit of {name} along a parameter, stable or not, through folds.

{title}. The orbits are exact. Where the order of the phases changes the branch goes on with the
new one. Folds, flips, grazings and beginnings and ends of a rest are located to rounding."""

EPILOG = """\b
Examples:
  nonsmooth branch {scene} --vary {vary}
  nonsmooth branch {scene} --vary {vary} -o branch.svg
  nonsmooth branch {scene} --vary {vary} --all --json
"""


def command(scene: "LoadedScene", said: str) -> click.Command:
    """Return ``nonsmooth branch`` of a scene, which the user called so."""
    attractors = click.Option(
        ["--attractors"], is_flag=True,
        help="Draw over what simulations settle on, up and down, once a period of the forcing.",
    ),  # fmt: skip
    options: list[click.Parameter] = [
        click.Option(
            ["--vary"], metavar="NAME=FROM:TO", required=True,
            help="The parameter, and its range.",
        ),
        *motion_options(scene),
        click.Option(
            ["--from-orbit"], type=click.Path(path_type=Path, dir_okay=False), metavar="FILE",
            help="Start from an orbit that solve has written as .json or .nc.",
        ),
        click.Option(
            ["--all", "every"], is_flag=True,
            help="Follow every orbit that is found at a few values, and those at their flips.",
        ),
        *(attractors if scene.frequency else ()),
        Aliased(
            ["--method"], alias="--methods",
            help=f"Solve it beside each orbit: {', '.join(method_names(scene))}.",
        ),
        Aliased(["--order"], alias="--orders", type=int, help="Its order.  [default: 10]"),
        click.Option(["--functions"], type=int, metavar="K", help=FUNCTIONS),
    ]  # fmt: skip
    return command_of(scene, said, run, options, OUTPUT, HELP, EPILOG)


def run(
    given: "Given[LoadedScene]", vary: str, from_orbit: Path | None, every: bool, json_: bool,
    output: Path | None, attractors: bool = False, **expansion: Any,
) -> int:  # fmt: skip
    """Follow the branch, show it, write it; the exit status."""
    from nonsmooth.files import documents
    from nonsmooth.solver.branches import Expansion
    from nonsmooth.solver.no_orbit import NoOrbit
    from nonsmooth.solver.results.branch import BranchInterrupted

    along = vary_from(given, vary, None)
    if every and from_orbit is not None:
        raise Problem(f"--from-orbit: got {from_orbit} beside --all, expected one of them")
    suffix = "" if output is None else output.suffix.lower()
    if every and suffix in {".csv", ".nc"}:
        raise Problem(f"--output: got {output} beside --all, expected .json or a picture")
    if attractors and suffix not in PICTURES:
        raise Problem("--attractors: expected beside --output and a picture")
    case, start = _start(given, from_orbit)
    interrupted, found = False, []
    with as_problems():
        how = Expansion.checked(case, **expansion)
    try:
        with as_problems(), busy(f"following {case.scene.name}") as say:

            def seen(value: float) -> None:
                say(f"{along.flag} = {value:g}")

            found = _followed(case, along, every, start, seen, how)
    except NoOrbit as finding:
        tell(finding)
        return 1
    except BranchInterrupted as interrupt:
        interrupted, found = True, interrupt.done
    whole = {"branches": [q.as_dict() for q in found]} if every else found[0].as_dict()
    used = [how.method] if how.order else []
    text = documents.text(case, {"scene": case.scene.name} | whole, used)
    if json_:
        click.echo(text, nl=False)
    else:
        from .shown import captions, tables

        click.echo(captions.caption(case))
        for branch in found:
            tables.branch(branch)
    below = _diagrams(case, found[0], along) if attractors and not interrupted else ()
    write_result(output, text, drawn_by("families.branch_figure", found, below), found[0])
    if interrupted:
        raise Problem(f"interrupted: {sum(map(len, found))} orbits are found", 130)
    return 0


def _start(
    given: "Given[LoadedScene]", from_orbit: Path | None
) -> "tuple[Case, ExactOrbit | None]":
    """Return the case, and the exact orbit next to one in a file, if one is named.

    A `Problem` is raised if the file holds no orbit, or has parameters beside it.
    """
    if from_orbit is None:
        return case_from(given), None
    from nonsmooth.files.api import load
    from nonsmooth.files.file_errors import FileError
    from nonsmooth.solver.results.orbit import Orbit

    if given.flags or given.file is not None:
        name = next(iter(given.flags), "case")
        raise Problem(f"--{name}: given beside --from-orbit, which says it")
    try:
        orbit = load(from_orbit, scene=given.about)
    except (FileError, OSError) as error:
        raise Problem(f"--from-orbit: {error}") from error
    if not isinstance(orbit, Orbit) or orbit.exact is None:
        raise Problem(
            f"--from-orbit: {from_orbit}: holds no single orbit that is near an exact one"
        )
    return orbit.case, orbit.exact


def _followed(
    case: "Case", along: Any, every: bool, start: "ExactOrbit | None", seen: Any,
    how: "Expansion",
) -> "list[Branch]":  # fmt: skip
    from nonsmooth.solver.branches import branch_case, every_branch

    what = case, along.parameter, along.first, along.last
    if every:
        return every_branch(*what, seen, how)
    return [branch_case(*what, start, seen, how)]


def _diagrams(case: "Case", found: "Branch", along: Any) -> "tuple[Diagram, ...]":
    """Return what simulations settle on along a parameter, upwards and downwards."""
    import numpy as np

    from nonsmooth.solver.strobe import diagram

    low, high = sorted((along.first, along.last))
    up = np.linspace(low, high, VALUES)
    ways = (values.tolist() for values in (up, up[::-1]))
    with busy(f"simulating {case.scene.name}"):
        return tuple(diagram(found.case, along.parameter, values) for values in ways)
