"""A solution of the equations of a method, in SI units; an orbit if it is admissible."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ..arrays import Vector
from ..iteration.newton import Outcome
from ..kernels import registry
from ..kernels.kernel import Kernel
from ..kernels.start import RoughTimes, solved
from ..scenes.case import Case
from ..scenes.methods import FIRST
from ..simulation.followers import not_followed
from . import admissible
from .allowance import by_neighbour, by_residual
from .errors import Errors, difference, times_apart
from .exact_orbit import ExactOrbit, from_times
from .shown import Shown

#: Difference of times, relative to the period, up to which an exact solution is the neighbour
#: of one of an expansion, and decides whether that one is an orbit.
FAR = 0.05

#: Order of a finer solution between one that is crude and the exact one.
FINER = 20


#: Why a solution is no orbit whose times lead to no exact one.
NOT_RESOLVED = ("its times lead to no exact orbit: the order does not resolve the motion",)


@dataclass(frozen=True, eq=False, repr=False)
class Solution(Shown):
    """The result of Newton's method for a case, a method and an order.

    Parameters
    ----------
    method : str
        Generic name of the method.
    order : int
        ``N`` of its expansion.
    outcome : Outcome
        The unknowns of the kernel, without units, and how Newton's method found them.
    iterations : int
        Jacobians factorised in all, including those for the starting values.
    functions : int or None
        Number of functions added to the harmonics at each switch; None if fixed by the method.
    """

    case: Case
    method: str
    order: int
    outcome: Outcome
    iterations: int
    functions: int | None = None

    @cached_property
    def _kernel(self) -> Kernel:
        return registry.kernel(self.case.scene, self.method, self.functions)

    @cached_property
    def _given(self) -> Any:
        """First argument of the kernel's functions."""
        return self._kernel.given(self.case, self.order)

    @property
    def unknowns(self) -> Vector:
        """The unknowns of the kernel, without units: coefficients, then times."""
        return self.outcome.unknowns

    @property
    def smoothness(self) -> str:
        """Class of the motion: ``"C0"`` where its velocity jumps, and so on."""
        return f"C{self.case.scene.k}"

    @property
    def converged(self) -> bool:
        """Whether Newton's method converged; an orbit that did not is not returned."""
        return self.outcome.converged

    @property
    def residual_norm(self) -> float:
        """Maximum norm of the residual, without units."""
        return self.outcome.residual_norm

    @cached_property
    def coefficients(self) -> dict[str, float | list[float]]:
        """The coefficients of the expansion by name, in SI units."""
        units = self.case.units
        coefficients: dict[str, float | list[float]] = {}
        memory = {q.name for q in self.case.cell.memory}
        for name, (values, power) in self._kernel.coefficients(self.unknowns).items():
            if name in memory:
                continue
            coefficients[name] = (np.asarray(values) * units.of_motion(power)).tolist()
        return coefficients

    @cached_property
    def violations(self) -> tuple[str, ...]:
        """Why the solution is not an orbit, in words; empty if it is one.

        Its own motion must violate no demand, and its exact neighbour must be an orbit.
        """
        if self.case.scene.has_body and self._neighbour is None:
            return ("no exact solution is next to it: the order does not resolve the contact",)
        return self.own_violations or self._disproof

    @cached_property
    def own_violations(self) -> tuple[str, ...]:
        """Violations of its own motion; for one mass the exact solution is not computed.

        Functions that begin at switches resolve the end of a phase to about 1 / (2 N), where
        its event is not imposed.
        """
        if self.case.scene.has_body:
            return admissible.violations(self, by_neighbour(self, self._exact_solution))
        unmet = 1 / (2 * self.order) if self._kernel.starts else 0.0
        return admissible.violations(self, by_residual(self), unmet)

    @cached_property
    def _disproof(self) -> tuple[str, ...]:
        """Violations of its exact neighbour; without one, of its own order of phases.

        It is no orbit if its times lead to no exact one at all.
        """
        near = self._neighbour
        if near is None:
            return NOT_RESOLVED if self.exact is None else not_followed(self)
        if near.admissible:
            return ()
        reason = f"the exact solution next to it is not an orbit: {'; '.join(near.violations)}"
        return (reason,)

    @property
    def admissible(self) -> bool:
        """Whether the solution is an orbit: nothing in `violations`."""
        return not self.violations

    @property
    def is_orbit(self) -> bool:
        """Whether Newton's method converged, and what it found is admissible."""
        return self.converged and self.admissible

    @cached_property
    def _exact_solution(self) -> ExactOrbit | None:
        """The exact solution to which its times lead; None if they lead to none.

        By Newton's method; where that leads far away, by way of a finer solution.
        """
        exact = from_times(self.case, _as_start(self))
        if not self._is_near(exact):
            kernel = registry.quicker_kernel(self.case.scene, FIRST, None, FINER)
            finer = attempt(kernel, self.case, FINER, self.times)
            beyond = from_times(self.case, _as_start(finer)) if finer.converged else exact
            exact = beyond if self._is_near(beyond) else exact
        return exact if exact.outcome.converged else None

    def _is_near(self, exact: ExactOrbit) -> bool:
        """Whether the times of an exact solution differ by at most `FAR`."""
        if not exact.outcome.converged:
            return False
        distance = times_apart(self, exact.cell_durations, exact.angle)
        return distance / self.case.cell.cells <= FAR

    @cached_property
    def _neighbour(self) -> ExactOrbit | None:
        """The exact solution, if its times differ by at most `FAR`; else None."""
        exact = self._exact_solution
        return exact if exact is not None and self._is_near(exact) else None

    @property
    def exact(self) -> ExactOrbit | None:
        """The exact orbit to which its times lead; None if they lead to none."""
        exact = self._exact_solution
        return exact if exact is not None and exact.admissible else None

    @cached_property
    def errors(self) -> Errors | None:
        """Errors against the exact orbit; None without one."""
        return None if self.exact is None else difference(self, self.exact, self.order)


def _as_start(solution: Solution) -> RoughTimes:
    """Return the times of a solution, to start from."""
    durations = tuple(map(float, solution.cell_durations))
    return RoughTimes(durations, solution.angle, "its own times")


def attempt(
    kernel: Kernel, case: Case, order: int, times: Vector, functions: int | None = None
) -> Solution:
    """Return the result of Newton's method from rough times; `admissible` tells if an orbit.

    Parameters
    ----------
    times : ndarray
        Durations and, if the scene is forced, the phase of the forcing; without units.
    functions : int, optional
        As in `Solution`.
    """
    with kernel.spending():
        arguments = kernel.given(case, order)
        outcome = solved(kernel, arguments, kernel.size(order), times)
    return Solution(case, kernel.method, order, outcome, outcome.iterations, functions)
