"""Motions: phase plane, displacement, velocity and acceleration over a period."""

from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from nonsmooth.solver.arrays import Vector

from .axes import EXACT, axes_or_new, check_quantity, curve, described, frame

if TYPE_CHECKING:
    from nonsmooth.solver.exact import ExactOrbit
    from nonsmooth.solver.results.orbit import Orbit

#: What can be drawn of a motion: the phase plane, or one of these over a period.
PLANE = "plane"
HISTORIES = {
    "displacement": "displacement [m]",
    "velocity": "velocity [m/s]",
    "acceleration": "acceleration [m/s²]",
}


#: How far motions are drawn against time, in periods: beyond the switch that ends one.
BEYOND = 1.2

#: How the first motion on a pair of axes looks.
FIRST: dict[str, Any] = {"color": "0.1", "linestyle": "-", "linewidth": 1.4}


def draw(motion: Any, ax: Any = None, quantity: str = PLANE, **style: Any) -> Any:
    """Draw a periodic motion and return the axes; see `Orbit.plot`.

    Both sides of each switch are drawn, the first and the last instant of each phase; against
    time for a little more than one period.  The first motion on a pair of axes is a solid dark
    line, those behind it look as their method.
    """
    check_quantity(quantity, (PLANE, *HISTORIES))
    axes, times = axes_or_new(ax), instants(motion)
    is_first = motion.look is not None and not axes.lines
    look = {"label": motion.label} | (FIRST if is_first else line(motion)) | style
    if quantity == PLANE:
        x, v = motion.displacement(times), motion.velocity(times)
        axes.plot(np.append(x, x[0]), np.append(v, v[0]), **look)
        axes.set(xlabel=HISTORIES["displacement"], ylabel=HISTORIES["velocity"])
    else:
        axes.plot(*beyond(times / motion.period, getattr(motion, quantity)(times)), **look)
        axes.set(xlabel="$t/T$", ylabel=HISTORIES[quantity])
    return axes


def line(motion: Any) -> dict[str, Any]:
    """Return how the curve of a motion looks: as its method's, or that of the exact orbit."""
    return EXACT if motion.look is None else curve(motion.look)


def beyond(part: Vector, values: Vector) -> tuple[Vector, Vector]:
    """Return values over parts of a period, and those at its beginning again behind it."""
    again = part < BEYOND - 1
    return np.append(part, 1 + part[again]), np.append(values, values[again])


def orbit_figure(orbits: "list[Orbit]", exact: "ExactOrbit | None") -> Figure:
    """Draw phase plane, displacement, velocity, acceleration of orbits, and the exact one."""
    every = [*([] if exact is None else [exact]), *orbits]
    figure = Figure(figsize=(8, 6), layout="constrained")
    panels = figure.subplots(2, 2).ravel()
    for motion in every:
        for axes, quantity in zip(panels, (PLANE, *HISTORIES), strict=True):
            draw(motion, axes, quantity)
    panels[0].set(title="periodic orbit")
    frame(figure, panels[0], described(every[0].case))
    return figure


#: The first and the last instant of a phase, from its ends, as a part of it.
INSIDE = 1e-9

#: Instants of each phase.
POINTS = 400


def instants(motion: Any) -> Vector:
    """Return times over one period of a motion in phases, both sides of every switch too."""
    ends = np.cumsum([0.0, *motion.durations])
    part = np.linspace(INSIDE, 1 - INSIDE, POINTS)
    return np.concatenate([low + (high - low) * part for low, high in pairwise(ends)])
