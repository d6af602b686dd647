"""A driven mass that lands on a stop and rests there until the force pulls it off (C0)."""

import sympy as sp

from nonsmooth.scene import Event, Parameter, Phase, Scene, a, forcing, v, x

m, k, F, Omega = sp.symbols("m k F Omega", positive=True)
c = sp.Symbol("c", nonnegative=True)
g = sp.Symbol("g", real=True)

PRESS = F * forcing - k * g  # on the stop, of a mass that rests there
FLIGHT = Phase(
    "flight",
    m * a + c * v + k * x - F * forcing,
    ends=Event(x - g, jump={v: 0}),  # no rebound: the phase behind it is held at rest
    demands={"the mass stays before the stop": g - x},
)
REST = Phase(
    "rest",
    a,
    ends=Event(PRESS),
    demands={"the force presses": PRESS},
    held=sp.Integer(0),
)

SCENE = Scene(
    "rest-on-a-stop",
    "a driven mass that lands on a stop and rests there",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("damping", c, "N s/m", 0.1, "viscous damping"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness of the spring"),
        Parameter("force", F, "N", 1.0, "amplitude of the force"),
        Parameter("frequency", Omega, "rad/s", 0.7, "angular frequency of the force"),
        Parameter("gap", g, "m", 0.2, "displacement of the stop"),
    ),
    phases=(FLIGHT, REST),
    frequency=Omega,
)
