"""All solutions of the exact equations where something forces and a cell is one free phase.

The duration of the phase is known.  With ``C = cos phi`` and ``S = sin phi`` of the forcing at
its start the end of the phase is linear in ``u = (x, x', C, S)``, and so are all conditions:
three rows ``A u = b`` beside ``C^2 + S^2 = 1``.  So there are two solutions, one, none, or,
where the rows depend on each other, none or infinitely many: no search is needed to say which.
"""

import math
from dataclasses import dataclass

import numpy as np

from ..arrays import Vector
from ..scenes.cell import Cell
from .two_phases import rows

#: What is rounding of singular values, and of residuals, as a part of the largest.
ROUNDING = 1e-11


@dataclass(frozen=True)
class Solutions:
    """Displacement and velocity where the phase starts, and the phase of the forcing.

    Without units; `found` is empty if there are infinitely many, or shown to be `none`.
    """

    found: tuple[tuple[float, float, float], ...]
    none: bool


def applies(cell: Cell) -> bool:
    """Whether a cell is one free phase under a forcing, without a memory."""
    return cell.forced and len(cell.phases) == 1 and not (cell.memory or cell.phases[0].held)


def solutions(cell: Cell) -> Solutions:
    """Return all solutions of the equations of a cell; see `applies`.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> all_of = solutions(registry.load("impact")().cell)
    >>> [f"{phi % 6.283185307:.6f}" for *_, phi in all_of.found]
    ['0.929644', '3.734531']
    """
    with np.errstate(all="ignore"):
        A, b = (part[0] for part in rows(cell, np.array([[cell.duration]])))
    sizes = np.abs(A).max(axis=1) + np.abs(b)
    sizes[sizes == 0] = 1.0
    A, b = A / sizes[:, None], b / sizes
    _, singular, directions = np.linalg.svd(A)
    rank = int(np.sum(singular > ROUNDING))
    particular = np.linalg.lstsq(A, b, rcond=ROUNDING)[0]
    if np.abs(A @ particular - b).max() > ROUNDING:
        return Solutions((), none=True)
    if rank < len(b):
        return Solutions((), none=False)
    return _on_the_circle(particular, directions[-1])


def _on_the_circle(point: Vector, direction: Vector) -> Solutions:
    """Return where the line of solutions of the rows meets ``C^2 + S^2 = 1``."""
    p, n = point[2:], direction[2:]
    a, half, c = float(n @ n), float(p @ n), float(p @ p) - 1.0
    if a <= ROUNDING**2:
        return Solutions((), none=abs(c) > ROUNDING)
    square = half * half - a * c
    if square < -ROUNDING * (half * half + abs(a * c)):
        return Solutions((), none=True)
    root = math.sqrt(max(square, 0.0))
    large = -(half + math.copysign(root, half))
    at = (large / a, c / large if large else 0.0)
    ends = [point + q * direction for q in sorted(at)]
    found = tuple((float(u[0]), float(u[1]), math.atan2(u[3], u[2])) for u in ends)
    return Solutions(found, none=False)
