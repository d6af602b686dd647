"""Errors in a scene, in one line: in a field, or for a system that cannot be a scene."""

import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager

import sympy as sp

from .data import a, forcing, t, v, x

#: Which systems can be a scene, and which tools are for others.
INSTEAD = (
    "a scene is one mass whose phases are linear in x, v and a, forced by one cosine; for "
    "other systems integrate from event to event (scipy.integrate.solve_ivp with events) or "
    "use a continuation code such as COCO or AUTO"
)

#: Functions with branches, on each of which they are an argument or a number.
_BRANCHES = (sp.Abs, sp.sign, sp.Heaviside, sp.Max, sp.Min, sp.Piecewise)


class SceneError(ValueError):
    """An error in a scene: the message names the field, what was found and expected."""


@contextmanager
def named(field: str) -> Iterator[None]:
    """Put the name of a field before the message of a `SceneError` in the ``with`` block."""
    try:
        yield
    except SceneError as error:
        text = str(error)
        raise SceneError(text if text.startswith(field) else f"{field}: {text}") from None


def check_kind(expression: sp.Expr, memory: Sequence[sp.Symbol], modulus: bool = False) -> None:
    """Check that time enters by `forcing` alone, and state and memory linearly.

    Parameters
    ----------
    expression : Expr
    memory : sequence of Symbol
    modulus : bool
        Whether an ``Abs`` is allowed, as in a demand.

    Raises
    ------
    SceneError
        If it is not so, with the term that is wrong.
    """
    times = {q for q in expression.free_symbols if q.name == t.name}
    if times:
        raise SceneError(_of_time(expression.xreplace(dict.fromkeys(times, t))))
    expected = ""
    if modulus:
        expression = expression.replace(sp.Abs, lambda argument: argument)
        expected = "expected a linear form, or a bound - Abs(...)"
    check_linear(expression, (x, v, a, forcing, *memory), expected)


def check_linear(expression: sp.Expr, symbols: Sequence[sp.Symbol], expected: str = "") -> None:
    """Check that an expression is jointly linear in symbols.

    Parameters
    ----------
    expression : Expr
    symbols : sequence of Symbol
    expected : str
        End of the message; by default it explains the kind of term, and what to do with it.

    Raises
    ------
    SceneError
        If it is not, with a nonlinear term and the symbols in it.
    """
    expanded = sp.expand(expression)
    if not _is_linear(expanded, symbols):
        terms = sp.Add.make_args(expanded)
        wrong = next((term for term in terms if not _is_linear(term, symbols)), expression)
        raise SceneError(_not_linear(wrong, [q for q in symbols if wrong.has(q)], expected))


def _is_linear(expression: sp.Expr, symbols: Iterable[sp.Symbol]) -> bool:
    return not any(sp.diff(expression, q).has(*symbols) for q in symbols)


def _not_linear(term: sp.Expr, symbols: list[sp.Symbol], expected: str) -> str:
    """Return the message for a term that is not linear in these symbols."""
    message = f"{term} is not linear in {' and '.join(map(str, symbols))}"
    if expected:
        return f"{message}, {expected}"
    state = [q for q in symbols if q != forcing]
    if state and forcing in symbols and _is_linear(term, state):
        return _varying(state[0], sp.diff(term, state[0]))
    kinds = [q for q in term.atoms(*_BRANCHES) if q.has(*symbols)]
    on_branches = term.replace(lambda q: isinstance(q, _BRANCHES), _sum_of_branches)
    if kinds and _is_linear(sp.expand(on_branches), symbols):
        kind = min(type(q).__name__ for q in kinds)
        return f"{message}: give each branch of {kind} a phase of its own"
    return f"{message}; {INSTEAD}"


def _sum_of_branches(function: sp.Expr) -> sp.Expr:
    """Return a weighted sum of the branches of a function."""
    if isinstance(function, sp.sign | sp.Heaviside):
        return sp.Dummy()
    parts = (q[0] if isinstance(function, sp.Piecewise) else q for q in function.args)
    return sp.Add(*(sp.Dummy() * part for part in parts))


def _of_time(expression: sp.Expr) -> str:
    """Return the message for an expression that has the time `t`."""
    for symbol in (x, v, a):
        coefficient = sp.diff(expression, symbol)
        if coefficient.has(t):
            return _varying(symbol, coefficient)
    waves = sorted((q for q in expression.atoms(sp.cos, sp.sin) if q.has(t)), key=str)
    stand_ins = {wave: sp.Dummy() for wave in waves}
    form = expression.xreplace(stand_ins)
    alike = len({wave.args[0] for wave in waves}) == 1 and not expression.has(forcing)
    if alike and not form.has(t) and _is_linear(sp.expand(form), tuple(stand_ins.values())):
        return (
            "it has the time t, which enters by forcing alone: "
            f"expected forcing in place of {waves[0]}"
        )
    return f"it has the time t in another way than one cosine, which is forcing; {INSTEAD}"


def _varying(symbol: sp.Symbol, coefficient: sp.Expr) -> str:
    return f"{symbol} has the coefficient {coefficient}, which varies with time; {INSTEAD}"


def looks_like_state(symbol: sp.Symbol) -> bool:
    """Return whether an unknown symbol may be meant as the coordinate of another mass.

    Examples
    --------
    >>> [looks_like_state(sp.Symbol(name)) for name in ("x2", "v_1", "y", "theta", "k2")]
    [True, True, True, True, False]
    """
    return bool(re.fullmatch(r"(d{0,2}[xvay]|theta|psi)_?\d*|[qu]_?\d+", symbol.name))
