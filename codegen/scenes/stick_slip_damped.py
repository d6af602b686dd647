"""A mass on a moving belt with viscous damping and weakening friction (C1)."""

import sympy as sp

from ..scene import Event, Parameter, Phase, Scene, a, v, x

M, K, V, mu_s, F_N = sp.symbols("M K V mu_s F_N", positive=True)
mu_k, c, w = sp.symbols("mu_k c w", nonnegative=True)

STICK = Phase(
    "stick",
    a,
    held=V,
    ends=Event(mu_s * F_N - K * x - c * V),
    demands={"the load stays within the static limit": mu_s * F_N - sp.Abs(K * x + c * V)},
)
SLIP = Phase(
    "slip",
    M * a + c * v + K * x - (mu_k - w * (V - v)) * F_N,
    ends=Event(v - V),
    demands={"the mass stays slower than the belt": V - v},
)

#: Normal force for which alpha = 1.
UNIT = V * sp.sqrt(K * M) / (mu_s - mu_k)

SCENE = Scene(
    "stick-slip-damped",
    "a damped mass on a moving belt, with weakening friction",
    source="W.-J. Kim and N. C. Perkins, J. Sound Vib. 261 (2003) 213-224, with damping",
    parameters=(
        Parameter("mass", M, "kg", 10.0, "mass"),
        Parameter("stiffness", K, "N/m", 1000.0, "stiffness of the spring"),
        Parameter("belt_speed", V, "m/s", 1.0, "speed of the belt"),
        Parameter("mu_s", mu_s, "", 0.5, "coefficient of static friction"),
        Parameter(
            "mu_k", mu_k, "", 0.25, "coefficient of kinetic friction at the belt's speed"
        ),
        Parameter("normal_force", F_N, "N", 400.0, "normal force"),
        Parameter("damping", c, "N s/m", 5.0, "viscous damping"),
        Parameter("weakening", w, "s/m", 0.0, "fall of the friction coefficient with speed"),
    ),
    phases=(STICK, SLIP),
    requires={"mu_k is at most mu_s": mu_s - mu_k},
    extremes={
        f"alpha = {alpha}, no damping": {c: 0, F_N: sp.sympify(alpha, rational=True) * UNIT}
        for alpha in ("1e-6", "1e-4", "1e-2", "1e2", "1e4", "1e6")
    }
    | {"no damping": {c: 0}},
    scales={"length": V * sp.sqrt(M / K)},
)
