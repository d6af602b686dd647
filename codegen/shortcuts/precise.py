"""Stage 4b: a `GalerkinSystem` as functions over numbers of any precision.

Input: the record of a method, and a number type (its cosine, sine, pi and fractions).
Output: the functions of the kernel over those numbers.

The closed forms are printed anew from the record, with fractions that stay exact; the loops
are those of the kernel.  Nothing is typed twice.
"""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import sympy as sp

from ..emission.printer import NumericPrinter
from .emit import LOOPS
from .methods import of_the_paper as derive


class ExactPrinter(NumericPrinter):
    """Print fractions of whole numbers as ``rational(p, q)``: no float64 in between."""

    def _print_Rational(self, expr: sp.Rational) -> str:
        return f"rational({expr.p}, {expr.q})"

    def _print_Pow(self, expr: sp.Pow, rational: bool = False) -> str:
        text = super()._print_Pow(expr, rational=rational)
        return f"rational(1, 1)/{text[2:]}" if text.startswith("1/") else text


class _Arrays:
    """What the loops use of NumPy, with room for any number."""

    def __init__(self, zero: Any) -> None:
        self.zero = zero

    def empty(self, shape: Any) -> Any:
        return np.full(shape, self.zero, dtype=object)

    zeros = empty


def function(
    arguments: tuple[Any, ...], values: tuple[sp.Expr, ...], numbers: Mapping[str, Any]
) -> Callable[..., Any]:
    """Return `values` as a function over other numbers; a scalar if there is one value."""
    settings = {"fully_qualified_modules": False, "allow_unknown_functions": True}
    value = values[0] if len(values) == 1 else values
    printer = ExactPrinter(settings)
    result: Callable[..., Any] = sp.lambdify(
        arguments, value, modules=[dict(numbers)], printer=printer
    )
    return result


def kernel(method: str, numbers: Mapping[str, Any]) -> dict[str, Callable[..., Any]]:
    """Return the functions of a kernel over other numbers, by name.

    Parameters
    ----------
    method : {"hb", "hb-c1", "c1"}
        Section 3.1, 3.2 or 3.3.
    numbers : mapping
        ``cos``, ``sin``, ``pi``, ``rational(p, q)`` of the number type.

    Returns
    -------
    dict
        Among others ``residual(alpha, z, R)`` and ``size(N)``; see the generated module.
    """
    system = derive(method)
    namespace: dict[str, Any] = {"np": _Arrays(numbers["rational"](0, 1)), **numbers}
    for form in system.forms:
        namespace[form.name] = function(form.arguments, form.values, numbers)
    exec(LOOPS[method], namespace)
    if method != "c1":
        _direct_waves(namespace)
    if method == "hb-c1":
        _in_closed_form(namespace)
    return namespace


def _direct_waves(namespace: dict[str, Any]) -> None:
    """Replace the rotations of the kernel, whose bounds would grow with every turn."""

    def waves(turn: Any, highest: int) -> tuple[list[Any], list[Any]]:
        cos, sin = namespace["cos"], namespace["sin"]
        turns = [k * turn for k in range(highest + 1)]
        return [cos(x) for x in turns], [sin(x) for x in turns]

    namespace["waves"] = waves


def _in_closed_form(namespace: dict[str, Any]) -> None:
    """Replace what `hb-c1` does for the sake of float64 by the closed forms themselves.

    (14) is not integrated by a Gauss rule, and the spherical Bessel functions have no
    series: the digits that this costs are there to be spent.
    """

    def spherical_bessel(z: Any, cos_z: Any, sin_z: Any) -> tuple[Any, ...]:
        return tuple(namespace[f"spherical_bessel_{l}"](cos_z, sin_z, z) for l in range(4))

    def g1_condition(N: int, z: Any, gamma: Any) -> Any:
        t1, T = z[-2], z[-1]
        C, S = namespace["slip_integrals"](N, t1, T)
        D = namespace["period_terms"](N, T)
        tail = namespace["tail_column"](
            N, C, S, D, namespace["harmonics_of_g1"](N, t1, T), t1, T, 1
        )
        R = namespace["np"].empty(2 * N + 2)
        namespace["c1_product"](N, z, C[0], S[0], D[0], tail[0], R)
        return R[2 * N + 1]

    namespace["spherical_bessel"] = spherical_bessel
    namespace["g1_condition"] = g1_condition
