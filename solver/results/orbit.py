"""A periodic orbit of a scene that one method computed, in SI units."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

from ..accuracy.estimate import estimate
from ..existence.known import others
from ..orbit.errors import Errors
from ..orbit.exact_orbit import ExactOrbit
from ..orbit.solution import Solution
from ..scenes.methods import about, shown
from ..stability.in_words import in_words
from ..stability.stability import Stability
from .document import document


@dataclass(frozen=True, eq=False, repr=False)
class Orbit(Solution):
    """A periodic orbit of a case, computed by one method at one order: a `Solution` to keep."""

    @classmethod
    def of(cls, found: Solution) -> "Orbit":
        """Return a solution as what users hold of its case."""
        own = {q.name: getattr(found, q.name) for q in fields(found)}
        return found.case.presented(cls(**own))

    @property
    def further(self) -> Mapping[str, float]:
        """More numbers for rows and documents, by the names that the case has for them."""
        return {}

    @property
    def confirmed(self) -> bool:
        """Whether it is an orbit, and near one: the exact one, or one of higher order."""
        if not (self.converged and self.admissible):
            return False
        return self.exact is not None or math.isfinite(self.estimate.times)

    @property
    def others(self) -> list[ExactOrbit]:
        """Exact orbits of the same oscillator, of any motion, that are known beside this one.

        All there are where all solutions of the exact equations can be listed: of one or two
        phases under a forcing.
        """
        return [] if self.exact is None else others(self.exact)

    @cached_property
    def estimate(self) -> Errors:
        """Errors as they are estimated, of one mass without the exact orbit; see `estimate`."""
        return estimate(self)

    @cached_property
    def stability(self) -> Stability:
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

    def __repr__(self) -> str:
        name = shown(self.case.scene, self.method)
        head = f"{self.case.scene.label} by {name}, N = {self.order}"
        if not self.converged:
            return f"<{head}: not converged: {self.outcome.reason}>"
        words = f"{self._times}{self._verdict}"
        return f"<{head}: {words}, estimate {self.estimate.times:.1e}>"
