"""Motions: phase plane, displacement, velocity and acceleration over a period."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from nonsmooth.plots.instants import instants

from ..style import EXACT
from .axes import axes_or_new, check_quantity, frame

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


def draw(motion: Any, ax: Any = None, quantity: str = PLANE, **style: Any) -> Any:
    """Draw a periodic motion and return the axes.

    Both sides of each switch are drawn, the first and the last instant of each phase.

    Parameters
    ----------
    motion : Motion or Motion
        What is drawn.
    ax : matplotlib Axes, optional
        Where; new ones without it.
    quantity : {"plane", "displacement", "velocity", "acceleration"}
        The phase plane, or one of the three against time in periods.
    **style
        Of the line, as `matplotlib.axes.Axes.plot` takes it.

    Raises
    ------
    ValueError
        If `quantity` is none of these.
    """
    check_quantity(quantity, (PLANE, *HISTORIES))
    axes, times = axes_or_new(ax), instants(motion)
    look = {"label": motion.label} | line(motion) | style
    if quantity == PLANE:
        x, v = motion.displacement(times), motion.velocity(times)
        axes.plot(np.append(x, x[0]), np.append(v, v[0]), **look)
        axes.set(xlabel=HISTORIES["displacement"], ylabel=HISTORIES["velocity"])
    else:
        axes.plot(times / motion.period, getattr(motion, quantity)(times), **look)
        axes.set(xlabel="t/T", ylabel=HISTORIES[quantity])
    return axes


def line(motion: Any) -> dict[str, Any]:
    """Return how the curve of a motion looks: as its method's, or that of the exact orbit."""
    look: dict[str, Any] | None = motion.look
    if look is None:
        return dict(EXACT)
    return {"color": look["color"], "linestyle": look["linestyle"], "linewidth": 1.4}


def motions_figure(
    motions: Iterable[tuple[str, Any]], title: str, words: str, columns: int = 3
) -> Figure:
    """Draw phase plane, displacement, velocity and acceleration of labelled motions."""
    figure = Figure(figsize=(8, 6), layout="constrained")
    panels = figure.subplots(2, 2).ravel()
    for label, motion in motions:
        for axes, quantity in zip(panels, (PLANE, *HISTORIES), strict=True):
            draw(motion, axes, quantity, label=label)
    panels[0].set(title=title)
    frame(figure, panels[0], words, columns)
    return figure


def orbit_figure(orbits: "list[Orbit]", exact: "ExactOrbit | None") -> Figure:
    """Draw some orbits of a case, and the exact one."""
    every = [*([] if exact is None else [exact]), *orbits]
    case = every[0].case
    words = f"{case.scene.name}: {case.description}"
    return motions_figure([(each.label, each) for each in every], "periodic orbit", words)
