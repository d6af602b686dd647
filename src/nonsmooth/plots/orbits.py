"""Periodic motions: phase plane, displacement, velocity and acceleration over a period."""

from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from nonsmooth.solver.arrays import Vector

from .axes import EXACT, axes_or_new, check_quantity, curve, described, frame

if TYPE_CHECKING:
    from nonsmooth.solver.exact import ExactOrbit
    from nonsmooth.solver.results.orbit import Orbit

#: The phase plane, and the quantities that are drawn against time, with their axis labels.
PLANE = "plane"
HISTORIES = {
    "displacement": "displacement [m]",
    "velocity": "velocity [m/s]",
    "acceleration": "acceleration [m/s²]",
}


#: Number of periods that are drawn against time: more than one, to show the last switch.
BEYOND = 1.2

#: The look of the first motion on a pair of axes.
FIRST: dict[str, Any] = {"color": "0.1", "linestyle": "-", "linewidth": 1.4}


def draw(motion: Any, ax: Any = None, quantity: str = PLANE, **style: Any) -> Any:
    """Draw a periodic motion and return the axes; see `Orbit.plot`.

    Both sides of each switch are drawn, and against time `BEYOND` periods.  The first motion on
    a pair of axes is a solid dark line, later ones have the look of their method.
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
    """Return the look of the curve of a motion: that of its method, or of exact orbits."""
    return EXACT if motion.look is None else curve(motion.look)


def beyond(part: Vector, values: Vector) -> tuple[Vector, Vector]:
    """Return times relative to the period and values, continued to `BEYOND` periods."""
    repeated = part < BEYOND - 1
    return np.append(part, 1 + part[repeated]), np.append(values, values[repeated])


def orbit_figure(orbits: "list[Orbit]", exact: "ExactOrbit | None") -> Figure:
    """Draw phase plane, displacement, velocity and acceleration of orbits and the exact one."""
    motions = [*([] if exact is None else [exact]), *orbits]
    figure = Figure(figsize=(8, 6), layout="constrained")
    panels = figure.subplots(2, 2).ravel()
    for motion in motions:
        for axes, quantity in zip(panels, (PLANE, *HISTORIES), strict=True):
            draw(motion, axes, quantity)
    panels[0].set(title="periodic orbit")
    panels[0].locator_params(axis="x", nbins=5)
    frame(figure, panels[0], described(motions[0].case))
    return figure


#: Distance of the first and the last instant of a phase from its ends, relative to it.
INSIDE = 1e-9

#: Number of instants of each phase.
POINTS = 400


def instants(motion: Any) -> Vector:
    """Return times over one period of a motion, with both sides of every switch."""
    ends = np.cumsum([0.0, *motion.durations])
    part = np.linspace(INSIDE, 1 - INSIDE, POINTS)
    return np.concatenate([low + (high - low) * part for low, high in pairwise(ends)])
