"""How a motion shows itself in a notebook: a small table, and a phase portrait."""

from html import escape
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arrays import Vector
from ..case.names import shown
from ..stability.words import in_words

if TYPE_CHECKING:
    from .motion import SceneMotion
    from .orbit import SceneOrbit

#: The first and the last instant of a phase that are drawn, from its ends, as a part of it.
INSIDE = 1e-9

#: Instants of each phase that are drawn.
POINTS = 400


def instants(motion: "SceneMotion") -> Vector:
    """Return times over one period in s: both sides of every switch are among them."""
    ends = np.cumsum([0.0, *motion.durations])
    part = np.linspace(INSIDE, 1 - INSIDE, POINTS)
    return np.concatenate([low + (high - low) * part for low, high in pairwise(ends)])


def portrait(motion: "SceneMotion", axes: Any, **style: Any) -> Any:
    """Draw the phase portrait of a motion and return the axes.

    Parameters
    ----------
    motion : SceneMotion
        What is drawn.
    axes : matplotlib Axes or None
        Where; new ones if None.
    **style
        Of the line, as `matplotlib.axes.Axes.plot` takes it.
    """
    if axes is None:
        import matplotlib.pyplot as plt  # noqa: PLC0415  (an extra)

        axes = plt.subplots()[1]
    times = instants(motion)
    x, v = motion.displacement(times), motion.velocity(times)
    axes.plot(np.append(x, x[0]), np.append(v, v[0]), **style)
    axes.set(xlabel="displacement [m]", ylabel="velocity [m/s]")
    return axes


def table(orbit: "SceneOrbit") -> str:
    """Return an orbit as a small table in HTML."""
    scene, turn = orbit.case.scene, orbit.forcing_phase
    rows = {
        "scene": f"{scene.name}: {scene.title}",
        "parameters": orbit.case.description,
        "method": f"{shown(scene, orbit.method)}, N = {orbit.order}",
        "period": f"{orbit.period:.10g} s",
        "phases": ", ".join(f"{p.name} {p.duration:.8g} s" for p in orbit.phases),
        "phase of the forcing": "" if turn is None else f"{turn:.8g} rad",
        "stability": in_words(orbit),
        "estimated error of the times": f"{orbit.estimate.times:.1e}",
    }
    cells = (
        f"<tr><th>{escape(name)}</th><td>{escape(text)}</td></tr>"
        for name, text in rows.items()
        if text
    )
    return f"<table>{''.join(cells)}</table>"
