"""The difference of two motions of a case: in period, times, and the first jumping derivative.

Against the exact orbit it is the error; against a better orbit the estimate of one.
"""

import math
from dataclasses import dataclass, replace

import numpy as np

from ..arrays import Vector
from . import chebyshev
from .motion import LOOK, Motion
from .quadrature import panels
from .transients import cuts


@dataclass(frozen=True)
class Errors:
    """Errors of an orbit.

    Parameters
    ----------
    period : float
        ``T/T_exact - 1``, signed; rounding if the motion is forced.
    times : float
        The largest error of a duration, and of the phase of the forcing over its angular
        frequency, relative to the period.
    discontinuous : float
        Relative L2 error of the first derivative that jumps somewhere, ``x^(k+1)`` for a
        motion of class C^k, with each phase mapped onto the exact one, so that jumps coincide.
    switches : float
        The largest error of the displacement where a phase begins, relative to the largest
        displacement.  It tells orbits apart whose phases end at given times: these are exact.
    """

    period: float
    times: float
    discontinuous: float
    switches: float


def difference(motion: Motion, reference: Motion, waves: int) -> Errors:
    """Return the errors of one motion against another of the same case.

    Parameters
    ----------
    waves : int
        Most waves of either on a phase: the number of panels of the quadrature.
    """
    durations, expected = motion.cell_durations, reference.cell_durations
    return Errors(
        period=float(np.sum(durations - expected)) / float(np.sum(expected)),
        times=times_apart(motion, expected, reference.angle) / motion.case.cell.cells,
        discontinuous=_of_derivative(motion, reference, waves),
        switches=_of_switches(motion, reference),
    )


def times_apart(motion: Motion, durations: Vector | tuple[float, ...], angle: float) -> float:
    """Return the largest difference between the times of a motion and others, over the cell."""
    cell = motion.case.cell
    distance = float(np.abs(motion.cell_durations - durations).max())
    if cell.forced:
        turn = math.remainder(motion.angle - angle, 2 * math.pi)
        distance = max(distance, abs(turn) / cell.omega)
    return distance / float(np.sum(durations))


def _of_switches(motion: Motion, reference: Motion) -> float:
    """Return the error `Errors.switches`."""
    phases, start = range(len(reference.cell_durations)), np.zeros(1)
    distance = max(
        abs(float((motion.part(p, start, 0) - reference.part(p, start, 0))[0])) for p in phases
    )
    size = max(float(np.abs(reference.part(p, LOOK, 0)).max()) for p in phases)
    return distance / size if size else distance


def _of_derivative(motion: Motion, reference: Motion, waves: int) -> float:
    """Return the error `Errors.discontinuous`."""
    u, weights = panels([], max(waves, 2))
    order = motion.case.cell.k + 1
    squared_error = squared_norm = 0.0
    for p, s in enumerate(reference.cell_durations):
        expected = derivative(reference, p, u, order)
        error = derivative(motion, p, u, order) - expected
        squared_error += float(s * (weights @ error**2))
        squared_norm += float(s * (weights @ expected**2))
    return math.sqrt(squared_error / squared_norm if squared_norm else squared_error)


def derivative(motion: Motion, p: int, u: Vector, order: int) -> Vector:
    """Return the derivative of any order by time at local times of phase `p`, without units.

    Orders above 2 of one mass are derivatives of an interpolant of the acceleration.
    """
    if order <= 2 or motion.case.scene.has_body:
        return motion.part(p, u, order)
    times, duration = order - 2, float(motion.cell_durations[p])
    parts = _acceleration_pieces(motion, p, size_of_forces(motion, p))
    return chebyshev.derivative_at(parts, u, times) / duration**times


def rounding_of_derivative(motion: Motion) -> float:
    """Return the rounding error of `Errors.discontinuous` of one mass, over machine epsilon.

    The acceleration is a sum of forces, which may nearly cancel; its derivatives are those of
    an interpolant.  A derivative multiplies rounding errors by the degree over the duration.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> from nonsmooth.solver.exact import exact_orbit
    >>> case = registry.load("dry-friction")(force=0.3001)  # hardly more than friction
    >>> f"{rounding_of_derivative(exact_orbit(case)):.0e}"
    '5e+03'
    """
    order = max(motion.case.cell.k + 1, 2)
    u, weights = panels([], 2)
    squared_error = squared_norm = 0.0
    for p, s in enumerate(motion.cell_durations):
        size = size_of_forces(motion, p)
        squared_norm += float(s * (weights @ derivative(motion, p, u, order) ** 2))
        for part in _acceleration_pieces(motion, p, size):
            duration = float(s) * (part.end - part.start)
            error = size * (len(part.coefficients) / duration) ** (order - 2)
            squared_error += duration * error**2
    return math.sqrt(squared_error / squared_norm) if squared_norm else 0.0


def size_of_forces(motion: Motion, p: int) -> float:
    """Return the largest sum of the sizes of the forces on one mass in phase `p`, over it."""
    phase = motion.cell.phases[p]
    if phase.held:
        return 0.0
    x, v = (motion.part(p, LOOK, j) for j in (0, 1))
    of_state = np.abs(phase.c * v) + np.abs(phase.k * x)
    return (abs(phase.f) + abs(phase.g) + float(of_state.max())) / phase.m


def _acceleration_pieces(motion: Motion, p: int, size: float) -> list[chebyshev.Piece]:
    """Return interpolants of the acceleration in phase `p`, a sum of forces of a size."""
    parts = chebyshev.pieces(lambda w: motion.part(p, w, 2), size, cuts(motion, p))
    return [replace(part, coefficients=part.significant(size)) for part in parts]


def acceleration_error(motion: Motion, reference: Motion, waves: int) -> float:
    """Return the relative L2 error of the acceleration over normalised time, (22) of the paper.

    `waves` are the most that either has on a period: the number of panels of the quadrature.
    """
    switches = (_switches(motion), _switches(reference))
    breaks = [float(t) for times in switches for t in times[1:-1] / times[-1]]
    theta, weights = panels(breaks, max(waves, 2))
    expected = _acceleration(reference, theta)
    error = _acceleration(motion, theta) - expected
    return math.sqrt(float(weights @ error**2) / float(weights @ expected**2))


def _switches(motion: Motion) -> Vector:
    """Return the times of the switches of a cell, from 0 to its end, without units."""
    times: Vector = np.append(0.0, np.cumsum(motion.cell_durations))
    return times


def _acceleration(motion: Motion, theta: Vector) -> Vector:
    """Return the acceleration at times in [0, 1) of the cell, without units."""
    switches = _switches(motion)
    t = theta * switches[-1]
    values = np.empty(len(t))
    for p, s in enumerate(motion.cell_durations):
        in_phase = (t >= switches[p]) & (t < switches[p + 1])
        values[in_phase] = motion.part(p, (t[in_phase] - switches[p]) / s, 2)
    return values
