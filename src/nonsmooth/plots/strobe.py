"""Motions seen once a period of the forcing: a bifurcation diagram, basins of attraction."""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure

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

if TYPE_CHECKING:
    from nonsmooth.solver.results.strobe import Basins, Diagram

#: What can be drawn over a parameter, and what the axis says.
QUANTITIES = {"displacement": "displacement [m]", "velocity": "velocity [m/s]"}

#: Where no motion is, where it has not settled, and basins in turn: told apart in grey, too.
NONE, UNSETTLED = "white", "0.1"
BASINS = ("0.85", "0.55", "#9ecae1", "#31729c", "#fdd0a2", "#b35806", "#c7e9c0", "#3f8f50")

#: The mark of each attractor.
MARKS = "o^sDvP*X"


def draw_diagram(
    result: "Diagram", ax: Any = None, quantity: str = "displacement", **style: Any
) -> Any:
    """Draw the states of a diagram as points and return the axes.

    A `ValueError` is raised if `quantity` is not one that there is.
    """
    check_quantity(quantity, QUANTITIES)
    axes, column = axes_or_new(ax), list(QUANTITIES).index(quantity)
    along = np.repeat(result.values, [len(each) for each in result.states])
    seen = np.concatenate([each[:, column] for each in result.states] or [np.empty(0)])
    axes.plot(along, seen, **{"color": "0.1", "marker": ".", "markersize": 1.5} | style, ls="")
    ended = [q for q, each in zip(result.values, result.states, strict=True) if not len(each)]
    mark_values(axes, ended, "the motion ends", "0.6")
    axes.set(xlabel=name_of(result.case.scene, result.parameter), ylabel=QUANTITIES[quantity])
    return axes


def draw_basins(result: "Basins", ax: Any = None) -> Any:
    """Draw the starts of a grid by the attractors that they lead to and return the axes."""
    axes, count = axes_or_new(ax), len(result.attractors)
    colors = [NONE, UNSETTLED, *(BASINS[i % len(BASINS)] for i in range(count))]
    axes.pcolormesh(
        result.x, result.v, result.index, cmap=ListedColormap(colors), vmin=-2.5,
        vmax=count - 0.5, shading="nearest", rasterized=True,
    )  # fmt: skip
    for i, each in enumerate(result.attractors):
        x, v = np.array(each.states).T
        every = "each period" if each.cycles == 1 else f"every {each.cycles} periods"
        axes.plot(
            x, v, MARKS[i % len(MARKS)], color=colors[2 + i], markeredgecolor="black",
            label=f"{every}, x = {x[0]:.3g} m",
        )  # fmt: skip
    axes.set(xlabel="displacement [m]", ylabel="velocity [m/s]")
    if ax is None:
        legend_above(axes.figure, axes, 2)
    return axes


def diagram_figure(result: "Diagram") -> Figure:
    """Draw displacement and velocity of a diagram."""
    figure = Figure(figsize=(7, 6), layout="constrained")
    upper, lower = figure.subplots(2, 1, sharex=True)
    draw_diagram(result, upper)
    draw_diagram(result, lower, "velocity")
    upper.set_xlabel("")
    words = described(result.case, result.parameter)
    say_below(figure, f"once a period of the forcing; {words}")
    return figure


def basins_figure(result: "Basins") -> Figure:
    """Draw basins of attraction."""
    figure = Figure(figsize=(6, 5), layout="constrained")
    frame(figure, draw_basins(result, figure.subplots()), described(result.case), 2)
    return figure
