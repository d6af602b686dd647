"""The oscillator of Section 2 in numbers: parameters, units, the one number `alpha`."""

import math
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from types import MappingProxyType
from typing import Any

from ...case.parameters import ParameterError, is_number

#: Unit of each parameter, and what it must be.
PARAMETERS: Mapping[str, tuple[str, str]] = MappingProxyType(
    {
        "mass": ("kg", "a positive number"),
        "stiffness": ("N/m", "a positive number"),
        "belt_speed": ("m/s", "a positive number"),
        "mu_s": ("", "a positive number"),
        "mu_k": ("", "a number not below 0"),
        "normal_force": ("N", "a positive number"),
    }
)


def parameter_errors(parameters: Mapping[str, object]) -> list[str]:
    """Return what is wrong with `parameters`, one line each; empty if nothing is."""
    errors = []
    numeric: dict[str, float] = {}
    for name, value in parameters.items():
        expected = PARAMETERS[name][1]
        limit = 0.0 if name == "mu_k" else math.ulp(0.0)
        if is_number(value) and float(value) >= limit:  # type: ignore[arg-type]
            numeric[name] = float(value)  # type: ignore[arg-type]
        else:
            errors.append(f"{name}: got {value!r}, expected {expected}")
    if {"mu_s", "mu_k"} <= numeric.keys() and numeric["mu_k"] >= numeric["mu_s"]:
        errors.append(
            f"mu_k: got {numeric['mu_k']!r}, expected less than mu_s = {numeric['mu_s']!r}; "
            "without a drop from static to kinetic friction there is no stick-slip"
        )
    return errors


def check_type(belt: object) -> None:
    """Check that `belt` is an oscillator, not its parameters.

    Raises
    ------
    TypeError
        If it is anything but a `StickSlip`.
    """
    if not isinstance(belt, StickSlip):
        raise TypeError(f"belt: got {belt!r:.80}, expected a StickSlip")


def alpha_of(parameters: Mapping[str, Any], sqrt: Callable[[Any], Any]) -> Any:
    """Return ``alpha``; of arrays with NumPy's root, of numbers with that of `math`."""
    p = parameters
    impedance = sqrt(p["stiffness"]) * sqrt(p["mass"])
    drop = (p["mu_s"] - p["mu_k"]) * p["normal_force"]
    return drop / impedance / p["belt_speed"]


def time_unit_of(parameters: Mapping[str, Any], sqrt: Callable[[Any], Any]) -> Any:
    """Return ``1/omega_n`` in s; see `alpha_of`."""
    return sqrt(parameters["mass"]) / sqrt(parameters["stiffness"])


@dataclass(frozen=True, kw_only=True)
class StickSlip:
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
        A `ValueError`: if a parameter is not a finite number in its range, all of them
        named at once; if ``mu_k >= mu_s``; or if a unit of the motion is beyond float64.

    Examples
    --------
    >>> belt = StickSlip(mass=10, stiffness=1000, belt_speed=1,
    ...                  mu_s=0.5, mu_k=0.25, normal_force=400)
    >>> belt.alpha
    1.0
    """

    mass: float
    stiffness: float
    belt_speed: float
    mu_s: float
    mu_k: float
    normal_force: float

    def __post_init__(self) -> None:
        errors = parameter_errors(asdict(self))
        if errors:
            raise ParameterError(errors)
        for name in PARAMETERS:
            object.__setattr__(self, name, float(getattr(self, name)))
        for name, value in self._scales().items():
            if not (math.isfinite(value) and value > 0):
                message = f"parameters: their {name} is {value!r}, outside float64"
                raise ParameterError([message])

    def _scales(self) -> dict[str, float]:
        """Return the sizes that results are made of; float64 has to hold them."""
        return {
            "alpha": self.alpha,
            "unit of time": self.time_unit,
            "unit of length": self.length_unit,
            "largest acceleration": self.acceleration_unit * (1 + self.alpha),
            "static limit": self.static_limit,
            "stick duration": 2 * self.alpha * self.time_unit,
        }

    @property
    def omega_n(self) -> float:
        """Natural frequency ``sqrt(K/M)`` in 1/s."""
        return math.sqrt(self.stiffness) / math.sqrt(self.mass)

    @property
    def alpha(self) -> float:
        """``omega_n (mu_s - mu_k) F_N / (K V)``, the one number that shapes the orbit."""
        return float(alpha_of(vars(self), math.sqrt))

    @property
    def time_unit(self) -> float:
        """``1/omega_n`` in s: the unit of dimensionless time."""
        return float(time_unit_of(vars(self), math.sqrt))

    @property
    def length_unit(self) -> float:
        """``V/omega_n`` in m: the unit of dimensionless length."""
        return self.belt_speed * self.time_unit

    @property
    def acceleration_unit(self) -> float:
        """``V omega_n`` in m/s**2: the unit of dimensionless acceleration."""
        return self.belt_speed * self.omega_n

    @property
    def slip_centre(self) -> float:
        """``x_s = mu_k F_N / K`` in m: the origin of dimensionless length."""
        return self.mu_k * self.normal_force / self.stiffness

    @property
    def static_limit(self) -> float:
        """``mu_s F_N / K`` in m: the displacement at which stick ends."""
        return self.mu_s * self.normal_force / self.stiffness


#: Section 4 of the paper.  The paper does not give F_N; 400 N is assumed: it makes
#: alpha = 1, and is the roundest force at which nearly all claims of Fig. 4 hold.
DEFAULT = StickSlip(
    mass=10.0, stiffness=1000.0, belt_speed=1.0, mu_s=0.5, mu_k=0.25, normal_force=400.0
)
