"""One oscillator and its orbits, each solved when it is first asked for."""

from dataclasses import dataclass, field, replace

import numpy as np

from nonsmooth.solver.arrays import Vector
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.shortcuts.accuracy.convergence import FLOORS, Rate, rate
from nonsmooth.solver.shortcuts.orbit import exact
from nonsmooth.solver.shortcuts.orbit.methods import METHODS
from nonsmooth.solver.shortcuts.orbit.orbit import Orbit
from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip
from nonsmooth.solver.shortcuts.search.solve import solve

#: Highest order that a claim is checked at: that of Fig. 3.
MOST = 40

#: Samples of each phase where a largest value is looked for.
SAMPLES = 2000


@dataclass(frozen=True)
class Case:
    """An oscillator, and what of its orbits has been computed.

    Parameters
    ----------
    belt : StickSlip
        The oscillator.
    """

    belt: StickSlip
    _found: dict[tuple[str, int], Orbit | NoOrbit] = field(default_factory=dict, repr=False)

    @property
    def alpha(self) -> float:
        """The one parameter of the oscillator."""
        return self.belt.alpha

    def orbit(self, method: str, order: int) -> Orbit:
        """Return one orbit.

        Raises
        ------
        NoOrbit
            If there is none, or none was found.
        """
        key = method, order
        if key not in self._found:
            try:
                self._found[key] = solve(self.belt, method, order, many=True)
            except NoOrbit as finding:
                known = "has no orbit" if finding.proven else "leads to no orbit"
                reason = f"{method} {known} at N = {order}"
                self._found[key] = NoOrbit(reason, finding.proven, ())
        found = self._found[key]
        if isinstance(found, NoOrbit):
            raise found
        return found

    def has(self, method: str, order: int) -> bool:
        """Return whether there is an orbit."""
        try:
            self.orbit(method, order)
        except NoOrbit:
            return False
        return True

    def orders(self, method: str) -> list[int]:
        """Return the orders to `MOST` at which there is an orbit."""
        return [N for N in range(1, MOST + 1) if self.has(method, N)]

    def period_error(self, method: str, order: int) -> float:
        """Return ``T/T_exact - 1``, without the errors of the acceleration."""
        T = exact.times(self.alpha)[1]
        return (float(self.orbit(method, order).unknowns[-1]) - T) / T

    def acceleration_error(self, method: str, order: int) -> float:
        """Return (22) over normalised time."""
        return self.orbit(method, order).errors.acceleration

    def rates(self, method: str) -> Rate:
        """Return how fast a method converges over the orders to `MOST` that have an orbit."""
        rows = [(N, self.orbit(method, N).errors) for N in self.orders(method)]
        return rate(method, rows)

    def behind(self, name: str, ours: str, theirs: str) -> list[int]:
        """Return the orders to `MOST` at which a method is not better than another.

        Where it has no orbit it is not; where only the other has none, or the error is
        rounding, it is.

        Parameters
        ----------
        name : {"period", "acceleration"}
            Which error.
        ours, theirs : {"hb", "hb-c1", "c1"}
        """
        error = {"period": self.period_error, "acceleration": self.acceleration_error}[name]

        def better(N: int) -> bool:
            size = abs(error(ours, N))
            rounding = size < FLOORS[name]
            return rounding or not self.has(theirs, N) or size < abs(error(theirs, N))

        return [N for N in range(1, MOST + 1) if not (self.has(ours, N) and better(N))]

    def overshoot(self, method: str, order: int) -> float:
        """Return how far the acceleration swings beyond 0 before its jump, in jumps.

        At the end of stick the exact one falls from 0; what is above 0 in the second half
        of stick is the ripple that Gibbs' phenomenon leaves there.
        """
        return self.peak(method, order)[1] / (self.alpha * self.belt.acceleration_unit)

    def peak(self, method: str, order: int) -> tuple[float, float]:
        """Return time and size, in SI units, of the highest ripple before end of stick."""
        orbit = self.orbit(method, order)
        times = np.linspace(orbit.t1 / 2, orbit.t1, SAMPLES, endpoint=False)
        values = orbit.acceleration(times)
        best = int(np.argmax(values))
        return float(times[best]), float(values[best])

    def largest_error(self, method: str, order: int, derivative: int = 2) -> float:
        """Return the largest error with each phase laid over the exact one.

        Of the acceleration in jumps; of displacement and velocity in the exact amplitude.
        """
        found, reference = self._phase_by_phase(method, order, derivative)
        size = self.alpha if derivative == 2 else float(np.hypot(1, self.alpha))
        return float(np.abs(found - reference).max()) / size

    def error_inside(self, method: str, order: int) -> float:
        """Return the largest error of the acceleration in the middle half of each phase."""
        found, reference = self._phase_by_phase(method, order, 2)
        inside = np.abs(found - reference).reshape(2, 4, -1)[:, 1:3]
        return float(inside.max()) / self.alpha

    def _phase_by_phase(
        self, method: str, order: int, derivative: int
    ) -> tuple[Vector, Vector]:
        """Return approximate and exact values, stick on stick and slip on slip."""
        z = self.orbit(method, order).unknowns
        u = (np.arange(SAMPLES) + 0.5) / SAMPLES
        evaluate = METHODS[method].evaluate
        t1, T = z[-2:]
        exact_t1, exact_T = exact.times(self.alpha)
        here = np.concatenate([t1 * u, t1 + (T - t1) * u])
        there = np.concatenate([exact_t1 * u, exact_t1 + (exact_T - exact_t1) * u])
        found = evaluate(z, order, here, derivative, self.alpha)
        return found, exact.evaluate(self.alpha, there, derivative)


def at_alpha(belt: StickSlip, alpha: float) -> Case:
    """Return the same oscillator under the normal force that gives this `alpha`."""
    return Case(replace(belt, normal_force=belt.normal_force * (alpha / belt.alpha)))
