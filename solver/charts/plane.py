"""The equations of an order of phases over two parameters, in one set of units."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property
from itertools import product

import numpy as np

from ..arrays import Integers, Matrix, Vector
from ..branch.along import ROUNDING, Along, Interval, chebyshev, of_blocks
from ..branch.course import Course, Row
from ..branch.piece import unit_of
from ..orbit.exact_orbit import ExactOrbit
from ..scenes.case import Case
from ..scenes.parameter_error import ParameterError

#: Least and highest degree of the series in each parameter.
LEAST_DEGREE, HIGHEST_DEGREE = 4, 64

Bounds = tuple[tuple[float, float], tuple[float, float]]


@dataclass(frozen=True, eq=False)
class Plane:
    """An order of phases over a rectangle of two parameters.

    Parameters
    ----------
    case : Case
        It gives the units and the other parameters.
    indices : (int, int)
        The numbers of the parameters.
    bounds : ((float, float), (float, float))
        Their ranges, in SI units.
    series : Along
        The equations, with series in both parameters, shape (entries, terms, terms).
    table : ndarray of int
        The watched forms.
    """

    course: Course
    case: Case
    indices: tuple[int, int]
    bounds: Bounds
    series: Along
    rows: tuple[Row, ...]
    table: Integers

    @classmethod
    def over(
        cls, course: Course, case: Case, indices: tuple[int, int], bounds: Bounds, z: Vector
    ) -> "Plane":
        """Return the plane of an order of phases.

        Parameters
        ----------
        case : Case
            The parameters of an orbit of this order that is not at an event.
        z : ndarray
            Its unknowns, in SI units.

        Raises
        ------
        ParameterError
            If the equations change too much over the rectangle for their series.
        """
        course = replace(course, units=case.units).about(case.numbers)
        cell = course.cell(case.numbers)
        unknowns = z / course.sizes(cell, case)
        rows = tuple(course.rows(case.numbers, unknowns))
        series = _series(course, case, indices, bounds, rows)
        table = course.table(case.numbers, unknowns, rows)
        points = product(*(q.some() for q in _intervals(case, indices, bounds)))
        others = (course.cell(_with(case, indices, point)) for point in points)
        equations = course.framed(cell, unknowns, series, others)
        return cls(course, case, indices, bounds, equations, rows, table)

    @cached_property
    def sizes(self) -> Vector:
        """The SI value of 1 of each unknown."""
        return self.course.sizes(self.course.cell(self.case.numbers), self.case)

    @property
    def perturbed(self) -> int:
        """The size of the map of perturbations; of a body, of its state with its memory."""
        return self.course.mapped or self.series.before

    def inside(self, points: Matrix) -> Matrix:
        """Return unknowns and parameters on the plane from those in SI units."""
        ends = enumerate(self.bounds)
        coordinates = ((2 * points[:, i - 2] - sum(q)) / (q[1] - q[0]) for i, q in ends)
        return np.column_stack([points[:, :-2] / self.sizes, *coordinates])

    def values(self, y: Vector) -> tuple[float, float]:
        """Return the parameters of an orbit of the plane in SI units."""
        first, second = (Interval(*self.bounds[i]).value(float(y[i - 2])) for i in (0, 1))
        return first, second

    def orbit(self, y: Vector) -> ExactOrbit | None:
        """Return the exact orbit of a point; None of a motion of one phase that never ends."""
        if self.course.endless:
            return None
        names = (self.case.scene.parameters[i].name for i in self.indices)
        values = dict(self.case.values) | dict(zip(names, self.values(y), strict=True))
        case = self.course.case(Case(self.case.scene, values, self.case.cycles))
        sizes = self.course.sizes(self.course.cell(case.numbers), case)
        return self.course.orbit(case, y[:-2] * self.sizes / sizes)


def _intervals(case: Case, indices: tuple[int, int], bounds: Bounds) -> list[Interval]:
    """Return the ranges of both parameters, without units."""
    return [Interval(*np.divide(bounds[i], unit_of(case, indices[i]))) for i in (0, 1)]


def _with(case: Case, indices: tuple[int, int], values: Sequence[float]) -> tuple[float, ...]:
    """Return all parameters, without units, two of which have other values."""
    numbers = list(case.numbers)
    numbers[indices[0]], numbers[indices[1]] = map(float, values)
    return tuple(numbers)


def _series(
    course: Course, case: Case, indices: tuple[int, int], bounds: Bounds, rows: Sequence[Row]
) -> Matrix:
    """Return the Chebyshev coefficients of all entries over a rectangle."""
    intervals = _intervals(case, indices, bounds)
    cell = course.cell(case.numbers)
    blocks = course.blocks(cell, course.forms(case.numbers, rows, cell))

    @cache  # the nodes of a degree are among those of twice the degree
    def entries(first: float, second: float) -> Vector:
        point = intervals[0].value(first), intervals[1].value(second)
        numbers = _with(case, indices, point)
        cell = course.cell(numbers)
        return course.entries(cell, course.forms(numbers, rows, cell))

    degrees = [LEAST_DEGREE, LEAST_DEGREE]
    while max(degrees) <= HIGHEST_DEGREE:
        (first, one), (second, other) = map(chebyshev, degrees)
        values = [entries(*nodes) for nodes in product(first.tolist(), second.tolist())]
        grid = np.array(values).T.reshape(-1, len(first), len(second))
        coefficients = one @ grid @ other.T
        largest = of_blocks(np.abs(grid).max(axis=(1, 2)), blocks)[:, None, None]
        coefficients[np.abs(coefficients) <= max(degrees) * ROUNDING * largest] = 0.0
        more = coefficients[:, -1].any(), coefficients[:, :, -1].any()
        if not any(more):
            used = [np.flatnonzero(coefficients.any(axis=i))[-1] + 1 for i in ((0, 2), (0, 1))]
            along, across = (max(2, int(count)) for count in used)
            return np.ascontiguousarray(coefficients[:, :along, :across])
        degrees = [degree << int(grows) for degree, grows in zip(degrees, more, strict=True)]
    names = [case.scene.parameters[i].name for i in indices]
    over = [f"from {low:g} to {high:g}" for low, high in bounds]
    words = f"{names[0]}: got values {over[0]}, and of {names[1]} {over[1]}, over which the"
    raise ParameterError([f"{words} equations change too much: expected smaller ranges"])
