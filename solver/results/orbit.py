"""A periodic orbit of a scene that one method computed, in SI units."""

from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any, ClassVar

from ..accuracy.estimate import estimate
from ..existence.known import others
from ..orbit.errors import Errors
from ..orbit.exact_orbit import ExactOrbit
from ..orbit.solution import Solution
from ..scenes.methods import about, shown
from ..stability.monodromy import NoMultipliersError
from ..stability.stability import Stability
from .document import document


@dataclass(frozen=True, eq=False, repr=False)
class Orbit(Solution):
    """A periodic orbit of a case, computed by one method at one order."""

    _role: ClassVar[str] = "method"

    @classmethod
    def of(cls, solution: Solution) -> "Orbit":
        """Return a solution as the orbit that users of its case get."""
        values = {q.name: getattr(solution, q.name) for q in fields(solution)}
        return solution.case.presented(cls(**values))

    @property
    def further(self) -> Mapping[str, float]:
        """Further numbers for rows and documents, by name; none but in subclasses."""
        return {}

    @property
    def others(self) -> list[ExactOrbit]:
        """Other known exact orbits of the same oscillator, of any motion.

        These are all there are if the solutions of the exact equations can be listed: for one
        or two phases with forcing.
        """
        return [] if self.exact is None else others(self.exact)

    @cached_property
    def estimate(self) -> Errors:
        """Estimated errors, for one mass without the exact orbit; see `accuracy.estimate`."""
        return estimate(self)

    @cached_property
    def stability(self) -> Stability:
        """The Floquet multipliers of the exact orbit next to this one, with their rounding.

        At its own times and states they would have its errors, amplified where an event is
        crossed slowly, for the saltation matrix divides by the rate there.

        Raises
        ------
        NoMultipliersError
            If no exact orbit is found next to it, an event is touched and not crossed, or a
            check of the computation failed.
        """
        if self.exact is None:
            raise NoMultipliersError("no exact orbit is found next to it")
        return self.exact.stability

    def as_dict(self) -> dict[str, Any]:
        """Return the orbit as the document that ``solve --json`` writes."""
        return document(self)

    @property
    def label(self) -> str:
        """Name in a legend: ``"c0-tau, N = 10"``."""
        return f"{shown(self.case.scene, self.method)}, N = {self.order}"

    @property
    def look(self) -> dict[str, Any]:
        """Style of its curve in pictures, that of the method."""
        return about(self.method).look

    @property
    def about(self) -> dict[str, Any]:
        """Scene, method, order and parameters, for tables and files."""
        also = {} if self.functions is None else {"functions": self.functions}
        return super().about | {"method": self.method, "order": self.order} | also

    @property
    def facts(self) -> dict[str, str]:
        """Lines that a notebook shows."""
        return super().facts | {"estimated error of the times": f"{self.estimate.times:.1e}"}

    def __repr__(self) -> str:
        name = shown(self.case.scene, self.method)
        head = f"{self.case.scene.label} by {name}, N = {self.order}"
        if not self.converged:
            return f"<{head}: not converged: {self.outcome.reason}>"
        words = f"{self._times}{self._verdict}"
        return f"<{head}: {words}, estimate {self.estimate.times:.1e}>"
