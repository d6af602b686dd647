"""Fig. 1 in outline: the mass on the belt, and the law of friction."""

from typing import Any

import numpy as np
from matplotlib.patches import Circle, Rectangle

from .case import Case

INK = "0.2"
ARROW = {"arrowstyle": "-|>", "color": INK, "shrinkA": 0, "shrinkB": 0}


def _arrow(axes: Any, start: tuple[float, float], end: tuple[float, float], name: str) -> None:
    axes.annotate("", end, xytext=start, arrowprops=ARROW)
    axes.annotate(name, end, xytext=(4, 4), textcoords="offset points", ha="left", va="bottom")


def oscillator(axes: Any, case: Case) -> None:
    """Draw mass, spring, belt and normal force."""
    axes.set(xlim=(0, 10), ylim=(-1.8, 4.6), aspect="equal")
    axes.axis("off")
    axes.add_patch(Rectangle((0, 0), 0.3, 3, facecolor="0.75", edgecolor=INK))
    turns = np.linspace(1.0, 3.8, 15)
    heights = 1.2 + 0.4 * np.array([0, *[1, -1] * 6, 1, 0])
    axes.plot([0.3, *turns, 4.5], [1.2, *heights, 1.2], color=INK, linewidth=1.4)
    axes.add_patch(Rectangle((4.5, 0.2), 2.2, 2, facecolor="0.9", edgecolor=INK))
    axes.text(5.6, 1.2, "M", ha="center", va="center")
    axes.text(2.4, 1.9, "K", ha="center")
    for x in (2.2, 9.0):
        axes.add_patch(Circle((x, -0.65), 0.75, facecolor="none", edgecolor=INK))
    for y in (0.1, -1.4):
        axes.plot([2.2, 9.0], [y, y], color=INK, linewidth=2)
    _arrow(axes, (4.7, -0.65), (6.7, -0.65), "V")
    _arrow(axes, (5.6, 4.2), (5.6, 2.3), "")
    axes.text(5.8, 3.5, "$F_N$")
    _arrow(axes, (7.0, 1.3), (8.4, 1.3), "x")


def friction(axes: Any, case: Case) -> None:
    """Draw Coulomb's law: friction against the velocity relative to the belt."""
    belt = case.belt
    static, kinetic = belt.mu_s * belt.normal_force, belt.mu_k * belt.normal_force
    for sign in (1, -1):
        axes.plot([0, -sign * belt.belt_speed], [sign * kinetic] * 2, color=INK, linewidth=1.6)
    axes.plot([0, 0], [-static, static], color=INK, linewidth=1.6)
    for level, name in ((static, r"$\mu_s F_N$"), (kinetic, r"$\mu_k F_N$")):
        axes.plot([0, belt.belt_speed], [level] * 2, color="0.5", linewidth=0.8, linestyle="--")
        axes.annotate(
            name, (belt.belt_speed, level), xytext=(0, 3), textcoords="offset points",
            ha="right",
        )  # fmt: skip
    axes.margins(y=0.12)
    axes.locator_params(axis="x", nbins=5)
    axes.set(xlabel="velocity relative to the belt [m/s]", ylabel="friction [N]")
