"""The record that emission and printing read: unknowns, conditions, tables."""

from dataclasses import dataclass

import sympy as sp

from ..scene import Scene
from .tables import Table
from .times import Times, cycles

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
        How many there are, in `N`; indices run from `first`.
    power : int
        Its unit is a length over a time to this power.
    what : str
        What it is, in a few words.
    first : int
        The lowest index.
    """

    symbol: sp.Expr
    count: sp.Expr
    power: int
    what: str
    first: int = 0

    @property
    def name(self) -> str:
        """Its name in a kernel."""
        return str(self.symbol)


@dataclass(frozen=True)
class Condition:
    """Rows of the system: one, or one for each value of an index.

    Parameters
    ----------
    name : str
        Of the function of the kernel.
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
    where : str
        The range of the index, for the reader.
    """

    name: str
    title: str
    expression: sp.Expr
    index: sp.Symbol | None = None
    first: sp.Expr = sp.S.Zero
    count: sp.Expr = sp.S.One
    number: str = ""
    where: str = ""


@dataclass(frozen=True)
class GalerkinConditions:
    """A scene in one expansion: unknowns in the order of the kernel, and conditions.

    Parameters
    ----------
    scene : Scene
    method : str
        Of the expansion, such as ``"ck-tau"``.
    title : str
        What the expansion is, for the heading.
    blocks : tuple of Block
        The coefficients, in their order; the times follow.
    times : Times
        The unknown times.
    conditions : tuple of Condition
    tables : tuple of Table
        What the conditions look up.
    lowest : int
        The smallest order at which there are as many conditions as unknowns and none is void.
    break_series : tuple of tuple of Expr
        The Legendre coefficients of functions with a break, if the expansion has them.
    function_series : tuple of tuple of tuple of Expr
        Of one function of the whole cell, if the expansion has it: on each phase the Legendre
        coefficients of ``T**3 G'''``, ``T**2 G''``, ``T G'``, ``G``.
    odd_harmonics : bool
        Whether only odd harmonics are there.  The order, which users give, is the highest
        harmonic; then `N` is ``(order + 1)//2``, and the order itself otherwise.
    """

    scene: Scene
    method: str
    title: str
    blocks: tuple[Block, ...]
    times: Times
    conditions: tuple[Condition, ...]
    tables: tuple[Table, ...]
    lowest: int
    break_series: tuple[tuple[sp.Expr, ...], ...] = ()
    function_series: tuple[tuple[tuple[sp.Expr, ...], ...], ...] = ()
    odd_harmonics: bool = False

    @property
    def parameters(self) -> tuple[sp.Symbol, ...]:
        """What makes a case: the parameters of the scene and, if it is forced, the cycles."""
        forced = self.times.frequency is not None
        return (*self.scene.symbols, cycles) if forced else self.scene.symbols

    def check_count(self) -> None:
        """Check that there are as many conditions as unknowns.

        Raises
        ------
        ValueError
            If not.
        """
        unknowns = sum((b.count for b in self.blocks), sp.Integer(len(self.times.unknown)))
        rows = sum((c.count for c in self.conditions), sp.Integer(0))
        if sp.expand(unknowns - rows) != 0:
            raise ValueError(f"{self.method}: {rows} conditions for {unknowns} unknowns")
