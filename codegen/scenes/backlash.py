"""A driven mass with a spring that has play on both sides (C2)."""

import sympy as sp

from ..scene import Event, Parameter, Phase, Scene, a, forcing, v, x

m, k, g, F, Omega = sp.symbols("m k g F Omega", positive=True)
c, k_0 = sp.symbols("c k_0", nonnegative=True)

ENGAGED = Phase(
    "engaged",
    m * a + c * v + k_0 * g + k * (x - g) - F * forcing,
    ends=Event(x - g),
    demands={"the spring is engaged": x - g},
)
LOOSE = Phase(
    "loose",
    m * a + c * v + k_0 * x - F * forcing,
    ends=Event(x + g),
    demands={"the mass stays within the play": g - sp.Abs(x)},
)

SCENE = Scene(
    "backlash",
    "a driven mass with play on both sides of its spring",
    source="S. Natsiavas, J. Sound Vib. 134 (1989) 315-331",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("damping", c, "N s/m", 0.1, "viscous damping"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness beyond the play"),
        Parameter("gap_stiffness", k_0, "N/m", 0.0, "stiffness within the play"),
        Parameter("gap", g, "m", 1.0, "half of the play"),
        Parameter("force", F, "N", 0.8, "amplitude of the force"),
        Parameter("frequency", Omega, "rad/s", 0.7, "angular frequency of the force"),
    ),
    phases=(ENGAGED, LOOSE),
    frequency=Omega,
    half_period=True,
    extremes={
        "a play 1e-3 as wide": {g: F / k / 1000},
        "hardly any spring within the play": {k_0: k / 10**6},
        "a spring 1e6 times as stiff": {k: 10**6 * m * Omega**2, k_0: m * Omega**2},
        "no damping": {c: 0},
    },
)
