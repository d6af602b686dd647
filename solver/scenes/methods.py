"""What is known of methods beside their kernels: names, convergence, looks."""

from collections.abc import Iterable
from dataclasses import dataclass
from importlib import import_module
from types import ModuleType
from typing import Any

from ...generated import methods as generated
from .loaded import LoadedScene

#: The method that is meant where none is named, and what the files of all say of them.
FIRST, METHODS = generated.FIRST, generated.METHODS

#: What the way by the exact flow is called where methods are.
EXACT = "exact"

#: Stands for the class C^k in the generic name of a method.
CLASS = "ck"

#: What stands there of functions of class C^1, where the scene is smoother.
CLASS_ONE = CLASS.replace("k", "1")


@dataclass(frozen=True)
class About:
    """What the file of an expansion says of it.

    Parameters
    ----------
    look : dict
        Of its curve in pictures: colour, marker, line.
    power : bool
        Whether its errors fall as a power of the order; else by a factor with each order.
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
    look: dict[str, Any]
    power: bool = False
    kernel: str = ""
    unseen: tuple[int, ...] = ()
    functions: tuple[int, ...] = ()
    alone: bool = False
    bodies: bool = False
    is_series: bool = False


def about(method: str) -> About:
    """Return what is known of a method by its generic name; little of one without a record."""
    look: dict[str, Any] = {"color": "0.5", "marker": "x", "linestyle": "--"}
    look |= {"title": method} | METHODS.get(without_class(method), {})
    own = {name: look.pop(name) for name in About.__annotations__ if name in look}
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


def methods(scene: LoadedScene) -> tuple[str, ...]:
    """Return the methods that there are for a scene, by their generic names."""
    facts: dict[str, dict[str, Any]] = METHODS
    if scene.has_body:
        return tuple(sorted(q for q in facts if facts[q]["bodies"]))
    made_for_it = getattr(scene.module, "ALONE", ())
    return tuple(sorted(q for q in facts if not facts[q]["alone"] or q in made_for_it))


def shown(scene: LoadedScene, method: str) -> str:
    """Return the name of a method with the class of a scene: ``c0-tau`` for ``ck-tau``.

    The generic name where the scene has another method of that name: ``hb-ck`` beside the
    ``hb-c1`` of the paper.
    """
    name = method.replace(CLASS, f"c{scene.k}")
    return method if name in methods(scene) else name


def generic(scene: LoadedScene, name: str) -> str:
    """Return the generic name of a method that may be spelled with the class of a scene."""
    name = name.replace("_", "-")
    if name in methods(scene):
        return name
    return "-".join(CLASS if part == f"c{scene.k}" else part for part in name.split("-"))


def with_class_one(method: str) -> str:
    """Return the name of a method whose functions are C^1 though the scene is smoother."""
    return method.replace(CLASS, CLASS_ONE)


def without_class(method: str) -> str:
    """Return the generic name of a method that may be one with functions of class C^1.

    Examples
    --------
    >>> without_class(with_class_one("ck-tau")), without_class("hb-c1")
    ('ck-tau', 'hb-c1')
    """
    return method if method in METHODS else method.replace(CLASS_ONE, CLASS)
