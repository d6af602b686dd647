"""Where a monitor vanishes in a step of a branch, and the orbit there."""

from contextlib import suppress
from dataclasses import dataclass
from functools import cache

import numpy as np

from ...arrays import Vector
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

#: Where branches meet, equations are singular: orbits are taken at these places beside, times
#: the first of these parts of a step that is large enough.
ACROSS, WIDTHS = (-5, -3, -1, 1, 3, 5), (1e-3, 1e-2, 1e-1)

#: Largest third difference of a smooth function there, as a part of its change: more is seen
#: where an orbit is one of the other branch.
BENT = 1e-3


@dataclass
class Search:
    """The lowest value of a monitor in the search for its root.

    Parameters
    ----------
    size, small : float
        The larger value at the ends (one of them may be NaN), and what is small beside both.
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

    def is_over(self, at: float, value: float) -> bool:
        """Whether all beyond the next value is rounding."""
        self.stalls = 0 if value <= self.least / 2 else self.stalls + 1
        if value < self.least:
            self.at, self.least = at, value
        is_settled = self.least <= self.small and self.stalls >= STALLED
        return value <= ROUNDING * self.size or is_settled


def root(piece: Piece, before: Place, ends: tuple[float, float], i: int) -> tuple[float, Place]:
    """Return where in a part of a step a monitor vanishes, and the orbit there (Brent).

    Where branches meet, the equations are singular: see `_across`.

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
        one, other = (abs(monitor(place_at(at))) for at in ends)
        search = Search(float(np.fmax(one, other)), SMALL * float(np.fmin(one, other)))

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
    if own == MEETS:
        return _across(piece, before, at, ends[1] - ends[0], i)
    return at, place_at(at)


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


def _across(
    piece: Piece, before: Place, at: float, length: float, i: int
) -> tuple[float, Place]:
    """Return where the equations are singular near a place in a step, and the orbit there.

    By interpolation between orbits to either side, as functions of `_singularities`; monitor i
    vanishes there.

    Raises
    ------
    NoStepError
        If there are none, or the equations are regular between.
    """
    for part in WIDTHS:
        with suppress(NoStepError, np.linalg.LinAlgError):
            steps = at + part * length * np.array(ACROSS)
            places = [piece.stepped(before, float(step)) for step in steps]
            heights = _singularities(piece, places)
            rise, bent = heights[-1] - heights[0], np.abs(np.diff(heights, 3)).max()
            is_monotone = (np.diff(heights) * rise > 0).all()
            if is_monotone and bent <= BENT * abs(rise) and heights[0] * heights[-1] < 0:
                return _at_zero(heights, steps, places, i)
    raise NoStepError


def _singularities(piece: Piece, places: list[Place]) -> Vector:
    """Return a smooth function of orbits that vanishes where their equations are singular.

    The Jacobian A of each, bordered by one tangent, is bordered by the singular vectors u and w
    of the least singular value of one of them: g of ``A v + u g = 0, w v = 1`` (W. J. F.
    Govaerts, 2000).
    """
    matrices = [np.vstack([piece.jacobian(q.y), places[0].tangent]) for q in places]
    left, _, right = np.linalg.svd(matrices[len(matrices) // 2])
    one = np.eye(len(left) + 1)[-1]
    bordered = (np.block([[A, left[:, -1:]], [right[-1:], np.zeros((1, 1))]]) for A in matrices)
    return np.array([np.linalg.solve(each, one)[-1] for each in bordered])


def _at_zero(
    heights: Vector, steps: Vector, places: list[Place], i: int
) -> tuple[float, Place]:
    """Return the step and the orbit for which monitor i vanishes, by Lagrange's formula."""
    apart = heights[:, None] - heights + np.eye(len(heights))
    weights = np.prod(np.where(np.eye(len(heights)), 1.0, -heights / apart), axis=1)
    parts = {
        name: np.tensordot(weights, np.array([getattr(place, name) for place in places]), 1)
        for name in ("y", "tangent", "extremes", "maps")
    }
    monitors = places[len(places) // 2].monitors.copy()
    monitors[i] = 0.0
    return float(weights @ steps), Place(monitors=monitors, **parts)
