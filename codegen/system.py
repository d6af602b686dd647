"""Stage 3: the record that a derivation ends in, and that printing and emission read.

A `GalerkinSystem` is data: the equations as a reader is shown them (dimensional, in the
paper's notation, with its numbers) and the closed forms of which a kernel is made
(dimensionless).  It is frozen; nothing downstream of it derives anything.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import sympy as sp


class DerivationError(Exception):
    """A statement that the derivation rests on was refuted by SymPy."""


class Inner(sp.Function):  # type: ignore[misc]
    """The inner product (8), unevaluated, for printing."""

    nargs = 2

    def _latex(self, printer: Any, exp: str | None = None) -> str:
        left, right = (printer._print(argument) for argument in self.args)
        return rf"\left\langle {left},\, {right} \right\rangle"

    def _sympystr(self, printer: Any) -> str:
        left, right = (printer._print(argument) for argument in self.args)
        return f"<{left}, {right}>"


@dataclass(frozen=True)
class Equation:
    """One numbered statement: a chain of sides that are equal.

    Parameters
    ----------
    number : str
        Number in the paper, such as ``"6"``; empty for what the paper does not number.
    title : str
        What the equation says, in a few words.
    sides : tuple of Expr
        Equal to each other, from the paper's form to the closed form and its value.
    where : str
        The range of the indices or of the time, for the reader.
    """

    number: str
    title: str
    sides: tuple[sp.Expr, ...]
    where: str = ""


@dataclass(frozen=True)
class ClosedForm:
    """One function of the kernel: what SymPy derived, for `lambdify` to write.

    Parameters
    ----------
    name : str
        Name of the function in the generated module.
    summary : str
        Its docstring; names the equation of the paper.
    arguments : tuple of Symbol or IndexedBase
        In the order of the function's signature.
    values : tuple of Expr
        What it returns; a scalar when there is one, else a tuple.
    """

    name: str
    summary: str
    arguments: tuple[Any, ...]
    values: tuple[sp.Expr, ...]


@dataclass(frozen=True)
class GalerkinSystem:
    """One method of the paper: its equations, its Jacobian, its closed forms.

    Parameters
    ----------
    method, section, title : str
        ``"hb"``, ``"3.1"``, and the heading of the section.
    unknowns : str
        The unknowns in the order of the kernel, for the reader.
    equations : tuple of Equation
        Expansion, residual, orthogonality conditions, closure.
    jacobian : tuple of Equation
        The derivative of the conditions with respect to every unknown.
    forms : tuple of ClosedForm
        Dimensionless closed forms, in the order in which they are emitted.
    """

    method: str
    section: str
    title: str
    unknowns: str
    equations: tuple[Equation, ...]
    jacobian: tuple[Equation, ...]
    forms: tuple[ClosedForm, ...]

    def equation(self, number: str) -> Equation:
        """Return the equation with this number in the paper.

        Raises
        ------
        KeyError
            If the method has no such equation.
        """
        for candidate in self.equations:
            if candidate.number == number:
                return candidate
        known = ", ".join(e.number for e in self.equations if e.number)
        raise KeyError(f"{self.method} has no equation ({number}); it has {known}")

    def latex(self) -> str:
        """Return the equations as LaTeX, numbered as in the paper, without a preamble."""
        from .printing import system_latex  # noqa: PLC0415  (printing derives, too)

        return system_latex(self)

    def text(self) -> str:
        """Return the equations as text for a terminal."""
        from .printing import system_text  # noqa: PLC0415

        return system_text(self)

    def __str__(self) -> str:
        return self.text()

    def _repr_latex_(self) -> str:
        return self.latex()

    def form(self, name: str) -> ClosedForm:
        """Return the closed form that becomes the function `name` of the kernel."""
        return next(form for form in self.forms if form.name == name)


def require_zero(claims: Iterable[tuple[str, sp.Expr]]) -> None:
    """Check that SymPy reduces each expression to zero.

    Raises
    ------
    DerivationError
        Naming the first claim that does not hold.
    """
    for claim, difference in claims:
        remainder = sp.expand(sp.expand_func(difference))
        if remainder != 0:
            remainder = sp.simplify(remainder)
        if remainder != 0:
            raise DerivationError(f"{claim}: {remainder} is not zero")
