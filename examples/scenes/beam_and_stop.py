"""A steel cantilever from its matrices, with an elastic stop at its tip (C2)."""

import numpy as np
import sympy as sp

from nonsmooth.scene import Body, Event, Parameter, Phase, Scene

COUNT, LENGTH, EI, LINE = 8, 0.5, 17.5, 0.39  # elements, m, N m^2, kg/m
h = LENGTH / COUNT
M, K = np.zeros((2, 2 * COUNT + 2, 2 * COUNT + 2))
for e in range(COUNT):  # a deflection and a slope, times h, at each end
    here = slice(2 * e, 2 * e + 4)
    M[here, here] += LINE * h / 420 * np.array(
        [[156, 22, 54, -13], [22, 4, 13, -3], [54, 13, 156, -22], [-13, -3, -22, 4]]
    )  # fmt: skip
    K[here, here] += EI / h**3 * np.array(
        [[12, 6, -12, 6], [6, 4, -6, 2], [-12, -6, 12, -6], [6, 2, -6, 4]]
    )  # fmt: skip
force, tip = np.zeros((2, 2 * COUNT))
force[COUNT - 2], tip[-2] = 1.0, 1.0  # 1 N in the middle

k, g, Omega = sp.symbols("k g Omega", positive=True)
BEAM = Body(M=M[2:, 2:], K=K[2:, 2:], ratio=0.01, modes=6, forcing=force, at={"tip": tip})
TIP = BEAM.at["tip"]
TOUCH = Phase("touch", TIP.force + k * (TIP.x - g), Event(TIP.x - g), {"it presses": TIP.x - g})
FREE = Phase("free", TIP.force, Event(TIP.x - g), {"it is before the stop": g - TIP.x})

SCENE = Scene(
    "beam-and-stop",
    "a steel cantilever with an elastic stop at its tip",
    body=BEAM,
    parameters=(
        Parameter("stop", k, "N/m", 2000.0, "stiffness of the stop"),
        Parameter("gap", g, "m", 0.001, "displacement of the tip at the stop"),
        Parameter("frequency", Omega, "rad/s", 100.0, "angular frequency of the force"),
    ),
    phases=(TOUCH, FREE),
    frequency=Omega,
)
