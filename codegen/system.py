"""Stage 3: the record that a derivation ends in, and that printing and emission read.

A `GalerkinSystem` is data: the equations as a reader is shown them (dimensional, in the
paper's notation, with its numbers) and the closed forms of which a kernel is made
(dimensionless).  It is frozen; nothing downstream of it derives anything.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

#: What the methods of a record call to be read: `readers` fills it, of stages that import this
#: one.  A record itself holds no printer and knows of none.
READERS: dict[str, Callable[..., Any]] = {}


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
    functions : tuple of str
        Functions of the generated module that compute it, closed forms first.
    """

    number: str
    title: str
    sides: tuple[sp.Expr, ...]
    where: str = ""
    functions: tuple[str, ...] = ()

    @property
    def words(self) -> str:
        """What the equation says, and where it holds."""
        return f"{self.title}; {self.where}" if self.where else self.title

    def latex(self) -> str:
        """Return the equation as displayed LaTeX, with its number as the tag."""
        return str(READERS["latex"](self))

    def text(self, unicode: bool = True) -> str:
        """Return the equation as text for a terminal, in Unicode or in plain ASCII."""
        return str(READERS["text"](self, unicode))

    def __str__(self) -> str:
        return self.text()

    def _repr_latex_(self) -> str:
        return self.latex()


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
        The derivatives of the conditions that are not zero; those of (5) to (7) and (14) by
        ``t1`` and ``T`` as the derivatives of the tables that they are linear in.
    forms : tuple of ClosedForm
        Dimensionless closed forms, in the order in which they are emitted.
    coefficients : tuple of Symbol or Indexed
        The unknown coefficients of the paper; an index runs from 1 or, where its symbol
        may be zero, from 0 to ``N``.

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
    forms: tuple[ClosedForm, ...] = field(repr=False)
    coefficients: tuple[sp.Expr, ...] = field(default=(), repr=False)

    def equation(self, number: str) -> Equation:
        """Return the equation with this number in the paper.

        Raises
        ------
        KeyError
            If the method has no such equation.

        Examples
        --------
        >>> import nonsmooth as ns
        >>> equation = ns.equations("hb").equation("9")
        >>> equation.title, equation.sides
        ('displacement at t = 0', (x(0), a0/2 + Sum(b[n], (n, 1, N)), x_0))
        """
        for candidate in self.equations:
            if candidate.number == number:
                return candidate
        known = ", ".join(e.number for e in self.equations if e.number)
        raise KeyError(f"{self.method} has no equation ({number}); it has {known}")

    def latex(self) -> str:
        """Return the equations as LaTeX, numbered as in the paper, without a preamble."""
        return str(READERS["all latex"](self.equations))

    def text(self, unicode: bool = True) -> str:
        """Return the equations as text for a terminal, in Unicode or in plain ASCII."""
        return "\n\n".join(equation.text(unicode) for equation in self.equations)

    def __str__(self) -> str:
        return self.text()

    def _repr_latex_(self) -> str:
        return str(READERS["notebook"](self.equations))

    def unknown_symbols(self, order: int) -> tuple[sp.Expr, ...]:
        """Return the unknowns at one order: the paper's coefficients, ``t1`` and ``T``.

        Examples
        --------
        >>> import nonsmooth as ns
        >>> ns.equations("hb").unknown_symbols(2)
        (a0, a[1], a[2], b[1], b[2], t1, T)
        """
        found: tuple[sp.Expr, ...] = READERS["unknowns"](self, order)
        return found

    def expanded(self, order: int) -> tuple[sp.Eq, ...]:
        """Return the conditions at one order, every sum carried out, as SymPy equations.

        They are in the unknowns and the parameters of the oscillator alone, for the paper's
        ``M``, ``K``, ``V``, ``mu_s``, ``mu_k``, ``F_N``: what the record abbreviates, the
        natural frequency and the displacements ``x_0``, ``x_s`` among it, is put in.

        Parameters
        ----------
        order : int
            ``N``, from 1 to 5.

        Raises
        ------
        ValueError
            If `order` is anything else, or the record is not in the paper's unknowns.

        Examples
        --------
        >>> import nonsmooth as ns
        >>> import sympy as sp
        >>> ns.equations("hb").expanded(1)[-2]
        Eq(a0/2 + b[1], F_N*(2*mu_k - mu_s)/K)
        >>> *_, displacement, velocity = ns.equations("c1").expanded(1)
        >>> velocity
        Eq((T - t1)**2*d[1]/2 + (T - t1)*d[0], 0)
        >>> f = sp.lambdify(ns.equations("c1").unknown_symbols(1), velocity.lhs)
        >>> f(-1.0, 0.5, 2.0, 6.0)
        0.0
        """
        found: tuple[sp.Eq, ...] = READERS["expanded"](self, order)
        return found

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
            remainder = sp.cancel(remainder)  # quick; sines are symbols like others to it
        if remainder != 0:
            remainder = sp.simplify(remainder)
        if remainder != 0:
            raise DerivationError(f"{claim}: {remainder} is not zero")
