"""The figures of the paper, recomputed for one oscillator, and the map of the claims.

Each is narrow enough for a telephone; pictures that the paper puts side by side are separate.
"""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np
from matplotlib.figure import Figure

import nonsmooth as ns
from nonsmooth.kim_perkins import METHODS
from nonsmooth.plots.axes import EXACT, curve, draw_errors
from nonsmooth.plots.orbits import BEYOND
from nonsmooth.plots.orbits import draw as draw_motion
from nonsmooth.solver.scenes.methods import about

from .case import MOST, Case
from .checks import BAND, THREE
from .claims import VERDICTS, Claim
from .intervals import FIRST, LAST, Intervals, force, segments
from .measures import peak
from .pictures import legend
from .scenes.sketches import sketch
from .words import percent

#: Short names, for legends.
NAMES = {name: f"{name} ({section})" for name, (section, _) in METHODS.items()}

#: The look of each method, the same as in other scenes, with the paper's markers.  The colours
#: suit colour-blind readers (Okabe & Ito); in grey, markers and lines tell methods apart.
STYLES = {"hb": about("hb").look, "hb-c1": about("hb-ck").look, "c1": about("ck").look}

#: A jump misplaced by one rounding error of t/T contributes about its square root to (22).
FLOOR = float(np.sqrt(np.finfo(float).eps))

#: The last order in Fig. 4; beyond, the curves coincide.
LAST_ORDER = 12

#: Styles of lines, of labels of levels, and of arrows.
THIN: Any = {"color": "0.5", "linewidth": 0.8, "linestyle": "--"}
LEVEL: Any = THIN | {"linestyle": (0, (5, 5))}
BESIDE_LEVEL: Any = {"xycoords": ("axes fraction", "data"), "color": "0.4"}
POINTING: Any = {
    "textcoords": "axes fraction",
    "fontsize": 9,
    "arrowprops": {"arrowstyle": "->", "color": "0.3"},
}


def _beside(axes: Any, words: str, place: tuple[float, float], **style: Any) -> None:
    axes.annotate(words, place, textcoords="offset points", **style)


def friction(axes: Any, case: Case) -> None:
    """Draw Fig. 1(b), Coulomb's law: friction against the velocity relative to the belt."""
    belt, ink = case.belt, {"color": "0.2", "linewidth": 1.6}
    static, kinetic = belt.mu_s * belt.normal_force, belt.mu_k * belt.normal_force
    for sign in (1, -1):
        axes.plot([0, -sign * belt.belt_speed], [sign * kinetic] * 2, **ink)
    axes.plot([0, 0], [-static, static], **ink)
    for level, name in ((static, r"$\mu_s F_N$"), (kinetic, r"$\mu_k F_N$")):
        axes.plot([0, belt.belt_speed], [level] * 2, **THIN)
        _beside(axes, name, (belt.belt_speed, level), xytext=(0, 3), ha="right")
    axes.margins(y=0.12)
    axes.locator_params(axis="x", nbins=5)
    axes.set(xlabel="velocity relative to the belt [m/s]", ylabel="friction [N]")


def plane(axes: Any, case: Case) -> None:
    """Draw Fig. 2(a), the phase plane: stick begins at A and ends at B."""
    exact = case.exact
    draw_motion(exact, axes, linewidth=1.6)
    for name, time in (("A", 0.0), ("B", exact.t1)):
        place = float(exact.displacement(time)), float(exact.velocity(time))
        axes.plot(*place, "o", color="black", markersize=5)
        _beside(axes, name, place, xytext=(0, 6), ha="center")
    axes.set(xlabel="displacement x [m]", ylabel="velocity [m/s]")
    axes.margins(0.08, 0.12)


def history(quantity: str, axes: Any, case: Case) -> None:
    """Draw Fig. 2(b), (c) or (d): a quantity against time."""
    exact = case.exact
    if quantity == "displacement":
        centre = case.belt.slip_centre
        axes.axhline(centre, **THIN)
        _beside(axes, "$x_s$", (1, centre), xytext=(-3, 3), ha="right")
    draw_motion(exact, axes, quantity, linewidth=1.6)
    share = exact.t1 / exact.period
    axes.axvspan(0, share, color="0.9", zorder=0)
    axes.axvspan(1, min(1 + share, BEYOND), color="0.9", zorder=0)
    where = {"xycoords": ("data", "axes fraction"), "ha": "center", "fontsize": 9}
    axes.annotate("stick", (share / 2, 1.02), **where)
    axes.annotate("slip", ((1 + share) / 2, 1.02), **where)
    axes.set(xlim=(0, BEYOND))


def accelerations(methods: tuple[str, ...], order: int, axes: Any, case: Case) -> None:
    """Draw Fig. 3 or 5: the acceleration by some methods."""
    draw_motion(case.exact, axes, "acceleration", linewidth=1.6)
    for method in methods:
        look = curve(STYLES[method])
        if case.has(method, order):
            look["label"] = NAMES[method]
            draw_motion(case.orbit(method, order), axes, "acceleration", **look)
        else:
            axes.plot([], [], label=f"{NAMES[method]}: no orbit", **look)
    axes.set(xlim=(0, 1))
    legend(axes, 2)


many_harmonics = partial(accelerations, ("hb",), MOST)


def overshoot(axes: Any, case: Case) -> None:
    """Draw the end of stick in Fig. 3, with the overshoot and the value at its end marked."""
    many_harmonics(axes, case)
    end, width = case.exact.t1 / case.exact.period, 4 / MOST
    falls = case.belt.largest_jump
    left, right = max(0, end - width), min(1, end + width)
    axes.set(xlim=(left, right), ylim=(-1.9 * falls, 0.45 * falls))
    if not case.has("hb", MOST):
        return
    orbit = case.orbit("hb", MOST)
    time, size = peak(orbit)
    axes.axhline(size, **THIN)
    words = f"overshoot {percent(size / falls)} of the jump"
    top = time / orbit.period, size
    axes.annotate(words, top, xytext=(0.03, 0.93), va="center", **POINTING)
    at_end = orbit.t1 / orbit.period, float(orbit.acceleration(orbit.t1))
    axes.plot(*at_end, "o", color=STYLES["hb"]["color"], markersize=6)
    axes.annotate("where stick ends\nin the series", at_end, xytext=(0.03, 0.3), **POINTING)


def _marked(method: str) -> dict[str, Any]:
    return STYLES[method] | {"markersize": 4.5, "linewidth": 0.9, "label": NAMES[method]}


def period(axes: Any, case: Case) -> None:
    """Draw Fig. 4: the ratio of the period to the exact one, against the order."""
    axes.axhspan(1 - BAND, 1 + BAND, color="0.85", zorder=0)
    axes.axhline(1, **EXACT)
    reach = 2 * BAND
    for method in METHODS:
        orders = [N for N in case.orders(method) if N <= LAST_ORDER]
        errors = [case.measured("period", method, N) for N in orders]
        axes.plot(orders, [1 + error for error in errors], **_marked(method))
        if method != "c1":
            reach = max([reach, *(abs(error) for error in errors)])
    axes.set(
        xlabel="order $N$", ylabel="$T$ / $T$ exact", ylim=(1 - 1.2 * reach, 1 + 1.2 * reach)
    )
    axes.xaxis.get_major_locator().set_params(integer=True)
    axes.ticklabel_format(axis="y", useOffset=False)
    legend(axes, 3)


def _errors(axes: Any, case: Case, of: str, least: float = -np.inf) -> None:
    """Draw the errors of each method that are above `least`, against the order."""
    for method in METHODS:
        orders = case.orders(method)
        errors = np.array([case.measured(of, method, N) for N in orders])
        draw_errors(axes, orders, np.where(errors > least, errors, np.nan), **_marked(method))
    legend(axes, 3)


def period_error(axes: Any, case: Case) -> None:
    """Draw the errors of the periods of Fig. 4 on a log scale."""
    axes.axhline(BAND, **LEVEL)
    where = BESIDE_LEVEL | {"fontsize": 8, "ha": "right", "va": "top"}
    _beside(axes, "0.1 %", (0.99, BAND), xytext=(0, -3), **where)
    _errors(axes, case, "period")
    axes.set(ylabel="|$T$ / $T$ exact − 1|")


def acceleration_error(axes: Any, case: Case) -> None:
    """Draw Fig. 6: the error (22) of the acceleration against the order.

    The level by rounding of a time is marked; errors far below it are accidental, not drawn.
    """
    _errors(axes, case, "acceleration", FLOOR / 10)
    axes.set(ylabel="error (22) of the acceleration")
    axes.axhline(FLOOR, **LEVEL)
    where = BESIDE_LEVEL | {"fontsize": 7}
    _beside(axes, "floor in float64", (0.02, FLOOR), xytext=(0, 3), **where)


#: The functions that draw the figures, by the names of their files.
FIGURES: dict[str, Callable[[Any, Case], None]] = {
    "fig-1a": lambda axes, case: sketch(axes, "stick-slip"),
    "fig-1b": friction,
    "fig-2a": plane,
    "fig-2b": partial(history, "displacement"),
    "fig-2c": partial(history, "velocity"),
    "fig-2d": partial(history, "acceleration"),
    "fig-3": many_harmonics,
    "fig-3-detail": overshoot,
    "fig-4": period,
    "fig-4-errors": period_error,
    "fig-5": partial(accelerations, tuple(METHODS), THREE),
    "fig-6": acceleration_error,
}


#: Shades of the verdicts; they differ in grey as well.
SHADES = dict(zip(VERDICTS, ("#0072B2", "#A9CCE3", "none"), strict=True))

#: Width of the map of the claims and height of a row, in inches.
WIDTH, ROW = 4.8, 0.23


def claim_map(belt: ns.StickSlip, claims: Sequence[Claim], intervals: Intervals) -> Figure:
    """Return the map of the claims: one row each, over the normal force."""
    figure = Figure(figsize=(WIDTH, ROW * len(claims) + 1), layout="constrained")
    axes = figure.subplots()
    for row, claim in enumerate(claims):
        for low, high, verdict in segments(claim, intervals):
            left, right = force(belt, low), force(belt, high)
            look: Any = {"height": 0.7, "color": SHADES[verdict], "linewidth": 0}
            axes.barh(row, right - left, left=left, **look)
    axes.axvline(belt.normal_force, color="black", linewidth=1.2, linestyle="--")
    labels = [f"{claim.title}  {n}" for n, claim in enumerate(claims, 1)]
    axes.set_yticks(range(len(claims)), labels, fontsize=8.5)
    axes.set(xscale="log", xlabel="normal force $F_N$ [N]", ylim=(len(claims) - 0.4, -0.6))
    axes.set_xlim(force(belt, FIRST), force(belt, LAST))
    axes.grid(axis="y", visible=False)
    return figure
