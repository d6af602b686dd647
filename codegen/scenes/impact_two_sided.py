"""A driven mass that bounces to and fro between two stops (C0)."""

import sympy as sp

from ..scene import Event, Parameter, Phase, Scene, a, forcing, v, x

m, k, F, Omega, g, r = sp.symbols("m k F Omega g r", positive=True)
c = sp.Symbol("c", nonnegative=True)

CROSSING = Phase(
    "crossing",  # from the stop at g to that at -g
    m * a + c * v + k * x - F * forcing,
    ends=Event(x + g, jump={v: -r * v}),
    demands={"the mass stays between the stops": g - sp.Abs(x)},
)

#: Amplitude of the motion without impacts, and where that hardly reaches the stops: there the
#: mass impacts slowly, since the frequency is between half the natural one and that.
REACH = F / sp.sqrt((k - m * Omega**2) ** 2 + (c * Omega) ** 2)
SLOW = sp.Rational(4, 5) * sp.sqrt(k / m)


def grazing(part: sp.Expr) -> dict[sp.Symbol, sp.Expr]:
    """Return the parameters where the gap is a part less than the amplitude."""
    return {Omega: SLOW, g: (1 - part) * REACH.subs(Omega, SLOW)}


SCENE = Scene(
    "impact-two-sided",
    "a driven mass that bounces between two stops",
    source="S. W. Shaw, J. Appl. Mech. 52 (1985) 453-464",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("damping", c, "N s/m", 0.1, "viscous damping"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness of the spring"),
        Parameter("force", F, "N", 1.0, "amplitude of the force"),
        Parameter("frequency", Omega, "rad/s", 1.2, "angular frequency of the force"),
        Parameter("gap", g, "m", 0.8, "distance of each stop from the middle"),
        Parameter("restitution", r, "", 0.6, "speed after over speed before an impact", most=1),
    ),
    phases=(CROSSING,),
    frequency=Omega,
    half_period=True,
    extremes={
        "hardly any rebound": {r: 0.05},
        "a rebound without loss": {r: 1},
        "no damping": {c: 0},
        "1e-4 before grazing": grazing(sp.Rational(1, 10**4)),
        "1e-8 before grazing": grazing(sp.Rational(1, 10**8)),
    },
)
