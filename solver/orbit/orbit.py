"""A periodic orbit of a scene that one method computed, in SI units."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from ..accuracy.errors import Errors, difference
from ..arrays import Vector
from ..case import registry
from ..case.case import Case
from ..case.kernel import Kernel
from ..case.methods import about
from ..case.names import shown
from ..flow.exact_motion import ExactOrbit, from_times
from ..iteration.newton import Outcome
from ..iteration.start import RoughTimes
from ..scaling import product_of_powers
from ..stability.words import in_words
from . import admissible
from .allowance import by_residual
from .document import document
from .motion import Motion

if TYPE_CHECKING:
    from ..stability.stability import Stability

#: Error of the times, as a part of the period, above which an exact solution is not next to one
#: of an expansion: whether that one is an orbit is not decided by it.
FAR = 0.05


@dataclass(frozen=True, eq=False, repr=False)
class Orbit(Motion):
    """A periodic orbit of a case, computed by one method at one order.

    Parameters
    ----------
    case : Case
        The oscillator.
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

    @property
    def unknowns(self) -> Vector:
        """The unknowns of the kernel, without units: coefficients, then times."""
        return self.outcome.unknowns

    @property
    def cell_durations(self) -> Vector:
        """Durations of the phases of the cell, without units."""
        return self._kernel.split(self.unknowns)[0]

    @property
    def angle(self) -> float:
        """Phase of the forcing at the first switch, anywhere on the circle."""
        return self._kernel.split(self.unknowns)[1]

    def _part(self, p: int, u: Vector, derivative: int) -> Vector:
        """Return a derivative of the displacement on phase `p` of the cell, without units."""
        values = self._kernel.motion(self.case.arguments, self.unknowns, p, u, derivative)
        return np.broadcast_to(np.asarray(values, dtype=float), np.shape(u))

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

    @property
    def further(self) -> Mapping[str, float]:
        """More numbers for rows and documents, by the names that the case has for them."""
        return {}

    @cached_property
    def violations(self) -> tuple[str, ...]:
        """What keeps the solution from being an orbit, in words.

        What its own residual excuses is bounded by the exact solution next to it: if that one
        is not an orbit, neither is this.  Functions that begin at switches resolve the end of a
        phase to about one part in 2 N where its event is not imposed.
        """
        unmet = 1 / (2 * self.order) if self._kernel.starts else 0.0
        return admissible.violations(self, by_residual(self), unmet) or self._disproof

    @cached_property
    def _disproof(self) -> tuple[str, ...]:
        """What the exact solution next to this one violates."""
        near = self._exact_solution
        if near is None or near.admissible:
            return ()
        if difference(self, near, self.order).times > FAR:
            return ()
        words = f"the exact solution next to it is not an orbit: {'; '.join(near.violations)}"
        return (words,)

    @property
    def admissible(self) -> bool:
        """Whether the solution is an orbit: nothing in `violations`."""
        return not self.violations

    @property
    def confirmed(self) -> bool:
        """Whether it is an orbit, and near one: the exact one, or one of higher order."""
        if not (self.converged and self.admissible):
            return False
        return self.exact is not None or math.isfinite(self.estimate.times)

    @cached_property
    def _exact_solution(self) -> ExactOrbit | None:
        """The solution of the exact equations to which its times lead, if to one."""
        own = RoughTimes(tuple(map(float, self.cell_durations)), self.angle, "its own times")
        found = from_times(self.case, own)
        return found if found.outcome.converged else None

    @property
    def exact(self) -> ExactOrbit | None:
        """The exact orbit next to this one; None if there is none to be found."""
        found = self._exact_solution
        return found if found is not None and found.admissible else None

    @property
    def others(self) -> list[ExactOrbit]:
        """Exact orbits of the same oscillator, of any motion, that are known beside this one.

        All there are where all solutions of the exact equations can be listed: of one or two
        phases under a forcing.
        """
        from ..flow.known import others  # noqa: PLC0415  (it reads exact orbits)

        return [] if self.exact is None else others(self.exact)

    @cached_property
    def errors(self) -> Errors | None:
        """Errors against the exact orbit; None if there is none to be found."""
        return None if self.exact is None else difference(self, self.exact, self.order)

    @cached_property
    def estimate(self) -> Errors:
        """Errors as they are estimated without the exact orbit; see `estimate`."""
        from ..accuracy.estimate import estimate  # noqa: PLC0415  (it computes orbits)

        return estimate(self)

    @cached_property
    def stability(self) -> "Stability":
        """What a period of the exact orbit next to this one makes of small perturbations.

        Multipliers belong to the exact orbit that this one approximates.  At its own times and
        states they have its errors, which grow where an event is crossed slowly: the saltation
        divides by the rate there.  They stand in only where no exact orbit is found.

        Raises
        ------
        NoMultipliersError
            If an event is touched and not crossed, or a check of the computation failed.
        """
        return super().stability if self.exact is None else self.exact.stability

    def as_dict(self) -> dict[str, Any]:
        """Return the orbit as the document that ``solve --json`` writes."""
        return document(self)

    @property
    def label(self) -> str:
        """What a legend calls it: ``"c0-tau, N = 10"``."""
        return f"{shown(self.case.scene, self.method)}, N = {self.order}"

    @property
    def look(self) -> dict[str, Any]:
        """Of its curves in pictures: those of the method."""
        return about(self.method).look

    @property
    def about(self) -> dict[str, Any]:
        """Scene, method, order and parameters, for tables and files."""
        also = {} if self.functions is None else {"functions": self.functions}
        return super().about | {"method": self.method, "order": self.order} | also

    @property
    def facts(self) -> dict[str, str]:
        """What a notebook shows."""
        found = super().facts
        head = {name: found.pop(name) for name in ("scene", "parameters")}
        return head | {"method": self.label} | found | {
            "stability": in_words(self),
            "estimated error of the times": f"{self.estimate.times:.1e}",
        }  # fmt: skip

    @property
    def _identity(self) -> tuple[object, ...]:
        return self.case, self.method, self.order, self.functions, self.unknowns.tobytes()

    def __repr__(self) -> str:
        name = shown(self.case.scene, self.method)
        head = f"{self.case.scene.label} by {name}, N = {self.order}"
        if not self.converged:
            return f"<{head}: not converged: {self.outcome.reason}>"
        return f"<{head}: {self._times}, estimate {self.estimate.times:.1e}>"
