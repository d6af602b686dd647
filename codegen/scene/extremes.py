"""The extremes of a scene: parameters at which digits are easily lost, and what is checked."""

from collections.abc import Iterator, Mapping

import sympy as sp

from .data import STATE_UNITS, SceneData
from .error import SceneError, named
from .parameters import bounds, within
from .units import balance, dimension_of, spelled


def check_extremes(scene: SceneData) -> None:
    """Check that each extreme gives parameters of the scene values that they may have.

    A `SceneError` names the first that does not.
    """
    if not isinstance(scene.extremes, Mapping):
        raise SceneError("extremes: expected a mapping {words: {symbol: value}}")
    units = {symbol: dimension_of(unit) for symbol, unit in STATE_UNITS.items()}
    units |= {q.symbol: dimension_of(q.unit) for q in scene.parameters}
    of_symbol = {q.symbol: q for q in scene.parameters}
    defaults = {q.symbol: q.default for q in scene.parameters}
    for words, values in scene.extremes.items():
        with named(f"extremes {words!r}"):
            if not (isinstance(words, str) and isinstance(values, Mapping) and values):
                raise SceneError("expected text, and a mapping {symbol: value}")
            for symbol, value in values.items():
                if symbol not in of_symbol:
                    raise SceneError(f"{symbol} is not a parameter of the scene")
                expression = _expression(value)
                strange = sorted(expression.free_symbols - set(of_symbol), key=str)
                if strange:
                    raise SceneError(f"{strange[0]} is not a parameter of the scene")
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


def _expression(value: object) -> sp.Expr:
    try:
        return sp.sympify(value, strict=True)
    except sp.SympifyError:
        raise SceneError(f"got {value!r}, expected a number or an expression") from None


def at_extremes(scene: SceneData) -> Iterator[tuple[sp.Expr, ...]]:
    """Yield all parameters in their order at each extreme; others keep their symbols."""
    for values in scene.extremes.values():
        yield tuple(sp.sympify(values.get(symbol, symbol)) for symbol in scene.symbols)
