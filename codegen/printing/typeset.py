"""Typeset expressions in LaTeX, with the paper's symbols.

Input: an expression.  Output: LaTeX mathematics, without an environment.
"""

import re

import sympy as sp
from sympy.printing.latex import LatexPrinter

from .drawing import LETTERS, with_word
from .order import factors, terms


class _Latex(LatexPrinter):  # type: ignore[misc]
    """LaTeX with the paper's symbols."""

    def _as_ordered_terms(self, expr: sp.Expr, order: str | None = None) -> list[sp.Expr]:
        return terms(expr)

    def _print_Mul(self, expr: sp.Expr) -> str:
        if not isinstance(expr, sp.Mul):
            return str(super()._print_Mul(expr))
        if expr.could_extract_minus_sign():
            return f"- {self._in_order(-expr)}"
        return self._in_order(expr)

    def _in_order(self, expr: sp.Expr) -> str:
        if expr.is_Add:
            return f"({self._print(expr)})"
        ordered = factors(expr) if expr.is_Mul else expr
        return str(super()._print_Mul(ordered) if ordered.is_Mul else self._print(ordered))

    def _print_Symbol(self, expr: sp.Symbol, style: str = "plain") -> str:
        if expr.name.endswith("'"):  # not a part of the word below
            return self._print_Symbol(sp.Symbol(expr.name[:-1])) + "'"
        short, word = with_word(expr.name)
        if word:
            return f"{self._print(sp.Symbol(short))}_{{{_upright(word)}}}"
        return _WORD.sub(r"\\mathrm{\g<0>}", str(super()._print_Symbol(expr)))

    def _print_Indexed(self, expr: sp.Indexed) -> str:
        base, indices = str(expr.base.label), ", ".join(map(self._print, expr.indices))
        name, word = with_word(base)
        if word:
            return rf"{self._print(sp.Symbol(name))}^{{{_upright(word)}}}_{{{indices}}}"
        label = self._print(expr.base.label)
        if "_{" in label:  # of one letter, which stands below with the indices
            return f"{label.removesuffix('}')}, {indices}}}"
        return f"{label}_{{{indices}}}"

    def _hprint_Function(self, func: str) -> str:
        named = "_" in func or "'" in func
        return str(self._print(sp.Symbol(func)) if named else super()._hprint_Function(func))

    def _print_Derivative(self, expr: sp.Derivative) -> str:
        ((variable, order),) = expr.variable_count
        function = expr.expr
        if isinstance(function, sp.core.function.AppliedUndef):
            name = self._print(sp.Symbol(function.func.__name__)) + "'" * int(order)
            return rf"{name}\left({self._print(variable)}\right)"
        below = rf"\partial {self._print(variable)}"
        if function.is_Symbol or isinstance(function, sp.Indexed):
            return rf"\frac{{\partial {self._print(function)}}}{{{below}}}"
        return rf"\frac{{\partial}}{{{below}}} \left({self._print(function)}\right)"

    def _print_KroneckerDelta(self, expr: sp.KroneckerDelta, exp: str | None = None) -> str:
        first, second = map(self._print, expr.args)
        return rf"\delta_{{{first}, {second}}}"

    def _with_index(self, expr: sp.Expr, exp: str | None = None) -> str:
        index, argument = map(self._print, expr.args)
        letter = LETTERS[expr.func.__name__].replace("*", "^{*}")
        return rf"{letter}_{{{index}}}\left({argument}\right)"

    _print_ShiftedLegendre = _print_TwiceIntegrated = _with_index  # noqa: N815  (of classes)


def _upright(word: str) -> str:
    return rf"\mathrm{{{word.replace('_', chr(92) + '_')}}}"


#: Brackets about what is no higher than they are: they need not stretch.
_FLAT = re.compile(
    r"(?<![\^_])({)?\\left\(((?:(?!\\left|\\right|\\frac|\\sum|\\int).)*?) ?\\right\)(?(1)})"
)

#: A name of several letters, which would be their product.
_WORD = re.compile(r"^[a-z]{2,}")

_SETTINGS = {"mul_symbol": None, "fold_short_frac": False, "order": "none"}


def latex(expression: sp.Expr) -> str:
    """Return `expression` as LaTeX mathematics."""
    text = str(_Latex(_SETTINGS).doprint(expression))
    text = text.replace(r"\operatorname{q}", "q")
    while (flat := _FLAT.sub(r"(\2)", text)) != text:
        text = flat
    return text
