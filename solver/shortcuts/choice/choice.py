"""What a choice of method and order is made of: candidates, the orbit, and refusals."""

from dataclasses import dataclass

from ...no_orbit import NoOrbit
from ...trade.not_certified import MARGIN, NotCertified
from ..accuracy.estimate import ACCELERATION_ROUNDING, ROUNDING, Estimate
from ..orbit.orbit import Orbit
from ..orbit.oscillator import StickSlip
from ..search.solve import solve

#: Below these no estimate goes: rounding.
LEAST = {"period": ROUNDING, "acceleration": ACCELERATION_ROUNDING}


@dataclass(frozen=True)
class Trial:
    """One candidate.

    Parameters
    ----------
    method, order : str, int
    estimate : Estimate or None
        Of its errors; None where it has no orbit.
    seconds : float or None
        Of one solve, measured; None where nothing was to be measured.
    """

    method: str
    order: int
    estimate: Estimate | None
    seconds: float | None = None


@dataclass(frozen=True)
class Choice:
    """What a tolerance or a budget led to.

    Parameters
    ----------
    orbit : Orbit
        The first candidate whose estimate is within the tolerance; the best within the
        budget.
    trials : tuple of Trial
        All candidates, in the order in which they were tried.
    """

    orbit: Orbit
    trials: tuple[Trial, ...]


class NotCertifiedOrbit(NotCertified):
    """No method, order by order, is as accurate as asked for.

    Parameters
    ----------
    wanted : dict
        The tolerances.
    trials : tuple of Trial
        What was tried.
    foretold : dict
        Order that a method would need, by its rate, where that is beyond its highest.
    """

    def __init__(
        self, wanted: dict[str, float], trials: tuple[Trial, ...], foretold: dict[str, float]
    ) -> None:
        super().__init__(wanted, trials, foretold)
        self.wanted = wanted
        self.trials = trials
        self.foretold = foretold

    def __str__(self) -> str:
        parts = [" and ".join(f"{name} to {tol:g}" for name, tol in self.wanted.items())]
        for name, tol in self.wanted.items():
            if MARGIN * tol <= LEAST[name]:
                parts.append(f"no estimate in float64 goes below {LEAST[name]:g}")
        found = [(trial.estimate, trial) for trial in self.trials if trial.estimate is not None]
        name = next(iter(self.wanted))
        if found:
            estimate, best = min(found, key=lambda pair: getattr(pair[0], name))
            value = getattr(estimate, name)
            parts.append(f"the best tried was {value:.1e} by {best.method}, N = {best.order}")
        parts += [f"{name} would need N of about {N:.0e}" for name, N in self.foretold.items()]
        return "; ".join(parts)


def attempt(belt: StickSlip, method: str, order: int, many: bool) -> Orbit | None:
    """Return the orbit of one candidate, or None where it has none."""
    try:
        return solve(belt, method, order, many=many)
    except NoOrbit:
        return None
