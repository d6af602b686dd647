"""A driven mass and an absorber joined to it by a spring and a slider in series (C2)."""

import sympy as sp

from ..scene import Event, Memory, Parameter, Phase, Scene
from .absorber_friction import JOINT, PAIR, F, Omega, c1, c2, f_R, k1, k2, m1, m2

k_t = sp.Symbol("k_t", positive=True)
w = sp.Symbol("w", real=True)

PULL = k_t * (JOINT.x - w)

SLIP = Phase(
    "slip",
    JOINT.force + f_R,
    ends=Event(JOINT.v),
    demands={"the joint slips forward": JOINT.v},
)
STICK = Phase(
    "stick",
    JOINT.force + PULL,
    ends=Event(PULL + f_R),
    demands={"the slider holds": f_R - sp.Abs(PULL)},
)

SCENE = Scene(
    "jenkins-absorber",
    "a driven mass and an absorber, joined by a spring and a slider in series",
    source="textbook: the Jenkins element",
    body=PAIR,
    parameters=(
        Parameter("mass", m1, "kg", 1.0, "the driven mass"),
        Parameter("absorber_mass", m2, "kg", 0.1, "the absorber"),
        Parameter("stiffness", k1, "N/m", 1.0, "spring to the ground"),
        Parameter("absorber_stiffness", k2, "N/m", 0.05, "spring of the absorber"),
        Parameter("tangential_stiffness", k_t, "N/m", 0.1, "spring in series with the slider"),
        Parameter("damping", c1, "N s/m", 0.02, "damper to the ground"),
        Parameter("absorber_damping", c2, "N s/m", 0.002, "damper of the absorber"),
        Parameter("friction", f_R, "N", 0.05, "force at which the slider gives way"),
        Parameter("force", F, "N", 0.2, "amplitude of the force on the driven mass"),
        Parameter("frequency", Omega, "rad/s", 1.0, "angular frequency of the force"),
    ),
    phases=(SLIP, STICK),
    frequency=Omega,
    half_period=True,
    memory=(Memory(w, "stick", JOINT.x - f_R / k_t, "where the slider is"),),
    extremes={
        "no damping but by the slider": {c1: 0, c2: 0},
        "slip almost throughout": {f_R: F / 200},
    },
)
