"""The lowest order of a method whose estimated errors are within a tolerance."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..accuracy.estimate import ROUNDING
from ..exact import ExactOrbit, exact_orbit
from ..existence.known import known_orbits
from ..kernels import registry
from ..no_orbit import NoOrbit
from ..orbit import solution
from ..orbit.errors import Errors, difference
from ..orbit.solution import attempt
from ..results.orbit import Orbit
from ..scenes.case import Case
from ..scenes.methods import FIRST, about, shown
from ..scenes.parameter_error import is_number, repeated
from ..search import COARSE, HIGHEST_ORDER, Search
from ..solve import number_of_functions, solve_case, with_motion
from .choice import MARGIN, Choice, NotCertified, Trial, size

#: Up to `EVERY` all orders are tried; beyond, the step is `STEP` times the order.
EVERY, STEP = 24, 0.15

#: The same for bodies, whose errors take long to estimate.
EVERY_OF_BODIES, STEP_OF_BODIES = 3, 0.5

#: If over the last `PATIENCE` orders the least error is more than `LEAST_FALL` times that
#: before, the errors do not fall any more.
PATIENCE, LEAST_FALL = 8, 0.9

#: Error above which the order may not resolve the waves of the motion: errors may fall later.
RESOLVED = 1e-3

#: Least rate p of errors ``N^-p`` that have begun to converge: that of times is 1 at least.
SLOWEST = 0.75

#: The search ends if the order needed is so many times the highest, or at low orders, so many.
FAR, FAR_AT_FIRST = 2, 30


def choose_order(
    case: Case, tol: float, method: str = FIRST, functions: int | None = None
) -> Choice:
    """Return the orbit of the lowest order, of those tried, that meets a tolerance.

    Parameters
    ----------
    case : Case
        The oscillator.
    tol : float
        Largest estimated error of the times and of the period, relative to the period, and of
        the displacement at switches, relative to the largest.
    method, functions : str, int
        See `solve_case`.

    Raises
    ------
    ValueError
        If `tol` is not between 0 and 1, or there is no such method.
    NotCertified
        If no order that can be computed meets it, or it is below rounding.
    NoOrbit
        If no order that was tried has an orbit.
    """
    if not (is_number(tol) and 0 < tol < 1):
        raise ValueError(f"tol: got {repeated(tol)}, expected a number between 0 and 1")
    case = with_motion(case)
    name = registry.generic_method(case.scene, method)
    count = number_of_functions(case, name, None) if functions is None else functions
    kernel = registry.kernel(case.scene, name, count)
    search = _Search(case, tol, name, count, [])
    if MARGIN * tol <= ROUNDING:
        raise NotCertified(tol, (), math.nan)
    last = kernel.lowest
    for order in search.orders(kernel.lowest):
        orbit = search.meets(order)
        if orbit is not None:
            orbit = search.lowest(last, order, orbit)
            return Choice(orbit, tuple(search.trials))
        if search.hopeless():
            break
        last = order
    if search.finding is not None and not search.known():
        raise search.finding
    raise NotCertified(tol, tuple(search.trials), search.needed())


@dataclass
class _Search:
    case: Case
    tol: float
    method: str
    functions: int | None
    trials: list[Trial]
    finding: NoOrbit | None = None

    def orders(self, lowest: int) -> Iterator[int]:
        """Yield the orders to try, ending with the highest.

        Above `COARSE`, as long as none had an orbit, they are doubled: a short phase may need
        a high order.
        """
        of_body, order = self.case.scene.has_body, lowest
        every, step = (EVERY_OF_BODIES, STEP_OF_BODIES) if of_body else (EVERY, STEP)
        while order < HIGHEST_ORDER:
            yield order
            if order > max(COARSE) and not self.known():
                order *= 2
            else:
                order += 1 if order < every else math.ceil(step * order)
        yield HIGHEST_ORDER

    def meets(self, order: int) -> Orbit | None:
        """Return the orbit of an order if it is within the tolerance; note the trial."""
        far = self._beyond(order)
        orbit = None if far is not None else self._orbit(order)
        method = self.method if orbit is None else orbit.method
        errors = far if orbit is None else orbit.estimate
        self.trials.append(Trial(shown(self.case.scene, method), order, errors))
        within = orbit is not None and size(orbit.estimate) <= MARGIN * self.tol
        return orbit if within else None

    def _orbit(self, order: int) -> Orbit | None:
        """Return the orbit of an order; None if none is found.

        Above `COARSE`, after an order without an orbit, only the exact orbit is a start.
        """
        behind_none = bool(self.trials) and self.trials[-1].estimate is None
        if not (order > max(COARSE) and behind_none and self._exact):
            try:
                return solve_case(self.case, self.method, order, self.functions)
            except NoOrbit as finding:
                self.finding = finding
                return None
        words = "the times of the exact orbit"
        search = Search(self._exact.case, self.method, order, self.functions, words)
        orbit = search.orbit(self._exact.times)
        if orbit is None and self.finding is not None:
            self.finding.tried += tuple(search.tried)
        return orbit

    def _beyond(self, order: int) -> Errors | None:
        """Return the errors of a body's solution against its exact orbit, if too large.

        Then they need not be estimated, which takes longer than the solution.
        """
        exact = next(iter(known_orbits(self.case)), None) if self.case.scene.has_body else None
        if exact is None:
            return None
        kernel = registry.kernel(exact.case.scene, self.method, self.functions)
        solution_ = attempt(kernel, exact.case, order, exact.times, self.functions)
        errors = difference(solution_, exact, order) if solution_.converged else None
        if errors is None or errors.times > solution.FAR or size(errors) <= self.tol:
            return None
        return errors

    def lowest(self, fails: int, meets: int, orbit: Orbit) -> Orbit:
        """Return the orbit of the lowest order within the tolerance, by bisection.

        `orbit` is that of the order `meets`; the order `fails` is not within the tolerance.
        """
        while meets - fails > 1:
            middle = (fails + meets) // 2
            candidate = self.meets(middle)
            if candidate is None:
                fails = middle
            else:
                meets, orbit = middle, candidate
        return orbit

    def known(self) -> list[tuple[int, float]]:
        """Return the orders with finite error estimates, and the errors."""
        sizes = [(t.order, size(t.estimate)) for t in self.trials if t.estimate is not None]
        return [(order, error) for order, error in sizes if math.isfinite(error)]

    def needed(self) -> float:
        """Return the order at which the errors would meet the tolerance, by extrapolation.

        Infinite if they do not fall any more; 0 if they converge geometrically, or if too few
        orders are known.
        """
        pairs, last = self.known(), self.trials[-1].order
        if len(pairs) < 2 * PATIENCE:
            return 0.0
        before = min(error for _, error in pairs[:-PATIENCE])
        resolved = before < RESOLVED or last > 4 * EVERY
        if resolved and min(error for _, error in pairs[-PATIENCE:]) > LEAST_FALL * before:
            return math.inf
        if not about(self.method).power:
            return 0.0
        orders, errors = np.log(np.array(pairs[len(pairs) // 2 :])).T
        power, at_1 = np.polyfit(orders, errors, 1)
        if power > -SLOWEST:
            return 0.0
        return float(np.exp(min((math.log(MARGIN * self.tol) - at_1) / power, 700.0)))

    @cached_property
    def _exact(self) -> ExactOrbit | None:
        """The exact orbit; None if none is found."""
        try:
            return exact_orbit(self.case)
        except NoOrbit:
            return None

    def hopeless(self) -> bool:
        """Whether no computable order can be expected to do; see `FAR`."""
        if not self.known():
            return self.trials[-1].order > max(COARSE) and self._exact is None
        far = FAR if self.trials[-1].order > 2 * EVERY else FAR_AT_FIRST
        return self.needed() > far * HIGHEST_ORDER
