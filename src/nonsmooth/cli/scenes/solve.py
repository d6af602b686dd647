"""``nonsmooth solve SCENE``: one orbit of a scene, one by each of its methods, or all."""

from collections.abc import Iterator
from dataclasses import asdict
from functools import cache
from typing import Any

from nonsmooth.files import documents
from nonsmooth.solver.exact import ExactOrbit
from nonsmooth.solver.existence.reasons import motions_without_switches
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.results.document import document_without_orbit
from nonsmooth.solver.results.orbit import Orbit
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.loaded import LoadedScene
from nonsmooth.solver.scenes.methods import FIRST
from nonsmooth.solver.solve import orbits_of
from nonsmooth.solver.trade.choice import Choice

from ..about import Given
from ..aliases import check_one_method, split_methods
from ..columns import Piece
from ..output import Destination, Text, drawn_by
from ..problems import Problem, as_problems, say, tell
from ..progress import busy
from ..values import parse_seconds
from . import captions, tables
from .case import case_from
from .wanted import Wanted, exact_near, search

#: Estimated error of the times above which an orbit is not returned without a word.
FAR_OFF = 0.1


def run(
    given: Given[LoadedScene], to: Destination, method: str | None, every: bool,
    budget: str | None, **numbers: Any,
) -> int:  # fmt: skip
    """Solve what is wanted, show it, write it; the exit status."""
    seconds = None if budget is None else parse_seconds(budget)
    wanted = Wanted(tuple(split_methods(method)), **numbers, budget=seconds)
    case = case_from(given)
    return _list_every(case, wanted, to) if every else _solve(case, wanted, to)


def _solve(case: Case, wanted: Wanted, to: Destination) -> int:
    """Solve by each method, or as a tolerance or a budget chooses; the exit status."""
    choice, outcomes = search(case, wanted)
    orbits = [orbit for orbit in outcomes.values() if isinstance(orbit, Orbit)]
    case = orbits[0].case if orbits else case
    exact = exact_near(case, orbits)
    order = wanted.size if wanted.tol is None else None

    @cache
    def text() -> str:
        parts = [
            orbit.as_dict()
            if isinstance(orbit, Orbit)
            else document_without_orbit(case, name, order, wanted.functions, orbit, exact)
            for name, orbit in outcomes.items()
        ]
        if choice is not None:
            parts[0] |= {"trials": [asdict(trial) for trial in choice.trials]}
        document = parts[0] if wanted.one else {"scene": case.scene.name, "orbits": parts}
        return documents.text(case, document, outcomes)

    def pieces() -> Iterator[Piece]:
        yield captions.caption(case)
        yield from tables.solutions(case, exact, outcomes)
        yield from tables.others_beside(exact)
        if choice is not None:
            yield _why(choice, wanted)
        yield f"\n{captions.legend(case.scene)}"

    to.show(text, pieces())
    for orbit in orbits if choice is None else []:
        if orbit.estimate.times > FAR_OFF:
            off = f"{100 * orbit.estimate.times:.0f} % of the period, by the estimate"
            say(f"{orbit.method}, N = {orbit.order}: its times are off by {off}")
    _write(to, text, orbits, exact)
    return 0 if len(orbits) == len(outcomes) else 1


def _list_every(case: Case, wanted: Wanted, to: Destination) -> int:
    """List every orbit by one method, the stable ones first, write them; the exit status."""
    for option, value in (("--tol", wanted.tol), ("--budget", wanted.budget)):
        if value is not None:
            raise Problem(f"{option}: got {value:g} beside --all, expected --order")
    check_one_method(wanted.methods, "--all")
    method = wanted.methods[0] if wanted.methods else FIRST
    orbits = []
    try:
        with as_problems(), busy("looking for all orbits"):
            orbits = orbits_of(case, method, wanted.size, wanted.functions)
    except NoOrbit as finding:
        tell(finding)
    still = motions_without_switches(case)

    @cache
    def text() -> str:
        entries = [orbit.as_dict() for orbit in orbits]
        entries += [motion.as_dict() for motion in still]
        return documents.text(case, {"scene": case.scene.name, "orbits": entries}, [method])

    to.show(text, tables.every(case, orbits, still))
    _write(to, text, orbits, None)
    return 0 if orbits or still else 1


def _why(choice: Choice, wanted: Wanted) -> str:
    """Return why this method and order were taken."""
    if wanted.tol is None:
        names = ", ".join(dict.fromkeys(trial.method for trial in choice.trials))
        words = f"the smallest estimated error within {wanted.budget:g} s, of {names}"
        return f"{choice.orbit.method}, N = {choice.orbit.order}: {words}"
    chosen = choice.trials[-1]
    words = f"the lowest order, of {len(choice.trials)} tried, whose estimated errors are"
    return f"{chosen.method}, N = {choice.orbit.order}: {words}\nwithin {wanted.tol:g}."


def _write(to: Destination, text: Text, orbits: list[Orbit], exact: ExactOrbit | None) -> None:
    """Write orbits, if a file is named: without any only their document."""
    if to.file is not None and to.file.suffix.lower() != ".json" and not orbits:
        say(f"no orbit, {to.file} is not written")
    else:
        to.write(text, drawn_by("orbits.orbit_figure", orbits, exact), orbits)
