"""A steel cantilever with an elastic stop behind a gap at its tip (C2)."""

import numpy as np
import sympy as sp

from ..scene import Body, Event, Parameter, Phase, Scene

k_c, g, F, Omega = sp.symbols("k_c g F Omega", positive=True)
zeta = sp.Symbol("zeta", nonnegative=True)
n_m = sp.Symbol("n_m", positive=True)

#: Elements, and the beam: length in m, bending stiffness in N m^2, mass a length in kg/m.
COUNT, LENGTH, BENDING, LINE = 30, 0.5, 17.5, 0.39


def cantilever(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return mass and stiffness of a clamped beam by cubic elements; deflections, slopes."""
    h = LENGTH / count
    scale = np.array([1, h, 1, h])
    shape = np.outer(scale, scale)
    m = np.array(
        [[156, 22, 54, -13], [22, 4, 13, -3], [54, 13, 156, -22], [-13, -3, -22, 4]]
    ) * (LINE * h / 420)  # fmt: skip
    k = np.array([[12, 6, -12, 6], [6, 4, -6, 2], [-12, -6, 12, -6], [6, 2, -6, 4]]) * (
        BENDING / h**3
    )
    M, K = np.zeros((2, 2 * count + 2, 2 * count + 2))
    for e in range(count):
        dofs = slice(2 * e, 2 * e + 4)
        M[dofs, dofs] += m * shape
        K[dofs, dofs] += k * shape
    return M[2:, 2:], K[2:, 2:]


MASS, STIFFNESS = cantilever(COUNT)
TIP, MIDDLE = 2 * COUNT - 2, COUNT - 2

BEAM = Body(
    M=MASS,
    K=STIFFNESS,
    ratio=zeta,
    modes=n_m,
    forcing=sp.SparseMatrix(2 * COUNT, 1, {(MIDDLE, 0): F}),
    at={"tip": np.eye(2 * COUNT)[TIP]},
)
END = BEAM.at["tip"]

CONTACT = Phase(
    "contact",
    END.force + k_c * (END.x - g),
    ends=Event(END.x - g),
    demands={"the tip presses the stop": END.x - g},
)
SEPARATED = Phase(
    "separated",
    END.force,
    ends=Event(END.x - g),
    demands={"the tip stays before the stop": g - END.x},
)

SCENE = Scene(
    "beam-clearance",
    "a steel cantilever with an elastic stop behind a gap at its tip",
    source="textbook: Euler-Bernoulli beam, cubic elements",
    body=BEAM,
    parameters=(
        Parameter("ratio", zeta, "", 0.01, "damping ratio of every mode"),
        Parameter("modes", n_m, "", 20.0, "how many modes are kept", most=2 * COUNT),
        Parameter("contact_stiffness", k_c, "N/m", 2e3, "stiffness of the stop"),
        Parameter("gap", g, "m", 1e-3, "displacement of the tip at the stop"),
        Parameter("force", F, "N", 1.0, "amplitude of the force at the middle"),
        Parameter("frequency", Omega, "rad/s", 100.0, "angular frequency of the force"),
    ),
    phases=(CONTACT, SEPARATED),
    frequency=Omega,
    extremes={
        "all modes": {n_m: 2 * COUNT},
        "hardly any damping": {zeta: sp.Rational(1, 10**6)},
        "a stop a hundredth as stiff": {k_c: k_c / 100},
    },
)
