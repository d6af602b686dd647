"""Shortcuts: quicker ways to some orbits, in one table; and who is solved by them.

`table` and `entrances` have what the room of shortcuts offers, and are empty where that room
is left out: everything else of this package works without it.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from typing import Any

from .arrays import Vector
from .case.case import Case

_ROOM = f"{__package__}.shortcuts"


@dataclass(frozen=True)
class Full:
    """The whole system of equations in whose place a shortcut is solved.

    Parameters
    ----------
    what : str
        Whose equations they are.
    residual : callable
        ``residual(case, order, functions, found)``: the equations, without units, at what a
        shortcut found; coefficients that it leaves out are those that suit its times best.
    times : callable or None
        ``times(case, order, functions)``: the unknown times by Newton's method for the whole
        system, as a part of the period; None where it does not converge.  None itself where
        nobody solves the whole system.
    """

    what: str
    residual: Callable[[Case, int, int | None, Vector], Vector]
    times: Callable[[Case, int, int | None], Vector | None] | None


@dataclass(frozen=True)
class Shortcut:
    """A quicker way to orbits that another system of equations has as well.

    Parameters
    ----------
    name : str
        What it is called.
    scene, method : str
        Whose orbits it finds: a scene, and the generic name of a method.
    functions : tuple of int
        The numbers of functions beside the harmonics; empty where none are counted.
    fits : callable
        ``fits(case, order)``: whether it is meant for this.
    solve : callable
        ``solve(cases, order, functions)``: what it finds of each case, without units: unknowns
        of `full`, or the unknown times alone.  It raises `NoOrbit` where there is none.
    times : callable
        ``times(found)``: the unknown times in that, as a part of the period.
    full : Full
        What it is solved in place of.
    bound : float
        Largest residual of `full` at what it finds.
    factor : float or None
        How many times quicker than `full` it is at `order`, compiled, once everything is
        loaded; None where speed is not what it is for.
    order : int
        Where `factor` is measured: ``python -m benchmarks.shortcuts``.
    why : str
        Why its orbits are the same.
    """

    name: str
    scene: str
    method: str
    functions: tuple[int, ...]
    fits: Callable[[Case, int], bool]
    solve: Callable[[Sequence[Case], int, int | None], list[Vector]]
    times: Callable[[Vector], Vector]
    full: Full
    bound: float
    factor: float | None
    order: int
    why: str


@dataclass(frozen=True)
class Entrance:
    """A class of oscillators that is solved by shortcuts, and what is called for it.

    Parameters
    ----------
    kind : type
        Of the oscillators.
    scene : str
        The scene whose cases they are.
    methods : mapping
        Generic names of methods, and what they are called here.
    case : callable
        ``case(oscillator)``: the same as a case of the scene.
    solve, sweep, exact, family : callable
        The verbs.
    default : str
        The method, as it is called here, where none is named.
    """

    kind: type
    scene: str
    methods: Mapping[str, str]
    case: Callable[[Any], Case]
    solve: Callable[..., Any]
    sweep: Callable[..., Any]
    exact: Callable[[Any], Any]
    family: Callable[..., Any]
    default: str

    def own_name(self, method: object) -> object:
        """Return what a method is called here, if it is one of these by either name."""
        return self.methods.get(method, method) if isinstance(method, str) else method

    def is_of_every_scene(self, method: object) -> bool:
        """Whether a method is not one of these, but one that every scene has."""
        from .case.registry import UnknownScene, generic_method, load  # noqa: PLC0415

        if not isinstance(method, str) or self.own_name(method) in self.methods.values():
            return False
        try:
            generic_method(load(self.scene), method)
        except UnknownScene:
            return False
        return True


def _offered(module: str, name: str) -> tuple[Any, ...]:
    """Return what a module of the room offers; nothing where the room is left out."""
    if find_spec(_ROOM) is None:
        return ()
    found: tuple[Any, ...] = getattr(import_module(f"{_ROOM}.{module}"), name)
    return found


@cache
def table() -> tuple[Shortcut, ...]:
    """Return all shortcuts there are."""
    return _offered("table", "TABLE")


def entrances() -> tuple[Entrance, ...]:
    """Return the classes of oscillators that are solved by shortcuts."""
    return _offered("entrance", "ENTRANCES")


def entrance_of(oscillator: object) -> Entrance:
    """Return the entrance of an oscillator that is not a case of a scene.

    Raises
    ------
    TypeError
        If it is not an oscillator at all.
    """
    known = entrances()
    for entrance in known:
        if isinstance(oscillator, entrance.kind):
            return entrance
    expected = " or ".join(["case of a scene", *(f"a {e.kind.__name__}" for e in known)])
    raise TypeError(f"case: got {oscillator!r:.80}, expected a {expected}")
