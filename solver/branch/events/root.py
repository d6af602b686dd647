"""Where a monitor vanishes in a step of a branch, and the orbit there."""

from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from ..piece import Piece
from ..place import NoStepError, Place
from ..walk import MEETS, OUTSIDE, OWN
from .circle import beyond_circle

#: Rounding of monitors without units.
ROUNDING = 4 * float(np.finfo(float).eps)

#: Tolerance of the root of a monitor, as a part of a step.
NEAR = 1e-14

#: Where a monitor is this small, as a part of its values at the ends of the step, and so many
#: values in turn have not halved it, the rest is rounding.
SMALL, STALLED = 1e-7, 2

#: Parts of a step tried beside a fold or a flip, and where branches meet: next to that no step
#: succeeds.
SIDES = 1e-6, 1e-5, 1e-4, 1e-3


@dataclass
class Search:
    """The lowest value of a monitor in the search for its root.

    Parameters
    ----------
    size, small : float
        The larger value at the ends; and what is small beside both.
    at, least : float
        Where it was lowest, and how low.
    stalls : int
        How many values in turn have not halved it.
    """

    size: float
    small: float
    at: float = np.nan
    least: float = np.inf
    stalls: int = 0

    @classmethod
    def between(cls, one: float, other: float) -> "Search":
        """Return a search from the values at both ends; one of them may be NaN."""
        return cls(float(np.fmax(one, other)), SMALL * float(np.fmin(one, other)))

    def is_over(self, at: float, value: float) -> bool:
        """Whether all beyond the next value is rounding."""
        self.stalls = 0 if value <= self.least / 2 else self.stalls + 1
        if value < self.least:
            self.at, self.least = at, value
        is_settled = self.least <= self.small and self.stalls >= STALLED
        return value <= ROUNDING * self.size or is_settled


def root(piece: Piece, before: Place, ends: tuple[float, float], i: int) -> tuple[float, Place]:
    """Return where in a part of a step a monitor vanishes, and the orbit there (Brent).

    Where branches meet, the equations are singular: then between the orbits on either side.

    Raises
    ------
    NoStepError
        If it is not found.
    """
    from scipy.optimize import brentq  # noqa: PLC0415  (300 ms)

    @cache
    def place_at(at: float) -> Place:
        return piece.stepped(before, at) if at else before

    def of_monitor(place: Place) -> float:
        return float(place.monitors[i])

    own = i - (len(before.monitors) - OWN)
    try:
        monitor = beyond_circle(piece, *map(place_at, ends)) if own == OUTSIDE else of_monitor
        search = Search.between(*(abs(monitor(place_at(at))) for at in ends))

        def value(at: float) -> float:
            try:
                height = monitor(place_at(at))
            except NoStepError:
                if own != MEETS or at in ends:
                    raise
                return 0.0
            if np.isnan(height):  # no orbit there that has it
                return search.size
            return 0.0 if search.is_over(at, abs(height)) else height

        at = float(
            brentq(value, *ends, xtol=NEAR * max(map(abs, ends)), rtol=NEAR, maxiter=200)
        )
    except (ValueError, RuntimeError):  # no change of the sign, or too many trials
        raise NoStepError from None
    at = search.at if search.least <= search.small else at
    try:
        return at, place_at(at)
    except NoStepError:
        low, high = either_side(piece, before, at, ends[1] - ends[0])
        return _between(low, high, i)


def either_side(
    piece: Piece, before: Place, at: float, length: float
) -> list[tuple[float, Place]]:
    """Return the nearest orbits on either side of a place in a step, each with where.

    Raises
    ------
    NoStepError
        If there are none.
    """
    for part in SIDES:
        with suppress(NoStepError):
            sides = at - part * length, at + part * length
            return [(side, piece.stepped(before, side)) for side in sides]
    raise NoStepError


def _between(
    low: tuple[float, Place], high: tuple[float, Place], i: int
) -> tuple[float, Place]:
    """Return where between two near orbits a monitor vanishes, and the orbit there, linearly.

    Raises
    ------
    NoStepError
        If it has one sign.
    """
    (start, one), (end, other) = low, high
    first, last = float(one.monitors[i]), float(other.monitors[i])
    if not first * last < 0:
        raise NoStepError
    part = first / (first - last)
    y, maps = (q + part * (r - q) for q, r in ((one.y, other.y), (one.maps, other.maps)))
    monitors = one.monitors.copy()
    monitors[i] = 0.0
    return start + part * (end - start), replace(one, y=y, monitors=monitors, maps=maps)
