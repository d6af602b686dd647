"""Checks of a phase: equation, event, demands, constraint."""

from collections.abc import Iterator, Mapping, Sequence

import sympy as sp

from ..bodies.law import laws
from ..data import Phase, a, forcing, v, x
from ..error import SceneError, check_kind, named
from ..linear import fixed, linear_phase, state_row, without_modulus
from ..units import Dimension, balance, spelled

Units = Mapping[sp.Symbol, Dimension]


def check_phase(
    phase: Phase, units: Units, forced: bool, memory: Sequence[sp.Symbol] = ()
) -> None:
    """Check one phase by itself; a `SceneError` names the field that is wrong.

    Parameters
    ----------
    phase : Phase
    units : mapping of Symbol to Dimension
        Units of all symbols that are allowed.
    forced : bool
        Whether there is forcing.
    memory : sequence of Symbol
        Symbols in which, like in the state, all must be linear.
    """
    field = f"phase {phase.name}"
    for name, value in checked_fields(phase, units, forced, memory):
        if "demand" in name:
            with named(f"{field}: {name}"):
                for part in without_modulus(value):
                    state_row(part, f"{field}: {name}", memory)
    with named(f"{field}: equation"):
        m = linear_phase(phase, memory).m
        if m.is_nonpositive:
            raise SceneError(f"got {m} times a, expected a positive mass")
    with named(f"{field}: ends"):
        of_x, of_v, cos, *_ = state_row(phase.ends.zero, f"{field}: ends", memory)
        if of_x == of_v == cos == 0:
            raise SceneError(f"{phase.ends.zero} depends on neither x, v nor forcing")
    _check_jump(phase, units, memory)
    if phase.held is not None:
        with named(f"{field}: held"):
            if sp.simplify(phase.equation / a).has(a) or linear_phase(phase).c != 0:
                raise SceneError(f"got the equation {phase.equation}, expected a")
            check_velocity(phase.held, units)
            if sp.sympify(phase.held).has(x, v, forcing, *memory):
                raise SceneError(f"got {phase.held}, expected a velocity in the parameters")
        if cos == 0 and (of_x == 0 or sp.sympify(phase.held) == 0):
            raise SceneError(
                f"{field}: ends: {phase.ends.zero} does not change while it is held"
            )


def checked_fields(
    phase: Phase, units: Units, forced: bool, memory: Sequence[sp.Symbol]
) -> Iterator[tuple[str, sp.Expr]]:
    """Yield the expressions of a phase, by the names of their fields, once they are checked.

    Each is linear, has forcing only in a forced scene, and its terms have one unit.
    """
    for name, expression in fields(phase):
        with named(f"phase {phase.name}: {name}"):
            value = sp.sympify(expression)
            check_kind(value, memory, modulus="demand" in name)
            if value.has(forcing) and not forced:
                raise SceneError("it has forcing, but the scene has no frequency")
            balance(sp.expand(value), units)
        yield name, value


def fields(phase: Phase) -> Iterator[tuple[str, sp.Expr]]:
    """Yield the expressions of a phase, by field, except the velocity at which it is held."""
    yield from (("equation", law) for law in laws(phase))
    yield "ends", phase.ends.zero
    yield from (("jump", value) for value in phase.ends.jump.values())
    for field, demands in (("demand", phase.demands), ("ends: demand", phase.ends.demands)):
        yield from ((f"{field} {words!r}", value) for words, value in demands.items())


def check_velocity(value: sp.Expr, units: Units) -> None:
    """Check that a value is a velocity, or zero; a `SceneError` if it is not."""
    value = sp.sympify(value)
    if value != 0 and balance(value, units) != units[v]:
        raise SceneError(f"{value} is not a velocity")


def _check_jump(phase: Phase, units: Units, memory: Sequence[sp.Symbol]) -> None:
    for symbol, value in phase.ends.jump.items():
        with named(f"phase {phase.name}: jump"):
            if symbol != v:
                raise SceneError(f"got a jump of {symbol}, expected one of v")
            check_velocity(value, units)
            of_x, _, cos, _ = state_row(value, f"phase {phase.name}: jump")
            if of_x != 0 or cos != 0 or sp.sympify(value).has(*memory):
                raise SceneError(f"got {value}, expected the velocity v alone in it")


def check_neighbours(phase: Phase, after: Phase, sign: int) -> None:
    """Check that a phase before a held one ends with the prescribed velocity.

    Parameters
    ----------
    phase, after : Phase
    sign : int
        -1 if the motion is mirrored between them, else 1.

    Raises
    ------
    SceneError
        If its event and its jump lead to another velocity.
    """
    if after.held is None:
        return
    field, speed = f"phase {phase.name}", sign * sp.sympify(after.held)
    law, before = sp.sympify(phase.ends.jump.get(v, v)), fixed(phase, v)
    if sp.simplify(law.subs(v, v if before is None else before) - speed) != 0:
        where, got, expected = (
            ("jump", law, speed) if phase.ends.jump else ("ends", phase.ends.zero, v - speed)
        )
        raise SceneError(
            f"{field}: {where}: got {got}, expected {expected}: "
            f"the velocity at which {after.name} is held"
        )


def check_same_units(phases: tuple[Phase, ...], units: Units) -> None:
    """Check that the equations of all free phases have the same unit.

    A `SceneError` is raised if not, for their residuals could not be added.
    """
    free = [phase for phase in phases if phase.held is None]
    dimensions = [balance(sp.expand(phase.equation), units) for phase in free]
    for phase, unit in zip(free, dimensions, strict=True):
        if unit != dimensions[0]:
            raise SceneError(
                f"phase {phase.name}: equation: it is in {spelled(unit)}, "
                f"that of {free[0].name} in {spelled(dimensions[0])}"
            )
