"""The figures of the paper, recomputed for one oscillator.

Each is narrow enough for a telephone; what stands beside another in the paper is a figure
of its own here.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from nonsmooth.plots.axes import LEAST
from nonsmooth.plots.orbits import draw as draw_motion
from nonsmooth.solver.shortcuts.orbit.motion import ExactOrbit, exact
from nonsmooth.style import EXACT, SETTINGS, STYLES, above_floor, draw_floor, line

from .case import MOST, Case
from .checks.fourier import BAND
from .sketch import friction, oscillator
from .words import percent

#: Inches, and the text in points: on a telephone both are shown at two thirds.
SIZE = (4.8, 3.2)
LOOK: Any = SETTINGS | {"font.size": 10, "legend.fontsize": 9}

#: Short names, for legends.
NAMES = {"hb": "hb (3.1)", "hb-c1": "hb-c1 (3.2)", "c1": "c1 (3.3)"}

#: Order of Fig. 5, and the last one in Fig. 4, where the curves can still be told apart.
SMALL, LAST = 3, 12

#: Periods of Fig. 2(b) to (d): past the first, so that both ends of slip are inside.
PERIODS = 1.2


def figure(draw: Callable[[Any, Case], None], case: Case) -> Figure:
    """Return a figure with one pair of axes, drawn."""
    made = Figure(figsize=SIZE, layout="constrained")
    draw(made.subplots(), case)
    return made


def _legend(axes: Any, columns: int) -> None:
    axes.legend(
        loc="lower center",
        bbox_to_anchor=(0.5, 1.0),
        ncols=columns,
        frameon=False,
        columnspacing=1.2,
    )


def _ends(motion: ExactOrbit) -> tuple[Any, Any]:
    """Return displacement and velocity in A, where stick begins, and B, where it ends."""
    times = [0.0, motion.t1]
    return motion.displacement(times), motion.velocity(times)


def plane(axes: Any, case: Case) -> None:
    """Draw Fig. 2(a): the limit cycle in the phase plane."""
    motion = exact(case.belt)
    draw_motion(motion, axes, linewidth=1.6)
    for name, x, v in zip("AB", *_ends(motion), strict=True):
        axes.plot(x, v, "o", color="black", markersize=5)
        axes.annotate(name, (x, v), xytext=(0, 6), textcoords="offset points", ha="center")
    axes.set(xlabel="displacement x [m]", ylabel="velocity [m/s]")
    axes.margins(0.08, 0.12)


def history(derivative: int) -> Callable[[Any, Case], None]:
    """Return what draws Fig. 2(b), (c) or (d): displacement, velocity or acceleration."""
    name = ("displacement", "velocity", "acceleration")[derivative]

    def draw(axes: Any, case: Case) -> None:
        motion = exact(case.belt)
        if derivative == 0:
            centre = case.belt.slip_centre
            axes.axhline(centre, color="0.5", linewidth=0.8, linestyle="--")
            axes.annotate(
                "$x_s$",
                (1, centre),
                xytext=(-3, 3),
                textcoords="offset points",
                ha="right",
            )
        draw_motion(motion, axes, name, linewidth=1.6)
        _go_on(axes.lines[-1])
        share = motion.t1 / motion.period
        axes.axvspan(0, share, color="0.9", zorder=0)
        axes.axvspan(1, min(1 + share, PERIODS), color="0.9", zorder=0)
        where = {"xycoords": ("data", "axes fraction"), "ha": "center", "fontsize": 9}
        axes.annotate("stick", (share / 2, 1.02), **where)
        axes.annotate("slip", ((1 + share) / 2, 1.02), **where)
        axes.set(xlim=(0, PERIODS))

    return draw


def _go_on(curve: Any) -> None:
    """Draw a curve over one period, in periods, on to `PERIODS`."""
    part, values = curve.get_data()
    again = part <= PERIODS - 1
    curve.set_data(np.append(part, 1 + part[again]), np.append(values, values[again]))


def _accelerations(axes: Any, case: Case, methods: tuple[str, ...], order: int) -> None:
    motion = exact(case.belt)
    draw_motion(motion, axes, "acceleration", linewidth=1.6)
    for method in methods:
        if not case.has(method, order):
            axes.plot([], [], label=f"{NAMES[method]}: no orbit", **line(method))
            continue
        orbit = case.orbit(method, order)
        draw_motion(orbit, axes, "acceleration", label=NAMES[method])
    axes.set(xlim=(0, 1))


def many_harmonics(axes: Any, case: Case) -> None:
    """Draw Fig. 3: the acceleration of classical harmonic balance with N = 40."""
    _accelerations(axes, case, ("hb",), MOST)
    _legend(axes, 2)


def overshoot(axes: Any, case: Case) -> None:
    """Draw the end of stick in Fig. 3, with the ripple measured and the mean marked."""
    _accelerations(axes, case, ("hb",), MOST)
    _legend(axes, 2)
    motion, jump = exact(case.belt), case.alpha * case.belt.acceleration_unit
    end = motion.t1 / motion.period
    width = 4 / MOST
    axes.set(xlim=(max(0, end - width), min(1, end + width)), ylim=(-1.9 * jump, 0.45 * jump))
    if not case.has("hb", MOST):
        return
    orbit = case.orbit("hb", MOST)
    time, size = case.peak("hb", MOST)
    axes.axhline(size, color="0.5", linewidth=0.8, linestyle="--")
    words = f"overshoot {percent(size / jump)} of the jump"
    axes.annotate(
        words, (time / orbit.period, size), xytext=(0.03, 0.93), textcoords="axes fraction",
        fontsize=9, va="center", arrowprops={"arrowstyle": "->", "color": "0.3"},
    )  # fmt: skip
    own = orbit.t1 / orbit.period
    level = float(orbit.acceleration(orbit.t1))
    axes.plot(own, level, "o", color=STYLES["hb"]["color"], markersize=6)
    axes.annotate(
        "where stick ends\nin the series", (own, level), xytext=(0.03, 0.3),
        textcoords="axes fraction", fontsize=9, arrowprops={"arrowstyle": "->", "color": "0.3"},
    )  # fmt: skip


def _against_order(
    axes: Any, case: Case, measure: Callable[[str, int], float], most: int
) -> None:
    for method, style in STYLES.items():
        orders = [N for N in case.orders(method) if most >= N]
        values = [measure(method, N) for N in orders]
        look = style | {"markersize": 4.5, "linewidth": 0.9}
        axes.plot(orders, values, label=NAMES[method], **look)
    axes.set(xlabel="order N")
    axes.xaxis.get_major_locator().set_params(integer=True)


def period(axes: Any, case: Case) -> None:
    """Draw Fig. 4: the period against the order, in exact periods."""
    axes.axhspan(1 - BAND, 1 + BAND, color="0.85", zorder=0)
    axes.axhline(1, **EXACT)
    _against_order(axes, case, lambda method, N: 1 + case.period_error(method, N), LAST)
    errors = [
        abs(case.period_error(method, N))
        for method in ("hb", "hb-c1")
        for N in case.orders(method)
        if N <= LAST
    ]
    reach = 1.2 * max([2 * BAND, *errors])
    axes.set(ylabel="T / T exact", ylim=(1 - reach, 1 + reach))
    axes.ticklabel_format(axis="y", useOffset=False)
    _legend(axes, 3)


def period_error(axes: Any, case: Case) -> None:
    """Draw the errors of Fig. 4 on a log scale, where they do not end in one line."""
    axes.axhline(BAND, color="0.5", linewidth=0.8, linestyle=(0, (5, 5)))
    axes.annotate(
        "0.1 %", (0.99, BAND), xycoords=("axes fraction", "data"), xytext=(0, -3),
        textcoords="offset points", fontsize=8, color="0.4", ha="right", va="top",
    )  # fmt: skip
    _against_order(
        axes, case, lambda method, N: max(abs(case.period_error(method, N)), LEAST), MOST
    )
    axes.set(yscale="log", ylabel="|T / T exact − 1|")
    _legend(axes, 3)


def three_methods(axes: Any, case: Case) -> None:
    """Draw Fig. 5: the acceleration at N = 3 by the three methods."""
    _accelerations(axes, case, tuple(STYLES), SMALL)
    _legend(axes, 2)


def acceleration_error(axes: Any, case: Case) -> None:
    """Draw Fig. 6: the error (22) of the acceleration against the order."""
    _against_order(
        axes, case, lambda method, N: above_floor(case.acceleration_error(method, N)), MOST
    )
    axes.set(yscale="log", ylabel="error (22) of the acceleration")
    draw_floor(axes)
    _legend(axes, 3)


#: What draws each figure, by the name of its file.
FIGURES: dict[str, Callable[[Any, Case], None]] = {
    "fig-1a": oscillator,
    "fig-1b": friction,
    "fig-2a": plane,
    "fig-2b": history(0),
    "fig-2c": history(1),
    "fig-2d": history(2),
    "fig-3": many_harmonics,
    "fig-3-detail": overshoot,
    "fig-4": period,
    "fig-4-errors": period_error,
    "fig-5": three_methods,
    "fig-6": acceleration_error,
}
