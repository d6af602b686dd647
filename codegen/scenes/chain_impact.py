"""Masses in a row, the last of which bounces off a stop (C0)."""

import sympy as sp

from ..scene import Body, Event, Parameter, Phase, Scene

m, k, F, Omega = sp.symbols("m k F Omega", positive=True)
c = sp.Symbol("c", nonnegative=True)
g = sp.Symbol("g", real=True)
r = sp.Symbol("r", positive=True)

#: How many masses there are; springs join them, and the first to the ground.
COUNT = 5

LINKS = sp.Matrix(
    COUNT, COUNT, lambda i, j: (2 - (i == COUNT - 1)) * (i == j) - (abs(i - j) == 1)
)

CHAIN = Body(
    M=m * sp.eye(COUNT),
    K=k * LINKS,
    C=c * LINKS,
    forcing=sp.Matrix([F, *[0] * (COUNT - 1)]),
    at={"end": [0] * (COUNT - 1) + [1]},
)
END = CHAIN.at["end"]

FLIGHT = Phase(
    "flight",
    END.force,
    ends=Event(END.x - g, jump={END.v: -r * END.v}),
    demands={"the last mass stays before the stop": g - END.x},
)

SCENE = Scene(
    "chain-impact",
    f"{COUNT} masses in a row, the last of which bounces off a stop",
    source="textbook: Newton's law of impact at one mass of a chain",
    body=CHAIN,
    parameters=(
        Parameter("mass", m, "kg", 1.0, "each mass"),
        Parameter("damping", c, "N s/m", 0.05, "each damper, beside its spring"),
        Parameter("stiffness", k, "N/m", 1.0, "each spring"),
        Parameter("gap", g, "m", 0.5, "displacement of the last mass at the stop"),
        Parameter("restitution", r, "", 0.7, "speed after over speed before an impact", most=1),
        Parameter("force", F, "N", 1.0, "amplitude of the force on the first mass"),
        Parameter("frequency", Omega, "rad/s", 0.5, "angular frequency of the force"),
    ),
    phases=(FLIGHT,),
    frequency=Omega,
    extremes={
        "a rebound without loss": {r: 1},
        "hardly any damping": {c: sp.Rational(1, 10**6)},
    },
)
