"""Units as powers of kilogram, metre and second, and the balance of an expression."""

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction

import sympy as sp

from .bodies.body import UNITS, Body
from .data import STATE_UNITS, Memory, SceneData
from .error import INSTEAD, SceneError, looks_like_state

Dimension = tuple[Fraction, Fraction, Fraction]

NONE: Dimension = (Fraction(0), Fraction(0), Fraction(0))

#: Units of which others are products of powers.
BASE = {
    "kg": (1, 0, 0),
    "m": (0, 1, 0),
    "s": (0, 0, 1),
    "N": (1, 1, -2),
    "rad": (0, 0, 0),
    "1": (0, 0, 0),
}

_FACTOR = re.compile(r"([A-Za-z]+|1)(?:\^(\d+|\(\d+/[1-9]\d*\)))?")

#: A slash outside the brackets of a power.
_SLASH = re.compile(r"/(?![^(]*\))")


def dimension_of(unit: str) -> Dimension:
    """Return the powers of kg, m, s in a unit such as ``"N s/m"`` or ``"m/s^2"``.

    A `SceneError` is raised if it is no product of powers of kg, m, s, N, rad.

    Examples
    --------
    >>> [int(power) for power in dimension_of("N s/m")]
    [1, 0, -1]
    """
    total = NONE
    above, *below = _SLASH.split(unit)
    for sign, part in ((1, above), *((-1, divisor) for divisor in below)):
        for factor in part.split() or ["?"] * bool(below):
            match = _FACTOR.fullmatch(factor)
            if match is None or match[1] not in BASE:
                expected = "kg, m, s, N, rad with spaces between, as in 'N s/m' or 'm/s^2'"
                raise SceneError(f"unit: got {unit!r}, expected {expected}")
            power = sign * Fraction((match[2] or "1").strip("()"))
            total = _sum(total, BASE[match[1]], power)
    return total


def _sum(left: Dimension, right: Sequence[Fraction | int], times: Fraction) -> Dimension:
    a, b, c = (p + times * q for p, q in zip(left, right, strict=True))
    return a, b, c


def _power(name: str, power: Fraction) -> str:
    if power == 1:
        return name
    return f"{name}^{power}" if power.denominator == 1 else f"{name}^({power})"


def spelled(dimension: Dimension) -> str:
    """Return a dimension for a message: ``kg m/s^2``."""
    parts = [(n, p) for n, p in zip(("kg", "m", "s"), dimension, strict=True) if p]
    above = [_power(n, p) for n, p in parts if p > 0]
    below = [_power(n, -p) for n, p in parts if p < 0]
    text = " ".join(above) or "1"
    return f"{text}/{' '.join(below)}" if below else text


def balance(expression: sp.Expr, units: Mapping[sp.Symbol, Dimension]) -> Dimension:
    """Return the dimension of an expression, all of whose terms must have the same.

    A `SceneError` names two terms whose units clash, or a symbol that has none.
    """
    if expression.is_Add:
        return _balance_of_sum(expression, units)
    if expression.is_Mul:
        total = NONE
        for factor in expression.args:
            total = _sum(total, balance(factor, units), Fraction(1))
        return total
    if expression.is_Pow:
        return _balance_of_power(expression, units)
    if expression.is_Symbol:
        return _unit_of(expression, units)
    if isinstance(expression, sp.Abs):
        return balance(expression.args[0], units)
    for argument in expression.args:
        if balance(argument, units) != NONE:
            raise SceneError(f"{expression}: expected a pure number as the argument")
    return NONE


def _balance_of_sum(expression: sp.Add, units: Mapping[sp.Symbol, Dimension]) -> Dimension:
    first, *terms = expression.args
    expected = balance(first, units)
    for term in terms:
        unit = balance(term, units)
        if unit != expected:
            raise SceneError(
                f"units clash: {first} is in {spelled(expected)}, {term} in {spelled(unit)}"
            )
    return expected


def _balance_of_power(expression: sp.Pow, units: Mapping[sp.Symbol, Dimension]) -> Dimension:
    base, exponent = expression.args
    inner = balance(base, units)
    if balance(exponent, units) != NONE:
        raise SceneError(f"{expression}: expected a pure number as the power")
    if inner == NONE:
        return NONE
    if not exponent.is_Rational:
        raise SceneError(f"{expression}: expected a rational power of what has a unit")
    return _sum(NONE, inner, Fraction(int(exponent.p), int(exponent.q)))


def _unit_of(symbol: sp.Symbol, units: Mapping[sp.Symbol, Dimension]) -> Dimension:
    if symbol in units:
        return units[symbol]
    twins = [other for other in units if other.name == symbol.name]
    but = f", but another symbol of that name is: with {_assumed(twins[0])}" if twins else ""
    if not twins and looks_like_state(symbol):
        but = f"; if it is a coordinate of another mass, {INSTEAD}"
    raise SceneError(f"{symbol} is not a parameter of the scene{but}")


def _assumed(symbol: sp.Symbol) -> str:
    """Return the assumption that distinguishes a symbol from another of the same name."""
    kinds = ("positive", "nonnegative", "real")
    return f"{next((kind for kind in kinds if symbol.assumptions0.get(kind)), 'no')}=True"


def units_of(scene: SceneData) -> dict[sp.Symbol, Dimension]:
    """Return the units of the state of the motion and of the parameters."""
    units = {symbol: dimension_of(unit) for symbol, unit in STATE_UNITS.items()}
    return units | {q.symbol: dimension_of(q.unit) for q in scene.parameters}


def units_of_contacts(body: Body) -> dict[sp.Symbol, Dimension]:
    """Return the units of the symbols of the contacts of a body."""
    by_contact = (zip(q.symbols, UNITS, strict=True) for q in body.at.values())
    return {symbol: dimension_of(unit) for pairs in by_contact for symbol, unit in pairs}


def power_of_time(scene: SceneData, memory: Memory) -> int:
    """Return p in the unit of a memory, length over time to the power p."""
    units = units_of(scene) | ({} if scene.body is None else units_of_contacts(scene.body))
    return -int(balance(sp.expand(memory.value), units)[2])
