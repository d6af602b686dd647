"""The points of the scenes: their table, and a picture of each."""

import math
from pathlib import Path
from typing import Any

from .measured import FLOOR, MINE, Point

#: Errors at which contenders are compared.
ERRORS = (1e-4, 1e-6, 1e-8, 1e-10)

#: From which on ours should be before all but the floor.
DEMANDING = 1e-8


def cheapest(points: list[Point], scene: str, name: str, error: float) -> Point | None:
    """Return the fastest setting of a contender that is at least this accurate."""
    good = [p for p in points if (p.scene, p.name) == (scene, name) and p.error <= error]
    return min(good, key=lambda p: p.seconds, default=None)


def names(points: list[Point]) -> list[str]:
    """Return the contenders, in their order."""
    return list(dict.fromkeys(p.name for p in points))


def scenes(points: list[Point]) -> list[str]:
    """Return the scenes, in their order."""
    return list(dict.fromkeys(p.scene for p in points))


def judged(points: list[Point]) -> list[dict[str, object]]:
    """Return for each scene and demanding error the quickest rival over ours: at least 1."""
    rows: list[dict[str, object]] = []
    others = [name for name in names(points) if name not in (MINE, FLOOR)]
    for scene in scenes(points):
        for error in (e for e in ERRORS if e <= DEMANDING):
            mine = cheapest(points, scene, MINE, error)
            found = [cheapest(points, scene, name, error) for name in others]
            rival = min(filter(None, found), key=lambda p: p.seconds, default=None)
            what = f"{scene}, {error:g}: {MINE}"
            if mine is None or rival is None:
                who, ratio = "nothing else gets there", 0.0 if mine else math.inf
            else:
                who, ratio = f"{rival.name} ({rival.setting})", mine.seconds / rival.seconds
            met = ratio <= 1.0
            rows.append({"target": f"{what} over {who}", "measured": ratio, "met": met})
    return rows


def show(points: list[Point], rows: list[dict[str, object]]) -> None:
    """Print microseconds to each error, and the targets."""
    heads = "".join(f"{error:>16g}" for error in ERRORS)
    print(
        f"\nmicroseconds to an error of the times, a part of T, and the setting\n{'':46}{heads}"
    )
    for scene in scenes(points):
        for name in names(points):
            found = [cheapest(points, scene, name, error) for error in ERRORS]
            if any(p.scene == scene and p.name == name for p in points):
                cells = (f"{p.seconds * 1e6:.3g} ({p.setting})" if p else "-" for p in found)
                print(f"{scene:19}{name:27}" + "".join(f"{cell:>16}" for cell in cells))
    if rows:
        print(f"\n{'target: at most 1':76}{'measured':>10}  met")
    for row in rows:
        met = "yes" if row["met"] else "NO"
        print(f"{row['target']!s:76}{row['measured']:10.3g}  {met}")


def draw(points: list[Point], target: Path) -> None:
    """Draw error against time for the scene of these points."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7, 4.5), layout="constrained")
    axes = figure.subplots()
    curves(axes, points)
    axes.legend(fontsize=8)
    figure.savefig(target, dpi=120)


def curves(axes: Any, points: list[Point]) -> None:
    """Draw the points of one problem."""
    for number, name in enumerate(names(points)):
        chosen = [p for p in points if p.name == name]
        own = name in (MINE, "hb-ck", "hb")
        axes.loglog(
            [p.seconds for p in chosen],
            [max(p.error, 1e-16) for p in chosen],
            color=f"C{number}",
            marker="os^*v>DP"[number % 8],
            markersize=9 if name == FLOOR else 5,
            linestyle="-" if own else "--",
            label=name,
        )
    axes.set(
        xlabel="seconds an orbit", ylabel="error of the times, part of T", title=points[0].scene
    )
    axes.grid(alpha=0.3)
