"""A mass in two wells: negative stiffness in the middle, unequal rigid stops outside."""

import sympy as sp

import nonsmooth as ns
from nonsmooth.scene import Event, Parameter, Phase, Scene, a, forcing, v, x

m, k, K, F, Omega, e, d1, d2 = sp.symbols("m k K F Omega e d1 d2", positive=True)
c, r1, r2 = sp.symbols("c r1 r2", nonnegative=True)
MOVES = m * a + c * v - F * forcing
LEFT_STOP, RIGHT_STOP = (Event(q, jump={v: -r * v}) for q, r in ((x + d1, r1), (x - d2, r2)))

WELLS = ns.scene(
    Scene(
        "wells",
        "two wells between stops",
        parameters=(
            Parameter("mass", m, "kg", 1.0, "mass"),
            Parameter("damping", c, "N s/m", 0.15, "damping"),
            Parameter("stiffness", k, "N/m", 1.0, "stiffness outside"),
            Parameter("negative", K, "N/m", 0.6, "less the stiffness in the middle"),
            Parameter("edge", e, "m", 0.5, "half the width of the middle"),
            Parameter("left", d1, "m", 1.6, "distance of the left stop"),
            Parameter("right", d2, "m", 1.3, "distance of the right stop"),
            Parameter("left_restitution", r1, "", 0.7, "restitution there", most=1),
            Parameter("right_restitution", r2, "", 0.5, "restitution there", most=1),
            Parameter("force", F, "N", 0.4, "force"),
            Parameter("frequency", Omega, "rad/s", 0.9, "angular frequency"),
        ),
        phases=(
            Phase(
                "mid",
                MOVES - K * x,
                ends=Event(x + e) | Event(x - e),
                demands={"not left": x + e, "not right": e - x},
            ),
            Phase(
                "right",
                MOVES - K * e + k * (x - e),
                ends=Event(x - e) | RIGHT_STOP,
                demands={"outside": x - e, "before the stop": d2 - x},
            ),
            Phase(
                "left",
                MOVES + K * e + k * (x + e),
                ends=Event(x + e) | LEFT_STOP,
                demands={"outside": -x - e, "before the stop": d1 + x},
            ),
        ),
        frequency=Omega,
        requires={"the left stop is outside": d1 - e, "the right one is outside": d2 - e},
    )
)
