"""The record that printing reads: unknowns and conditions."""

from dataclasses import dataclass

import sympy as sp

from ..scene import Scene
from .times import Times

#: The order of the expansion; where only odd harmonics are there, their number.
N = sp.Symbol("N", integer=True, positive=True)


@dataclass(frozen=True)
class Block:
    """Unknown coefficients that stand together.

    Parameters
    ----------
    symbol : Symbol or IndexedBase
        One unknown, or a family with an index.
    count : Expr
        How many there are, in `N`.
    what : str
        What it is, in a few words.
    """

    symbol: sp.Expr
    count: sp.Expr
    what: str

    @property
    def name(self) -> str:
        """What it is called."""
        return str(self.symbol)


@dataclass(frozen=True)
class Condition:
    """Rows of the system: one, or one for each value of an index.

    Parameters
    ----------
    name : str
        What printing knows it by.
    title : str
        What it says.
    expression : Expr
        Zero; linear in the coefficients.  Sums over an index of a family stand as `Sum`.
    index : Symbol, optional
        Running from `first`.
    first, count : Expr
        First value of the index, and number of rows, in `N`.
    number : str
        Number in the paper.
    """

    name: str
    title: str
    expression: sp.Expr
    index: sp.Symbol | None = None
    first: sp.Expr = sp.S.Zero
    count: sp.Expr = sp.S.One
    number: str = ""

    @property
    def where(self) -> str:
        """The range of the index, for the reader."""
        if self.index is None:
            return ""
        return f"{self.index} = {self.first}, ..., {self.first + self.count - 1}"


@dataclass(frozen=True)
class GalerkinConditions:
    """A scene in one expansion: unknowns and conditions, in the order of the kernel.

    Parameters
    ----------
    scene : Scene
    method : str
        Of the expansion, such as ``"ck-tau"``; behind a comma, how many functions it has.
    title : str
        What the expansion is, for the heading.
    blocks : tuple of Block
        The coefficients, in their order; the times follow.
    times : Times
        The unknown times.
    conditions : tuple of Condition
    """

    scene: Scene
    method: str
    title: str
    blocks: tuple[Block, ...]
    times: Times
    conditions: tuple[Condition, ...]

    def check_count(self) -> None:
        """Check that there are as many conditions as unknowns; a `ValueError` if not."""
        unknowns = sum((b.count for b in self.blocks), sp.Integer(len(self.times.unknown)))
        rows = sum((c.count for c in self.conditions), sp.Integer(0))
        if sp.expand(unknowns - rows) != 0:
            raise ValueError(f"{self.method}: {rows} conditions for {unknowns} unknowns")
