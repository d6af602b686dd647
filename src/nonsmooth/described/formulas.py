"""The formulas of a scene as text, read from its generated module: no SymPy is needed."""

import ast
import inspect
from functools import cache
from types import ModuleType

#: What a linear form is linear in.
STATE = ("x", "x'", "cos(Omega t + phi)", "")


@cache
def rows(module: ModuleType, function: str) -> tuple[tuple[str, ...], ...]:
    """Return what a function of the module returns, as text: a tuple for each phase.

    Where it returns one expression for each phase, each is a tuple of one.
    """
    source = ast.parse(inspect.getsource(getattr(module, function)))
    (result,) = (node for node in ast.walk(source) if isinstance(node, ast.Return))
    assert isinstance(result.value, ast.Tuple)
    return tuple(
        tuple(map(_text, row.elts)) if isinstance(row, ast.Tuple) else (_text(row),)
        for row in result.value.elts
    )


def nested(module: ModuleType, function: str) -> tuple[tuple[tuple[str, ...], ...], ...]:
    """Return what a function of the module returns that has several rows for each phase."""
    source = ast.parse(inspect.getsource(getattr(module, function)))
    (result,) = (node for node in ast.walk(source) if isinstance(node, ast.Return))
    assert isinstance(result.value, ast.Tuple)
    return tuple(
        tuple(tuple(map(_text, row.elts)) for row in phase.elts if isinstance(row, ast.Tuple))
        for phase in result.value.elts
        if isinstance(phase, ast.Tuple)
    )


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
