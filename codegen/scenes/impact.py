"""A driven mass that bounces off a stop (C0)."""

import sympy as sp

from ..scene import Event, Parameter, Phase, Scene, a, forcing, v, x

m, k, F, Omega, r = sp.symbols("m k F Omega r", positive=True)
c = sp.Symbol("c", nonnegative=True)
g = sp.Symbol("g", real=True)

FLIGHT = Phase(
    "flight",
    m * a + c * v + k * x - F * forcing,
    ends=Event(x - g, jump={v: -r * v}),
    demands={"the mass stays before the stop": g - x},
)

#: Amplitude of the motion without impacts, and where that hardly reaches the stop: there the
#: mass impacts slowly, since the frequency is above twice the natural one.
REACH = F / sp.sqrt((k - m * Omega**2) ** 2 + (c * Omega) ** 2)
FAST = sp.Rational(5, 2) * sp.sqrt(k / m)


def grazing(part: sp.Expr) -> dict[sp.Symbol, sp.Expr]:
    """Return the parameters where the gap is a part less than the amplitude."""
    return {Omega: FAST, g: (1 - part) * REACH.subs(Omega, FAST)}


SCENE = Scene(
    "impact",
    "a driven mass that bounces off a stop",
    source="S. W. Shaw and P. J. Holmes, J. Sound Vib. 90 (1983) 129-155",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("damping", c, "N s/m", 0.1, "viscous damping"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness of the spring"),
        Parameter("force", F, "N", 1.0, "amplitude of the force"),
        Parameter("frequency", Omega, "rad/s", 1.8, "angular frequency of the force"),
        Parameter("gap", g, "m", 0.1, "displacement at which the mass hits the stop"),
        Parameter("restitution", r, "", 0.6, "speed after over speed before an impact", most=1),
    ),
    phases=(FLIGHT,),
    frequency=Omega,
    extremes={
        "hardly any rebound": {r: 0.05},
        "a rebound without loss": {r: 1},
        "no damping": {c: 0},
        "1e-4 before grazing": grazing(sp.Rational(1, 10**4)),
        "1e-8 before grazing": grazing(sp.Rational(1, 10**8)),
        "a stop 1e-3 of the amplitude away": {g: REACH / 1000},
    },
)
