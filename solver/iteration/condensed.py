"""Newton's method where each phase is solved for by itself: on states and times only.

The rows of a phase are banded in the coefficients of its acceleration; for given states in
which the phases begin, memory and times they determine these, all but the last where the class
is high.  So the coefficients are functions of the other unknowns, and what joins the phases is
a system of as many equations, whatever the order: multiple shooting, with the expansion in the
place of an integrator.  Some of these equations give an unknown by themselves, before or after
all others; `iteration.iterate_scene` solves what is left.

``KEPT`` and the functions that stand here with no body are those of the kernel that `linking`
links this module to.
"""

from typing import Any

import numpy as np

from ..arrays import Matrix, Vector
from .bands import factorise_band, solve_columns, substitute
from .linear import least_squares

#: In the place of `iteration.FAST`: here a new Jacobian costs little more than a residual.
FAST = 0.001

#: Stand for those of the kernel.
KEPT, KEPT_DURATIONS, BELOW, ABOVE = 1, 1, 2, 2
KEPT_FORCED = False


def before(case: Any, z: Vector) -> None:
    """Stand for what single conditions give before."""
    raise NotImplementedError


def after(case: Any, z: Vector) -> None:
    """Stand for what follows from the rest."""
    raise NotImplementedError


def kept_places(z: Vector) -> Any:
    """Stand for the places of the unknowns that are solved for together."""
    raise NotImplementedError


def band_places(z: Vector) -> Any:
    """Stand for the places and sizes of the bands."""
    raise NotImplementedError


def bands(case: Any, z: Vector, diagonals: Any, right: Matrix) -> None:
    """Stand for the bands of the kernel."""
    raise NotImplementedError


def band_rates(case: Any, z: Vector, found: Matrix, slopes: Any) -> None:
    """Stand for their derivatives."""
    raise NotImplementedError


def joints(case: Any, z: Vector, R: Vector) -> None:
    """Stand for the conditions that remain."""
    raise NotImplementedError


def joint_rates(case: Any, z: Vector, slopes: Any, J: Matrix) -> None:
    """Stand for their derivatives."""
    raise NotImplementedError


def residual(case: Any, z: Vector, R: Vector) -> None:
    """Stand for the residual of the whole system."""
    raise NotImplementedError


def iterate_scene(case: Any, z: Vector, limit: int) -> tuple[int, int, float, float]:
    """Stand for Newton's method on what remains."""
    raise NotImplementedError


def condensed_residual(work: Any, y: Vector, R: Vector) -> None:
    """Fill R with what remains at `y`.

    Of the unknowns of the bands those are left in `z` which the joints see; see `complete`.
    """
    case, z, diagonals, right, found, _, exchanged = work
    pad = BELOW + ABOVE
    places = kept_places(z)
    for i in range(KEPT):
        z[places[i]] = y[i]
    bands(case, z, diagonals, right)
    for p, (at, size, _, left, reach) in enumerate(band_places(z)):
        for j in range(size, size + left):
            for i in range(j - ABOVE, size):
                right[p, pad + i] -= diagonals[p, pad + i, pad + j - i] * z[at + j]
            found[p, pad + j] = z[at + j]
        factorise_band(diagonals, exchanged, p, size, right)
        substitute(diagonals, p, 0, reach, right, found)
        for i in range(reach):
            z[at + i] = found[p, pad + i]
    joints(case, z, R)


def complete(work: Any) -> None:
    """Fill in all unknowns of the bands, where the residual was evaluated last."""
    _, z, diagonals, right, found, _, _ = work
    pad = BELOW + ABOVE
    for p, (at, size, _, _, reach) in enumerate(band_places(z)):
        substitute(diagonals, p, reach, size, right, found)
        for i in range(reach, size):
            z[at + i] = found[p, pad + i]


def condensed_jacobian(work: Any, y: Vector, J: Matrix) -> None:
    """Fill J with the derivatives, where the residual was evaluated last."""
    case, z, diagonals, _, found, slopes, exchanged = work
    pad = BELOW + ABOVE
    complete(work)
    band_rates(case, z, found, slopes)
    for p, (_, size, place, left, reach) in enumerate(band_places(z)):
        for j in range(size, size + left):
            for i in range(j - ABOVE, size):
                slopes[p, pad + i, place + j - size] -= diagonals[p, pad + i, pad + j - i]
        solve_columns(diagonals, exchanged, p, size, slopes, reach)
    joint_rates(case, z, slopes, J)


def workplace(case: Any, z: Vector) -> Any:
    """Return what the condensed functions work in: `case`, `z`, and room for the bands.

    There are zeros in front of the solutions, and behind them.
    """
    pad, longest, count = BELOW + ABOVE, 0, 0
    for _, size, _, left, _ in band_places(z):
        longest, count = max(longest, size + left), count + 1
    rows = pad + longest + ABOVE
    diagonals, slopes = np.empty((count, rows, pad + ABOVE + 1)), np.empty((count, rows, KEPT))
    sides = np.zeros((2, count, rows))
    return (
        case,
        z,
        diagonals,
        sides[0],
        sides[1],
        slopes,
        np.empty((count, rows), dtype=np.int64),
    )


def fitted(work: Any, y: Vector) -> None:
    """Fill in the states and memory that fit the times in `y` best: least squares.

    What remains is linear in them, and there are more equations; each is scaled to a largest
    coefficient of 1.
    """
    unknown = KEPT - KEPT_DURATIONS - (1 if KEPT_FORCED else 0)
    if unknown == 0:
        return
    R, J = np.empty(KEPT), np.empty((KEPT, KEPT))
    y[:unknown] = 0.0
    condensed_residual(work, y, R)
    condensed_jacobian(work, y, J)
    for i in range(KEPT):
        largest = 0.0
        for j in range(unknown):
            largest = max(largest, abs(J[i, j]))
        factor = 1.0 / largest if largest > 0 else 1.0
        for j in range(unknown):
            J[i, j] *= factor
        J[i, unknown] = -factor * R[i]
    least_squares(J, unknown, y)


def iterate_condensed(case: Any, z: Vector, limit: int) -> tuple[int, int, float, float]:
    """Solve ``residual(case, z) = 0`` from the times in `z`, which is overwritten.

    See `iteration.iterate_scene`; the norm returned is that of the whole residual.
    """
    before(case, z)
    work, y = workplace(case, z), np.empty(KEPT)
    places = kept_places(z)
    for i in range(KEPT):
        y[i] = z[places[i]]
    fitted(work, y)
    status, iterations, correction, _ = iterate_scene(work, y, limit)
    complete(work)
    for i in range(KEPT):
        z[places[i]] = y[i]
    after(case, z)
    R = np.empty(len(z))
    residual(case, z, R)
    norm = 0.0
    for value in R:
        if abs(value) > norm or np.isnan(value):
            norm = abs(value)
    return status, iterations, correction, norm
