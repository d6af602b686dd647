"""The formulas of a scene as text, read from its generated module: no SymPy is needed."""

import ast
import inspect
from functools import cache
from types import ModuleType
from typing import Any

#: What a linear form is linear in.
STATE = ("x", "x'", "cos(Omega t + phi)", "")

#: The same of another contact of a body.
CONTACT = ("x_{}", "x_{}'", "force_{}", "x_{}''")


def state_of(contacts: tuple[str, ...]) -> tuple[str, ...]:
    """Return what a linear form of a body is linear in.

    Examples
    --------
    >>> state_of(("tip", "root"))[4:]
    ('force', "x''", 'x_root', "x_root'", 'force_root', "x_root''")
    """
    more = (f"{q.format(name)}" for name in contacts[1:] for q in CONTACT)
    return (*STATE, "force", "x''", *more)


@cache
def rows(module: ModuleType, function: str) -> tuple[Any, ...]:
    """Return what a function of the module returns, as text: a tuple for each phase.

    It has expressions, or rows of them; of a single expression it is a tuple of one.
    """
    source = ast.parse(inspect.getsource(getattr(module, function)))
    (result,) = (node for node in ast.walk(source) if isinstance(node, ast.Return))
    assert isinstance(result.value, ast.Tuple)
    phases = map(_texts, result.value.elts)
    return tuple(phase if isinstance(phase, tuple) else (phase,) for phase in phases)


def _texts(node: ast.expr) -> Any:
    """Return an expression as text, or several as a tuple."""
    return tuple(map(_texts, node.elts)) if isinstance(node, ast.Tuple) else _text(node)


def linear(coefficients: tuple[str, ...], words: tuple[str, ...] = STATE) -> str:
    """Return a sum of coefficients times words.

    Examples
    --------
    >>> linear(("-K", "1", "0", "F_N*mu_s - c"))
    "-K x + x' + F_N*mu_s - c"
    >>> linear(("a + b", "-1", "0", "0"))
    "(a + b) x - x'"
    """
    found = ""
    for coefficient, word in zip(coefficients, words, strict=True):
        if _is_zero(coefficient):
            continue
        minus, factor = _signed(coefficient)
        term = _product(factor, word)
        if not word:  # a constant is not put in parentheses
            minus, term = coefficient.startswith("-"), coefficient.removeprefix("-")
        sign = "-" if minus else "+"
        found += f" {sign} {term}" if found else f"{'-' if minus else ''}{term}"
    return found or "0"


def _text(node: ast.expr) -> str:
    """Return an expression as text, products without spaces."""
    text = ast.unparse(node)
    for sign in ("*", "/", "**"):
        text = text.replace(f" {sign} ", sign)
    return text


def _is_zero(text: str) -> bool:
    return text in {"0", "0.0"}


def _signed(text: str) -> tuple[bool, str]:
    """Return whether there is a minus before all of it, and the rest."""
    node = ast.parse(text, mode="eval").body
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        return True, _text(node.operand)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult | ast.Div):
        minus, _ = _signed(_text(node.left))
        return minus, text.replace("-", "", 1) if minus else text
    return False, text


def _product(factor: str, word: str) -> str:
    if not word:
        return factor
    if factor in {"1", "1.0"}:
        return word
    node = ast.parse(factor, mode="eval").body
    divided = isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub)
    return f"({factor}) {word}" if divided else f"{factor} {word}"
