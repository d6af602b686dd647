"""Linear forms: the equation of motion of a phase, events and demands as coefficients."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import sympy as sp

from .data import Phase, a, forcing, v, x
from .error import INSTEAD, SceneError, check_linear, named


@dataclass(frozen=True)
class LinearPhase:
    """The coefficients of one phase: ``m x'' + c x' + k x = f + g cos(Omega t + phi)``.

    With a memory w it is ``... = f + h w + ...``, and `memory` has the h of each.
    """

    m: sp.Expr
    c: sp.Expr
    k: sp.Expr
    f: sp.Expr
    g: sp.Expr
    memory: tuple[sp.Expr, ...] = ()

    @property
    def coefficients(self) -> tuple[sp.Expr, ...]:
        """All of them: ``m, c, k, f, g``, then those of the memory."""
        return self.m, self.c, self.k, self.f, self.g, *self.memory


def parts(expression: sp.Expr, symbols: Sequence[sp.Symbol], what: str) -> list[sp.Expr]:
    """Return the coefficient of each symbol, and the constant.

    Raises
    ------
    SceneError
        If the expression is not linear in them; the message begins with `what`.
    """
    with named(what):
        return list(_parts(expression, tuple(symbols)))


@lru_cache(maxsize=1024, typed=True)  # checks and classes ask for the same forms again
def _parts(expression: sp.Expr, symbols: tuple[sp.Symbol, ...]) -> tuple[sp.Expr, ...]:
    """Return the coefficients and the constant; a `SceneError` if it is not linear."""
    expanded = sp.expand(expression)
    check_linear(expanded, symbols)
    coefficients = [sp.diff(expanded, symbol) for symbol in symbols]
    constant = sp.expand(
        expanded - sum(c * q for c, q in zip(coefficients, symbols, strict=True))
    )
    return (*map(sp.factor_terms, coefficients), sp.factor_terms(constant))


def linear_phase(phase: Phase, memory: Sequence[sp.Symbol] = ()) -> LinearPhase:
    """Return the coefficients of the equation of motion of a phase.

    Parameters
    ----------
    phase : Phase
    memory : sequence of Symbol
        Symbols with coefficients of their own; others are part of `f`.

    Raises
    ------
    SceneError
        If it is not linear in acceleration, velocity, displacement and forcing, or has no
        acceleration.
    """
    what = f"phase {phase.name}: equation"
    m, c, k, g, *of_memory, f = parts(phase.equation, (a, v, x, forcing, *memory), what)
    if m == 0:
        expected = INSTEAD if phase.held is None else "of a phase that is held, expected a"
        raise SceneError(f"{what}: {phase.equation} has no acceleration a; {expected}")
    return LinearPhase(m, c, k, -f, -g, tuple(-h for h in of_memory))


def state_row(
    expression: sp.Expr, what: str, memory: Sequence[sp.Symbol] = ()
) -> tuple[sp.Expr, ...]:
    """Return the factors of a linear form: of displacement, velocity, forcing, 1, memories.

    Raises
    ------
    SceneError
        If `expression` is not linear; the message begins with `what`.
    """
    if sp.sympify(expression).has(a):
        raise SceneError(f"{what}: {expression} has the acceleration a, expected x, v, forcing")
    *factors, constant = parts(sp.sympify(expression), (x, v, forcing, *memory), what)
    return (*factors[:3], constant, *factors[3:])


def fixed(phase: Phase, symbol: sp.Symbol) -> sp.Expr | None:
    """Return the value of `x` or `v` that the event of a phase prescribes, or None."""
    zero = sp.expand(phase.ends.zero)
    if not zero.has(symbol) or zero.free_symbols & ({x, v, forcing} - {symbol}):
        return None
    return -zero.subs(symbol, 0) / sp.diff(zero, symbol)


def without_modulus(expression: sp.Expr, states: Sequence[sp.Symbol]) -> tuple[sp.Expr, ...]:
    """Return a demand without moduli of the state: ``bound - Abs(q)`` as ``bound -+ q``.

    `states` are the symbols of the state.

    Raises
    ------
    SceneError
        If a modulus of the state occurs otherwise, so that both signs are not equivalent.
    """
    moduli = [q for q in expression.atoms(sp.Abs) if q.has(*states)]
    if not moduli:
        return (expression,)
    modulus = min(moduli, key=sp.default_sort_key)
    stand_in = sp.Dummy()
    expanded = sp.expand(expression.xreplace({modulus: stand_in}))
    weight = sp.diff(expanded, stand_in)
    if weight.has(stand_in, *states) or not weight.is_nonpositive:
        raise SceneError(f"got {expression}, expected a bound - Abs(...)")
    both = (expanded.xreplace({stand_in: sign * modulus.args[0]}) for sign in (1, -1))
    return tuple(part for each in both for part in without_modulus(each, states))
