"""Where a phase is cut, so that interpolation sees transients that are short against it."""

from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Vector
from ..bodies.part import parts_of
from ..bodies.systems import BodyError
from ..flow import flow
from ..scenes.bodies.cell import BodyCell
from ..scenes.cell import Cell

if TYPE_CHECKING:
    from .motion import Motion

#: Decays by a factor e in a phase beyond which a transient may pass between the first nodes of
#: an interpolant: what is left of it there is too small to be told from rounding.
FAST = 50.0

#: Decays after which nothing is left of it.
GONE = 40.0


def cuts(motion: "Motion", p: int) -> Vector:
    """Return the local times, in (0, 1), at which phase `p` is cut: the shortest parts first.

    Each is twice as far from the start as the one before, from one decay of the fastest
    transient to `GONE` of the slowest that is `FAST`.  Where a transient grows, from the end.

    Examples
    --------
    >>> from nonsmooth.solver.exact import exact_orbit
    >>> from nonsmooth.solver.kernels import registry
    >>> light, heavy = (registry.load("dry-friction")(damping=c) for c in (0.2, 1e4))
    >>> [len(cuts(exact_orbit(case), 0)) for case in (light, heavy)]
    [0, 7]
    """
    rates = -_roots(motion.case.cell, p).real * float(motion.cell_durations[p])
    return np.sort(np.concatenate([_from_start(rates), 1 - _from_start(-rates)]))


def _from_start(rates: Vector) -> Vector:
    """Return the cuts for transients that decay at these rates."""
    fast = rates[rates > FAST]
    if not len(fast) or not np.isfinite(fast).all():
        return np.empty(0)
    first, last = 1 / fast.max(), GONE / fast.min()
    times = first * 2.0 ** np.arange(np.ceil(np.log2(last / first)) + 1)
    return np.asarray(times[times < 1.0])


def _roots(cell: Cell, p: int) -> Vector:
    """Return the roots of the equation of a phase; none if it is held, or not known."""
    if isinstance(cell, BodyCell):
        try:
            return np.asarray(parts_of(cell)[p].flow.poles)
        except BodyError:  # said where its motion is computed
            return np.empty(0, dtype=complex)
    phase = cell.phases[p]
    return np.array([] if phase.held else flow.roots(phase), dtype=complex)
