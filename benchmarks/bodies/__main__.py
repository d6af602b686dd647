"""Time against error of the times for rows of masses with an elastic stop.

    python -m benchmarks.bodies [N ...] [-o output] [--fewest]

Our exact orbit and force series, this also from the orbit at a frequency 1 % lower, as in a
response; harmonic balance (pyHarm where it is installed, and condensed to the contact by hand),
shooting by RK4.  Errors are against times in many digits; medians, taken in turn.  The modes of
the row are computed beforehand for ours, its compliances and flows in every call of the others.
Prints a table, writes ``bodies.json`` and ``bodies.png``.
"""

import argparse
import json
from dataclasses import asdict
from pathlib import Path

from ..every_scene.measured import ROUNDS, Contender, Point, measured
from ..every_scene.shown import curves, show
from . import ours, rivals
from .problem import FEW, Row, row

SIZES = (2, 10, 100, 1000)
ORDERS, STEPS = (3, 4, 6, 8, 10, 12, 16, 24, 32, 48), (64, 256, 1024, 4096, 16384)

#: Steps times masses that shooting is given time for.
MOST = 120_000


def contenders(which: Row) -> list[Contender]:
    """Return all that can be had for a row, ours first."""
    newton, package = ours.by_newton(which), ours.by_package(which)
    ways = [
        ("force series", newton, ORDERS),
        ("force series, in a response", ours.in_response(which), ORDERS),
    ]
    if which.n <= FEW:
        ways += [
            ("exact orbit", newton, (0,)),
            ("ns.solve", package, (10,)),
            ("ns.exact", package, (0,)),
        ]
    steps = [q for q in STEPS if q * which.n <= MOST]
    ways.append(("RK4 shooting, numba", rivals.shooting(which), steps))
    found = [Contender(name, solve, lambda q: (q,), tuple(own)) for name, solve, own in ways]
    balance = [("AFT, condensed, NumPy", rivals.aft(which), rivals.HARMONICS)]
    package = rivals.pyharm(which)
    if package is not None:
        few = [H for H in rivals.HARMONICS if which.n * (2 * H + 1) <= rivals.UNKNOWNS]
        balance.append(("AFT, pyHarm", package, tuple(few)))
    return found + [
        Contender(name, solve, lambda q: (q,), own, rivals.switches)
        for name, solve, own in balance
    ]


def draw(points: list[Point], target: Path) -> None:
    """Draw error against time, a panel a row."""
    from matplotlib.figure import Figure

    names = list(dict.fromkeys(q.scene for q in points))
    figure = Figure(figsize=(4 * max(len(names), 2), 4.5), layout="constrained")
    panels = figure.subplots(1, len(names), squeeze=False, sharey=True)[0]
    for axes, name in zip(panels, names, strict=True):
        curves(axes, [q for q in points if q.scene == name])
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=4)
    figure.savefig(target, dpi=120)


def main() -> None:
    """Read the arguments, measure, print, draw, write."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("sizes", nargs="*", type=int, metavar="N")
    parser.add_argument("-o", "--output", type=Path, default=Path("output"))
    parser.add_argument("--fewest", action="store_true", help="one setting each, once")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    points: list[Point] = []
    for n in options.sizes or SIZES:
        which, rounds = row(n), 1 if options.fewest else ROUNDS
        points += measured(which.name, contenders(which), which.error, rounds, options.fewest)
    show(points, [])
    draw(points, options.output / "bodies.png")
    document = {"schema": 1, "points": [asdict(q) for q in points]}
    (options.output / "bodies.json").write_text(json.dumps(document, indent=2) + "\n")
    print(f"wrote bodies.json and bodies.png to {options.output}")


if __name__ == "__main__":
    main()
