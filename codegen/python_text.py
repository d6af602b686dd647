"""SymPy expressions as the text of Python expressions that keep their digits."""

import hashlib
import math
import re

import sympy as sp
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.pycode import PythonCodePrinter


class NumericPrinter(PythonCodePrinter):  # type: ignore[misc]
    """Print small powers as products, and a fraction as one division.

    With products, plain and compiled code round alike; with ``s/2`` for ``(1/2)*s``, the
    functions keep the digits of exact numbers, too.
    """

    def _print_Mul(self, expr: sp.Mul) -> str:
        numerator, denominator = sp.fraction(expr)
        if denominator == 1:
            return str(super()._print_Mul(expr))
        is_negative = numerator.as_coeff_Mul()[0].is_negative
        sign, numerator = ("-", -numerator) if is_negative else ("", numerator)
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

    def _print_RisingFactorial(self, expr: sp.Expr) -> str:
        return f"rising({', '.join(map(self._print, expr.args))})"

    def _print_factorial(self, expr: sp.Expr) -> str:
        return f"rising(1, {self._print(expr.args[0])})"

    def _print_Exp1(self, expr: sp.Expr) -> str:
        return "exp(1)"  # e may be a parameter


def rising(x: float, k: int) -> float:
    """Return ``x (x + 1) ... (x + k - 1)``."""
    found = 1.0
    for i in range(k):
        found = found * (x + i)
    return found


#: Functions by the names that they have in the module ``math``.
PRINTER = NumericPrinter({"fully_qualified_modules": False, "allow_unknown_functions": True})


def python(expression: sp.Expr) -> str:
    """Return an expression in Python, functions by their names in the module ``math``."""
    return str(PRINTER.doprint(sp.sympify(expression)))


#: The functions of the module ``math``, and its number.
_MATH = (
    "pi",
    *(name for name in dir(math) if callable(getattr(math, name)) and name[0] != "_"),
)


def math_names(text: str) -> list[str]:
    """Return what the code in a text uses of the module ``math``."""
    code = re.sub(r'""".*?"""', "", text, flags=re.DOTALL)
    used = set(re.findall(r"(?<![\w.])(pi)\b|(?<![\w.])(?<!def )(\w+)\(", code))
    names = {name for pair in used for name in pair}
    return sorted(name for name in _MATH if name in names)


def digest(text: str) -> str:
    """Return the SHA-256 of `text`, in hexadecimal."""
    return hashlib.sha256(text.encode()).hexdigest()
