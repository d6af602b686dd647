"""Facts about methods besides their kernels: names, convergence, style of curves."""

from collections.abc import Iterable
from dataclasses import dataclass
from importlib import import_module
from types import ModuleType
from typing import Any

from ...generated import methods as generated
from .loaded import LoadedScene

#: The default method, and the facts that the files of all expansions state.
FIRST, METHODS, SMOOTHEST = generated.FIRST, generated.METHODS, generated.SMOOTHEST

#: Name of the exact solution among those of methods.
EXACT = "exact"

#: Part of a method's generic name that stands for the class C^k.
CLASS = "ck"

#: The same part for functions of class C^1 in a scene that is smoother.
CLASS_ONE = CLASS.replace("k", "1")


@dataclass(frozen=True)
class About:
    """Facts that the file of an expansion states.

    Parameters
    ----------
    look : dict
        Style of its curve in pictures: colour, marker, line.
    power : bool
        Whether its errors fall like a power of the order; else geometrically.
    kernel : str
        Name of the generated module of its kernel; empty for a method without a record.
    unseen : tuple of int
        Number of polynomials on a phase, by its class, to which its test functions are
        orthogonal; empty if there are none.
    functions : tuple of int
        Allowed numbers of functions added to the harmonics at a switch; empty if not variable.
    alone : bool
        Whether it is made for certain scenes only.
    bodies : bool
        Whether it exists as an expansion of contact forces on bodies.
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
    """Return the facts about a method by its generic name; defaults without a record."""
    look: dict[str, Any] = {"color": "0.5", "marker": "x", "linestyle": "--"}
    look |= {"title": method} | METHODS.get(without_class(method), {})
    fields = {name: look.pop(name) for name in About.__annotations__ if name in look}
    if not look.pop("filled", True):
        look["markerfacecolor"] = "white"
    return About(look=look, **fields)


def module_of(method: str) -> ModuleType:
    """Return the generated module of a method with a kernel."""
    return import_module(f"...generated.{about(method).kernel}", __package__)


def in_order(methods: Iterable[str]) -> tuple[str, ...]:
    """Return methods in the order of their records; those without a record come last."""
    recorded = [*METHODS]
    index = {method: i for i, method in enumerate(recorded)}
    return tuple(sorted(methods, key=lambda m: (index.get(without_class(m), len(recorded)), m)))


def methods(scene: LoadedScene) -> tuple[str, ...]:
    """Return the generic names of the methods available for a scene."""
    facts: dict[str, dict[str, Any]] = METHODS
    if scene.has_body:
        return tuple(sorted(q for q in facts if facts[q]["bodies"]))
    made_for_it = getattr(scene.module, "ALONE", ())
    return tuple(sorted(q for q in facts if not facts[q]["alone"] or q in made_for_it))


def shown(scene: LoadedScene, method: str) -> str:
    """Return the name of a method with the class of a scene: ``c0-tau`` for ``ck-tau``.

    The generic name remains if another method has that name: ``hb-ck`` beside ``hb-c1``.
    """
    name = method.replace(CLASS, f"c{scene.k}")
    return method if name in methods(scene) else name


def generic(scene: LoadedScene, name: str) -> str:
    """Return the generic name of a method whose name may have the class of a scene."""
    name = name.replace("_", "-")
    if name in methods(scene):
        return name
    return "-".join(CLASS if part == f"c{scene.k}" else part for part in name.split("-"))


def with_class_one(method: str) -> str:
    """Return the name of a method whose functions are C^1 though the scene is smoother."""
    return method.replace(CLASS, CLASS_ONE)


def without_class(method: str) -> str:
    """Return the generic name of a method, undoing `with_class_one`.

    Examples
    --------
    >>> without_class(with_class_one("ck-tau")), without_class("hb-c1")
    ('ck-tau', 'hb-c1')
    """
    return method if method in METHODS else method.replace(CLASS_ONE, CLASS)
