"""All solutions of the exact equations of a forced cell of one free phase.

The duration of the phase is known.  With ``C = cos phi`` and ``S = sin phi`` of the forcing at
its start the end of the phase is linear in ``u = (x, x', C, S)``, and so are all conditions:
three rows ``A u = b`` beside ``C^2 + S^2 = 1``.  So there are two solutions, one or none; if
the rows are linearly dependent, none or infinitely many.
"""

import math
from dataclasses import dataclass, replace

import numpy as np

from ..arrays import Vector
from ..scenes.cell import Cell
from .two_phases import rows

#: Size of singular values and residuals that are rounding, relative to the largest.
ROUNDING = 1e-11

#: Size of a spurious solution, relative to the motion.
FAR = 1e12


@dataclass(frozen=True)
class Solutions:
    """Solutions: displacement, velocity and phase of the forcing at the start, without units.

    `states` is empty if there are infinitely many, if there is provably `none`, or if neither
    can be decided.
    """

    states: tuple[tuple[float, float, float], ...]
    none: bool
    infinite: bool = False


def applies(cell: Cell) -> bool:
    """Whether a cell is one free phase under a forcing, without a memory."""
    return cell.forced and len(cell.phases) == 1 and not (cell.memory or cell.phases[0].held)


def solutions(cell: Cell) -> Solutions:
    """Return all solutions of the equations of a cell; see `applies`.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> all_of = solutions(registry.load("impact")().cell)
    >>> [f"{phi % 6.283185307:.6f}" for *_, phi in all_of.states]
    ['0.929644', '3.734531']
    """
    with np.errstate(all="ignore"):
        A, b = (stack[0] for stack in rows(cell, np.array([[cell.duration]])))
    length, rate = _units(cell)
    A = A * [length, length * rate, 1.0, 1.0]
    sizes = np.abs(A).max(axis=1)
    sizes[sizes == 0] = 1.0
    A, b = A / sizes[:, None], b / sizes
    direction = np.linalg.svd(A)[2][-1]
    particular, _, rank, singular = np.linalg.lstsq(A, b, rcond=ROUNDING)
    left, size = (float(np.abs(vector).max()) for vector in (A @ particular - b, b))
    if left > ROUNDING * size:  # a solution has the size of this over neglected singular values
        none = rank < len(b) and left > FAR * singular[rank] * max(1.0, size)
        return Solutions((), none)
    if rank < len(b):
        return Solutions((), none=False, infinite=True)
    points = on_the_circle(particular, direction)
    states = tuple((length * x, length * rate * v, angle) for x, v, angle in points.states)
    return replace(points, states=states)


def _units(cell: Cell) -> tuple[float, float]:
    """Return a displacement of the size of the motion, and a rate of its changes.

    In these units the rounding errors of the rows are small for stiff and for slow phases.
    """
    phase, omega = cell.phases[0], cell.omega
    stiffness = max(phase.k, phase.c * omega, phase.m * omega**2)
    return (abs(phase.g) or 1.0) / stiffness, max(omega, math.sqrt(abs(phase.k) / phase.m))


def on_the_circle(point: Vector, direction: Vector) -> Solutions:
    """Return the points ``C^2 + S^2 = 1`` on a line of solutions of the rows."""
    size = max(1.0, math.hypot(*point[-2:]))  # its square may be beyond float64
    p, n, unit = point[-2:] / size, direction[-2:], (1.0 / size) ** 2
    a, half, c = float(n @ n), float(p @ n), float(p @ p) - unit
    if a <= ROUNDING**2:
        none = abs(c) > ROUNDING * (unit + float(p @ p))
        return Solutions((), none, infinite=not none)
    square = half * half - a * c
    if square < -ROUNDING * (half * half + abs(a * c)):
        return Solutions((), none=True)
    root = math.sqrt(max(square, 0.0))
    large = -(half + math.copysign(root, half))
    at = (large / a, c / large if large else 0.0)
    ends = [point + size * q * direction for q in sorted(at)]
    points = tuple((float(u[0]), float(u[1]), math.atan2(u[-1], u[-2])) for u in ends)
    return Solutions(points, none=False)
