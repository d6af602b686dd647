"""The three expansions by name, and what can be had of each."""

from ...scenes.parameter_error import whole
from ..attached import Attached
from ..structure import Structure
from .bare import BareModes
from .forced import ritz_forced
from .pieces import piecewise

#: ``ritz``: sines; ``ritz-ck``: sines and forced modes; ``ck``: functions of class C^k only.
METHODS = ("ritz", "ritz-ck", "ck")

#: Highest orders: sines are sums, Legendre pieces dense matrices.
HIGHEST = {"ritz": 4096, "ritz-ck": 512, "ck": 100}


def generic_method(structure: Structure, method: object) -> str:
    """Return the generic name of a method, which may be spelled with the class.

    Raises
    ------
    ValueError
        If there is none of this name.
    """
    if isinstance(method, str):
        wanted = method.replace(f"c{structure.k}", "ck")
        if wanted in METHODS:
            return wanted
    expected = f"one of {', '.join(METHODS)}: {structure.name} is C{structure.k}"
    raise ValueError(f"method: got {method!r}, expected {expected}")


def shown(structure: Structure, method: str, forced: int = 0) -> str:
    """Return the name of a method with the class: ``ritz-c1``, of two forced modes with (2)."""
    name = method.replace("ck", f"c{structure.k}")
    return f"{name}({forced})" if forced > 1 else name


def check_forced(structure: Structure, method: str, forced: int | None) -> int:
    """Return how many forced modes a method has.

    Raises
    ------
    ValueError
        If there are not so many, or the method has none.
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
    """Return the bare modes of a method at an order, with so many forced modes."""
    if method == "ck":
        return piecewise(attached, order)
    return ritz_forced(attached, order, tuple(range(1, forced + 1)))


def check_count(there_are: int, count: int | None, usual: int, method: str, order: int) -> int:
    """Return how many modes are wanted: as usual, or as many as there are, without a number.

    Raises
    ------
    ValueError
        If there are fewer.
    """
    if count is None:
        return min(usual, there_are)
    if whole("count", count) > there_are:
        raise ValueError(
            f"count: got {count}, {method} at order {order} has {there_are} modes; "
            "expected fewer, or a higher order"
        )
    return count
