"""A steel cantilever with a mass at its tip that bounces off a rigid stop (C0)."""

import numpy as np
import sympy as sp

from ..scene import Body, Event, Parameter, Phase, Scene
from .beam_clearance import COUNT, cantilever

g, r, F, Omega = sp.symbols("g r F Omega", positive=True)
zeta = sp.Symbol("zeta", nonnegative=True)
n_m = sp.Symbol("n_m", positive=True)

#: Mass at the tip in kg: without one an impact has no limit as modes are added.
TIP_MASS = 0.1

MASS, STIFFNESS = cantilever(COUNT)
TIP, MIDDLE = 2 * COUNT - 2, COUNT - 2
MASS[TIP, TIP] += TIP_MASS

BEAM = Body(
    M=MASS,
    K=STIFFNESS,
    ratio=zeta,
    modes=n_m,
    forcing=sp.SparseMatrix(2 * COUNT, 1, {(MIDDLE, 0): F}),
    at={"tip": np.eye(2 * COUNT)[TIP]},
)
END = BEAM.at["tip"]

FLIGHT = Phase(
    "flight",
    END.force,
    ends=Event(END.x - g, jump={END.v: -r * END.v}),
    demands={"the tip stays before the stop": g - END.x},
)

SCENE = Scene(
    "beam-impact",
    "a steel cantilever with a mass at its tip that bounces off a rigid stop",
    source="textbook: Euler-Bernoulli beam, cubic elements; Newton's law of impact",
    body=BEAM,
    parameters=(
        Parameter("ratio", zeta, "", 0.02, "damping ratio of every mode"),
        Parameter("modes", n_m, "", 20.0, "how many modes are kept", most=2 * COUNT),
        Parameter("gap", g, "m", 1e-3, "displacement of the tip at the stop"),
        Parameter("restitution", r, "", 0.6, "speed after over speed before an impact", most=1),
        Parameter("force", F, "N", 1.0, "amplitude of the force at the middle"),
        Parameter("frequency", Omega, "rad/s", 30.0, "angular frequency of the force"),
    ),
    phases=(FLIGHT,),
    frequency=Omega,
    extremes={
        "all modes": {n_m: 2 * COUNT},
        "hardly any loss": {r: sp.Rational(19, 20)},
        "every mode damped by a fifth": {zeta: sp.Rational(1, 5)},
    },
)
