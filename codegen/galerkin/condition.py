"""Records of the conditions for printing: times, unknowns and conditions."""

from dataclasses import dataclass

import sympy as sp

from ..scene import Scene
from ..system import Equation

#: The order of the expansion; with odd harmonics only, their number.
N = sp.Symbol("N", integer=True, positive=True)

#: The phase of the forcing at the first switch.
phi = sp.Symbol("phi", real=True)

#: Number of periods of the forcing in the period, given by the case; odd if a cell is half one.
cycles = sp.Symbol("cycles", integer=True, positive=True)


@dataclass(frozen=True)
class Times:
    """The unknown times: durations of the phases and, with forcing, its phase.

    Parameters
    ----------
    durations : tuple of Symbol
        One for each phase of the cell.
    frequency : Expr or None
        Angular frequency of the forcing.
    sign : int
        -1 if the cell is half a period, else 1.
    """

    durations: tuple[sp.Symbol, ...]
    frequency: sp.Expr | None
    sign: int

    @classmethod
    def of(cls, scene: Scene) -> "Times":
        """Return the times of a scene, named after its phases."""
        durations = (sp.Symbol(f"s_{phase.name}", positive=True) for phase in scene.phases)
        return cls(tuple(durations), scene.frequency, scene.sign)

    @property
    def unknown(self) -> tuple[sp.Symbol, ...]:
        """All unknown times, in the order of the kernel."""
        return self.durations if self.frequency is None else (*self.durations, phi)

    def start(self, p: int) -> sp.Expr:
        """Return the time at which phase `p` begins; for ``p = P`` the end of the cell."""
        return sp.Add(*self.durations[:p])

    @property
    def cell(self) -> sp.Expr:
        """The duration of a cell."""
        return sp.Add(*self.durations)

    @property
    def period(self) -> sp.Expr:
        """The period."""
        return self.cell if self.sign == 1 else 2 * self.cell

    @property
    def forced_cell(self) -> sp.Expr:
        """The duration of a forced cell by the frequency of the forcing."""
        turn = sp.pi if self.sign == -1 else 2 * sp.pi
        return turn * cycles / self.frequency

    def harmonic(self, index: sp.Expr) -> sp.Expr:
        """Return the number of a harmonic by its index: odd if ``x(t + T/2) = -x(t)``."""
        return index if self.sign == 1 else 2 * index - 1

    def angle(self, time: sp.Expr) -> sp.Expr:
        """Return the angle of the forcing at a time of the cell."""
        return sp.Integer(0) if self.frequency is None else self.frequency * time + phi

    def forcing(self, time: sp.Expr) -> sp.Expr:
        """Return the forcing, of amplitude one, at a time of the cell."""
        return sp.Integer(0) if self.frequency is None else sp.cos(self.angle(time))


@dataclass(frozen=True)
class Block:
    """A block of unknown coefficients.

    Parameters
    ----------
    symbol : Symbol or IndexedBase
        One unknown, or a family with an index.
    count : Expr
        Number of unknowns, as an expression in `N`.
    what : str
        Their meaning in a few words.
    """

    symbol: sp.Expr
    count: sp.Expr
    what: str

    @property
    def name(self) -> str:
        """Name of the symbol."""
        return str(self.symbol)


@dataclass(frozen=True)
class Condition:
    """A condition ``expression = 0``: one row, or one for each value of an index.

    Parameters
    ----------
    name : str
        Key of the condition in printing.
    title : str
        Its meaning in words.
    expression : Expr
        Linear in the coefficients; sums over an index of a family are unevaluated `Sum`.
    index : Symbol, optional
        Index of the rows, from `first` on.
    first, count : Expr
        First value of the index, and number of rows, as expressions in `N`.
    number : str
        Equation number in the paper.
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
        """The range of the index in words; empty without one."""
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
        Name of the expansion, such as ``"ck-tau"``; after a comma, its number of functions.
    title : str
        The expansion in words, for the heading.
    blocks : tuple of Block
        The coefficients in order; the times follow.
    times : Times
        The unknown times.
    conditions : tuple of Condition

    Raises
    ------
    ValueError
        If the numbers of conditions and unknowns differ.
    """

    scene: Scene
    method: str
    title: str
    blocks: tuple[Block, ...]
    times: Times
    conditions: tuple[Condition, ...]

    def __post_init__(self) -> None:
        unknowns = sum((b.count for b in self.blocks), sp.Integer(len(self.times.unknown)))
        rows = sum((c.count for c in self.conditions), sp.Integer(0))
        if sp.expand(unknowns - rows) != 0:
            raise ValueError(f"{self.method}: {rows} conditions for {unknowns} unknowns")


@dataclass(frozen=True)
class BodyConditions(GalerkinConditions):
    """The conditions of a body, each linear in the coefficients and in entries of tables.

    Parameters
    ----------
    expansion : tuple of Equation
        The expansions of the forces.
    tables : tuple of Equation
        The quantities that conditions use: with free indices, then the expressions equal to
        it, from the definition to the closed form.  Each depends only on earlier ones.
    """

    expansion: tuple[Equation, ...] = ()
    tables: tuple[Equation, ...] = ()
