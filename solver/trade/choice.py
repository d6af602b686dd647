"""What a tolerance or a budget comes to: what was tried, the orbit, or why there is none."""

import math
from dataclasses import dataclass

from ..accuracy.estimate import ROUNDING
from ..orbit.errors import Errors
from ..results.orbit import Orbit

#: Part of a tolerance that an estimate may use up; it is itself off by a few per cent.
MARGIN = 0.9


@dataclass(frozen=True)
class Trial:
    """One order that was tried.

    `estimate` is None where it has no orbit, `seconds` where none were to be measured.
    """

    method: str
    order: int
    estimate: Errors | None
    seconds: float | None = None


@dataclass(frozen=True)
class Choice:
    """What a tolerance or budget led to: the orbit, and all that was tried on the way."""

    orbit: Orbit
    trials: tuple[Trial, ...]


class NotCertified(Exception):  # noqa: N818  (a finding, not a fault)
    """No orbit in float64 is as accurate as asked for, as far as the estimate can say.

    Parameters
    ----------
    tol : float
        What was asked for.
    tried : tuple of Trial
    needed : float
        The order at which the errors, as they fall, would meet it; infinite where they do not.
    """

    def __init__(self, tol: float, tried: tuple[Trial, ...], needed: float) -> None:
        super().__init__(tol, tried, needed)
        self.tol, self.tried, self.needed = tol, tried, needed

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


class TooSlow(Exception):  # noqa: N818  (a finding, not a fault)
    """No orbit is computed within the budget.

    Parameters
    ----------
    budget, fastest : float
        Seconds.
    """

    def __init__(self, budget: float, fastest: float) -> None:
        super().__init__(budget, fastest)
        self.budget, self.fastest = budget, fastest

    def __str__(self) -> str:
        budget, fastest = f"{self.budget:.2g} s", f"{self.fastest:.2g} s"
        return f"a budget of {budget}: the fastest orbit takes {fastest} here"


def size(errors: Errors) -> float:
    """Return what a tolerance bounds: errors of the switches, and of a free period."""
    return max(errors.times, errors.switches, abs(errors.period))
