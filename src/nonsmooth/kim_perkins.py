"""The oscillator of Kim & Perkins (2003) under the names and symbols of the paper.

`StickSlip` is the case of the scene ``stick-slip``.  Its orbits are those of any case, and have
besides what the paper prints: `t1`, the coefficients of (3), (11), (15), the measure (22).

W.-J. Kim and N. C. Perkins, J. Sound Vib. 261 (2003) 213-224.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from functools import cached_property, partial
from typing import Any, Self

from .all_solutions import solutions
from .solver.kernels.registry import load
from .solver.no_orbit import NoOrbit
from .solver.orbit.errors import Errors, acceleration_error, difference
from .solver.orbit.exact_orbit import ExactOrbit
from .solver.orbit.motion import Motion
from .solver.orbit.solution import Solution
from .solver.results.orbit import Orbit
from .solver.scaling import product_of_powers
from .solver.scenes.case import Case
from .solver.scenes.methods import shown
from .solver.scenes.parameter_error import ParameterError

#: The scene, and its parameters in Section 4.  The paper does not give F_N; 400 N is assumed:
#: it makes alpha = 1, and is the roundest force at which nearly all claims of Fig. 4 hold.
SCENE = "stick-slip"
SECTION_4 = {
    "mass": 10.0, "stiffness": 1000.0, "belt_speed": 1.0, "mu_s": 0.5, "mu_k": 0.25,
    "normal_force": 400.0,
}  # fmt: skip
CHOICE = "F_N = 400 N is assumed; the paper does not give it (see `nonsmooth report`)."

#: The methods of the paper: sections, and what a table calls them.
METHODS = {
    "hb": ("3.1", "Fourier series"),
    "hb-c1": ("3.2", "Fourier series + one C¹ function"),
    "c1": ("3.3", "C¹ functions"),
}

#: Beyond, the durations of stick and slip differ by so much that float64 cannot hold both.
SMALLEST_ALPHA, LARGEST_ALPHA = 1e-8, 1e8

#: Highest order at which all solutions of (18) to (20) are isolated: it takes a second.
MOST_ISOLATED = 12


class StickSlip(Case):
    """A mass on a moving belt, held by a spring, with Coulomb friction (Fig. 1).

    Parameters
    ----------
    mass : float
        ``M`` in kg.
    stiffness : float
        ``K`` in N/m.
    belt_speed : float
        ``V`` in m/s.
    mu_s, mu_k : float
        Static and kinetic coefficient of friction, ``0 <= mu_k < mu_s``.
    normal_force : float
        ``F_N`` in N.

    Raises
    ------
    ParameterError
        A `ValueError`: if a parameter is not a finite number in its range, all of them named at
        once, or if ``mu_k >= mu_s``.

    Examples
    --------
    >>> belt = StickSlip(mass=10, stiffness=1000, belt_speed=1,
    ...                  mu_s=0.5, mu_k=0.25, normal_force=400)
    >>> round(belt.alpha, 12)
    1.0
    """

    mass: float
    stiffness: float
    belt_speed: float
    mu_s: float
    mu_k: float
    normal_force: float

    own_numbers = ("t1",)
    own_errors = ("t1", "acceleration", "acceleration_aligned")

    def __init__(
        self, *, mass: float, stiffness: float, belt_speed: float, mu_s: float, mu_k: float,
        normal_force: float,
    ) -> None:  # fmt: skip
        values = (mass, stiffness, belt_speed, mu_s, mu_k, normal_force)
        super().__init__(load(SCENE), dict(zip(SECTION_4, values, strict=True)))
        for name, value in self.values.items():
            object.__setattr__(self, name, value)
        self._check()

    def _check(self) -> None:
        """Check that there is a drop of friction, and that float64 holds stick and slip."""
        if self.mu_k == self.mu_s:
            words = (
                f"mu_k: got {self.mu_k!r}, expected less than mu_s = {self.mu_s!r}; without a "
                "drop from static to kinetic friction there is no stick-slip"
            )
            raise ParameterError([words])
        if not SMALLEST_ALPHA <= self.alpha <= LARGEST_ALPHA:
            words = (
                f"parameters: their alpha is {self.alpha!r}, expected {SMALLEST_ALPHA:g} to "
                f"{LARGEST_ALPHA:g}; beyond, stick or slip is too short a part of the period"
            )
            raise ParameterError([words])

    def __repr__(self) -> str:
        words = ", ".join(f"{name}={value!r}" for name, value in self.values.items())
        return f"StickSlip({words})"

    def __reduce__(self) -> tuple[object, tuple[object, ...]]:
        return partial(StickSlip, **self.values), ()

    @property
    def alpha(self) -> float:
        """``omega_n (mu_s - mu_k) F_N / (K V)``, the one number that shapes the orbit."""
        impedance = math.sqrt(self.stiffness) * math.sqrt(self.mass)
        drop = (self.mu_s - self.mu_k) * self.normal_force
        return drop / impedance / self.belt_speed

    @property
    def omega_n(self) -> float:
        """Natural frequency ``sqrt(K/M)`` in 1/s."""
        return math.sqrt(self.stiffness) / math.sqrt(self.mass)

    @property
    def static_limit(self) -> float:
        """``mu_s F_N / K`` in m: the displacement at which stick ends."""
        return self.mu_s * self.normal_force / self.stiffness

    @property
    def slip_centre(self) -> float:
        """``x_s = mu_k F_N / K`` in m: where the spring balances kinetic friction."""
        return self.mu_k * self.normal_force / self.stiffness

    @property
    def amplitude(self) -> float:
        """Half of the way between the two ends of the exact motion, in m."""
        return self.belt_speed / self.omega_n * math.hypot(1.0, self.alpha)

    @property
    def largest_jump(self) -> float:
        """``V omega_n alpha`` in m/s**2: by how much the acceleration jumps."""
        return self.alpha * self.belt_speed * self.omega_n

    def with_value(self, name: str, value: Any) -> "StickSlip":
        """Return the oscillator with another value of a parameter."""
        return StickSlip(**dict(self.values) | {name: value})

    def called(self, method: str) -> str:
        """Return what the paper calls a method."""
        return shown(self.scene, method)

    def presented(self, motion: Any) -> Any:
        """Return an orbit of this case, exact or not, with the paper's quantities."""
        kind = ExactStickSlipOrbit if isinstance(motion, ExactOrbit) else StickSlipOrbit
        return kind.of(motion)

    def completed(self, document: dict[str, Any], exact: ExactOrbit | None) -> dict[str, Any]:
        """Return the document of an orbit that was not found with all keys of one that was."""
        entry = document["exact"] | {"t1": exact and exact.durations[0]}
        return super().completed(document, exact) | {
            "transition_mismatch": None,
            "exact": entry,
        }

    def none(self, method: str, order: int, tried: Sequence[str]) -> NoOrbit | None:
        """Return a `NoOrbit` with a proof that a method has no orbit at an order, else None."""
        if method != "ck" or order > MOST_ISOLATED:
            return None
        try:
            roots = solutions(self, order)
        except ArithmeticError:
            return None
        if any(not root.violations for root in roots):
            return None
        words = f"all {len(roots)} real solutions of (18)-(20) at order {order} and alpha = "
        words += f"{self.alpha:.6g} were isolated; none is an orbit"
        return NoOrbit(words, True, tuple(tried))


def as_in_paper(case: Case) -> Case:
    """Return a case of the paper's scene as a `StickSlip`, any other as it is."""
    if case.scene != load(SCENE):
        return case
    return StickSlip(**case.values)


@dataclass(frozen=True)
class StickSlipErrors(Errors):
    """Errors of an orbit, with those that the paper uses.

    Parameters
    ----------
    period, times, discontinuous, switches : float
        See `Errors`.
    t1 : float
        ``t1/t1_exact - 1``, signed.
    acceleration : float
        (22), on normalised time.  A jump misplaced by ``dt`` contributes ``sqrt(dt)``: in
        float64 the measure cannot go below about 1e-8.
    acceleration_aligned : float
        The same with each phase mapped onto the exact one: `discontinuous`.
    """

    t1: float
    acceleration: float
    acceleration_aligned: float


class _Belt(Motion):
    """What all orbits of the belt have, exact or not."""

    case: StickSlip

    @classmethod
    def of(cls, motion: ExactOrbit | Solution) -> Self:
        """Return an orbit with the paper's quantities."""
        assert isinstance(motion.case, StickSlip)
        return cls(**{field.name: getattr(motion, field.name) for field in fields(motion)})

    @property
    def t1(self) -> float:
        """End of stick in s."""
        return self.durations[0]

    @property
    def _times(self) -> str:
        return f"T = {self.period:.10g} s, t1 = {self.t1:.10g} s"


class ExactStickSlipOrbit(_Belt, ExactOrbit):
    """The exact orbit of Section 2."""


class StickSlipOrbit(_Belt, Orbit):
    """A converged, admissible periodic orbit of the belt."""

    @property
    def transition_mismatch(self) -> float:
        """``K x(t1)/(mu_s F_N) - 1``: an error measure that needs no exact orbit."""
        return self.phases[1].displacement / self.case.static_limit - 1

    @cached_property
    def errors(self) -> Errors | None:
        """Errors against the exact orbit: `StickSlipErrors`; None if none is found."""
        if self.exact is None:
            return None
        general = difference(self, self.exact, self.order)
        t1 = self.durations[0] / self.exact.durations[0] - 1
        apart = acceleration_error(self, self.exact, self.order)
        added = {"t1": t1, "acceleration": apart, "acceleration_aligned": general.discontinuous}
        return StickSlipErrors(**vars(general), **added)

    @cached_property
    def coefficients(self) -> dict[str, float | list[float]]:
        """The paper's coefficients in SI units; of other methods those of any scene.

        ``hb``: ``a0``, ``a``, ``b`` of (3) in m; ``hb-c1``: those of (11), and ``c1`` of the
        printed ``g1`` of (12) in m/s**4; ``c1``: ``d`` of (15), ``d[n]`` in m/s**(n+2).
        """
        coefficients = super().coefficients
        if self.method == "hb-c1":
            amplitude: Any = coefficients["c1"]
            slip = (self.durations[1], -3), (self.period, -1)
            return coefficients | {"c1": product_of_powers(amplitude, *slip)}
        if self.method == "ck":
            return {"d": self._powers(coefficients["d_slip"])}
        return coefficients

    def _powers(self, series: Any) -> list[float]:
        """Return the coefficients of (15) in powers of ``t - t1`` for those in ``P_n*(u)``.

        ``P_n*(u)`` has ``(-1)**(n+k) C(n, k) C(n+k, k)`` at ``u**k``.  These grow like 5.8**n
        and alternate: of the d_n at high order some digits are lost, of the orbit, which is
        not evaluated from them, none.
        """
        powers = []
        for k in range(len(series)):
            terms = (
                series[n] * float((-1) ** (n + k) * math.comb(n, k) * math.comb(n + k, k))
                for n in range(k, len(series))
            )
            powers.append(product_of_powers(math.fsum(terms), (self.durations[1], -k)))
        return powers

    @property
    def further(self) -> Mapping[str, float]:
        """``t1`` in s, for rows and documents."""
        return {"t1": self.t1}

    def as_dict(self) -> dict[str, Any]:
        """Return the orbit as the document that ``solve --json`` writes."""
        document = super().as_dict()
        if self.exact is not None:
            document["exact"]["t1"] = self.exact.durations[0]
        return document | {"transition_mismatch": self.transition_mismatch}
