"""The search for an orbit of a case of one motion by one method, from several starts."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from itertools import chain, islice, product

import numpy as np

from .arrays import Vector
from .bodies.harmonics.system import mean_fixes
from .exact import ExactOrbit, exact_orbit, prefers_stable, starts
from .existence.known import known
from .existence.reasons import not_decided, shown_to_be_none, without_switches
from .kernels import registry
from .kernels.kernel import Kernel
from .kernels.start import PATIENCE, RoughTimes, is_reversible, is_singular, rough_times
from .no_orbit import NoOrbit
from .orbit.solution import Solution, attempt
from .results.orbit import Orbit
from .scenes.bodies.cell import BodyCell
from .scenes.case import Case
from .scenes.methods import FIRST, about
from .scenes.parameter_error import whole

#: Orders of the coarse orbits from whose times all methods start.  At the first Newton's method
#: converges from rough times; a motion with many waves needs the second.
COARSE = (5, 12)

#: Added to these orders for each further cycle of the forcing.
WAVES = 4

#: Highest order: beyond, the dense linear systems take seconds and nothing is gained.
HIGHEST_ORDER = 400


def search_of(case: Case, method: str, order: int, functions: int | None) -> "Search":
    """Return the search for an orbit of a case of one motion, with the order checked."""
    kernel = registry.kernel(case.scene, method, functions)
    return Search(case, method, check_order(kernel, order), functions)


@dataclass
class Search:
    """A search for an orbit of a case of one motion, and the outcome of each start.

    `words` describe the start in use, `iterations` counts those so far, `exact` tells that an
    exact orbit is known, `tried` has the reason why each start failed, `unstable` is the first
    orbit found if a stable one is preferred.
    """

    case: Case
    method: str
    order: int
    functions: int | None
    words: str = ""
    iterations: int = 0
    exact: bool = False
    tried: list[str] = field(default_factory=list)
    unstable: Orbit | None = None

    @cached_property
    def kernel(self) -> Kernel:
        """The method's kernel, compiled or not, whichever is quicker now."""
        return registry.quicker_kernel(self.case.scene, self.method, self.functions, self.order)

    def run(self) -> Orbit:
        """Return the orbit of the first start that leads to one.

        In an undeclared order a stable one, if simulations lead to one.

        Raises
        ------
        NoOrbit
            If none does; with the reason for each.
        """
        for times in self.starts():
            orbit = self.orbit(times)
            if orbit is not None and not prefers_stable(self.case, orbit):
                return orbit
            self.unstable = self.unstable or orbit
        if self.unstable is not None:
            return self.unstable
        name = f"{self.case.scene.label}, {self.kernel.method}, N = {self.order}"
        words = "; ".join([f"{name}: no admissible orbit was found", *self._what_else()])
        tried = tuple(dict.fromkeys(self.tried))
        proven = shown_to_be_none(self.case, tried)
        proven = proven or self.case.none(self.method, self.order, tried)
        error = proven or NoOrbit(words, False, tried)
        error.iterations = self.iterations
        raise error

    def _what_else(self) -> Iterator[str]:
        """Yield further reasons why no orbit was found, where any are known."""
        cell, series = self.case.cell, about(self.method).is_series
        if series and isinstance(cell, BodyCell) and not mean_fixes(cell):
            yield (
                f"{self.kernel.method} cannot compute one: nothing damps or holds a motion "
                "that repeats with the forcing, and no mean contact force determines it"
            )
            return
        if self.exact or known(self.case).orbits:
            yield "there is an exact orbit, and from its times there is no way to one"
            yield "a higher order may have it, or a tolerance in place of the order"
            return
        yield from not_decided(self.case)
        yield from without_switches(self.case)

    def from_exact(self, exact: ExactOrbit) -> Orbit | None:
        """Return the orbit of the method next to an exact one; None if there is none."""
        self.exact, self.words = True, "the times of the exact orbit"
        starts = chain([exact.times], self.aside(exact.times))
        return next((orbit for orbit in map(self.orbit, starts) if orbit is not None), None)

    def aside(self, times: Vector) -> Iterator[Vector]:
        """Yield times with one switch moved by half a period of the highest harmonic.

        Where the velocity jumps, the times of harmonics have errors of that size, and Newton's
        method may not reach them from the exact times.  Other methods have none to yield.
        """
        count = len(self.case.cell.phases)
        if count == 1 or not about(self.method).is_series:
            return
        wave = times[:count].sum() * self.case.cell.cells / self.order
        for p, step in product(range(count), (wave / 2, -wave / 2)):
            moved = times.copy()
            moved[p - 1 if p else count - 1] += step
            moved[p] -= step
            if p == 0 and self.case.cell.forced:
                moved[-1] += self.case.cell.omega * step
            self.words = "the times of the exact orbit, one of them half a wave aside"
            if moved[:count].min() > 0:
                yield moved

    def orbit(self, times: Vector) -> Orbit | None:
        """Return the orbit to which Newton's method leads from times; None if to none."""
        orbit = self.note(attempt(self.kernel, self.case, self.order, times, self.functions))
        if not orbit.is_orbit:
            orbit = self.less_smooth(orbit, times)
        return orbit if orbit.is_orbit else None

    def note(self, solution: Solution) -> Orbit:
        """Return a result with the iterations of all starts; if it failed, note the reason."""
        total = self.iterations + solution.outcome.iterations
        orbit = Orbit.of(replace(solution, iterations=total))
        self.count(orbit)
        return orbit

    def count(self, solution: Solution) -> None:
        """Count the iterations of a result; if it failed, note the reason.

        Of a coarse result only its own violations count: its exact neighbour is not computed.
        """
        self.iterations += solution.outcome.iterations
        why = "" if solution.converged else solution.outcome.reason
        complete = isinstance(solution, Orbit)
        why = why or "; ".join(solution.violations if complete else solution.own_violations)
        if why:
            self.tried.append(
                f"from {self.words}: {solution.method}, N = {solution.order}: {why}"
            )

    def less_smooth(self, failed: Orbit, times: Vector) -> Orbit:
        """Return the orbit by functions of class C^1, if the smoother method is singular.

        That is so if its Jacobian at the times of the C^1 orbit is.  Else, or without such an
        orbit, the failed result is returned.
        """
        name = registry.class_one(self.case.scene, failed.method)
        if name is None:
            return failed
        kernel = registry.kernel(self.case.scene, name)
        orbit = self.note(attempt(kernel, self.case, failed.order, times))
        if orbit.converged and is_singular(self.kernel, self.case, failed.order, orbit.times):
            return orbit
        return failed

    def starts(self) -> Iterator[Vector]:
        """Yield times to start from: those of coarse orbits and of simulations.

        For the order see `exact.starts`.  The last are those of the exact orbit, which may be
        found where no coarse one is.
        """
        rough = () if self.case.scene.has_body else self._coarse()
        with_exact = self.exact or known(self.case).orbits  # what simulations do says no more
        tried = [] if with_exact else self.tried
        for words, times in starts(self.case, rough, tried, lambda: self.unstable is not None):
            self.words = words
            yield self._vector(times)
        if self.case.scene.has_body or known(self.case).listed or self.unstable is not None:
            return
        try:
            exact = exact_orbit(self.case)
        except NoOrbit:
            return
        self.exact, self.words = True, "the times of the exact orbit"
        yield exact.times

    def _coarse(self) -> Iterator[RoughTimes]:
        """Yield the times of coarse orbits, from rough times."""
        class_one = registry.class_one(self.case.scene, FIRST)
        method = (is_reversible(self.case.cell) and class_one) or FIRST
        waves = WAVES * (self.case.cycles - 1)
        trials = product([q + waves for q in COARSE], rough_times(self.case.cell))
        for order, rough in islice(trials, PATIENCE if known(self.case).listed else None):
            self.words = rough.words
            coarse = _coarse_orbit(self.case, method, order, tuple(self._vector(rough)))
            self.count(coarse)
            if coarse.converged and not coarse.own_violations:
                yield RoughTimes(tuple(coarse.cell_durations), coarse.angle, rough.words)

    def _vector(self, times: RoughTimes) -> Vector:
        """Return times as a vector: durations and, with a forcing, its phase."""
        return np.array([*times.durations, *([times.angle] if self.kernel.forced else [])])


@lru_cache(maxsize=512)
def _coarse_orbit(case: Case, method: str, order: int, times: tuple[float, ...]) -> Solution:
    """Return the result of a coarse method from rough times; cached for all methods."""
    kernel = registry.quicker_kernel(case.scene, method, None, order)
    return attempt(kernel, case, order, np.array(times))


def check_order(kernel: Kernel, value: object) -> int:
    """Return an order as an int.

    Raises
    ------
    ValueError
        If it is no whole number from the method's lowest order to `HIGHEST_ORDER`.
    """
    return whole("order", value, kernel.lowest, HIGHEST_ORDER, f" for {kernel.method}")
