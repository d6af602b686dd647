"""A driven frame of two masses, each with an elastic stop (C2)."""

import sympy as sp

from nonsmooth.scene import Body, Event, Parameter, Phase, Scene

m, k, k_s, c, F, Omega, g_1, g_2 = sp.symbols("m k k_s c F Omega g_1 g_2", positive=True)

K = sp.Matrix([[2, -1], [-1, 1]])
FRAME = Body(
    M=m * sp.eye(2), K=k * K, C=c * K, forcing=[0, F], at={"low": [1, 0], "top": [0, 1]}
)
LOW, TOP = FRAME.at["low"], FRAME.at["top"]

LOW_MEETS, TOP_MEETS = Event(LOW.x - g_1), Event(TOP.x - g_2)
LOW_FREE, LOW_PRESSED = LOW.force, LOW.force + k_s * (LOW.x - g_1)
TOP_FREE, TOP_PRESSED = TOP.force, TOP.force + k_s * (TOP.x - g_2)
OFF_LOW, ON_LOW = {"below, no stop is met": g_1 - LOW.x}, {"below, it presses": LOW.x - g_1}
OFF_TOP, ON_TOP = {"on top, no stop is met": g_2 - TOP.x}, {"on top, it presses": TOP.x - g_2}

FREE = Phase("free", (LOW_FREE, TOP_FREE), TOP_MEETS | LOW_MEETS, OFF_LOW | OFF_TOP)
TOP_ALONE = Phase("top", (LOW_FREE, TOP_PRESSED), LOW_MEETS | TOP_MEETS, OFF_LOW | ON_TOP)
BOTH = Phase("both", (LOW_PRESSED, TOP_PRESSED), TOP_MEETS | LOW_MEETS, ON_LOW | ON_TOP)
LOW_ALONE = Phase("low", (LOW_PRESSED, TOP_FREE), LOW_MEETS | TOP_MEETS, ON_LOW | OFF_TOP)

SCENE = Scene(
    "two-elastic-stops",
    "a driven frame of two masses, each with an elastic stop",
    body=FRAME,
    parameters=(
        Parameter("mass", m, "kg", 1.0, "each mass"),
        Parameter("stiffness", k, "N/m", 1.0, "spring below, and between the masses"),
        Parameter("damping", c, "N s/m", 0.05, "damper beside each spring"),
        Parameter("stop_stiffness", k_s, "N/m", 5.0, "stiffness of the stops"),
        Parameter("gap", g_1, "m", 0.4, "way of the lower mass to its stop"),
        Parameter("top_gap", g_2, "m", 0.6, "way of the upper mass to its stop"),
        Parameter("force", F, "N", 0.3, "amplitude of the force on the upper mass"),
        Parameter("frequency", Omega, "rad/s", 0.7, "angular frequency of the force"),
    ),
    phases=(FREE, TOP_ALONE, BOTH, LOW_ALONE),
    frequency=Omega,
)
