"""Kernels of bodies, solved for times alone: force series, harmonics, exact equations."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ...generated import force_series
from ..arrays import Matrix, Vector
from ..bodies import exact
from ..bodies import motion as motions
from ..bodies.force_series import events, integrals, one_by_one, series
from ..bodies.force_series.layout import setting
from ..bodies.harmonics import system as harmonics
from ..bodies.motion import Given
from ..bodies.part import parts_of
from ..iteration.many import converged
from ..scenes.methods import about
from . import linking
from .account import Account
from .compiling import rebuilt
from .family import Family
from .kernel import Kernel
from .start import RoughTimes

if TYPE_CHECKING:
    from ..scenes.bodies.cell import BodyCell
    from ..scenes.loaded import LoadedScene

#: Largest number of entries of all phase maps of starts that are solved at once.
ROOM = 2_000_000

#: Lowest order: a line on each phase, one harmonic.
LOWEST = 1


def linked(equations: Any, make: linking.Make) -> dict[str, Any]:
    """Return the functions of the force series, and Newton's method on its times.

    Compiled functions integrate for one pole at a time, plain ones for arrays of poles.
    """
    by_pole = () if make is rebuilt else (one_by_one,)
    functions = linking.made((force_series, integrals, *by_pole, series, equations), {}, make)
    system = functions["residual"], functions["jacobian"], functions["times_of"]
    newton = linking.newton_with(*system, make, FAST=events.FAST)
    return functions | {"iterate": newton["iterate_scene"]}


#: Names of the functions that solve for the times.
SOLVING = "residual", "jacobian", "iterate"

#: Modules compiled with the force series, one kernel for all bodies.
MODULES = (force_series, integrals, one_by_one, series, *linking.SEVERAL)
FAMILY = Family(linked, MODULES, events.residual, seconds=20.0)


def kernel(
    scene: "LoadedScene",
    method: str,
    functions: int | None,
    compiles: Callable[[Account], bool],
) -> Kernel:
    """Return the kernel of a method for a scene of one motion.

    Parameters
    ----------
    scene, method : LoadedScene, str
    functions : int, optional
        Number of functions added to the harmonics, of a method that has them.
    compiles : callable
        ``compiles(account)``: whether to compile the kernel, if it can be compiled.
    """
    memory = [(name, power) for name, _, power, _ in scene.memory]
    solving, account, beside = (residual, jacobian, iterate), None, None
    if about(method).is_series:
        beside = functions or 0
    else:
        spent = FAMILY.account_of(events.__name__)
        compile_it = compiles(spent)
        account = None if compile_it else spent
        linked_functions = (FAMILY.compiled if compile_it else FAMILY.plain)(events.__name__)
        solving = tuple(_of_arrays(linked_functions[name]) for name in SOLVING)
    bare = _made(method, len(scene.kinds), memory, scene.frequency is not None, 0, solving)

    def given(case: Any, order: int) -> Given:
        return Given(case.cell, order, beside)

    return replace(bare, given=given, account=account)


def exact_kernel(cell: "BodyCell") -> Kernel:
    """Return the kernel of the exact equations of a cell of a body."""
    count, memory = len(cell.phases), [(each.name, each.power) for each in cell.memory]
    solving = residual, jacobian, iterate
    return _made("exact", count, memory, cell.forced, 2 * count, solving)


def _made(
    method: str,
    count: int,
    memory: list[tuple[str, int]],
    forced: bool,
    states: int,
    solving: tuple[Any, ...],
) -> Kernel:
    """Return a kernel whose unknowns are `states` entries of states, the memories, and times.

    The functions `solving` are of the times alone; the other unknowns are filled in afterwards.
    Of each memory, name and power of 1/time in its unit are given.
    """
    (times_residual, times_jacobian, newton), width = solving, count + forced

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
        return motions.signals(_given(case), z[len(z) - width :], p, u)

    def motion(case: Any, z: Vector, p: int, u: Vector, derivative: int) -> Vector:
        return motions.derivative(_given(case), z[len(z) - width :], p, u, derivative)

    def coefficients(z: Vector) -> dict[str, tuple[Any, int]]:
        return {name: (z[states + i], power) for i, (name, power) in enumerate(memory)}

    return Kernel(
        method=method,
        durations=count,
        forced=forced,
        lowest=LOWEST,
        size=lambda order: states + len(memory) + width,
        residual=times_residual,
        jacobian=times_jacobian,
        motion=motion,
        coefficients=coefficients,
        iterate=iterate,
        condensed=True,
        signals=signals,
    )


def _of_arrays(function: Any) -> Any:
    """Return a function of the force series with a `Given` as first argument."""

    def of_given(case: Given, *others: Any) -> Any:
        arrays = setting(case.cell, case.order)
        of_this_call = arrays._replace(evaluated=arrays.evaluated.copy())
        return function(of_this_call, *others)

    return of_given


def _given(case: Any) -> Given:
    """Return the argument of a kernel as `Given`; exact equations may take the cell alone."""
    return case if isinstance(case, Given) else Given(case, 0)


def _evaluated(case: Any, times: Vector) -> Any:
    """Return residual and Jacobian of the exact equations or of harmonics, at given times."""
    cell, order, functions = _given(case)
    if order == 0:
        return exact.evaluated(cell, times)
    return harmonics.evaluated(cell, order, functions or 0, times)


def residual(case: Any, times: Vector, R: Vector) -> None:
    """Fill R with the residuals of the events and of the cell's duration, at given times."""
    try:
        R[:] = _evaluated(case, times).residual
    except np.linalg.LinAlgError:
        R[:] = np.nan


def jacobian(case: Any, times: Vector, J: Matrix) -> None:
    """Fill J with the derivatives of `residual` by the times."""
    try:
        J[:] = _evaluated(case, times).jacobian
    except np.linalg.LinAlgError:
        J[:] = np.nan


def times_of(case: Given) -> tuple[int, int]:
    """Return the number of unknown durations, and of unknown phases of the forcing: 1 or 0."""
    return len(case.cell.phases), int(case.cell.forced)


#: Newton's method for these equations, always plain Python.
iterate = linking.newton_with(residual, jacobian, times_of, rebuilt, FAST=events.FAST)[
    "iterate_scene"
]


def _fill(case: Given, z: Vector, times: Vector, states: int) -> None:
    """Fill in the unknowns before the times: states at the begin of phases, and memories."""
    cell = case.cell
    if case.order == 0:
        starts = exact.evaluated(cell, times).starts
        first = parts_of(cell)[0].lawful.A.shape[0]
        memory = [starts[each.phase][first + i] for i, each in enumerate(cell.memory)]
        for p in range(len(cell.phases)) if states else ():
            z[2 * p : 2 * p + 2] = motions.signals(case, times, p, np.zeros(1))[:2, 0]
    else:
        memory = list(motions.memory_of(case, times))
    z[states : states + len(cell.memory)] = memory


def ends(cell: "BodyCell", starts: Sequence[RoughTimes]) -> Iterator[RoughTimes]:
    """Yield the times to which Newton's method leads from several, some of them often."""

    def equations(times: Matrix) -> tuple[Matrix, Matrix]:
        found = exact.at_times(cell, times)
        return found.residual, found.jacobian

    count = len(cell.phases)
    at_once = 1 + ROOM // (count * (2 * len(cell.body.squares)) ** 2)
    for i in range(0, len(starts), at_once):
        rows = [[*q.durations, *[q.angle] * cell.forced] for q in starts[i : i + at_once]]
        with np.errstate(all="ignore"):
            found_times = converged(equations, np.array(rows), int(cell.forced))
        for z in found_times:
            angle = float(z[count]) if cell.forced else 0.0
            yield RoughTimes(tuple(map(float, z[:count])), angle, "several starts")
