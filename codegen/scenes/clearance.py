"""A driven mass that meets a second spring behind a clearance (C2)."""

import sympy as sp

from ..scene import Event, Parameter, Phase, Scene, a, forcing, v, x

m, k, k_c, F, Omega = sp.symbols("m k k_c F Omega", positive=True)
c = sp.Symbol("c", nonnegative=True)
g = sp.Symbol("g", real=True)

CONTACT = Phase(
    "contact",
    m * a + c * v + k * x + k_c * (x - g) - F * forcing,
    ends=Event(x - g),
    demands={"the second spring is pressed": x - g},
)
SEPARATED = Phase(
    "separated",
    m * a + c * v + k * x - F * forcing,
    ends=Event(x - g),
    demands={"the mass stays off the second spring": g - x},
)

#: Amplitude of the motion without contact.
REACH = F / sp.sqrt((k - m * Omega**2) ** 2 + (c * Omega) ** 2)

SCENE = Scene(
    "clearance",
    "a driven mass with a second spring behind a clearance",
    source="S. W. Shaw and P. J. Holmes, J. Sound Vib. 90 (1983) 129-155",
    parameters=(
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("damping", c, "N s/m", 0.2, "viscous damping"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness of the first spring"),
        Parameter("contact_stiffness", k_c, "N/m", 4.0, "stiffness of the second spring"),
        Parameter("gap", g, "m", 0.5, "displacement at which it meets the second spring"),
        Parameter("force", F, "N", 1.0, "amplitude of the force"),
        Parameter("frequency", Omega, "rad/s", 1.3, "angular frequency of the force"),
    ),
    phases=(CONTACT, SEPARATED),
    frequency=Omega,
    # half a period of both springs together, if the contact is short against the period
    guess=(sp.pi * sp.sqrt(m / (k + k_c)), 2 * sp.pi / Omega),
    extremes={
        "a contact 1e3 times as stiff": {k_c: 1000 * k},
        "a contact 1e6 times as stiff": {k_c: 10**6 * k},
        "a gap 1e-3 of the amplitude": {g: REACH / 1000},
        "no damping": {c: 0},
        "1e-4 before grazing": {g: REACH * (1 - sp.Rational(1, 10**4))},
        "1e-8 before grazing": {g: REACH * (1 - sp.Rational(1, 10**8))},
    },
)
