"""The text of a module of closed forms, by `lambdify`."""

import inspect
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from ..python_text import PRINTER, digest, math_names, rising


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


def expression_source(form: ClosedForm, value: sp.Expr) -> str:
    """Return what `sympy.lambdify` writes behind ``return`` for one value of `form`."""
    if value.is_Integer:
        return f"{value}.0"  # of one type with the other values
    function = sp.lambdify(form.arguments, value, modules="math", printer=PRINTER)
    return inspect.getsource(function).partition("return ")[2].strip()


def function_source(form: ClosedForm) -> str:
    """Return the source of one closed form: a value a line, as `lambdify` writes it."""
    arguments = ", ".join(str(argument) for argument in form.arguments)
    values = [expression_source(form, value) for value in form.values]
    if len(values) == 1:
        result = values[0]
    else:
        result = "(\n" + "".join(f"        {value},\n" for value in values) + "    )"
    return f'def {form.name}({arguments}):\n    """{form.summary}"""\n    return {result}\n'


def module_text(
    document: str, closed_forms: Sequence[ClosedForm], beside: Sequence[ClosedForm] = ()
) -> str:
    """Return the text of a module: what it is, of which derivation, and its functions.

    The derivation is of the closed forms and of those `beside` them, of another module.
    """
    body = "\n\n".join(map(function_source, closed_forms))
    if "rising(" in body:
        body += "\n\n" + inspect.getsource(rising)
    names = math_names(body)
    math = f"from math import {', '.join(names)}\n\n" if names else ""
    return f"{document}\n{math}{mark((*beside, *closed_forms))}\n\n{body}"


def mark(closed_forms: Sequence[ClosedForm]) -> str:
    """Return the line that says of which derivation a module is."""
    derived = "\n".join(f"{q.name}{q.arguments}{sp.srepr(q.values)}" for q in closed_forms)
    return f'MATHEMATICS = "{digest(derived)}"  # of the closed forms, by srepr\n'
