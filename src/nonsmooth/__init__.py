"""Periodic orbits of non-smooth oscillators by harmonic balance and Galerkin expansions.

SymPy derives the equations of W.-J. Kim and N. C. Perkins, J. Sound Vib. 261 (2003)
213-224, and the same for any scene; the package solves them by generated kernels.  SI units
throughout.

Examples
--------
>>> import nonsmooth as ns
>>> belt = ns.StickSlip(mass=10, stiffness=1000, belt_speed=1,
...                     mu_s=0.5, mu_k=0.25, normal_force=400)
>>> orbit = ns.solve(belt, method="c1", order=7)
>>> round(orbit.period, 6), round(ns.exact(belt).period, 6)
(0.671238, 0.671239)
>>> ns.solve(ns.scene("impact")(gap=0.2), tol=1e-9)
<impact by c0-tau, N = 9: T = 3.490658504 s, phi = 1.103021211 rad, stable, estimate 8.3e-11>
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .codegen import derive as equations
    from .extras import MissingExtra
    from .files.api import load, save
    from .files.file_errors import FileError, FileWarning
    from .kim_perkins import StickSlip
    from .oscillators import solve
    from .plots.plot import plot
    from .scene import find as scene
    from .scene_files.error import SceneFileError
    from .scene_files.find import names as scenes
    from .solver.branches import branch, branches
    from .solver.chart import chart
    from .solver.exact import ExactOrbit
    from .solver.exact import exact_orbit as exact
    from .solver.family import family
    from .solver.no_orbit import NoOrbit
    from .solver.results.branch import Branch
    from .solver.results.chart import Chart
    from .solver.results.family import Family
    from .solver.results.orbit import Orbit
    from .solver.results.strobe import Basins, Diagram
    from .solver.results.sweep import Sweep
    from .solver.scenes.case import Case
    from .solver.scenes.loaded import UnknownScene
    from .solver.scenes.parameter_error import ParameterError
    from .solver.simulation.record import Simulation
    from .solver.simulation.simulate import simulate
    from .solver.space.mode import Mode
    from .solver.space.modes import Modes, ToleranceNotMet, modes
    from .solver.space.structure import UnknownStructure
    from .solver.space.structure import names as structures
    from .solver.strobe import basins, diagram
    from .solver.sweep import sweep
    from .solver.trade.choice import NotCertified, TooSlow

    __version__: str

#: Where each public name lives.  Nothing is imported before it is asked for: SymPy takes a
#: second, numba as long, and a command that shows its help needs neither.
_HOMES = {
    "Basins": ("solver.results.strobe", "Basins"),
    "Branch": ("solver.results.branch", "Branch"),
    "Diagram": ("solver.results.strobe", "Diagram"),
    "Case": ("solver.scenes.case", "Case"),
    "Chart": ("solver.results.chart", "Chart"),
    "ExactOrbit": ("solver.exact", "ExactOrbit"),
    "FileError": ("files.file_errors", "FileError"),
    "FileWarning": ("files.file_errors", "FileWarning"),
    "MissingExtra": ("extras", "MissingExtra"),
    "Mode": ("solver.space.mode", "Mode"),
    "Modes": ("solver.space.modes", "Modes"),
    "NoOrbit": ("solver.no_orbit", "NoOrbit"),
    "NotCertified": ("solver.trade.choice", "NotCertified"),
    "ParameterError": ("solver.scenes.parameter_error", "ParameterError"),
    "Family": ("solver.results.family", "Family"),
    "SceneFileError": ("scene_files.error", "SceneFileError"),
    "Orbit": ("solver.results.orbit", "Orbit"),
    "Sweep": ("solver.results.sweep", "Sweep"),
    "Simulation": ("solver.simulation.record", "Simulation"),
    "StickSlip": ("kim_perkins", "StickSlip"),
    "ToleranceNotMet": ("solver.space.modes", "ToleranceNotMet"),
    "TooSlow": ("solver.trade.choice", "TooSlow"),
    "UnknownScene": ("solver.scenes.loaded", "UnknownScene"),
    "UnknownStructure": ("solver.space.structure", "UnknownStructure"),
    "basins": ("solver.strobe", "basins"),
    "branch": ("solver.branches", "branch"),
    "branches": ("solver.branches", "branches"),
    "chart": ("solver.chart", "chart"),
    "diagram": ("solver.strobe", "diagram"),
    "equations": ("codegen", "derive"),
    "exact": ("solver.exact", "exact_orbit"),
    "family": ("solver.family", "family"),
    "load": ("files.api", "load"),
    "modes": ("solver.space.modes", "modes"),
    "plot": ("plots.plot", "plot"),
    "save": ("files.api", "save"),
    "scenes": ("scene_files.find", "names"),
    "simulate": ("solver.simulation.simulate", "simulate"),
    "solve": ("oscillators", "solve"),
    "structures": ("solver.space.structure", "names"),
    "sweep": ("solver.sweep", "sweep"),
}

__all__ = [
    "Basins", "Branch", "Case", "Chart", "Diagram", "ExactOrbit", "Family", "FileError",
    "FileWarning", "MissingExtra", "Mode", "Modes", "NoOrbit", "NotCertified", "Orbit",
    "ParameterError", "SceneFileError", "Simulation", "StickSlip", "Sweep",
    "ToleranceNotMet", "TooSlow", "UnknownScene", "UnknownStructure", "__version__",
    "basins", "branch", "branches", "chart", "diagram", "equations", "exact", "family",
    "load", "modes", "plot", "save", "scene", "scenes", "simulate", "solve", "structures",
    "sweep",
]  # fmt: skip


def __getattr__(name: str) -> Any:
    """Return a public name, imported at its first use."""
    if name == "__version__":
        return import_module("importlib.metadata").version("nonsmooth")
    if name == "scene":  # a module that is called
        return import_module(f"{__name__}.scene")
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    home, attribute = _HOMES[name]
    value = getattr(import_module(f"{__name__}.{home}"), attribute)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return __all__
