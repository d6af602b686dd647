"""A driven frame on two friction joints, each a spring and a slider in series (C2)."""

import sympy as sp

from nonsmooth.scene import Body, Event, Memory, Parameter, Phase, Scene

k_t, f_1, f_2, F, Omega = sp.symbols("k_t f_1 f_2 F Omega", positive=True)
w_1, w_2 = sp.symbols("w_1 w_2", real=True)

K = sp.Matrix([[2, -1], [-1, 1]])
FRAME = Body(M=sp.eye(2), K=K, C=K / 20, forcing=[0, F], at={"low": [1, 0], "top": [0, 1]})
LOW, TOP = FRAME.at["low"], FRAME.at["top"]
PULL_1, PULL_2 = k_t * (LOW.x - w_1), k_t * (TOP.x - w_2)

LOW_STICKS, LOW_SLIPS = LOW.force + PULL_1, LOW.force + f_1
TOP_STICKS, TOP_SLIPS, TOP_BACK = TOP.force + PULL_2, TOP.force + f_2, TOP.force - f_2
LOW_HOLDS = {"the lower slider holds": f_1 - sp.Abs(PULL_1)}
TOP_HOLDS = {"the upper slider holds": f_2 - sp.Abs(PULL_2)}
LOW_FORTH, TOP_FORTH = {"below it slips forward": LOW.v}, {"on top it slips forward": TOP.v}
TOP_BACKWARD = {"on top it slips back": -TOP.v}


def gives(pull, limit, forth, back):
    """Return the events at which a slider gives way, and what follows each."""
    return Event(pull - limit, to=forth) | Event(pull + limit, to=back)


def stops(contact, then):
    """Return the event at which a slider stops."""
    return Event(contact.v, to=then)


PHASES = (
    Phase(
        "stick",
        (LOW_STICKS, TOP_STICKS),
        gives(PULL_1, f_1, "low", "-low") | gives(PULL_2, f_2, "top", "-top"),
        LOW_HOLDS | TOP_HOLDS,
    ),
    Phase(
        "low",
        (LOW_SLIPS, TOP_STICKS),
        stops(LOW, "stick") | gives(PULL_2, f_2, "both", "apart"),
        LOW_FORTH | TOP_HOLDS,
    ),
    Phase(
        "both",
        (LOW_SLIPS, TOP_SLIPS),
        stops(LOW, "top") | stops(TOP, "low"),
        LOW_FORTH | TOP_FORTH,
    ),
    Phase(
        "apart",
        (LOW_SLIPS, TOP_BACK),
        stops(LOW, "-top") | stops(TOP, "low"),
        LOW_FORTH | TOP_BACKWARD,
    ),
    Phase(
        "top",
        (LOW_STICKS, TOP_SLIPS),
        stops(TOP, "stick") | gives(PULL_1, f_1, "both", "-apart"),
        LOW_HOLDS | TOP_FORTH,
    ),
)

SCENE = Scene(
    "two-joints",
    "a driven frame on two friction joints",
    body=FRAME,
    parameters=(
        Parameter("joint_stiffness", k_t, "N/m", 1.0, "spring in series with each slider"),
        Parameter("low_friction", f_1, "N", 0.1, "force at which the lower slider gives way"),
        Parameter("top_friction", f_2, "N", 0.2, "force at which the upper one does"),
        Parameter("force", F, "N", 0.3, "amplitude of the force on the upper mass"),
        Parameter("frequency", Omega, "rad/s", 0.6, "angular frequency of the force"),
    ),
    phases=PHASES,
    frequency=Omega,
    half_period=True,
    memory=(
        Memory(w_1, ("stick", "top"), LOW.x + LOW.force / k_t, "where the lower slider is"),
        Memory(w_2, ("stick", "low"), TOP.x + TOP.force / k_t, "where the upper slider is"),
    ),
)
