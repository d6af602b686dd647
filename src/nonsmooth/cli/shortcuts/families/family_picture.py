"""Picture of a sweep over a parameter: period, amplitude, stick fraction, estimate."""

from collections.abc import Mapping
from pathlib import Path

import matplotlib as mpl
from matplotlib.figure import Figure

from nonsmooth.solver.shortcuts.orbit.oscillator import PARAMETERS
from nonsmooth.style import SETTINGS, label, line, save

from .family_job import Job, Points

#: What is drawn, and what the axis says.
PANELS = {
    "period": "period $T$ [s]",
    "amplitude": "amplitude [m]",
    "stick_fraction": "stick fraction $t_1/T$",
    "estimate_period": "estimated error of $T$",
}


def family_picture(job: Job, found: Mapping[str, Points], target: Path) -> None:
    """Write the figure of a sweep over a parameter as a picture."""
    with mpl.rc_context(SETTINGS):
        save(family_figure(job, found), target)


def family_figure(job: Job, found: Mapping[str, Points]) -> Figure:
    """Draw the four along the parameter, each method a line."""
    unit = PARAMETERS[job.vary.parameter][0]
    along = job.vary.flag.replace("-", " ") + (f" [{unit}]" if unit else "")
    figure = Figure(figsize=(8, 6), layout="constrained")
    for axes, (name, title) in zip(
        figure.subplots(2, 2, sharex=True).ravel(), PANELS.items(), strict=True
    ):
        for method, points in found.items():
            words = label(method, job.c1_terms)
            axes.plot(points["value"], points[name], label=words, **line(method))
        axes.set_ylabel(title)
        if job.vary.log:
            axes.set_xscale("log")
        if name != "stick_fraction" and (job.vary.log or name == "estimate_period"):
            axes.set_yscale("log")
        if axes.get_subplotspec().is_last_row():
            axes.set_xlabel(along)
    figure.legend(
        *figure.axes[0].get_legend_handles_labels(), loc="outside upper left",
        ncols=len(found), frameon=False, title=f"$N = {job.order}$",
    )  # fmt: skip
    return figure
