"""Closed forms as functions of plain Python, as `sympy.lambdify` writes them."""

import inspect
from dataclasses import dataclass
from typing import Any

import sympy as sp

from ..python_text import NumericPrinter


@dataclass(frozen=True)
class ClosedForm:
    """One function of a generated module: what SymPy derived, for `lambdify` to write.

    Parameters
    ----------
    name : str
        Name of the function.
    summary : str
        Its docstring.
    arguments : tuple of Symbol or IndexedBase
        In the order of the function's signature.
    values : tuple of Expr
        What it returns; a scalar when there is one, else a tuple.
    """

    name: str
    summary: str
    arguments: tuple[Any, ...]
    values: tuple[sp.Expr, ...]


def _expression_source(form: ClosedForm, value: sp.Expr) -> str:
    """Return what `sympy.lambdify` writes behind ``return`` for one value of `form`."""
    if value.is_Integer:
        return f"{value}.0"  # of one type with the other values
    settings = {"fully_qualified_modules": False, "allow_unknown_functions": True}
    printer = NumericPrinter(settings)
    function = sp.lambdify(form.arguments, value, modules="math", printer=printer)
    return inspect.getsource(function).partition("return ")[2].strip()


def function_source(form: ClosedForm) -> str:
    """Return the source of one closed form: a value a line, as `lambdify` writes it."""
    arguments = ", ".join(str(argument) for argument in form.arguments)
    values = [_expression_source(form, value) for value in form.values]
    if len(values) == 1:
        result = values[0]
    else:
        result = "(\n" + "".join(f"        {value},\n" for value in values) + "    )"
    return f'def {form.name}({arguments}):\n    """{form.summary}"""\n    return {result}\n'
