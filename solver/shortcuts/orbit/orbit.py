"""A periodic orbit that a method of the paper computed, in SI units."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from ...arrays import Vector
from ...case.methods import about
from ..accuracy.errors import Errors, errors
from ..accuracy.estimate import Estimate, estimate
from ..names import METHODS as NAMES
from ..names import SCENE
from ..search.newton import Outcome
from . import admissible
from .amplitude import amplitude
from .extremes import extremes
from .methods import METHODS, Method, with_terms
from .motion import Motion
from .oscillator import StickSlip

#: The name that each method has in every scene.
GENERIC = {own: name for name, own in NAMES.items()}


@dataclass(frozen=True, eq=False, repr=False)
class Orbit(Motion):
    """A converged, admissible periodic orbit computed by one method of the paper.

    Parameters
    ----------
    belt : StickSlip
        The oscillator.
    method : {"hb", "hb-c1", "c1"}
        Section 3.1, 3.2 or 3.3.
    order : int
        ``N`` of (3), (11), (15).
    outcome : Outcome
        The dimensionless unknowns of the kernel, and how Newton's method found them.
    iterations : int
        Jacobians factorised in all, those of the way to the start included.
    c1_terms : int
        C1 functions of ``"hb-c1"``; the paper has one.
    """

    belt: StickSlip
    method: str
    order: int
    outcome: Outcome
    iterations: int
    c1_terms: int = 1

    @property
    def unknowns(self) -> Vector:
        """The dimensionless unknowns of the kernel: coefficients, ``t1``, ``T``."""
        return self.outcome.unknowns

    @property
    def _method(self) -> Method:
        return with_terms(METHODS[self.method], self.c1_terms)

    @property
    def period(self) -> float:
        """``T`` in s."""
        return float(self.unknowns[-1] * self.belt.time_unit)

    @property
    def t1(self) -> float:
        """End of stick in s."""
        return float(self.unknowns[-2] * self.belt.time_unit)

    @cached_property
    def amplitude(self) -> float:
        """Half of the way between the two ends of the motion, in m."""
        method, belt = self._method, self.belt
        return belt.length_unit * amplitude(method, self.order, belt.alpha, self.unknowns)

    @cached_property
    def extremes(self) -> dict[str, tuple[float, float]]:
        """Least and largest ``displacement`` in m and ``velocity`` in m/s over a period."""
        method, belt = self._method, self.belt
        ends = [extremes(method, self.order, belt.alpha, self.unknowns, j) for j in (0, 1)]
        (left, right), (back, forth) = ends
        centre, length, speed = belt.slip_centre, belt.length_unit, belt.belt_speed
        return {
            "displacement": (centre + length * left, centre + length * right),
            "velocity": (speed * back, speed * forth),
        }

    @property
    def converged(self) -> bool:
        """Whether Newton's method converged; an orbit that did not is not returned."""
        return self.outcome.converged

    @property
    def residual_norm(self) -> float:
        """Maximum norm of the dimensionless residual."""
        return self.outcome.residual_norm

    @cached_property
    def coefficients(self) -> dict[str, object]:
        """The paper's coefficients in SI units.

        ``hb``: ``a0``, ``a``, ``b`` of (3) in m; ``hb-c1``: those of (11), and ``c1`` of
        the printed ``g1`` in m/s**4 or, of several C1 functions, ``c``; ``c1``: ``d`` of
        (15), ``d[n]`` in m/s**(n+2).  ``a``, ``b``, ``c`` and ``d`` are lists.
        """
        return self._method.coefficients(self.unknowns, self.order, self.belt)

    @cached_property
    def violations(self) -> tuple[str, ...]:
        """What keeps the solution from being an orbit, in words."""
        return admissible.violations(self._method, self.order, self.belt, self.unknowns)

    @property
    def admissible(self) -> bool:
        """Whether the solution is an orbit: nothing in `violations`."""
        return not self.violations

    @property
    def transition_mismatch(self) -> float:
        """``K x(t1)/(mu_s F_N) - 1``: an error measure that needs no exact orbit.

        The static limit is ``x_s + A``, and ``A`` its part ``1 - mu_k/mu_s``.
        """
        t1 = self.unknowns[-2:-1]
        alpha = self.belt.alpha
        y = float(self._method.evaluate(self.unknowns, self.order, t1, 0, alpha)[0])
        return (y / alpha - 1) * (1 - self.belt.mu_k / self.belt.mu_s)

    @cached_property
    def errors(self) -> Errors:
        """Errors against the exact orbit: ``period``, ``t1``, ``acceleration`` (22)."""
        return errors(self._method, self.order, self.belt.alpha, self.unknowns)

    @cached_property
    def estimate(self) -> Estimate:
        """Errors as they are estimated without the exact orbit; see `estimate`."""
        return estimate(self._method, self.order, self.belt.alpha, self.outcome)

    def _dimensionless(self) -> tuple[float, float, Callable[[Vector, int], Vector]]:
        z, order, alpha = self.unknowns, self.order, self.belt.alpha
        t1, T = map(float, z[-2:])
        evaluate = self._method.evaluate
        return t1, T, lambda t, derivative: evaluate(z, order, t, derivative, alpha)

    def as_dict(self) -> dict[str, Any]:
        """Return the orbit as the document that ``solve --json`` writes."""
        from ....files.shortcuts.documents import of_solution  # noqa: PLC0415  (it reads this)

        return of_solution(self.belt, self.method, self.order, self)

    @property
    def label(self) -> str:
        """What a legend calls it: ``"c1, N = 7"``."""
        terms = f"({self.c1_terms})" if self.c1_terms > 1 else ""
        return f"{self.method}{terms}, N = {self.order}"

    @property
    def look(self) -> dict[str, Any]:
        """Of its curves in pictures: those of the method."""
        return about(GENERIC[self.method]).look

    @property
    def about(self) -> dict[str, Any]:
        """Scene, method, order and parameters, for tables and files."""
        terms = {"c1_terms": self.c1_terms} if self.c1_terms > 1 else {}
        return super().about | {"method": self.method, "order": self.order} | terms

    @property
    def facts(self) -> dict[str, str]:
        """What a notebook shows."""
        found = super().facts
        head = {name: found.pop(name) for name in ("scene", "parameters")}
        return head | {"method": self.label} | found | {
            "error (22) of the acceleration": f"{self.errors.acceleration:.1e}",
            "estimated error of the period": f"{self.estimate.period:.1e}",
        }  # fmt: skip

    @property
    def _identity(self) -> tuple[object, ...]:
        return self.belt, self.method, self.order, self.c1_terms, self.unknowns.tobytes()

    def __repr__(self) -> str:
        estimate = f"estimate {self.estimate.period:.1e}"
        return f"<{SCENE} by {self.label}: {self._times}, {estimate}>"

    def __str__(self) -> str:
        method = self._method
        return "\n".join(
            (
                f"{method.name} (Section {method.section}, {method.title}), N = {self.order}",
                f"  T  = {self.period:.10g} s   (T/T_exact - 1 = {self.errors.period:.3e})",
                f"  t1 = {self.t1:.10g} s   (t1/t1_exact - 1 = {self.errors.t1:.3e})",
                f"  acceleration error (22) = {self.errors.acceleration:.3e}",
                f"    with phases aligned   = {self.errors.acceleration_aligned:.3e}",
                f"  transition mismatch     = {self.transition_mismatch:.3e}",
                f"  estimated error of T    = {self.estimate.period:.1e}",
                f"  residual {self.residual_norm:.1e} after {self.iterations} iterations; "
                f"{'admissible' if self.admissible else '; '.join(self.violations)}",
            )
        )
