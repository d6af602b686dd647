"""Time against error of the times for the other scenes, our methods and others in one sitting.

    python -m benchmarks.scenes [-o output]

All start from the same rough times (10 %, 0.3 rad off) and are timed in turn, round after
round; medians.  ck-tau, ck, hb and hb-ck are compiled kernels, the start of the coefficients
included: that of ck-tau is its own, the others' is by normal equations.  Every method but
ck-tau starts from the times of ck-tau at N = 5, whose time counts.
Prints tables and targets, and writes ``scenes.png``.
"""

import argparse
import statistics
import time
from collections.abc import Callable
from pathlib import Path

import numba
from numba.core.dispatcher import Dispatcher

from nonsmooth.solver.kernels import registry

from . import scene_ours, scene_rivals, scene_simulation
from . import scene_references as references
from .scene_rivals import Solve
from .scene_shown import RK4, Point, cheapest, draw, show

ROUNDS = 9
SECONDS = 0.01  # of work in one round of one contender

#: What ck-tau may take of the time of the RK4 return map, at an error of the times.
TARGETS = {1e-6: 1.0, 1e-10: 1 / 3}

#: Methods, the functions of hb-ck that `solve_case` takes, and the orders.
ORDERS = {
    "ck-tau": (3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 16),
    "ck": (4, 6, 8, 10, 12, 14, 16),
    "hb": (4, 8, 16, 32, 64),
    "hb-ck": (4, 8, 16, 32, 64),
}

#: Contenders that are kernels, in the scene's own units.
KERNELS = tuple(ORDERS)

STEPS = (16, 24, 32, 48, 64, 128, 256, 288, 320, 512, 544, 576, 1024, 2048)

#: Scene, functions of hb-ck, and what is written for it by hand: name, solver, settings.
SCENES: dict[str, tuple[int, tuple[tuple[str, Solve, tuple[int, ...]], ...]]] = {
    "impact": (
        2,
        (
            (RK4, scene_rivals.impact_rk4_map, STEPS),
            ("  no event, known period", scene_rivals.impact_rk4_period, STEPS),
            ("exact flow, by hand", scene_rivals.impact_flow, (0,)),
            ("solve_ivp DOP853", scene_simulation.impact, (3, 6, 9, 12)),
        ),
    ),
    "stick-slip-damped": (
        1,
        (
            (RK4, scene_rivals.belt_rk4, STEPS),
            ("exact flow, by hand", scene_rivals.belt_flow, (0,)),
            ("solve_ivp DOP853", scene_simulation.belt, (3, 6, 9, 12)),
        ),
    ),
}


def _contenders(scene: str) -> list[tuple[str, Solve, tuple[int, ...]]]:
    """Return all ways to the orbit of a scene, ours first."""
    functions, rivals = SCENES[scene]
    found = []
    for method, orders in ORDERS.items():
        number = functions if method == "hb-ck" else None
        found.append((method, scene_ours.newton(scene, method, number), orders))
    found.append(("ck-tau solve_case()", scene_ours.whole(scene, "ck-tau"), (6, 10, 14)))
    found.append(("exact flow, exact_orbit()", scene_ours.exact_flow(scene), (0,)))
    return [*found, *rivals]


def _repeated(solve: Solve) -> Callable[..., float]:
    """Return a loop over orbits from slightly different times; compiled if `solve` is."""

    def loop(case, setting, a, b, count):
        total = 0.0
        for i in range(count):
            total += solve(case, setting, a, b * (1 + 1e-9 * i))[1]
        return total

    return numba.njit(loop) if isinstance(solve, Dispatcher) else loop


def measure(rounds: int = ROUNDS, fewest: bool = False) -> list[Point]:
    """Return all points, timed round by round; with `fewest`, one setting of each contender."""
    runs = []
    for scene in SCENES:
        case, rough = registry.load(scene)(), references.rough(scene)
        unit = case.units.time
        units = (unit, 1.0) if case.cell.forced else (unit, unit)
        for name, solve, settings in _contenders(scene):
            own = name in KERNELS
            scale = units if own else (1.0, 1.0)
            a, b = (t / u for t, u in zip(rough, scale, strict=True))
            loop = _repeated(solve)
            for setting in settings[:1] if fewest else settings:
                given = tuple(case.values.values()), setting
                if own:
                    number = SCENES[scene][0] if name == "hb-ck" else None
                    given = scene_ours.taken(case, name, setting, number)
                times = solve(*given, a, b)
                error = references.error(scene, (times[0] * scale[0], times[1] * scale[1]))
                once = min(_seconds(loop, *given, a, b, 1) for _ in range(3))
                count = max(1, min(20_000, int(SECONDS / once)))
                arguments = (loop, *given, a, b, count)
                runs.append((scene, name, setting, error, arguments))
    seen: list[list[float]] = [[] for _ in runs]
    for _ in range(rounds):
        for run, times in zip(runs, seen, strict=True):
            times.append(_seconds(*run[4]))
    return [
        Point(scene, name, setting, error, statistics.median(times))
        for (scene, name, setting, error, _), times in zip(runs, seen, strict=True)
    ]


def _seconds(loop: Callable[..., float], case, setting, a, b, count) -> float:
    begin = time.perf_counter()
    loop(case, setting, a, b, count)
    return (time.perf_counter() - begin) / count


def targets(points: list[Point]) -> list[dict[str, object]]:
    """Return each target with the measured ratio, and whether it is met."""
    rows: list[dict[str, object]] = []
    for scene in SCENES:
        for error, allowed in TARGETS.items():
            mine = cheapest(points, scene, "ck-tau", error)
            theirs = cheapest(points, scene, RK4, error)
            ratio = mine.seconds / theirs.seconds
            what = (
                f"{scene}, {error:g}: ck-tau (N = {mine.setting}) over RK4 ({theirs.setting})"
            )
            rows.append({"target": what, "at_most": allowed, "measured": ratio})
    for row in rows:
        row["met"] = float(str(row["measured"])) <= float(str(row["at_most"]))
    return rows


def main() -> None:
    """Measure, print, draw."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", type=Path, default=Path("output"))
    folder = parser.parse_args().output
    folder.mkdir(parents=True, exist_ok=True)
    points = measure()
    show(points, targets(points))
    draw(points, folder / "scenes.png")
    print(f"wrote {folder / 'scenes.png'}")


if __name__ == "__main__":
    main()
