"""Periodic orbits of a stick-slip oscillator by harmonic balance and Galerkin expansions.

SymPy derives the equations of W.-J. Kim and N. C. Perkins, J. Sound Vib. 261 (2003)
213-224; the package solves them by generated kernels.  SI units throughout.

Examples
--------
>>> import nonsmooth as ns
>>> belt = ns.StickSlip(mass=10, stiffness=1000, belt_speed=1,
...                     mu_s=0.5, mu_k=0.25, normal_force=400)
>>> orbit = ns.solve(belt, method="c1", order=7)
>>> round(orbit.period, 6), round(ns.exact(belt).period, 6)
(0.671238, 0.671239)
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .codegen import derive as equations
    from .files.api import load, save
    from .files.errors import FileError
    from .solver.belt import ParameterError, StickSlip
    from .solver.family import Family, family
    from .solver.motion import ExactOrbit, exact
    from .solver.no_orbit import NoOrbit
    from .solver.orbit import Orbit
    from .solver.solve import solve
    from .solver.sweep import Row, Sweep, sweep

    __version__: str

#: Where each public name lives.  Nothing is imported before it is asked for: SymPy takes a
#: second, numba as long, and a command that shows its help needs neither.
_HOMES = {
    "ExactOrbit": ("solver.motion", "ExactOrbit"),
    "FileError": ("files.errors", "FileError"),
    "Family": ("solver.family", "Family"),
    "NoOrbit": ("solver.no_orbit", "NoOrbit"),
    "NotCertified": ("solver.choice", "NotCertified"),
    "Orbit": ("solver.orbit", "Orbit"),
    "ParameterError": ("solver.belt", "ParameterError"),
    "Row": ("solver.sweep", "Row"),
    "StickSlip": ("solver.belt", "StickSlip"),
    "Sweep": ("solver.sweep", "Sweep"),
    "TooSlow": ("solver.choice", "TooSlow"),
    "equations": ("codegen", "derive"),
    "exact": ("solver.motion", "exact"),
    "load": ("files.api", "load"),
    "save": ("files.api", "save"),
    "family": ("solver.family", "family"),
    "solve": ("solver.solve", "solve"),
    "sweep": ("solver.sweep", "sweep"),
}

__all__ = [
    "ExactOrbit",
    "Family",
    "FileError",
    "NoOrbit",
    "NotCertified",
    "Orbit",
    "ParameterError",
    "Row",
    "StickSlip",
    "Sweep",
    "TooSlow",
    "__version__",
    "equations",
    "exact",
    "family",
    "load",
    "save",
    "solve",
    "sweep",
]


def __getattr__(name: str) -> Any:
    """Return a public name, imported at its first use."""
    if name == "__version__":
        return import_module("importlib.metadata").version("nonsmooth")
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    home, attribute = _HOMES[name]
    value = getattr(import_module(f"{__name__}.{home}"), attribute)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return __all__
