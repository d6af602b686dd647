"""Pictures of a scene: its orbits against the exact one, and how its methods converge."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
from matplotlib.figure import Figure

from nonsmooth.solver.case.methods import about
from nonsmooth.solver.case.names import shown
from nonsmooth.solver.orbit.notebook import instants, portrait
from nonsmooth.solver.trade import EXACT as FLOW
from nonsmooth.style import EXACT, SETTINGS, save

from .captions import derivative

if TYPE_CHECKING:
    from nonsmooth.solver.case.case import Case
    from nonsmooth.solver.flow.exact import ExactSceneOrbit
    from nonsmooth.solver.orbit.motion import SceneMotion
    from nonsmooth.solver.orbit.orbit import SceneOrbit
    from nonsmooth.solver.sweep import SceneSweep
    from nonsmooth.solver.trade import Trade

#: Least error that is drawn.
LEAST = 1e-17


def orbit_picture(
    case: "Case", orbits: "list[SceneOrbit]", exact: "ExactSceneOrbit | None", target: Path
) -> None:
    """Write the figure of some orbits as a picture."""
    with mpl.rc_context(SETTINGS):
        save(orbit_figure(case, orbits, exact), target)


def orbit_figure(
    case: "Case", orbits: "list[SceneOrbit]", exact: "ExactSceneOrbit | None"
) -> Figure:
    """Draw phase plane, displacement, velocity and acceleration."""
    figure = Figure(figsize=(8, 6), layout="constrained")
    plane, *histories = figure.subplots(2, 2).ravel()
    if exact is not None:
        _draw(plane, histories, exact, "exact", EXACT)
    for orbit in orbits:
        words = f"{shown(case.scene, orbit.method)}, N = {orbit.order}"
        look = {name: about(orbit.method).look[name] for name in ("color", "linestyle")}
        _draw(plane, histories, orbit, words, look | {"linewidth": 1.4})
    plane.set(title="periodic orbit")
    names = ("displacement [m]", "velocity [m/s]", "acceleration [m/s²]")
    for axes, name in zip(histories, names, strict=True):
        axes.set(xlabel="t/T", ylabel=name)
    _label(figure, plane, case)
    return figure


def _label(figure: Figure, axes: Any, case: "Case") -> None:
    handles, labels = axes.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=3, frameon=False)
    figure.supxlabel(f"{case.scene.name}: {case.description}", fontsize=7, wrap=True)


def _draw(
    plane: Any, histories: list[Any], motion: "SceneMotion", words: str, style: dict[str, Any]
) -> None:
    portrait(motion, plane, label=words, **style)
    times = instants(motion)
    x, v, a = motion.displacement(times), motion.velocity(times), motion.acceleration(times)
    for axes, values in zip(histories, (x, v, a), strict=True):
        axes.plot(times / motion.period, values, **style)


def convergence_picture(result: "SceneSweep", target: Path) -> None:
    """Write the figure of a sweep as a picture."""
    with mpl.rc_context(SETTINGS):
        save(convergence_figure(result), target)


def convergence_figure(result: "SceneSweep") -> Figure:
    """Draw the errors of the times and of the derivative that jumps against the order."""
    scene = result.case.scene
    figure = Figure(figsize=(8, 4.2), layout="constrained")
    both = figure.subplots(1, 2)
    titles = {"times": "error of the times", "discontinuous": f"error of ${derivative(scene)}$"}
    for axes, (name, title) in zip(both, titles.items(), strict=True):
        for method in dict.fromkeys(row.method for row in result.rows):
            points = [
                (row.order, max(getattr(row.errors, name), LEAST))
                for row in result.of(method)
                if row.errors is not None
            ]
            look = about(method).look | {"markersize": 4, "linewidth": 0.9}
            orders, errors = zip(*points, strict=True) if points else ((), ())
            axes.semilogy(orders, errors, label=shown(scene, method), **look)
        axes.set(xlabel="order N", ylabel=title, title=title)
    _label(figure, both[0], result.case)
    return figure


def trade_picture(result: "Trade", target: Path) -> None:
    """Write the figure of time against error as a picture."""
    with mpl.rc_context(SETTINGS):
        save(trade_figure(result), target)


def trade_figure(result: "Trade") -> Figure:
    """Draw error against time, each method a line, the front behind them."""
    scene = result.case.scene
    figure = Figure(figsize=(7, 4.5), layout="constrained")
    axes = figure.subplots()
    best = sorted((p.seconds, p.error) for p in result.points if p.front)
    wide: dict[str, Any] = {"color": "0.8", "linewidth": 5, "zorder": 1}
    axes.step(*zip(*best, strict=True), where="post", label="the front", **wide)
    for method in dict.fromkeys(point.method for point in result.points):
        points = [(p.seconds, p.error) for p in result.points if p.method == method]
        look = {"color": "0.2", "marker": "*"} if method == FLOW else about(method).look
        words = "exact flow" if method == FLOW else shown(scene, method)
        times, errors = zip(*points, strict=True)
        axes.plot(times, errors, label=words, markersize=5, zorder=2, **look)
    axes.set(xscale="log", yscale="log", xlabel="time of one orbit [s]")
    axes.set_ylabel("error of the times, as a part of the period")
    _label(figure, axes, result.case)
    return figure
