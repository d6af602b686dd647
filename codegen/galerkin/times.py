"""The unknown times of a scene: durations of its phases, and the phase of the forcing."""

from dataclasses import dataclass

import sympy as sp

from ..scene import Scene

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

    def angle(self, time: sp.Expr) -> sp.Expr:
        """Return the angle of the forcing at a time of the cell."""
        return sp.Integer(0) if self.frequency is None else self.frequency * time + phi

    def forcing(self, time: sp.Expr) -> sp.Expr:
        """Return the forcing, of amplitude one, at a time of the cell."""
        return sp.Integer(0) if self.frequency is None else sp.cos(self.angle(time))
