"""``nonsmooth solve SCENE --all``: every orbit of a scene that is found, of every motion."""

from typing import TYPE_CHECKING

import click

from ...aliases import check_one_method
from ...problems import Problem, as_problems
from ...progress import busy
from ..wanted import Wanted, tell, write_orbits

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.case import Case

LEGEND = (
    "T: period; phi: phase of the forcing at the first switch; least x, largest x: of the "
    "displacement; estimate: error of the times, as a part of T."
)


def list_every(case: "Case", wanted: Wanted) -> int:
    """List every orbit by one method, the stable ones first, write them; the exit status."""
    from nonsmooth.files import documents
    from nonsmooth.solver.existence.reasons import motions_without_switches
    from nonsmooth.solver.no_orbit import NoOrbit
    from nonsmooth.solver.scenes.methods import FIRST
    from nonsmooth.solver.solve import orbits_of

    from ...columns import filled
    from . import captions, tables

    for option, value in (("--tol", wanted.tol), ("--budget", wanted.budget)):
        if value is not None:
            raise Problem(f"{option}: got {value:g} beside --all, expected --order")
    check_one_method(list(wanted.methods), "--all")
    method = wanted.methods[0] if wanted.methods else FIRST
    orbits = []
    try:
        with as_problems(), busy("looking for all orbits"):
            orbits = orbits_of(case, method, wanted.size, wanted.functions)
    except NoOrbit as finding:
        tell(finding)
    still = motions_without_switches(case)
    every = [*(orbit.as_dict() for orbit in orbits), *(motion.as_dict() for motion in still)]
    text = documents.text(case, {"scene": case.scene.name, "orbits": every}, [method])
    if wanted.json:
        click.echo(text, nl=False)
    else:
        click.echo(captions.caption(case))
        tables.every(orbits, still)
        click.echo(f"\n{filled(LEGEND)}")
    write_orbits(wanted.output, text, orbits, None)
    return 0 if every else 1
