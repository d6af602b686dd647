"""The look of the pictures of both reports, and how they are written.

Each is narrow enough for a telephone.
"""

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

from nonsmooth.plots.axes import SETTINGS, panel, write

#: Size in inches, and of texts in points; on a telephone both are shown at two thirds.
SIZE = (4.8, 3.2)
LOOK: Any = SETTINGS | {"font.size": 10, "legend.fontsize": 9}

#: Formats of every picture; the page embeds the SVG.
SUFFIXES = (".svg", ".pdf")

#: Placement of a legend above the axes, centred.
ABOVE: Any = {"loc": "lower center", "bbox_to_anchor": (0.5, 1.0), "frameon": False}

#: A function that draws an object on given axes.
Draw = Callable[[Any, Any], None]


def figure(draw: Draw, shown: object) -> Figure:
    """Return a figure with one pair of axes, on which `draw` has drawn `shown`."""
    return panel(lambda axes: draw(axes, shown), SIZE)


def legend(axes: Any, columns: int) -> None:
    """Put the legend above the axes, in so many columns."""
    axes.legend(ncols=columns, columnspacing=1.2, **ABOVE)


def files(names: Iterable[str]) -> set[str]:
    """Return the names of all files of a report with these pictures."""
    return {"index.html", *(name + suffix for name in names for suffix in SUFFIXES)}


def write_report(
    folder: Path,
    pictures: Mapping[str, Callable[[], Figure]],
    page: Callable[[Mapping[str, str]], str],
    done: Callable[[str], None],
) -> None:
    """Write every picture into a folder, in each format, and the page with their SVGs."""
    for name, draw in pictures.items():
        write(draw, *(folder / (name + suffix) for suffix in SUFFIXES), look=LOOK)
        done(name)
    drawn = {name: (folder / f"{name}.svg").read_text("utf-8") for name in pictures}
    (folder / "index.html").write_text(page(drawn), "utf-8")
    done("index.html")
