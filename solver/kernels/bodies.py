"""Kernels of bodies: the force series, and the exact equations, of the times alone."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arrays import Matrix, Vector
from ..bodies import exact, series
from ..bodies import motion as motions
from . import linking
from .kernel import Kernel

if TYPE_CHECKING:
    from ..scenes.bodies.cell import BodyCell
    from ..scenes.loaded import LoadedScene

#: What is given to the functions of a kernel: a cell, and N; 0 of the exact equations.
Given = tuple["BodyCell", int]

#: Lowest order: a line on each phase.
LOWEST = 1


def series_kernel(scene: "LoadedScene", method: str) -> Kernel:
    """Return the kernel of the force series for a scene of one motion."""
    return _kernel(scene, method, lambda case, order: (case.cell, order))


def exact_kernel(cell: "BodyCell") -> Kernel:
    """Return the exact equations of a cell of a body."""
    count, memory = len(cell.phases), len(cell.memory)
    return _made("exact", count, memory, cell.forced, 2 * count, lambda case, order: (cell, 0))


def _kernel(scene: "LoadedScene", method: str, given: Callable[[Any, int], Any]) -> Kernel:
    count, memory = len(scene.kinds), scene.memory
    forced = scene.frequency is not None
    names = [name for name, *_ in memory]
    powers = [power for _, _, power, _ in memory]
    own = _made(method, count, len(memory), forced, 0, given)

    def coefficients(z: Vector) -> dict[str, tuple[Any, int]]:
        return {q: (z[i], powers[i]) for i, q in enumerate(names)}

    return Kernel(**{**vars(own), "coefficients": coefficients})


def _made(
    method: str, count: int, memory: int, forced: bool, states: int, given: Any
) -> Kernel:
    """Return a kernel whose unknowns are states, if any, the memory, and the times."""
    width = count + forced
    newton = linking.linked(residual, jacobian, count, forced)

    def iterate(case: Any, z: Vector, limit: int) -> tuple[int, int, float, float]:
        case = _given(case)
        times = z[len(z) - width :].copy()
        status, iterations, correction, norm = newton(case, times, limit)
        z[len(z) - width :] = times
        try:
            _fill(case, z, times, states)
        except (np.linalg.LinAlgError, ValueError):
            z[: len(z) - width] = np.nan
        return status, iterations, float(correction), float(norm)

    def signals(case: Any, z: Vector, p: int, u: Vector) -> Matrix:
        return motions.signals(*_given(case), z[len(z) - width :], p, u)

    def motion(case: Any, z: Vector, p: int, u: Vector, derivative: int) -> Vector:
        return motions.derivative(*_given(case), z[len(z) - width :], p, u, derivative)

    return Kernel(
        method=method,
        durations=count,
        forced=forced,
        lowest=LOWEST,
        size=lambda order: states + memory + width,
        residual=residual,
        jacobian=jacobian,
        motion=motion,
        coefficients=lambda z: {},
        iterate=iterate,
        given=given,
        condensed=True,
        signals=signals,
    )


def _given(case: Any) -> Given:
    """Return a cell and an order; of the exact equations the cell alone is given."""
    return case if isinstance(case, tuple) else (case, 0)


def _evaluated(case: Any, times: Vector) -> Any:
    cell, order = _given(case)
    return exact.evaluated(cell, times) if order == 0 else series.evaluated(cell, order, times)


def residual(case: Any, times: Vector, R: Vector) -> None:
    """Fill R with the events and the length of the cell, at times alone."""
    try:
        R[:] = _evaluated(case, times).residual
    except np.linalg.LinAlgError:
        R[:] = np.nan


def jacobian(case: Any, times: Vector, J: Matrix) -> None:
    """Fill J with their derivatives."""
    try:
        J[:] = _evaluated(case, times).jacobian
    except np.linalg.LinAlgError:
        J[:] = np.nan


def _fill(case: Given, z: Vector, times: Vector, states: int) -> None:
    """Fill what stands before the times: the state in which phases begin, and the memory."""
    cell, order = case
    found = _evaluated(case, times)
    before = states
    if order == 0:
        first = exact.parts_of(cell)[0].lawful.A.shape[0]
        own = [found.starts[each.phase][first + i] for i, each in enumerate(cell.memory)]
        for p in range(len(cell.phases)) if states else ():
            z[2 * p : 2 * p + 2] = motions.signals(cell, 0, times, p, np.zeros(1))[:2, 0]
    else:
        own = list(found.unknowns[len(found.unknowns) - len(cell.memory) :])
    z[before : before + len(cell.memory)] = own
