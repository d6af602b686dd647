"""What a figure shows, read back from matplotlib: curves, their looks, legends, words."""

from typing import Any

import numpy as np
from computed import ODD, case
from matplotlib.colors import to_hex
from matplotlib.lines import Line2D

import nonsmooth as ns
from nonsmooth.report.figures import FIGURES
from nonsmooth.report.pictures import figure

#: The paper's markers.
MARKERS = {"hb": "D", "hb-c1": "s", "c1": "o"}


def report_axes(name: str, belt: ns.StickSlip = ODD) -> Any:
    """Return the only axes of a figure of the report."""
    (axes,) = figure(FIGURES[name], case(belt)).axes
    return axes


def labels(axes: Any) -> tuple[str, str]:
    """Return what stands at the two axes."""
    return axes.get_xlabel(), axes.get_ylabel()


def data(line: Line2D) -> tuple[np.ndarray, np.ndarray]:
    """Return the numbers of a curve."""
    return np.asarray(line.get_xdata(), float), np.asarray(line.get_ydata(), float)


def longest(axes: Any) -> Line2D:
    """Return the curve of most points."""
    return max(axes.lines, key=lambda line: len(line.get_xdata()))


def look(line: Line2D) -> tuple[str, str, str]:
    """Return what tells a curve from others: colour, marker, whether it is dashed."""
    return to_hex(line.get_color()), str(line.get_marker()), str(line.get_linestyle())


def legend(holder: Any) -> dict[str, Line2D]:
    """Return the handles of the only legend of axes or of a figure, by their words."""
    one = holder.get_legend() if hasattr(holder, "get_legend") else holder.legends[0]
    words = [text.get_text() for text in one.get_texts()]
    return dict(zip(words, one.legend_handles, strict=True))


def explained(axes: Any, legend_of: Any = None) -> dict[str, Line2D]:
    """Return the curves by what the legend says of those that look like them."""
    handles = legend(axes if legend_of is None else legend_of)
    found = {}
    for words, handle in handles.items():
        alike = [line for line in axes.lines if look(line) == look(handle)]
        assert len(alike) == 1, (words, len(alike))
        found[words] = alike[0]
    return found


def words(axes: Any) -> list[str]:
    """Return all text inside axes, in the order it was drawn."""
    return [text.get_text() for text in axes.texts if text.get_text()]


def note(axes: Any, text: str) -> Any:
    """Return the one annotation that begins with these words."""
    (found,) = (a for a in axes.texts if a.get_text().startswith(text))
    return found
