"""A case of the report whose measurements are made up, so that a check can be shown false."""

from collections.abc import Callable, Collection, Mapping
from types import SimpleNamespace
from typing import Any

import nonsmooth as ns
from nonsmooth.report.case import DEFAULT, Case, at_alpha


class Fake(Case):
    """Measurements by method and order; what a check asks for besides is an error.

    Parameters
    ----------
    measured : mapping of (str, str) to callable
        From what is measured, and of which method, to its value by the order.
    alpha : float
        The parameter of the oscillator, the default but for its normal force.
    missing : collection of (str, int)
        Methods and orders without an orbit.
    orbit : callable, optional
        From method and order to an orbit.
    exact : object, optional
        In the place of the exact orbit.
    """

    def __init__(
        self,
        measured: Mapping[tuple[str, str], Callable[[int], float]] = {},
        alpha: float = 1.0,
        missing: Collection[tuple[str, int]] = (),
        orbit: Callable[[str, int], Any] = lambda method, order: SimpleNamespace(),
        exact: Any = None,
    ) -> None:
        super().__init__(at_alpha(DEFAULT, alpha).belt)
        own = {"made": orbit, "values": measured, "missing": missing, "other": exact}
        for name, value in own.items():
            object.__setattr__(self, name, value)

    @property
    def exact(self) -> Any:
        return super().exact if self.other is None else self.other

    def orbit(self, method: str, order: int) -> Any:
        if (method, order) in self.missing:
            raise ns.NoOrbit(f"{method} has no orbit at N = {order}", True, ())
        return self.made(method, order)

    def measured(self, of: str, method: str, order: int) -> float:
        self.orbit(method, order)
        return self.values[of, method](order)
