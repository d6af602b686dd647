"""``nonsmooth solve``: one orbit, or the orbit by all three methods."""

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..aliases import Aliased, OneOrder, check_one_method, split_methods
from ..output import DATA, PICTURES, check_target, write_file, write_picture, write_text
from ..problems import Problem, Verbose, reasons, say
from ..progress import busy
from ..scenes.command import SceneCommand
from ..scenes.wanted import Wanted
from ..values.seconds import parse_seconds
from .by_scene import (
    FUNCTIONS,
    NO_SHORTCUTS,
    MethodOfPaper,
    are_generic,
    refuse_beside_generic,
    solve_generic,
)
from .equations import METHODS
from .parameters import belt_from, caption, parameter_options
from .precise import add_precise, check_digits, show_precise
from .tolerance import choose, why

if TYPE_CHECKING:
    from nonsmooth.solver.no_orbit import NoOrbit
    from nonsmooth.solver.shortcuts.orbit.orbit import Orbit
    from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip

#: N without ``--order``.
ORDER = 10

#: Order from which a search is said to go on at once: it takes seconds to minutes.
LARGE = 50_000

#: Estimated error of the period above which an orbit is not returned without a word.
FAR_OFF = 0.1

EPILOG = """\b
Examples:
  nonsmooth solve --tol 1e-8
  nonsmooth solve --budget 1ms
  nonsmooth solve --method c1 --order 7
  nonsmooth solve --order 10 -o orbit.png      all three methods
  nonsmooth solve --method hb --order 40 --case belt.toml --json
  nonsmooth solve --method c1 --order 20 --digits 50
  nonsmooth solve --method c1-tau --tol 1e-12
  nonsmooth solve impact --gap 0.2 --tol 1e-9
"""


@click.command(cls=SceneCommand, module="solve", epilog=EPILOG)
@click.option(
    "--method",
    cls=Aliased,
    alias="--methods",
    type=MethodOfPaper(METHODS),
    help="hb, hb-c1 or c1 of the paper (default: all); or c1-tau, as of every scene.",
)
@click.option(
    "--order",
    cls=Aliased,
    alias="--orders",
    type=OneOrder(),
    help=f"N, the size of the expansion.  [default: {ORDER}]",
)
@click.option(
    "--c1-terms", type=int, default=1, show_default=True, help="C1 functions of hb-c1, 1 to 6."
)
@click.option("--functions", type=int, help=FUNCTIONS)
@click.option("--no-shortcuts", is_flag=True, help=NO_SHORTCUTS)
@click.option("--tol", type=float, help="Choose: largest relative error of the period.")
@click.option("--tol-acceleration", type=float, help="Choose: largest error (22).")
@click.option("--budget", help="Choose: the best in this time, like 200us, 1ms, 2s.")
@parameter_options
@click.option("--digits", type=int, help="Refine period and t1 to this many digits.")
@click.option("--json", "json_", is_flag=True, help="Print one JSON document.")
@click.option(
    "-o", "--output", type=click.Path(path_type=Path),
    help="Write the orbit: .json, .nc, its motion .csv; or a picture .png, .svg, .pdf.",
)  # fmt: skip
def solve(
    method: str | None,
    order: int | None,
    c1_terms: int,
    functions: int | None,
    no_shortcuts: bool,
    tol: float | None,
    tol_acceleration: float | None,
    budget: str | None,
    case: Path | None,
    json_: bool,
    output: Path | None,
    digits: int | None,
    **flags: float | None,
) -> int:
    """Compute the periodic orbit by one method of the paper, or by all three.

    With a tolerance, the cheapest method and order that meet it, by the estimated error;
    with a budget, the best that fits, timed on this machine. SCENE is a name of 'nonsmooth
    scenes', or the path of a scene file, which is Python and is run; without it, the belt of
    the paper. 'nonsmooth solve SCENE --help' lists its parameters.
    """
    check_target(output, (*DATA, *PICTURES))
    names = split_methods(method)
    if are_generic(method, functions, no_shortcuts, "--method"):
        refuse_beside_generic(
            {
                "--c1-terms": c1_terms if c1_terms != 1 else None,
                "--tol-acceleration": tol_acceleration,
                "--digits": digits,
            }
        )
        seconds = None if budget is None else parse_seconds(budget)
        wanted = Wanted(tuple(names), order, functions, tol, seconds, json_, output)
        return solve_generic(case, flags, wanted)
    from nonsmooth.solver.shortcuts.orbit.orbit import Orbit  # noqa: PLC0415

    found: dict[str, Orbit | NoOrbit]
    if any(value is not None for value in (tol, tol_acceleration, budget)):
        check_digits(digits, 1)
        check_one_method(names, "a tolerance or budget")
        if c1_terms != 1:
            raise Problem(
                f"--c1-terms: got {c1_terms} beside a tolerance or budget, expected 1"
            )
        seconds = None if budget is None else parse_seconds(budget)
        choice = choose(belt_from(case, flags), method, order, tol, tol_acceleration, seconds)
        belt, method, order = choice.orbit.belt, choice.orbit.method, choice.orbit.order
        found = {method: choice.orbit}
    else:
        choice, order = None, ORDER if order is None else order
        _check_terms(names, c1_terms)
        check_digits(digits, order)
        if digits is not None and c1_terms != 1:
            raise Problem(f"--c1-terms: got {c1_terms} beside --digits, expected 1")
        belt = belt_from(case, flags)
        terms = dict.fromkeys(METHODS, 1) | {"hb-c1": c1_terms}
        found = {name: _search(belt, name, order, terms[name]) for name in names or METHODS}
    from nonsmooth.files.json_text import sealed  # noqa: PLC0415
    from nonsmooth.files.shortcuts.documents import (  # noqa: PLC0415
        of_solution,
        several,
        with_origin,
    )

    documents = [of_solution(belt, name, order, result) for name, result in found.items()]
    if choice is not None:
        documents[0] |= {"trials": [asdict(trial) for trial in choice.trials]}
    _add_digits(documents, found, digits)
    whole = documents[0] if len(documents) == 1 else several(documents)
    text = sealed(with_origin(whole, list(found)))
    if json_:
        click.echo(text, nl=False)
    else:
        from .tables import legend, solutions  # noqa: PLC0415

        click.echo(caption(belt))
        solutions(belt, found)
        if choice is not None:
            click.echo(why(choice))
        if digits is not None:
            show_precise(documents)
        legend(found)
    orbits = [orbit for orbit in found.values() if isinstance(orbit, Orbit)]
    _warn_of_far_off(orbits if tol is None else [])
    if output is not None:
        _write(output, text, belt, orbits)
    return 0 if len(orbits) == len(found) else 1


solve.params.append(Verbose())


def _check_terms(names: list[str], c1_terms: int) -> None:
    if c1_terms != 1 and names and "hb-c1" not in names:
        raise Problem(f"--c1-terms: got {c1_terms}, expected 1 for method {names[0]}")


def _add_digits(
    documents: list[dict[str, Any]], found: "dict[str, Orbit | NoOrbit]", digits: int | None
) -> None:
    if digits is not None:
        for each in documents:
            add_precise(each, found[each["method"]], digits)


def _search(belt: "StickSlip", method: str, order: int, terms: int) -> "Orbit | NoOrbit":
    from nonsmooth.solver.case.parameters import ParameterError  # noqa: PLC0415
    from nonsmooth.solver.no_orbit import NoOrbit  # noqa: PLC0415
    from nonsmooth.solver.shortcuts.orbit import methods  # noqa: PLC0415
    from nonsmooth.solver.shortcuts.search.solve import solve as search  # noqa: PLC0415

    long = LARGE < order <= methods.check_method(method).highest_order
    try:
        with busy(f"{method}, N = {order}", long):
            return search(belt, method, order, c1_terms=terms)
    except ParameterError as error:
        raise Problem(str(error)) from error
    except ValueError as error:
        raise Problem("--" + str(error).replace("c1_terms", "c1-terms")) from error
    except NoOrbit as finding:
        first, *below = reasons(finding)
        say(f"{method}, N = {order}: {first}", below)
        return finding


def _warn_of_far_off(orbits: "list[Orbit]") -> None:
    for orbit in orbits:
        off = orbit.estimate.period
        if off > FAR_OFF:
            hint = (
                f"its period is off by {off:.0%}, by the estimate; --tol chooses a better one"
            )
            click.echo(f"nonsmooth: {orbit.method}, N = {orbit.order}: {hint}", err=True)


def _write(output: Path, text: str, belt: "StickSlip", orbits: "list[Orbit]") -> None:
    if output.suffix.lower() == ".json":
        write_text(output, text)
    elif output.suffix.lower() in DATA:
        if orbits:
            write_file(output, orbits)
        else:
            click.echo(f"nonsmooth: no orbit, {output} is not written", err=True)
    else:
        from nonsmooth.plots.shortcuts.orbits import orbit_figure  # noqa: PLC0415

        write_picture(output, lambda: orbit_figure(belt, orbits))
