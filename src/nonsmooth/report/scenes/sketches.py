"""A sketch of each shipped oscillator: mass, spring, damper, and the non-smooth element."""

from typing import Any

import numpy as np
from matplotlib.patches import Circle, Rectangle

INK, FILL, HATCH = "0.2", "0.92", "0.75"
DRIVEN = r"$F \cos(\Omega t + \varphi)$"
ARROW = {"arrowstyle": "-|>", "color": INK, "shrinkA": 0, "shrinkB": 0}


def arrow(axes: Any, start: tuple[float, float], end: tuple[float, float], name: str) -> None:
    """Draw an arrow, with a name at its end."""
    axes.annotate("", end, xytext=start, arrowprops=ARROW)
    axes.annotate(name, end, xytext=(4, 2), textcoords="offset points", va="bottom")


def line(axes: Any, xs: list[float], ys: list[float], width: float = 1.3) -> None:
    """Draw a polyline."""
    axes.plot(xs, ys, color=INK, linewidth=width)


def words(
    axes: Any, x: float, y: float, name: str, across: str = "left", up: str = "baseline"
) -> None:
    """Write a name at a place."""
    axes.text(x, y, name, ha=across, va=up)


def box(
    axes: Any, left: float, bottom: float, width: float, height: float, shade: str = FILL
) -> None:
    """Draw a rectangular body."""
    axes.add_patch(Rectangle((left, bottom), width, height, facecolor=shade, edgecolor=INK))


def wheel(axes: Any, x: float, y: float, radius: float) -> None:
    """Draw a wheel of a belt."""
    axes.add_patch(Circle((x, y), radius, facecolor="none", edgecolor=INK))


def wall(axes: Any, x: float, bottom: float, top: float, side: int) -> None:
    """Draw a wall with its face at `x`, and its body to the right (`side` 1) or left (-1)."""
    box(axes, x if side > 0 else x - 0.35, bottom, 0.35, top - bottom, HATCH)


def spring(
    axes: Any, start: float, end: float, y: float, name: str, height: float = 0.3
) -> None:
    """Draw a spring between two places."""
    lead = 0.12 * (end - start)
    coils = np.linspace(start + lead, end - lead, 15)
    heights = y + height * np.array([0, *[1, -1] * 6, 1, 0])
    line(axes, [start, *coils, end], [y, *heights, y])
    words(axes, (start + end) / 2, y + height + 0.12, name, "center", "bottom")


def damper(axes: Any, start: float, end: float, y: float, name: str) -> None:
    """Draw a dashpot between two places."""
    middle = (start + end) / 2
    cup = middle + 0.35
    line(axes, [start, middle], [y, y])
    line(axes, [middle, middle], [y - 0.18, y + 0.18])
    line(axes, [middle - 0.3, cup, cup, middle - 0.3], [y - 0.28, y - 0.28, y + 0.28, y + 0.28])
    line(axes, [cup, end], [y, y])
    words(axes, start + 0.2 * (end - start), y + 0.08, name, "center", "bottom")


def mass(
    axes: Any,
    left: float,
    right: float,
    bottom: float = 0.2,
    top: float = 2.4,
    name: str = "$m$",
) -> None:
    """Draw the mass and the direction of positive displacement."""
    box(axes, left, bottom, right - left, top - bottom)
    words(axes, (left + right) / 2, (bottom + top) / 2, name, "center", "center")
    arrow(axes, (left, top + 0.3), (left + 1.0, top + 0.3), "$x$")


def gap(axes: Any, start: float, end: float, y: float, name: str = "$g$") -> None:
    """Draw the distance between two places."""
    axes.annotate("", (end, y), xytext=(start, y), arrowprops=ARROW | {"arrowstyle": "<|-|>"})
    words(axes, (start + end) / 2, y - 0.1, name, "center", "top")


#: A function that draws a part of a sketch, and its arguments.
Part = tuple[Any, ...]

#: A mass on spring and damper, which most oscillators have; driven from above; before a stop.
HUNG: list[Part] = [
    (wall, 0.4, 0.0, 2.6, -1),
    (spring, 0.4, 3.6, 1.9, "$k$"),
    (damper, 0.4, 3.6, 0.75, "$c$"),
    (mass, 3.6, 5.6),
]
DRIVEN_FROM_ABOVE: list[Part] = [*HUNG, (arrow, (3.2, 3.3), (4.4, 3.3), DRIVEN)]
BEFORE_A_STOP: list[Part] = [
    *DRIVEN_FROM_ABOVE, (wall, 7.2, 0.0, 2.6, 1), (gap, 5.6, 7.2, 0.6)
]  # fmt: skip

#: The normal force on a mass.
PRESSED: list[Part] = [(arrow, (5.3, 4.2), (5.3, 2.4), ""), (words, 5.45, 3.7, "$F_N$")]

#: A mass on a moving belt.
BELT_WALL: Part = (wall, 0.4, 0.0, 2.8, -1)
ON_A_BELT: list[Part] = [
    (mass, 3.6, 5.6, 0.2, 2.4, "$M$"),
    *((wheel, x, -0.65, 0.75) for x in (3.2, 8.2)),
    *((line, [3.2, 8.2], [y, y], 2) for y in (0.1, -1.4)),
    (arrow, (4.7, -0.75), (6.5, -0.75), "$V$"),
    *PRESSED,
]

#: The sketches by the names of their scenes.
SKETCHES: dict[str, list[Part]] = {
    "impact": [*BEFORE_A_STOP, (words, 7.9, 1.3, "$r$")],
    "impact-inelastic": [*BEFORE_A_STOP, (words, 7.9, 1.3, "$r = 0$")],
    "impact-two-sided": [
        (wall, 0.4, 0.9, 2.6, -1),
        (spring, 0.4, 3.6, 2.25, "$k$", 0.22),
        (damper, 0.4, 3.6, 1.2, "$c$"),
        (mass, 3.6, 5.6),
        (arrow, (3.2, 3.3), (4.4, 3.3), DRIVEN),
        (wall, 7.2, 0.0, 2.6, 1),
        (wall, 2.0, -0.4, 0.5, -1),
        (gap, 5.6, 7.2, 0.6),
        (gap, 2.0, 3.6, 0.25),
        (words, 7.9, 1.3, "$r$"),
    ],
    "clearance": [
        *DRIVEN_FROM_ABOVE,
        (line, [6.7, 6.7], [0.6, 2.0], 2),
        (spring, 6.7, 8.9, 1.3, "$k_c$"),
        (wall, 8.9, 0.0, 2.6, 1),
        (gap, 5.6, 6.7, 0.5),
    ],
    "backlash": [
        (mass, 3.9, 5.7),
        (arrow, (3.5, 3.3), (4.7, 3.3), DRIVEN),
        (line, [6.7, 6.7], [0.6, 2.0], 2),
        (spring, 6.7, 8.7, 1.4, "$k$"),
        (wall, 8.7, -0.6, 2.6, 1),
        (line, [2.9, 2.9], [0.6, 2.0], 2),
        (spring, 0.9, 2.9, 1.4, "$k$"),
        (wall, 0.9, -0.6, 2.6, -1),
        (damper, 0.9, 4.8, -0.3, "$c$"),
        (line, [4.8, 4.8], [-0.3, 0.2]),
        (gap, 5.7, 6.7, 0.5),
        (gap, 2.9, 3.9, 0.6),
    ],
    "dry-friction": [
        *HUNG,
        (box, 3.0, -0.1, 6.0, 0.3, HATCH),  # the ground that it slides on
        (arrow, (5.6, 1.3), (6.8, 1.3), DRIVEN),
        *PRESSED,
        (words, 6.2, 0.35, r"$\mu_s, \mu_k$", "left", "bottom"),
    ],
    "elastic-plastic": [
        (wall, 0.4, -0.4, 3.2, -1),
        (spring, 0.4, 2.3, 2.7, "$k$", 0.22),
        (line, [2.3, 2.7], [2.7, 2.7]),
        (box, 2.7, 2.5, 0.9, 0.4),
        (line, [2.4, 4.1], [2.45, 2.45]),
        (line, [3.6, 4.6], [2.7, 2.7]),
        (words, 3.15, 2.95, "$F_y$", "center", "bottom"),
        (spring, 0.4, 4.6, 1.45, "$h$", 0.22),
        (damper, 0.4, 4.6, 0.3, "$c$"),
        (mass, 4.6, 6.6, -0.1, 3.0),
        (arrow, (6.6, 1.3), (7.8, 1.3), DRIVEN),
    ],
    "stick-slip": [BELT_WALL, (spring, 0.4, 3.6, 1.4, "$K$"), *ON_A_BELT],
    "stick-slip-damped": [
        BELT_WALL,
        (spring, 0.4, 3.6, 1.9, "$K$"),
        (damper, 0.4, 3.6, 0.75, "$c$"),
        *ON_A_BELT,
    ],
}


def sketch(axes: Any, name: str) -> None:
    """Draw the sketch of the scene of this name; raise a `KeyError` if it has none."""
    for draw, *arguments in SKETCHES[name]:
        draw(axes, *arguments)
    axes.set(xlim=(-0.2, 10.2), ylim=(-1.8, 4.8), aspect="equal")
    axes.axis("off")
