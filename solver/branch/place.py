"""An orbit of a branch with its monitors, and room for several."""

from dataclasses import dataclass
from typing import Any, NamedTuple

from ..arrays import Matrix, Vector


@dataclass(frozen=True, eq=False)
class Place:
    """An orbit of a piece.

    Parameters
    ----------
    y : ndarray
        The unknowns, and the coordinate ``q`` of the parameter.
    tangent : ndarray
        The unit tangent, in scaled coordinates.
    monitors : ndarray
        Test functions for events: three of each form of the table, the durations, and those of
        the orbit as a whole (`walk.OWN`).
    extremes : ndarray, shape (2, 2)
        Least and largest displacement and velocity of the cell.
    maps : ndarray, shape (2, n, n) or (2, 0, 0)
        The derivative of the map over the cell, before it is mirrored, and its size; of a body
        they are not kept.
    """

    y: Vector
    tangent: Vector
    monitors: Vector
    extremes: Matrix
    maps: Matrix


class Orbits(NamedTuple):
    """Orbits in the rows of arrays: see `walk.walk`."""

    Y: Matrix
    D: Matrix
    V: Matrix
    E: Any
    T: Any
    S: Vector

    def place(self, i: int) -> Place:
        """Return the orbit of a row."""
        return Place(self.Y[i], self.D[i], self.V[i], self.E[i], self.T[i])


class NoStepError(ArithmeticError):
    """A step does not lead to the branch."""
