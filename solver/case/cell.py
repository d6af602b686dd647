"""The equations of one cell, in dimensionless numbers: what every other module reads."""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .numbers import SceneNumbers

#: A linear form in the state: factors of x, x', of the cosine of the forcing, and a constant.
Form = tuple[float, float, float, float]


@dataclass(frozen=True)
class Phase:
    """One phase: ``m x'' + c x' + k x = f + g cos(Omega t + phi)``, or ``x' = speed``.

    Parameters
    ----------
    name : str
        Of the scene.
    m, c, k, f, g : float
        Of the equation of motion.
    held : bool
        Whether a constraint holds the velocity, at `speed`.
    event : Form
        Vanishes at the end of the phase, where the velocity is that before the switch.
    rho, d : float
        Velocity after the switch at its end: ``rho x' + d``.
    demands : tuple of (str, Form)
        What must not be negative in the phase, with its words.
    """

    name: str
    m: float
    c: float
    k: float
    f: float
    g: float
    held: bool
    speed: float
    event: Form
    rho: float
    d: float
    demands: tuple[tuple[str, Form], ...]


@dataclass(frozen=True)
class Cell:
    """A period, or half of one of which the other half is the mirror image.

    Parameters
    ----------
    phases : tuple of Phase
        In order.
    frequency : float or None
        Angular frequency of the forcing.
    sign : {1, -1}
        What the next cell is multiplied by: -1 where ``x(t + T/2) = -x(t)``.
    k : int
        Class of the motion.
    """

    phases: tuple[Phase, ...]
    frequency: float | None
    sign: int
    k: int
    guess: tuple[float, ...]

    @property
    def forced(self) -> bool:
        """Whether the phase of a forcing is unknown, and the duration of the cell known."""
        return self.frequency is not None

    @property
    def cells(self) -> int:
        """Cells in a period."""
        return 1 if self.sign > 0 else 2

    @property
    def omega(self) -> float:
        """Angular frequency of the forcing; 0 if there is none."""
        return 0.0 if self.frequency is None else self.frequency

    @property
    def duration(self) -> float:
        """Duration of the cell, if the forcing makes it known."""
        if self.frequency is None:
            raise ValueError("the duration of a cell without forcing is unknown")
        return 2 * math.pi / self.frequency / self.cells


def cell_of(scene: "SceneNumbers", numbers: tuple[float, ...]) -> Cell:
    """Return the cell of a scene for dimensionless parameters."""
    module = scene.module
    rows = zip(
        module.PHASES,
        scene.numbers("coefficients", numbers),
        scene.numbers("held", numbers),
        scene.numbers("events", numbers),
        scene.numbers("jumps", numbers),
        module.DEMANDS,
        scene.numbers("demands", numbers),
        strict=True,
    )
    phases = tuple(
        Phase(
            name,
            **dict(zip("mckfg", map(float, equation), strict=True)),
            held=held,
            speed=float(speed),
            event=_form(event),
            rho=float(jump[0]),
            d=float(jump[1]),
            demands=tuple(zip(words, map(_form, demands), strict=True)),
        )
        for (name, held), equation, speed, event, jump, words, demands in rows
    )
    names = [parameter.name for parameter in scene.parameters]
    frequency = None if scene.frequency is None else numbers[names.index(scene.frequency)]
    guess = tuple(map(float, scene.numbers("guess", numbers)))
    return Cell(phases, frequency, -1 if module.HALF_PERIOD else 1, scene.k, guess)


def _form(row: tuple[float, ...]) -> Form:
    x, v, cos, constant = map(float, row)
    return x, v, cos, constant
