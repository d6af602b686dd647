"""The equations of a cell along a parameter: arrays whose entries are Chebyshev series."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from ..arrays import Integers, Matrix, Vector
from ..scenes.bodies.cell import BodyCell
from ..scenes.cell import Cell, Form
from ..scenes.mirror import mirror, same
from ..simulation.followers import vanishing
from ..simulation.machines import machine_of

#: Degrees of a series, tried in turn: nodes of one are among those of the next, the ends among
#: all.  Size of terms that are rounding, relative to the largest.
DEGREES, ROUNDING = (1, 4, 24), 1e-15

#: Least scale of a state or a memory, relative to the largest.
SMALL = 0.01

#: Coordinates at which a property is checked that is to hold on the whole interval.
SOME = -0.9173, -0.4271, 0.3183, 0.8419

#: Length of the shortest interval on which series are resolved, as a part of its values.
SHORTEST = 1e-10

#: Relative difference of equal values that were computed in different units.
EQUAL = 16 * float(np.finfo(float).eps)


#: Returns the cell and the watched forms at a value of the parameter.
Content = Callable[[float], tuple[Cell, list[Form]]]


class Along(NamedTuple):
    """The arrays of a cell as series, as `extended` takes them.

    Parameters
    ----------
    kinds, setting : ndarray
        See `scenes.arrays.Arrays`; of a body zeros, and the size of its state.
    series : ndarray, shape (entries, terms)
        Chebyshev coefficients of the other entries, and of the watched forms.
    divided : ndarray of int, shape (P,)
        By which power of its duration the event row of each phase is divided, 0 to 3; see
        `extended.divided_event`.
    weights : ndarray, shape (unknowns + 1,)
        1 over the scale of each unknown, and of ``q``.
    before : int
        The number of unknowns before the durations.
    sign : float
        1, or -1 where the next cell is the mirror image.
    independent : tuple
        Of the parameter; of a body `bodies.arrays.Known`, else empty.
    """

    kinds: Integers
    setting: Integers
    series: Any
    divided: Integers
    weights: Vector
    before: int
    sign: float
    independent: Any = ()


@dataclass(frozen=True)
class Interval:
    """An interval of a parameter, without units, with the coordinate ``q`` in [-1, 1]."""

    low: float
    high: float

    def q(self, value: float) -> float:
        """Return the coordinate of a value."""
        return (2 * value - self.low - self.high) / (self.high - self.low)

    def value(self, q: float) -> float:
        """Return the value of a coordinate; the ends are exact."""
        return ((1 - q) * self.low + (1 + q) * self.high) / 2

    def some(self) -> list[float]:
        """Return some values in it, none of them special, as ends may be."""
        return [self.value(q) for q in SOME]

    def halves_about(self, value: float) -> "Iterator[Interval]":
        """Yield it, its half about a value in it, and so on; one at least.

        An end at which the value is, but for rounding, stays an end; one that is near stays
        until the other is as near, or steps would only ever go a part of the way to it.
        """
        low, high = self.low, self.high
        shortest, rounding = SHORTEST * abs(value), EQUAL * abs(value)
        yield self
        while high - low > shortest:
            below, above = value - low, high - value
            low = (low + value) / 2 if below > max(rounding, above / 2) else low
            high = (high + value) / 2 if above > max(rounding, below / 2) else high
            yield Interval(low, high)


def resolved(
    values: Callable[[float], Vector], value: float, interval: Interval, blocks: Integers
) -> tuple[Matrix, Interval]:
    """Return Chebyshev series on an interval, or on the part about a value that they resolve.

    Parameters
    ----------
    values : callable
        What is expanded, at a value of the parameter; not finite where there is nothing.
    value : float
        About which the interval is cut where the series do not converge.
    interval : Interval
    blocks : ndarray of int
        The block to which each entry belongs: rounding is a part of the largest of a block.

    Raises
    ------
    ArithmeticError
        If no part of the interval can be resolved.

    Examples
    --------
    >>> one, unit = np.zeros(1, dtype=int), Interval(0.0, 1.0)
    >>> resolved(lambda value: np.array([value**2]), 0.5, unit, one)[0]
    array([[0.375, 0.5  , 0.125]])
    >>> resolved(lambda value: np.array([abs(value - 0.9)]), 0.5, unit, one)[1]
    Interval(low=0.25, high=0.75)
    """
    for part in interval.halves_about(value):
        series = _series(values, part, blocks)
        if series is not None:
            return series, part
    raise ArithmeticError("the equations are not smooth along the parameter")


def _series(
    values: Callable[[float], Vector], interval: Interval, blocks: Integers
) -> Matrix | None:
    """Return the Chebyshev coefficients of all entries; None where they are not resolved."""
    values = cache(values)
    for degree in DEGREES:
        nodes, table = chebyshev(degree)
        samples = np.array([values(q) for q in map(interval.value, nodes)])
        if not np.isfinite(samples).all():
            return None
        series = (table @ samples).T
        constant = (samples == samples[0]).all(axis=0)
        series[constant] = 0.0
        series[constant, 0] = samples[0, constant]
        sizes = np.abs(series).max(axis=1)
        series[np.abs(series) <= ROUNDING * sizes[:, None]] = 0.0
        sizes = of_blocks(sizes, blocks)
        if (np.abs(series[:, -2:]) <= ROUNDING * sizes[:, None]).all():
            terms = int(np.flatnonzero(series.any(axis=0)).max(initial=1)) + 1
            return np.ascontiguousarray(series[:, :terms])
    return None


def of_blocks(sizes: Vector, blocks: Integers) -> Vector:
    """Return for each entry the largest size in its block."""
    largest = np.zeros(blocks.max() + 1)
    np.maximum.at(largest, blocks, sizes)
    return largest[blocks]


def chebyshev(degree: int) -> tuple[Vector, Matrix]:
    """Return the extrema of a Chebyshev polynomial, and the matrix from values to coefficients.

    Of a multiple of the degree these are among the extrema, to the last digit.
    """
    k = np.arange(degree + 1)  # in whole numbers: the waves keep their digits
    table = np.cos(np.pi / degree * (np.outer(k, k) % (2 * degree)))
    table[[0, -1]] /= 2
    table[:, [0, -1]] /= 2
    return np.cos(np.pi * (k / degree)), 2 / degree * table


def weights(cell: Cell, z: Vector, farthest: float) -> Vector:
    """Return 1 over the scale of each unknown of a cell, and 1 for ``q``.

    `farthest` is the largest displacement, also between switches: at these all may vanish.
    """
    count, memories = len(cell.phases), len(cell.memory)
    states, memory = z[: 2 * count], z[2 * count : 2 * count + memories]
    total = float(z[2 * count + memories :][:count].sum())
    largest = max(farthest, float(np.abs(z[: 2 * count + memories]).max()))
    least = SMALL * largest if largest > ROUNDING else 1.0  # at rest at 0
    sizes = np.ones(len(z) + 1)
    sizes[0 : 2 * count : 2] = max(farthest, least)
    sizes[1 : 2 * count : 2] = max(float(np.abs(states[1::2]).max()), least)
    sizes[2 * count : 2 * count + memories] = np.maximum(np.abs(memory), least)
    sizes[2 * count + memories :][:count] = total
    return 1 / sizes


def divided_phases(cells: Sequence[Cell], durations: Vector) -> Integers:
    """Return by which power of its duration the event row of each phase is divided, 0 to 3.

    By 1 for phases that begin on the surface where they end.  If all phases of a cell do, the
    longest keeps its row: else no equation puts the orbit on the surface.  By 2 or 3 where, in
    all of some cells, so many of the event and its rates vanish as the phase begins; behind a
    rest on the surface by 3 alone, with which another row says where it is.
    """
    cell, machines = cells[0], list(map(machine_of, cells))
    returning = np.array([returns(cell, p) for p in range(len(cell.phases))], dtype=np.int64)
    divided = returning.copy()
    if divided.all():
        divided[int(np.argmax(durations[: len(divided)]))] = 0
    for p in np.flatnonzero(divided == returning).tolist():
        if changes_by_forces(cell, p) and vanishing(machines[0], p) > 1:
            least = min(vanishing(machine, p) for machine in machines)
            divided[p] = least if least > 1 else divided[p]
    return divided


def returns(cell: Cell, p: int) -> bool:
    """Whether a phase begins on the surface where it ends, without a leap of the form."""
    before, phase = cell.phases[p - 1], cell.phases[p]
    before = mirror(before) if p == 0 and cell.sign < 0 else before
    width = phase.width
    remembers = any(phase.event[width:]) or any(before.event[width:])
    leaps = remembers or before.leaps(phase.event)
    return same(before.event[:width], phase.event[:width]) and not leaps


def changes_by_forces(cell: Cell, p: int) -> bool:
    """Whether the change of an event over a phase is known where its first rates vanish.

    For one mass see `extended.divided_event`: of the displacement alone, or the velocity.
    """
    phase = cell.phases[p]
    x, v, cosine, *further = phase.event
    of_one = not (v or cosine) or not any((x, cosine, *further))
    return isinstance(cell, BodyCell) or (of_one and not phase.held)


def of_velocity(form: Form) -> bool:
    """Whether a form is of the velocity, and not of the displacement."""
    return form[0] == 0 != form[1]
