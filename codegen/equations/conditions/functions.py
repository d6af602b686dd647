"""Functions that are printed unevaluated: derivatives at a time, families with an index."""

from typing import Any

import sympy as sp
from sympy.printing.pretty.stringpict import prettyForm, stringPict

t = sp.Symbol("t", positive=True)
u = sp.Symbol("u", nonnegative=True)
T, omega_0 = sp.symbols("T omega_0", positive=True)
x = sp.Function("x")

#: The residual of the equation of motion.
R = sp.Function("R")(t)

_DOTS = {1: r"\dot{x}", 2: r"\ddot{x}"}


class Rate(sp.Function):  # type: ignore[misc]
    """``Rate(order, time)``: a derivative of the displacement at a time."""

    nargs = 2

    @property
    def times_differentiated(self) -> sp.Expr:
        """The order of the derivative, by which terms are sorted."""
        return self.args[0]

    def _pretty(self, printer: Any) -> prettyForm:
        order, time = self.args
        at = prettyForm(*printer._print(time).parens())
        return prettyForm(*stringPict.next("x" + "'" * int(order), at))

    def _latex(self, printer: Any, exp: str | None = None) -> str:
        order, time = int(self.args[0]), printer._print(self.args[1])
        name = _DOTS.get(order, rf"x^{{({order})}}")
        return rf"{name}\left({time}\right)"


class Member(sp.Function):  # type: ignore[misc]
    """``Member(name, index, argument)``: a function of a family, such as ``beta_n(u)``."""

    nargs = 3

    def _pretty(self, printer: Any) -> prettyForm:
        name, index, argument = self.args
        at = prettyForm(*printer._print(argument).parens())
        return prettyForm(*stringPict.next(printer._indexed(name.name, (index,)), at))

    def _latex(self, printer: Any, exp: str | None = None) -> str:
        name, index, argument = self.args
        head = printer._print(sp.IndexedBase(name)[index])
        return rf"{head}\left({printer._print(argument)}\right)"


def state(order: int, time: sp.Expr) -> sp.Expr:
    """Return the displacement at a time, or a derivative of it."""
    return Rate(order, time) if order else x(time)


def member(name: str, index: sp.Expr, argument: sp.Expr) -> sp.Expr:
    """Return a function of a family at an argument."""
    return Member(sp.Symbol(name), sp.sympify(index), argument)
