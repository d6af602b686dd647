"""A driven mass that bounces off a stop (C0)."""

import sympy as sp

from ..scene import Event, Parameter, Phase, Scene, a, forcing, v, x

m, k, F, Omega, r = sp.symbols("m k F Omega r", positive=True)
c = sp.Symbol("c", nonnegative=True)
g = sp.Symbol("g", real=True)

FLIGHT = Phase(
    "flight",
    m * a + c * v + k * x - F * forcing,
    ends=Event(x - g, jump={v: -r * v}),
    demands={"the mass stays before the stop": g - x},
)

SCENE = Scene(
    "impact",
    "a driven mass that bounces off a stop",
    source="S. W. Shaw and P. J. Holmes, J. Sound Vib. 90 (1983) 129-155",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("damping", c, "N s/m", 0.1, "viscous damping"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness of the spring"),
        Parameter("force", F, "N", 1.0, "amplitude of the force"),
        Parameter("frequency", Omega, "rad/s", 1.8, "angular frequency of the force"),
        Parameter("gap", g, "m", 0.1, "displacement at which the mass hits the stop"),
        Parameter("restitution", r, "", 0.6, "speed after over speed before an impact", most=1),
    ),
    phases=(FLIGHT,),
    frequency=Omega,
)
