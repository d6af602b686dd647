"""What a cell of a body makes of small perturbations of its state and memory."""

from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Matrix, Vector
from ..iteration.linear import product
from .exact import evaluated
from .part import angles_of, parts_of, phase_map, rates, turned, wave

if TYPE_CHECKING:
    from ..scenes.bodies.cell import BodyCell


def cell_map(cell: "BodyCell", times: Vector) -> tuple[Matrix, Matrix, Vector]:
    """Return what a cell makes of perturbations of ``X = (y, memory)``, before it is mirrored.

    The product over the phases of the flow and of the saltation at the switch that ends the
    phase, ``S = R + (F+ - R F- - R_t) n^T/(n F- + h_t)``; see `stability.cell_map`.

    Returns
    -------
    matrix : ndarray, shape (n, n)
    size : ndarray, shape (n, n)
        Rounding errors are parts of it; see `linear.product`.
    crossed : ndarray, shape (P,)
        The rate at which the event that ends each phase is crossed, as a part of the size of
        its terms.
    """
    parts, starts = parts_of(cell), evaluated(cell, times).starts
    theta, count = angles_of(cell, times), len(parts)
    shape = count, starts.shape[1], starts.shape[1]
    steps, sizes, crossed = np.empty(shape), np.empty(shape), np.empty(count)
    for p, part in enumerate(parts):
        along, by_wave = phase_map(part, float(times[p]))
        end = along @ starts[p] + by_wave @ wave(theta[p])
        q, sign = (p + 1, 1) if p + 1 < count else (0, cell.sign)
        before = rates(part, end, theta[p + 1])
        behind = sign * rates(parts[q], starts[q], theta[q] if q == 0 else theta[p + 1])
        gradient, waves = part.switch.gradient, part.switch.waves
        approach = cell.omega * float(waves @ turned(theta[p + 1]))
        scale = float(np.abs(gradient) @ np.abs(before)) + cell.omega * float(
            np.abs(waves).sum()
        )
        rate = approach + float(gradient @ before)
        crossed[p] = abs(rate) / scale if scale > 0 else 0.0
        jump = behind - part.switch.state @ before
        jump -= cell.omega * (part.switch.inputs @ turned(theta[p + 1]))
        across = part.switch.state + np.outer(jump, gradient) / rate
        steps[p] = across @ along
        sizes[p] = np.abs(across) @ np.abs(along) / min(1.0, crossed[p])
    return *product(steps, sizes), crossed
