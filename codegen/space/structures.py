"""The structures: one record each; the class of each is deduced."""

from collections.abc import Mapping
from types import MappingProxyType

import sympy as sp

from ...nearest import one_of
from ..scene import Parameter
from .data import Bare, L, Structure

EI, rho_A, T, rho_L = sp.symbols("EI rho_A T rho_L", positive=True)
k_r, k, m_0, J, theta = sp.symbols("k_r k m_0 J theta", positive=True)

_LENGTH = Parameter("length", L, "m", 1.0, "length between the supports")

BEAM = Bare(
    "beam",
    2,
    (
        _LENGTH,
        Parameter("bending_stiffness", EI, "N m^2", 1.0, "bending stiffness"),
        Parameter("mass_per_length", rho_A, "kg/m", 1.0, "mass per length"),
    ),
    sp.sqrt(EI / rho_A) / L**2,
    EI,
)

STRING = Bare(
    "string",
    1,
    (
        _LENGTH,
        Parameter("tension", T, "N", 1.0, "tension of a string or cable; of a rod, E A"),
        Parameter("mass_per_length", rho_L, "kg/m", 1.0, "mass per length"),
    ),
    sp.sqrt(T / rho_L) / L,
    T,
)

# As the paper cites them in Section 1.
_GU = "K. Gu and B. H. Tongue, J. Appl. Mech. 54 (1987) 904-909"
_LIN = "H. P. Lin and N. C. Perkins, J. Sound Vib. 179 (1995) 131-149"
_SHEN = "M.-H. H. Shen and C. Pierre, J. Sound Vib. 138 (1990) 115-134"

_ALL = (
    Structure(
        "beam-rotational-spring",
        "a beam with a rotational spring",
        BEAM,
        felt=1,
        kind="stiffness",
        attached=Parameter("stiffness", k_r, "N m/rad", 10.0, "stiffness of the spring"),
        strength=k_r * L / EI,
        source=_GU,
    ),
    Structure(
        "beam-rotary-inertia",
        "a beam with a rotary inertia",
        BEAM,
        felt=1,
        kind="inertia",
        attached=Parameter("inertia", J, "kg m^2", 10.0, "moment of inertia"),
        strength=J / (rho_A * L**3),
    ),
    Structure(
        "beam-spring",
        "a beam with a spring",
        BEAM,
        felt=0,
        kind="stiffness",
        attached=Parameter("stiffness", k, "N/m", 10.0, "stiffness of the spring"),
        strength=k * L**3 / EI,
    ),
    Structure(
        "beam-mass",
        "a beam with a mass",
        BEAM,
        felt=0,
        kind="inertia",
        attached=Parameter("mass", m_0, "kg", 10.0, "mass attached"),
        strength=m_0 / (rho_A * L),
    ),
    Structure(
        "beam-crack",
        "a beam with an open crack, as a hinge with a rotational spring",
        BEAM,
        felt=2,
        kind="compliance",
        attached=Parameter("compliance", theta, "rad/(N m)", 10.0, "angle per moment"),
        strength=theta * EI / L,
        source=_SHEN,
    ),
    Structure(
        "string-mass",
        "a string, cable or rod with a mass",
        STRING,
        felt=0,
        kind="inertia",
        attached=Parameter("mass", m_0, "kg", 10.0, "mass attached"),
        strength=m_0 / (rho_L * L),
        source=_LIN,
    ),
    Structure(
        "string-spring",
        "a string, cable or rod with a spring",
        STRING,
        felt=0,
        kind="stiffness",
        attached=Parameter("stiffness", k, "N/m", 10.0, "stiffness of the spring"),
        strength=k * L / T,
    ),
)

#: All structures by name.
STRUCTURES: Mapping[str, Structure] = MappingProxyType({q.name: q for q in _ALL})


def structure_named(name: str) -> Structure:
    """Return a structure by its name.

    A `ValueError` names the nearest structure that there is.
    """
    if name not in STRUCTURES:
        raise ValueError(f"structure: got {name!r}, expected {one_of(name, STRUCTURES)}")
    return STRUCTURES[name]
