"""A kernel in ball arithmetic: its own source, evaluated over other numbers.

Each operation of the source becomes one on balls (Arb, by python-flint); quotients of integers
are exact.  The radius of a result bounds its rounding error.  Only the spherical Bessel
functions are replaced: their recurrences are made for the precision of float64.
"""

import ast
import inspect
from collections.abc import Callable
from functools import cache
from math import prod
from types import FunctionType
from typing import Any

import numpy as np
from flint import arb, ctx, fmpq

#: Types of integers in a kernel, from loops and from arrays.
WHOLE = (int, np.integer)

#: Fills R with the residual at z: ``residual(case, z, R)``, over balls.
Residual = Callable[[Any, Any, Any], None]


def residual_in_balls(residual: Callable[..., None]) -> Residual:
    """Return the residual of a kernel over balls, at the precision in force."""
    function = _plain(residual)
    in_balls: Residual = _functions(function, ctx.dps)[function.__name__]
    return in_balls


def _plain(value: Any) -> Any:
    """Return the Python function of a compiled one; anything else unchanged."""
    return getattr(value, "py_func", value)


@cache
def _functions(first: FunctionType, digits: int) -> dict[str, Any]:
    """Return a function and all that it calls, over balls; `digits` are those in force."""
    namespace: dict[str, Any] = {
        "cos": lambda x: arb(x).cos(),
        "sin": lambda x: arb(x).sin(),
        "sqrt": lambda x: arb(x).sqrt(),
        "exp": lambda x: arb(x).exp(),
        "pi": arb.pi(),
        "np": _Arrays,
        "quotient": quotient,
        "spherical_bessel": spherical_bessel,
        "rising": rising,
    }
    pending = [first]
    while pending:
        function = pending.pop()
        tree = _Exact().visit(ast.parse(inspect.getsource(function)))
        exec(compile(ast.fix_missing_locations(tree), "in balls", "exec"), namespace)
        for name in {*function.__code__.co_names} - namespace.keys():
            used = _plain(function.__globals__.get(name))
            if isinstance(used, FunctionType):
                pending.append(used)
            elif isinstance(used, int):
                namespace[name] = used
    return namespace


class _Exact(ast.NodeTransformer):
    """Replace divisions by calls of `quotient`."""

    def visit_BinOp(self, node: ast.BinOp) -> ast.AST:
        self.generic_visit(node)
        if not isinstance(node.op, ast.Div):
            return node
        return ast.Call(ast.Name("quotient", ast.Load()), [node.left, node.right], [])


def quotient(above: Any, below: Any) -> Any:
    """Return a quotient as a ball; that of integers is rounded only once."""
    if isinstance(above, WHOLE) and isinstance(below, WHOLE):
        return arb(fmpq(int(above), int(below)))
    return above / (arb(below) if isinstance(below, int | float) else below)


def rising(x: int, k: int) -> int:
    """Return ``x (x + 1) ... (x + k - 1)``, exact."""
    return prod(range(int(x), int(x + k)))


def as_balls(argument: Any) -> Any:
    """Return the first argument of a kernel's functions with balls in place of floats."""
    if isinstance(argument, tuple):
        return tuple(map(as_balls, argument))
    if isinstance(argument, np.ndarray) and argument.dtype == float:
        return np.frompyfunc(arb, 1, 1)(argument)
    return argument


class _Arrays:
    """The functions of NumPy that kernels use, with arrays of objects."""

    int64 = np.int64

    @staticmethod
    def zeros(shape: Any, dtype: Any = None) -> Any:
        return np.full(shape, arb(0), dtype=object) if dtype is None else np.zeros(shape, dtype)

    @staticmethod
    def ones(shape: Any) -> Any:
        return np.full(shape, arb(1), dtype=object)

    empty = zeros


def spherical_bessel(x: Any, j: Any) -> None:
    """Fill j with ``j_0(x), j_1(x), ...`` of a ball: the last two, then by downward recurrence.

    ``j_n(x) = x^n/(2 n + 1)!! 0F1(n + 3/2; -x^2/4)`` (DLMF 10.16.9, 10.47.3).
    """
    x, count = arb(x), len(j)
    if x == 0:
        j[:] = arb(0)
        j[0] = arb(1)
        return
    double, power = arb(1), arb(1)
    for n in range(count):
        if n:
            double, power = double * (2 * n + 1), power * x
        if n >= count - 2:
            j[n] = power / double * (-x * x / 4).hypgeom_0f1(arb(2 * n + 3) / 2)
    for n in range(count - 3, -1, -1):
        j[n] = (2 * n + 3) / x * j[n + 1] - j[n + 2]
