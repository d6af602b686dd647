"""From an oscillator to a folder: the scan, the pictures, the page."""

import math
from collections.abc import Callable
from pathlib import Path

import matplotlib as mpl
from matplotlib.figure import Figure

import nonsmooth as ns
from nonsmooth.style import save

from .captions import PLATES
from .case import Case
from .claim_map import claim_map
from .claims import CLAIMS, PARTS
from .figures import FIGURES, LOOK, SIZE, figure
from .intervals import SCANNED, Intervals, scan
from .page import page

#: Vector formats of every picture; the page has the SVG inside.
SUFFIXES = (".svg", ".pdf")

#: Names of the pictures, that of the claims last.
PICTURES = (*FIGURES, "claims")

#: How often progress is told: the scan, the pictures, the page.
STEPS = SCANNED + len(PARTS) + len(PICTURES) + 1

#: Every file of a report.
FILES = {"index.html", *(name + suffix for name in PICTURES for suffix in SUFFIXES)}


def draw(case: Case, intervals: Intervals, folder: Path, done: Callable[[str], None]) -> None:
    """Write every picture into a folder, in each format."""
    for name in PICTURES:
        with mpl.rc_context(LOOK):
            if name in FIGURES:
                made = figure(FIGURES[name], case)
            else:
                made = claim_map(case.belt, CLAIMS, intervals)
            for suffix in SUFFIXES:
                save(made, folder / (name + suffix))
        done(name)


def plate(belt: ns.StickSlip, number: int) -> Figure:
    """Return one figure of the paper, from 1 to 6: its pictures beside and below each other."""
    (names,) = (list(plate.pictures) for plate in PLATES if plate.number == number)
    columns = min(len(names), 2)
    rows = math.ceil(len(names) / columns)
    made = Figure(figsize=(columns * SIZE[0], rows * SIZE[1]), layout="constrained")
    case = Case(belt)
    for axes, name in zip(made.subplots(rows, columns, squeeze=False).flat, names, strict=True):
        FIGURES[name](axes, case)
        letter = name.removeprefix(f"fig-{number}")
        if len(letter) == 1:
            axes.annotate(f"({letter})", (-0.12, 1.02), xycoords="axes fraction")
    return made


def write_plate(belt: ns.StickSlip, number: int, target: Path) -> None:
    """Write one figure of the paper as a picture, in the format that its ending names."""
    with mpl.rc_context(LOOK):
        save(plate(belt, number), target)


def build(belt: ns.StickSlip, folder: Path, done: Callable[[str], None]) -> None:
    """Write the report on an oscillator into an empty folder.

    Parameters
    ----------
    belt : StickSlip
        The oscillator.
    folder : Path
        An empty folder.
    done : callable
        Called `STEPS` times with what has just been done, in words.
    """
    intervals = scan(belt, PARTS, done)
    case = Case(belt)
    draw(case, intervals, folder, done)
    pictures = {name: (folder / f"{name}.svg").read_text("utf-8") for name in PICTURES}
    (folder / "index.html").write_text(page(case, intervals, pictures), "utf-8")
    done("index.html")
