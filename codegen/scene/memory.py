"""What is checked of the memory of a scene: constants that switches set."""

from collections.abc import Mapping

import sympy as sp

from .data import STATE_UNITS, Memory, SceneData, a, forcing, t
from .error import SceneError, named
from .linear import state_row
from .names import check_meaning, check_name
from .units import Dimension, balance, dimension_of, spelled


def check_memory(
    scene: SceneData, units: Mapping[sp.Symbol, Dimension]
) -> dict[sp.Symbol, Dimension]:
    """Check the memory of a scene, and return the unit of each.

    A `SceneError` names the field that is wrong.
    """
    found: dict[sp.Symbol, Dimension] = {}
    for memory in scene.memory:
        field = f"memory {memory.symbol}"
        _check_symbol(field, memory, scene, {*units, *found})
        names = [phase.name for phase in scene.phases]
        if memory.at not in names:
            raise SceneError(
                f"{field}: at: got {memory.at!r}, expected one of {', '.join(names)}"
            )
        with named(f"{field}: value"):
            found[memory.symbol] = _unit(memory, scene, units)
    return found


def power_of_time(scene: SceneData, memory: Memory) -> int:
    """Return the p of the unit of a memory, a length over a time to the power p."""
    units = {symbol: dimension_of(unit) for symbol, unit in STATE_UNITS.items()}
    units |= {q.symbol: dimension_of(q.unit) for q in scene.parameters}
    return -int(balance(sp.expand(memory.value), units)[2])


def _check_symbol(field: str, memory: Memory, scene: SceneData, taken: set[sp.Symbol]) -> None:
    symbol = memory.symbol
    if symbol != sp.Symbol(symbol.name, real=True):
        raise SceneError(f"{field}: symbol: got other assumptions, expected real=True")
    check_name(f"{field}: symbol", symbol.name)
    if symbol.name in {other.name for other in taken}:
        raise SceneError(f"{field}: symbol: there is another symbol of that name")
    check_meaning(f"{field}: symbol", symbol.name, [phase.name for phase in scene.phases])


def _unit(memory: Memory, scene: SceneData, units: Mapping[sp.Symbol, Dimension]) -> Dimension:
    value = sp.sympify(memory.value)
    if value.has(t, a):
        raise SceneError(f"got {value}, expected x, v, forcing and parameters")
    if value.has(forcing) and scene.frequency is None:
        raise SceneError("it has forcing, but the scene has no frequency")
    if value.free_symbols <= {*units} - {*STATE_UNITS}:
        raise SceneError(f"{value} depends on neither x, v nor forcing")
    unit = balance(sp.expand(value), units)
    state_row(value, f"memory {memory.symbol}: value")
    mass, length, time = unit
    if mass != 0 or length != 1 or time > 0 or time.denominator != 1:
        raise SceneError(f"it is in {spelled(unit)}, expected m, m/s, m/s^2, ...")
    return unit
