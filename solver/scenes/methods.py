"""What is known of a method beside its kernel: its title, how it converges, how it is drawn."""

from collections.abc import Iterable
from dataclasses import dataclass
from importlib import import_module
from types import ModuleType
from typing import Any

from ...generated.methods import FIRST, METHODS
from .method_names import without_class

__all__ = ["EXACT", "FIRST", "METHODS", "About", "about", "in_order", "module_of"]

#: What the way by the exact flow is called where methods are.
EXACT = "exact"


@dataclass(frozen=True)
class About:
    """What the file of an expansion says of it.

    Parameters
    ----------
    power : bool
        Whether its errors fall as a power of the order; else by a factor with each order.
    look : dict
        Of its curve in pictures: colour, marker, line.
    kernel : str
        The generated module of its kernel; empty of a method without a record.
    unseen : tuple of int
        How many polynomials its tests do not see on a phase, by its class; empty if none.
    functions : tuple of int
        How many functions beside the harmonics it may have at a switch; empty if it has none.
    alone : bool
        Whether it is made for some scenes alone.
    bodies : bool
        Whether there is one of contact forces, for bodies of several degrees of freedom.
    is_series : bool
        Whether it is one series over the period, and not a polynomial on each phase.
    """

    title: str
    power: bool
    look: dict[str, Any]
    kernel: str
    unseen: tuple[int, ...]
    functions: tuple[int, ...]
    alone: bool
    bodies: bool
    is_series: bool


def about(method: str) -> About:
    """Return what is known of a method by its generic name; little of one without a record."""
    own: dict[str, Any] = {"title": method, "power": False, "kernel": ""}
    own |= {"unseen": (), "functions": (), "alone": False, "is_series": False}
    own |= {"bodies": False}
    look: dict[str, Any] = {"color": "0.5", "marker": "x", "linestyle": "--"}
    for name, fact in METHODS.get(without_class(method), {}).items():
        (own if name in own else look)[name] = fact
    if not look.pop("filled", True):
        look["markerfacecolor"] = "white"
    return About(look=look, **own)


def module_of(method: str) -> ModuleType:
    """Return the generated module of a method with a kernel."""
    return import_module(f"...generated.{about(method).kernel}", __package__)


def in_order(methods: Iterable[str]) -> tuple[str, ...]:
    """Return methods in the order in which they are told; one without a record comes last."""
    known = [*METHODS]
    place = {method: i for i, method in enumerate(known)}
    return tuple(sorted(methods, key=lambda m: (place.get(without_class(m), len(known)), m)))
