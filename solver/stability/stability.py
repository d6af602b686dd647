"""The multipliers of an orbit, whether it is stable, and how far it is from the boundary."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Complex, Vector
from ..scenes.cell import Cell
from .monodromy import Monodromy, monodromy

if TYPE_CHECKING:
    from ..orbit.motion import Motion

#: Rounding errors of the monodromy's entries, as parts of `Monodromy.size`: those of the times
#: and states that Newton's method left are in them.
ROUNDING = 1e-12


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


def of_monodromy(cell: Cell, found: Monodromy) -> Stability:
    """Return the multipliers of an orbit by the monodromy of its cell."""
    values, errors = _eigenvalues(found)
    if cell.cells == 2:  # the second half is the mirror image of the first
        values, errors = values**2, 2 * np.abs(values) * errors + errors**2
    trivial = None
    if not cell.forced:
        which = int(np.argmin(np.abs(values - 1)))
        trivial = float(values[which].real)
        values, errors = np.delete(values, which), np.delete(errors, which)
    order = sorted(range(len(values)), key=lambda j: (-abs(values[j]), -values[j].imag))
    largest = float(errors[order[0]]) if order else 0.0
    return Stability(values[order], trivial, largest)


def _eigenvalues(found: Monodromy) -> tuple[Complex, Vector]:
    """Return the eigenvalues of a cell's monodromy, and what rounding may change of each.

    An error of the matrix shifts an eigenvalue by what the eigenvectors on both sides make of
    it; a double one that has a single eigenvector by its root.  What a phase or a switch
    forgets has a multiplier of 0, which is set, not computed.
    """
    count = len(found.matrix)
    if found.forgotten >= count - 1:  # at most one is left: the trace
        left = np.eye(count)[0] * (found.forgotten < count)
        values = (left * np.trace(found.matrix)).astype(complex)
        return values, left * ROUNDING * float(np.trace(found.size))
    values, right = np.linalg.eig(found.matrix)  # of a real matrix: pairs are exact
    values = np.asarray(values, dtype=complex)
    from_left, left = np.linalg.eig(found.matrix.T)
    errors = np.empty(count)
    zero = np.argsort(np.abs(values))[: found.forgotten]
    for j, value in enumerate(values):
        distance = np.abs(np.delete(values, j) - value).min(initial=np.inf)
        moved = ROUNDING * float(np.linalg.norm(found.size))
        if distance <= np.sqrt(moved):
            errors[j] = np.sqrt(moved)
            continue
        across = left[:, int(np.argmin(np.abs(from_left - value)))]
        shared = abs(across @ right[:, j])
        errors[j] = ROUNDING * float(np.abs(across) @ found.size @ np.abs(right[:, j])) / shared
    values[zero], errors[zero] = 0.0, 0.0
    return values, errors
