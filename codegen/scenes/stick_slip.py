"""A mass on a moving belt, stick and slip: the oscillator of the paper, (1) and (2) (C1)."""

import sympy as sp

from ..scene import Event, Parameter, Phase, Scene, a, v, x

M, K, V, mu_s, F_N = sp.symbols("M K V mu_s F_N", positive=True)
mu_k = sp.Symbol("mu_k", nonnegative=True)

STICK = Phase(
    "stick",
    a,
    held=V,
    ends=Event(mu_s * F_N - K * x),
    demands={"the spring force stays within the static limit": mu_s * F_N - sp.Abs(K * x)},
)
SLIP = Phase(
    "slip",
    M * a + K * x - mu_k * F_N,
    ends=Event(v - V),
    demands={"the mass stays slower than the belt": V - v},
)

#: The numbers that the paper gives to these equations.
NUMBERS = {
    "motion_stick": "1",
    "motion_slip": "1",
    "held_stick": "2",
    "demands_stick": "2",
    "event_slip": "10",
    "event_slip_after": "10",
}

#: Normal force for which alpha = 1.
UNIT = V * sp.sqrt(K * M) / (mu_s - mu_k)

SCENE = Scene(
    "stick-slip",
    "a mass on a moving belt, stick and slip",
    source="W.-J. Kim and N. C. Perkins, J. Sound Vib. 261 (2003) 213-224",
    parameters=(
        Parameter("mass", M, "kg", 10.0, "mass"),
        Parameter("stiffness", K, "N/m", 1000.0, "stiffness of the spring"),
        Parameter("belt_speed", V, "m/s", 1.0, "speed of the belt"),
        Parameter("mu_s", mu_s, "", 0.5, "coefficient of static friction"),
        Parameter("mu_k", mu_k, "", 0.25, "coefficient of kinetic friction"),
        Parameter("normal_force", F_N, "N", 400.0, "normal force"),
    ),
    phases=(STICK, SLIP),
    requires={"mu_k is at most mu_s": mu_s - mu_k},
    start={x: (2 * mu_k - mu_s) * F_N / K},
    extremes={
        f"alpha = {alpha}": {F_N: sp.sympify(alpha, rational=True) * UNIT}
        for alpha in ("1e-6", "1e-4", "1e-2", "1e2", "1e4", "1e6")
    },
)
