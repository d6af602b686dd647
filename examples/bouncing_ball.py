"""A ball that bounces on a vibrating table (C0): a scene file.

The displacement x is that of the ball above the table.  Seen from the table, whose own is
A cos(Omega t + phi), gravity is -g and the table's acceleration a force:

    nonsmooth solve examples/bouncing_ball.py
"""

import sympy as sp

from nonsmooth.scene import Event, Parameter, Phase, Scene, a, forcing, v, x

g, A, Omega, r = sp.symbols("g A Omega r", positive=True)

FLIGHT = Phase(
    "flight",
    a + g - A * Omega**2 * forcing,  # zero; forcing is cos(Omega t + phi)
    ends=Event(x, jump={v: -r * v}),  # zero where the flight ends, and what becomes of v
    demands={"the ball stays above the table": x},  # not negative
)

SCENE = Scene(
    "bouncing-ball",
    "a ball that bounces on a vibrating table",
    source="P. J. Holmes, J. Sound Vib. 84 (1982) 173-189",
    parameters=(
        Parameter("gravity", g, "m/s^2", 9.81, "acceleration of gravity"),
        Parameter("amplitude", A, "m", 0.004, "amplitude of the table"),
        Parameter("frequency", Omega, "rad/s", 50.0, "angular frequency of the table"),
        Parameter("restitution", r, "", 0.8, "speed after over speed before", most=1),
    ),
    phases=(FLIGHT,),
    frequency=Omega,
)
