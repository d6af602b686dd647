"""What several modules compare with: the exact orbit of Section 2 in SI, orbits solved once."""

from functools import cache

import numpy as np

import nonsmooth as ns
from nonsmooth.kim_perkins import StickSlipOrbit
from nonsmooth.report.case import DEFAULT, FLOORS, MOST, Case
from nonsmooth.solver.accuracy.rates import slope

#: No two of its scales are the same, nor 1: a wrong unit or a missing factor is seen.
ODD = ns.StickSlip(
    mass=0.02, stiffness=8.0, belt_speed=0.75, mu_s=0.9, mu_k=0.5, normal_force=1.0
)

#: Here the C1 series has no orbit at N = 3 and 4.
LIGHT = ns.StickSlip(
    mass=10, stiffness=1000, belt_speed=1, mu_s=0.5, mu_k=0.25, normal_force=100
)


def belt_of(alpha: float) -> ns.StickSlip:
    """Return an oscillator of this alpha whose units are those of the polynomials."""
    return ns.StickSlip(
        mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
    )


class Exact:
    """The exact orbit, from the parameters: stick from A to B, then an arc back."""

    def __init__(self, belt: ns.StickSlip) -> None:
        self.omega = (belt.stiffness / belt.mass) ** 0.5
        self.speed = belt.belt_speed
        self.centre = belt.mu_k * belt.normal_force / belt.stiffness
        self.reach = (belt.mu_s - belt.mu_k) * belt.normal_force / belt.stiffness
        self.jump = (belt.mu_s - belt.mu_k) * belt.normal_force / belt.mass
        self.t1 = 2 * self.reach / self.speed
        arc = np.pi + 2 * np.arctan(self.speed / (self.omega * self.reach))
        self.period = self.t1 + arc / self.omega

    def motion(self, part: np.ndarray, derivative: int) -> np.ndarray:
        """Return displacement, velocity or acceleration at parts of the period."""
        t = part * self.period
        angle, w = self.omega * (t - self.t1), self.omega
        cos, sin = np.cos(angle), np.sin(angle)
        slip = (
            self.centre + self.reach * cos + self.speed / w * sin,
            self.speed * cos - self.reach * w * sin,
            -(w**2) * self.reach * cos - w * self.speed * sin,
        )[derivative]
        stick = (self.centre - self.reach + self.speed * t, self.speed + 0 * t, 0 * t)
        return np.asarray(np.where(t < self.t1, stick[derivative], slip))


@cache
def case(belt: ns.StickSlip = DEFAULT) -> Case:
    """Return the one case of an oscillator that all tests of the report share."""
    return Case(belt)


def orbits(belt: ns.StickSlip, method: str, last: int = MOST) -> dict[int, StickSlipOrbit]:
    """Return the orbits of a method by order, up to one."""
    return {N: case(belt).orbit(method, N) for N in case(belt).orders(method) if last >= N}


def period_errors(belt: ns.StickSlip, method: str) -> dict[int, float]:
    """Return ``T/T_exact - 1`` by order, from the periods and the closed form."""
    period = Exact(belt).period
    return {N: orbit.period / period - 1 for N, orbit in orbits(belt, method).items()}


def acceleration_errors(belt: ns.StickSlip, method: str) -> dict[int, float]:
    """Return (22) by order."""
    found = orbits(belt, method).items()
    return {N: orbit.errors.acceleration for N, orbit in found}


def rate(belt: ns.StickSlip, of: str, method: str) -> float | None:
    """Return how fast an error falls with the order, over the upper half of the scale."""
    errors = {"period": period_errors, "acceleration": acceleration_errors}[of](belt, method)
    return slope(errors.items(), FLOORS[of], power=method != "c1", upper_half=True)
