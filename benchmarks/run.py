"""Time against accuracy: our methods and what a user would otherwise use, in one sitting.

    python -m benchmarks.run [-o output/bench]

Writes tables, ``bench.json``, ``bench.png`` and, of the other scenes, ``scenes.png``.  Every
contender is timed in turn, round after round, so that a slow spell of the machine hits all;
figures are medians.
"""

import argparse
import json
import math
import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

import numba
from numba.core.dispatcher import Dispatcher

from . import latency, ours, rivals, scenes, unrolled

ALPHAS = (0.245, 1.0)
ROUNDS = 7
SECONDS = 0.04  # of work in one round of one contender

#: Errors at which contenders are compared, and what `ck-tau` is to reach there: the rival, and
#: the largest part of its time.
TARGETS = {
    1e-6: ("numba RK4 + event", 1.0),
    1e-9: ("numba RK4 + event", 0.5),
    1e-13: ("numba collocation", 0.5),
}


@dataclass(frozen=True)
class Contender:
    """A way to the period, at several settings."""

    name: str
    make: Callable[[float], rivals.Period]
    settings: Sequence[float]


CONTENDERS = (
    Contender("c1-tau kernel", ours.by_kernel("ck-tau"), (3, 4, 5, 6, 7, 8, 9, 10, 12)),
    Contender("c1 kernel", ours.by_kernel("ck"), (5, 7, 8, 9, 10, 11, 13, 15, 17)),
    Contender("c1-tau solve()", ours.by_solve("ck-tau"), (5, 7, 9, 11)),
    Contender("c1 solve()", ours.by_solve("c1"), (5, 9, 13, 17)),
    Contender("hb-c1 solve()", ours.by_solve("hb-c1"), (5, 10, 20, 40)),
    Contender("hb solve()", ours.by_solve("hb"), (5, 10, 20, 40)),
    Contender(
        "numba RK4 + event",
        rivals.rk4_with_event,
        (32, 64, 72, 96, 128, 256, 320, 384, 512, 1024, 4096),
    ),
    Contender("  multiplied out by hand", rivals.linear_rk4_with_event, (64, 256, 1024)),
    Contender("numba collocation", rivals.collocation, (8, 10, 12, 14, 16, 18, 20, 22)),
    Contender("solve_ivp DOP853", rivals.dop853, (1e-5, 1e-8, 1e-11, 1e-13)),
    Contender("solve_bvp", rivals.bvp_two_segments, (1e-3, 1e-6, 1e-9)),
    Contender("Gauss + fsolve", rivals.quadrature_and_fsolve, (5, 7, 9)),
    Contender("unrolled lambdify", unrolled.unrolled, (5, 7, 8, 9)),
)


@dataclass(frozen=True)
class Point:
    """One contender at one setting and alpha: its error, and seconds an orbit."""

    name: str
    setting: float
    alpha: float
    error: float
    seconds: float


def repeated(period: rivals.Period) -> Callable[[float, int], float]:
    """Return a loop over orbits of slightly different alpha; compiled if `period` is."""

    def loop(alpha: float, count: int) -> float:
        total = 0.0
        for i in range(count):
            total += period(alpha * (1 + 1e-12 * i))
        return total

    return numba.njit(loop) if isinstance(period, Dispatcher) else loop


def seconds_of(loop: Callable[[float, int], float], alpha: float, count: int) -> float:
    """Return seconds an orbit of one run of `count` orbits."""
    begin = time.perf_counter()
    loop(alpha, count)
    return (time.perf_counter() - begin) / count


def measure() -> list[Point]:
    """Return all points, timed round by round."""
    cases = []
    for contender in CONTENDERS:
        for setting in contender.settings:
            period = contender.make(setting)
            loop = repeated(period)
            for alpha in ALPHAS:
                T = 2 * alpha + math.pi + 2 * math.atan2(1.0, alpha)
                try:
                    error = abs(period(alpha) / T - 1)
                except Exception as failure:  # a rival that fails is left out, and said
                    print(f"{contender.name} at {setting:g}, alpha = {alpha}: {failure}")
                    continue
                once = seconds_of(loop, alpha, 1)
                once = min(once, seconds_of(loop, alpha, 1))
                count = max(1, min(200_000, int(SECONDS / max(once, 1e-7))))
                cases.append((contender.name, setting, alpha, error, loop, count))
    times: list[list[float]] = [[] for _ in cases]
    for _ in range(ROUNDS):
        for case, seen in zip(cases, times, strict=True):
            seen.append(seconds_of(case[4], case[2], case[5]))
    return [
        Point(name, setting, alpha, error, statistics.median(seen))
        for (name, setting, alpha, error, _, _), seen in zip(cases, times, strict=True)
    ]


def cheapest(points: list[Point], name: str, alpha: float, error: float) -> Point | None:
    """Return the fastest setting of a contender that is at least this accurate."""
    good = [p for p in points if p.name == name and p.alpha == alpha and p.error <= error]
    return min(good, key=lambda p: p.seconds, default=None)


def targets(points: list[Point]) -> list[dict[str, object]]:
    """Return each target with the measured ratio, met or not."""
    rows: list[dict[str, object]] = []
    for alpha in ALPHAS:
        for error, (rival, allowed) in TARGETS.items():
            mine = cheapest(points, "c1-tau kernel", alpha, error)
            theirs = cheapest(points, rival, alpha, error)
            if mine is None or theirs is None:
                continue
            ratio = mine.seconds / theirs.seconds
            what = f"alpha {alpha:g}, error {error:g}: time over {rival}"
            rows.append({"target": what, "at_most": allowed, "measured": ratio})
    return rows


def judged(rows: list[dict[str, object]]) -> list[dict[str, object]]:
    """Return the rows, each with whether it meets its target."""
    for row in rows:
        row["met"] = float(str(row["measured"])) <= float(str(row["at_most"]))
    return rows


def show(points: list[Point], rows: list[dict[str, object]]) -> None:
    """Print the tables."""
    print(f"{'contender':26}{'setting':>9}{'alpha':>7}{'period error':>14}{'microseconds':>14}")
    for p in points:
        time_ = p.seconds * 1e6
        print(f"{p.name:26}{p.setting:9g}{p.alpha:7g}{p.error:14.1e}{time_:14.3f}")
    print()
    print(f"{'target':58}{'at most':>9}{'measured':>10}  met")
    for row in rows:
        met = "yes" if row["met"] else "NO"
        print(f"{row['target']:58}{row['at_most']:9.3g}{row['measured']:10.3g}  {met}")


def draw(points: list[Point], target: Path) -> None:
    """Draw error against time, a panel for each alpha."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(10, 5), layout="constrained")
    markers = "os^DvP*X<>phd"
    for axes, alpha in zip(figure.subplots(1, 2, sharey=True), ALPHAS, strict=True):
        for contender, marker in zip(CONTENDERS, markers, strict=True):
            chosen = [p for p in points if p.name == contender.name and p.alpha == alpha]
            chosen.sort(key=lambda p: p.setting)
            own = contender.name.startswith(("c1", "hb"))
            axes.loglog(
                [p.seconds for p in chosen],
                [max(p.error, 1e-16) for p in chosen],
                marker=marker,
                markersize=5,
                linewidth=1.4 if own else 0.8,
                linestyle="-" if own else "--",
                label=contender.name,
            )
        axes.set(xlabel="seconds an orbit", title=f"alpha = {alpha:g}")
        axes.grid(alpha=0.3)
    figure.axes[0].set_ylabel("error of the period")
    handles, labels = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=5, frameon=False)
    figure.savefig(target, dpi=150)


def main() -> None:
    """Measure, print, write."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", type=Path, default=Path("output"))
    folder = parser.parse_args().output
    folder.mkdir(parents=True, exist_ok=True)
    points = measure()
    rows = judged(targets(points) + latency.measure())
    show(points, rows)
    others = scenes.measure()
    other_rows = scenes.targets(others)
    scenes.show(others, other_rows)
    document = {
        "schema": 1,
        "points": [asdict(p) for p in points],
        "targets": rows,
        "scenes": [asdict(p) for p in others],
        "targets_of_scenes": other_rows,
    }
    (folder / "bench.json").write_text(json.dumps(document, indent=2) + "\n")
    draw(points, folder / "bench.png")
    scenes.draw(others, folder / "scenes.png")
    print(f"wrote bench.json, bench.png and scenes.png to {folder}")


if __name__ == "__main__":
    main()
