"""A tool that cuts while a tooth is in the work, and that the work may throw off (C1)."""

import sympy as sp

from nonsmooth.scene import Event, Parameter, Phase, Scene, a, forcing, v, x

m, k, k_c, h, Omega = sp.symbols("m k k_c h Omega", positive=True)
c = sp.Symbol("c", nonnegative=True)

FREE = m * a + c * v + k * x
TURN, EDGE = Event(forcing), Event(x - h)  # a tooth enters or leaves; the tool is at the edge
CUT = Phase(
    "cut",
    FREE - k_c * (h - x),
    ends=TURN | EDGE,
    demands={"a tooth is in": forcing, "the tool cuts": h - x},
)
# Both are free: they are two phases since each demands what the other excludes.
OFF = Phase(
    "off",
    FREE,
    ends=TURN | EDGE,
    demands={"a tooth is in": forcing, "the tool is off": x - h},
)
OUT = Phase("out", FREE, ends=TURN, demands={"no tooth is in": -forcing})

SCENE = Scene(
    "interrupted-cut",
    "a tool that cuts for a half of each turn, and that may leave the work",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass of the tool"),
        Parameter("damping", c, "N s/m", 0.05, "viscous damping"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness of the tool"),
        Parameter("cutting", k_c, "N/m", 0.5, "force of the cut by its depth"),
        Parameter("feed", h, "m", 0.1, "depth of the cut of a tool at rest"),
        Parameter("frequency", Omega, "rad/s", 1.0, "angular frequency of the teeth"),
    ),
    phases=(CUT, OUT, OFF),
    frequency=Omega,
    scales={"length": h},
)
