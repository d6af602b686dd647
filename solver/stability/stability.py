"""The multipliers of an orbit, whether it is stable, and how far it is from the boundary."""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Complex
from ..scenes.cell import Cell
from .cell_map import lasting
from .monodromy import Monodromy, NoMultipliersError, monodromy

if TYPE_CHECKING:
    from ..orbit.motion import Motion

#: Rounding errors of the monodromy's entries, as parts of `Monodromy.size`: those of the times
#: and states that Newton's method left are in them.
ROUNDING = 1e-12

#: Rounding errors of the equations, as a part of those of the monodromy.
OF_EQUATIONS = 1e-3

#: How far from an eigenvalue an iteration for its vectors is, as a part of the way to the next;
#: its steps, each of which gains as much.
BESIDE, ITERATIONS = 1e-6, 2


@dataclass(frozen=True)
class Stability:
    """What one whole period of an orbit makes of small perturbations.

    Parameters
    ----------
    multipliers : ndarray of complex
        The largest first; that of a shift in time along an autonomous orbit is left out.
    trivial_multiplier : float or None
        That of the shift: 1 but for errors; None where a forcing fixes the time.
    rounding : float
        What rounding may change of the largest modulus.
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
        """Whether perturbations die out; None where rounding does not let it be told."""
        return None if abs(self.margin) <= self.rounding else self.margin > 0


def stability(motion: "Motion") -> Stability:
    """Return the multipliers of an orbit, at its own times and states.

    Raises
    ------
    NoMultipliersError
        If there are none, or a check of the computation failed; with the reason in words.
    """
    return of_monodromy(motion.case.cell, monodromy(motion))


def is_stable(motion: "Motion") -> bool | None:
    """Return whether a motion is stable; None where that cannot be told."""
    try:
        return motion.stable
    except NoMultipliersError:
        return None


def of_monodromy(cell: Cell, found: Monodromy) -> Stability:
    """Return the multipliers of an orbit by the monodromy of its cell."""
    own = _eigenvalues(found)
    twice = cell.cells == 2  # the second half is the mirror image of the first
    values, left = own**2 if twice else own, list(range(len(own)))
    trivial = None
    if not cell.forced:
        which = int(np.argmin(np.abs(values - 1)))
        trivial = float(values[which].real)
        left.remove(which)
    left.sort(key=lambda j: (-abs(values[j]), -values[j].imag))
    rounding = _rounding(found, own, left[0]) if left else 0.0
    near = abs(cell.sign * own[left[0]] - 1) if left else 1.0
    if near**2 <= OF_EQUATIONS * rounding:  # at a fold the orbit itself is off by its root
        rounding = max(rounding, float(near))
    if twice and left:
        rounding = 2 * float(np.abs(own[left[0]])) * rounding + rounding**2
    return Stability(values[left], trivial, rounding)


def _eigenvalues(found: Monodromy) -> Complex:
    """Return the eigenvalues of a cell's monodromy.

    What a phase or a switch forgets has a multiplier of 0, which is set, not computed; so has
    what dies out in a cell.
    """
    values = np.zeros(len(found.matrix), dtype=complex)
    if found.forgotten >= len(values) - 1:  # at most one is left: the trace
        values[: len(values) - found.forgotten] = np.trace(found.matrix)
        return values
    lasts = lasting(found.matrix)
    values[: len(lasts)] = np.linalg.eigvals(found.matrix[np.ix_(lasts, lasts)])
    values[np.argsort(np.abs(values))[: found.forgotten]] = 0.0
    return values


def _rounding(found: Monodromy, values: Complex, j: int) -> float:
    """Return what rounding may change of an eigenvalue.

    An error of the matrix shifts it by what the eigenvectors on both sides make of it; a double
    one that has a single eigenvector by its root.
    """
    if values[j] == 0:
        return 0.0
    if found.forgotten >= len(values) - 1:
        return ROUNDING * float(np.trace(found.size))
    moved = ROUNDING * math.hypot(*found.size.ravel())  # squares of 1e-200 would be 0
    distance = np.abs(np.delete(values, j) - values[j]).min(initial=np.inf)
    if distance <= np.sqrt(moved):
        return float(np.sqrt(moved))
    near = values[j] + min(moved, BESIDE * distance)
    inverse = np.linalg.inv(found.matrix - near * np.eye(len(values)))
    across = along = np.cos(np.arange(1.0, 1 + len(values)))  # of no symmetry
    for _ in range(ITERATIONS):
        across, along = across @ inverse, inverse @ along
        across, along = across / np.abs(across).max(), along / np.abs(along).max()
    shared = abs(across @ along)
    return ROUNDING * float(np.abs(across) @ found.size @ np.abs(along)) / float(shared)
