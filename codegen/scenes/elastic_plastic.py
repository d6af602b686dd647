"""A driven mass on an elastic-plastic element: it yields, reverses, yields (C2).

The element has the force z: ``z' = k x'`` while it is elastic, ``|z| = F_y`` while it flows.
Where the motion reverses at the displacement w, z is at the limit, and unloads from it:
``z = F_y + k (x - w)`` as the mass moves back.
"""

import sympy as sp

from ..scene import Event, Memory, Parameter, Phase, Scene, a, forcing, v, x

m, k, F, Omega, F_y = sp.symbols("m k F Omega F_y", positive=True)
c, h = sp.symbols("c h", nonnegative=True)
w = sp.Symbol("w", real=True)

Z = F_y + k * (x - w)
REST = m * a + c * v + h * x - F * forcing

ELASTIC = Phase(
    "elastic",
    REST + Z,
    ends=Event(Z + F_y),
    demands={"the force stays within the yield force": F_y - sp.Abs(Z)},
)
PLASTIC = Phase(
    "plastic",
    REST - F_y,
    ends=Event(v),
    demands={"the mass moves backward": -v},
)

#: Force of the element where it does not yield.
REACH = k * F / sp.sqrt((h + k - m * Omega**2) ** 2 + (c * Omega) ** 2)

SCENE = Scene(
    "elastic-plastic",
    "a driven mass on an elastic-plastic element",
    source="T. K. Caughey, J. Appl. Mech. 27 (1960) 640-643",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("damping", c, "N s/m", 0.1, "viscous damping"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness of the element while elastic"),
        Parameter("yield_force", F_y, "N", 0.5, "force at which the element flows"),
        Parameter("hardening", h, "N/m", 0.2, "stiffness of the spring beside it"),
        Parameter("force", F, "N", 1.0, "amplitude of the force"),
        Parameter("frequency", Omega, "rad/s", 0.8, "angular frequency of the force"),
    ),
    phases=(ELASTIC, PLASTIC),
    frequency=Omega,
    half_period=True,  # and without hardening, when any mean would do, this one has mean zero
    extremes={
        "no hardening": {h: 0},
        "no damping": {c: 0},
        "a yield force 1e-6 below the elastic one": {F_y: REACH * (1 - sp.Rational(1, 10**6))},
        "a yield force 1e-10 below the elastic one": {
            F_y: REACH * (1 - sp.Rational(1, 10**10))
        },
        "hardly ever elastic": {F_y: F / 1000},
        "an element 1e3 times as stiff": {k: 1000 * m * Omega**2},
    },
    memory=(Memory(w, "elastic", x, "displacement where the motion reverses"),),
)
