"""A clock: a damped pendulum that gets a kick each time it passes the middle forward (C0)."""

import sympy as sp

from nonsmooth.scene import Event, Parameter, Phase, Scene, a, v, x

m, k, c, I = sp.symbols("m k c I", positive=True)

SWING = Phase(
    "swing",
    m * a + c * v + k * x,
    ends=Event(x, jump={v: v + I / m}, demands={"the pendulum moves forward": v}),
)

SCENE = Scene(
    "escapement",
    "a clock: a damped pendulum and a kick a period",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("damping", c, "N s/m", 0.1, "viscous damping"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness: weight over length, of a pendulum"),
        Parameter("kick", I, "N s", 0.1, "momentum of a kick"),
    ),
    phases=(SWING,),
    scales={"length": I / sp.sqrt(k * m)},
    guess=(2 * sp.pi * sp.sqrt(m / k),),  # and not half of it, where it passes backward
)
