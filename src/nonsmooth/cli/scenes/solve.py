"""``nonsmooth solve SCENE``: one orbit of a scene, or the orbit by each of its methods."""

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..aliases import Aliased, OneOrder, split_methods
from ..output import DATA, PICTURES, check_target
from ..values.seconds import parse_seconds
from .options import case_from, command_of, motion_options
from .wanted import ORDER, Wanted, exact_near, search, write_orbits

if TYPE_CHECKING:
    from nonsmooth.solver.results.orbit import Orbit
    from nonsmooth.solver.scenes.case import Case
    from nonsmooth.solver.scenes.loaded import LoadedScene
    from nonsmooth.solver.trade.choice import Choice

#: Estimated error of the times above which an orbit is not returned without a word.
FAR_OFF = 0.1

#: What an orbit can be written as.
SUFFIXES = (*DATA, *PICTURES)

HELP = """Compute the periodic orbit of {name} by one method, or by each.

{title}. With a tolerance, the lowest order of the method, without one of {best}, whose
estimated errors of times and period are within it. With a budget, the best orbit that fits,
timed on this machine."""

EPILOG = """\b
Examples:
  nonsmooth solve {scene}
  nonsmooth solve {scene} --method {best} --tol 1e-9
  nonsmooth solve {scene} --{flag} {value:g} -o orbit.png
"""

FUNCTIONS = "Functions of hb-ck at each switch.  [default: 1; 2 where x' jumps]"


def command(scene: "LoadedScene", said: str) -> click.Command:
    """Return ``nonsmooth solve`` of a scene, which the user called so."""
    names = method_names(scene)
    options: list[click.Parameter] = [
        Aliased(
            ["--method"], alias="--methods", help=f"{', '.join(names)}; without it, all."
        ),
        Aliased(
            ["--order"], alias="--orders", type=OneOrder(),
            help=f"N, the size.  [default: {ORDER}]",
        ),
        click.Option(["--functions"], type=int, metavar="K", help=FUNCTIONS),
        *motion_options(scene),
        click.Option(["--tol"], type=float, help="Choose N: largest error of times, period."),
        click.Option(["--budget"], help="Choose: the best in this time, like 200us, 1ms, 2s."),
        click.Option(
            ["--all", "every"], is_flag=True, help="List every orbit found, of every motion."
        ),
        click.Option(["--json", "json_"], is_flag=True, help="Print one JSON document."),
        click.Option(
            ["-o", "--output"], type=click.Path(path_type=Path),
            help="Write the orbit: .json, .nc, its motion .csv; or a picture .png, .svg, .pdf.",
        ),
    ]  # fmt: skip

    def callback(
        method: str | None, order: int | None, functions: int | None, tol: float | None,
        budget: str | None, every: bool, case: Path | None, json_: bool,
        output: Path | None, **flags: Any,
    ) -> int:  # fmt: skip
        check_target(output, SUFFIXES)
        seconds = None if budget is None else parse_seconds(budget)
        wanted = Wanted(
            tuple(split_methods(method)), order, functions, tol, seconds, json_, output
        )
        found = case_from(scene, case, flags)
        if every:
            from .every import list_every

            return list_every(found, wanted)
        return run(found, wanted)

    last = scene.parameters[-1]
    words = {"name": scene.name, "title": scene.title.capitalize(), "best": names[-1]}
    examples = {"flag": last.name.replace("_", "-"), "value": last.default}
    epilog = EPILOG.format(scene=said, best=names[-1], **examples)
    return command_of(scene, callback, options, HELP.format(**words), epilog)


def method_names(scene: "LoadedScene") -> list[str]:
    """Return the methods of a scene as they are shown, in their order."""
    from nonsmooth.solver.kernels.registry import methods
    from nonsmooth.solver.scenes.method_names import shown
    from nonsmooth.solver.scenes.methods import in_order

    return [shown(scene, method) for method in in_order(methods(scene))]


def run(case: "Case", wanted: Wanted) -> int:
    """Solve as wanted, show it, write it; the exit status."""
    from nonsmooth.files import documents
    from nonsmooth.solver.results.orbit import Orbit

    choice, found = search(case, wanted)
    orbits = [orbit for orbit in found.values() if isinstance(orbit, Orbit)]
    case = orbits[0].case if orbits else case
    exact = exact_near(case, orbits)
    order = (ORDER if wanted.order is None else wanted.order) if wanted.tol is None else None
    parts = documents.of_each(case, found, order, wanted.functions, exact)
    if choice is not None:
        parts[0] |= {"trials": [asdict(trial) for trial in choice.trials]}
    text = documents.text_of_each(case, parts, list(found), wanted.one)
    if wanted.json:
        click.echo(text, nl=False)
    else:
        from .shown import captions, tables

        click.echo(captions.caption(case))
        tables.solutions(case, exact, found)
        tables.tell_of_others(exact)
        if choice is not None:
            click.echo(_why(choice, wanted))
        click.echo(f"\n{captions.legend(case.scene)}")
    _warn(orbits if choice is None else [])
    if wanted.output is not None:
        write_orbits(wanted.output, text, orbits, exact)
    return 0 if len(orbits) == len(found) else 1


def _why(choice: "Choice", wanted: Wanted) -> str:
    """Return why this method and order were taken."""
    if wanted.tol is None:
        names = ", ".join(dict.fromkeys(trial.method for trial in choice.trials))
        words = f"the smallest estimated error within {wanted.budget:g} s, of {names}"
        return f"{choice.orbit.method}, N = {choice.orbit.order}: {words}"
    last = choice.trials[-1]
    words = f"the lowest order, of {len(choice.trials)} tried, whose estimated errors are"
    return f"{last.method}, N = {choice.orbit.order}: {words}\nwithin {wanted.tol:g}."


def _warn(orbits: "list[Orbit]") -> None:
    for orbit in orbits:
        off = orbit.estimate.times
        if off > FAR_OFF:
            hint = f"its times are off by {off:.0%} of the period, by the estimate"
            click.echo(f"nonsmooth: {orbit.method}, N = {orbit.order}: {hint}", err=True)
