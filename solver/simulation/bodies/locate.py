"""The first event of a phase of a body, which no step can pass over.

Between two times a form is within ``B h**4/384`` of the cubic that has its values and slopes
at both, where B bounds its fourth derivative, and that cubic is above the least of its
Bernstein coefficients.  Intervals for which this leaves a zero are divided, until the form
falls all along one: then it has one zero there.  A form that falls below zero by no more than
its rounding only touches it.
"""

import numpy as np

from ...arrays import Matrix, Vector
from ..steps.locate import BEYOND, CUT, EPS, EVENT, LOST, NOISE
from .along import Along
from .regime import TERMS

#: Intervals that are looked at together, and how much longer they are after each success.
POINTS, LONGER = 16, 4.0

#: Times that intervals are divided or go on before a search is given up.
MOST_ROUNDS = 20_000

#: Newton's steps and halvings to a zero, and those to that of a cubic.
STEPS, CUBIC = 60, 6


def first_event(
    along: Along, zeros: "np.ndarray[tuple[int], np.dtype[np.bool_]]", most: float
) -> tuple[float, int, int]:
    """Return where the first of some forms vanishes: a time, how it ended, and which form.

    How is `EVENT`, `CUT`, `BEYOND` or `LOST`.

    Parameters
    ----------
    along : Along
        Each form is not negative just after its beginning.
    zeros : ndarray of bool, shape (F,)
        Which forms are known to be zero there.
    most : float
        Time after which the search ends.
    """
    zero = [
        along.regime.leading(row, along.Y, bool(known))
        for row, known in zip(along.rows, zeros, strict=True)
    ]
    begins = [_departs(along, f, order, most) for f, order in enumerate(zero) if order]
    tolerance = NOISE * along.sizes
    tolerance[[order == TERMS for order in zero]] = np.inf  # zero all along
    first = min([most, along.regime.window, *begins])
    t, h = 0.0, first / POINTS
    if not np.isfinite(tolerance + h).any():
        return 0.0, BEYOND, 0
    for _ in range(MOST_ROUNDS):
        if t >= most:
            return most, CUT, 0
        ends = np.minimum(t + h * np.arange(POINTS + 1), most)
        values, slopes = along.at(ends)
        if not np.isfinite(values).all():
            return t, BEYOND, 0
        least, steepest = _hulls(along, ends, values, slopes)
        doubtful = ~(least > -tolerance[:, None])
        doubtful[np.array(zero) > 0, :] &= ends[1:] > first
        if not doubtful.any():
            t, h = float(ends[-1]), LONGER * h
            continue
        k = int(np.argmax(doubtful.any(axis=0)))
        forms, a, b = (
            np.flatnonzero(doubtful[:, k]).tolist(),
            float(ends[k]),
            float(ends[k + 1]),
        )
        below = values[forms, k + 1] < -tolerance[forms]
        if below.all() and (steepest[forms, k] < 0).all():
            cubics = np.array([values[:, k], values[:, k + 1], slopes[:, k], slopes[:, k + 1]])
            found = [(_zero(along, form, a, b, cubics[:, form]), form) for form in forms]
            return _event(min(found))
        if b - a > 4 * EPS * b:
            t, h = a, (b - a) / POINTS
        elif below.any():
            return _event((b, forms[int(np.argmax(below))]))
        else:
            t, h = b, first / POINTS
    return t, LOST, 0


def _event(found: tuple[float, int]) -> tuple[float, int, int]:
    return found[0], EVENT, int(found[1])


def _departs(along: Along, form: int, order: int, most: float) -> float:
    """Return a time in which a form that begins at zero has no other zero.

    Its first derivative that is not zero keeps half of its value.
    """
    if order == TERMS:
        return most
    row = along.rows[form]
    for _ in range(order):
        row = row @ along.regime.generator
    growth = float(along.regime.part.flow.poles.real.max(initial=0.0))
    most = min(most, 1 / growth) if growth > 0 else most
    bound = float(along.bounds(order + 1, np.zeros(1), most)[form, 0])
    value = abs(float(row @ along.Y))
    return min(most, value / (2 * bound)) if bound else most


def _hulls(along: Along, t: Vector, values: Matrix, slopes: Matrix) -> tuple[Matrix, Matrix]:
    """Return below what a form never falls between times, and what its slope never exceeds."""
    h, left, right = np.diff(t), values[:, :-1], values[:, 1:]
    falls, rises = slopes[:, :-1], slopes[:, 1:]
    bound = along.bounds(4, t[:-1], float(h.max()))
    inner = np.minimum(left + h * falls / 3, right - h * rises / 3)
    least = np.minimum(np.minimum(left, right), inner) - bound * h**4 / 384
    mean = (right - left) / np.where(h > 0, h, 1.0)
    steep = np.maximum(np.maximum(falls, rises), 3 * mean - falls - rises)
    return least, steep + bound * h**3 / 124


def _zero(along: Along, form: int, a: float, b: float, cubic: Vector) -> float:
    """Return the zero of a form that falls between two times, by Newton's method.

    It starts from that of the cubic by the values at both, and the slopes.
    """
    low, high = max(0.0, 2 * a - b), b  # it may begin below, by rounding
    t = a + (b - a) * _zero_of_cubic(cubic * [1.0, 1.0, b - a, b - a])
    last, rounding = EPS * b, NOISE * float(along.sizes[form])  # no step before the first
    for _ in range(STEPS):
        values, slopes = along.at(np.array([t]), form)
        value, slope = float(values[0, 0]), float(slopes[0, 0])
        if value == 0:
            return t
        low, high = (t, high) if value > 0 else (low, t)
        moved = t - value / slope if slope < 0 else np.inf
        if abs(value) <= rounding and slope < 0:
            return min(max(moved, low), high)
        moved = moved if low < moved < high else (low + high) / 2
        step = abs(moved - t)
        if step * min(1.0, (step / last) ** 2) <= EPS * t:  # steps shrink by their squares
            return moved
        t, last = moved, step
    return t


def _zero_of_cubic(cubic: Vector) -> float:
    """Return about where a cubic that falls from 0 to 1 vanishes.

    Examples
    --------
    >>> round(_zero_of_cubic(np.array([1.0, -7.0, 0.0, -24.0])), 6)
    0.5
    """
    start, end, falls, rises = map(float, cubic)
    second, third = 3 * (end - start) - 2 * falls - rises, 2 * (start - end) + falls + rises
    u = min(max(start / (start - end), 0.0), 1.0)
    for _ in range(CUBIC):
        slope = falls + u * (2 * second + 3 * u * third)
        value = start + u * (falls + u * (second + u * third))
        u = min(max(u - value / slope if slope < 0 else 0.5, 0.0), 1.0)
    return u
