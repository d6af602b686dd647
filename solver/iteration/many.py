"""Newton's method from many starts at once: the rules of `iteration`, with stacked equations.

Each start is a coroutine that asks for corrections; all that wait are answered together.
"""

from collections.abc import Callable, Generator

import numpy as np

from ..arrays import Matrix, Vector
from .iteration import ROUNDOFF, SETTLED, SMALLEST_STEP, longest_damping, step_size
from .newton import ITERATION_LIMIT

#: It yields where it wants corrections, and whether the Jacobian of the place before is kept
#: from now on.  It is sent those by the Jacobian that is kept and by the one there.
Search = Generator[tuple[Vector, bool], tuple[Vector, Vector], Vector | None]


def converged(
    equations: Callable[[Matrix], tuple[Matrix, Matrix]], starts: Matrix, forced: int
) -> list[Vector]:
    """Return where Newton's method converges from each start; without those where it does not.

    Parameters
    ----------
    equations : callable
        Residuals, shape (k, n), and Jacobians, shape (k, n, n), at k places.
    starts : ndarray, shape (m, n)
        Durations and, if `forced`, the phase of the forcing.
    """
    count, n = starts.shape
    searches = [_search(z, n - forced, forced) for z in starts]
    wanted = {i: next(search) for i, search in enumerate(searches)}
    kept, newest = np.zeros((2, count, n, n))
    found: dict[int, Vector | None] = {}
    while wanted:
        rows, renewed = [*wanted], [i for i, (_, renews) in wanted.items() if renews]
        kept[renewed] = newest[renewed]
        R, newest[rows] = equations(np.array([z for z, _ in wanted.values()]))
        corrections = _solved(kept[rows], -R), _solved(newest[rows], -R)
        for i, simplified, full in zip(rows, *corrections, strict=True):
            try:
                wanted[i] = searches[i].send((simplified, full))
            except StopIteration as end:
                del wanted[i]
                found[i] = end.value
    return [z for _, z in sorted(found.items()) if z is not None]


def _search(z: Vector, durations: int, forced: int) -> Search:
    """Search from z by the steps of `iteration.iterate_within`, none of them simplified."""
    damping, previous = 1.0, np.inf
    _, step = yield z, False
    for _ in range(ITERATION_LIMIT):
        length, correction = step_size(step, z, durations, forced)
        if not np.isfinite(length):
            return None
        longest, renews = longest_damping(step, z, durations, forced), True
        if length <= SETTLED and (correction <= ROUNDOFF or correction > 0.5 * previous):
            return np.asarray(z + longest * step)
        previous, damping = correction, min(1.0, 2.0 * damping, longest)
        while True:
            trial = z + damping * step
            following, newest = yield trial, renews
            size, ahead = step_size(following, z, durations, forced)
            if size <= (1 - damping / 4) * length or max(size, length) <= SETTLED:
                break
            damping, renews = damping / 2, False
            if damping < SMALLEST_STEP:
                return None
        if max(size, length) <= SETTLED and ahead <= ROUNDOFF:
            return np.asarray(trial + following)
        z, step = trial, newest
    return None


def _solved(J: Matrix, R: Matrix) -> Matrix:
    """Return the solutions of stacked systems; NaN where one is singular."""
    scales = np.abs(J).max(axis=2)
    scales[scales == 0] = 1.0
    try:
        return np.asarray(
            np.linalg.solve(J / scales[..., None], (R / scales)[..., None])[..., 0]
        )
    except np.linalg.LinAlgError:
        if len(J) > 1:
            return np.concatenate(
                [_solved(*q) for q in zip(J[:, None], R[:, None], strict=True)]
            )
        return np.full(R.shape, np.nan)
