"""SymPy expressions as the text of Python expressions that keep their digits."""

import math
import re

import sympy as sp

from .printer import NumericPrinter


class KernelPrinter(NumericPrinter):
    """Print numbers as floats would be read, and tables as they are indexed."""

    def _print_Indexed(self, expr: sp.Indexed) -> str:
        indices = ", ".join(str(sp.expand(index)) for index in expr.indices)
        return f"{expr.base.label}[{indices}]"

    def _print_KroneckerDelta(self, expr: sp.KroneckerDelta) -> str:
        symbol, value = sorted(expr.args, key=lambda q: not q.is_Symbol)
        return f"(1.0 if {symbol} == {value} else 0.0)"

    def _print_Exp1(self, expr: sp.Expr) -> str:
        return "exp(1)"  # e may be a parameter


_PRINTER = KernelPrinter({"fully_qualified_modules": False, "allow_unknown_functions": True})


def python(expression: sp.Expr) -> str:
    """Return an expression in Python, functions by their names in the module ``math``."""
    return str(_PRINTER.doprint(sp.sympify(expression)))


def floating(expression: sp.Expr) -> str:
    """Return an expression in Python that is a float, also where it is an integer."""
    value = sp.sympify(expression)
    return f"{value}.0" if value.is_Integer else python(value)


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
