"""The results of a choice by tolerance or budget: trials, the orbit, or why there is none."""

import math
from dataclasses import dataclass

from ..accuracy.estimate import ROUNDING
from ..orbit.errors import Errors
from ..results.orbit import Orbit

#: Largest estimate, relative to the tolerance: the estimate errs by a few per cent.
MARGIN = 0.9


@dataclass(frozen=True)
class Trial:
    """One order that was tried.

    `estimate` is None if it has no orbit, `seconds` if its time was not measured.
    """

    method: str
    order: int
    estimate: Errors | None
    seconds: float | None = None


@dataclass(frozen=True)
class Choice:
    """The orbit chosen for a tolerance or a budget, and all orders that were tried."""

    orbit: Orbit
    trials: tuple[Trial, ...]


class NotCertified(Exception):  # noqa: N818  (a finding, not a fault)
    """No orbit that was tried has estimated errors within the tolerance.

    Parameters
    ----------
    tol : float
        The tolerance.
    tried : tuple of Trial
    needed : float
        The order at which the errors would meet it by extrapolation; infinite if they do not
        fall, 0 or NaN if unknown.
    """

    def __init__(self, tol: float, tried: tuple[Trial, ...], needed: float) -> None:
        super().__init__(tol, tried, needed)
        self.tol, self.tried, self.needed = tol, tried, needed

    def __str__(self) -> str:
        words = [f"times to {self.tol:g}"]
        if MARGIN * self.tol <= ROUNDING:
            words.append(f"no estimate in float64 goes below {ROUNDING:g}")
        sizes = [(size(trial.estimate), trial) for trial in self.tried if trial.estimate]
        finite = [(error, trial) for error, trial in sizes if math.isfinite(error)]
        if finite:
            best, trial = min(finite, key=lambda pair: pair[0])
            words.append(f"the best tried was {best:.1e} by {trial.method}, N = {trial.order}")
        if self.needed == math.inf:
            words.append("the errors do not fall any more")
        elif self.needed > 0:
            words.append(f"it would need N of about {self.needed:.0e}")
        return "; ".join(words)


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
    """Return the error that a tolerance bounds: the largest of times, switches and period."""
    return max(errors.times, errors.switches, abs(errors.period))
