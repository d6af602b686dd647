"""Maps of small perturbations of the state: over a phase, and across a switch.

The state is a vector that begins with displacement and velocity.  What else a motion remembers
would follow: it is constant in a phase, and a switch sets it.
"""

import math
from dataclasses import dataclass

import numpy as np

from ..arrays import Matrix, Vector
from ..case.cell import Phase
from ..flow import flow


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
    size : float
        Of what the rate of the event is the sum of, added without sign.
    """

    rates_before: Vector
    rates_after: Vector
    law: Matrix
    gradient: Vector
    drift: float
    size: float

    @property
    def crossing(self) -> float:
        """The rate at which the event is crossed."""
        return float(self.gradient @ self.rates_before) + self.drift


def saltation(switch: Switch) -> Matrix:
    """Return the derivative of the state behind a switch by that before it, at one time.

    ``S = R + (F+ - R F-) n^T / (n F- + h_t)``: derived by SymPy in
    ``codegen/scene/saltation.py``.
    """
    jump = switch.rates_after - switch.law @ switch.rates_before
    return np.asarray(switch.law + np.outer(jump, switch.gradient) / switch.crossing)


def determinant(switch: Switch) -> float:
    """Return the determinant of the saltation, by the lemma for changes of rank one.

    Another way than by the entries: one checks the other.
    """
    law, jump = switch.law, switch.rates_after - switch.law @ switch.rates_before
    adjugate = np.trace(law) * np.eye(2) - law  # of two states; the law may be singular
    change = float(switch.gradient @ adjugate @ jump) / switch.crossing
    return float(np.linalg.det(law)) + change


def transition(phase: Phase, s: float) -> Matrix:
    """Return the derivative of the state at the end of a phase by that at its start."""
    return flow.end(phase, np.zeros(2), 0.0, 0.0, s).by_start


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
