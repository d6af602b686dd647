"""A driven mass between two stops at different distances (C0)."""

import sympy as sp

from nonsmooth.scene import Event, Parameter, Phase, Scene, a, forcing, v, x

m, k, F, Omega, left, right = sp.symbols("m k F Omega left right", positive=True)
c, r = sp.symbols("c r", nonnegative=True)

REST = m * a + c * v + k * x - F * forcing
BETWEEN = {"the mass is left of the right stop": right - x, "and right of the left": x + left}
BACK = Phase("back", REST, ends=Event(x + left, jump={v: -r * v}), demands=BETWEEN)
FORTH = Phase("forth", REST, ends=Event(x - right, jump={v: -r * v}), demands=BETWEEN)

SCENE = Scene(
    "unequal-stops",
    "a driven mass between two stops at different distances",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("damping", c, "N s/m", 0.1, "viscous damping"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness of the spring"),
        Parameter("force", F, "N", 1.0, "amplitude of the force"),
        Parameter("frequency", Omega, "rad/s", 1.2, "angular frequency of the force"),
        Parameter("left", left, "m", 0.6, "way to the left stop"),
        Parameter("right", right, "m", 0.9, "way to the right stop"),
        Parameter("restitution", r, "", 0.6, "speed after over speed before", most=1),
    ),
    phases=(BACK, FORTH),
    frequency=Omega,
)
