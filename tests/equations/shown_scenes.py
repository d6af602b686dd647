"""Scenes that the tests show: those of the program, and others as users write them."""

from functools import cache

import sympy as sp
from shown_numbers import Numbers

from nonsmooth.codegen.equations import scene_named
from nonsmooth.codegen.equations.registry import conditions, methods
from nonsmooth.codegen.scene import Event, Parameter, Phase, Scene, a, forcing, v, x
from nonsmooth.codegen.scenes.impact import SCENE as IMPACT

m, k, F, Omega = sp.symbols("m k F Omega", positive=True)
c, f_d, f_s = sp.symbols("c f_d f_s", nonnegative=True)
_OSCILLATOR = (
    Parameter("mass", m, "kg", 1.0, "mass"),
    Parameter("damping", c, "N s/m", 0.1, "viscous damping"),
    Parameter("stiffness", k, "N/m", 1.0, "stiffness"),
    Parameter("force", F, "N", 1.0, "amplitude of the force"),
    Parameter("frequency", Omega, "rad/s", 0.7, "angular frequency"),
)
_FREE = m * a + c * v + k * x - F * forcing

#: Dry friction with a stop in each half of the period, C1.
STOPS = Scene(
    "stops",
    "a driven mass with dry friction that stops twice a period",
    (
        *_OSCILLATOR,
        Parameter("friction", f_d, "N", 0.5, "force of sliding friction"),
        Parameter("static_friction", f_s, "N", 0.6, "largest force at rest"),
    ),
    (
        Phase("down", _FREE - f_d, Event(v), {"it slides down": -v}),
        Phase("rest", a, Event(k * x - F * forcing + f_s), held=sp.Integer(0)),
    ),
    frequency=Omega,
    half_period=True,
)

SCENES: dict[str, str | Scene] = {
    "impact": "impact",
    "stick-slip": "stick-slip",
    "stick-slip-damped": "stick-slip-damped",
    "clearance": "clearance",
    "stops": STOPS,
    "impact-two-sided": "impact-two-sided",
    "elastic-plastic": "elastic-plastic",
    "impact-inelastic": "impact-inelastic",
}

#: Scenes of every run; those left out have phases of the same kinds.
EVERY_RUN = (
    "impact",
    "stick-slip",
    "stick-slip-damped",
    "stops",
    "elastic-plastic",
    "impact-inelastic",
)

#: Every method on a scene, and each kind of phase in the others.
CASES = [
    *(("impact", method) for method in methods(IMPACT)),
    *(("stick-slip", method) for method in ("hb", "hb-c1", "ck")),
    ("stick-slip-damped", "ck-tau"),
    ("stick-slip-damped", "hb"),
    ("clearance", "ck-tau"),
    ("clearance", "hb"),
    ("stops", "hb-ck"),
    ("stops", "ck"),
    ("impact-two-sided", "hb"),
    ("impact-two-sided", "ck-tau"),
    ("elastic-plastic", "hb"),
    ("elastic-plastic", "ck-tau"),
    ("impact-inelastic", "hb"),
    ("impact-inelastic", "hb-ck"),
    ("impact-inelastic", "ck-tau"),
]
CASES_OF_EVERY_RUN = [
    case for case in CASES if case[0] in EVERY_RUN and case != ("stops", "ck")
]


@cache
def numbers(scene: str, method: str, functions: int | None = None) -> Numbers:
    """Return what is shown of a scene in an expansion, with numbers."""
    return Numbers(conditions(scene_named(SCENES[scene]), method, functions), 3)
