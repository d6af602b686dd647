"""All roots of ``D**2 = P**2 + Q**2`` on an interval, and whether none can be missing.

D, P and Q are smooth.  On short pieces each is interpolated by Chebyshev polynomials; the last
coefficients estimate the error, the others bound derivatives.  With ``R = hypot(P, Q)``:

- A part of a piece has no root if ``|D| - R`` or ``D**2 - R**2`` at its middle is larger than
  its possible change on the part.
- It has at most one root of ``D = R`` and one of ``D = -R`` if D is steeper than R, and at most
  one root in all if ``D**2 - R**2`` is monotonic.
- Else it is halved.

Two close roots on both sides of a zero of D belong to different equations: both are found.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.polynomial import chebyshev

from ..arrays import Indices, Matrix, Vector
from ..orbit.chebyshev import interpolation

#: ``function(s)`` returns D, P and Q, each of the shape of `s`; those of one row of `s` may be
#: multiplied by a positive number of that row.
Function = Callable[[Matrix], Matrix]

#: Degree of an interpolant; the number of its last coefficients, and their size, relative to
#: the largest, once it is resolved.
DEGREE, LAST, RESOLVED = 24, 3, 1e-12

#: Size of last coefficients that may be rounding, and the factor by which halving a piece must
#: reduce them: if it does not, they are taken as the error of the interpolant.
NOISE, LOWER = 1e-4, 4.0

#: Most pieces, and most parts of pieces at a time.
MOST_PIECES, MOST_PARTS = 600, 4000

#: Most halvings: of a piece until it is resolved, of a part, of a part with one root.
SHORTEST, DEEPEST, HALVINGS = 12, 40, 48

#: Steps of false position before an interval is halved; the change at which they end.
FALSE, SETTLED = 12, 1e-15

#: Relative distance below which doubtful intervals are joined.
BESIDE = 1e-9

#: Bound of the error of an interpolant, relative to its last coefficients.
FACTOR = 8.0


@dataclass(frozen=True)
class Roots:
    """The roots: their places, and the signs of D there, ``D = sign * R``.

    The error of a place is about 1e-12 of the distance from the nearer end.  In `doubtful`
    intervals, shape (n, 2), there may be further roots; `resolved` is whether all pieces are.
    """

    places: Vector
    signs: Vector
    doubtful: Matrix
    resolved: bool

    @property
    def complete(self) -> bool:
        """Whether all roots were found."""
        return self.resolved and not len(self.doubtful)


@dataclass(frozen=True)
class Pieces:
    """Interpolants of D, P and Q: coefficients of shape ``(3, pieces, DEGREE + 1)``."""

    starts: Vector
    ends: Vector
    coefficients: Matrix
    resolved: bool

    def taken(self, indices: Indices) -> "Pieces":
        """Return some of the pieces."""
        starts, ends = self.starts[indices], self.ends[indices]
        return Pieces(starts, ends, self.coefficients[:, indices], self.resolved)


def roots(function: Function, edges: Vector) -> Roots:
    """Return the roots of a function between the first and the last of ascending edges."""
    parts = _pieces(function, edges)
    which, low, high, doubtful = _isolated(parts)
    places, signs = _bisected(parts, which, low, high)
    order = np.argsort(places)
    return Roots(places[order], signs[order], doubtful, parts.resolved)


def _pieces(function: Function, edges: Vector) -> Pieces:
    """Return interpolants on pieces between the edges, halved until they are resolved."""
    nodes, matrix = interpolation(DEGREE)
    low, high = edges[:-1], edges[1:]
    before = np.full(len(low), np.inf)
    done: list[tuple[Vector, Vector, Matrix]] = []
    resolved, count = True, 0
    for halvings in range(SHORTEST + 1):
        s = low[:, None] + (high - low)[:, None] * (1 + nodes) / 2
        C = function(s) @ matrix
        last = np.abs(C[:, :, -LAST:]).max(axis=(0, 2)) / np.abs(C).max(axis=(0, 2))
        fine = (last <= RESOLVED) | ((last <= NOISE) & (LOWER * last >= before))
        count += len(low)
        if halvings == SHORTEST or count > MOST_PIECES:
            resolved, fine = bool(fine.all()), np.ones_like(fine)
        done.append((low[fine], high[fine], C[:, fine]))
        middle = (low + high)[~fine] / 2
        low, high = np.append(low[~fine], middle), np.append(middle, high[~fine])
        before = np.tile(last[~fine], 2)
        if not len(low):
            break
    starts, ends, coefficients = zip(*done, strict=True)
    return Pieces(
        np.concatenate(starts), np.concatenate(ends),
        np.concatenate(coefficients, axis=1), resolved,
    )  # fmt: skip


def _values(C: Matrix, w: Vector) -> Matrix:
    """Return the values of interpolants, each row of coefficients at its own place."""
    return np.asarray(np.einsum("fnk,nk->fn", C, chebyshev.chebvander(w, C.shape[2] - 1)))


def _isolated(parts: Pieces) -> tuple[Indices, Vector, Vector, Matrix]:
    """Return parts with at most one root of each equation, and doubtful intervals."""
    C, F = parts.coefficients, _difference(parts.coefficients)
    rates, rate_F = _derivative(C, 1), _derivative(F, 1)
    bends = np.abs(_derivative(C, 2)).sum(axis=2)
    bend_D, bend_R = bends[0], np.hypot(bends[1], bends[2])
    bend_F = np.abs(_derivative(F, 2)).sum(axis=2)[0]
    error = FACTOR * np.abs(C[:, :, -LAST:]).max(axis=(0, 2))
    error_F = error * np.abs(C).sum(axis=2).max(axis=0)
    count = C.shape[1]
    which, middle, half = np.arange(count), np.zeros(count), np.ones(count)
    single: list[tuple[Indices, Vector, Vector]] = []
    given_up: list[tuple[Indices, Vector, Vector]] = []
    for _ in range(DEEPEST):
        (D, P, Q), (dD, dP, dQ) = _values(C[:, which], middle), _values(rates[:, which], middle)
        value, rate = (abs(_values(each[:, which], middle)[0]) for each in (F, rate_F))
        more_D, more_R = half * bend_D[which], half * bend_R[which]
        slope_D, slope_R = np.abs(dD) + more_D, np.hypot(dP, dQ) + more_R
        change, change_F = half * (slope_D + slope_R), half * (rate + half * bend_F[which])
        far = np.abs(np.abs(D) - np.hypot(P, Q)) > change + error[which]
        far |= value > change_F + error_F[which]
        once = np.abs(dD) - more_D > slope_R + error[which] * DEGREE**2
        once |= rate > half * bend_F[which] + error_F[which] * DEGREE**2
        vain = (change <= error[which]) & (change_F <= error_F[which])
        kept, left = once & ~far, ~(once | far | vain)
        vain &= ~(once | far)
        single.append((which[kept], middle[kept] - half[kept], middle[kept] + half[kept]))
        given_up.append((which[vain], middle[vain], half[vain]))
        which, quarter = np.repeat(which[left], 2), np.repeat(half[left] / 2, 2)
        middle = np.repeat(middle[left], 2) + quarter * np.tile([-1.0, 1.0], left.sum())
        half = quarter
        if not 0 < len(which) <= MOST_PARTS:
            break
    given_up.append((which, middle, half))
    index, low, high = (np.concatenate(each) for each in zip(*single, strict=True))
    which, middle, half = (np.concatenate(each) for each in zip(*given_up, strict=True))
    where = parts.taken(which)
    return index, low, high, _joined(_place(where, middle - half), _place(where, middle + half))


def _derivative(C: Matrix, times: int) -> Matrix:
    return np.asarray(chebyshev.chebder(C, times, axis=2), dtype=float)


def _difference(C: Matrix) -> Matrix:
    """Return the coefficients of ``D**2 - P**2 - Q**2``, of twice the degree."""
    nodes, matrix = interpolation(2 * DEGREE)
    D, P, Q = C @ chebyshev.chebvander(nodes, DEGREE).T
    return np.asarray(((D * D - P * P - Q * Q) @ matrix)[None])


def _joined(low: Vector, high: Vector) -> Matrix:
    """Return intervals in order; those that touch are merged."""
    order = np.argsort(low)
    low, high = low[order], np.maximum.accumulate(high[order])
    separate = low[1:] > high[:-1] * (1 + BESIDE)
    first, last = np.append(True, separate), np.append(separate, True)
    return np.column_stack([low[first[: len(low)]], high[last[: len(low)]]])


def _place(parts: Pieces, w: Vector) -> Vector:
    return np.asarray(parts.starts + (parts.ends - parts.starts) * (1 + w) / 2)


def _bisected(
    parts: Pieces, which: Indices, low: Vector, high: Vector
) -> tuple[Vector, Vector]:
    """Return the roots of ``D = R`` and ``D = -R`` in parts at whose ends the signs differ."""
    places, signs = [], []
    for sign in (1.0, -1.0):
        C = parts.coefficients[:, which]
        crossed = (_excess(sign, C, low) >= 0) != (_excess(sign, C, high) >= 0)
        excess = partial(_excess, sign, C[:, crossed])
        w = changes_of_sign(excess, low[crossed], high[crossed], HALVINGS)
        places.append(_place(parts.taken(which[crossed]), w))
        signs.append(np.full(len(w), sign))
    return np.concatenate(places), np.concatenate(signs)


def _excess(sign: float, C: Matrix, w: Vector) -> Vector:
    D, P, Q = _values(C, w)
    return np.asarray(sign * D - np.hypot(P, Q))


@np.errstate(divide="ignore", invalid="ignore")  # values may be beyond float64
def changes_of_sign(
    function: Callable[[Vector], Vector], low: Vector, high: Vector, halvings: int
) -> Vector:
    """Return the place in each interval where a function changes its sign.

    By false position, with half of the value at an end that stays (the Illinois method); an
    interval in which this does not settle is halved.

    Examples
    --------
    >>> cubes = changes_of_sign(lambda x: x**3 - [1, 5], np.zeros(2), np.full(2, 3.0), 50)
    >>> print(cubes)
    [1.         1.70997595]
    """
    left, right, near = function(low), function(high), SETTLED * np.maximum(abs(low), abs(high))
    begin = end = left >= 0
    place, done = low, np.zeros(len(low), dtype=bool)
    for step in range(FALSE + halvings):
        false, last = high - right * ((high - low) / (right - left)), place
        is_inside = np.isfinite(right - left) & (low <= false) & (false <= high)
        is_inside &= step < FALSE
        place = np.where(done, last, np.where(is_inside, false, (low + high) / 2))
        value = function(place)
        done |= (value == 0) | (np.abs(place - last) <= near)
        if done.all():
            break
        before = (value >= 0) == begin
        part = np.where((before == end) & (step > 0), 0.5, 1.0)  # of an end that stays again
        left, low = np.where(before, value, part * left), np.where(before, place, low)
        right, high = np.where(before, part * right, value), np.where(before, high, place)
        end = before
    return np.asarray(place)
