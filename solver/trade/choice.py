"""What a tolerance or a budget comes to: what was tried, the orbit, or why there is none."""

import math
from dataclasses import dataclass

from ..accuracy.errors import SceneErrors
from ..accuracy.estimate import ROUNDING
from ..orbit.orbit import SceneOrbit
from .not_certified import MARGIN, NotCertified


@dataclass(frozen=True)
class SceneTrial:
    """One order that was tried.

    Parameters
    ----------
    method, order : str, int
    estimate : SceneErrors or None
        Of its errors; None where it has no orbit.
    seconds : float or None
        Of one solve, measured; None where nothing was to be measured.
    """

    method: str
    order: int
    estimate: SceneErrors | None
    seconds: float | None = None


@dataclass(frozen=True)
class SceneChoice:
    """What a tolerance or budget led to: the orbit, and all that was tried on the way."""

    orbit: SceneOrbit
    trials: tuple[SceneTrial, ...]


class NotCertifiedScene(NotCertified):
    """No order of a method is as accurate as asked for, as far as the estimate can say."""

    def __init__(self, tol: float, trials: tuple[SceneTrial, ...], needed: float) -> None:
        super().__init__(tol, trials, needed)
        self.tol, self.tried, self.needed = tol, trials, needed

    def __str__(self) -> str:
        parts = [f"times to {self.tol:g}"]
        if MARGIN * self.tol <= ROUNDING:
            parts.append(f"no estimate in float64 goes below {ROUNDING:g}")
        sizes = [(size(trial.estimate), trial) for trial in self.tried if trial.estimate]
        found = [(error, trial) for error, trial in sizes if math.isfinite(error)]
        if found:
            best, trial = min(found, key=lambda pair: pair[0])
            parts.append(f"the best tried was {best:.1e} by {trial.method}, N = {trial.order}")
        if self.needed == math.inf:
            parts.append("the errors do not fall any more")
        elif self.needed > 0:
            parts.append(f"it would need N of about {self.needed:.0e}")
        return "; ".join(parts)


def size(errors: SceneErrors) -> float:
    """Return what a tolerance bounds: the error of the times, and of a free period."""
    return max(errors.times, abs(errors.period))
