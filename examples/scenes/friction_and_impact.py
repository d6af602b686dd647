"""A driven mass with dry friction that bounces off a stop (C0)."""

import sympy as sp

from nonsmooth.scene import Event, Parameter, Phase, Scene, a, forcing, v, x

m, k, F, Omega, g = sp.symbols("m k F Omega g", positive=True)
f, r = sp.symbols("f r", nonnegative=True)

REST = m * a + k * x - F * forcing
FORTH = Phase(
    "forth",
    REST + f,
    ends=Event(x - g, jump={v: -r * v}),
    demands={"the mass moves forward": v, "and stays before the stop": g - x},
)
BACK = Phase("back", REST - f, ends=Event(v), demands={"the mass moves backward": -v})

SCENE = Scene(
    "friction-and-impact",
    "a driven mass with dry friction that bounces off a stop",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness of the spring"),
        Parameter("friction", f, "N", 0.2, "friction force"),
        Parameter("gap", g, "m", 0.4, "way to the stop"),
        Parameter("restitution", r, "", 0.7, "speed after over speed before", most=1),
        Parameter("force", F, "N", 1.0, "amplitude of the force"),
        Parameter("frequency", Omega, "rad/s", 1.5, "angular frequency of the force"),
    ),
    phases=(FORTH, BACK),
    frequency=Omega,
)
