"""What is to be solved on the command line, and the orbits that are found."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..problems import Problem, as_problems
from ..progress import busy

if TYPE_CHECKING:
    from nonsmooth.solver.case.case import Case
    from nonsmooth.solver.choice import SceneChoice
    from nonsmooth.solver.flow.exact import ExactSceneOrbit
    from nonsmooth.solver.no_orbit import NoOrbit
    from nonsmooth.solver.orbit.orbit import SceneOrbit

#: N without ``--order``.
ORDER = 10

#: Starts of a vain search that are told on stderr; a JSON document has all.
TOLD = 2


@dataclass(frozen=True)
class Wanted:
    """What is to be solved, and how it is to be shown."""

    method: str | None = None
    order: int | None = None
    functions: int | None = None
    tol: float | None = None
    json: bool = False
    output: Path | None = None

    @property
    def one(self) -> bool:
        """Whether one orbit is wanted, and not that of every method."""
        return self.method is not None or self.tol is not None


def search(
    case: "Case", wanted: Wanted
) -> "tuple[SceneChoice | None, dict[str, SceneOrbit | NoOrbit]]":
    """Return what a tolerance chose, if there is one, and what was found by method.

    Where the scene has several motions, that which occurs is found first.

    Raises
    ------
    Problem
        If something wanted cannot be computed.
    """
    from nonsmooth.solver.accuracy.estimate import BEST  # noqa: PLC0415
    from nonsmooth.solver.case.names import in_order  # noqa: PLC0415
    from nonsmooth.solver.case.registry import generic_method, methods  # noqa: PLC0415
    from nonsmooth.solver.no_orbit import NoOrbit  # noqa: PLC0415
    from nonsmooth.solver.solve import number_of_functions, with_motion  # noqa: PLC0415

    scene = case.scene
    with as_problems():
        one = generic_method(scene, wanted.method or BEST) if wanted.one else None
    names = in_order(methods(scene)) if one is None else (one,)
    found: dict[str, SceneOrbit | NoOrbit] = {}
    try:
        with busy("looking for a motion"):
            case = with_motion(case)
    except NoOrbit as finding:
        tell(finding)
        return None, dict.fromkeys(names, finding)
    if wanted.tol is not None:
        return _choose(case, names[0], wanted)
    for name in names:
        count = (
            number_of_functions(case, name, wanted.functions)
            if one is None
            else wanted.functions
        )
        found[name] = _solve(case, name, ORDER if wanted.order is None else wanted.order, count)
    return None, found


def _solve(
    case: "Case", method: str, order: int, functions: int | None
) -> "SceneOrbit | NoOrbit":
    from nonsmooth.solver.no_orbit import NoOrbit  # noqa: PLC0415
    from nonsmooth.solver.solve import solve_case  # noqa: PLC0415

    try:
        with as_problems(), busy(f"{method}, N = {order}"):
            return solve_case(case, method, order, functions)
    except NoOrbit as finding:
        tell(finding)
        return finding


def _choose(
    case: "Case", method: str, wanted: Wanted
) -> "tuple[SceneChoice | None, dict[str, SceneOrbit | NoOrbit]]":
    from nonsmooth.solver.choice import NotCertifiedScene  # noqa: PLC0415
    from nonsmooth.solver.no_orbit import NoOrbit  # noqa: PLC0415
    from nonsmooth.solver.tolerance import choose_order  # noqa: PLC0415

    if wanted.order is not None:
        raise Problem(f"--order: got {wanted.order} beside --tol, which chooses it")
    assert wanted.tol is not None
    try:
        with as_problems(), busy(f"{method} to {wanted.tol:g}"):
            choice = choose_order(case, wanted.tol, method, wanted.functions)
    except NotCertifiedScene as finding:
        raise Problem(f"no orbit is certified: {finding}", 1) from finding
    except NoOrbit as finding:
        tell(finding)
        return None, {method: finding}
    return choice, {method: choice.orbit}


def tell(finding: "NoOrbit") -> None:
    """Say on stderr why there is no orbit, with the first of the starts."""
    more = len(finding.tried) - TOLD
    parts = [finding.reason, *finding.tried[:TOLD]]
    if more > 0:
        parts.append(f"and {more} more starts")
    click.echo(f"nonsmooth: {'; '.join(parts)}", err=True)


def exact_near(case: "Case", orbits: "list[SceneOrbit]") -> "ExactSceneOrbit | None":
    """Return the exact orbit next to the orbits, or any if there are none."""
    from nonsmooth.solver.flow.exact import exact_orbit  # noqa: PLC0415
    from nonsmooth.solver.no_orbit import NoOrbit  # noqa: PLC0415

    for orbit in orbits:
        if orbit.exact is not None:
            return orbit.exact
    if case.scene.motions:  # none has an orbit: all were tried
        return None
    try:
        return exact_orbit(case)
    except NoOrbit:
        return None
