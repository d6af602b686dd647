"""The difference of two motions of a case: in period, times, and the first jumping derivative.

Against the exact orbit it is the error; against a better orbit the estimate of one.
"""

import math
from dataclasses import dataclass

import numpy as np

from ..arrays import Vector
from . import chebyshev
from .motion import LOOK, Motion
from .quadrature import panels


@dataclass(frozen=True)
class Errors:
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
    switches : float
        The largest error of the displacement where a phase begins, as a part of the largest
        displacement.  Where a clock says when phases end, times have no error, and it has.
    """

    period: float
    times: float
    discontinuous: float
    switches: float


def difference(found: Motion, reference: Motion, waves: int) -> Errors:
    """Return the errors of one motion against another of the same case.

    Parameters
    ----------
    waves : int
        Most waves of either on a phase, for quadrature.
    """
    here, there = found.cell_durations, reference.cell_durations
    return Errors(
        period=float(np.sum(here - there)) / float(np.sum(there)),
        times=times_apart(found, there, reference.angle) / found.case.cell.cells,
        discontinuous=_of_derivative(found, reference, waves),
        switches=_of_switches(found, reference),
    )


def times_apart(found: Motion, durations: Vector | tuple[float, ...], angle: float) -> float:
    """Return how far the times of a motion are from others, as a part of a cell."""
    cell = found.case.cell
    off = float(np.abs(found.cell_durations - durations).max())
    if cell.forced:
        turn = math.remainder(found.angle - angle, 2 * math.pi)
        off = max(off, abs(turn) / cell.omega)
    return off / float(np.sum(durations))


def _of_switches(found: Motion, reference: Motion) -> float:
    phases, start = range(len(reference.cell_durations)), np.zeros(1)
    off = max(
        abs(float((found.part(p, start, 0) - reference.part(p, start, 0))[0])) for p in phases
    )
    size = max(float(np.abs(reference.part(p, LOOK, 0)).max()) for p in phases)
    return off / size if size else off


def _of_derivative(found: Motion, reference: Motion, waves: int) -> float:
    u, weights = panels([], max(waves, 2))
    order = found.case.cell.k + 1
    apart = size = 0.0
    for p, s in enumerate(reference.cell_durations):
        expected = derivative(reference, p, u, order)
        off = derivative(found, p, u, order) - expected
        apart += float(s * (weights @ off**2))
        size += float(s * (weights @ expected**2))
    return math.sqrt(apart / size) if size else math.sqrt(apart)


def derivative(motion: Motion, p: int, u: Vector, order: int) -> Vector:
    """Return a derivative by time of any order on a phase, without units.

    Parameters
    ----------
    order : int
        Of the derivative; of orders above 2 by interpolation of the acceleration.
    """
    if order <= 2 or motion.case.scene.has_body:
        return motion.part(p, u, order)
    parts = chebyshev.pieces(lambda w: motion.part(p, w, 2))
    duration = float(motion.cell_durations[p])
    further = order - 2
    return chebyshev.derivative_at(parts, u, further) / duration**further


def acceleration_error(found: Motion, reference: Motion, waves: int) -> float:
    """Return (22) of the paper: the relative L2 difference over normalised time.

    `waves` are the most that either has on a period, for quadrature.
    """
    breaks = [
        float(end) for each in (found, reference) for end in _ends(each)[1:-1] / _ends(each)[-1]
    ]
    theta, weights = panels(breaks, max(waves, 2))
    expected = _at(reference, theta)
    apart = _at(found, theta) - expected
    return math.sqrt(float(weights @ apart**2) / float(weights @ expected**2))


def _ends(motion: Motion) -> Vector:
    ends: Vector = np.append(0.0, np.cumsum(motion.cell_durations))
    return ends


def _at(motion: Motion, theta: Vector) -> Vector:
    """Return the acceleration at parts of the period, without units."""
    ends = _ends(motion)
    t = theta * ends[-1]
    values = np.empty(len(t))
    for p, s in enumerate(motion.cell_durations):
        here = (t >= ends[p]) & (t < ends[p + 1])
        values[here] = motion.part(p, (t[here] - ends[p]) / s, 2)
    return values
