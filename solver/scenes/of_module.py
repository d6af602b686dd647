"""The cell of a scene from the numbers that its generated module returns for parameters."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from .cell import Cell, Form, Memory, Phase

if TYPE_CHECKING:
    from .loaded import LoadedScene


def cell_of(scene: "LoadedScene", numbers: tuple[float, ...], cycles: int = 1) -> Cell:
    """Return the cell of a scene of one motion for dimensionless parameters."""
    phases = []
    equations = scene.numbers("coefficients", numbers)
    for equation, fields in zip(equations, fields_of_phases(scene, numbers), strict=True):
        m, c, k, f, g, *memory = map(float, equation)
        phases.append(Phase(m=m, c=c, k=k, f=f, g=g, memory=tuple(memory), **fields))
    cell = Cell(phases=tuple(phases), **fields_of_cell(scene, numbers))
    start = form_of(scene.numbers("start", numbers)) if scene.has_start else ()
    return replace(cell, cycles=cycles, start=start)


def fields_of_phases(
    scene: "LoadedScene", numbers: tuple[float, ...]
) -> Iterator[dict[str, Any]]:
    """Yield the fields of each `Phase` besides its equation: name, event, jump, demands."""
    module = scene.module
    rows = zip(
        scene.kinds,
        scene.numbers("held", numbers),
        scene.numbers("events", numbers),
        scene.numbers("jumps", numbers),
        zip(module.DEMANDS, scene.numbers("demands", numbers), strict=True),
        zip(module.SWITCH_DEMANDS, scene.numbers("switch_demands", numbers), strict=True),
        strict=True,
    )
    for (name, held), speed, event, jump, demands, at_switch in rows:
        yield {
            "name": name,
            "held": held,
            "speed": float(speed),
            "event": form_of(event),
            "rho": float(jump[0]),
            "d": float(jump[1]),
            "demands": _with_words(*demands),
            "switch_demands": _with_words(*at_switch),
        }


def fields_of_cell(scene: "LoadedScene", numbers: tuple[float, ...]) -> dict[str, Any]:
    """Return the fields of a `Cell` besides its phases, for one cycle of the forcing."""
    names = [parameter.name for parameter in scene.parameters]
    values = scene.numbers("memory", numbers)
    return {
        "frequency": None if scene.frequency is None else numbers[names.index(scene.frequency)],
        "sign": -1 if scene.half_period else 1,
        "k": scene.k,
        "guess": tuple(map(float, scene.numbers("guess", numbers))),
        "memory": tuple(
            Memory(name, phase, power, form_of(value))
            if isinstance(phase, int)
            else Memory(name, -1, power, form_of(value), phase)
            for (name, phase, power, _), value in zip(scene.memory, values, strict=True)
        ),
        "classes": scene.classes,
        "orders": scene.orders,
        "to": scene.to,
    }


def form_of(row: Sequence[float]) -> Form:
    """Return a row of a generated module as a form."""
    return tuple(map(float, row))


def _with_words(
    words: Sequence[str], rows: Sequence[Sequence[float]]
) -> tuple[tuple[str, Form], ...]:
    """Return forms, each with its words."""
    return tuple(zip(words, map(form_of, rows), strict=True))
