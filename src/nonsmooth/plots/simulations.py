"""A simulated motion: against time, and in the phase plane."""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from nonsmooth.solver.scenes.methods import about

from .axes import axes_or_new, check_quantity, described, say_below
from .orbits import HISTORIES, PLANE

if TYPE_CHECKING:
    from nonsmooth.solver.simulation.record import Simulation

#: What each quantity is called on an axis.
LABELS = HISTORIES | {"force": "contact force [N]"}

#: Part of the time, at the end, that is drawn over the rest in the phase plane.
LATE = 0.2


def draw(
    motion: "Simulation",
    ax: Any = None,
    quantity: str = "displacement",
    *,
    since: float = 0.0,
    **style: Any,
) -> Any:
    """Draw a simulated motion and return the axes; see `Simulation.plot`."""
    check_quantity(quantity, (*motion.quantities, PLANE))
    axes = axes_or_new(ax)
    times, *values = map(np.concatenate, zip(*motion.samples(), strict=True))
    late = times >= since
    columns = {name: each[late] for name, each in zip(motion.quantities, values, strict=True)}
    look = {"color": "0.25", "linewidth": 0.8} | style
    if quantity == PLANE:
        axes.plot(columns["displacement"], columns["velocity"], **look)
        axes.set(xlabel=HISTORIES["displacement"], ylabel=HISTORIES["velocity"])
    else:
        axes.plot(times[late], columns[quantity], **look)
        axes.set(xlabel="$t$ [s]", ylabel=LABELS[quantity])
    return axes


def simulation_figure(motion: "Simulation") -> Figure:
    """Draw a motion against time, and the phase plane with its late part.

    Displacement and velocity are drawn, and of a body the contact force.
    """
    figure = Figure(figsize=(9, 4.8), layout="constrained")
    drawn = [name for name in motion.quantities if name != "acceleration"]
    panels = figure.subplot_mosaic([[name, PLANE] for name in drawn], width_ratios=(1.6, 1))
    for name in drawn:
        draw(motion, panels[name], name).label_outer()
    plane, colour = panels[PLANE], about("hb").look["color"]
    draw(motion, plane, PLANE, color="0.7", linewidth=0.6, label="from the start")
    words = f"the last {100 * LATE:.0f} % of the time"
    since = (1 - LATE) * motion.time
    draw(motion, plane, PLANE, since=since, color=colour, linewidth=1.4, label=words)
    plane.legend(loc="lower left", bbox_to_anchor=(0, 1.0), frameon=False, fontsize=8)
    say_below(figure, described(motion.case))
    return figure
