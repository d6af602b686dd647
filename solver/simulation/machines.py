"""The machine of any cell: of one mass, or of a body; both are followed in the same way."""

from typing import Any, TypeAlias

from ..scenes.bodies.cell import BodyCell
from ..scenes.cell import Cell
from .bodies.machine import BodyMachine
from .machine import Machine

#: What a motion is followed by; its states are those of its own kind.
AnyMachine: TypeAlias = Machine | BodyMachine

#: A `State`, or a `BodyState`.
AnyState: TypeAlias = Any


def machine_of(cell: Cell) -> AnyMachine:
    """Return the phases of a cell, and the rules by which one follows another."""
    return BodyMachine.of(cell) if isinstance(cell, BodyCell) else Machine.of(cell)
