"""Pictures: the orbit against the exact one, and how the methods converge."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from nonsmooth.solver.shortcuts.orbit.motion import Motion, exact
from nonsmooth.style import (
    EXACT,
    LABELS,
    SETTINGS,
    STYLES,
    above_floor,
    draw_floor,
    label,
    line,
    save,
)

if TYPE_CHECKING:
    from nonsmooth.shortcuts.tradeoff import Point
    from nonsmooth.solver.shortcuts.orbit.orbit import Orbit
    from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip
    from nonsmooth.solver.shortcuts.search.sweep import Sweep

#: The series that is not the paper's, in the picture of time against error.
TAU_LABEL = {"c1-tau": "c1-tau: $C^1$ functions, other tests"}
TAU_STYLE: dict[str, dict[str, Any]] = {
    "c1-tau": {"color": "#CC79A7", "marker": "^", "linestyle": "-"}
}


def orbit_picture(belt: "StickSlip", orbits: "list[Orbit]", target: Path) -> None:
    """Write the figure of some orbits as a picture."""
    with mpl.rc_context(SETTINGS):
        save(orbit_figure(belt, orbits), target)


def orbit_figure(belt: "StickSlip", orbits: "list[Orbit]") -> Figure:
    """Draw phase plane, displacement, velocity and acceleration as in Figs. 2 and 5."""
    figure = Figure(figsize=(8, 6), layout="constrained")
    plane, *histories = figure.subplots(2, 2).ravel()
    reference = exact(belt)
    _draw_motion(plane, histories, reference, "exact", EXACT)
    for orbit in orbits:
        words = f"{label(orbit.method, orbit.c1_terms)}, N = {orbit.order}"
        _draw_motion(plane, histories, orbit, words, line(orbit.method))
    plane.set(xlabel="displacement [m]", ylabel="velocity [m/s]", title="limit cycle")
    names = ("displacement [m]", "velocity [m/s]", "acceleration [m/s²]")
    for axes, name in zip(histories, names, strict=True):
        axes.set(xlabel="t/T", ylabel=name)
    handles, labels = plane.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=2, frameon=False)
    figure.supxlabel(_caption(belt), fontsize=8)
    return figure


def _draw_motion(
    plane: Any, histories: list[Any], motion: Motion, words: str, style: dict[str, Any]
) -> None:
    part = np.linspace(0, 1, 2001)
    times = part * motion.period
    times[-1] = np.nextafter(motion.period, 0)
    x, v, a = motion.displacement(times), motion.velocity(times), motion.acceleration(times)
    plane.plot(x, v, label=words, **style)
    for axes, values in zip(histories, (x, v, a), strict=True):
        axes.plot(part, values, **style)


def convergence_picture(result: "Sweep", target: Path) -> None:
    """Write the figure of a sweep as a picture."""
    with mpl.rc_context(SETTINGS):
        save(convergence_figure(result), target)


def convergence_figure(result: "Sweep") -> Figure:
    """Draw period and acceleration error against the order, as in Figs. 4 and 6."""
    figure = Figure(figsize=(8, 4.2), layout="constrained")
    period, size, acceleration = figure.subplots(1, 3)
    reference = exact(result.belt).period
    for method in dict.fromkeys(row.method for row in result.rows):
        rows = [row for row in result.of(method) if row.errors and row.period]
        orders = [row.order for row in rows]
        errors = [row.errors for row in rows if row.errors]
        style = STYLES[method] | {
            "markersize": 4,
            "linewidth": 0.9,
            "label": label(method, result.c1_terms),
        }
        period.plot(orders, [(row.period or 0) / reference for row in rows], **style)
        size.semilogy(orders, [max(abs(e.period), 1e-16) for e in errors], **style)
        visible = [above_floor(e.acceleration) for e in errors]
        acceleration.semilogy(orders, visible, **style)
    period.axhline(1, **EXACT)
    draw_floor(acceleration)
    period.set(xlabel="order N", ylabel="T / T exact", title="period (Fig. 4)")
    size.set(xlabel="order N", ylabel="|T / T exact - 1|", title="period error")
    title = "acceleration error (Fig. 6)"
    acceleration.set(xlabel="order N", ylabel="error (22)", title=title)
    handles, labels = period.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=3, frameon=False)
    figure.supxlabel(_caption(result.belt), fontsize=8)
    return figure


def _caption(belt: "StickSlip") -> str:
    return (
        rf"stick-slip oscillator, $\alpha = \omega_n (\mu_s - \mu_k) F_N / (K V)$ = "
        f"{belt.alpha:.4g}, $F_N$ = {belt.normal_force:g} N"
    )


def _by_way(points: "list[Point]") -> "dict[tuple[str, str, int], list[Point]]":
    """Return the points of each regime, method and number of C1 functions."""
    found: dict[tuple[str, str, int], list[Point]] = {}
    for point in points:
        found.setdefault((point.regime, point.method, point.c1_terms), []).append(point)
    return found


def tradeoff_picture(points: "list[Point]", target: Path) -> None:
    """Write the figure of time against error as a picture."""
    with mpl.rc_context(SETTINGS):
        save(tradeoff_figure(points), target)


def tradeoff_figure(points: "list[Point]") -> Figure:
    """Draw error against time, each method a line, the front behind them."""
    figure = Figure(figsize=(7, 4.5), layout="constrained")
    axes = figure.subplots()
    front = sorted((p.seconds, p.error) for p in points if p.front)
    axes.step(
        *np.array(front).T, where="post", color="0.8", linewidth=5, label="the front",
        zorder=1,
    )  # fmt: skip
    for (regime, method, terms), chosen in _by_way(points).items():
        times, errors = [p.seconds for p in chosen], [p.error for p in chosen]
        words, look = (LABELS | TAU_LABEL)[method], (STYLES | TAU_STYLE)[method]
        if terms > 1:
            words = f"{method} with {terms} $C^1$ functions"
            look = look | {"fillstyle": "none", "linewidth": 0.8}
        if regime == "precise":
            words, look = "c1, many digits", {"color": "0.2", "marker": "*"}
        axes.plot(times, errors, label=words, markersize=5, zorder=2, **look)
        if terms > 1:
            where: Any = {"xytext": (4, -8), "textcoords": "offset points", "fontsize": 7}
            axes.annotate(f"K = {terms}", (times[-1], errors[-1]), **where)
    axes.set(xscale="log", yscale="log", xlabel="time of one orbit [s]")
    axes.set_ylabel("relative error of the period")
    axes.legend(frameon=False)
    return figure
