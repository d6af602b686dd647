"""What is checked of the parameters of a scene."""

import math
from collections.abc import Sequence

import sympy as sp

from .data import STATE_UNITS, Parameter
from .error import SceneError, named
from .names import TAKEN, check_meaning, check_name
from .units import dimension_of


def check_parameters(parameters: Sequence[Parameter], phases: Sequence[str]) -> None:
    """Check names, symbols, units and defaults, and that nothing is there twice.

    A `SceneError` names the first that is wrong.
    """
    for q in parameters:
        field = f"parameter {q.name}"
        check_name(field, q.name)
        if q.name in TAKEN:
            raise SceneError(f"{field}: the name is taken by an option of the command line")
        with named(field):
            dimension_of(q.unit)
        _check_symbol(field, q.symbol, phases)
        if not math.isfinite(q.default) or not within(q, q.default):
            raise SceneError(f"{field}: default: got {q.default!r}, expected {bounds(q)}")
    for what in ("name", "symbol"):
        seen = [getattr(q, what) for q in parameters]
        twice = [str(each) for each in seen if seen.count(each) > 1]
        if twice:
            raise SceneError(f"parameters: {what} {twice[0]} is there twice")


def _check_symbol(field: str, symbol: sp.Symbol, phases: Sequence[str]) -> None:
    kinds = ({"positive": True}, {"nonnegative": True}, {"real": True})
    if symbol not in {sp.Symbol(symbol.name, **kind) for kind in kinds}:
        raise SceneError(
            f"{field}: symbol: got {symbol} with other assumptions, "
            "expected positive, nonnegative or real"
        )
    check_name(f"{field}: symbol", symbol.name)
    if symbol in STATE_UNITS:
        raise SceneError(f"{field}: symbol: {symbol} stands for the state of the motion")
    check_meaning(f"{field}: symbol", symbol.name, phases)


def within(parameter: Parameter, value: float) -> bool:
    """Whether a value satisfies the assumptions of the symbol and the largest value."""
    symbol = parameter.symbol
    low = value > 0 if symbol.is_positive else (value >= 0 or not symbol.is_nonnegative)
    return bool(low) and (parameter.most is None or bool(value <= parameter.most))


def bounds(parameter: Parameter) -> str:
    """Return what is expected of a value, in words."""
    symbol = parameter.symbol
    low = "above 0" if symbol.is_positive else "0 or more" if symbol.is_nonnegative else ""
    high = "" if parameter.most is None else f"at most {parameter.most:g}"
    return "a number " + " and ".join(filter(None, (low, high))) if low or high else "a number"
