"""Checks of a phase: equation, event, demands, constraint."""

from collections.abc import Iterator, Mapping, Sequence

import sympy as sp

from ..bodies.law import form, law_rows, place, signals, velocities
from ..data import Phase, SceneData, a, forcing, v, x
from ..error import SceneError, check_kind, named
from ..linear import fixed, linear_phase, without_modulus
from ..units import Dimension, balance, spelled

Units = Mapping[sp.Symbol, Dimension]


def check_phase(phase: Phase, scene: SceneData, units: Units) -> None:
    """Check one phase by itself; a `SceneError` names the field that is wrong.

    Parameters
    ----------
    phase : Phase
    scene : SceneData
    units : mapping of Symbol to Dimension
        Units of all symbols that are allowed.
    """
    field, memory = f"phase {phase.name}", [q.symbol for q in scene.memory]
    states = [q for q in signals(scene) if q != 1]
    for name, value in checked_fields(phase, units, scene.frequency is not None, memory):
        if "demand" in name:
            with named(f"{field}: {name}"):
                for part in without_modulus(value, states):
                    form(part, scene, f"{field}: {name}")
    with named(f"{field}: equation"):
        if scene.body is not None:
            _check_forces(phase, scene)
        elif (m := linear_phase(phase, memory).m).is_nonpositive:
            raise SceneError(f"got {m} times a, expected a positive mass")
    with named(f"{field}: ends"):
        row = form(phase.ends.zero, scene, f"{field}: ends")
        if scene.body is None and all(c == 0 for c in row[:3]):
            raise SceneError(f"{phase.ends.zero} depends on neither x, v nor forcing")
        if all(c == 0 for i, c in enumerate(row) if i != 3):
            raise SceneError(f"{phase.ends.zero} depends on no displacement, velocity or force")
    _check_jump(phase, scene, units)
    if phase.held is not None:
        with named(f"{field}: held"):
            _check_held(phase, scene, units)
        of_x, _, cos, *_ = row
        unmoved = cos == 0 and (of_x == 0 or sp.sympify(phase.held) == 0)
        if scene.body is None and unmoved:
            raise SceneError(
                f"{field}: ends: {phase.ends.zero} does not change while it is held"
            )


def _check_forces(phase: Phase, scene: SceneData) -> None:
    """Check that the laws of a phase that is not held say what the contact forces are."""
    pairs = zip(scene.contacts, law_rows(phase, scene), strict=True)
    if phase.held is None and any(row[place(scene, q.force)] == 0 for q, row in pairs):
        raise SceneError("it has no force: say the speed at which it is held")


def _check_held(phase: Phase, scene: SceneData, units: Units) -> None:
    """Check that a constraint prescribes the velocity, and the equation says no more."""
    memory = [q.symbol for q in scene.memory]
    if len(scene.contacts) > 1:
        raise SceneError(
            "a body with several contacts cannot be held; a joint that sticks can have a "
            "spring in series with its slider"
        )
    if scene.body is None:
        others = linear_phase(phase, memory).coefficients[1:]
    else:
        (row,), at = law_rows(phase, scene), place(scene, a)
        others = (*row[:at], *row[at + 1 :])
    if any(c != 0 for c in others):
        raise SceneError(f"got the equation {phase.equation}, expected a")
    check_velocity(phase.held, units)
    if sp.sympify(phase.held).has(x, v, forcing, *memory):
        raise SceneError(f"got {phase.held}, expected a velocity in the parameters")


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
    yield from (("equation", law) for law in phase.laws)
    yield "ends", phase.ends.zero
    yield from (("jump", value) for value in phase.ends.jump.values())
    for field, demands in (("demand", phase.demands), ("ends: demand", phase.ends.demands)):
        yield from ((f"{field} {words!r}", value) for words, value in demands.items())


def check_velocity(value: sp.Expr, units: Units) -> None:
    """Check that a value is a velocity, or zero; a `SceneError` if it is not."""
    value = sp.sympify(value)
    if value != 0 and balance(value, units) != units[v]:
        raise SceneError(f"{value} is not a velocity")


def _check_jump(phase: Phase, scene: SceneData, units: Units) -> None:
    """Check that a velocity jumps to a linear form of itself alone."""
    for symbol, value in phase.ends.jump.items():
        with named(f"phase {phase.name}: jump"):
            if symbol not in velocities(scene):
                raise SceneError(f"got a jump of {symbol}, expected one of {v}")
            check_velocity(value, units)
            row = form(value, scene, f"phase {phase.name}: jump")
            allowed = {3, place(scene, symbol)}
            if any(c != 0 for i, c in enumerate(row) if i not in allowed):
                raise SceneError(f"got {value}, expected the velocity {symbol} alone in it")


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
    before = fixed(phase, v) if phase.held is None else phase.held
    law = sp.sympify(phase.ends.jump.get(v, v))
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
