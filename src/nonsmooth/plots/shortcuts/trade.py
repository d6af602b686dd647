"""Time of an orbit against its error, of the paper's methods and of many digits."""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from ...style import LABELS, STYLES

if TYPE_CHECKING:
    from nonsmooth.shortcuts.tradeoff import Point

#: The series that is not the paper's.
TAU_LABEL = {"c1-tau": "c1-tau: $C^1$ functions, other tests"}
TAU_STYLE: dict[str, dict[str, Any]] = {
    "c1-tau": {"color": "#CC79A7", "marker": "^", "linestyle": "-"}
}


def _by_way(points: "list[Point]") -> "dict[tuple[str, str, int], list[Point]]":
    """Return the points of each regime, method and number of C1 functions."""
    found: dict[tuple[str, str, int], list[Point]] = {}
    for point in points:
        found.setdefault((point.regime, point.method, point.c1_terms), []).append(point)
    return found


def tradeoff_figure(points: "list[Point]") -> Figure:
    """Draw error against time, each method a line, the front behind them."""
    figure = Figure(figsize=(7, 4.5), layout="constrained")
    axes = figure.subplots()
    front = sorted((p.seconds, p.error) for p in points if p.front)
    axes.step(
        *np.array(front).T, where="post", color="0.8", linewidth=5, label="the front",
        zorder=1,
    )  # fmt: skip
    for (regime, method, terms), chosen in _by_way(points).items():
        times, errors = [p.seconds for p in chosen], [p.error for p in chosen]
        words, look = (LABELS | TAU_LABEL)[method], (STYLES | TAU_STYLE)[method]
        if terms > 1:
            words = f"{method} with {terms} $C^1$ functions"
            look = look | {"fillstyle": "none", "linewidth": 0.8}
        if regime == "precise":
            words, look = "c1, many digits", {"color": "0.2", "marker": "*"}
        axes.plot(times, errors, label=words, markersize=5, zorder=2, **look)
        if terms > 1:
            where: Any = {"xytext": (4, -8), "textcoords": "offset points", "fontsize": 7}
            axes.annotate(f"K = {terms}", (times[-1], errors[-1]), **where)
    axes.set(xscale="log", yscale="log", xlabel="time of one orbit [s]")
    axes.set_ylabel("relative error of the period")
    axes.legend(frameon=False)
    return figure
