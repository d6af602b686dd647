"""A simulated motion as a table of its phases."""

from typing import TYPE_CHECKING

import click

from ...columns import print_table, table_of

if TYPE_CHECKING:
    from nonsmooth.solver.simulation.record import SimulatedPhase, Simulation

#: Phases of a long motion that are printed: the first, and the last.
FIRST, LAST = 8, 12


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
