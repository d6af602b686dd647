"""Kernels of bodies, of the times alone: force series, harmonics, the exact equations."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..arrays import Matrix, Vector
from ..bodies import exact, series
from ..bodies import motion as motions
from ..bodies.harmonics import system as harmonics
from ..bodies.part import parts_of
from ..scenes.methods import about
from . import linking
from .kernel import Kernel

if TYPE_CHECKING:
    from ..scenes.bodies.cell import BodyCell
    from ..scenes.loaded import LoadedScene

#: Lowest order: a line on each phase, one harmonic.
LOWEST = 1


class Given(NamedTuple):
    """What the functions of a kernel take.

    Parameters
    ----------
    cell : BodyCell
    order : int
        N; 0 of the exact equations.
    functions : int, optional
        Of harmonics: how many functions are beside them at each switch.
    """

    cell: "BodyCell"
    order: int
    functions: int | None = None


def kernel(scene: "LoadedScene", method: str, functions: int | None) -> Kernel:
    """Return the kernel of a method for a scene of one motion.

    Parameters
    ----------
    scene, method : LoadedScene, str
    functions : int, optional
        Beside the harmonics, of a method that has them.
    """
    beside = (functions or 0) if about(method).is_series else None
    return _kernel(scene, method, lambda case, order: Given(case.cell, order, beside))


def exact_kernel(cell: "BodyCell") -> Kernel:
    """Return the exact equations of a cell of a body."""
    count, memory = len(cell.phases), len(cell.memory)
    return _made(
        "exact", count, memory, cell.forced, 2 * count, lambda case, order: Given(cell, 0)
    )


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
        cell, order, functions = _given(case)
        return motions.signals(cell, order, z[len(z) - width :], p, u, functions)

    def motion(case: Any, z: Vector, p: int, u: Vector, derivative: int) -> Vector:
        cell, order, functions = _given(case)
        times = z[len(z) - width :]
        return motions.derivative(cell, order, times, p, u, derivative, functions)

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
    return case if isinstance(case, Given) else Given(case, 0)


def _evaluated(case: Any, times: Vector) -> Any:
    cell, order, functions = _given(case)
    if order == 0:
        return exact.evaluated(cell, times)
    if functions is None:
        return series.evaluated(cell, order, times)
    return harmonics.evaluated(cell, order, functions, times)


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
    cell, order, functions = case
    before = states
    if order == 0:
        found = exact.evaluated(cell, times)
        first = parts_of(cell)[0].lawful.A.shape[0]
        own = [found.starts[each.phase][first + i] for i, each in enumerate(cell.memory)]
        for p in range(len(cell.phases)) if states else ():
            z[2 * p : 2 * p + 2] = motions.signals(cell, 0, times, p, np.zeros(1))[:2, 0]
    else:
        own = list(motions.memory_of(cell, order, functions, times))
    z[before : before + len(cell.memory)] = own
