"""A driven mass with dry friction: it slides on, or it stops twice a period (C1)."""

import sympy as sp

from ..scene import Event, Parameter, Phase, Scene, a, forcing, v, x

m, k, F, Omega, F_N, mu_s, mu_k = sp.symbols("m k F Omega F_N mu_s mu_k", positive=True)
c = sp.Symbol("c", nonnegative=True)

SLIDES = m * a + c * v + k * x - mu_k * F_N - F * forcing  # to negative x: friction is upwards
BACKWARD = {"the mass slides backward": -v}
LOAD = F * forcing - k * x

SLIDING = Phase(
    "slide",
    SLIDES,
    ends=Event(v, demands={"the load exceeds the static limit": LOAD - mu_s * F_N}),
    demands=BACKWARD,
)
BEFORE_A_STOP = Phase("slide", SLIDES, ends=Event(v), demands=BACKWARD)
STOP = Phase(
    "stop",
    a,
    held=sp.Integer(0),
    ends=Event(mu_s * F_N - LOAD),
    demands={"the load stays within the static limit": mu_s * F_N - sp.Abs(LOAD)},
)

SCENE = Scene(
    "dry-friction",
    "a driven mass with dry friction",
    source="J. P. Den Hartog, Trans. ASME 53 (1931) 107-115",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("damping", c, "N s/m", 0.1, "viscous damping"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness of the spring"),
        Parameter("normal_force", F_N, "N", 1.0, "normal force"),
        Parameter("mu_s", mu_s, "", 0.3, "coefficient of static friction"),
        Parameter("mu_k", mu_k, "", 0.3, "coefficient of kinetic friction"),
        Parameter("force", F, "N", 1.0, "amplitude of the force"),
        Parameter("frequency", Omega, "rad/s", 0.8, "angular frequency of the force"),
    ),
    motions={"sliding": (SLIDING,), "two-stops": (BEFORE_A_STOP, STOP)},
    frequency=Omega,
    half_period=True,
    requires={"mu_k is at most mu_s": mu_s - mu_k},
    extremes={
        "no damping": {c: 0},
        "hardly any friction": {F_N: F / 10**6},
        "rest for 99.9 % of the time": {F_N: F / mu_s * (1 - sp.Rational(1, 10**6))},
        "friction that falls from 0.3 to 0": {mu_k: mu_s / 10**6},
    },
)
