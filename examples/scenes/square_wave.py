"""An oscillator under a force that is F for half a period and -F for the other (C1)."""

import sympy as sp

from nonsmooth.scene import Event, Parameter, Phase, Scene, a, forcing, v, x

m, k, F, Omega = sp.symbols("m k F Omega", positive=True)
c = sp.Symbol("c", nonnegative=True)

PUSH = Phase(
    "push",
    m * a + c * v + k * x - F,
    ends=Event(forcing),
    demands={"the force is positive": forcing},
)

SCENE = Scene(
    "square-wave",
    "an oscillator under a force that jumps between F and -F",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("damping", c, "N s/m", 0.2, "viscous damping"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness of the spring"),
        Parameter("force", F, "N", 1.0, "size of the force"),
        Parameter("frequency", Omega, "rad/s", 0.7, "angular frequency of the force"),
    ),
    phases=(PUSH,),
    frequency=Omega,
    half_period=True,  # the other half is the same with the opposite sign
    scales={"length": F / k},
)
