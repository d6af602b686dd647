"""What all contenders solve: a scene, its exact times, and rough ones to start from.

Times are without units, those of the case: the durations of the cell and, if something forces,
the phase of the forcing at the first switch.
"""

import math
from dataclasses import dataclass
from functools import cache

import numpy as np

from nonsmooth.solver.exact import ExactOrbit, exact_orbit
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.solve import with_motion

#: How rough the times are: durations are too long and too short by turns, the angle is off.
OFF, ANGLE_OFF = 0.1, 0.3

#: What maps of states start from, as a part of the state where the first phase begins.
STATE_OFF = 1.1


@dataclass(frozen=True)
class Problem:
    """One scene with its default parameters, in the motion that occurs.

    Parameters
    ----------
    case : Case
        Of one motion.
    exact : ExactOrbit
        What errors are measured against: Newton's method on the closed-form flow.
    """

    case: Case
    exact: ExactOrbit

    @property
    def name(self) -> str:
        """Of the scene."""
        return self.case.scene.name

    @property
    def times(self) -> np.ndarray:
        """The exact times."""
        angle = [self.exact.angle] if self.case.cell.forced else []
        return np.array([*self.exact.cell_durations, *angle])

    @property
    def rough(self) -> np.ndarray:
        """The times from which all start; where the period is known, durations add up to it."""
        count, times = len(self.case.cell.phases), self.times
        times[:count] *= [1 + OFF * (-1) ** p for p in range(count)]
        if self.case.cell.forced:
            times[:count] *= self.case.cell.duration / times[:count].sum()
            times[-1] += ANGLE_OFF
        return times

    @property
    def state(self) -> tuple[float, float]:
        """Exact displacement and velocity where the first phase begins."""
        x, v = (float(self.exact.part(0, np.zeros(1), d)[0]) for d in (0, 1))
        return x, v

    def error(self, times: np.ndarray) -> float:
        """Return the largest error of the times: as a part of the period, angles over Omega."""
        cell, count = self.case.cell, len(self.case.cell.phases)
        off = np.abs(np.asarray(times) - self.times)
        if cell.forced:
            turn = math.remainder(times[-1] - self.times[-1], 2 * math.pi)
            off[-1] = abs(turn) / cell.omega
        return float(np.max(off) / (cell.cells * self.times[:count].sum()))


@cache
def problem(scene: str) -> Problem:
    """Return the problem of a scene, by its name."""
    case = with_motion(registry.load(scene)())
    return Problem(case, exact_orbit(case))
