"""A driven mass and a spring with a dashpot that push it and never pull (C1)."""

import sympy as sp

from nonsmooth.scene import Event, Parameter, Phase, Scene, a, forcing, v, x

m, k, F, Omega, k_c, c_c = sp.symbols("m k F Omega k_c c_c", positive=True)
c, g = sp.symbols("c g", nonnegative=True)

PUSH = k_c * (x - g) + c_c * v  # it would pull before the mass is back at the gap
CONTACT = Phase(
    "contact",
    m * a + c * v + k * x + PUSH - F * forcing,
    ends=Event(PUSH),
    demands={"the stop pushes": PUSH},
)
FREE = Phase("free", m * a + c * v + k * x - F * forcing, ends=Event(x - g))

SCENE = Scene(
    "pushing-stop",
    "a driven mass and a spring with a dashpot that only push",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("damping", c, "N s/m", 0.1, "viscous damping"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness of the spring"),
        Parameter("contact_stiffness", k_c, "N/m", 20.0, "stiffness of the stop"),
        Parameter("contact_damping", c_c, "N s/m", 2.0, "damping of the stop"),
        Parameter("gap", g, "m", 0.3, "way to the stop"),
        Parameter("force", F, "N", 1.0, "amplitude of the force"),
        Parameter("frequency", Omega, "rad/s", 1.3, "angular frequency of the force"),
    ),
    phases=(CONTACT, FREE),
    frequency=Omega,
)
