"""One result of each kind, small, shared by the tests of pictures, tables and lines."""

from functools import cache
from typing import Any

import nonsmooth as ns
from nonsmooth.kim_perkins import SECTION_4
from nonsmooth.solver.space.attached import attach
from nonsmooth.solver.space.convergence import Line, convergence
from nonsmooth.solver.space.structure import load

ORDER = 6
BELT = ns.StickSlip(**SECTION_4)


@cache
def thing(kind: str) -> Any:
    """Return the result of a kind."""
    return MAKERS[kind]()


def _modes() -> ns.Modes:
    return ns.modes("beam-mass", position="1/3", mass=10, count=3)


MAKERS = {
    "orbit": lambda: ns.solve(ns.scene("dry-friction")(frequency=0.4), order=ORDER),
    "exact": lambda: ns.exact(ns.scene("impact")()),
    "sweep": lambda: ns.sweep(ns.scene("impact")(), ["hb", "ck-tau"], [4, 5, 6]),
    "family": lambda: ns.family(ns.scene("impact")(), "gap", [0.1, 0.2, 50.0], order=ORDER),
    "simulation": lambda: ns.simulate(ns.scene("impact")(), cycles=2),
    "belt": lambda: ns.solve(BELT, "c1", ORDER),
    "exact-belt": lambda: ns.exact(BELT),
    "sweep-belt": lambda: ns.sweep(BELT, ["hb", "c1"], [2, 3, 4]),
    "family-belt": lambda: ns.family(BELT, "belt_speed", [0.001, 0.5, 1.0], "hb", 5),
    "modes": _modes,
    "study": lambda: convergence(attach(load("string-mass")), [Line("ritz-ck", 1)], (4, 8)),
}

#: Those that are a motion over one period.
MOTIONS = ("orbit", "exact", "belt", "exact-belt")
