"""Piecewise Chebyshev interpolants of functions on [0, 1], adaptively refined.

Pieces are halved until the last coefficients are rounding.  Critical points and extremes are
then exact to rounding: no narrow dip is missed between samples.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.polynomial import chebyshev

from ..arrays import Matrix, Vector

Function = Callable[[Vector], Vector]

#: Degree of a piece; number of its last coefficients that must be small; how small, relative
#: to the largest value.
DEGREE, LAST, RESOLVED = 32, 4, 1e-13

#: Largest rounding error of a function, relative to its size.  Last coefficients below this
#: that halving a piece does not lower are noise: the piece is resolved.
NOISE = 1e-8

#: Most halvings of a piece, and most pieces: a function that needs more has more waves than
#: can be followed, or consists mostly of rounding errors.
HALVINGS, MOST = 40, 256

#: Coefficients below this, relative to the values, are their rounding errors.
ROUNDING = 1e-14

#: Largest distance of a root from [-1, 1], or from the real axis, to be a candidate.
NEAR = 1e-3


@dataclass(frozen=True)
class Piece:
    """Chebyshev coefficients on an interval, and whether they resolve the function there."""

    start: float
    end: float
    coefficients: Vector
    resolved: bool = True

    def derivative(self, times: int) -> Vector:
        """Return the coefficients of the derivative of order `times` by u in [0, 1]."""
        scale = 2 / (self.end - self.start)
        return np.asarray(chebyshev.chebder(self.coefficients, times, scl=scale))

    def significant(self, size: float) -> Vector:
        """Return the coefficients up to the last that is no rounding of values of a size."""
        above = np.flatnonzero(np.abs(self.coefficients) > ROUNDING * size)
        return self.coefficients[: int(above.max(initial=0)) + 1]

    def critical_points(self) -> Vector:
        """Return the real roots of the derivative, and points near roots up to rounding."""
        series = self.significant(float(np.abs(self.coefficients).max()))
        if len(series) == 1:
            return np.empty(0)
        roots = chebyshev.chebroots(chebyshev.chebder(series))
        near = (np.abs(roots.imag) <= NEAR) & (np.abs(roots.real) <= 1 + NEAR)
        w = np.clip(roots[near].real, -1.0, 1.0)
        return np.asarray(self.start + (self.end - self.start) * (1 + w) / 2)


@cache
def interpolation(degree: int) -> tuple[Vector, Matrix]:
    """Return the Chebyshev nodes on [-1, 1], and the matrix from values to coefficients."""
    nodes = np.cos(np.pi * (np.arange(degree + 1) + 0.5) / (degree + 1))
    matrix = chebyshev.chebvander(nodes, degree) * (2 / (degree + 1))
    matrix[:, 0] /= 2
    return np.asarray(nodes), np.asarray(matrix)


def pieces(
    function: Function, size: float = 0.0, cuts: Sequence[float] | Vector = ()
) -> list[Piece]:
    """Return the interpolants of a function on [0, 1], from left to right.

    Parameters
    ----------
    function : callable
        Values at an array of points; smooth on [0, 1].
    size : float
        Size of the terms whose sum the function is, if larger than its own values: their
        rounding errors limit its resolution.
    cuts : sequence of float
        Where the first pieces meet, in increasing order; see `transients.cuts`.
    """
    nodes, matrix = interpolation(DEGREE)
    interpolants: list[Piece] = []
    edges = np.array([0.0, *cuts, 1.0])
    starts, ends, last_before = edges[:-1], edges[1:], np.full(len(edges) - 1, np.inf)
    halvings = 0
    while len(starts):  # all pieces once halved, then all twice
        lengths = ends - starts
        values = function((starts[:, None] + lengths[:, None] * (1 + nodes) / 2).ravel())
        coefficients = values.reshape(len(starts), -1) @ matrix
        size = max(size, float(np.abs(values).max()))
        last = np.abs(coefficients[:, -LAST:]).max(axis=1)
        only_noise = (last <= NOISE * size) & (last > last_before / 100)
        resolved = (last <= RESOLVED * size) | only_noise
        too_many = len(interpolants) + len(starts) >= MOST
        done = resolved | too_many | (halvings >= HALVINGS)
        interpolants += [
            Piece(float(start), float(end), row, bool(is_resolved))
            for start, end, row, is_resolved in zip(
                starts[done], ends[done], coefficients[done], resolved[done], strict=True
            )
        ]
        middles = (starts + lengths / 2)[~done]
        starts = np.column_stack([starts[~done], middles]).ravel()
        ends = np.column_stack([middles, ends[~done]]).ravel()
        last_before, halvings = np.repeat(last[~done], 2), halvings + 1
    return sorted(interpolants, key=lambda piece: piece.start)


def candidates(parts: list[Piece]) -> Vector:
    """Return the points where a function may have its extremes: critical points and ends."""
    ends = [0.0, *(part.end for part in parts)]
    return np.concatenate([ends, *(part.critical_points() for part in parts)])


def extremes(
    function: Function, size: float = 0.0, cuts: Sequence[float] | Vector = ()
) -> tuple[float, float]:
    """Return the least and the largest value of a function on [0, 1]; see `pieces`.

    Critical points are looked for in those pieces that may have values beyond their ends.
    """
    parts = pieces(function, size, cuts)
    coefficients = np.array([part.coefficients for part in parts])
    mean, waves = coefficients[:, 0], coefficients[:, 1:]
    signs = (-1.0) ** np.arange(1, coefficients.shape[1])
    ends = mean + np.array([waves.sum(axis=1), (waves * signs).sum(axis=1)])
    reach = np.abs(waves).sum(axis=1)
    beyond = (mean + reach >= ends.max()) | (mean - reach <= ends.min())
    inside = candidates([parts[i] for i in np.flatnonzero(beyond)])
    values = function(np.append(inside, 1.0))
    return float(values.min()), float(values.max())


def accumulated(parts: list[Piece]) -> tuple[float, float]:
    """Return the maximum norms of the first and the second integral of a function.

    The constant of the first is such that the second has equal values at 0 and 1; the constant
    of the second is such that its norm is least.
    """
    w = np.linspace(-1.0, 1.0, 2 * DEGREE + 1)
    rate = travel = 0.0
    points, rates, travels = [], [], []
    for part in parts:
        half = (part.end - part.start) / 2
        once = chebyshev.chebint(part.coefficients, 1, lbnd=-1, scl=half)
        twice = chebyshev.chebint(once, 1, lbnd=-1, scl=half)
        points.append(part.start + half * (1 + w))
        rates.append(rate + chebyshev.chebval(w, once))
        travels.append(travel + rate * half * (1 + w) + chebyshev.chebval(w, twice))
        rate, travel = float(rates[-1][-1]), float(travels[-1][-1])
    level = np.concatenate(travels) - travel * np.concatenate(points)
    largest = np.abs(np.concatenate(rates) - travel).max()
    return float(largest), float(level.max() - level.min()) / 2


def derivative_at(parts: list[Piece], u: Vector, times: int) -> Vector:
    """Return the derivative of order `times` of an interpolant at points in [0, 1]."""
    starts = np.array([part.start for part in parts])
    which = np.searchsorted(starts, u, side="right") - 1
    values = np.empty(len(u))
    for index, part in enumerate(parts):
        inside = which == index
        w = 2 * (u[inside] - part.start) / (part.end - part.start) - 1
        values[inside] = chebyshev.chebval(w, part.derivative(times))
    return values
