"""The symbolic stage: from the equation of motion to the text of the kernels.

Stages, one file each, in the order in which a derivation runs through them:

1. `oscillator`: Section 2 as data.
2. `inner_product`, `fourier`, `slip_moments`, `c1_legendre`: basis functions and the
   inner product (8), in closed form with symbolic indices.
3. `hb`, `hb_c1`, `c1`: Sections 3.1, 3.2, 3.3, each ending in a `system.GalerkinSystem`.
4. `printing` shows the record to a reader, `emit` writes it as a module of kernels,
   `generate` puts the modules into ``generated/``.

Nothing else in the package imports SymPy.
"""

from collections.abc import Callable, Mapping
from functools import cache
from types import MappingProxyType

from . import c1, hb, hb_c1
from .system import DerivationError, Equation, GalerkinSystem

#: The methods of the paper, in its order, and what derives each.
METHODS: Mapping[str, Callable[[], GalerkinSystem]] = MappingProxyType(
    {"hb": hb.derive, "hb-c1": hb_c1.derive, "c1": c1.derive}
)


@cache
def derive(method: str) -> GalerkinSystem:
    """Return the derived equations of a method.

    Parameters
    ----------
    method : {"hb", "hb-c1", "c1"}
        Section 3.1, 3.2 or 3.3 of the paper.

    Raises
    ------
    ValueError
        If `method` is none of these.
    """
    if method not in METHODS:
        known = ", ".join(METHODS)
        raise ValueError(f"method: got {method!r}, expected one of {known}")
    return METHODS[method]()


__all__ = ["METHODS", "DerivationError", "Equation", "GalerkinSystem", "derive"]
