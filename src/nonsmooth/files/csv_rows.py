"""CSV, for other programs: rows of results and of studies, motions over time."""

import csv
from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nonsmooth.solver.scenes.methods import shown

if TYPE_CHECKING:
    from nonsmooth.solver.results.family import Family
    from nonsmooth.solver.results.orbit import Orbit
    from nonsmooth.solver.results.sweep import Sweep
    from nonsmooth.solver.simulation.record import Simulation
    from nonsmooth.solver.space.modes import Modes

#: Columns of a motion; behind them, of each row of modes, stand the parameters.
MOTION = ("t", "displacement", "velocity", "acceleration")
MODES = (
    "method", "order", "forced", "unknowns", "number", "frequency", "omega", "beta",
    "eigenvalue", "exact_beta", "exact_frequency", "error", "low", "high", "modal_mass",
    "jump_mismatch", "node", "structure", "position", "strength",
)  # fmt: skip


def write(target: Path, rows: Iterable[Mapping[str, Any]]) -> None:
    """Write rows of the same columns below a line with their names."""
    iterator = iter(rows)
    first = next(iterator, {})
    with target.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(first)
        writer.writerows(row.values() for row in chain([first] if first else (), iterator))


def of_orbits(orbits: "Sequence[Orbit]") -> list[dict[str, Any]]:
    """Return the motion of each orbit over a period: s, m, m/s, m/s**2."""
    return [
        {"method": shown(orbit.case.scene, orbit.method)} | {name: row[name] for name in MOTION}
        for orbit in orbits
        for row in orbit.table().rows()
    ]


def of_simulation(motion: "Simulation") -> list[dict[str, Any]]:
    """Return a simulated motion, each phase from its start to its end."""
    names = ("t", *motion.quantities)
    return [
        {"phase": phase.name} | dict(zip(names, row, strict=True))
        for phase, samples in zip(motion.phases, motion.samples(), strict=True)
        for row in zip(*samples, strict=True)
    ]


def of_sweep(result: "Sweep") -> list[dict[str, Any]]:
    """Return the rows of a sweep, each with the scene and its parameters behind it."""
    case, flat_rows = result.case, []
    constants = {"scene": case.scene.name, "motion": case.scene.motion, "cycles": case.cycles}
    for row in result.dictionaries():
        values = _flat(row)
        durations = values.pop("durations")
        flat_rows.append(values | {"durations": durations} | constants | dict(case.values))
    return flat_rows


def of_family(result: "Family") -> list[dict[str, Any]]:
    """Return a row a value, with the scene and its other parameters behind it."""
    constants: dict[str, Any] = {"scene": result.case.scene.name, "method": result.method}
    constants |= {"order": result.order, "functions": result.functions}
    constants |= {n: value for n, value in result.case.values.items() if n != result.parameter}
    beside = next((row.beside.numbers for row in result.rows if row.beside), {})
    flat_rows = []
    for row in result.rows:
        values = row.as_dict()
        values[result.parameter] = values.pop("value")
        numbers = dict.fromkeys(beside) if row.beside is None else row.beside.numbers
        flat_rows.append(_flat(values) | numbers | constants)
    return flat_rows


def of_modes(
    expansions: "Sequence[Modes]", vary: str = "", values: Sequence[float] = ()
) -> list[dict[str, Any]]:
    """Return a row a mode, with the structure and its parameters behind it.

    First stands the value of what is varied.
    """
    names = [*MODES, *expansions[0].attached.values]
    names = [name for name in names if name != vary.replace("-", "_")]
    return [
        ({vary: values[place]} if vary else {}) | {name: row[name] for name in names}
        for place, expansion in enumerate(expansions)
        for row in expansion.table().rows()
    ]


#: The rows of results of each kind.
ROWS: Mapping[str, Callable[[Sequence[Any]], Iterable[dict[str, Any]]]] = {
    "orbits": of_orbits,
    "sweep": lambda several: of_sweep(several[0]),
    "family": lambda several: of_family(several[0]),
    "branch": lambda several: of_family(several[0]),
    "map": lambda several: several[0].rows(),
    "modes": of_modes,
    "shapes": lambda several: several[0].table().rows(),
}


def _flat(row: Mapping[str, Any]) -> dict[str, Any]:
    """Return a row with durations in one cell, and numbers that have names behind the rest."""
    cells = {name: value for name, value in row.items() if not isinstance(value, Mapping)}
    cells["durations"] = " ".join(map(repr, row["durations"] or ()))
    if "multipliers" in row:
        cells["strobe"] = " ".join(map(repr, row["strobe"] or ()))
        parts = (complex(number["re"], number["im"]) for number in row["multipliers"] or ())
        cells["multipliers"] = " ".join(f"{q.real!r}{q.imag:+}j" for q in parts)
    for key, ends in row.get("extremes", {}).items():
        cells[f"least_{key}"], cells[f"largest_{key}"] = ends or (None, None)
    for name in ("errors", "estimate"):
        for key, value in row.get(name, {}).items():
            cells[f"{name.removesuffix('s')}_{key}"] = value
    return cells
