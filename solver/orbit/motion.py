"""A periodic motion of a case, in SI units, made of the motion of each phase."""

import math
from contextlib import suppress
from dataclasses import dataclass, fields
from functools import cached_property, partial
from typing import Any

import numpy as np
import numpy.typing as npt

from ..arrays import Complex, Matrix, Vector, real_numbers
from ..iteration.newton import Outcome
from ..kernels.kernel import Kernel
from ..scenes.case import Case
from ..scenes.cell import Cell
from ..scenes.ordered import names_of_period
from ..stability.monodromy import NoMultipliersError
from ..stability.stability import Stability, stability
from . import chebyshev
from .transients import cuts

#: Local times at which the size of a motion is sampled.  Values at this many points or fewer
#: are cached.
LOOK = np.linspace(0.0, 1.0, 65)


@dataclass(frozen=True)
class OrbitPhase:
    """One phase of an orbit, in SI units.

    Parameters
    ----------
    name : str
        Its name in the scene.
    duration : float
        In s.
    displacement, velocity : float
        Where it starts, in m and m/s, after the switch.
    """

    name: str
    duration: float
    displacement: float
    velocity: float


class Motion:
    """A periodic motion of a case, evaluated at any time in SI units.

    A subclass is a dataclass with the equations that it solves, as `_kernel`.
    """

    case: Case
    outcome: Outcome

    @cached_property
    def _kernel(self) -> Kernel:
        """Kernel of the equations that the motion solves."""
        raise NotImplementedError

    @cached_property
    def _given(self) -> Any:
        """First argument of the kernel's functions."""
        return self.case.cell

    @property
    def _identity(self) -> tuple[object, ...]:
        """Key by which motions are compared: all fields but how Newton's method went."""
        how = (name for name in self.__getstate__() if name not in ("outcome", "iterations"))
        return (*(getattr(self, name) for name in how), self.outcome.unknowns.tobytes())

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self._identity == other._identity

    def __hash__(self) -> int:
        return hash(self._identity)

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields of the dataclass, without cached properties, for pickle."""
        return {field.name: getattr(self, field.name) for field in fields(self)}  # type: ignore[arg-type]

    @property
    def times(self) -> Vector:
        """Durations of the cell and, if forced, the phase of the forcing; without units."""
        return self._kernel.times(self.outcome.unknowns)

    @property
    def cell_durations(self) -> Vector:
        """Durations of the phases of the cell, without units."""
        return self._kernel.split(self.outcome.unknowns)[0]

    @property
    def memory_values(self) -> tuple[float, ...]:
        """Values of the memory, set by switches of the cell, without units, in its order."""
        by_name = self._kernel.coefficients(self.outcome.unknowns)
        return tuple(float(by_name[memory.name][0]) for memory in self.case.cell.memory)

    @cached_property
    def cell(self) -> Cell:
        """The equations of the cell, with the values of its memory put in."""
        return self.case.cell.remembering(self.memory_values)

    @cached_property
    def memory(self) -> dict[str, float]:
        """Values of the memory in the first cell, by name, in SI units."""
        values = zip(self.case.cell.memory, self.memory_values, strict=True)
        return {q.name: value * self.case.units.of_motion(q.power) for q, value in values}

    @property
    def angle(self) -> float:
        """Phase of the forcing at the first switch in rad, not reduced to one turn."""
        return self._kernel.split(self.outcome.unknowns)[1]

    def part(self, p: int, u: Vector, derivative: int) -> Vector:
        """Return a derivative of the displacement at local times of phase `p`, without units.

        Values at few points are cached: checks look at the same ones many times.
        """
        if len(u) > len(LOOK):
            return self._part(p, u, derivative)
        key = p, derivative, u.tobytes()
        if key not in self._parts:
            self._parts[key] = self._part(p, u, derivative)
        return self._parts[key]

    def _part(self, p: int, u: Vector, derivative: int) -> Vector:
        """Return the same as `part`, without the cache."""
        values = self._kernel.motion(self._given, self.outcome.unknowns, p, u, derivative)
        return np.broadcast_to(np.asarray(values, dtype=float), np.shape(u))

    def angle_at(self, p: int, u: Vector) -> Vector:
        """Return the phase of the forcing at local times of phase `p` of the cell."""
        durations, omega = self.cell_durations, self.case.cell.omega
        begin = self.angle + omega * float(np.sum(durations[:p]))
        return np.asarray(begin + omega * durations[p] * u)

    def signals(self, p: int, u: Vector) -> Matrix:
        """Return the quantities of which forms are linear combinations; shape (S, len(u)).

        At local times of phase `p`, without units: of one mass x, x', the cosine of the forcing
        and 1; of a body those of `BodyPhase`.
        """
        if self.case.scene.has_body:
            assert self._kernel.signals is not None
            return self._kernel.signals(self._given, self.outcome.unknowns, p, u)
        x, v = (self.part(p, u, j) for j in (0, 1))
        return np.array([x, v, np.cos(self.angle_at(p, u)), np.ones(len(u))])

    @cached_property
    def _parts(self) -> dict[tuple[int, int, bytes], Vector]:
        """Cache of `part`."""
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
        names = names_of_period(self.case)
        states = [[float(self.part(p, start, j)[0]) for j in (0, 1)] for p in self._of_cell]
        return tuple(
            OrbitPhase(
                name=names[index],
                duration=self.durations[index],
                displacement=self._sign(index) * states[p][0] * units.length,
                velocity=self._sign(index) * states[p][1] * units.of_motion(1),
            )
            for index, p in enumerate([*self._of_cell] * cell.cells)
        )

    @cached_property
    def sizes(self) -> Matrix:
        """Sizes of all `signals` on each phase; shape (P, S).

        The largest of 65 samples, and no less than `_least_sizes`.
        """
        largest = ((p, np.abs(self.signals(p, LOOK)).max(axis=1)) for p in self._of_cell)
        return np.array([np.maximum(sizes, self._least_sizes(p)) for p, sizes in largest])

    def _least_sizes(self, p: int) -> Vector | float:
        """Return sizes below which `signals` on phase `p` are mostly rounding."""
        return 0.0

    @property
    def _of_cell(self) -> range:
        """Indices of the phases of the cell."""
        return range(len(self.case.cell.phases))

    def _sign(self, index: int) -> int:
        """Return the sign of the cell that has phase `index` of the period."""
        return self.case.cell.sign if index >= len(self.case.cell.phases) else 1

    @cached_property
    def _switches(self) -> Vector:
        """Times of the switches of a period, from 0 to its end, in s."""
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
        """Return a derivative of the displacement at times in s, in SI units."""
        times = real_numbers(t)
        if not np.isfinite(times).all():
            raise ValueError(f"t: got {t!r:.80}, expected finite times in s")
        within = np.mod(times.ravel(), self._switches[-1])
        within[within >= self._switches[-1]] = 0.0  # of a tiny negative number
        which = np.searchsorted(self._switches, within, side="right") - 1
        values = np.empty(len(within))
        for index in np.unique(which):
            in_phase = which == index
            u = (within[in_phase] - self._switches[index]) / self.durations[index]
            p = int(index) % len(self.case.cell.phases)
            part = self.part(p, np.clip(u, 0.0, 1.0), derivative)
            values[in_phase] = self._sign(index) * part
        values *= self.case.units.of_motion(derivative)
        return values.reshape(times.shape)

    @cached_property
    def extremes(self) -> dict[str, tuple[float, float]]:
        """Least and largest displacement in m, and velocity in m/s, over a period."""
        return {name: self._range(j) for j, name in enumerate(("displacement", "velocity"))}

    def _range(self, derivative: int) -> tuple[float, float]:
        """Return the least and the largest value of a derivative, from its critical points."""
        parts = [partial(self.part, p, derivative=derivative) for p in self._of_cell]
        size = max(float(np.abs(part(LOOK)).max()) for part in parts)
        ranges = [chebyshev.extremes(q, size, cuts(self, p)) for p, q in enumerate(parts)]
        low, high = np.transpose(ranges)
        least, largest = float(low.min()), float(high.max())
        if self.case.cell.sign < 0:
            least, largest = min(least, -largest), max(largest, -least)
        unit = self.case.units.of_motion(derivative)
        return least * unit, largest * unit

    @cached_property
    def stability(self) -> Stability:
        """The Floquet multipliers of the orbit, with bounds of their rounding errors.

        Raises
        ------
        NoMultipliersError
            If an event is touched and not crossed, or a check of the computation failed.
        """
        return stability(self)

    @property
    def multipliers(self) -> Complex:
        """The Floquet multipliers of a whole period, the largest first; see `stability`.

        Without forcing, `trivial_multiplier` is left out.
        """
        return self.stability.multipliers

    @property
    def trivial_multiplier(self) -> float | None:
        """The multiplier of a shift in time, 1 up to errors; None of a forced motion."""
        return self.stability.trivial_multiplier

    @property
    def stable(self) -> bool | None:
        """Whether small perturbations decay; None if undecided, or without multipliers."""
        with suppress(NoMultipliersError):
            return self.stability.stable
        return None

    @property
    def margin(self) -> float:
        """1 less the largest modulus of the multipliers: positive if the orbit is stable."""
        return self.stability.margin
