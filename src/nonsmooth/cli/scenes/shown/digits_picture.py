"""Heat maps of the digits that float64 keeps: extremes by order, a map a method."""

from pathlib import Path
from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from nonsmooth.solver.scenes.method_names import shown
from nonsmooth.solver.scenes.methods import EXACT
from nonsmooth.style import SETTINGS, save

from .digits import ABSENT, words_of
from .heat_map import draw_digits

if TYPE_CHECKING:
    from nonsmooth.solver.precision.digits import Kept
    from nonsmooth.solver.scenes.case import Case


def digits_picture(case: "Case", found: "list[Kept]", target: Path) -> None:
    """Write the heat maps as a picture."""
    with mpl.rc_context(SETTINGS | {"axes.grid": False}):
        save(digits_figure(case, found), target)


def digits_figure(case: "Case", found: "list[Kept]") -> Figure:
    """Draw the digits of the times: a map for the exact equations and for each method."""
    methods = list(dict.fromkeys(kept.method for kept in found))
    extremes = list(dict.fromkeys(kept.extreme for kept in found))[::-1]
    orders = sorted({kept.order for kept in found if kept.order is not None})
    widths = [1 if method == EXACT else max(2, len(orders)) for method in methods]
    size = (3.2 + 0.42 * sum(widths), 1.6 + 0.28 * len(extremes))
    figure = Figure(figsize=size, layout="constrained")
    ratios = {"width_ratios": widths}
    maps = figure.subplots(1, len(methods), squeeze=False, sharey=True, gridspec_kw=ratios)[0]
    for axes, method in zip(maps, methods, strict=True):
        columns: list[int | None] = [None] if method == EXACT else [*orders]
        digits = np.full((len(extremes), len(columns)), np.nan)
        words = np.full(digits.shape, ABSENT, dtype=object)
        for kept in (kept for kept in found if kept.method == method):
            place = extremes.index(kept.extreme), columns.index(kept.order)
            digits[place] = np.nan if kept.digits is None else kept.digits
            words[place] = words_of(kept).replace(".0", "")
        labels = ["" if order is None else order for order in columns]
        rows = [extreme or "as given" for extreme in extremes]
        image = draw_digits(axes, digits, words, labels, rows)
        axes.set_title(shown(case.scene, method), fontsize=9)
        axes.set_xlabel("" if method == EXACT else "order N")
    bar = figure.colorbar(image, ax=maps, shrink=0.8)
    bar.set_label("digits of the times")
    figure.supxlabel(f"{case.scene.name}: {case.description}", fontsize=7, wrap=True)
    return figure
