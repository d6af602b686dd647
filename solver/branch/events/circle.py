"""Which multiplier crosses the unit circle between two orbits of a branch."""

from collections.abc import Callable
from typing import Any

import numpy as np

from ..piece import Piece
from ..place import Place
from ..walk import NEUTRAL, OUTSIDE, OWN


def multipliers(piece: Piece, place: Place) -> Any:
    """Return the multipliers of a cell, not mirrored, by descending modulus."""
    values = np.linalg.eigvals(piece.maps(place)[0])
    return values[np.argsort(-np.abs(values), kind="stable")]


def beyond_circle(piece: Piece, one: Place, other: Place) -> Callable[[Place], float]:
    """Return a monitor of the next multiplier that leaves the unit circle between two orbits.

    It is the modulus less 1 of the largest one that is inside at one of them.  If that is on
    the circle there, as without damping, the monitor vanishes where it is off by rounding.
    """
    k, inside = first_leaving(one, other)
    size = abs(multipliers(piece, inside)[k]) - 1
    least = NEUTRAL if abs(size) <= NEUTRAL else 0.0
    return lambda place: float(abs(multipliers(piece, place)[k]) - 1 - least)


def first_leaving(one: Place, other: Place) -> tuple[int, Place]:
    """Return the smaller number of multipliers outside at two orbits, and that orbit."""
    counts = [place.monitors[len(place.monitors) - OWN + OUTSIDE] for place in (one, other)]
    return int(min(counts)), (one, other)[int(np.argmin(counts))]
