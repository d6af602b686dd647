"""The methods of the paper, and what is solved in their place: what derives each."""

from collections.abc import Callable, Mapping
from functools import cache
from types import MappingProxyType

from ..system import GalerkinSystem
from .paper import c1, hb, hb_c1
from .reduced import c1_reduced
from .symmetric import hb_symmetric

#: The methods of the paper, in its order, and what derives each.
METHODS: Mapping[str, Callable[[], GalerkinSystem]] = MappingProxyType(
    {"hb": hb.derive, "hb-c1": hb_c1.derive, "c1": c1.derive}
)

#: What is solved in their place, where that is quicker: the same orbits.
SOLVED: Mapping[str, Callable[[], GalerkinSystem]] = MappingProxyType(
    {"hb-symmetric": hb_symmetric.derive, "c1-reduced": c1_reduced.derive}
)


@cache
def of_the_paper(method: str) -> GalerkinSystem:
    """Return the equations of one of these, derived once in a process."""
    known = {**METHODS, **SOLVED}
    if method not in known:
        raise ValueError(f"method: got {method!r}, expected one of {', '.join(known)}")
    return known[method]()
