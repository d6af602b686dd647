"""Maps of two parameters: regions of motions, their stability, and curves of events."""

from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from ..nearest import in_short
from .axes import axes_or_new, described, panel, say_below
from .families import name_of
from .simulations import BASINS, NONE

if TYPE_CHECKING:
    from nonsmooth.solver.results.chart import Chart

#: The line style of each kind of event.
LINES = {
    "fold": "-", "flip": "--", "torus": (0, (5, 1, 1, 1, 1, 1)), "branch-point": (0, (8, 3)),
    "grazing": ":", "sticking": "-.", "vanishing": (0, (1, 3)),
}  # fmt: skip

#: Hatching of regions that are not stable.
HATCH = "////"

#: Least share of the points for a region to have its number drawn.
LEAST = 0.01


def draw(result: "Chart", ax: Any = None) -> Any:
    """Draw the regions of motions and the curves of events, and return the axes.

    Each motion has a shade, which differs in grey as well, and a number that the legend
    explains.  Regions that are not stable are hatched; those without an orbit are white.
    """
    axes, count = axes_or_new(ax), len(result.motions)
    a, b = result.values
    colors = [NONE, *(BASINS[i % len(BASINS)] for i in range(count))]
    axes.pcolormesh(
        a, b, result.index, cmap=ListedColormap(colors), vmin=-1.5, vmax=count - 0.5,
        shading="nearest", rasterized=True,
    )  # fmt: skip
    _hatch(axes, result)
    handles = [
        Patch(facecolor=colors[i + 1], edgecolor="0.3", label=f"{i + 1}: {in_short(name)}")
        for i, name in enumerate(result.motions)
    ]
    for i in range(count):
        _number(axes, result, i)
    if (result.stable[result.index >= 0] != 1).any():
        words = "not stable"
        handles.append(Patch(facecolor="white", edgecolor="0.3", hatch=HATCH, label=words))
    if (result.index < 0).any():
        handles.append(Patch(facecolor="white", edgecolor="0.3", label="no orbit found"))
    for kind in dict.fromkeys(curve.kind for curve in result.curves):
        curves = [curve.points for curve in result.curves if curve.kind == kind]
        for points in curves:
            (line,) = axes.plot(*points.T, color="black", linestyle=LINES[kind], linewidth=1.2)
        line.set_label(kind)
        handles.append(line)
    axes.set(xlim=(a[0], a[-1]), ylim=(b[0], b[-1]))
    x_name, y_name = (name_of(result.case.scene, name) for name in result.parameters)
    axes.set(xlabel=x_name, ylabel=y_name)
    axes.legend(
        handles=handles, loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0,
        frameon=False, fontsize=8, handlelength=3,
    )  # fmt: skip
    return axes


def _hatch(axes: Any, result: "Chart") -> None:
    """Hatch the points with an orbit that is not known to be stable."""
    unstable = (result.index >= 0) & (result.stable != 1)
    if unstable.any():
        edges = [_edges(each) for each in result.values]
        mask = np.repeat(np.repeat(unstable, 2, axis=0), 2, axis=1)
        axes.contourf(
            *(np.repeat(each, 2)[1:-1] for each in edges), mask, levels=[0.5, 1.5],
            colors="none", hatches=[HATCH],
        )  # fmt: skip


def _edges(values: Any) -> Any:
    """Return the edges of cells around equidistant values."""
    half = (values[1] - values[0]) / 2
    return np.append(values - half, values[-1] + half)


def _number(axes: Any, result: "Chart", i: int) -> None:
    """Draw the number of a motion where its region is widest."""
    from scipy.ndimage import distance_transform_edt  # noqa: PLC0415  (200 ms)

    region = result.index == i
    if region.mean() < LEAST:
        return
    depths = distance_transform_edt(np.pad(region, 1))[1:-1, 1:-1]
    row, column = np.unravel_index(int(depths.argmax()), region.shape)
    a, b = result.values
    axes.text(
        a[column], b[row], str(i + 1), ha="center", va="center", fontsize=9,
        bbox={"facecolor": "white", "edgecolor": "0.3", "boxstyle": "circle,pad=0.25"},
    )  # fmt: skip


def chart_figure(result: "Chart") -> Figure:
    """Draw a map, with a caption."""
    figure = panel(partial(draw, result), (7.5, 4.8))
    say_below(figure, described(result.case, *result.parameters))
    return figure
