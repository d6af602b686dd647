"""The Floquet multipliers of an orbit, its stability, and their rounding errors."""

import math
from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Complex, Matrix
from ..scenes.cell import Cell
from .cell_map import lasting
from .monodromy import forgotten, monodromy

if TYPE_CHECKING:
    from ..orbit.motion import Motion

#: Rounding errors of the monodromy matrix, relative to their scale, with those of the times
#: and states from Newton's method.
ROUNDING = 1e-12

#: Rounding errors of the equations, relative to those of the monodromy matrix.
OF_EQUATIONS = 1e-3

#: Distance of the shift of inverse iteration from an eigenvalue, relative to that of the next
#: eigenvalue; number of iterations, each of which gains this factor.
BESIDE, ITERATIONS = 1e-6, 2


@dataclass(frozen=True)
class Stability:
    """The Floquet multipliers of an orbit over a whole period.

    Parameters
    ----------
    multipliers : ndarray of complex
        The largest first; that of a shift in time along an autonomous orbit is left out.
    trivial_multiplier : float or None
        That of the shift, 1 up to errors; None of a forced orbit.
    rounding : float
        Bound of the rounding error of the largest modulus.
    """

    multipliers: Complex
    trivial_multiplier: float | None
    rounding: float

    @property
    def margin(self) -> float:
        """1 less the largest modulus: positive if the orbit is stable."""
        return 1.0 - float(np.abs(self.multipliers).max(initial=0.0))

    @property
    def stable(self) -> bool | None:
        """Whether perturbations decay; None if the margin is below its rounding error."""
        return None if abs(self.margin) <= self.rounding else self.margin > 0


def stability(motion: "Motion") -> Stability:
    """Return the multipliers of an orbit, at its own times and states.

    Raises
    ------
    NoMultipliersError
        If there are none, or a check of the computation failed; with the reason in words.
    """
    return of_monodromy(motion.case.cell, *monodromy(motion))


def of_monodromy(cell: Cell, matrix: Matrix, size: Matrix) -> Stability:
    """Return the multipliers of an orbit from the monodromy matrix of its cell.

    `size` is the scale of the rounding errors of the matrix.
    """
    lost = forgotten(cell)
    eigenvalues = _eigenvalues(matrix, lost)
    twice = cell.cells == 2  # the second half is the mirror image of the first
    values, remaining = eigenvalues**2 if twice else eigenvalues, list(range(len(eigenvalues)))
    trivial = None
    if not cell.forced:
        index = int(np.argmin(np.abs(values - 1)))
        trivial = float(values[index].real)
        remaining.remove(index)
    remaining.sort(key=lambda j: (-abs(values[j]), -values[j].imag))
    rounding = _rounding(matrix, size, lost, eigenvalues, remaining[0]) if remaining else 0.0
    near = abs(cell.sign * eigenvalues[remaining[0]] - 1) if remaining else 1.0
    if near**2 <= OF_EQUATIONS * rounding:  # near a fold, the orbit's error is a square root
        rounding = max(rounding, float(near))
    if twice and remaining:
        rounding = 2 * float(np.abs(eigenvalues[remaining[0]])) * rounding + rounding**2
    return Stability(values[remaining], trivial, rounding)


def _eigenvalues(matrix: Matrix, lost: int) -> Complex:
    """Return the eigenvalues of the monodromy matrix of a cell.

    Those that are 0, for `lost` parts of the state that are forgotten, and others that decay
    within a cell, are set and not computed.
    """
    values = np.zeros(len(matrix), dtype=complex)
    if lost >= len(values) - 1:  # at most one is left: the trace
        values[: len(values) - lost] = np.trace(matrix)
        return values
    lasts = lasting(matrix)
    values[: len(lasts)] = np.linalg.eigvals(matrix[np.ix_(lasts, lasts)])
    values[np.argsort(np.abs(values))[:lost]] = 0.0
    return values


def _rounding(matrix: Matrix, size: Matrix, lost: int, values: Complex, j: int) -> float:
    """Return a first-order bound of the rounding error of eigenvalue j.

    ``|l| |E| |r| / |l r|`` with left and right eigenvectors l, r and the error E of the matrix;
    for a nearly double eigenvalue, the square root of the norm of E.
    """
    if values[j] == 0:
        return 0.0
    if lost >= len(values) - 1:
        return ROUNDING * float(np.trace(size))
    error = ROUNDING * math.hypot(*size.ravel())  # squares of 1e-200 would be 0
    distance = np.abs(np.delete(values, j) - values[j]).min(initial=np.inf)
    if distance <= np.sqrt(error):
        return float(np.sqrt(error))
    inverse = _inverse(matrix, values[j], min(error, BESIDE * distance))
    left = right = np.cos(np.arange(1.0, 1 + len(values)))  # without symmetry
    for _ in range(ITERATIONS):
        left, right = left @ inverse, inverse @ right
        left, right = left / np.abs(left).max(), right / np.abs(right).max()
    product = abs(left @ right)
    return ROUNDING * float(np.abs(left) @ size @ np.abs(right)) / float(product)


def _inverse(matrix: Matrix, value: complex, aside: float) -> Complex:
    """Return the inverse of a matrix less a number beside an eigenvalue.

    Farther aside if that is singular: with large entries, an eigenvalue is off by rounding.
    """
    while True:
        with suppress(np.linalg.LinAlgError):
            shift = (value + aside) * np.eye(len(matrix))
            return np.asarray(np.linalg.inv(matrix - shift), dtype=complex)
        aside = max(2 * aside, float(np.finfo(float).tiny))
