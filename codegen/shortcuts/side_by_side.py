"""An equation, and beside it the functions of the generated module that compute it.

Input: the record of a method, and its module in ``generated/``.
Output: the two together, for a reader who compares them.
"""

from importlib import import_module
from inspect import getsource
from typing import NamedTuple

from ..system import Equation, GalerkinSystem


class SideBySide(NamedTuple):
    """An equation of the record, its LaTeX, and the source of its functions."""

    equation: Equation
    latex: str
    source: str


def side_by_side(system: GalerkinSystem) -> tuple[SideBySide, ...]:
    """Return each equation that the generated module of the method computes, with its code."""
    name = system.method.replace("-", "_")
    module = import_module(f"...generated.shortcuts.{name}", __package__)
    return tuple(
        SideBySide(
            equation,
            equation.latex(),
            "\n\n".join(getsource(getattr(module, name)) for name in equation.functions),
        )
        for equation in system.equations
        if equation.functions
    )
