"""A gear mesh: stiff with two pairs of teeth in contact, softer with one (C1)."""

import sympy as sp

from nonsmooth.scene import Event, Parameter, Phase, Scene, a, forcing, v, x

m, k_1, k_2, P, Omega = sp.symbols("m k_1 k_2 P Omega", positive=True)
c = sp.Symbol("c", nonnegative=True)

REST = m * a + c * v - P
DOUBLE = Phase(
    "double", REST + k_2 * x, ends=Event(forcing), demands={"two pairs bear": forcing}
)
SINGLE = Phase(
    "single", REST + k_1 * x, ends=Event(forcing), demands={"one pair bears": -forcing}
)

SCENE = Scene(
    "gear-mesh",
    "a gear mesh whose stiffness alternates",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass of the pair, along the line of action"),
        Parameter("damping", c, "N s/m", 0.1, "viscous damping"),
        Parameter("single", k_1, "N/m", 1.0, "stiffness of one pair of teeth"),
        Parameter("double", k_2, "N/m", 1.6, "stiffness of two pairs"),
        Parameter("load", P, "N", 1.0, "static load"),
        Parameter("frequency", Omega, "rad/s", 1.7, "angular frequency of the mesh"),
    ),
    phases=(DOUBLE, SINGLE),
    frequency=Omega,
    scales={"length": P / k_1},
)
