"""How every picture looks, and how it is written.

A colour that colour-blind readers tell apart (Okabe & Ito), a marker and a line style for
each method, so that the pictures can be read in grey.
"""

from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure

#: Line style, marker and colour of each method; the paper's markers.
STYLES: dict[str, dict[str, Any]] = {
    "hb": {
        "color": "#0072B2",
        "marker": "D",
        "markerfacecolor": "white",
        "linestyle": (0, (6, 2)),
    },
    "hb-c1": {"color": "#D55E00", "marker": "s", "linestyle": (0, (6, 2, 1.5, 2))},
    "c1": {"color": "#009E73", "marker": "o", "linestyle": (0, (1.5, 1))},
}
EXACT: dict[str, Any] = {"color": "0.25", "linestyle": "-", "linewidth": 1.0}

SETTINGS: Any = {
    "font.size": 9,
    "axes.grid": True,
    "grid.alpha": 0.3,
    "axes.axisbelow": True,
    "svg.hashsalt": "nonsmooth",
    "svg.fonttype": "path",
}

#: A jump misplaced by one rounding error of t/T contributes about its square root to (22).
FLOOR = float(np.sqrt(np.finfo(float).eps))


def save(figure: Figure, target: Path) -> None:
    """Write the figure without a date: the same input gives the same bytes.

    With `SETTINGS` in force.
    """
    metadata = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}
    figure.savefig(target, dpi=150, metadata=metadata.get(target.suffix.lower()))


def line(method: str) -> dict[str, Any]:
    """Return the style of a method's curve, without markers."""
    style = {name: STYLES[method][name] for name in ("color", "linestyle")}
    return style | {"linewidth": 1.4}


def draw_floor(axes: Any) -> None:
    """Mark where rounding of a time alone holds (22); what is far below it is so by luck."""
    axes.axhline(FLOOR, color="0.5", linewidth=0.8, linestyle=(0, (5, 5)))
    where = {"xycoords": ("axes fraction", "data"), "textcoords": "offset points"}
    style = {"fontsize": 7, "color": "0.4"}
    axes.annotate("floor in float64", (0.02, FLOOR), xytext=(0, 3), **where, **style)


def above_floor(error: float) -> float:
    """Return an error (22) as it is drawn: not at all where it is below rounding."""
    return error if error > FLOOR / 10 else float("nan")
