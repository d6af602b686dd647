"""Scenes of the references that do not come with the program: as a user would write them."""

import sympy as sp

from nonsmooth.codegen.scene import Event, Parameter, Phase, Scene, a, forcing, v, x

m, k, F, Omega, r, h = sp.symbols("m k F Omega r h", positive=True)
c, f_d, f_s = sp.symbols("c f_d f_s", nonnegative=True)
g = sp.Symbol("g", positive=True)

MASS = Parameter("mass", m, "kg", 1.0, "mass")
DAMPING = Parameter("damping", c, "N s/m", 0.1, "viscous damping")
STIFFNESS = Parameter("stiffness", k, "N/m", 1.0, "stiffness")
FORCE = Parameter("force", F, "N", 1.0, "amplitude of the force")
GAP = Parameter("gap", g, "m", 1.0, "gap")


def frequency(value: float) -> Parameter:
    return Parameter("frequency", Omega, "rad/s", value, "angular frequency")


#: S2b: contact first, as in the references.
CONTACT = Phase("contact", m * a + c * v + k * x + h * (x - g) - F * forcing, Event(x - g))
FREE = Phase("free", m * a + c * v + k * x - F * forcing, Event(x - g))
CLEARANCE = Scene(
    "one-sided-contact",
    "a spring behind a gap",
    (
        MASS,
        Parameter("damping", c, "N s/m", 0.2, "viscous damping"),
        STIFFNESS,
        FORCE,
        frequency(1.3),
        Parameter("gap", g, "m", 0.5, "gap"),
        Parameter("contact_stiffness", h, "N/m", 4.0, "stiffness of the contact"),
    ),
    (CONTACT, FREE),
    frequency=Omega,
)

#: S2a: a dead zone, half a period.
ENGAGED = Phase("engaged", m * a + c * v + k * (x - g) - F * forcing, Event(x - g))
LOOSE = Phase("loose", m * a + c * v - F * forcing, Event(x + g))
DEAD_ZONE = Scene(
    "dead-zone",
    "a spring with play on both sides",
    (
        MASS,
        DAMPING,
        STIFFNESS,
        Parameter("force", F, "N", 0.8, "amplitude of the force"),
        frequency(0.7),
        GAP,
    ),
    (ENGAGED, LOOSE),
    frequency=Omega,
    half_period=True,
)

#: S3a: sliding without a stop, down first.
DOWN = Phase("down", m * a + c * v + k * x - f_d - F * forcing, Event(v))
SLIDING = Scene(
    "sliding",
    "a driven mass with dry friction that never stops",
    (
        MASS,
        DAMPING,
        STIFFNESS,
        FORCE,
        frequency(0.8),
        Parameter("friction", f_d, "N", 0.3, "force of sliding friction"),
    ),
    (DOWN,),
    frequency=Omega,
    half_period=True,
)

#: S3b: with a stop in each half period.
DOWN_TO_REST = Phase("down", m * a + c * v + k * x - f_d - F * forcing, Event(v))
REST = Phase("rest", a, Event(x * k - F * forcing + f_s), held=sp.Integer(0))
TWO_STOPS = Scene(
    "two-stops",
    "a driven mass with dry friction that stops twice a period",
    (
        MASS,
        DAMPING,
        STIFFNESS,
        FORCE,
        frequency(0.4),
        Parameter("friction", f_d, "N", 0.5, "force of sliding friction"),
        Parameter("static_friction", f_s, "N", 0.6, "largest force at rest"),
    ),
    (DOWN_TO_REST, REST),
    frequency=Omega,
    half_period=True,
)

#: S6: impacts on both sides, half a period.
CROSSING = Phase("crossing", m * a + c * v + k * x - F * forcing, Event(x + g, jump={v: -r * v}))
TWO_SIDED = Scene(
    "two-sided",
    "a driven mass between two stops",
    (
        MASS,
        DAMPING,
        STIFFNESS,
        FORCE,
        frequency(1.2),
        Parameter("gap", g, "m", 0.8, "gap"),
        Parameter("restitution", r, "", 0.6, "restitution", most=1),
    ),
    (CROSSING,),
    frequency=Omega,
    half_period=True,
)

#: By the name of the scene in the references, with what the references call its switches.
SCENES = {
    "S2a": DEAD_ZONE,
    "S2b": CLEARANCE,
    "S3a": SLIDING,
    "S3b": TWO_STOPS,
    "S6": TWO_SIDED,
}
