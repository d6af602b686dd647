"""Tables of the orbits of a scene, at most 80 columns wide where the numbers allow."""

import math
import textwrap
from collections.abc import Mapping
from typing import TYPE_CHECKING

import click

from nonsmooth.solver.case.names import shown
from nonsmooth.solver.orbit.orbit import SceneOrbit

from ...shortcuts.tables import MORE_DIGITS, _print, _table, certain_digits
from .captions import WIDTH, derivative

if TYPE_CHECKING:
    from nonsmooth.solver.case.case import Case
    from nonsmooth.solver.flow.exact import ExactSceneOrbit
    from nonsmooth.solver.no_orbit import NoOrbit
    from nonsmooth.solver.orbit.motion import SceneMotion
    from nonsmooth.solver.sweep import SceneSweep

Found = Mapping[str, "SceneOrbit | NoOrbit"]


def solutions(case: "Case", exact: "ExactSceneOrbit | None", found: Found) -> None:
    """Print the orbit by each method, below the exact one."""
    scene = case.scene
    phases = scene.phases if len(scene.phases) > 1 and not scene.motions else ()
    table = _table(
        "method", "N", "T [s]", *(["phi [rad]"] if scene.frequency else []),
        *(f"{phase} [s]" for phase in phases),
        "times", derivative(scene), "estimate", "it",
    )  # fmt: skip
    table.add_row("exact", "", *(["none found"] if exact is None else _times(exact)))
    for method, orbit in found.items():
        if not isinstance(orbit, SceneOrbit):
            table.add_row(shown(scene, method), "", orbit.status)
            continue
        errors = orbit.errors
        table.add_row(
            name_of(orbit),
            str(orbit.order),
            *_times(orbit),
            *(("", "") if errors is None else _errors(errors.times, errors.discontinuous)),
            f"{orbit.estimate.times:.1e}",
            str(orbit.iterations),
        )
    _print(table)
    for orbit in found.values():
        if isinstance(orbit, SceneOrbit) and orbit.estimate.times < MORE_DIGITS:
            words = f"{name_of(orbit)}, N = {orbit.order}: {_in_full(orbit)}"
            click.echo(textwrap.fill(words, WIDTH, subsequent_indent="  "))


def name_of(orbit: SceneOrbit) -> str:
    """Return a method as tables show it, with its functions where they are not the default."""
    name = shown(orbit.case.scene, orbit.method)
    default = {None, 2 if orbit.case.scene.k == 0 else 1}
    return name if orbit.functions in default else f"{name}({orbit.functions})"


def _times(motion: "SceneMotion") -> list[str]:
    """Return period, phase of the forcing and, of several phases, the durations of a cell."""
    count = len(motion.case.cell.phases)
    turn = motion.forcing_phase
    return [
        f"{motion.period:.9g}",
        *([] if turn is None else [f"{turn:.7g}"]),
        *(f"{s:.7g}" for s in motion.durations[:count] if count > 1),
    ]


def _errors(*errors: float) -> tuple[str, ...]:
    return tuple(f"{error:.2e}" for error in errors)


def _in_full(orbit: SceneOrbit) -> str:
    """Return the times of an orbit by the digits that its estimated errors leave."""
    part, turn = orbit.estimate.times, orbit.forcing_phase
    words = [f"T = {certain_digits(orbit.period, abs(orbit.estimate.period))} s"]
    if turn is not None:
        off = 2 * math.pi * part * (orbit.period / _forcing_period(orbit.case))
        words.append(f"phi = {certain_digits(turn, off / turn if turn else 1.0)} rad")
    names = orbit.case.scene.phases
    if len(names) > 1:
        for name, s in zip(names, orbit.durations, strict=False):
            words.append(f"{name} = {certain_digits(s, part * orbit.period / s)} s")
    return ", ".join(words)


def _forcing_period(case: "Case") -> float:
    return 2 * math.pi / float(case.values[str(case.scene.frequency)])


def convergence(result: "SceneSweep") -> None:
    """Print one row a method and order, and how fast each method converges."""
    scene = result.case.scene
    forced = scene.frequency is not None
    table = _table(
        "method", "N", "T [s]", *(["phi [rad]"] if forced else []),
        "times", derivative(scene), "estimate", "it",
    )  # fmt: skip
    for row in result.rows:
        head = (shown(scene, row.method), str(row.order))
        if row.estimate is None:
            table.add_row(*head, row.status, *[""] * (3 + forced), str(row.iterations))
            continue
        errors = row.errors
        table.add_row(
            *head,
            f"{row.period:.9g}",
            *([f"{row.forcing_phase:.7g}"] if forced else []),
            *(("", "") if errors is None else _errors(errors.times, errors.discontinuous)),
            f"{row.estimate.times:.1e}",
            str(row.iterations),
        )
    _print(table)
    click.echo("\nConvergence, fitted to the logarithms of all errors above rounding:\n")
    rates = _table("method", "times", derivative(scene))
    for method, rate in result.rates().items():
        rates.add_row(shown(scene, method), rate.text("times"), rate.text("discontinuous"))
    _print(rates)
    click.echo()
