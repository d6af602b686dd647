"""The types of the fields of a scene: the first check, before all mathematics."""

import numbers
from collections.abc import Iterator, Mapping
from itertools import chain
from types import UnionType
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from ..bodies.body import Body
from ..data import Event, Memory, Parameter, Phase, SceneData
from ..error import INSTEAD, SceneError, named

#: Numbers that are not allowed anywhere in an expression.
_NO_NUMBERS = (sp.I, sp.nan, sp.oo, -sp.oo, sp.zoo)


def check_entries(scene: SceneData) -> None:
    """Check the type of every field; a `SceneError` names the first that is wrong."""
    for name in ("name", "title", "source"):
        _expect(name, getattr(scene, name), str, "text")
    if any(mark in scene.title for mark in ('"""', "\\", "\n")):
        raise SceneError(f'title: got {scene.title!r}, expected one line without \\ and """')
    _expect("body", scene.body, Body | None, "a Body")
    _expect("half_period", scene.half_period, bool, "True or False")
    sequences: list[tuple[str, Any, type]] = [
        ("parameters", scene.parameters, Parameter),
        ("phases", scene.phases, Phase),
        ("memory", scene.memory, Memory),
    ]
    _expect("motions", scene.motions, Mapping, "a mapping {name: (Phase, ...)}")
    for motion, phases in scene.motions.items():
        _expect("motions", motion, str, "text before the colon")
        sequences.append((f"motion {motion}", phases, Phase))
    for name, entries, kind in sequences:
        for entry in _several(name, entries):
            _expect(name, entry, kind, f"a {kind.__name__}")
    for parameter in scene.parameters:
        _check_parameter(parameter)
    for phase in (*scene.phases, *chain.from_iterable(scene.motions.values())):
        _check_phase(phase, scene.body is not None)
    for memory in scene.memory:
        _check_memory(memory)
    for name in ("requires", "scales"):
        _check_mapping(name, getattr(scene, name))
    _check_mapping("start", scene.start, texts=False)
    if scene.frequency is not None and not isinstance(scene.frequency, sp.Symbol):
        raise SceneError(f"frequency: got {scene.frequency!r}, expected one symbol")
    guesses = scene.guess if isinstance(scene.guess, Mapping) else {"": scene.guess}
    for guess in guesses.values():
        for duration in _several("guess", guess):
            _check_expression("guess", duration)


def _expect(field: str, value: object, kind: type | UnionType, words: str) -> None:
    if not isinstance(value, kind):
        raise SceneError(f"{field}: got {_shown(value)}, expected {words}")


def _shown(value: object) -> str:
    """Return a value for a message, or only its type if it is long."""
    text = repr(value)
    return text if len(text) < 40 and "\n" not in text else f"a {type(value).__name__}"


def _several(field: str, value: Any) -> Iterator[Any]:
    """Yield the entries of a tuple."""
    if not isinstance(value, tuple | list):
        raise SceneError(
            f"{field}: got {_shown(value)}, expected a tuple; one entry is written (entry,)"
        )
    yield from value


def _check_parameter(q: Parameter) -> None:
    _expect("parameter: name", q.name, str, "text")
    field = f"parameter {q.name}"
    _expect(f"{field}: symbol", q.symbol, sp.Symbol, "a SymPy symbol")
    for name in ("unit", "what"):
        _expect(f"{field}: {name}", getattr(q, name), str, "text")
    for name in ("default", "most"):
        value = getattr(q, name)
        number = isinstance(value, numbers.Real | sp.Number) and not isinstance(value, bool)
        if not number and not (name == "most" and value is None):
            raise SceneError(f"{field}: {name}: got {_shown(value)}, expected a number")


def _check_phase(phase: Phase, of_body: bool) -> None:
    _expect("phase: name", phase.name, str, "text")
    field = f"phase {phase.name}"
    for equation in phase.laws if of_body else (phase.equation,):
        _check_expression(f"{field}: equation", equation)
    _expect(f"{field}: ends", phase.ends, Event, "an Event")
    for other in _several(f"{field}: ends", phase.ends.others):
        _expect(f"{field}: ends", other, Event, "an Event")
    if phase.ends.others and any(event.demands for event in phase.ends.each):
        expected = "those of the phase: one of several events has none of its own"
        raise SceneError(f"{field}: ends: demand: got demands at a switch, expected {expected}")
    for event in phase.ends.each:
        _expect(f"{field}: ends: to", event.to, str, "the name of a phase")
        _check_expression(f"{field}: ends", event.zero)
        _check_mapping(f"{field}: jump", event.jump, texts=False)
        _check_mapping(f"{field}: ends: demand", event.demands)
    _check_mapping(f"{field}: demand", phase.demands)
    if phase.held is not None:
        _check_expression(f"{field}: held", phase.held)


def _check_memory(memory: Memory) -> None:
    _expect("memory: symbol", memory.symbol, sp.Symbol, "a SymPy symbol")
    field = f"memory {memory.symbol}"
    for name in (memory.at,) if isinstance(memory.at, str) else _several(field, memory.at):
        _expect(f"{field}: at", name, str, "the name of a phase")
    _expect(f"{field}: what", memory.what, str, "text")
    _check_expression(f"{field}: value", memory.value)


def _check_mapping(field: str, value: object, texts: bool = True) -> None:
    """Check a mapping to expressions, from texts or from symbols."""
    _expect(field, value, Mapping, "a mapping {...: expression}")
    assert isinstance(value, Mapping)
    for key, expression in value.items():
        if texts:
            _expect(field, key, str, "text before the colon")
            _check_expression(f"{field} {key!r}", expression)
        else:
            _expect(field, key, sp.Symbol, "a symbol before the colon")
            _check_expression(field, expression)


def _check_expression(field: str, value: object) -> None:
    """Check an expression: finite and real, in symbols, without functions of time."""
    if isinstance(value, sp.Equality):
        raise SceneError(f"{field}: got an equation, expected one side of it, the other zero")
    if isinstance(value, sp.Rel):
        expected = "an expression, the larger side less the smaller"
        raise SceneError(f"{field}: got {value}, expected {expected}")
    if isinstance(value, tuple | list | sp.MatrixBase):
        raise SceneError(f"{field}: got {_shown(value)}, expected one expression; {INSTEAD}")
    number = isinstance(value, int | float) and not isinstance(value, bool)
    if not number and not isinstance(value, sp.Expr):
        raise SceneError(f"{field}: got {_shown(value)}, expected an expression of SymPy")
    with named(field):
        expression = sp.sympify(value)
        if expression.has(*_NO_NUMBERS):
            raise SceneError(f"got {expression}, expected real and finite numbers")
        unknown = expression.atoms(AppliedUndef, sp.Derivative, sp.Integral)
        if unknown:
            term = max(unknown, key=lambda q: (_of_the_past(q), str(q)))
            instead = f" as they are now; {INSTEAD}" if _of_the_past(term) else ""
            raise SceneError(f"got {term}, expected the symbols x, v, a and forcing{instead}")


def _of_the_past(function: sp.Expr) -> bool:
    """Return whether a function depends on earlier times: a delay, an integral."""
    delay = isinstance(function, AppliedUndef) and isinstance(function.args[0], sp.Add)
    return delay or isinstance(function, sp.Integral)
