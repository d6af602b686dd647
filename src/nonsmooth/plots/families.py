"""An orbit along a parameter: its ends, its times, and what is not sure of it."""

from itertools import cycle
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from nonsmooth.solver.scenes.method_names import shown
from nonsmooth.solver.scenes.methods import about

from .axes import axes_or_new, check_quantity

if TYPE_CHECKING:
    from nonsmooth.solver.arrays import Vector
    from nonsmooth.solver.results.family import Family, FamilyRow

#: What can be drawn, and what the axis says; of the third, where there are several phases.
QUANTITIES = {
    "displacement": "ends of the displacement [m]",
    "velocity": "ends of the velocity [m/s]",
    "times": "durations, as parts of the period",
    "estimate": "estimated error of the times",
    "period": "period [s]",
}


def draw(result: "Family", ax: Any = None, quantity: str = "displacement", **style: Any) -> Any:
    """Draw one quantity of a family along its parameter and return the axes.

    Parameters
    ----------
    result : Family
        What is drawn.
    ax : matplotlib Axes, optional
        Where; new ones without it.
    quantity : {"displacement", "velocity", "times", "estimate", "period"}
        Of the first two both ends; the durations of the phases, or of a single one the phase
        of the forcing; the estimated error of the times; the period.
    **style
        Of the lines, as `matplotlib.axes.Axes.plot` takes it.

    Raises
    ------
    ValueError
        If `quantity` is none of these.
    """
    check_quantity(quantity, QUANTITIES)
    axes, along = axes_or_new(ax), result["value"]
    look = {"color": about(result.method).look["color"], "linewidth": 1.2} | style
    if quantity == "times":
        _draw_times(axes, result, along, {"linewidth": 1.2, "color": "0.2"} | style)
    elif quantity == "estimate":
        errors = [row.estimate.times if row.estimate else np.nan for row in result.rows]
        axes.semilogy(along, errors, **look)
    elif quantity == "period":
        axes.plot(along, result["period"], **look)
    else:
        for end in (0, 1):
            axes.plot(along, _ends(result, quantity, end), **look)
    if quantity != "times":
        axes.set_ylabel(QUANTITIES[quantity])
    axes.set_xlabel(name_of(result))
    return axes


def name_of(result: "Family") -> str:
    """Return what the axis of the parameter says."""
    parameter = next(q for q in result.case.scene.parameters if q.name == result.parameter)
    unit = f" [{parameter.unit}]" if parameter.unit else ""
    return f"{parameter.name.replace('_', ' ')} {parameter.symbol}{unit}"


def _ends(result: "Family", name: str, end: int) -> "Vector":
    def value(row: "FamilyRow") -> float:
        return np.nan if row.extremes is None else row.extremes[name][end]

    return np.array([value(row) for row in result.rows])


def _draw_times(axes: Any, result: "Family", along: "Vector", style: dict[str, Any]) -> None:
    """Draw the phase of the forcing, or the durations of the phases as parts of the period."""
    names = result.case.scene.phases
    if len(names) == 1:
        axes.plot(along, result["forcing_phase"], **style)
        axes.set_ylabel("phase of the forcing [rad]")
        return
    for name, line in zip(names, cycle(("-", "--", "-.", ":")), strict=False):
        part = [
            result.durations_of(row).get(name, np.nan) / (row.period or np.nan)
            for row in result.rows
        ]
        axes.plot(along, part, **{"linestyle": line, "label": name} | style)
    axes.set_ylabel(QUANTITIES["times"])
    axes.legend(frameon=False)


def family_figure(result: "Family", log: bool = False) -> Figure:
    """Draw ends of displacement and velocity, the times, and the estimated error."""
    scene = result.case.scene
    figure = Figure(figsize=(8, 6), layout="constrained")
    panels = figure.subplots(2, 2, sharex=True).ravel()
    for axes, quantity in zip(panels, QUANTITIES, strict=False):
        draw(result, axes, quantity)
    for axes in panels[:2]:
        axes.set_xlabel("")
    if log:
        panels[0].set_xscale("log")
    method = f"{shown(scene, result.method)}, N = {result.order}"
    words = f"{scene.name}: {result.other_parameters}; {method}"
    figure.supxlabel(words, fontsize=7, wrap=True)
    return figure
