"""From an oscillator to a folder: the scan, the pictures, the page."""

from collections.abc import Callable
from pathlib import Path

import matplotlib as mpl

from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip
from nonsmooth.style import save

from .case import Case
from .claim_map import claim_map
from .claims import CLAIMS
from .figures import FIGURES, LOOK, figure
from .intervals import SCANNED, Intervals, scan
from .page import page

PARTS = [part for claim in CLAIMS for part in claim.parts]

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


def build(belt: StickSlip, folder: Path, done: Callable[[str], None]) -> None:
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
