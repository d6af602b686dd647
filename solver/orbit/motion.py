"""A periodic motion of a case, in SI units, made of the motion of each phase."""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt

from ..arrays import Matrix, Vector
from ..presentation.showing import Shown
from ..scenes.case import Case
from ..scenes.cell import Cell
from ..stability.monodromy import NoMultipliersError
from ..stability.stability import Complex, Stability, stability
from .extremes import LOOK, extremes

#: Points of a phase, at most, at which values are kept.
FEW = len(LOOK)


@dataclass(frozen=True)
class OrbitPhase:
    """One phase of an orbit, in SI units.

    Parameters
    ----------
    name : str
        Of the scene.
    duration : float
        In s.
    displacement, velocity : float
        Where it starts, in m and m/s, after the switch.
    """

    name: str
    duration: float
    displacement: float
    velocity: float


class Motion(Shown):
    """Displacement, velocity and acceleration of a periodic motion at any time, in SI units.

    A subclass says its case, and without units: durations, forcing phase, motion on a phase.
    """

    case: Case

    @property
    def about(self) -> dict[str, Any]:
        """Scene, period and parameters, for tables and files."""
        scene, turn = self.case.scene, self.forcing_phase
        found: dict[str, Any] = {"scene": scene.name, "class": f"C{scene.k}"}
        found |= {"motion": scene.motion} if scene.motion else {}
        found |= {"cycles": self.case.cycles, "period": self.period}
        found |= {} if turn is None else {"forcing_phase": turn}
        phases = " ".join(phase.name for phase in self.phases)
        return found | {"phases": phases} | dict(self.case.values)

    @property
    def facts(self) -> dict[str, str]:
        """What a notebook shows: what is solved, period, phases, stability."""
        scene, turn = self.case.scene, self.forcing_phase
        return {
            "scene": f"{scene.name}: {scene.title}",
            "parameters": self.case.description,
            "period": f"{self.period:.10g} s",
            "phases": ", ".join(f"{p.name} {p.duration:.8g} s" for p in self.phases),
            "phase of the forcing": "" if turn is None else f"{turn:.8g} rad",
        }

    @property
    def _times(self) -> str:
        """The period, and the durations of the phases of a cell or the phase of the forcing."""
        words, turn = [f"T = {self.period:.10g} s"], self.forcing_phase
        if len(self.cell_durations) > 1:
            of_cell = self.phases[: len(self._of_cell)]
            words += [f"{p.name} {p.duration:.10g} s" for p in of_cell]
        if turn is not None:
            words.append(f"phi = {turn:.10g} rad")
        return ", ".join(words)

    @property
    def _verdict(self) -> str:
        """Whether it is stable, in a word behind a comma; empty where that is not known."""
        try:
            stable = self.stable
        except NoMultipliersError:
            return ""
        return "" if stable is None else ", stable" if stable else ", unstable"

    @property
    def cell_durations(self) -> Vector:
        """Durations of the phases of the cell, without units."""
        raise NotImplementedError

    @property
    def memory_values(self) -> tuple[float, ...]:
        """What the switches of the cell set, without units, in the order of its memory."""
        return ()

    @cached_property
    def cell(self) -> Cell:
        """The equations of the cell, with numbers for what its switches set."""
        return self.case.cell.remembering(self.memory_values)

    @cached_property
    def memory(self) -> dict[str, float]:
        """What the switches of the first cell set, by name, in SI units."""
        values = zip(self.case.cell.memory, self.memory_values, strict=True)
        return {q.name: value * self.case.units.of_motion(q.power) for q, value in values}

    @property
    def angle(self) -> float:
        """Phase of the forcing at the first switch, anywhere on the circle."""
        raise NotImplementedError

    def part(self, p: int, u: Vector, derivative: int) -> Vector:
        """Return a derivative of the displacement on phase `p` of the cell, without units.

        Checks look at the same few points of a phase many times: what was found is kept.
        """
        if len(u) > FEW:
            return self._part(p, u, derivative)
        key = p, derivative, u.tobytes()
        if key not in self._parts:
            self._parts[key] = self._part(p, u, derivative)
        return self._parts[key]

    def _part(self, p: int, u: Vector, derivative: int) -> Vector:
        """Return what `part` does, computed anew."""
        raise NotImplementedError

    def signals(self, p: int, u: Vector) -> Matrix:
        """Return what linear forms are of on phase `p`, of a body; shape (S, len(u))."""
        raise NotImplementedError

    @cached_property
    def _parts(self) -> dict[tuple[int, int, bytes], Vector]:
        return {}

    @cached_property
    def durations(self) -> tuple[float, ...]:
        """Durations of the phases of one period in s, from the first switch."""
        cells = self.case.cell.cells
        return tuple(float(s * self.case.units.time) for s in self.cell_durations) * cells

    @property
    def period(self) -> float:
        """Period in s."""
        return math.fsum(self.durations)

    @property
    def forcing_phase(self) -> float | None:
        """Phase of the forcing at ``t = 0``, in [0, 2 pi); None where nothing forces."""
        if not self.case.cell.forced:
            return None
        turn = self.angle % (2 * math.pi)
        return turn if turn < 2 * math.pi else 0.0  # of a tiny negative number

    @cached_property
    def phases(self) -> tuple[OrbitPhase, ...]:
        """The phases of one period, from the first switch."""
        cell, units, start = self.case.cell, self.case.units, np.zeros(1)
        states = [[float(self.part(p, start, j)[0]) for j in (0, 1)] for p in self._of_cell]
        return tuple(
            OrbitPhase(
                name=cell.phases[p].name,
                duration=self.durations[index],
                displacement=self._sign(index) * states[p][0] * units.length,
                velocity=self._sign(index) * states[p][1] * units.of_motion(1),
            )
            for index, p in enumerate([*self._of_cell] * cell.cells)
        )

    @cached_property
    def sizes(self) -> Matrix:
        """Sizes of x, x', the cosine of the forcing and 1 on each phase, without units.

        Of a body those of all `signals`.

        The largest of 65 values on each, enough for a scale.
        """
        cell, durations = self.case.cell, self.cell_durations
        if self.case.scene.has_body:
            return np.array([np.abs(self.signals(p, LOOK)).max(axis=1) for p in self._of_cell])
        found = np.ones((len(cell.phases), 4))
        for p, s in enumerate(durations):
            angle = self.angle + cell.omega * float(np.sum(durations[:p]))
            cosine = np.cos(angle + cell.omega * s * LOOK)
            rows = (self.part(p, LOOK, 0), self.part(p, LOOK, 1), cosine)
            found[p, :3] = [np.abs(row).max() for row in rows]
        return found

    @property
    def _of_cell(self) -> range:
        return range(len(self.case.cell.phases))

    def _sign(self, index: int) -> int:
        return self.case.cell.sign if index >= len(self.case.cell.phases) else 1

    @cached_property
    def _switches(self) -> Vector:
        """Times at which the phases of a period start, and its end, in s."""
        ends = [math.fsum(self.durations[:p]) for p in range(len(self.durations) + 1)]
        return np.array(ends)

    def displacement(self, t: npt.ArrayLike) -> Vector:
        """Return ``x(t)`` in m.

        Parameters
        ----------
        t : array_like of float, any shape
            Times in s; the first phase starts at 0, and the motion repeats with `period`.

        Raises
        ------
        ValueError
            If a time is infinite or not a number.
        """
        return self._at(t, 0)

    def velocity(self, t: npt.ArrayLike) -> Vector:
        """Return the velocity in m/s at times `t`; at a switch, that after it."""
        return self._at(t, 1)

    def acceleration(self, t: npt.ArrayLike) -> Vector:
        """Return the acceleration in m/s**2 at times `t`; at a switch, that after it."""
        return self._at(t, 2)

    def _at(self, t: npt.ArrayLike, derivative: int) -> Vector:
        times = np.asarray(t if np.isrealobj(t) else np.nan, dtype=float)
        if not np.isfinite(times).all():
            raise ValueError(f"t: got {t!r}, expected finite times in s")
        within = np.mod(times.ravel(), self._switches[-1])
        within[within >= self._switches[-1]] = 0.0  # of a tiny negative number
        which = np.searchsorted(self._switches, within, side="right") - 1
        values = np.empty(len(within))
        for index in np.unique(which):
            here = which == index
            u = (within[here] - self._switches[index]) / self.durations[index]
            p = int(index) % len(self.case.cell.phases)
            values[here] = self._sign(index) * self.part(p, np.clip(u, 0.0, 1.0), derivative)
        values *= self.case.units.of_motion(derivative)
        return values.reshape(times.shape)

    @cached_property
    def extremes(self) -> dict[str, tuple[float, float]]:
        """Least and largest displacement in m, and velocity in m/s, over a period."""
        return {
            name: extremes(self, derivative)
            for derivative, name in enumerate(("displacement", "velocity"))
        }

    @cached_property
    def stability(self) -> Stability:
        """What a period makes of small perturbations, with the rounding of that.

        Raises
        ------
        NoMultipliersError
            If an event is touched and not crossed, or a check of the computation failed.
        """
        return stability(self)

    @property
    def multipliers(self) -> Complex:
        """The Floquet multipliers of a whole period, the largest first; see `stability`.

        Without forcing, that of a shift in time is left out: it is `trivial_multiplier`.
        """
        return self.stability.multipliers

    @property
    def trivial_multiplier(self) -> float | None:
        """The multiplier of a shift in time, 1 but for errors; None where something forces."""
        return self.stability.trivial_multiplier

    @property
    def stable(self) -> bool | None:
        """Whether small perturbations die out; None where that cannot be told."""
        return self.stability.stable

    @property
    def margin(self) -> float:
        """1 less the largest modulus of the multipliers: positive if the orbit is stable."""
        return self.stability.margin
