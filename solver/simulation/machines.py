"""The machine of any cell, of one mass or of a body; both have the same interface."""

from functools import lru_cache

from ..scenes.bodies.cell import BodyCell
from ..scenes.cell import Cell
from .bodies.machine import BodyMachine
from .machine import Machine


@lru_cache(maxsize=8)
def machine_of(cell: Cell) -> Machine:
    """Return the phases of a cell, and the rules by which one follows another."""
    return BodyMachine(cell) if isinstance(cell, BodyCell) else Machine(cell)
