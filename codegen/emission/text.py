"""The text of a module of closed forms."""

import inspect
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from ..python_text import digest, math_names, python, rising


@dataclass(frozen=True)
class ClosedForm:
    """One function of a generated module, with expressions derived by SymPy.

    Parameters
    ----------
    name : str
        Name of the function.
    summary : str
        Its docstring.
    arguments : tuple of Symbol or IndexedBase
        In the order of the function's signature.
    values : tuple of Expr
        Its results: one is returned as a scalar, several as a tuple.
    """

    name: str
    summary: str
    arguments: tuple[Any, ...]
    values: tuple[sp.Expr, ...]


def expression_source(value: sp.Expr) -> str:
    """Return the source of one value."""
    return f"{value}.0" if value.is_Integer else python(value)  # a float like the others


def function_source(form: ClosedForm) -> str:
    """Return the source of one closed form, with one value on each line."""
    arguments = ", ".join(str(argument) for argument in form.arguments)
    values = list(map(expression_source, form.values))
    if len(values) == 1:
        result = values[0]
    else:
        result = "(\n" + "".join(f"        {value},\n" for value in values) + "    )"
    return f'def {form.name}({arguments}):\n    """{form.summary}"""\n    return {result}\n'


def module_text(
    document: str, closed_forms: Sequence[ClosedForm], beside: Sequence[ClosedForm] = ()
) -> str:
    """Return the text of a module: its docstring, the hash of its derivation, its functions.

    The hash includes closed forms `beside` them, which are those of another module.
    """
    body = "\n\n".join(map(function_source, closed_forms))
    if "rising(" in body:
        body += "\n\n" + inspect.getsource(rising)
    names = math_names(body)
    math = f"from math import {', '.join(names)}\n\n" if names else ""
    return f"{document}\n{math}{mark((*beside, *closed_forms))}\n\n{body}"


def mark(closed_forms: Sequence[ClosedForm]) -> str:
    """Return the line with the hash of the derivation of closed forms."""
    derived = "\n".join(f"{q.name}{q.arguments}{sp.srepr(q.values)}" for q in closed_forms)
    return f'MATHEMATICS = "{digest(derived)}"  # of the closed forms, by srepr\n'
