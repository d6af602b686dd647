"""The record that a derivation ends in, for a reader.

A `GalerkinSystem` is data: the equations as a reader is shown them, dimensional, in the paper's
notation, with its numbers.  It is frozen; nothing downstream of it derives anything.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import sympy as sp

from .printing.latex import displayed, equation_latex, in_notebook
from .printing.text import equation_text


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


class ShiftedLegendre(sp.Function):  # type: ignore[misc]
    """``P_n*(u) = P_n(2 u - 1)``, unevaluated, for printing."""

    nargs = 2


class TwiceIntegrated(sp.Function):  # type: ignore[misc]
    """``Q_n(u)``, unevaluated, for printing."""

    nargs = 2


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

    @property
    def words(self) -> str:
        """What the equation says, and where it holds."""
        return f"{self.title}; {self.where}" if self.where else self.title

    def latex(self) -> str:
        """Return the equation as displayed LaTeX, with its number as the tag."""
        return displayed(self)

    def text(self, unicode: bool = True) -> str:
        """Return the equation as text for a terminal, in Unicode or in plain ASCII."""
        return equation_text(self, unicode)

    def __str__(self) -> str:
        return self.text()

    def _repr_latex_(self) -> str:
        return self.latex()


#: An equation without a number, in words and with its sides.
line = partial(Equation, "")


@dataclass(frozen=True)
class Section:
    """A part of a document: a heading, its equations, and a sentence between the two."""

    heading: str
    equations: tuple[Equation, ...]
    note: str = ""


@dataclass(frozen=True)
class GalerkinSystem:
    """A scene in one expansion: its equations and their Jacobian.

    Parameters
    ----------
    method, section, title : str
        ``"hb"``, ``"3.1"``, and the heading of the section.
    unknowns : str
        The unknowns in the order of the kernel, for the reader.
    equations : tuple of Equation
        Expansion, residual, orthogonality conditions, closure.
    jacobian : tuple of Equation
        The derivatives of the conditions that are not zero; those of (5) to (7) and (14) by
        ``t1`` and ``T`` as the derivatives of the tables that they are linear in.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> ns.equations("hb-c1")  # doctest: +ELLIPSIS
    GalerkinSystem(method='hb-c1', section='3.2', ...)
    """

    method: str
    section: str
    title: str
    unknowns: str
    equations: tuple[Equation, ...] = field(repr=False)
    jacobian: tuple[Equation, ...] = field(repr=False)

    def equation(self, number: str) -> Equation:
        """Return the equation with this number in the paper.

        Raises
        ------
        KeyError
            If the method has no such equation.

        Examples
        --------
        >>> import nonsmooth as ns
        >>> equation = ns.equations("hb-c1").equation("11")
        >>> equation.title, equation.sides[0]
        ('expansion', x(t))
        """
        for candidate in self.equations:
            if candidate.number == number:
                return candidate
        numbers = ", ".join(e.number for e in self.equations if e.number)
        raise KeyError(f"{self.method} has no equation ({number}); it has {numbers}")

    def latex(self) -> str:
        """Return the equations as LaTeX, numbered as in the paper, without a preamble."""
        return "\n".join(map(equation_latex, self.equations))

    def text(self, unicode: bool = True) -> str:
        """Return the equations as text for a terminal, in Unicode or in plain ASCII."""
        return "\n\n".join(equation.text(unicode) for equation in self.equations)

    def __str__(self) -> str:
        return self.text()

    def _repr_latex_(self) -> str:
        return in_notebook(self.equations)


def require_zero(claims: Iterable[tuple[str, sp.Expr]]) -> None:
    """Check that SymPy reduces each expression to zero.

    A `DerivationError` names the first claim that does not hold.
    """
    for claim, difference in claims:
        remainder = sp.expand(sp.expand_func(difference))
        if remainder != 0:
            remainder = sp.cancel(remainder)  # quick; sines are symbols like others to it
        if remainder != 0:
            remainder = sp.simplify(remainder)
        if remainder != 0:
            raise DerivationError(f"{claim}: {remainder} is not zero")
