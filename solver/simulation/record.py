"""A simulated motion in SI units: its phases, and the motion at any time within it."""

import math
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt

from ...nearest import counted
from ..arrays import Vector, real_numbers
from ..presentation.documents import SCHEMA
from ..presentation.notebook import of_rows
from ..presentation.table import COURSE, Table, Tabular
from ..scenes.case import Case
from .segment import Segment

#: Index of the force among the quantities of a motion, after x and its two derivatives.
FORCE = 3

#: Rounding by which a time may lie outside of a motion, relative to its duration.
ROUNDING = 16 * float(np.finfo(float).eps)


@dataclass(frozen=True)
class SimulatedPhase:
    """One phase of a simulated motion, in SI units.

    Parameters
    ----------
    name, mirrored : str, bool
        Name of the phase in the scene, and whether this is its mirror image.
    start, duration : float
        In s.
    displacement, velocity : float
        At the start, in m and m/s, after the switch.
    forcing_phase : float or None
        Phase of the forcing at the start, in rad, to its own rounding however late that is;
        None where nothing forces.
    """

    name: str
    mirrored: bool
    start: float
    duration: float
    displacement: float
    velocity: float
    forcing_phase: float | None = None


@dataclass(frozen=True, repr=False)
class Simulation(Tabular):
    """A motion of a case from a given state.

    Parameters
    ----------
    case : Case
        The oscillator.
    segments : tuple of Segment
        Its phases without units.
    ended : str
        Why it ended before the time asked for; empty if it did not.
    """

    case: Case
    segments: tuple[Segment, ...]
    ended: str = ""

    @cached_property
    def phases(self) -> tuple[SimulatedPhase, ...]:
        """The phases, in order, in SI units."""
        units, forced = self.case.units, self.case.cell.forced
        return tuple(
            SimulatedPhase(
                q.phase.name, q.mirrored, float(q.t) * units.time, q.s * units.time,
                q.x * units.length, q.v * units.of_motion(1), q.angle if forced else None,
            )
            for q in self.segments
        )  # fmt: skip

    @property
    def time(self) -> float:
        """Duration of the motion, in s."""
        last = self.segments[-1]
        return float(last.t + Fraction(last.s)) * self.case.units.time

    @property
    def forcing_phase(self) -> float | None:
        """Phase of the forcing at the start, in rad; None where nothing forces."""
        return self.segments[0].angle if self.case.cell.forced else None

    def displacement(self, t: npt.ArrayLike) -> Vector:
        """Return ``x(t)`` in m.

        Parameters
        ----------
        t : array_like of float, any shape
            Times in s, from 0 to `time`; beyond either end by rounding counts as the end.

        Raises
        ------
        ValueError
            If a time is outside of the motion, or not a number.
        """
        return self._at(t, 0)

    def velocity(self, t: npt.ArrayLike) -> Vector:
        """Return the velocity in m/s at times `t`; at a switch, that after it."""
        return self._at(t, 1)

    def acceleration(self, t: npt.ArrayLike) -> Vector:
        """Return the acceleration in m/s**2 at times `t`; at a switch, that after it."""
        return self._at(t, 2)

    def force(self, t: npt.ArrayLike) -> Vector:
        """Return the force of the first contact of a body in N at times `t`.

        At a switch, that after it; impulses do not count as forces.

        Raises
        ------
        ValueError
            If a time is outside of the motion, or the motion is that of one mass.
        """
        return self._at(t, FORCE)

    @property
    def quantities(self) -> tuple[str, ...]:
        """Names of the quantities that the motion has at any time."""
        names = ("displacement", "velocity", "acceleration")
        return (*names, "force") if self.case.scene.has_body else names

    def _of(self, q: Segment, s: Vector, number: int) -> Vector:
        """Return one of the `quantities` in a phase at local times, in SI units."""
        units = self.case.units
        if number == FORCE:
            return q.force(s) * (units.mass * units.of_motion(2))
        return q.motion(s, self.case.cell.omega, number) * units.of_motion(number)

    def _at(self, t: npt.ArrayLike, number: int) -> Vector:
        times = real_numbers(t)
        slack = ROUNDING * self.time
        if not ((times >= -slack) & (times <= self.time + slack)).all():
            raise ValueError(f"t: got {t!r:.80}, expected times from 0 to {self.time:.6g} s")
        local = times.clip(0.0, self.time).ravel() / self.case.units.time
        starts = np.array([float(q.t) for q in self.segments])
        indices = np.searchsorted(starts, local, side="right") - 1
        values = np.empty(len(local))
        for index in np.unique(indices):
            q, chosen = self.segments[index], indices == index
            s = np.clip(local[chosen] - starts[index], 0.0, q.s)
            values[chosen] = self._of(q, s, number)
        return values.reshape(times.shape)

    def samples(self, points: float = 100) -> list[tuple[Vector, ...]]:
        """Return times and the `quantities` of each phase, in SI units.

        Parameters
        ----------
        points : float
            About how many for each shortest period of the motion.  The start and the end of a
            phase are always among them; the values at an end are those before the switch.
        """
        cell, unit, samples = self.case.cell, self.case.units.time, []
        for q in self.segments:
            s = q.s * np.linspace(0.0, 1.0, 3 + math.ceil(points * q.s / q.wave(cell.omega)))
            values = (self._of(q, s, number) for number in range(len(self.quantities)))
            samples.append(((float(q.t) + s) * unit, *values))
        return samples

    def as_dict(self) -> dict[str, Any]:
        """Return the motion as the document that ``simulate --json`` writes."""
        return {
            "schema": SCHEMA,
            "scene": self.case.scene.name,
            "parameters": dict(self.case.values),
            "forcing_phase": self.forcing_phase,
            "time": self.time,
            "ended": self.ended or None,
            "phases": [
                {
                    "name": q.name,
                    "mirrored": q.mirrored,
                    "time": q.start,
                    "duration": q.duration,
                    "forcing_phase": q.forcing_phase,
                    "start": {"displacement": q.displacement, "velocity": q.velocity},
                }
                for q in self.phases
            ],
        }

    def plot(
        self, ax: Any = None, quantity: str = "displacement", *, since: float = 0, **style: Any
    ) -> Any:
        """Draw the motion and return the axes; needs matplotlib, the extra ``plot``.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Axes to draw in; new ones by default.
        quantity : {"displacement", "velocity", "acceleration", "force", "plane"}
            What is drawn against time (the force: only of a body); or the phase plane.
        since : float
            First time that is drawn, in s.
        **style
            Of the line, as `matplotlib.axes.Axes.plot` takes it.

        Raises
        ------
        ValueError
            If `quantity` is none of these.
        MissingExtra
            An `ImportError`: if matplotlib is not installed.
        """
        from ...plots.simulations import draw  # noqa: PLC0415  (an extra)

        return draw(self, ax, quantity, since=since, **style)

    def table(self) -> Table:
        """Return the motion sampled in each phase from start to end, with the phase's number.

        At a switch there are two rows: before it, and after it.
        """
        samples = self.samples()
        arrays = map(np.concatenate, zip(*samples, strict=True))
        columns = dict(zip(("t", *self.quantities), arrays, strict=True))
        columns["phase"] = np.repeat(np.arange(len(samples)), [len(q[0]) for q in samples])
        about = {"scene": self.case.scene.name, "time": self.time, "ended": self.ended}
        return Table(("t",), columns, COURSE | {"force": "N"}, about | dict(self.case.values))

    def __repr__(self) -> str:
        count = counted(len(self.segments), "phase")
        words = f"; ended: {self.ended}" if self.ended else ""
        name = self.case.scene.name
        return f"<{name} simulated for {self.time:.6g} s: {count}{words}>"

    def _repr_html_(self) -> str:
        return of_rows(repr(self), "", self.plot)
