"""A cell of a body as the arrays of its equations; see `equations`."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ...arrays import Matrix, Vector
from ...bodies.part import generator_of, parts_of
from ...scenes.bodies.cell import BodyCell
from ...scenes.cell import Form


def durations_of(cell: BodyCell, z: Vector) -> Vector:
    """Return the durations among unknowns."""
    return z[len(z) - len(cell.phases) - cell.forced :][: len(cell.phases)]


def in_order(cell: BodyCell, rows: Matrix) -> Matrix:
    """Return forms of ``(y, cos, sin, 1, memory)`` as those of ``(y, memory, cos, sin, 1)``."""
    end = rows.shape[-1] - len(cell.memory)
    parts = rows[..., : end - 3], rows[..., end:], rows[..., end - 3 : end]
    return np.concatenate(parts, axis=-1)


def arrays(cell: BodyCell, forms: Sequence[Form]) -> list[Matrix]:
    """Return the arrays of a cell as `equations.case_at` has them, behind its first."""
    parts, count = parts_of(cell), len(cell.phases)
    states = parts[0].switch.state.shape[0]
    width = states + 3
    switches = np.array([np.eye(width)] * count)
    for p, part in enumerate(parts):
        switches[p, :states] = np.hstack([part.switch.state, part.switch.inputs])
    generators = [generator_of(part, cell.omega) for part in parts]
    return [
        np.array([in_order(cell, in_order(cell, own.T).T) for own in generators]),
        switches,
        in_order(cell, np.array([part.switch.event for part in parts])),
        in_order(cell, np.array([part.lawful.rows[:2] for part in parts])),
        np.array([cell.sign, cell.omega, cell.duration if cell.forced else 0.0]),
        np.array(forms, dtype=float).reshape(-1, width),
    ]


def case_of(cell: BodyCell, forms: Sequence[Form]) -> Any:
    """Return the arrays of a cell as `equations.case_at` does."""
    return np.zeros(len(cell.phases), dtype=np.int64), *arrays(cell, forms)
