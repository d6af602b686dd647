"""A driven mass that hits a stop, stays, and rests on it until it is pulled off (C0)."""

import sympy as sp

from ..scene import Event, Parameter, Phase, Scene, a, forcing, v, x

m, k, F, Omega = sp.symbols("m k F Omega", positive=True)
c = sp.Symbol("c", nonnegative=True)
g = sp.Symbol("g", real=True)

PRESSES = F * forcing - k * g  # what presses a mass at rest on to the stop

FLIGHT = Phase(
    "flight",
    m * a + c * v + k * x - F * forcing,
    ends=Event(x - g, jump={v: 0}),
    demands={"the mass stays before the stop": g - x},
)
REST = Phase(
    "rest",
    a,
    held=sp.Integer(0),
    ends=Event(PRESSES),
    demands={"the mass is pressed on to the stop": PRESSES},
)

SCENE = Scene(
    "impact-inelastic",
    "a driven mass that hits a stop and rests on it",
    source="S. W. Shaw and P. J. Holmes, J. Sound Vib. 90 (1983) 129-155, with restitution 0",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("damping", c, "N s/m", 0.1, "viscous damping"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness of the spring"),
        Parameter("force", F, "N", 1.0, "amplitude of the force"),
        Parameter("frequency", Omega, "rad/s", 1.2, "angular frequency of the force"),
        Parameter("gap", g, "m", 0.1, "displacement at which the mass hits the stop"),
    ),
    phases=(FLIGHT, REST),
    frequency=Omega,
    extremes={
        "no damping": {c: 0},
        "a stop where the spring is free": {g: 0},
        "rest for 0.6 % of the time": {Omega: sp.Rational(9, 5) * sp.sqrt(k / m)},
    },
)
