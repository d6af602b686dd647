"""What is known of a method beside its kernel: its title, how it converges, how it is drawn."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from ...generated.methods import FIRST, METHODS
from .method_names import without_class

__all__ = ["EXACT", "FIRST", "METHODS", "About", "about", "in_order"]

#: What the way by the exact flow is called where methods are.
EXACT = "exact"


@dataclass(frozen=True)
class About:
    """What the file of an expansion says of it.

    Parameters
    ----------
    title : str
        What it is.
    power : bool
        Whether its errors fall as a power of the order; else by a factor with each order.
    look : dict
        Of its curve in pictures: colour, marker, line.
    kernel : str or None
        The generated module of its kernel for any scene, if it has one.
    unseen : tuple of int
        How many polynomials its tests do not see on a phase, by its class; empty if none.
    """

    title: str
    power: bool
    look: dict[str, Any]
    kernel: str | None
    unseen: tuple[int, ...]


def about(method: str) -> About:
    """Return what is known of a method by its generic name; little of one without a record.

    Examples
    --------
    >>> about(FIRST).power, about("another").title
    (False, 'another')
    """
    facts: dict[str, Any] = {"title": method, "power": False, "kernel": None, "unseen": ()}
    facts.update(METHODS.get(without_class(method), {}))  # type: ignore[call-overload]
    own = [facts.pop(name) for name in ("title", "power", "kernel", "unseen")]
    look = {"color": "0.5", "marker": "x", "linestyle": "--"} | facts
    if not look.pop("filled", True):
        look["markerfacecolor"] = "white"
    title, power, kernel, unseen = own
    return About(title, power, look, kernel, unseen)


def in_order(methods: Iterable[str]) -> tuple[str, ...]:
    """Return methods in the order in which they are told; one without a record comes last.

    Examples
    --------
    >>> in_order(["another", *reversed(METHODS)]) == (*METHODS, "another")
    True
    """
    known = [*METHODS]
    place = {method: i for i, method in enumerate(known)}
    return tuple(sorted(methods, key=lambda m: (place.get(without_class(m), len(known)), m)))
