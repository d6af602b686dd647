"""A driven mass with play in its spring, and a static load (C2)."""

import sympy as sp

from nonsmooth.scene import Event, Parameter, Phase, Scene, a, forcing, v, x

m, k, F, Omega, g = sp.symbols("m k F Omega g", positive=True)
c, P = sp.symbols("c P", nonnegative=True)

REST = m * a + c * v - P - F * forcing
RIGHT = Phase(
    "right", REST + k * (x - g), ends=Event(x - g), demands={"the right flank bears": x - g}
)
PLAY = Phase("play", REST, ends=Event(x - g), demands={"the mass is in the play": g - x})

SCENE = Scene(
    "loaded-backlash",
    "a driven mass with play in its spring and a static load",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("damping", c, "N s/m", 0.1, "viscous damping"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness of the flanks"),
        Parameter("gap", g, "m", 1.0, "half of the play"),
        Parameter("load", P, "N", 0.5, "static load"),
        Parameter("force", F, "N", 0.6, "amplitude of the force"),
        Parameter("frequency", Omega, "rad/s", 0.8, "angular frequency of the force"),
    ),
    phases=(RIGHT, PLAY),
    frequency=Omega,
)
