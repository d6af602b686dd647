"""A piece of a branch: one order of phases, one set of units, an interval of the parameter."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from ..arrays import Integers, Matrix, Vector
from ..orbit.exact_orbit import ExactOrbit
from ..scenes.case import Case
from ..scenes.cell import Cell, Form
from . import walk
from .along import Along, Interval
from .course import Course, Row
from .place import NoStepError, Orbits, Place

#: Half width of the interval of a piece, as a part of the parameter or of its unit.
REACH = 0.5


@dataclass(frozen=True, eq=False)
class Piece:
    """The equations of an order of phases along a parameter, in one set of units.

    Parameters
    ----------
    course : Course
    case : Case
        It gives the units and the other parameters.
    index : int
        The number of the parameter.
    bounds : (float, float)
        Its range, in SI units.
    interval : Interval
        The part of the range in which the equations are valid, without units.
    along : Along
        The equations.
    rows : tuple of Row
        The watched forms.
    table : ndarray of int
        The same as `watch` takes them.
    """

    course: Course
    case: Case
    index: int
    bounds: tuple[float, float]
    interval: Interval
    along: Along
    rows: tuple[Row, ...]
    table: Integers

    @classmethod
    def at(
        cls, course: Course, case: Case, index: int, bounds: tuple[float, float], y: Vector,
        rows: Sequence[Row] | None = None,
    ) -> "Piece":  # fmt: skip
        """Return the piece around an orbit, in the units of a case.

        Parameters
        ----------
        course, case, index
            See `Piece`.
        bounds : (float, float)
            Of the parameter, in SI units.
        y : ndarray
            The unknowns of the orbit, and its parameter, without units.
        rows : sequence of Row, optional
            The forms to watch; default: all.
        """
        z, value, unit = y[:-1], float(y[-1]), unit_of(case, index)
        reach = REACH * max(abs(value), 1.0)
        low, high = (bound / unit for bound in bounds)
        interval = Interval(max(low, value - reach), min(high, value + reach))

        def numbers(at: float) -> tuple[float, ...]:
            return (*case.numbers[:index], at, *case.numbers[index + 1 :])

        parameters = numbers(value)
        course = replace(course, units=case.units).about(parameters)
        watched = tuple(course.rows(parameters, z) if rows is None else rows)

        def content(at: float) -> tuple[Cell, list[Form]]:
            cell = course.cell(numbers(at))
            return cell, course.forms(numbers(at), watched, cell)

        equations, interval = course.along(content, value, interval, z)
        table = course.table(parameters, z, watched)
        return cls(course, case, index, bounds, interval, equations, watched, table)

    @property
    def name(self) -> str:
        """The name of the parameter."""
        return self.case.scene.parameters[self.index].name

    def value(self, y: Vector) -> float:
        """Return the parameter in SI units, exact at an end of the range."""
        if self.ends_at(y):
            return self.bounds[int(y[-1] > 0)]
        return self.number(y) * unit_of(self.case, self.index)

    def number(self, y: Vector) -> float:
        """Return the parameter without units."""
        return self.interval.value(float(y[-1]))

    def of_number(self, y: Vector) -> Vector:
        """Return unknowns with the coordinate ``q`` in place of the parameter behind them."""
        return np.append(y[:-1], self.interval.q(float(y[-1])))

    def equations(self, y: Vector) -> Any:
        """Return the equations at an orbit; see `extended.case_at`."""
        return self.course.by("case_at", self.along, float(y[-1]))

    def maps(self, place: Place) -> tuple[Matrix, Matrix]:
        """Return the derivative of the map over the cell, not yet mirrored, and its size."""
        return self.course.maps(self.equations(place.y), place.y[:-1], place.maps)

    def numbers(self, y: Vector) -> tuple[float, ...]:
        """Return all parameters without units."""
        parameters = self.case.numbers
        return (*parameters[: self.index], self.number(y), *parameters[self.index + 1 :])

    def durations(self, y: Vector) -> Vector:
        """Return the durations of the phases, without units."""
        return y[self.along.before :][: len(self.along.kinds)]

    def ends_at(self, y: Vector) -> bool:
        """Whether an orbit is at an end of the range of the parameter."""
        edge = self.interval.high if y[-1] > 0 else self.interval.low
        end = self.bounds[int(y[-1] > 0)] / unit_of(self.case, self.index)
        return abs(y[-1]) == 1 and edge == end

    @cached_property
    def cell(self) -> Cell:
        """The cell for the parameters of the case."""
        return self.course.cell(self.case.numbers)

    def place(self, y: Vector, border: Vector) -> Place:
        """Return an orbit with its monitors, its tangent on the side of `border`.

        Raises
        ------
        NoStepError
            If it has no tangent.
        """
        orbits = self._room(y, border)
        self._asked(walk.PLACED, orbits)
        place = orbits.place(0)
        if not np.isfinite(place.tangent).all():
            raise NoStepError
        return place

    def corrected(self, y: Vector, border: Vector) -> Vector:
        """Return the orbit to which Newton's method leads, orthogonally to `border`.

        Raises
        ------
        NoStepError
        """
        orbits = self._room(y, border)
        _, why, _ = self._asked(walk.CORRECTED, orbits)
        if why == walk.STUCK:
            raise NoStepError
        unknowns: Vector = orbits.Y[0]
        return unknowns

    def jacobian(self, y: Vector) -> Matrix:
        """Return the Jacobian in scaled coordinates, its largest entry in each row 1."""
        J = np.empty((len(y) - 1, len(y)))
        self.course.by("jacobian_along", self.along, y[:-1], y[-1], J)
        J /= self.along.weights
        scaled: Matrix = J / np.abs(J).max(axis=1, keepdims=True)
        return scaled

    def singular_vectors(self, y: Vector) -> Matrix:
        """Return the right singular vectors of the Jacobian; the last span its null space."""
        return np.linalg.svd(self.jacobian(y))[2]

    def stepped(self, place: Place, length: float) -> Place:
        """Return the orbit one step along the branch.

        Raises
        ------
        NoStepError
        """
        ahead = place.y + length * place.tangent / self.along.weights
        return self.place(self.corrected(ahead, place.tangent), place.tangent)

    def walk(
        self, place: Place, length: float, most: float, room: int
    ) -> tuple[list[Place], Vector, int, float]:
        """Return the orbits of the next steps, their lengths, and why they end.

        Parameters
        ----------
        place : Place
            Where to begin.
        length : float
            The first step to try.
        most : float
            The most that a step changes the parameter, in SI units.
        room : int
            Most steps.

        Returns
        -------
        places, lengths, why, length
            See `walk.walk`.
        """
        orbits = self._room(place.y, place.tangent, room)
        orbits.V[0], orbits.E[0], orbits.T[0] = place.monitors, place.extremes, place.maps
        last, why, length = self._asked(walk.WALKED, orbits, length, most / self.sizes[-1])
        places = [orbits.place(i) for i in range(1, last + 1)]
        return places, orbits.S[1 : last + 1], why, length

    def _room(self, y: Vector, tangent: Vector, steps: int = 0) -> Orbits:
        """Return arrays with unknowns and tangent of an orbit, and room for some steps."""
        mapped, count = self.course.mapped, steps + 1
        monitors = 3 * len(self.table) + len(self.along.kinds) + walk.OWN
        shapes = (len(y),), (len(y),), (monitors,), (2, 2), (2, mapped, mapped), ()
        orbits = Orbits(*(np.empty((count, *shape)) for shape in shapes))
        orbits.Y[0], orbits.D[0] = y, tangent
        return orbits

    def _asked(
        self, task: int, orbits: Orbits, length: float = 0.0, most: float = 0.0
    ) -> tuple[int, int, float]:
        """See `walk.asked`."""
        arguments = task, self.along, self.table, length, most, *orbits
        last, why, length = self.course.by("asked", *arguments)
        return last, why, length

    @cached_property
    def sizes(self) -> Vector:
        """The SI value of 1 of each unknown, and of 1 of ``q``."""
        half = (self.interval.high - self.interval.low) / 2
        size_of_q = half * unit_of(self.case, self.index)
        return np.append(self.course.sizes(self.cell, self.case), size_of_q)

    def orbit(self, y: Vector, value: float | None = None) -> ExactOrbit | None:
        """Return the exact orbit of a place, or near it at another value of the parameter.

        None of a motion of one phase that never ends.
        """
        if self.course.endless:
            return None
        case = self.case.with_value(self.name, self.value(y) if value is None else value)
        return self.course.orbit(case, self.in_units_of(case, y))

    def in_units_of(self, case: Case, y: Vector) -> Vector:
        """Return the unknowns of an orbit in the units of another case."""
        return np.asarray(y[:-1] * self.sizes[:-1] / replace(self, case=case).sizes[:-1])

    def admits(self, place: Place) -> bool:
        """Whether an orbit is admissible, by its monitors and by the checks of a solver."""
        if (place.monitors[: -walk.OWN] < -walk.LOST).any():
            return False
        orbit = self.orbit(place.y)
        return orbit is None or (orbit.outcome.converged and orbit.admissible)

    def moved(self, place: Place) -> "tuple[Piece, Place]":
        """Return a new piece around an orbit, with its units, and the orbit in it."""
        case = self.case.with_value(self.name, self.value(place.y))
        unknowns = np.append(self.in_units_of(case, place.y), case.numbers[self.index])
        piece = Piece.at(self.course, case, self.index, self.bounds, unknowns, self.rows)
        y = piece.of_number(unknowns)
        border = place.tangent / self.along.weights * self.sizes
        border = border / piece.sizes * piece.along.weights
        y = piece.corrected(y, np.append(np.zeros(len(y) - 1), 1.0))
        return piece, piece.place(y, border / np.linalg.norm(border))


def unit_of(case: Case, index: int) -> float:
    """Return the SI value of 1 of a parameter in the units of a case."""
    return case.units.of_parameter(case.scene.powers[index])
