"""The record of a body in an expansion: conditions, and the tables that they look up."""

from dataclasses import dataclass

import sympy as sp

from ..condition import GalerkinConditions


@dataclass(frozen=True)
class Table:
    """What conditions look up, and what it is.

    Parameters
    ----------
    entry : Indexed or Symbol
        With its indices free.
    title : str
    sides : tuple of Expr
        What it is equal to, from its definition to its closed form.
    where : str
        The range of the indices, for the reader.
    """

    entry: sp.Expr
    title: str
    sides: tuple[sp.Expr, ...]
    where: str = ""


@dataclass(frozen=True)
class BodyConditions(GalerkinConditions):
    """The conditions of a body, each linear in the coefficients by way of its tables.

    Parameters
    ----------
    expansion : tuple of Table
        What the forces are.
    tables : tuple of Table
        In an order in which each needs those before it alone.
    """

    expansion: tuple[Table, ...] = ()
    tables: tuple[Table, ...] = ()
