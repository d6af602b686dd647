"""A driven mass on an elastic-plastic element, with a static load (C2)."""

import sympy as sp

from nonsmooth.scene import Event, Memory, Parameter, Phase, Scene, a, forcing, v, x

m, k, h, F_y, F, Omega = sp.symbols("m k h F_y F Omega", positive=True)
c, P = sp.symbols("c P", nonnegative=True)
top, bottom = sp.symbols("top bottom", real=True)  # displacements where the motion reverses

REST = m * a + c * v + h * x - P - F * forcing
DOWN, UP = F_y + k * (x - top), -F_y + k * (x - bottom)  # force of the element, elastic
LIMIT = "the force stays within the yield force"
PHASES = (
    Phase("unloads", REST + DOWN, Event(DOWN + F_y), {LIMIT: F_y - sp.Abs(DOWN)}),
    Phase("flows_back", REST - F_y, Event(v), {"the mass moves backward": -v}),
    Phase("loads", REST + UP, Event(UP - F_y), {LIMIT: F_y - sp.Abs(UP)}),
    Phase("flows", REST + F_y, Event(v), {"the mass moves forward": v}),
)

SCENE = Scene(
    "loaded-plasticity",
    "a driven mass on an elastic-plastic element with a static load",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("damping", c, "N s/m", 0.1, "viscous damping"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness of the element while elastic"),
        Parameter("hardening", h, "N/m", 0.2, "stiffness of the spring beside it"),
        Parameter("yield_force", F_y, "N", 0.5, "force at which the element flows"),
        Parameter("load", P, "N", 0.1, "static load"),
        Parameter("force", F, "N", 1.0, "amplitude of the force"),
        Parameter("frequency", Omega, "rad/s", 0.8, "angular frequency of the force"),
    ),
    phases=PHASES,
    frequency=Omega,
    memory=(
        Memory(top, "unloads", x, "displacement where it turns back"),
        Memory(bottom, "loads", x, "displacement where it turns forward"),
    ),
)
