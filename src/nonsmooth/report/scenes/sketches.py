"""A drawing of each shipped oscillator: mass, spring, damper, and what breaks the motion."""

from collections.abc import Callable
from typing import Any

import numpy as np
from matplotlib.patches import Circle, Rectangle

INK, FILL, HATCH = "0.2", "0.92", "0.75"
ARROW = {"arrowstyle": "-|>", "color": INK, "shrinkA": 0, "shrinkB": 0}

Drawing = Callable[[Any], None]


def _arrow(axes: Any, start: tuple[float, float], end: tuple[float, float], name: str) -> None:
    axes.annotate("", end, xytext=start, arrowprops=ARROW)
    axes.annotate(name, end, xytext=(4, 2), textcoords="offset points", va="bottom")


def wall(axes: Any, x: float, bottom: float, top: float, side: int) -> None:
    """Draw a wall whose face is at `x`; `side` is where its body lies."""
    corner = (x if side > 0 else x - 0.35, bottom)
    axes.add_patch(Rectangle(corner, 0.35, top - bottom, facecolor=HATCH, edgecolor=INK))


def spring(
    axes: Any, start: float, end: float, y: float, name: str, height: float = 0.3
) -> None:
    """Draw a spring between two places."""
    lead = 0.12 * (end - start)
    turns = np.linspace(start + lead, end - lead, 15)
    heights = y + height * np.array([0, *[1, -1] * 6, 1, 0])
    axes.plot([start, *turns, end], [y, *heights, y], color=INK, linewidth=1.3)
    axes.text((start + end) / 2, y + height + 0.12, name, ha="center", va="bottom")


def damper(axes: Any, start: float, end: float, y: float, name: str) -> None:
    """Draw a dashpot between two places."""
    middle, line = (start + end) / 2, {"color": INK, "linewidth": 1.3}
    cup = middle + 0.35
    axes.plot([start, middle], [y, y], **line)
    axes.plot([middle, middle], [y - 0.18, y + 0.18], **line)
    axes.plot(
        [middle - 0.3, cup, cup, middle - 0.3], [y - 0.28, y - 0.28, y + 0.28, y + 0.28], **line
    )
    axes.plot([cup, end], [y, y], **line)
    axes.text(start + 0.2 * (end - start), y + 0.08, name, ha="center", va="bottom")


def mass(
    axes: Any,
    left: float,
    right: float,
    bottom: float = 0.2,
    top: float = 2.4,
    name: str = "$m$",
) -> None:
    """Draw the mass and the direction in which its displacement is counted."""
    axes.add_patch(
        Rectangle((left, bottom), right - left, top - bottom, facecolor=FILL, edgecolor=INK)
    )
    axes.text((left + right) / 2, (bottom + top) / 2, name, ha="center", va="center")
    _arrow(axes, (left, top + 0.3), (left + 1.0, top + 0.3), "$x$")


def force(axes: Any, x: float, y: float = 1.3) -> None:
    """Draw the force that drives the mass."""
    _arrow(axes, (x, y), (x + 1.2, y), r"$F \cos(\Omega t + \varphi)$")


def pressed(axes: Any, x: float, top: float = 2.4) -> None:
    """Draw the normal force on the mass."""
    _arrow(axes, (x, top + 1.8), (x, top), "")
    axes.text(x + 0.15, top + 1.3, "$F_N$")


def gap(axes: Any, start: float, end: float, y: float, name: str = "$g$") -> None:
    """Draw the distance between two places."""
    axes.annotate("", (end, y), xytext=(start, y), arrowprops=ARROW | {"arrowstyle": "<|-|>"})
    axes.text((start + end) / 2, y - 0.1, name, ha="center", va="top")


def ground(axes: Any, start: float, end: float, y: float = 0.0) -> None:
    """Draw the ground that a mass slides on."""
    axes.add_patch(
        Rectangle((start, y - 0.3), end - start, 0.3, facecolor=HATCH, edgecolor=INK)
    )


def _hung(axes: Any) -> None:
    """Draw what most oscillators share: a mass on spring and damper."""
    wall(axes, 0.4, 0.0, 2.6, -1)
    spring(axes, 0.4, 3.6, 1.9, "$k$")
    damper(axes, 0.4, 3.6, 0.75, "$c$")
    mass(axes, 3.6, 5.6)


def impact(axes: Any) -> None:
    """Draw a mass before a stop."""
    _hung(axes)
    _arrow(axes, (3.2, 3.3), (4.4, 3.3), r"$F \cos(\Omega t + \varphi)$")
    wall(axes, 7.2, 0.0, 2.6, 1)
    gap(axes, 5.6, 7.2, 0.6)
    axes.text(7.9, 1.3, "$r$")


def impact_inelastic(axes: Any) -> None:
    """Draw a mass before a stop that takes its speed."""
    _hung(axes)
    _arrow(axes, (3.2, 3.3), (4.4, 3.3), r"$F \cos(\Omega t + \varphi)$")
    wall(axes, 7.2, 0.0, 2.6, 1)
    gap(axes, 5.6, 7.2, 0.6)
    axes.text(7.9, 1.3, "$r = 0$")


def impact_two_sided(axes: Any) -> None:
    """Draw a mass between two stops."""
    wall(axes, 0.4, 0.9, 2.6, -1)
    spring(axes, 0.4, 3.6, 2.1, "$k$", 0.22)
    damper(axes, 0.4, 3.6, 1.3, "$c$")
    mass(axes, 3.6, 5.6)
    _arrow(axes, (3.2, 3.3), (4.4, 3.3), r"$F \cos(\Omega t + \varphi)$")
    wall(axes, 7.2, 0.0, 2.6, 1)
    wall(axes, 2.0, -0.4, 0.5, -1)
    gap(axes, 5.6, 7.2, 0.6)
    gap(axes, 2.0, 3.6, 0.25)
    axes.text(7.9, 1.3, "$r$")


def clearance(axes: Any) -> None:
    """Draw a mass before a spring that it does not touch at rest."""
    _hung(axes)
    _arrow(axes, (3.2, 3.3), (4.4, 3.3), r"$F \cos(\Omega t + \varphi)$")
    axes.plot([6.7, 6.7], [0.6, 2.0], color=INK, linewidth=2)
    spring(axes, 6.7, 8.9, 1.3, "$k_c$")
    wall(axes, 8.9, 0.0, 2.6, 1)
    gap(axes, 5.6, 6.7, 0.5)


def backlash(axes: Any) -> None:
    """Draw a mass that plays between two springs."""
    mass(axes, 3.9, 5.7)
    _arrow(axes, (3.5, 3.3), (4.7, 3.3), r"$F \cos(\Omega t + \varphi)$")
    for face, end, wall_at, side in ((6.7, 8.7, 8.7, 1), (2.9, 0.9, 0.9, -1)):
        axes.plot([face, face], [0.6, 2.0], color=INK, linewidth=2)
        spring(axes, min(face, end), max(face, end), 1.4, "$k$")
        wall(axes, wall_at, -0.6, 2.6, side)
    damper(axes, 0.9, 4.8, -0.3, "$c$")
    axes.plot([4.8, 4.8], [-0.3, 0.2], color=INK, linewidth=1.3)
    gap(axes, 5.7, 6.7, 0.5)
    gap(axes, 2.9, 3.9, 0.6)


def dry_friction(axes: Any) -> None:
    """Draw a driven mass on a rough ground."""
    _hung(axes)
    ground(axes, 3.0, 9.0, 0.2)
    force(axes, 5.6)
    pressed(axes, 5.3)
    axes.text(6.2, 0.35, r"$\mu_s, \mu_k$", va="bottom")


def elastic_plastic(axes: Any) -> None:
    """Draw a mass on a spring in series with a slider, a spring and a damper beside them."""
    wall(axes, 0.4, -0.4, 3.2, -1)
    spring(axes, 0.4, 2.3, 2.7, "$k$", 0.22)
    axes.plot([2.3, 2.7], [2.7, 2.7], color=INK, linewidth=1.3)
    axes.add_patch(Rectangle((2.7, 2.5), 0.9, 0.4, facecolor=FILL, edgecolor=INK))
    axes.plot([2.4, 4.1], [2.45, 2.45], color=INK, linewidth=1.3)
    axes.plot([3.6, 4.6], [2.7, 2.7], color=INK, linewidth=1.3)
    axes.text(3.15, 2.95, "$f_y$", ha="center", va="bottom")
    spring(axes, 0.4, 4.6, 1.45, "$h$", 0.22)
    damper(axes, 0.4, 4.6, 0.3, "$c$")
    mass(axes, 4.6, 6.6, -0.1, 3.0)
    force(axes, 6.6)


def belt(axes: Any) -> None:
    """Draw a mass on a moving belt."""
    wall(axes, 0.4, 0.0, 2.8, -1)
    spring(axes, 0.4, 3.6, 1.4, "$K$")
    _on_a_belt(axes)


def damped_belt(axes: Any) -> None:
    """Draw a damped mass on a moving belt."""
    wall(axes, 0.4, 0.0, 2.8, -1)
    spring(axes, 0.4, 3.6, 1.9, "$K$")
    damper(axes, 0.4, 3.6, 0.75, "$c$")
    _on_a_belt(axes)


def _on_a_belt(axes: Any) -> None:
    mass(axes, 3.6, 5.6, name="$M$")
    for x in (3.2, 8.2):
        axes.add_patch(Circle((x, -0.65), 0.75, facecolor="none", edgecolor=INK))
    for y in (0.1, -1.4):
        axes.plot([3.2, 8.2], [y, y], color=INK, linewidth=2)
    _arrow(axes, (4.7, -0.75), (6.5, -0.75), "$V$")
    pressed(axes, 5.3)


#: By the name of the scene.
SKETCHES: dict[str, Drawing] = {
    "impact": impact,
    "impact-inelastic": impact_inelastic,
    "impact-two-sided": impact_two_sided,
    "clearance": clearance,
    "backlash": backlash,
    "dry-friction": dry_friction,
    "elastic-plastic": elastic_plastic,
    "stick-slip": belt,
    "stick-slip-damped": damped_belt,
}


def sketch(axes: Any, name: str) -> None:
    """Draw the oscillator of this name.

    Raises
    ------
    KeyError
        If there is no drawing of it.
    """
    SKETCHES[name](axes)
    axes.set(xlim=(-0.2, 10.2), ylim=(-1.8, 4.8), aspect="equal")
    axes.axis("off")
