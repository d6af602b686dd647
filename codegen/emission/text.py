"""The text of a module of kernels: closed forms by `lambdify`, and loops in Python."""

import inspect
import types
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from ..python_text import PRINTER, digest, math_names


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


def functions_of(*modules: types.ModuleType) -> list[str]:
    """Return the text of all functions of runtimes; closed forms are none there."""
    texts = []
    for module in modules:
        own = (q for q in vars(module).values() if isinstance(q, types.FunctionType))
        texts += [inspect.getsource(q) for q in own if q.__module__ == module.__name__]
    return texts


def module_text(
    document: str,
    constants: Mapping[str, int],
    closed_forms: Sequence[ClosedForm],
    functions: Sequence[str],
) -> str:
    """Return the text of a module: what it is, its imports, constants, and functions."""
    numbers = "".join(f"{name} = {value}\n" for name, value in constants.items())
    texts = (*map(function_source, closed_forms), *functions)
    body = "\n\n".join(text.strip() + "\n" for text in texts)
    names = math_names(body)
    math = f"from math import {', '.join(names)}\n\n" if names else ""
    legendre = "from numpy.polynomial import legendre\n" if "legendre.legval" in body else ""
    both = marks(closed_forms, numbers + body)
    return f"{document}\n{math}import numpy as np\n{legendre}\n{both}\n{numbers}\n\n{body}"


def marks(closed_forms: Sequence[ClosedForm], text: str) -> str:
    """Return the lines that say of which derivation a module is, and what its text is."""
    derived = "\n".join(f"{q.name}{q.arguments}{sp.srepr(q.values)}" for q in closed_forms)
    return (
        f'MATHEMATICS = "{digest(derived)}"  # of the closed forms, by srepr\n'
        f'BODY = "{digest(text)}"  # of the text below\n'
    )
