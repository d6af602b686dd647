"""Convergence of the methods of a scene: errors against the order, and computing time."""

from typing import TYPE_CHECKING, Any

from matplotlib.figure import Figure

from nonsmooth.solver.scenes.methods import EXACT, about, shown

from .axes import axes_or_new, check_quantity, described, draw_errors, frame, legend_above

if TYPE_CHECKING:
    from nonsmooth.solver.results.sweep import Sweep
    from nonsmooth.solver.scenes.loaded import LoadedScene
    from nonsmooth.solver.trade.measured import Trade

#: The errors that can be drawn.
QUANTITIES = ("times", "discontinuous", "period")


def draw(result: "Sweep", ax: Any = None, quantity: str = "times", **style: Any) -> Any:
    """Draw one error of a sweep against the order and return the axes; see `Sweep.plot`."""
    check_quantity(quantity, QUANTITIES)
    axes, scene = axes_or_new(ax), result.case.scene
    for method in dict.fromkeys(row.method for row in result.rows):
        rows = [row for row in result.of(method) if row.errors is not None]
        errors = [getattr(row.errors, quantity) for row in rows]
        look = about(method).look | {"label": shown(scene, method)} | style
        draw_errors(axes, [row.order for row in rows], errors, **look)
    axes.set_ylabel(f"error of {name_of_error(scene, quantity)}")
    if ax is None:
        legend_above(axes.figure, axes)
    return axes


def name_of_error(scene: "LoadedScene", quantity: str) -> str:
    """Return the name of the quantity of an error, for labels."""
    return derivative(scene.k + 1) if quantity == "discontinuous" else f"the {quantity}"


def derivative(order: int) -> str:
    """Return a derivative of the displacement for labels, as ``$x'$``."""
    return "$x" + "'" * order + "$"


def convergence_figure(result: "Sweep") -> Figure:
    """Draw the errors of the times and of the derivative that jumps against the order."""
    figure = Figure(figsize=(8, 4.2), layout="constrained")
    panels = figure.subplots(1, 2)
    for axes, quantity in zip(panels, QUANTITIES, strict=False):
        draw(result, axes, quantity)
        axes.set_title(axes.get_ylabel())
    frame(figure, panels[0], described(result.case))
    return figure


def trade_figure(result: "Trade") -> Figure:
    """Draw errors against computing time, a line for each method, and the Pareto front.

    The line of a method is its own Pareto front.
    """
    case = result.case
    figure = Figure(figsize=(7, 4.5), layout="constrained")
    axes = figure.subplots()
    best = sorted((p.seconds, p.error) for p in result.points if p.front)
    backdrop: dict[str, Any] = {"color": "0.8", "linewidth": 5, "zorder": 1}
    if len(best) > 1:
        axes.step(*zip(*best, strict=True), where="post", label="the front", **backdrop)
    for method in dict.fromkeys(point.method for point in result.points):
        points = result.front_of(method)
        look = {"color": "0.2", "marker": "*"} if method == EXACT else about(method).look
        words = "exact flow" if method == EXACT else shown(case.scene, method)
        times, errors = zip(*points, strict=True)
        axes.plot(times, errors, label=words, markersize=5, zorder=2, **look)
    axes.set(xscale="log", yscale="log", xlabel="time of one orbit [s]")
    axes.set_ylabel("error of the times, as a part of the period")
    frame(figure, axes, described(case))
    return figure
