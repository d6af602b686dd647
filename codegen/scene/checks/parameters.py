"""Checks of the parameters of a scene, its memories, and its extremes."""

import math
from collections.abc import Iterable, Mapping, Sequence

import sympy as sp

from ..bodies.law import form
from ..data import STATE_UNITS, Memory, Parameter, SceneData, forcing, v, x
from ..error import SceneError, named
from ..units import Dimension, balance, dimension_of, spelled, units_of
from .names import check_free, check_meaning, check_name
from .phases import fields


def check_parameters(parameters: Sequence[Parameter], phases: Sequence[str]) -> None:
    """Check names, symbols, units and defaults, and that none occurs twice.

    A `SceneError` names the first that is wrong.
    """
    for q in parameters:
        field = f"parameter {q.name}"
        check_name(field, q.name)
        check_free(field, q.name)
        with named(field):
            dimension_of(q.unit)
        _check_symbol(field, q.symbol, phases)
        if not math.isfinite(q.default) or not within(q, q.default):
            raise SceneError(f"{field}: default: got {q.default!r}, expected {bounds(q)}")
    for attribute in ("name", "symbol"):
        values = [getattr(q, attribute) for q in parameters]
        repeated = [str(value) for value in values if values.count(value) > 1]
        if repeated:
            raise SceneError(f"parameters: {attribute} {repeated[0]} is there twice")


def _check_symbol(field: str, symbol: sp.Symbol, phases: Sequence[str]) -> None:
    kinds = ({"positive": True}, {"nonnegative": True}, {"real": True})
    if symbol not in {sp.Symbol(symbol.name, **kind) for kind in kinds}:
        raise SceneError(
            f"{field}: symbol: got {symbol} with other assumptions, expected positive, "
            f"nonnegative or real, as in sp.Symbol({symbol.name!r}, positive=True)"
        )
    check_name(f"{field}: symbol", symbol.name)
    if symbol in STATE_UNITS:
        raise SceneError(f"{field}: symbol: {symbol} stands for the state of the motion")
    check_meaning(f"{field}: symbol", symbol.name, phases)


def within(parameter: Parameter, value: float) -> bool:
    """Return whether a value satisfies the assumptions of the symbol and the upper bound."""
    symbol = parameter.symbol
    allowed = value > 0 if symbol.is_positive else (value >= 0 or not symbol.is_nonnegative)
    return bool(allowed) and (parameter.most is None or bool(value <= parameter.most))


def bounds(parameter: Parameter) -> str:
    """Return the allowed values in words."""
    symbol = parameter.symbol
    low = "above 0" if symbol.is_positive else "0 or more" if symbol.is_nonnegative else ""
    high = "" if parameter.most is None else f"at most {parameter.most:g}"
    return "a number " + " and ".join(filter(None, (low, high))) if low or high else "a number"


def check_memory(
    scene: SceneData, units: Mapping[sp.Symbol, Dimension]
) -> dict[sp.Symbol, Dimension]:
    """Check the memories of a scene, and return their units.

    A `SceneError` names the field that is wrong.
    """
    memory_units: dict[sp.Symbol, Dimension] = {}
    for memory in scene.memory:
        field = f"memory {memory.symbol}"
        _check_remembered(field, memory, scene, {*units, *memory_units})
        names = [phase.name for phase in scene.phases]
        if memory.at not in names:
            raise SceneError(
                f"{field}: at: got {memory.at!r}, expected one of {', '.join(names)}"
            )
        with named(f"{field}: value"):
            memory_units[memory.symbol] = _unit_of(memory, scene, units)
    return memory_units


def check_several(scene: SceneData) -> None:
    """Check the memories that hold in several phases, before an order sets them.

    A `SceneError` names the field that is wrong.
    """
    phases = [phase for order in scene.declared.values() for phase in order]
    names = list(dict.fromkeys(phase.name for phase in phases))
    several = {phase.name for phase in phases if phase.ends.others}
    forces = [contact.force for contact in scene.contacts]
    for memory in scene.memory:
        field, value = f"memory {memory.symbol}", sp.sympify(memory.value)
        if isinstance(memory.at, str):
            if memory.at in several:
                got = f"got {memory.at!r}, which ends in several ways"
                raise SceneError(f"{field}: at: {got}, expected ({memory.at!r},)")
            continue
        wrong = [name for name in memory.at if name not in names]
        if wrong or not set(memory.at) < set(names):
            got = repr(wrong[0]) if wrong else f"{len(memory.at)} phases"
            expected = f"some of {', '.join(names)}, but not all"
            raise SceneError(f"{field}: at: got {got}, expected {expected}")
        constant = value.subs(dict.fromkeys(value.free_symbols - {*scene.symbols}, 0))
        if constant != 0:
            raise SceneError(f"{field}: value: got the constant {constant}, expected none")
        for phase in (phase for phase in phases if phase.name not in memory.at):
            if phase.held is not None and value.has(*forces):
                what = f"got a force, but in {phase.name} it is not known: the contact is held"
                raise SceneError(f"{field}: value: {what}")
            expressions = (sp.sympify(q) for end in phase.each_end for _, q in fields(end))
            if any(q.has(memory.symbol) for q in expressions):
                expected = f"expected it in {', '.join(memory.at)} alone"
                raise SceneError(f"phase {phase.name}: got {memory.symbol}, {expected}")


def _check_remembered(
    field: str, memory: Memory, scene: SceneData, taken: set[sp.Symbol]
) -> None:
    symbol = memory.symbol
    if symbol != sp.Symbol(symbol.name, real=True):
        raise SceneError(f"{field}: symbol: got other assumptions, expected real=True")
    check_name(f"{field}: symbol", symbol.name)
    if symbol.name in {other.name for other in taken}:
        raise SceneError(f"{field}: symbol: there is another symbol of that name")
    check_meaning(f"{field}: symbol", symbol.name, [phase.name for phase in scene.phases])


def _unit_of(
    memory: Memory, scene: SceneData, units: Mapping[sp.Symbol, Dimension]
) -> Dimension:
    value = sp.sympify(memory.value)
    states = {q for contact in scene.contacts for q in (contact.x, contact.v)} or {x, v}
    allowed = {*states, forcing, *(q.symbol for q in scene.parameters)}
    if value.free_symbols & ({*units} - allowed):
        raise SceneError(f"got {value}, expected x, v, forcing and parameters")
    if value.has(forcing) and scene.frequency is None:
        raise SceneError("it has forcing, but the scene has no frequency")
    if not value.free_symbols & {*states, forcing}:
        raise SceneError(f"{value} depends on neither x, v nor forcing")
    unit = balance(sp.expand(value), units)
    form(value, scene, f"memory {memory.symbol}: value", memory=False)
    mass, length, time = unit
    if mass != 0 or length != 1 or time > 0 or time.denominator != 1:
        raise SceneError(f"it is in {spelled(unit)}, expected m, m/s, m/s^2, ...")
    return unit


def check_extremes(scene: SceneData) -> None:
    """Check that each extreme has allowed values of parameters.

    A `SceneError` names the first that has not.
    """
    if not isinstance(scene.extremes, Mapping):
        raise SceneError("extremes: expected a mapping {words: {symbol: value}}")
    units, of_symbol = units_of(scene), {q.symbol: q for q in scene.parameters}
    defaults = {q.symbol: q.default for q in scene.parameters}
    for words, values in scene.extremes.items():
        with named(f"extremes {words!r}"):
            if not (isinstance(words, str) and isinstance(values, Mapping) and values):
                raise SceneError("expected text, and a mapping {symbol: value}")
            for symbol, value in values.items():
                expression = _expression(value)
                check_known({symbol}, of_symbol)
                check_known(expression.free_symbols, of_symbol)
                if not expression.is_number:  # a number is in SI
                    unit = balance(expression, units)
                    if unit != dimension_of(of_symbol[symbol].unit):
                        raise SceneError(
                            f"{symbol} is set to {value}, which is in {spelled(unit)}, "
                            f"expected {of_symbol[symbol].unit}"
                        )
                at_defaults = complex(expression.subs(defaults))
                if at_defaults.imag or not within(of_symbol[symbol], at_defaults.real):
                    raise SceneError(
                        f"{symbol} is {value} of the default parameters, "
                        f"expected {bounds(of_symbol[symbol])}"
                    )


def check_known(symbols: set[sp.Symbol], known: Iterable[sp.Symbol]) -> None:
    """Check that symbols are parameters; a `SceneError` names one that is not."""
    unknown = sorted(symbols - set(known), key=str)
    if unknown:
        raise SceneError(f"{unknown[0]} is not a parameter of the scene")


def _expression(value: object) -> sp.Expr:
    try:
        return sp.sympify(value, strict=True)
    except sp.SympifyError:
        raise SceneError(f"got {value!r}, expected a number or an expression") from None
