"""A driven mass with a ball in a slot of it, which takes its energy: an impact damper (C0)."""

import sympy as sp

from nonsmooth.scene import Body, Event, Parameter, Phase, Scene

m, m_b, k, F, Omega, g = sp.symbols("m m_b k F Omega g", positive=True)
c, r = sp.symbols("c r", nonnegative=True)

PAIR = Body(
    M=sp.diag(m, m_b),
    K=sp.diag(k, 0),  # nothing holds the ball
    C=sp.diag(c, 0),
    forcing=sp.Matrix([F, 0]),
    at={"ball": [-1, 1]},
)
BALL = PAIR.at["ball"]
FLIGHT = Phase(
    "flight",
    BALL.force,  # zero: the ball flies on
    ends=Event(BALL.x - g, jump={BALL.v: -r * BALL.v}),
    demands={"the ball is in the slot": g - sp.Abs(BALL.x)},
)

SCENE = Scene(
    "ball-in-a-slot",
    "a driven mass with a ball in a slot of it",
    body=PAIR,
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass that is driven"),
        Parameter("ball", m_b, "kg", 0.05, "the ball"),
        Parameter("stiffness", k, "N/m", 1.0, "spring of the mass"),
        Parameter("damping", c, "N s/m", 0.02, "damper of the mass"),
        Parameter("gap", g, "m", 0.5, "half of the way that the ball has"),
        Parameter("restitution", r, "", 0.7, "speed after over speed before", most=1),
        Parameter("force", F, "N", 0.03, "amplitude of the force"),
        Parameter("frequency", Omega, "rad/s", 1.0, "angular frequency of the force"),
    ),
    phases=(FLIGHT,),
    frequency=Omega,
    half_period=True,
)
