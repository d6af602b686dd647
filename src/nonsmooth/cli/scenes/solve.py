"""``nonsmooth solve SCENE``: one orbit of a scene, or the orbit by each of its methods."""

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..about import Given, Output
from ..aliases import Aliased, OneOrder, split_methods
from ..output import DATA, PICTURES
from ..values import parse_seconds
from .options import case_from, command_of, method_names, motion_options
from .wanted import ORDER, Wanted, exact_near, search, write_orbits

if TYPE_CHECKING:
    from nonsmooth.solver.results.orbit import Orbit
    from nonsmooth.solver.scenes.case import Case
    from nonsmooth.solver.scenes.loaded import LoadedScene
    from nonsmooth.solver.trade.choice import Choice

#: Estimated error of the times above which an orbit is not returned without a word.
FAR_OFF = 0.1

OUTPUT = Output(
    "Write the orbit: .json, .nc, its motion .csv; or a picture .png, .svg, .pdf.",
    (*DATA, *PICTURES),
)

HELP = """Compute the periodic orbit of {name} by one method, or by each.

{title}. With a tolerance, the lowest order of the method, without one of {best}, whose
estimated errors of times and period are within it. With a budget, the best orbit that fits,
timed on this machine."""

EPILOG = """\b
Examples:
  nonsmooth solve {scene}
  nonsmooth solve {scene} --method {best} --tol 1e-9
  nonsmooth solve {scene} {flag} {value:g} -o orbit.png
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
    ]  # fmt: skip
    return command_of(scene, said, run, options, OUTPUT, HELP, EPILOG)


def run(
    given: "Given[LoadedScene]", method: str | None, every: bool, budget: str | None,
    json_: bool, output: Path | None, **numbers: Any,
) -> int:  # fmt: skip
    """Solve what is wanted, show it, write it; the exit status."""
    seconds = None if budget is None else parse_seconds(budget)
    methods = tuple(split_methods(method))
    wanted = Wanted(methods, **numbers, budget=seconds, json=json_, output=output)
    case = case_from(given)
    if every:
        from .shown.every import list_every

        return list_every(case, wanted)
    return _solve(case, wanted)


def _solve(case: "Case", wanted: Wanted) -> int:
    """Solve by each method, or as a tolerance or a budget chooses; the exit status."""
    from nonsmooth.files import documents
    from nonsmooth.solver.results.orbit import Orbit

    choice, found = search(case, wanted)
    orbits = [orbit for orbit in found.values() if isinstance(orbit, Orbit)]
    case = orbits[0].case if orbits else case
    exact = exact_near(case, orbits)
    order = wanted.size if wanted.tol is None else None
    parts = documents.of_each(case, found, order, wanted.functions, exact)
    if choice is not None:
        parts[0] |= {"trials": [asdict(trial) for trial in choice.trials]}
    whole = parts[0] if wanted.one else {"scene": case.scene.name, "orbits": parts}
    text = documents.text(case, whole, found)
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
            hint = f"its times are off by {100 * off:.0f} % of the period, by the estimate"
            click.echo(f"nonsmooth: {orbit.method}, N = {orbit.order}: {hint}", err=True)
