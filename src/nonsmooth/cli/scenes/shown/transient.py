"""A simulated motion as a table of its phases, and as a picture."""

from pathlib import Path
from typing import TYPE_CHECKING

import click
import numpy as np

from ...columns import print_table, table_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from nonsmooth.solver.simulation.record import SimulatedPhase, Simulation

#: Phases of a long motion that are printed: the first, and the last.
FIRST, LAST = 8, 12

#: Part of the time, at the end, that is drawn over the rest in the phase plane.
LATE = 0.2


def table(motion: "Simulation") -> None:
    """Print the phases of a motion: the first and the last where there are many."""
    found = table_of("phase", "t [s]", "lasts [s]", "x [m]", "x' [m/s]")
    phases = motion.phases
    few = len(phases) <= FIRST + LAST
    for phase in phases if few else phases[:FIRST]:
        found.add_row(*_cells(phase))
    if not few:
        found.add_row("...", "", "", "", "")
        for phase in phases[-LAST:]:
            found.add_row(*_cells(phase))
    print_table(found)
    words = "phase" if len(phases) == 1 else "phases"
    mirrored = any(phase.mirrored for phase in phases)
    click.echo(
        f"\n{len(phases)} {words} in {motion.time:.6g} s; t, x and x' where each begins."
    )
    if mirrored:
        click.echo("-: the mirror image of the phase.")


def _cells(phase: "SimulatedPhase") -> tuple[str, ...]:
    name = f"-{phase.name}" if phase.mirrored else phase.name
    numbers = (phase.start, phase.duration, phase.displacement, phase.velocity)
    return name, *(f"{number + 0.0:.7g}" for number in numbers)


def picture(motion: "Simulation", target: Path) -> None:
    """Write the figure of a motion as a picture."""
    import matplotlib as mpl  # noqa: PLC0415  (a table needs none)

    from nonsmooth.style import SETTINGS, save  # noqa: PLC0415

    with mpl.rc_context(SETTINGS):
        save(figure(motion), target)


def figure(motion: "Simulation") -> "Figure":
    """Draw displacement and velocity against time, and the phase plane with its late part."""
    from matplotlib.figure import Figure  # noqa: PLC0415

    from nonsmooth.style import STYLES  # noqa: PLC0415

    drawn = Figure(figsize=(9, 4.8), layout="constrained")
    panels = drawn.subplot_mosaic([["x", "plane"], ["v", "plane"]], width_ratios=(1.6, 1))
    times, x, v, _ = map(np.concatenate, zip(*motion.samples(), strict=True))
    for name, values, label in (("x", x, "displacement [m]"), ("v", v, "velocity [m/s]")):
        panels[name].plot(times, values, color="0.25", linewidth=0.8)
        panels[name].set(ylabel=label)
    panels["v"].set(xlabel="t [s]")
    late = times >= (1 - LATE) * motion.time
    plane, colour = panels["plane"], STYLES["hb"]["color"]
    plane.plot(x, v, color="0.7", linewidth=0.6, label="from the start")
    words = f"the last {LATE:.0%} of the time"
    plane.plot(x[late], v[late], color=colour, linewidth=1.4, label=words)
    plane.set(xlabel="displacement [m]", ylabel="velocity [m/s]")
    plane.legend(loc="lower left", bbox_to_anchor=(0, 1.0), frameon=False, fontsize=8)
    case = motion.case
    drawn.supxlabel(f"{case.scene.name}: {case.description}", fontsize=7, wrap=True)
    return drawn
