"""Scenes of the references that do not come with the program: as a user would write them."""

import sympy as sp

from nonsmooth.codegen.scene import Event, Parameter, Phase, Scene, a, forcing, v, x
from nonsmooth.codegen.scenes import (
    backlash,
    clearance,
    impact,
    impact_two_sided,
    stick_slip,
    stick_slip_damped,
)

m, k, F, Omega = sp.symbols("m k F Omega", positive=True)
c, f_d, f_s = sp.symbols("c f_d f_s", nonnegative=True)

MASS = Parameter("mass", m, "kg", 1.0, "mass")
STIFFNESS = Parameter("stiffness", k, "N/m", 1.0, "stiffness")


def damping(value: float) -> Parameter:
    return Parameter("damping", c, "N s/m", value, "viscous damping")


def force(value: float) -> Parameter:
    return Parameter("force", F, "N", value, "amplitude of the force")


def frequency(value: float) -> Parameter:
    return Parameter("frequency", Omega, "rad/s", value, "angular frequency")


#: S3a: sliding without a stop, down first.
SLIDE_DOWN = m * a + c * v + k * x - f_d - F * forcing
FRICTION = Parameter("friction", f_d, "N", 0.3, "force of sliding friction")
SLIDING = Scene(
    "sliding",
    "a driven mass with dry friction that never stops",
    (MASS, damping(0.1), STIFFNESS, force(1.0), frequency(0.8), FRICTION),
    (Phase("down", SLIDE_DOWN, Event(v)),),
    frequency=Omega,
    half_period=True,
)


def _stopping(name: str, limit: sp.Expr, *friction: Parameter) -> Scene:
    """Return a scene that rests while the load is below a limit."""
    return Scene(
        name,
        "a driven mass with dry friction that stops twice a period",
        (MASS, damping(0.1), STIFFNESS, force(1.0), frequency(0.4), *friction),
        (
            Phase("down", SLIDE_DOWN, Event(v)),
            Phase("rest", a, Event(x * k - F * forcing + limit), held=sp.Integer(0)),
        ),
        frequency=Omega,
        half_period=True,
    )


#: S3b: with a stop in each half period; S3c: the friction is the same at rest.
MOVING = Parameter("friction", f_d, "N", 0.5, "force of sliding friction")
AT_REST = Parameter("static_friction", f_s, "N", 0.6, "largest force at rest")
TWO_STOPS = _stopping("two-stops", f_s, MOVING, AT_REST)
EQUAL_FRICTION = _stopping("equal-friction", f_d, MOVING)

#: S5c: the friction falls with the speed, and is continuous where the mass is at rest.
M, K, V, mu, F_N, w = sp.symbols("M K V mu F_N w", positive=True)
CONTINUOUS = Scene(
    "continuous-friction",
    "a mass on a belt, with friction that falls from its static value",
    (
        Parameter("mass", M, "kg", 1.0, "mass"),
        Parameter("stiffness", K, "N/m", 1.0, "stiffness"),
        Parameter("belt_speed", V, "m/s", 1.0, "speed of the belt"),
        Parameter("mu", mu, "", 2.0, "coefficient of friction at rest"),
        Parameter("normal_force", F_N, "N", 1.0, "normal force"),
        Parameter("damping", c, "N s/m", 0.0, "viscous damping"),
        Parameter("weakening", w, "s/m", 0.4, "fall of the coefficient with speed"),
    ),
    (
        Phase("stick", a, Event(mu * F_N - K * x - c * V), held=V),
        Phase("slip", M * a + c * v + K * x - (mu - w * (V - v)) * F_N, Event(v - V)),
    ),
)

#: By the name of the scene in the references; parameters in the order of the scene, where
#: they are not its defaults.
SCENES = {
    "S0n": (stick_slip.SCENE, (1.0, 1.0, 1.0, 1.0, 0.0, 1.0)),
    "S1": (impact.SCENE, None),
    "S2a": (backlash.SCENE, None),
    "S2b": (clearance.SCENE, None),
    "S3a": (SLIDING, None),
    "S3b": (TWO_STOPS, None),
    "S3c": (EQUAL_FRICTION, None),
    "S5a": (stick_slip_damped.SCENE, (1.0, 1.0, 1.0, 3.0, 1.0, 1.0, 0.1, 0.0)),
    "S5b": (stick_slip_damped.SCENE, (1.0, 1.0, 1.0, 2.0, 1.0, 1.0, 0.1, 0.2)),
    "S5c": (CONTINUOUS, None),
    "S6": (impact_two_sided.SCENE, None),
}


def case_of(name: str) -> tuple[float, ...]:
    """Return the parameters of a scene of the references, which has units of 1."""
    scene, values = SCENES[name]
    return values or tuple(float(q.default) for q in scene.parameters)
