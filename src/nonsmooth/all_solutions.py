"""All real solutions of the C1 series of the paper, (18) to (20), orbits or not."""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .solver.existence.isolated import isolated
from .solver.kernels.registry import kernel
from .solver.orbit.attempt import attempt

if TYPE_CHECKING:
    from .kim_perkins import StickSlip


@dataclass(frozen=True)
class RealSolution:
    """A real solution of (18) to (20).

    Parameters
    ----------
    slip, t1, period : float
        In s; `t1` may be negative.
    violations : tuple of str
        What keeps it from being an orbit; empty of the orbit.
    transition_mismatch : float or None
        `StickSlipOrbit.transition_mismatch`; None where `t1` is not positive.
    """

    slip: float
    t1: float
    period: float
    violations: tuple[str, ...]
    transition_mismatch: float | None


def solutions(belt: "StickSlip", order: int) -> list[RealSolution]:
    """Return all real solutions of (18) to (20), orbits or not, by their durations of slip.

    Raises
    ------
    ArithmeticError
        If two of them coincide.
    """
    found = []
    for t1, slip in isolated(order, belt.alpha):
        stick, rest = t1 / belt.omega_n, slip / belt.omega_n
        violations: tuple[str, ...] = (f"stick lasts {stick:.3g} s",)
        off = None
        if t1 > 0:
            times = np.array([stick, rest]) / belt.units.time
            orbit = belt.presented(attempt(kernel(belt.scene, "ck"), belt, order, times))
            violations, off = orbit.violations, orbit.transition_mismatch
        turns = slip / (2 * math.pi)
        if turns > 1 + 1 / (2 * order):
            words = f"slip lasts {turns:.4g} natural periods: within one, the velocity is back"
            violations = (f"{words} at V", *violations)
        found.append(RealSolution(rest, stick, stick + rest, violations, off))
    return found
