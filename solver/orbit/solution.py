"""A solution of a method's equations for a case, in SI units: an orbit if it is admissible."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ..arrays import Vector
from ..iteration.newton import Outcome
from ..kernels import registry
from ..kernels.kernel import Kernel
from ..kernels.start import RoughTimes, solved
from ..scaling import product_of_powers
from ..scenes.case import Case
from ..simulation.followers import not_followed
from . import admissible
from .allowance import by_neighbour, by_residual
from .errors import Errors, difference, times_apart
from .exact_orbit import ExactOrbit, from_times
from .shown import Shown

#: Error of the times, as a part of the period, above which an exact solution is not next to one
#: of an expansion: whether that one is an orbit is not decided by it.
FAR = 0.05


@dataclass(frozen=True, eq=False, repr=False)
class Solution(Shown):
    """Where Newton's method led, for a case, a method and an order.

    Parameters
    ----------
    method : str
        Generic name of the method.
    order : int
        ``N`` of its expansion.
    outcome : Outcome
        The unknowns of the kernel, without units, and how Newton's method found them.
    iterations : int
        Jacobians factorised in all, those of the way to the start included.
    functions : int or None
        Functions beside the harmonics at each switch, where the method counts them.
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
        """What the functions of the kernel take for the case."""
        return self._kernel.given(self.case, self.order)

    @property
    def unknowns(self) -> Vector:
        """The unknowns of the kernel, without units: coefficients, then times."""
        return self.outcome.unknowns

    @property
    def memory_values(self) -> tuple[float, ...]:
        """What the switches set, without units, in the order of the cell's memory."""
        found = self._kernel.coefficients(self.unknowns)
        return tuple(float(found[memory.name][0]) for memory in self.case.cell.memory)

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
        found: dict[str, float | list[float]] = {}
        memory = {q.name for q in self.case.cell.memory}
        for name, (values, power) in self._kernel.coefficients(self.unknowns).items():
            if name in memory:
                continue
            unit = product_of_powers(units.length, (units.time, -power))
            found[name] = (np.asarray(values, dtype=float) * unit).tolist()
        return found

    @cached_property
    def violations(self) -> tuple[str, ...]:
        """What keeps the solution from being an orbit, in words.

        What its own residual excuses is bounded by the exact solution next to it: if that one
        is not an orbit, neither is this.  Functions that begin at switches resolve the end of a
        phase to about one part in 2 N where its event is not imposed.
        """
        if self.case.scene.has_body and self._neighbour is None:
            return ("no exact solution is next to it: the order does not resolve the contact",)
        return self.own_violations or self._disproof

    @cached_property
    def own_violations(self) -> tuple[str, ...]:
        """What keeps it from being one by its own motion; the exact one is not asked."""
        if self.case.scene.has_body:
            return admissible.violations(self, by_neighbour(self, self._exact_solution))
        unmet = 1 / (2 * self.order) if self._kernel.starts else 0.0
        return admissible.violations(self, by_residual(self), unmet)

    @cached_property
    def _disproof(self) -> tuple[str, ...]:
        """What the exact solution next to it violates; where there is none, its own order."""
        near = self._neighbour
        if near is None:
            return not_followed(self)
        if near.admissible:
            return ()
        words = f"the exact solution next to it is not an orbit: {'; '.join(near.violations)}"
        return (words,)

    @property
    def admissible(self) -> bool:
        """Whether the solution is an orbit: nothing in `violations`."""
        return not self.violations

    @cached_property
    def _exact_solution(self) -> ExactOrbit | None:
        """The solution of the exact equations to which its times lead, if to one."""
        own = RoughTimes(tuple(map(float, self.cell_durations)), self.angle, "its own times")
        found = from_times(self.case, own)
        return found if found.outcome.converged else None

    @cached_property
    def _neighbour(self) -> ExactOrbit | None:
        """The same, if it is next to this one."""
        near = self._exact_solution
        if near is None:
            return None
        off = times_apart(self, near.cell_durations, near.angle) / self.case.cell.cells
        return near if off <= FAR else None

    @property
    def exact(self) -> ExactOrbit | None:
        """The exact orbit next to this one; None if there is none to be found."""
        found = self._exact_solution
        return found if found is not None and found.admissible else None

    @cached_property
    def errors(self) -> Errors | None:
        """Errors against the exact orbit; None if there is none to be found."""
        return None if self.exact is None else difference(self, self.exact, self.order)


def attempt(
    kernel: Kernel, case: Case, order: int, times: Vector, functions: int | None = None
) -> Solution:
    """Return where Newton's method leads from rough times: an orbit only if it says so.

    Parameters
    ----------
    times : ndarray
        Durations and, if the scene is forced, the phase of the forcing; without units.
    functions : int, optional
        See `Solution`.
    """
    with kernel.spending():
        given = kernel.given(case, order)
        outcome = solved(kernel, given, kernel.size(order), times)
    return Solution(case, kernel.method, order, outcome, outcome.iterations, functions)
