"""A mass on a belt whose friction falls as it slips faster (C1)."""

import sympy as sp

from nonsmooth.scene import Event, Parameter, Phase, Scene, a, v, x

m, k, V, f_s, f_k = sp.symbols("m k V f_s f_k", positive=True)
c, w = sp.symbols("c w", nonnegative=True)

STICK = Phase(
    "stick",
    a,
    ends=Event(k * x + c * V - f_s),
    demands={"friction holds the mass": f_s - sp.Abs(k * x + c * V)},
    held=V,
)
SLIP = Phase(
    "slip",
    m * a + c * v + k * x - (f_k - w * (V - v)),
    ends=Event(v - V),
    demands={"the mass is slower than the belt": V - v},
)

SCENE = Scene(
    "weakening-belt",
    "a mass on a belt whose friction falls with the speed of slip",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("damping", c, "N s/m", 0.05, "viscous damping"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness of the spring"),
        Parameter("belt_speed", V, "m/s", 0.5, "speed of the belt"),
        Parameter("static", f_s, "N", 1.0, "friction force that holds the mass at most"),
        Parameter("kinetic", f_k, "N", 0.7, "friction force as slip begins"),
        Parameter("weakening", w, "N s/m", 0.1, "what it loses with the speed of slip"),
    ),
    phases=(STICK, SLIP),
)
