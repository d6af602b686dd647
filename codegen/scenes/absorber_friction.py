"""A driven mass and a tuned absorber on it, with dry friction between them (C1)."""

import sympy as sp

from ..scene import Body, Event, Parameter, Phase, Scene

m1, m2, k1, k2, f_R, F, Omega = sp.symbols("m1 m2 k1 k2 f_R F Omega", positive=True)
c1, c2 = sp.symbols("c1 c2", nonnegative=True)

PAIR = Body(
    M=sp.diag(m1, m2),
    K=sp.Matrix([[k1 + k2, -k2], [-k2, k2]]),
    C=sp.Matrix([[c1 + c2, -c2], [-c2, c2]]),
    forcing=sp.Matrix([F, 0]),
    at={"joint": [-1, 1]},
)
JOINT = PAIR.at["joint"]

SLIP = Phase(
    "slip",
    JOINT.force + f_R,
    ends=Event(JOINT.v),
    demands={"the absorber slips forward": JOINT.v},
)
STICK = Phase(
    "stick",
    JOINT.a,
    ends=Event(JOINT.force - f_R),
    demands={"friction holds": f_R - sp.Abs(JOINT.force)},
    held=0,
)

SCENE = Scene(
    "absorber-friction",
    "a driven mass and a tuned absorber, with dry friction between them",
    source="textbook: J. P. Den Hartog, Mechanical Vibrations",
    body=PAIR,
    parameters=(
        Parameter("mass", m1, "kg", 1.0, "the driven mass"),
        Parameter("absorber_mass", m2, "kg", 0.1, "the absorber"),
        Parameter("stiffness", k1, "N/m", 1.0, "spring to the ground"),
        Parameter("absorber_stiffness", k2, "N/m", 0.1, "spring of the absorber"),
        Parameter("damping", c1, "N s/m", 0.02, "damper to the ground"),
        Parameter("absorber_damping", c2, "N s/m", 0.002, "damper of the absorber"),
        Parameter("friction", f_R, "N", 0.02, "friction between the masses"),
        Parameter("force", F, "N", 0.2, "amplitude of the force on the driven mass"),
        Parameter("frequency", Omega, "rad/s", 0.7, "angular frequency of the force"),
    ),
    phases=(SLIP, STICK),
    frequency=Omega,
    half_period=True,
    extremes={
        "no damping but by friction": {c1: 0, c2: 0},
        "slip almost throughout": {f_R: F / 2000},
    },
)
