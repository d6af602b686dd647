"""The three expansions by name, and checks of their options."""

from ...scenes.parameter_error import whole
from ..attached import Attached
from ..structure import Structure
from .bare import BareModes
from .forced import ritz_forced
from .pieces import piecewise

#: ``ritz``: sines; ``ritz-ck``: sines and forced modes; ``ck``: functions of class C^k only.
METHODS = ("ritz", "ritz-ck", "ck")

#: Highest orders; those of ``ck`` need dense matrices.
HIGHEST = {"ritz": 4096, "ritz-ck": 512, "ck": 100}


def generic_method(structure: Structure, method: object) -> str:
    """Return the generic name of a method whose name may contain the class.

    Raises
    ------
    ValueError
        If no method has this name.
    """
    if isinstance(method, str):
        name = method.replace(f"c{structure.k}", "ck")
        if name in METHODS:
            return name
    expected = f"one of {', '.join(METHODS)}: {structure.name} is C{structure.k}"
    raise ValueError(f"method: got {method!r}, expected {expected}")


def shown(structure: Structure, method: str, forced: int = 0) -> str:
    """Return the name of a method with the class: ``ritz-c1``, or ``ritz-c1(2)``."""
    name = method.replace("ck", f"c{structure.k}")
    return f"{name}({forced})" if forced > 1 else name


def check_forced(structure: Structure, method: str, forced: int | None) -> int:
    """Return the number of forced modes, by default 1 for the method that has them.

    Raises
    ------
    ValueError
        If there are fewer, or the method has none.
    """
    if method != "ritz-ck":
        if forced is not None:
            raise ValueError(f"forced: got {forced!r}, {method} has no forced modes")
        return 0
    return whole("forced", 1 if forced is None else forced, 1, structure.most_forced)


def check_order(method: str, order: object) -> int:
    """Return the order of a method; a ValueError if it is not one in its range."""
    return whole("order", order, 1, HIGHEST[method], f" for {method}")


def bare_modes(attached: Attached, method: str, order: int, forced: int) -> BareModes:
    """Return the bare modes of a method at an order, with a number of forced modes."""
    if method == "ck":
        return piecewise(attached, order)
    return ritz_forced(attached, order, tuple(range(1, forced + 1)))
