"""Picture of an orbit along a parameter: its ends, its times, and what is not sure of it."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from nonsmooth.solver.case.methods import about
from nonsmooth.solver.case.names import shown
from nonsmooth.style import SETTINGS, save

from .captions import others

if TYPE_CHECKING:
    from nonsmooth.solver.arrays import Vector
    from nonsmooth.solver.family import FamilyRow, SceneFamily


def family_picture(result: "SceneFamily", log: bool, target: Path) -> None:
    """Write the figure of a family as a picture."""
    with mpl.rc_context(SETTINGS):
        save(family_figure(result, log), target)


def family_figure(result: "SceneFamily", log: bool = False) -> Figure:
    """Draw ends of displacement and velocity, the times, and the estimated error."""
    scene, along = result.case.scene, result["value"]
    parameter = next(q for q in scene.parameters if q.name == result.parameter)
    figure = Figure(figsize=(8, 6), layout="constrained")
    panels = figure.subplots(2, 2, sharex=True).ravel()
    look = {"color": about(result.method).look["color"], "linewidth": 1.2}
    for axes, (name, unit) in zip(
        panels, (("displacement", "m"), ("velocity", "m/s")), strict=False
    ):
        for end in (0, 1):
            axes.plot(along, _ends(result, name, end), **look)
        axes.set_ylabel(f"ends of the {name} [{unit}]")
    _times(panels[2], result, along)
    estimate = [row.estimate.times if row.estimate else np.nan for row in result.rows]
    panels[3].semilogy(along, estimate, **look)
    panels[3].set_ylabel("estimated error of the times")
    unit = f" [{parameter.unit}]" if parameter.unit else ""
    for axes in panels[2:]:
        axes.set_xlabel(f"{parameter.name.replace('_', ' ')} {parameter.symbol}{unit}")
    if log:
        panels[0].set_xscale("log")
    method = f"{shown(scene, result.method)}, N = {result.order}"
    figure.supxlabel(f"{scene.name}: {others(result)}; {method}", fontsize=7, wrap=True)
    return figure


def _ends(result: "SceneFamily", name: str, end: int) -> "Vector":
    def value(row: "FamilyRow") -> float:
        return np.nan if row.extremes is None else row.extremes[name][end]

    return np.array([value(row) for row in result.rows])


def _times(axes: Any, result: "SceneFamily", along: "Vector") -> None:
    """Draw the phase of the forcing, or the durations of the phases as parts of the period."""
    names = result.case.scene.phases
    if len(names) == 1:
        axes.plot(along, result["forcing_phase"], color="0.2", linewidth=1.2)
        axes.set_ylabel("phase of the forcing [rad]")
        return
    for p, (name, line) in enumerate(
        zip(names, ("-", "--", "-.", ":") * len(names), strict=False)
    ):
        part = [
            np.nan if row.durations is None or row.period is None
            else row.durations[p] / row.period
            for row in result.rows
        ]  # fmt: skip
        axes.plot(along, part, color="0.2", linestyle=line, linewidth=1.2, label=name)
    axes.set_ylabel("durations, as parts of the period")
    axes.legend(frameon=False)
