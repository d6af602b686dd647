"""How the paper's methods converge: Figs. 4 and 6 for any of its oscillators."""

from typing import TYPE_CHECKING, Any

from matplotlib.figure import Figure

from nonsmooth.solver.shortcuts.orbit.motion import exact

from ...style import EXACT, STYLES, above_floor, draw_floor, label
from ..axes import axes_or_new, check_quantity, draw_errors, frame
from .orbits import caption

if TYPE_CHECKING:
    from nonsmooth.solver.shortcuts.search.sweep import Sweep

#: What can be drawn: the title of its panel, and what its axis says.
QUANTITIES = {
    "ratio": ("period (Fig. 4)", "T / T exact"),
    "period": ("period error", "|T / T exact - 1|"),
    "acceleration": ("acceleration error (Fig. 6)", "error (22)"),
}


def draw(result: "Sweep", ax: Any = None, quantity: str = "period", **style: Any) -> Any:
    """Draw one quantity of a sweep against the order, a line a method; return the axes.

    Parameters
    ----------
    result : Sweep
        What is drawn.
    ax : matplotlib Axes, optional
        Where; new ones, with a legend, without it.
    quantity : {"period", "acceleration", "ratio"}
        The error of the period, or of the acceleration (22), which is not drawn where it is
        below rounding; or the period in exact periods.
    **style
        Of the lines, as `matplotlib.axes.Axes.plot` takes it.

    Raises
    ------
    ValueError
        If `quantity` is none of these.
    """
    check_quantity(quantity, QUANTITIES)
    axes, reference = axes_or_new(ax), exact(result.belt).period
    for method in dict.fromkeys(row.method for row in result.rows):
        rows = [row for row in result.of(method) if row.errors and row.period]
        orders, errors = [row.order for row in rows], [row.errors for row in rows if row.errors]
        look = STYLES[method] | {"label": label(method, result.c1_terms)} | style
        if quantity == "ratio":
            ratios = [(row.period or 0) / reference for row in rows]
            axes.plot(orders, ratios, **{"markersize": 4, "linewidth": 0.9} | look)
        elif quantity == "period":
            draw_errors(axes, orders, [e.period for e in errors], **look)
        else:
            draw_errors(axes, orders, [above_floor(e.acceleration) for e in errors], **look)
    if quantity == "ratio":
        axes.axhline(1, **EXACT)
    elif quantity == "acceleration":
        draw_floor(axes)
    axes.set(xlabel="order N", ylabel=QUANTITIES[quantity][1])
    if ax is None:
        axes.legend(frameon=False)
    return axes


def convergence_figure(result: "Sweep") -> Figure:
    """Draw period and acceleration error against the order, as in Figs. 4 and 6."""
    figure = Figure(figsize=(8, 4.2), layout="constrained")
    panels = figure.subplots(1, 3)
    for axes, (quantity, (title, _)) in zip(panels, QUANTITIES.items(), strict=True):
        draw(result, axes, quantity).set_title(title)
    frame(figure, panels[0], caption(result.belt))
    return figure
