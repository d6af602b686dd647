"""The text of a module of kernels: closed forms, and the loops that stand here as Python."""

import inspect
import types
from collections.abc import Mapping, Sequence

import sympy as sp

from ..python_text import digest, math_names
from .closed_forms import ClosedForm, function_source


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
    derived = "\n".join(f"{q.name}{q.arguments}{sp.srepr(q.values)}" for q in closed_forms)
    marks = f'MATHEMATICS = "{digest(derived)}"  # of the closed forms, by srepr\n'
    marks += f'BODY = "{digest(numbers + body)}"  # of the text below\n'
    return f"{document}\n{math}import numpy as np\n{legendre}\n{marks}\n{numbers}\n\n{body}"
