"""The equations of a cell along a parameter: arrays whose entries are Chebyshev series."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ..arrays import Integers, Matrix, Vector
from ..scenes.cell import Cell, Form, Phase
from ..scenes.mirror import mirror, same

#: Terms of a series; size of terms that are rounding, relative to the largest.
TERMS, ROUNDING = 24, 1e-15

#: Least scale of a state or a memory, relative to the largest.
SMALL = 0.01

#: Coordinates at which a property is checked that is to hold on the whole interval.
SOME = -1.0, -0.4271, 0.3183, 1.0

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
    series : ndarray, shape (entries, TERMS)
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
        """Return its ends and some values between, none of them special."""
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
    if not np.isfinite([values(interval.low), values(interval.high)]).all():
        return None
    nodes, table = chebyshev(TERMS)
    samples = np.array([values(q) for q in map(interval.value, nodes)])
    series = (table @ samples).T
    constant = (samples == samples[0]).all(axis=0)
    series[constant] = 0.0
    series[constant, 0] = samples[0, constant]
    sizes = np.abs(series).max(axis=1)
    series[np.abs(series) <= ROUNDING * sizes[:, None]] = 0.0
    sizes = of_blocks(sizes, blocks)
    return series if (np.abs(series[:, -2:]) <= ROUNDING * sizes[:, None]).all() else None


def of_blocks(sizes: Vector, blocks: Integers) -> Vector:
    """Return for each entry the largest size in its block."""
    largest = np.zeros(blocks.max() + 1)
    np.maximum.at(largest, blocks, sizes)
    block_sizes: Vector = largest[blocks]
    return block_sizes


def chebyshev(count: int) -> tuple[Vector, Matrix]:
    """Return Chebyshev nodes, and the matrix from values there to coefficients."""
    k = 2 * np.arange(count) + 1  # in whole numbers: the waves keep their digits
    table = np.cos(np.pi / (2 * count) * (np.outer(np.arange(count), k) % (4 * count)))
    table[0] /= 2
    return np.cos(np.pi / (2 * count) * k), 2 / count * table


def weights(cell: Cell, z: Vector) -> Vector:
    """Return 1 over the scale of each unknown of a cell, and 1 for ``q``."""
    count, memories = len(cell.phases), len(cell.memory)
    states, memory = z[: 2 * count], z[2 * count : 2 * count + memories]
    total = float(z[2 * count + memories :][:count].sum())
    largest = float(np.abs(z[: 2 * count + memories]).max())
    least = SMALL * largest if largest > ROUNDING else 1.0  # at rest at 0 at every switch
    sizes = np.ones(len(z) + 1)
    for j in range(2):
        sizes[j : 2 * count : 2] = max(float(np.abs(states[j::2]).max()), least)
    sizes[2 * count : 2 * count + memories] = np.maximum(np.abs(memory), least)
    sizes[2 * count + memories :][:count] = total
    return 1 / sizes


def divided_phases(cell: Cell, durations: Vector) -> Integers:
    """Return 1 for each phase whose event row is divided by its duration, else 0.

    These begin on the surface where they end.  If all phases of a cell do, the longest keeps
    its row: else no equation puts the orbit on the surface.
    """
    count = len(cell.phases)
    divided = np.array([returns(cell, p) for p in range(count)], dtype=np.int64)
    if divided.all():
        divided[int(np.argmax(durations[:count]))] = 0
    return divided


def returns(cell: Cell, p: int) -> bool:
    """Whether a phase begins on the surface where it ends, without a leap of the form."""
    before, phase = earlier(cell, p, 1), cell.phases[p]
    width = phase.width
    remembers = any(phase.event[width:]) or any(before.event[width:])
    leaps = remembers or before.leaps(phase.event)
    return same(before.event[:width], phase.event[:width]) and not leaps


def begins_still(cell: Cell, p: int) -> bool:
    """Whether a phase begins without speed, and the surface where it ends does not move."""
    before, event = cell.phases[p - 1], cell.phases[p].event
    return (before.rho, before.d) == (0.0, 0.0) and not any(event[1:3])


def begins_slowly(cell: Cell, p: int) -> bool:
    """Whether a phase begins without speed and acceleration, and ends where that is so again.

    It follows a rest that ended because the holding force, that of the phase, reached a limit.
    It ends without speed, or where the mass rested.
    """
    before, phase = earlier(cell, p, 1), cell.phases[p]
    at_rest = before.held and before.speed == before.d == 0
    if phase.held or not (at_rest and phase.g) or cell.memory:
        return False
    force = -phase.k, 0.0, phase.g, phase.f
    if of_speed(cell, p):
        return same(before.event, force)
    slope, *varying, constant = phase.event
    if any(varying) or not same(earlier(cell, p, 2).event, phase.event):
        return False
    force_at_surface = 0.0, 0.0, phase.g, phase.f + phase.k * constant / slope
    return same(before.event, force) or same(before.event, force_at_surface)


def begins_as_set(cell: Cell, p: int) -> bool:
    """Whether a phase begins without speed on the surface that the memory it sets defines."""
    before, event = earlier(cell, p, 1), cell.phases[p].event
    if not event[0] or any(event[1:3]) or before.event[0] or any(before.event[2:]):
        return False
    terms, sets_memory = [np.array(event[:4])], False
    for factor, memory in zip(event[4:], cell.memory, strict=True):
        if factor:
            sets_memory = memory.phase == p
            terms.append(factor * np.array(memory.value[:4]))
    sizes = np.abs(terms).max(axis=0)
    return sets_memory and bool((np.abs(np.sum(terms, axis=0)) <= EQUAL * sizes).all())


def of_speed(cell: Cell, p: int) -> bool:
    """Whether a phase ends without speed."""
    event = cell.phases[p].event
    return bool(event[1]) and not any((event[0], *event[2:]))


def of_velocity(form: Form) -> bool:
    """Whether a form is of the velocity, and not of the displacement."""
    return form[0] == 0 != form[1]


def earlier(cell: Cell, p: int, by: int) -> Phase:
    """Return the phase `by` before phase p, mirrored if it is in the half period before."""
    phase = cell.phases[(p - by) % len(cell.phases)]
    return mirror(phase) if p < by and cell.sign < 0 else phase
