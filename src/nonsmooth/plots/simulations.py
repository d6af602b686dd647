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

#: About how many points of a motion are drawn for each wave, and at most in all.
POINTS, MOST = 100, 200_000

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
    return _drawn(_columns(motion), axes_or_new(ax), quantity, since=since, **style)


def _columns(motion: "Simulation") -> dict[str, Any]:
    """Return times and quantities along a motion, fewer a wave where there are many waves."""
    waves = sum(q.s / q.wave(motion.case.cell.omega) for q in motion.segments)
    samples = motion.samples(min(POINTS, MOST / max(waves, 1.0)))
    found = map(np.concatenate, zip(*samples, strict=True))
    return dict(zip(("t", *motion.quantities), found, strict=True))


def _drawn(
    columns: dict[str, Any], axes: Any, quantity: str, *, since: float = 0.0, **style: Any
) -> Any:
    """Draw a quantity of a motion, or its phase plane, from a time on; return the axes."""
    late = columns["t"] >= since
    look = {"color": "0.25", "linewidth": 0.8} | style
    x, y = ("displacement", "velocity") if quantity == PLANE else ("t", quantity)
    axes.plot(columns[x][late], columns[y][late], **look)
    labels = LABELS | {"t": "$t$ [s]"}
    axes.set(xlabel=labels[x], ylabel=labels[y])
    return axes


def simulation_figure(motion: "Simulation") -> Figure:
    """Draw a motion against time, and the phase plane with its late part.

    Displacement and velocity are drawn, and of a body the contact force.
    """
    figure = Figure(figsize=(9, 4.8), layout="constrained")
    columns = _columns(motion)
    drawn = [name for name in motion.quantities if name != "acceleration"]
    panels = figure.subplot_mosaic([[name, PLANE] for name in drawn], width_ratios=(1.6, 1))
    for name in drawn:
        _drawn(columns, panels[name], name).label_outer()
    plane, colour = panels[PLANE], about("hb").look["color"]
    _drawn(columns, plane, PLANE, color="0.7", linewidth=0.6, label="from the start")
    words = f"the last {100 * LATE:.0f} % of the time"
    since = (1 - LATE) * motion.time
    _drawn(columns, plane, PLANE, since=since, color=colour, linewidth=1.4, label=words)
    plane.legend(loc="lower left", bbox_to_anchor=(0, 1.0), frameon=False, fontsize=8)
    say_below(figure, described(motion.case))
    return figure
