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
from importlib.metadata import version
from typing import TYPE_CHECKING, Any

from .solver.belt import ParameterError, StickSlip
from .solver.orbit import ExactOrbit, Orbit
from .solver.solve import NoOrbit, solve
from .solver.sweep import Row, Sweep, sweep

if TYPE_CHECKING:
    from .codegen.api import equations

__version__ = version("nonsmooth")

__all__ = [
    "ExactOrbit",
    "NoOrbit",
    "Orbit",
    "ParameterError",
    "Row",
    "StickSlip",
    "Sweep",
    "__version__",
    "equations",
    "exact",
    "solve",
    "sweep",
]


def exact(belt: StickSlip) -> ExactOrbit:
    """Return the exact orbit of Section 2.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> belt = ns.StickSlip(mass=10, stiffness=1000, belt_speed=1,
    ...                     mu_s=0.5, mu_k=0.25, normal_force=400)
    >>> ns.exact(belt).t1
    0.2
    """
    return ExactOrbit(belt)


def __getattr__(name: str) -> Any:
    """Import the symbolic stage, which takes a second, when it is asked for."""
    if name == "equations":
        return import_module(".codegen.api", __name__).equations
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
