"""A steel rod from two files of matrices, with an elastic stop at its end (C2)."""

from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import sympy as sp
from scipy import sparse

from nonsmooth.scene import Body, Event, Parameter, Phase, Scene

COUNT, LENGTH, EA, LINE = 200, 2.0, 2.1e7, 0.78  # elements, m, N, kg/m
h = LENGTH / COUNT

with TemporaryDirectory() as folder:  # in place of what a finite-element program wrote
    where = Path(folder)
    twice = np.append(np.full(COUNT - 1, 2.0), 1.0)  # the left end is held
    for name, main, beside in (("M", LINE * h / 3, LINE * h / 6), ("K", EA / h, -EA / h)):
        rows = sparse.diags_array(
            [main * twice, *[np.full(COUNT - 1, beside)] * 2], offsets=[0, 1, -1]
        )
        sparse.save_npz(where / f"{name}.npz", rows.tocsc())
    M, K = (sparse.load_npz(where / f"{name}.npz") for name in "MK")

w = np.eye(COUNT)[-1]
k, g, Omega = sp.symbols("k g Omega", positive=True)
ROD = Body(M=M, K=K, ratio=0.01, modes=20, forcing=2e3 * w, at={"end": w})
END = ROD.at["end"]
TOUCH = Phase("touch", END.force + k * (END.x - g), Event(END.x - g), {"it presses": END.x - g})
FREE = Phase("free", END.force, Event(END.x - g), {"it is before the stop": g - END.x})

SCENE = Scene(
    "rod-and-stop",
    "a steel rod with an elastic stop at its end",
    body=ROD,
    parameters=(
        Parameter("stop", k, "N/m", 2e7, "stiffness of the stop"),
        Parameter("gap", g, "m", 1e-4, "displacement of the end at the stop"),
        Parameter("frequency", Omega, "rad/s", 3000.0, "angular frequency of the force"),
    ),
    phases=(TOUCH, FREE),
    frequency=Omega,
)
