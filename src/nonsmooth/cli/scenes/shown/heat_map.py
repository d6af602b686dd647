"""A heat map of digits, with each number in its cell."""

from collections.abc import Sequence
from typing import Any

import numpy as np

#: Digits at the two ends of the colour scale, which is as readable in grey.
SCALE = (0, 16)
COLOURS = "cividis"


def draw_digits(
    axes: Any, digits: Any, words: Any, columns: Sequence[object], rows: Sequence[str]
) -> Any:
    """Draw a map and return it, for its scale.

    Parameters
    ----------
    axes : matplotlib Axes
    digits : ndarray, shape (rows, columns)
        Not a number where there are none: the cell is grey.
    words : ndarray of str
        What stands in each cell.
    columns, rows : sequence
        What stands beside them.
    """
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
