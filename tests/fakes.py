"""A case of the report whose measurements are made up, so that a check can be shown false."""

from collections.abc import Callable, Iterable, Mapping
from types import SimpleNamespace
from typing import Any

from nonsmooth.report.case import Case, at_alpha
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.shortcuts.accuracy.errors import Errors
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT

#: What is measured of a method, by the order.
Measure = Mapping[str, Callable[[int], float]]


class Fake(Case):
    """Measurements by method and order; what a check asks for besides is an error.

    Parameters
    ----------
    alpha : float
        The parameter of the oscillator, the default but for its normal force.
    missing : iterable of (str, int)
        Methods and orders without an orbit.
    orbit : callable, optional
        From method and order to an orbit.
    measured : mapping of str to mapping
        Of ``period``, ``acceleration``, ``overshoot``, ``largest``, ``inside``.
    """

    def __init__(
        self,
        alpha: float = 1.0,
        missing: Iterable[tuple[str, int]] = (),
        orbit: Callable[[str, int], Any] | None = None,
        **measured: Any,
    ) -> None:
        super().__init__(at_alpha(DEFAULT, alpha).belt)
        own = {"missing": set(missing), "made": orbit, "measured": measured}
        for name, value in own.items():
            object.__setattr__(self, name, value)

    def _of(self, name: str, method: str, order: int) -> float:
        if (method, order) in self.missing:
            raise NoOrbit(f"{method} has no orbit at N = {order}", True, ())
        return self.measured[name][method](order)

    def orbit(self, method: str, order: int) -> Any:
        if (method, order) in self.missing:
            raise NoOrbit(f"{method} has no orbit at N = {order}", True, ())
        if self.made is not None:
            return self.made(method, order)
        known = [self.measured.get(name, {}).get(method) for name in ("period", "acceleration")]
        period, acceleration = (measure(order) if measure else 0.0 for measure in known)
        return SimpleNamespace(errors=Errors(period, period, acceleration, acceleration))

    def period_error(self, method: str, order: int) -> float:
        return self._of("period", method, order)

    def acceleration_error(self, method: str, order: int) -> float:
        return self._of("acceleration", method, order)

    def overshoot(self, method: str, order: int) -> float:
        return self._of("overshoot", method, order)

    def largest_error(self, method: str, order: int, derivative: int = 2) -> float:
        measured = self.measured["largest"][method]
        return measured(order) if derivative == 2 else measured(order, derivative)

    def error_inside(self, method: str, order: int) -> float:
        return self._of("inside", method, order)
