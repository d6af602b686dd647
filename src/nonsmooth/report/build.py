"""The report on an oscillator, written into a folder: the scan, the pictures, the page."""

import math
from collections.abc import Callable
from functools import partial
from pathlib import Path

from matplotlib.figure import Figure

import nonsmooth as ns
from nonsmooth.plots.axes import write

from ..workers import pool
from .captions import PLATES
from .case import Case
from .claims import CLAIMS, PARTS
from .figures import FIGURES, claim_map
from .intervals import SCANNED, scan
from .page import page
from .pictures import LOOK, SIZE, figure, files, write_report

#: Names of the pictures; the last is the map of the claims.
PICTURES = (*FIGURES, "claims")

#: Number of steps of which progress is reported: the scan, the pictures, the page.
STEPS = SCANNED + len(PARTS) + len(PICTURES) + 1

#: Every file of a report.
FILES = files(PICTURES)


def plate(belt: ns.StickSlip, number: int) -> Figure:
    """Return one figure of the paper, 1 to 6, with its pictures in two columns."""
    (names,) = (list(plate.pictures) for plate in PLATES if plate.number == number)
    columns = min(len(names), 2)
    rows = math.ceil(len(names) / columns)
    fig = Figure(figsize=(columns * SIZE[0], rows * SIZE[1]), layout="constrained")
    case = Case(belt)
    for axes, name in zip(fig.subplots(rows, columns, squeeze=False).flat, names, strict=True):
        FIGURES[name](axes, case)
        letter = name.removeprefix(f"fig-{number}")
        if len(letter) == 1:
            axes.annotate(f"({letter})", (-0.12, 1.02), xycoords="axes fraction")
    return fig


def write_plate(belt: ns.StickSlip, number: int, target: Path) -> None:
    """Write one figure of the paper to a file, in the format of its suffix."""
    write(partial(plate, belt, number), target, look=LOOK)


def build(belt: ns.StickSlip, folder: Path, done: Callable[[str], None]) -> None:
    """Write the report on an oscillator into an empty folder.

    Parameters
    ----------
    belt : StickSlip
        The oscillator.
    folder : Path
        An empty folder.
    done : callable
        Called `STEPS` times, with the step just done in words.
    """
    with pool() as processes:
        intervals = scan(belt, PARTS, done, processes.map)
    case = Case(belt)
    pictures = {name: partial(figure, drawn, case) for name, drawn in FIGURES.items()}
    pictures["claims"] = partial(claim_map, belt, CLAIMS, intervals)
    write_report(folder, pictures, partial(page, case, intervals), done)
