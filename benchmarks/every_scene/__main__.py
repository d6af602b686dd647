"""Time against error of the times for every scene: our methods, and what else leads there.

    python -m benchmarks.every_scene [SCENE ...] [-o output] [--fewest]

All start from the same rough times (10 %, 0.3 rad off) or, where a state is what is unknown,
from one that is 10 % too large; harmonic balance from a first harmonic that is so.  Times are
medians, taken in turn.  The error is the largest of the durations and of the phase of the
forcing over its frequency, as a part of the period, against the exact flow.  Prints a table and
targets, and writes ``every_scene.json`` and a picture for each scene.  `harmonicbalance` (PyPI)
is timed where it is installed.
"""

import argparse
import json
from dataclasses import asdict
from pathlib import Path

from nonsmooth.solver.kernels import registry

from . import shown
from .measured import ROUNDS, Point, measure
from .problem import problem


def run(scenes: list[str], folder: Path, fewest: bool) -> None:
    """Measure, print, draw, write; with `fewest`, the first setting of each contender, once."""
    points: list[Point] = []
    for scene in scenes:
        found = measure(problem(scene), 1 if fewest else ROUNDS, fewest)
        shown.draw(found, folder / f"speed_{scene}.png")
        points += found
    rows = [] if fewest else shown.judged(points)
    shown.show(points, rows)
    document = {"schema": 1, "points": [asdict(p) for p in points], "targets": rows}
    (folder / "every_scene.json").write_text(json.dumps(document, indent=2) + "\n")
    print(f"wrote every_scene.json and a picture of each scene to {folder}")


def main() -> None:
    """Read the arguments, and run."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenes", nargs="*", metavar="SCENE")
    parser.add_argument("-o", "--output", type=Path, default=Path("output"))
    parser.add_argument("--fewest", action="store_true", help="one setting each, once")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    of_one_mass = [name for name in registry.names() if not registry.load(name).has_body]
    run(options.scenes or of_one_mass, options.output, options.fewest)


if __name__ == "__main__":
    main()
