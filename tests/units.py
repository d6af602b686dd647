"""What each number of a result is measured in, written by hand, and the same in other units."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import nonsmooth as ns

#: Powers of kg, m and s in each unit.
DIMENSIONS = {
    "rad": (0, 0, 0),
    "1": (0, 0, 0),
    "kg": (1, 0, 0),
    "s": (0, 0, 1),
    "m": (0, 1, 0),
    "m/s": (0, 1, -1),
    "m/s**2": (0, 1, -2),
    "m/s**4": (0, 1, -4),
    "N": (1, 1, -2),
    "N/m": (1, 0, -2),
}

PARAMETERS = {
    "mass": "kg",
    "stiffness": "N/m",
    "belt_speed": "m/s",
    "mu_s": "1",
    "mu_k": "1",
    "normal_force": "N",
}

#: Of an orbit, a row of a sweep, a point of a family.
RESULTS = {"t1": "s", "period": "s"}
MOTION = {"t": "s", "displacement": "m", "velocity": "m/s", "acceleration": "m/s**2"}
WALL_TIME = {"seconds": "s"}

#: Of what the document of an orbit has as that of any scene.
OF_ANY_SCENE = {
    "duration": "s", "durations": "s", "forcing_phase": "rad", "displacement": "m",
    "velocity": "m/s",
}  # fmt: skip

SCALARS = PARAMETERS | RESULTS | MOTION | OF_ANY_SCENE | WALL_TIME | {"slip": "s"}

#: ``d[n]`` of Section 3.3 has a unit of its own for each ``n``.
BY_NUMBER = "m/s**(n + 2)"
COEFFICIENTS = {
    "hb": {"a0": "m", "a": "m", "b": "m"},
    "hb-c1": {"a0": "m", "a": "m", "b": "m", "c1": "m/s**4"},
    "c1": {"d": BY_NUMBER},
    "c1-tau": {
        "x_stick": "m",
        "v_stick": "m/s",
        "x_slip": "m",
        "v_slip": "m/s",
        "d_slip": "m/s**2",
    },
}


#: An oscillator whose every parameter is another number.
BELT = ns.StickSlip(
    mass=3.0, stiffness=700.0, belt_speed=0.7, mu_s=0.5, mu_k=0.2, normal_force=150.0
)


@dataclass(frozen=True)
class Units:
    """Other units: how many of them are a kilogram, a metre, a second."""

    kg: float
    m: float
    s: float

    def of(self, unit: str, n: int = 0) -> float:
        """Return how many of the other units are one of this."""
        kg, m, s = (0, 1, -2 - n) if unit == BY_NUMBER else DIMENSIONS[unit]
        return self.kg**kg * self.m**m * self.s**s

    def belt(self, belt: ns.StickSlip) -> ns.StickSlip:
        """Return the same oscillator, measured in the other units."""
        numbers = {name: belt.values[name] * self.of(u) for name, u in PARAMETERS.items()}
        return ns.StickSlip(**numbers)


#: Far from each other in every unit; of powers of four the root, too, is without rounding.
POWERS = Units(kg=2.0**2, m=2.0**10, s=2.0**-6)


def flags(belt: ns.StickSlip, *without: str) -> list[str]:
    """Return the oscillator as flags of the command line."""
    return [
        f"--{name.replace('_', '-')}={getattr(belt, name)!r}"
        for name in PARAMETERS
        if name not in without
    ]


def leaves(value: Any, path: tuple[Any, ...] = ()) -> dict[tuple[Any, ...], Any]:
    """Return every number and text of a document by its path."""
    if isinstance(value, Mapping):
        items = list(value.items())
    elif isinstance(value, list):
        items = list(enumerate(value))
    else:
        return {path: value}
    return {key: leaf for k, v in items for key, leaf in leaves(v, (*path, k)).items()}
