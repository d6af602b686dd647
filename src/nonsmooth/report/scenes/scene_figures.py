"""The figures of the page on one oscillator, each narrow enough for a telephone."""

from collections.abc import Mapping
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np

from nonsmooth.plots.axes import EXACT, LEAST
from nonsmooth.plots.orbits import beyond, line
from nonsmooth.plots.orbits import draw as draw_motion
from nonsmooth.plots.sweeps import derivative as label_of
from nonsmooth.plots.sweeps import name_of_error
from nonsmooth.solver.arrays import Vector
from nonsmooth.solver.orbit.errors import derivative
from nonsmooth.solver.orbit.motion import Motion
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.methods import about

from ..pictures import ABOVE, Draw, legend
from .collected import Collected, Way, rate_of_jump, rate_of_times
from .sketches import SKETCHES, sketch

#: Number of points of a phase at which a derivative is drawn.
POINTS = 800


def plane(axes: Any, results: Collected) -> None:
    """Draw the phase plane: the exact orbit, and orbits of low order."""
    draw_motion(results.exact, axes, linewidth=1.6)
    for name, orbit in results.small.items():
        draw_motion(orbit, axes, label=f"{name}, N = {orbit.order}")
    for phase in results.exact.phases:
        axes.plot(phase.displacement, phase.velocity, "o", color="black", markersize=4)
    legend(axes, 2)


def history(axes: Any, results: Collected) -> None:
    """Draw displacement and velocity over a period, and the switches."""
    exact, beside = results.exact, axes.twinx()
    draw_motion(exact, axes, "displacement", label="displacement", color="0.2", linewidth=1.5)
    look = {"color": "#0072B2", "linestyle": "--", "linewidth": 1.5}
    draw_motion(exact, beside, "velocity", label="velocity", **look)
    switches = np.cumsum(exact.durations)[:-1] / exact.period
    for place in switches:
        axes.axvline(place, color="0.7", linewidth=0.8)
    beside.grid(visible=False)
    handles = [axes.get_lines()[0], beside.get_lines()[0]]
    axes.legend(handles, ["displacement", "velocity"], ncols=2, **ABOVE)


def _over_time(motion: Motion, order: int) -> tuple[Vector, Vector]:
    """Return ``t/T`` and a derivative in SI units over some more than a period.

    NaN separates the phases.
    """
    cell, scale = motion.case.cell, motion.case.units.of_motion(order)
    u = np.linspace(0.0, 1.0, POINTS)
    ends = np.cumsum([0.0, *motion.durations]) / motion.period
    times, values = [], []
    for index, (low, high) in enumerate(pairwise(ends)):
        p, turned = index % len(cell.phases), index >= len(cell.phases)
        sign = cell.sign if turned else 1
        times.append(np.append(low + (high - low) * u, np.nan))
        values.append(np.append(sign * scale * derivative(motion, p, u, order), np.nan))
    return beyond(np.concatenate(times), np.concatenate(values))


def jumping(axes: Any, results: Collected) -> None:
    """Draw the first derivative that jumps, by all methods: Fourier series overshoot there."""
    order = results.case.cell.k + 1
    axes.plot(*_over_time(results.exact, order), label="exact", **EXACT | {"linewidth": 1.6})
    for name, orbit in results.ringing.items():
        words = f"{name}, N = {orbit.order}"
        axes.plot(*_over_time(orbit, order), label=words, **line(orbit) | {"linewidth": 1})
    unit = "m/s" if order == 1 else f"m/s$^{order}$"
    axes.set(xlabel="$t/T$", ylabel=f"{label_of(order)} [{unit}]")
    legend(axes, 2)


def convergence(name: str, axes: Any, results: Collected) -> None:
    """Draw one error against the order, with the slopes of theory."""
    for way, curve in results.curves.items():
        orders = [*curve]
        errors = [max(getattr(each, name), LEAST) for each in curve.values()]
        axes.loglog(orders, errors, label=way.name, **_marked(way))
        if about(way.method).power and orders:
            rate = theory(results, way, name)
            slope = errors[0] * (np.array(orders) / orders[0]) ** -(rate or 0.0)
            if rate is not None and errors[0] > LEAST:
                axes.loglog(orders, slope, color="0.75", linewidth=3, zorder=0)
    quantity = name_of_error(results.case.scene, name)
    axes.set(xlabel="order $N$", ylabel=f"error of {quantity}")
    axes.set_xticks([4, 8, 16, 32], ["4", "8", "16", "32"])
    axes.minorticks_off()
    legend(axes, 3)


def theory(results: Collected, way: Way, name: str) -> float | None:
    """Return the power of 1/N with which an error of a series falls by theory; None if unknown.

    Of a structure it is known for the times only, and if not all switches are impacts: impulses
    alone leave no error.
    """
    functions, scene = way.functions or 0, results.case.scene
    if scene.has_body and (name != "times" or not any(scene.classes)):
        return None
    rate = rate_of_times if name == "times" else rate_of_jump
    return rate(results.case, functions)


def _marked(way: Way) -> dict[str, Any]:
    look: dict[str, Any] = about(way.method).look | {"markersize": 4, "linewidth": 0.9}
    if (way.functions or 0) > 1:
        look |= {"fillstyle": "none", "alpha": 1 - 0.25 * ((way.functions or 0) - 1)}
    return look


#: The functions that draw the figures, by the names of their files, and captions.
FIGURES: Mapping[str, tuple[Draw, str]] = {
    "sketch": (lambda axes, q: sketch(axes, q.case.scene.name), "the oscillator"),
    "plane": (plane, "the orbit in the phase plane"),
    "history": (history, "displacement and velocity over a period"),
    "jump": (jumping, "the first derivative that jumps"),
    "times": (partial(convergence, "times"), "error of the times against the order"),
    "discontinuous": (
        partial(convergence, "discontinuous"),
        "error of the derivative that jumps against the order",
    ),
}


def figures_of(case: Case) -> dict[str, Draw]:
    """Return the functions that draw the figures of a case; the sketch only if there is one."""
    drawn = case.scene.name in SKETCHES
    return {name: draw for name, (draw, _) in FIGURES.items() if drawn or name != "sketch"}
