"""Heat maps of the correct digits in float64: extreme parameters by order, a map per method."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.methods import EXACT, shown

from .axes import described, say_below

if TYPE_CHECKING:
    from nonsmooth.solver.precision.digits import Kept

#: Digits at the ends of the colour scale, which is readable in grey as well.
SCALE = (0, 16)
COLOURS = "cividis"


@mpl.rc_context({"axes.grid": False})
def digits_figure(case: Case, measured: "list[Kept]") -> Figure:
    """Draw the correct digits of the times: a map for the exact equations and each method."""
    methods = list(dict.fromkeys(kept.method for kept in measured))
    extremes = list(dict.fromkeys(kept.extreme for kept in measured))[::-1]
    orders = sorted({kept.order for kept in measured if kept.order is not None})
    widths = [1 if method == EXACT else max(2, len(orders)) for method in methods]
    size = (3.2 + 0.42 * sum(widths), 1.6 + 0.28 * len(extremes))
    figure = Figure(figsize=size, layout="constrained")
    ratios = {"width_ratios": widths}
    maps = figure.subplots(1, len(methods), squeeze=False, sharey=True, gridspec_kw=ratios)[0]
    for axes, method in zip(maps, methods, strict=True):
        columns: list[int | None] = [None] if method == EXACT else [*orders]
        digits = np.full((len(extremes), len(columns)), np.nan)
        words = np.full(digits.shape, "", dtype=object)
        for kept in (kept for kept in measured if kept.method == method):
            place = extremes.index(kept.extreme), columns.index(kept.order)
            digits[place] = np.nan if kept.digits is None else kept.digits
            words[place] = kept.words.replace(".0", "")
        labels = ["" if order is None else order for order in columns]
        rows = [extreme or "as given" for extreme in extremes]
        image = _draw_map(axes, digits, words, labels, rows)
        axes.set_title(shown(case.scene, method), fontsize=9)
        axes.set_xlabel("" if method == EXACT else "order $N$")
    bar = figure.colorbar(image, ax=maps, shrink=0.8)
    bar.set_label("digits of the times")
    say_below(figure, described(case))
    return figure


def _draw_map(
    axes: Any, digits: Any, words: Any, columns: Sequence[object], rows: Sequence[str]
) -> Any:
    """Draw a map with texts in its cells, and return it; cells without a number are grey."""
    axes.set_facecolor("0.85")
    image = axes.pcolormesh(digits, cmap=COLOURS, vmin=SCALE[0], vmax=SCALE[1])
    for (i, k), word in np.ndenumerate(words):
        shade = 0.0 if np.isnan(digits[i, k]) or digits[i, k] > 9 else 1.0
        axes.text(
            k + 0.5, i + 0.5, word, ha="center", va="center", color=str(shade), fontsize=7
        )
    axes.set_xticks(np.arange(len(columns)) + 0.5, columns)
    axes.set_yticks(np.arange(len(rows)) + 0.5, rows)
    return image
