"""Our exact orbit and force series from rough times, and the functions of the package."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

import nonsmooth as ns
from nonsmooth.solver.bodies.motion import Given
from nonsmooth.solver.iteration.newton import newton
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.kernels.bodies import exact_kernel

from .problem import OMEGA, Row


def _units(row: Row) -> np.ndarray:
    return np.array([row.case.units.time] * 2 + [1.0])


#: Frequency of the point before, by that of a point of a response.
BEFORE = 0.99


def in_response(row: Row) -> Callable[[int], np.ndarray]:
    """Return Newton's method from the times at a frequency near by: a point of a response."""
    orbit = ns.exact(row.case.scene(**{**row.case.values, "drive": BEFORE * OMEGA}))
    times = [*(BEFORE * q.duration for q in orbit.phases), orbit.forcing_phase]
    return by_newton(row, np.array(times))


def by_newton(row: Row, start: np.ndarray | None = None) -> Callable[[int], np.ndarray]:
    """Return Newton's method on the times, by the series of an order; by the exact flow at 0.

    The series is compiled.  Poles and eigenbases are computed anew in every call, the modes of
    the body are not.
    """
    cell, rough = row.case.cell, (row.rough if start is None else start) / _units(row)
    series = registry.kernel(row.case.scene.each_motion[0], "ck-tau", compile_it=True)

    def solve(order: int) -> np.ndarray:
        fresh = replace(cell, body=replace(cell.body))
        own = series if order else exact_kernel(fresh)
        start = np.append(np.zeros(own.size(order) - len(rough)), rough)
        given = Given(fresh, order) if order else fresh
        return newton(own.iterate, given, start).unknowns[-3:] * _units(row)

    return solve


def by_package(row: Row) -> Callable[[int], np.ndarray]:
    """Return what `ns.solve`, at 0 `ns.exact`, returns: with starts of its own, all checks."""
    scene, values = row.case.scene, row.case.values
    count = [0]

    def solve(order: int) -> np.ndarray:
        count[0] += 1  # another case, of which nothing is known
        case = scene(**{**values, "gap": values["gap"] * (1 + 1e-14 * count[0])})
        orbit = ns.solve(case, order=order) if order else ns.exact(case)
        return np.array([*(q.duration for q in orbit.phases), orbit.forcing_phase])

    return solve
