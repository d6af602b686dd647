"""The paper's oscillator: its orbits against the exact one."""

from typing import TYPE_CHECKING

from matplotlib.figure import Figure

from nonsmooth.solver.shortcuts.orbit.motion import exact

from ...style import label
from ..orbits import motions_figure

if TYPE_CHECKING:
    from nonsmooth.solver.shortcuts.orbit.orbit import Orbit
    from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip


def orbit_figure(belt: "StickSlip", orbits: "list[Orbit]") -> Figure:
    """Draw phase plane, displacement, velocity and acceleration as in Figs. 2 and 5."""
    named = [(f"{label(q.method, q.c1_terms)}, N = {q.order}", q) for q in orbits]
    every = [("exact", exact(belt)), *named]
    return motions_figure(every, "limit cycle", caption(belt), 2)


def caption(belt: "StickSlip") -> str:
    """Return what stands below a figure of an oscillator."""
    return (
        rf"stick-slip oscillator, $\alpha = \omega_n (\mu_s - \mu_k) F_N / (K V)$ = "
        f"{belt.alpha:.4g}, $F_N$ = {belt.normal_force:g} N"
    )
