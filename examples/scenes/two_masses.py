"""Two masses in a row, the second of which bounces off a stop (C0)."""

import sympy as sp

from nonsmooth.scene import Body, Event, Parameter, Phase, Scene

m_1, m_2, k_1, k_2, F, Omega, g = sp.symbols("m_1 m_2 k_1 k_2 F Omega g", positive=True)
c, r = sp.symbols("c r", nonnegative=True)

ROW = Body(
    M=sp.diag(m_1, m_2),
    K=sp.Matrix([[k_1 + k_2, -k_2], [-k_2, k_2]]),
    C=c * sp.Matrix([[2, -1], [-1, 1]]),
    forcing=sp.Matrix([F, 0]),
    at={"end": [0, 1]},
)
END = ROW.at["end"]
FLIGHT = Phase(
    "flight",
    END.force,  # zero: nothing touches the second mass
    ends=Event(END.x - g, jump={END.v: -r * END.v}),
    demands={"the second mass stays before the stop": g - END.x},
)

SCENE = Scene(
    "two-masses",
    "two masses in a row, the second of which bounces off a stop",
    body=ROW,
    parameters=(
        Parameter("first_mass", m_1, "kg", 1.0, "mass that is driven"),
        Parameter("second_mass", m_2, "kg", 0.5, "mass that bounces"),
        Parameter("first_stiffness", k_1, "N/m", 1.0, "spring to the ground"),
        Parameter("second_stiffness", k_2, "N/m", 1.0, "spring between the masses"),
        Parameter("damping", c, "N s/m", 0.1, "each damper, beside its spring"),
        Parameter("gap", g, "m", 0.4, "way of the second mass to the stop"),
        Parameter("restitution", r, "", 0.6, "speed after over speed before", most=1),
        Parameter("force", F, "N", 1.0, "amplitude of the force"),
        Parameter("frequency", Omega, "rad/s", 1.3, "angular frequency of the force"),
    ),
    phases=(FLIGHT,),
    frequency=Omega,
)
