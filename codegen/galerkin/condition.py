"""The records that printing reads: times, unknowns, conditions and what they look up."""

from dataclasses import dataclass

import sympy as sp

from ..scene import Scene

#: The order of the expansion; where only odd harmonics are there, their number.
N = sp.Symbol("N", integer=True, positive=True)


phi = sp.Symbol("phi", real=True)


#: How many periods of the forcing the period is: a number of the case, odd in half a period.
cycles = sp.Symbol("cycles", integer=True, positive=True)


@dataclass(frozen=True)
class Times:
    """Durations of the phases and, where something forces, the phase of the forcing.

    Parameters
    ----------
    durations : tuple of Symbol
        One for each phase of the cell.
    frequency : Expr or None
        Angular frequency of the forcing.
    sign : int
        -1 where the cell is half a period.
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
        """Return the time at which phase `p` begins; of the last, for the end of the cell."""
        return sp.Add(*self.durations[:p])

    @property
    def cell(self) -> sp.Expr:
        """The length of a cell."""
        return sp.Add(*self.durations)

    @property
    def period(self) -> sp.Expr:
        """The period."""
        return self.cell if self.sign == 1 else 2 * self.cell

    @property
    def forced_cell(self) -> sp.Expr:
        """The length of a cell as the forcing makes it, where there is one."""
        turns = sp.pi if self.sign == -1 else 2 * sp.pi
        return turns * cycles / self.frequency

    def harmonic(self, index: sp.Expr) -> sp.Expr:
        """Return the harmonic of an index: any, or odd where ``x(t + T/2) = -x(t)``."""
        return index if self.sign == 1 else 2 * index - 1

    def angle(self, time: sp.Expr) -> sp.Expr:
        """Return the angle of the forcing at a time of the cell."""
        return sp.Integer(0) if self.frequency is None else self.frequency * time + phi

    def forcing(self, time: sp.Expr) -> sp.Expr:
        """Return the forcing, of amplitude one, at a time of the cell."""
        return sp.Integer(0) if self.frequency is None else sp.cos(self.angle(time))


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

    A `ValueError` is raised if there are not as many conditions as unknowns.

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

    def __post_init__(self) -> None:
        unknowns = sum((b.count for b in self.blocks), sp.Integer(len(self.times.unknown)))
        rows = sum((c.count for c in self.conditions), sp.Integer(0))
        if sp.expand(unknowns - rows) != 0:
            raise ValueError(f"{self.method}: {rows} conditions for {unknowns} unknowns")


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
