"""SymPy expressions as the text of Python expressions that keep their digits."""

import inspect
import re
from collections.abc import Iterator, Sequence

import sympy as sp

from ..emit import NumericPrinter


class KernelPrinter(NumericPrinter):
    """Print numbers as floats would be read, and tables as they are indexed."""

    def _print_Indexed(self, expr: sp.Indexed) -> str:
        indices = ", ".join(str(sp.expand(index)) for index in expr.indices)
        return f"{expr.base.label}[{indices}]"


def python_all(
    expressions: Sequence[sp.Expr], arguments: Sequence[sp.Expr] = ()
) -> tuple[str, ...]:
    """Return what `sympy.lambdify` writes behind ``return`` for each of some expressions."""
    settings = {"fully_qualified_modules": False, "allow_unknown_functions": True}
    printer = KernelPrinter(settings)
    values = tuple(map(sp.sympify, expressions))
    function = sp.lambdify(tuple(arguments), values, modules="math", printer=printer)
    text = inspect.getsource(function).partition("return ")[2].strip()
    return tuple(_items(text.removeprefix("(").removesuffix(")")))


def python(expression: sp.Expr, arguments: Sequence[sp.Expr] = ()) -> str:
    """Return what `sympy.lambdify` writes behind ``return`` for one expression."""
    return python_all((expression,), arguments)[0]


def _items(text: str) -> Iterator[str]:
    """Yield what stands between the commas of a tuple, but for those within brackets."""
    depth, item = 0, ""
    for letter in text:
        depth += (letter in "([") - (letter in ")]")
        if letter == "," and depth == 0:
            yield item.strip()
            item = ""
        else:
            item += letter
    if item.strip():
        yield item.strip()


def math_names(text: str) -> list[str]:
    """Return what a text uses of the module ``math``."""
    names = ("cos", "exp", "pi", "sin", "sqrt")
    return [name for name in names if re.search(rf"(?<![\w.]){name}\b", text)]
