"""Time of an orbit against its error, of the methods of a scene."""

from typing import TYPE_CHECKING, Any

from matplotlib.figure import Figure

from nonsmooth.solver.scenes.method_names import shown
from nonsmooth.solver.scenes.methods import EXACT, about

from .axes import described, frame

if TYPE_CHECKING:
    from nonsmooth.solver.trade.measured import Trade


def trade_figure(result: "Trade") -> Figure:
    """Draw error against time, each method a line, the front behind them."""
    case = result.case
    figure = Figure(figsize=(7, 4.5), layout="constrained")
    axes = figure.subplots()
    best = sorted((p.seconds, p.error) for p in result.points if p.front)
    wide: dict[str, Any] = {"color": "0.8", "linewidth": 5, "zorder": 1}
    axes.step(*zip(*best, strict=True), where="post", label="the front", **wide)
    for method in dict.fromkeys(point.method for point in result.points):
        points = [(p.seconds, p.error) for p in result.points if p.method == method]
        look = {"color": "0.2", "marker": "*"} if method == EXACT else about(method).look
        words = "exact flow" if method == EXACT else shown(case.scene, method)
        times, errors = zip(*points, strict=True)
        axes.plot(times, errors, label=words, markersize=5, zorder=2, **look)
    axes.set(xscale="log", yscale="log", xlabel="time of one orbit [s]")
    axes.set_ylabel("error of the times, as a part of the period")
    frame(figure, axes, described(case))
    return figure
