"""Simulated motions: against time, in the phase plane, and once a period of the forcing.

The last are bifurcation diagrams and basins of attraction.
"""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure

from nonsmooth.solver.scenes.methods import about

from .axes import (
    axes_or_new,
    check_quantity,
    described,
    frame,
    legend_above,
    mark_values,
    say_below,
)
from .families import name_of
from .orbits import HISTORIES, PLANE

if TYPE_CHECKING:
    from nonsmooth.solver.results.strobe import Basins, Diagram
    from nonsmooth.solver.simulation.record import Simulation

#: The axis labels of quantities.
LABELS = HISTORIES | {"force": "contact force [N]"}

#: Number of points of a motion: about so many for each wave, and at most in all.
POINTS, MOST = 100, 200_000

#: Share of the time, at its end, that is highlighted in the phase plane.
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
    """Return times and quantities along a motion, at about `POINTS` instants of each wave."""
    waves = sum(q.s / q.wave(motion.case.cell.omega) for q in motion.segments)
    samples = motion.samples(min(POINTS, MOST / max(waves, 1.0)))
    columns = map(np.concatenate, zip(*samples, strict=True))
    return dict(zip(("t", *motion.quantities), columns, strict=True))


def _drawn(
    columns: dict[str, Any], axes: Any, quantity: str, *, since: float = 0.0, **style: Any
) -> Any:
    """Draw a quantity of a motion, or its phase plane, from a time on; return the axes."""
    shown = columns["t"] >= since
    look = {"color": "0.25", "linewidth": 0.8} | style
    x, y = ("displacement", "velocity") if quantity == PLANE else ("t", quantity)
    axes.plot(columns[x][shown], columns[y][shown], **look)
    labels = LABELS | {"t": "$t$ [s]"}
    axes.set(xlabel=labels[x], ylabel=labels[y])
    return axes


def simulation_figure(motion: "Simulation") -> Figure:
    """Draw a motion against time, and in the phase plane with its late part highlighted.

    Against time are displacement and velocity, and of a body the contact force.
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
    plane.locator_params(axis="x", nbins=4)  # labels of small numbers are long
    plane.legend(loc="lower left", bbox_to_anchor=(0, 1.0), frameon=False, fontsize=8)
    say_below(figure, described(motion.case))
    return figure


#: The quantities that a diagram can show, and their axis labels.
SEEN = {"displacement": "displacement [m]", "velocity": "velocity [m/s]"}

#: Colours: no motion, not settled, and the basins in turn, which differ in grey as well.
NONE, UNSETTLED = "white", "0.1"
BASINS = ("0.85", "0.55", "#9ecae1", "#31729c", "#fdd0a2", "#b35806", "#c7e9c0", "#3f8f50")

#: The markers of attractors in turn.
MARKS = "o^sDvP*X"


def draw_diagram(
    result: "Diagram", ax: Any = None, quantity: str = "displacement", **style: Any
) -> Any:
    """Draw the states of a diagram as points and return the axes.

    A `ValueError` is raised if `quantity` is not a key of `SEEN`.
    """
    check_quantity(quantity, SEEN)
    axes, column = axes_or_new(ax), list(SEEN).index(quantity)
    along = np.repeat(result.values, [len(each) for each in result.states])
    values = np.concatenate([each[:, column] for each in result.states] or [np.empty(0)])
    axes.plot(
        along, values, **{"color": "0.1", "marker": ".", "markersize": 1.5} | style, ls=""
    )
    ended = [q for q, each in zip(result.values, result.states, strict=True) if not len(each)]
    mark_values(axes, ended, "the motion ends", "0.6")
    axes.set(xlabel=name_of(result.case.scene, result.parameter), ylabel=SEEN[quantity])
    return axes


def draw_basins(result: "Basins", ax: Any = None) -> Any:
    """Draw the initial states of a grid, coloured by attractor, and return the axes."""
    axes, count = axes_or_new(ax), len(result.attractors)
    colors = [NONE, UNSETTLED, *(BASINS[i % len(BASINS)] for i in range(count))]
    axes.pcolormesh(
        result.x, result.v, result.index, cmap=ListedColormap(colors), vmin=-2.5,
        vmax=count - 0.5, shading="nearest", rasterized=True,
    )  # fmt: skip
    for i, attractor in enumerate(result.attractors):
        x, v = np.array(attractor.states).T
        when = "each period" if attractor.cycles == 1 else f"every {attractor.cycles} periods"
        axes.plot(
            x, v, MARKS[i % len(MARKS)], color=colors[2 + i], markeredgecolor="black",
            label=f"{when}, x = {x[0]:.3g} m",
        )  # fmt: skip
    for index, words in ((-1, "not settled"), (-2, "no motion from there")):
        if (result.index == index).any():
            square = {"marker": "s", "color": colors[2 + index], "markeredgecolor": "black"}
            axes.plot([], [], linestyle="", label=words, **square)
    axes.set(xlabel="displacement [m]", ylabel="velocity [m/s]")
    if ax is None:
        legend_above(axes.figure, axes, 2)
    return axes


def diagram_figure(result: "Diagram") -> Figure:
    """Draw displacement and velocity of a bifurcation diagram."""
    figure = Figure(figsize=(7, 6), layout="constrained")
    upper, lower = figure.subplots(2, 1, sharex=True)
    draw_diagram(result, upper)
    draw_diagram(result, lower, "velocity")
    upper.set_xlabel("")
    if upper.get_legend_handles_labels()[1]:
        legend_above(figure, upper)
    words = described(result.case, result.parameter)
    say_below(figure, f"once a period of the forcing; {words}")
    return figure


def basins_figure(result: "Basins") -> Figure:
    """Draw basins of attraction."""
    figure = Figure(figsize=(6, 5), layout="constrained")
    frame(figure, draw_basins(result, figure.subplots()), described(result.case), 2)
    return figure
