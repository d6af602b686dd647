"""A mass in two wells: negative stiffness in the middle, unequal rigid stops outside."""

import sympy as sp
from made_scenes import parameters, scene_of

from nonsmooth.scene import Event, Phase, a, forcing, v, x

m, k, K, F, Omega, e, d1, d2 = sp.symbols("m k K F Omega e d1 d2", positive=True)
c, r1, r2 = sp.symbols("c r1 r2", nonnegative=True)
MOVES = m * a + c * v - F * forcing
LEFT_STOP, RIGHT_STOP = (Event(q, jump={v: -r * v}) for q, r in ((x + d1, r1), (x - d2, r2)))

WELLS = scene_of(
    "wells",
    parameters(
        mass=(m, "kg", 1.0), damping=(c, "N s/m", 0.15), stiffness=(k, "N/m", 1.0),
        negative=(K, "N/m", 0.6), edge=(e, "m", 0.5), left=(d1, "m", 1.6), right=(d2, "m", 1.3),
        left_restitution=(r1, "", 0.7), right_restitution=(r2, "", 0.5), force=(F, "N", 0.4),
        frequency=(Omega, "rad/s", 0.9),
    ),
    Phase(
        "mid", MOVES - K * x, Event(x + e) | Event(x - e),
        {"not left": x + e, "not right": e - x},
    ),
    Phase(
        "right", MOVES - K * e + k * (x - e), Event(x - e) | RIGHT_STOP,
        {"outside": x - e, "before the stop": d2 - x},
    ),
    Phase(
        "left", MOVES + K * e + k * (x + e), Event(x + e) | LEFT_STOP,
        {"outside": -x - e, "before the stop": d1 + x},
    ),
    requires={"the left stop is outside": d1 - e, "the right one is outside": d2 - e},
)  # fmt: skip
