"""Periodic motions in SI units, and the exact one."""

import math
from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from ...arrays import Vector
from ...results.motion import Shown
from ..names import PHASES, SCENE
from . import exact as closed_form
from .oscillator import PARAMETERS, StickSlip, check_type


class Motion(Shown):
    """Displacement, velocity and acceleration of a periodic motion at any time, in SI."""

    belt: StickSlip

    @property
    def period(self) -> float:
        """``T`` in s."""
        raise NotImplementedError

    @property
    def t1(self) -> float:
        """End of stick in s."""
        raise NotImplementedError

    @property
    def durations(self) -> tuple[float, float]:
        """Durations of stick and slip in s."""
        return self.t1, self.period - self.t1

    @property
    def amplitude(self) -> float:
        """Half of the way between the two ends of the motion, in m."""
        raise NotImplementedError

    @property
    def about(self) -> dict[str, Any]:
        """Scene, period and parameters, for tables and files."""
        head = {"scene": SCENE, "class": "C1", "period": self.period, "t1": self.t1}
        return head | {"phases": " ".join(PHASES)} | asdict(self.belt)

    @property
    def facts(self) -> dict[str, str]:
        """What a notebook shows: what is solved, period, end of stick."""
        parts = (
            f"{name} = {getattr(self.belt, name):.4g} {unit}".rstrip()
            for name, (unit, _) in PARAMETERS.items()
        )
        return {
            "scene": f"{SCENE}: alpha = {self.belt.alpha:.6g}",
            "parameters": ", ".join(parts),
            "period": f"{self.period:.10g} s",
            "end of stick": f"{self.t1:.10g} s",
        }

    @property
    def _times(self) -> str:
        return f"T = {self.period:.10g} s, t1 = {self.t1:.10g} s"

    @property
    def multipliers(self) -> npt.NDArray[np.complex128]:
        """The Floquet multipliers but that of a shift in time: 0, since stick forgets all."""
        return np.zeros(1, dtype=complex)

    @property
    def trivial_multiplier(self) -> float:
        """The multiplier of a shift in time: ``cos s - alpha sin s``, s the duration of slip.

        It is 1 where that duration is exact, and what it is off says how far.
        """
        t1, T, _ = self._dimensionless()
        return math.cos(T - t1) - self.belt.alpha * math.sin(T - t1)

    @property
    def stable(self) -> bool:
        """Whether small perturbations die out: at the end of the slip in which they happen."""
        return True

    @property
    def margin(self) -> float:
        """1 less the largest modulus of the multipliers: 1."""
        return 1.0

    def _dimensionless(self) -> tuple[float, float, Callable[[Vector, int], Vector]]:
        """Return ``t1``, ``T`` and ``evaluate(t, derivative)`` on ``[0, T)``, dimensionless."""
        raise NotImplementedError

    def _at(self, t: npt.ArrayLike, derivative: int) -> Vector:
        times = np.asarray(t if np.isrealobj(t) else np.nan, dtype=float)
        if not np.isfinite(times).all():
            raise ValueError(f"t: got {t!r}, expected finite times in s")
        in_period = np.mod(times.ravel(), self.period)
        in_period[in_period >= self.period] = 0.0  # of a tiny negative number
        t1, T, evaluate = self._dimensionless()
        phase, slips = in_period / self.belt.time_unit, in_period >= self.t1
        # the change of units may round a time into the other phase
        first, end = np.where(slips, t1, 0.0), np.where(slips, T, t1)
        phase = np.clip(phase, first, np.nextafter(end, 0.0))
        belt = self.belt
        unit = (belt.length_unit, belt.belt_speed, belt.acceleration_unit)[derivative]
        values = unit * evaluate(phase, derivative)
        if derivative == 0:
            values += self.belt.slip_centre
        return values.reshape(times.shape)

    def displacement(self, t: npt.ArrayLike) -> Vector:
        """Return ``x(t)`` in m.

        Parameters
        ----------
        t : array_like of float, any shape
            Times in s; stick starts at 0, and the motion repeats with `period`.

        Returns
        -------
        ndarray of float, of the shape of `t`

        Raises
        ------
        ValueError
            If a time is infinite or not a number.
        """
        return self._at(t, 0)

    def velocity(self, t: npt.ArrayLike) -> Vector:
        """Return the velocity in m/s at times `t`; see `displacement`."""
        return self._at(t, 1)

    def acceleration(self, t: npt.ArrayLike) -> Vector:
        """Return the acceleration in m/s**2 at times `t`; see `displacement`.

        Where it jumps, at `t1` and at `period`, the value is that of the phase which begins.
        """
        return self._at(t, 2)


@dataclass(frozen=True, eq=False, repr=False)
class ExactOrbit(Motion):
    """The exact orbit of Section 2.

    Examples
    --------
    >>> from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT
    >>> orbit = ExactOrbit(DEFAULT)
    >>> round(orbit.period, 9), orbit.t1
    (0.671238898, 0.2)
    >>> orbit
    <exact orbit of stick-slip: T = 0.671238898 s, t1 = 0.2 s, alpha = 1>
    """

    belt: StickSlip

    @property
    def period(self) -> float:
        """``T`` in s."""
        return closed_form.times(self.belt.alpha)[1] * self.belt.time_unit

    @property
    def t1(self) -> float:
        """End of stick, ``2 A/V``, in s."""
        return closed_form.times(self.belt.alpha)[0] * self.belt.time_unit

    @property
    def amplitude(self) -> float:
        """Half of the way between the two ends of the motion, in m."""
        return self.belt.length_unit * math.hypot(1.0, self.belt.alpha)

    @property
    def label(self) -> str:
        """What a legend calls it."""
        return "exact"

    @property
    def look(self) -> None:
        """Of its curves in pictures: None, those of every exact orbit."""

    @property
    def _identity(self) -> tuple[object, ...]:
        return (self.belt,)

    def __repr__(self) -> str:
        return f"<exact orbit of {SCENE}: {self._times}, alpha = {self.belt.alpha:.6g}>"

    def _dimensionless(self) -> tuple[float, float, Callable[[Vector, int], Vector]]:
        alpha = self.belt.alpha
        evaluate = closed_form.evaluate
        return *closed_form.times(alpha), lambda t, order: evaluate(alpha, t, order)


def exact(belt: StickSlip) -> ExactOrbit:
    """Return the exact orbit of Section 2.

    Raises
    ------
    TypeError
        If `belt` is not a `StickSlip`.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> belt = ns.StickSlip(mass=10, stiffness=1000, belt_speed=1,
    ...                     mu_s=0.5, mu_k=0.25, normal_force=400)
    >>> ns.exact(belt).t1
    0.2
    """
    check_type(belt)
    return ExactOrbit(belt)
