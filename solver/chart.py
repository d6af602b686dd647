"""A map of two parameters: which motion there is at each point, and whether it is stable.

Some rows and columns are followed as branches, with a search for orbits on each.  From their
orbits the points between are filled in, each from its neighbours, and the events on them lie on
curves that are followed in both parameters.  Lines, and the blocks of rows between them, are
tasks of their own.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise, product
from numbers import Integral
from typing import Any

import numpy as np

from .arrays import Integers, Matrix, Vector
from .branch.branch import GENERIC
from .branch.course import Course
from .charts.block import NEITHER, STABLE, block_of
from .charts.curves import curves_of
from .charts.lines import Line, Stretch, line_of
from .charts.plane import Bounds, Plane
from .results.chart import Chart, EventCurve
from .results.interrupted import Interrupted
from .scenes.case import Case, check_case, index_of
from .scenes.ordered import declared_as
from .scenes.orders import Order, image
from .scenes.parameter_error import is_number

#: Least and most values of an axis, and most points.
LEAST_VALUES, MOST_VALUES, MOST_POINTS = 2, 10_000, 4_000_000

#: Least lines that are followed each way, and for how many rows or columns there is one.
LINES, EACH = 3, 64


@dataclass(frozen=True)
class Axis:
    """A parameter that varies: its range in SI units, and how many values it takes."""

    name: str
    ends: tuple[float, float]
    count: int

    @property
    def values(self) -> Vector:
        """Its values, in SI units."""
        return np.linspace(*self.ends, self.count)

    def lines(self) -> list[tuple[str, float]]:
        """Return its values on lines that are followed, each with its name."""
        return [(self.name, float(self.values[i])) for i in _lines(self.count)]


def chart(
    case: Case, axes: Mapping[str, tuple[float, float, int]], executor: Any = None,
    progress: Callable[[str], None] = lambda done: None,
) -> Chart:  # fmt: skip
    """Return which motion an oscillator has over two of its parameters.

    Each orbit is exact, converged and admissible; a point without one is empty.  Of several
    at a point a stable one is shown, and among these the motion that the scene declares first.
    Orbits are looked for at a few values on some rows and columns: what lies between them and
    touches none is not seen.

    Parameters
    ----------
    case : Case
        The oscillator; its own values of the two parameters do not matter.
    axes : mapping of str to (float, float, int)
        For each of two parameters its first and last value in SI units, and how many values.
    executor : Executor, optional
        Where lines and blocks of rows are computed: anything with the ``submit`` of
        `concurrent.futures`, such as pools of processes, dask's client and pools of MPI.
        Default: this process.
    progress : callable
        Called with words when a line or a block is done; there are `number_of_tasks`.

    Raises
    ------
    TypeError
        If `case` is not a `Case`.
    ParameterError
        A `ValueError`: if the scene has no such parameter, a corner of the map makes no
        oscillator, or the equations change too much over it.
    ValueError
        If there are not two axes, or one is not two different numbers and a count.
    Interrupted
        A `KeyboardInterrupt`: with the rows that were computed before.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> stop = registry.load("impact")(damping=0.1, restitution=0.8)
    >>> found = chart(stop, {"frequency": (2.0, 3.0, 2), "gap": (0.0, 0.2, 2)})
    >>> found.motion
    [['flight', 'flight'], ['flight', 'only flight']]
    >>> [curve.kind for curve in found.curves]
    ['flip', 'grazing']
    """
    columns, rows = _axes(case, axes)
    names, bounds = (columns.name, rows.name), (columns.ends, rows.ends)
    corner = _at(case, names, (columns.ends[0], rows.ends[0]))
    tasks = [
        (corner.with_value(*each), names, bounds, across, along.count)
        for across, of, along in ((1, rows, columns), (0, columns, rows))
        for each in of.lines()
    ]
    lines: list[Line] = []
    for line in _run(executor, line_of, tasks):
        lines.append(line)
        progress(f"line {len(lines)} of {len(tasks)}")
    planes, seeds = planes_of(case, names, bounds, [each for line in lines for each in line[0]])
    A, B = (np.linspace(-1, 1, axis.count) for axis in (columns, rows))
    parts = [range(low, high + 1) for low, high in pairwise(_lines(rows.count))]
    blocks = _run(
        executor, block_of, [(planes, A, B[part], B[1] - B[0], seeds) for part in parts]
    )
    values = columns.values, rows.values
    best = np.full((len(B), len(A)), 3 * len(planes))
    curves: list[EventCurve] = []
    done = 0
    try:
        events = [each for line in lines for each in line[1]]
        for curve in curves_of(events, planes):
            points = np.array([curve.plane.values(y) for y in curve.points])
            curves.append(EventCurve(curve.kind, curve.plane.course.called, points, curve.why))
        for part, block in zip(parts, blocks, strict=True):
            best[part] = np.minimum(best[part], block)
            done = part[-1] + 1
            progress(f"{rows.name} = {rows.values[done - 1]:g}")
    except KeyboardInterrupt:
        if not done:
            raise
        partial = _result(case, names, values, planes, best, curves)
        raise Interrupted(partial, f"{done} of {rows.count} rows are done") from None
    return _result(case, names, values, planes, best, curves)


def number_of_tasks(columns: int, rows: int) -> int:
    """Return how many lines and blocks a map has."""
    return len(_lines(columns)) + 2 * len(_lines(rows)) - 1


def _lines(count: int) -> list[int]:
    """Return which rows, or columns, are followed."""
    several = min(count, max(LINES, count // EACH + 1))
    return sorted({*np.linspace(0, count - 1, several).round().astype(int).tolist()})


def _run(executor: Any, work: Callable[..., Any], tasks: Sequence[Any]) -> Iterator[Any]:
    """Return an iterator over the results of tasks, which an executor begins at once."""
    if executor is None:
        return (work(*task) for task in tasks)
    futures = [executor.submit(work, *task) for task in tasks]
    return (future.result() for future in futures)


def planes_of(
    case: Case, names: tuple[str, str], bounds: Bounds, stretches: Sequence[Stretch]
) -> tuple[list[Plane], list[Matrix]]:
    """Return the planes of all orders of phases that were found, and their orbits."""
    indices = index_of(case, names[0]), index_of(case, names[1])
    planes, seeds = [], []
    inside = _at(case, names, [low + GENERIC * (high - low) for low, high in bounds])
    courses = {q.course: None for q in stretches if q.course.exists(inside)}
    for course in sorted(courses, key=lambda each: _turn(each, inside)):
        same_course = [q for q in stretches if q.course == course]
        longest = max(same_course, key=lambda q: len(q.points))
        plane = Plane.over(course, longest.case, indices, bounds, longest.middle)
        planes.append(plane)
        seeds.append(plane.inside(np.concatenate([q.points for q in same_course])))
    return planes, seeds


def _turn(course: Course, case: Case) -> tuple[float, str]:
    """Return what sorts orders of phases: those that are declared, then by their length.

    Before a declared order stands its half, of symmetric orbits, if it is a motion of a case.
    """
    every, steps = course.base.whole.each_motion, course.order.steps
    if not course.endless and course.declared is not None:
        return every.index(course.declared), ""
    if course.order.half_period:
        cell = course.base.cell(case.numbers)
        images = [q for q in (image(cell, step) for step in steps) if q is not None]
        declared = declared_as(course.base, Order((*steps, *images)))
        if declared is not None:
            return every.index(declared) - 0.5, ""
    return len(every) + len(steps), course.called


def _result(
    case: Case, names: tuple[str, str], values: tuple[Vector, Vector],
    planes: Sequence[Plane], best: Integers, curves: Sequence[EventCurve],
) -> Chart:  # fmt: skip
    """Return what is found as users hold it, with the motions that occur."""
    count = len(planes)
    number, verdict = (best % count, best // count) if count else (best, best)
    index, motions = np.full(best.shape, -1), []
    for i, plane in enumerate(planes):
        chosen = (number == i) & (best < 3 * count)
        if chosen.any():
            motions += [] if plane.course.called in motions else [plane.course.called]
            index[chosen] = motions.index(plane.course.called)
    stable = np.where(verdict == NEITHER, -1, verdict == STABLE).astype(int)
    stable[index < 0] = -1
    return Chart(case, names, values, tuple(motions), index, stable, tuple(curves))


def _axes(case: Case, axes: Mapping[str, tuple[float, float, int]]) -> tuple[Axis, Axis]:
    """Return what varies along the columns and along the rows, checked."""
    check_case(case)
    if not isinstance(axes, Mapping) or len(axes) != 2:
        raise ValueError(f"axes: got {axes!r:.80}, expected two parameters")
    columns, rows = (_axis(case, name, extent) for name, extent in axes.items())
    if columns.count * rows.count > MOST_POINTS:
        got = f"{columns.count} by {rows.count} points"
        raise ValueError(f"axes: got {got}, expected at most {MOST_POINTS}")
    for corner in product(columns.ends, rows.ends):
        _at(case, (columns.name, rows.name), corner)
    return columns, rows


def _axis(case: Case, name: str, numbers: object) -> Axis:
    index_of(case, name)
    parts: list[Any] = [*numbers] if isinstance(numbers, Sequence) else []
    right = len(parts) == 3 and all(map(is_number, parts)) and parts[0] != parts[1]
    count = int(parts[2]) if right and isinstance(parts[2], Integral) else 0
    if not LEAST_VALUES <= count <= MOST_VALUES:
        expected = f"two different numbers, and {LEAST_VALUES} to {MOST_VALUES} values"
        raise ValueError(f"{name}: got {numbers!r:.80}, expected {expected}")
    low, high = sorted(map(float, parts[:2]))
    return Axis(name, (low, high), count)


def _at(case: Case, names: tuple[str, str], values: Sequence[float]) -> Case:
    """Return the case at a point of the map."""
    parameters = dict(case.values) | {n: float(q) for n, q in zip(names, values, strict=True)}
    return Case(case.scene, parameters, case.cycles)
