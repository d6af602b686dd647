"""The paper's oscillator along a parameter: period, amplitude, stick fraction, estimate."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from matplotlib.figure import Figure

from nonsmooth.solver.shortcuts.orbit.oscillator import PARAMETERS

from ...style import label, line
from ..axes import axes_or_new, check_quantity

if TYPE_CHECKING:
    from nonsmooth.solver.shortcuts.search.family import Family

#: What is drawn, and what the axis says.
QUANTITIES = {
    "period": "period $T$ [s]",
    "amplitude": "amplitude [m]",
    "stick_fraction": "stick fraction $t_1/T$",
    "estimate_period": "estimated error of $T$",
}

#: The one that is an error, drawn on a logarithmic axis.
ERROR = "estimate_period"


def draw(family: "Family", ax: Any = None, quantity: str = "period", **style: Any) -> Any:
    """Draw one quantity of a family along its parameter and return the axes.

    Parameters
    ----------
    family : Family
        What is drawn.
    ax : matplotlib Axes, optional
        Where; new ones without it.
    quantity : {"period", "amplitude", "stick_fraction", "estimate_period"}
        The field of its points.
    **style
        Of the line, as `matplotlib.axes.Axes.plot` takes it.

    Raises
    ------
    ValueError
        If `quantity` is none of these.
    """
    check_quantity(quantity, QUANTITIES)
    axes = axes_or_new(ax)
    look = line(family.method) | {"label": label(family.method, family.c1_terms)} | style
    axes.plot(family["value"], family[quantity], **look)
    unit = PARAMETERS[family.parameter][0]
    words = family.parameter.replace("_", " ") + (f" [{unit}]" if unit else "")
    axes.set(xlabel=words, ylabel=QUANTITIES[quantity])
    if quantity == ERROR:
        axes.set_yscale("log")
    return axes


def family_figure(families: "Mapping[str, Family]", log: bool = False) -> Figure:
    """Draw the four of each family over the same values, on logarithmic axes if asked for."""
    figure = Figure(figsize=(8, 6), layout="constrained")
    panels = figure.subplots(2, 2, sharex=True).ravel()
    for axes, quantity in zip(panels, QUANTITIES, strict=True):
        for family in families.values():
            draw(family, axes, quantity)
        if log:
            axes.set_xscale("log")
            if quantity != "stick_fraction":
                axes.set_yscale("log")
    for axes in panels[:2]:
        axes.set_xlabel("")
    order = next(iter(families.values())).order
    figure.legend(
        *panels[0].get_legend_handles_labels(), loc="outside upper left",
        ncols=len(families), frameon=False, title=f"$N = {order}$",
    )  # fmt: skip
    return figure
