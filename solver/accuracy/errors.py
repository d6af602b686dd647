"""The difference of two motions of a case: in period, times, and the first jumping derivative.

Against the exact orbit it is the error; against a better orbit the estimate of one.
"""

import math
from dataclasses import dataclass

import numpy as np

from ..arrays import Vector
from ..orbit import chebyshev
from ..orbit.motion import SceneMotion
from .quadrature import panels


@dataclass(frozen=True)
class SceneErrors:
    """Errors of an orbit.

    Parameters
    ----------
    period : float
        ``T/T_exact - 1``, signed; of a forced motion, rounding.
    times : float
        The largest error of a duration, and of the phase of the forcing over its angular
        frequency, as a part of the period.
    discontinuous : float
        Relative L2 error of the first derivative that jumps somewhere, ``x^(k+1)`` for a
        motion of class C^k, with each phase mapped onto the exact one, so that jumps coincide.
    """

    period: float
    times: float
    discontinuous: float


def difference(found: SceneMotion, reference: SceneMotion, waves: int) -> SceneErrors:
    """Return the errors of one motion against another of the same case.

    Parameters
    ----------
    found, reference : SceneMotion
        The two.
    waves : int
        Most waves of either on a phase, for quadrature.
    """
    cell = found.case.cell
    here, there = found.cell_durations, reference.cell_durations
    total = float(np.sum(there))
    times = float(np.abs(here - there).max())
    if cell.forced:
        turn = math.remainder(found.angle - reference.angle, 2 * math.pi)
        times = max(times, abs(turn) / cell.omega)
    return SceneErrors(
        period=float(np.sum(here - there)) / total,
        times=times / (total * cell.cells),
        discontinuous=_ofderivative(found, reference, waves),
    )


def _ofderivative(found: SceneMotion, reference: SceneMotion, waves: int) -> float:
    u, weights = panels([], max(waves, 2))
    order = found.case.cell.k + 1
    apart = size = 0.0
    for p, s in enumerate(reference.cell_durations):
        expected = derivative(reference, p, u, order)
        off = derivative(found, p, u, order) - expected
        apart += float(s * (weights @ off**2))
        size += float(s * (weights @ expected**2))
    return math.sqrt(apart / size) if size else math.sqrt(apart)


def derivative(motion: SceneMotion, p: int, u: Vector, order: int) -> Vector:
    """Return a derivative by time of any order on a phase, without units.

    Parameters
    ----------
    motion : SceneMotion
    p : int
        The phase of the cell.
    u : ndarray
        Local times in [0, 1].
    order : int
        Of the derivative; of orders above 2 by interpolation of the acceleration.
    """
    if order <= 2:
        return motion.part(p, u, order)
    parts = chebyshev.pieces(lambda w: motion.part(p, w, 2))
    duration = float(motion.cell_durations[p])
    further = order - 2
    return chebyshev.derivative_at(parts, u, further) / duration**further
