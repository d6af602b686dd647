"""Heat maps of the digits kept: alpha by order, stable and printed form side by side."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from nonsmooth.style import LABELS, SETTINGS, save

from ..scenes.shown.heat_map import draw_digits

if TYPE_CHECKING:
    from nonsmooth.shortcuts.digits import Cell

FORMS = {"stable": "stable forms (the kernels)", "printed": "as printed, SI units"}


def digits_picture(found: "list[Cell]", target: Path) -> None:
    """Write the heat maps as a picture."""
    with mpl.rc_context(SETTINGS | {"axes.grid": False}):
        save(heat_maps(found), target)


def heat_maps(found: "list[Cell]") -> Figure:
    """Draw the digits of ``t1`` and ``T`` that each form keeps, a row a method."""
    methods = list(dict.fromkeys(cell.method for cell in found))
    figure = Figure(figsize=(9, 3.1 * len(methods)), layout="constrained")
    axes = figure.subplots(len(methods), 2, squeeze=False)
    for row, method in zip(axes, methods, strict=True):
        cells = [cell for cell in found if cell.method == method]
        for place, form in zip(row, FORMS, strict=True):
            image = _draw(place, cells, form)
            place.set_title(f"{LABELS[method]}\n{FORMS[form]}", fontsize=9)
    bar = figure.colorbar(image, ax=axes, shrink=0.6)
    bar.set_label("digits of t1 and T, relative to T")
    words = "—: no orbit at this order, slip not resolved, or not measured;  ×: no convergence"
    figure.supxlabel(words, fontsize=8)
    return figure


def _draw(axes: Any, cells: "list[Cell]", form: str) -> Any:
    alphas = sorted({cell.alpha for cell in cells})
    orders = sorted({cell.order for cell in cells})
    digits = np.full((len(alphas), len(orders)), np.nan)
    words = np.full(digits.shape, "—", dtype=object)
    for cell in cells:
        place = alphas.index(cell.alpha), orders.index(cell.order)
        result = getattr(cell, form)
        if result.digits is not None:
            digits[place], words[place] = result.digits, f"{result.digits:.0f}"
        elif result.status == "not-converged":
            digits[place], words[place] = 0, "×"
    image = draw_digits(axes, digits, words, orders, [f"{alpha:g}" for alpha in alphas])
    axes.set(xlabel="order N", ylabel=r"$\alpha$")
    return image
