"""Expressions as Python text that keeps digits, and the hash of a text."""

import hashlib

import sympy as sp
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.pycode import PythonCodePrinter


def _is_negative(expression: sp.Expr) -> bool:
    return bool(expression.as_coeff_Mul()[0].is_negative)


class NumericPrinter(PythonCodePrinter):  # type: ignore[misc]
    """Print small powers as products, and a fraction as one division.

    With products, plain and compiled code round alike; with ``s/2`` for ``(1/2)*s``, the
    functions keep the digits of exact numbers, too.
    """

    def _print_Mul(self, expr: sp.Mul) -> str:
        numerator, denominator = sp.fraction(expr)
        if denominator == 1:
            return str(super()._print_Mul(expr))
        sign, numerator = ("-", -numerator) if _is_negative(numerator) else ("", numerator)
        above = self.parenthesize(numerator, PRECEDENCE["Mul"])
        below = self.parenthesize(denominator, PRECEDENCE["Pow"], strict=False)
        return f"{sign}{above}/{below}"

    def _print_Pow(self, expr: sp.Pow, rational: bool = False) -> str:
        base, exponent = expr.as_base_exp()
        if exponent.is_Integer and 2 <= abs(int(exponent)) <= 6:
            text = self.parenthesize(base, 100)
            product = "*".join([text] * abs(int(exponent)))
            return f"({product})" if exponent > 0 else f"1/({product})"
        return str(super()._print_Pow(expr, rational=rational))


def digest(text: str) -> str:
    """Return the SHA-256 of `text`, in hexadecimal."""
    return hashlib.sha256(text.encode()).hexdigest()
