"""Maps of small perturbations of the state: over a phase, and across a switch.

The state is a vector of displacement, velocity and what the motion remembers: constants of a
phase, each of which a switch sets.
"""

import math
from dataclasses import dataclass, replace

import numpy as np

from ..arrays import Matrix, Vector
from ..flow import flow
from ..scenes.cell import Phase


@dataclass(frozen=True)
class Switch:
    """One switch of an orbit, in the numbers of its two sides.

    Parameters
    ----------
    rates_before, rates_after : ndarray, shape (n,)
        Derivative of the state by time on both sides.
    law : ndarray, shape (n, n)
        Derivative of the state after by the state before, at the event.
    gradient : ndarray, shape (n,)
        Derivative of the event's form by the state before.
    drift : float
        Its derivative by time at a fixed state: of the forcing.
    turning : ndarray, shape (n,)
        Derivative by time at a fixed state of what the law makes of the state.
    size : float
        Of what the rate of the event is the sum of, added without sign.
    """

    rates_before: Vector
    rates_after: Vector
    law: Matrix
    gradient: Vector
    drift: float
    turning: Vector
    size: float

    @property
    def approach(self) -> float:
        """The rate at which the event is crossed."""
        return float(self.gradient @ self.rates_before) + self.drift

    @property
    def jump(self) -> Vector:
        """What a delay of the event adds to the state behind it, by the time of the delay."""
        return np.asarray(self.rates_after - self.law @ self.rates_before - self.turning)


def saltation(switch: Switch) -> Matrix:
    """Return the derivative of the state behind a switch by that before it, at one time.

    ``S = R + (F+ - R F- - R_t) n^T / (n F- + h_t)``: derived by SymPy in
    ``codegen/scene/saltation.py``.
    """
    change = np.outer(switch.jump, switch.gradient) / switch.approach
    return np.asarray(switch.law + change)


def determinant(switch: Switch) -> float:
    """Return the determinant of the saltation, by the lemma for changes of rank one.

    Another way than by the entries: one checks the other.
    """
    law = switch.law
    change = float(switch.gradient @ adjugate(law) @ switch.jump) / switch.approach
    return float(np.linalg.det(law)) + change


def adjugate(matrix: Matrix) -> Matrix:
    """Return the transposed matrix of cofactors, also of a singular matrix.

    Examples
    --------
    >>> adjugate(np.array([[1.0, 2.0], [3.0, 4.0]]))
    array([[ 4., -2.],
           [-3.,  1.]])
    """
    n = len(matrix)
    found = np.empty((n, n))
    for i in range(n):
        for j in range(n):
            rest = np.delete(np.delete(matrix, j, axis=0), i, axis=1)
            found[i, j] = (-1) ** (i + j) * np.linalg.det(rest)
    return found


def transition(phase: Phase, s: float, factors: tuple[float, ...] = ()) -> Matrix:
    """Return the derivative of the state at the end of a phase by that at its start.

    Parameters
    ----------
    phase : Phase
        With numbers for the memory.
    s : float
        Its duration.
    factors : tuple of float
        Force of each constant that the motion remembers.
    """
    count = 2 + len(factors)
    found = np.eye(count)
    found[:2, :2] = flow.by_start(phase, s)
    for i, factor in enumerate(factors):
        if not phase.held:
            pushed = replace(phase, f=factor, g=0.0)
            found[:2, 2 + i] = flow.state_at(pushed, 0.0, 0.0, 0.0, 0.0, s)
    return found


def contraction(phase: Phase, s: float) -> float:
    """Return the determinant of `transition`, by Liouville's formula; 0 of a held phase."""
    return 0.0 if phase.held else math.exp(-phase.c / phase.m * s)


def rates(phase: Phase, state: Vector, cosine: float) -> Vector:
    """Return the derivative of the state by time in a phase."""
    if phase.held:
        return np.array([phase.speed, 0.0])
    x, v = state
    force = phase.f + phase.g * cosine - phase.c * v - phase.k * x
    return np.array([v, force / phase.m])
