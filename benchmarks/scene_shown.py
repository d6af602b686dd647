"""The points of the other scenes: their table, and their picture."""

from dataclasses import dataclass
from pathlib import Path

#: What ck-tau is compared with, and what is the floor.
RK4, EXACT = "numba RK4 return map", "exact flow, by hand"

#: What the legend says, where it is not the name.
LEGEND = {
    "  no event, known period": "RK4 over the known period",
    "hb-ck": "hb-ck (K = 2; K = 1)",
}


@dataclass(frozen=True)
class Point:
    """One contender at one setting: error of the times, a part of T, and seconds an orbit."""

    scene: str
    name: str
    setting: int
    error: float
    seconds: float


def _scenes(points: list[Point]) -> list[str]:
    return list(dict.fromkeys(p.scene for p in points))


def cheapest(points: list[Point], scene: str, name: str, error: float) -> Point:
    """Return the fastest setting of a contender that is at least this accurate."""
    good = [p for p in points if (p.scene, p.name) == (scene, name) and p.error <= error]
    return min(good, key=lambda p: p.seconds)


def show(points: list[Point], rows: list[dict[str, object]]) -> None:
    """Print the tables."""
    print(f"\n{'scene':19}{'contender':27}{'setting':>8}{'times off':>11}{'microseconds':>14}")
    for p in points:
        print(f"{p.scene:19}{p.name:27}{p.setting:8}{p.error:11.1e}{p.seconds * 1e6:14.2f}")
    print()
    for scene in _scenes(points):
        exact = cheapest(points, scene, EXACT, 1e-10)
        for error in (1e-6, 1e-10):
            mine = cheapest(points, scene, "ck-tau", error)
            ratio = mine.seconds / exact.seconds
            print(f"{scene}, {error:g}: ck-tau takes {ratio:.3g} times the exact flow by hand")
    print(f"\n{'target':76}{'at most':>9}{'measured':>10}  met")
    for row in rows:
        met = "yes" if row["met"] else "NO"
        print(f"{row['target']:76}{row['at_most']:9.3g}{row['measured']:10.3g}  {met}")


def draw(points: list[Point], target: Path) -> None:
    """Draw error against time, a panel for each scene."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(10, 5.5), layout="constrained")
    names = list(dict.fromkeys(p.name for p in points))
    markers = dict(zip(names, "oos^DP*v>X<", strict=False))
    for axes, scene in zip(figure.subplots(1, 2, sharey=True), _scenes(points), strict=True):
        for number, name in enumerate(names):
            chosen = [p for p in points if (p.scene, p.name) == (scene, name)]
            own = name.strip().startswith(("ck", "hb", "start"))
            axes.loglog(
                [p.seconds for p in chosen],
                [max(p.error, 1e-16) for p in chosen],
                color=f"C{number}" if number < 10 else "0.2",
                marker=markers.get(name, "."),
                markersize=5,
                linewidth=1.4 if own else 0.8,
                linestyle="-" if own else "--",
                label=LEGEND.get(name, name),
            )
        axes.set(xlabel="seconds an orbit", title=scene)
        axes.grid(alpha=0.3)
    figure.axes[0].set_ylabel("error of the times, part of the period")
    handles, labels = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=4, frameon=False)
    figure.savefig(target, dpi=150)
