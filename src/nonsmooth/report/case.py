"""One oscillator and its orbits, each computed on first use."""

from dataclasses import dataclass, field
from functools import cached_property

import nonsmooth as ns
from nonsmooth.kim_perkins import SECTION_4, ExactStickSlipOrbit, StickSlipOrbit
from nonsmooth.solver.accuracy.rates import slope

from .measures import MEASURES

#: The oscillator of Section 4.
DEFAULT = ns.StickSlip(**SECTION_4)

#: Highest order at which claims are checked: that of Fig. 3.
MOST = 40

#: Highest order at which all solutions of the C1 series are found in milliseconds.
QUICK = 5

#: Errors of the period, and in the measure (22), below which they are rounding.
FLOORS = {"period": 1e-12, "acceleration": 1e-6}


@dataclass(frozen=True)
class Case:
    """An oscillator, with a cache of its orbits and their errors.

    Parameters
    ----------
    belt : StickSlip
        The oscillator.
    """

    belt: ns.StickSlip
    _found: dict[tuple[str, int], StickSlipOrbit | ns.NoOrbit] = field(
        default_factory=dict, repr=False
    )
    _measured: dict[tuple[str, str, int], float] = field(default_factory=dict, repr=False)

    @cached_property
    def exact(self) -> ExactStickSlipOrbit:
        """The exact orbit."""
        return ExactStickSlipOrbit.of(ns.exact(self.belt))

    def orbit(self, method: str, order: int) -> StickSlipOrbit:
        """Return one orbit.

        Raises
        ------
        NoOrbit
            If there is none, or none is found; raised again from the cache.
        """
        key = method, order
        if key not in self._found:
            try:
                self._found[key] = self._solved(method, order)
            except ns.NoOrbit as finding:
                words = "has no orbit" if finding.proven else "leads to no orbit"
                reason = f"{method} {words} at N = {order}"
                self._found[key] = ns.NoOrbit(reason, finding.proven, ())
        answer = self._found[key]
        if isinstance(answer, ns.NoOrbit):
            raise answer
        return answer

    def _solved(self, method: str, order: int) -> StickSlipOrbit:
        """Return one orbit, or raise a `NoOrbit`.

        For the C1 series a proof that there is none is quicker than a vain search.  It is tried
        first at low orders, and if the order before has no orbit.
        """
        before = self._found.get((method, order - 1))
        if method == "c1" and (order <= QUICK or isinstance(before, ns.NoOrbit)):
            shown = self.belt.none("ck", order, ())
            if shown is not None:
                raise shown
        return StickSlipOrbit.of(ns.solve(self.belt, method, order))

    def has(self, method: str, order: int) -> bool:
        """Return whether an orbit is found."""
        try:
            self.orbit(method, order)
        except ns.NoOrbit:
            return False
        return True

    def orders(self, method: str) -> list[int]:
        """Return the orders up to `MOST` at which an orbit is found."""
        return [N for N in range(1, MOST + 1) if self.has(method, N)]

    def measured(self, of: str, method: str, order: int) -> float:
        """Return one of the `MEASURES` of one orbit."""
        key = of, method, order
        if key not in self._measured:
            self._measured[key] = MEASURES[of](self.orbit(method, order), self.exact)
        return self._measured[key]

    def rate(self, of: str, method: str) -> float | None:
        """Return the rate of convergence of an error, as in `Sweep.rates`.

        The power of 1/N or, for the C1 series, the digits gained per order; None if too few
        orders have an orbit.
        """
        errors = [(N, self.measured(of, method, N)) for N in self.orders(method)]
        return slope(errors, FLOORS[of], power=method != "c1", upper_half=True)

    def behind(self, of: str, ours: str, theirs: str) -> list[int]:
        """Return the orders up to `MOST` at which a method is not better than another.

        It is not if it has no orbit; it is if only the other has none, or its own error is
        rounding.
        """

        def better(N: int) -> bool:
            size = abs(self.measured(of, ours, N))
            rounding = size < FLOORS[of]
            without = rounding or not self.has(theirs, N)
            return without or size < abs(self.measured(of, theirs, N))

        return [N for N in range(1, MOST + 1) if not (self.has(ours, N) and better(N))]


def at_alpha(belt: ns.StickSlip, alpha: float) -> Case:
    """Return the case of an oscillator with the normal force that gives `alpha`."""
    force = belt.normal_force * (alpha / belt.alpha)
    return Case(belt.with_value("normal_force", force))
