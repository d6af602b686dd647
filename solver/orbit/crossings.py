"""Whether a phase would have ended before its end: its event, met on the way.

A demand that ends with a phase keeps its event from being met earlier.  Where none does, the
event is followed through its critical points.  Where it changes its sign on the way, the phase
ends there if the velocity jumps at it, or if the phase that follows can begin: else the event
is crossed from beyond, as by a mass that comes back through the place where it left a spring.
"""

from functools import partial

import numpy as np

from ..arrays import Vector
from ..bodies.laws import places, under
from ..scenes.bodies.cell import BodyCell
from . import chebyshev
from .forms import scale_of, value, value_at
from .motion import Motion

#: Halvings of the interval in which a sign changes.
HALVINGS = 60


def met_before(orbit: Motion, p: int, allowed: float) -> float | None:
    """Return the local time at which a phase would end before its end, if there is one.

    Parameters
    ----------
    p : int
        A phase of its cell with no demand that ends with it.
    allowed : float
        What its event may be beyond 0, as a part of its scale.
    """
    for before, after in _changes(orbit, p, allowed):
        u = _between(orbit, p, before, after)
        if _is_a_switch(orbit, p, u, allowed):
            return u
    return None


def _changes(orbit: Motion, p: int, allowed: float) -> list[tuple[float, float]]:
    """Return the intervals in which the event changes its sign for more than rounding."""
    form = orbit.cell.phases[p].event
    scale = scale_of(orbit, p, form)
    if not np.isfinite(scale):
        return []
    parts = chebyshev.pieces(partial(value, orbit, p, form), scale)
    points = np.sort(chebyshev.candidates(parts))
    values = value(orbit, p, form, points)
    kept = np.flatnonzero(np.abs(values) > allowed * scale)
    sides = np.sign(values[kept])
    turns = np.flatnonzero(sides[:-1] != sides[1:])
    return [(float(points[kept[i]]), float(points[kept[i + 1]])) for i in turns]


def _between(orbit: Motion, p: int, before: float, after: float) -> float:
    """Return where the event vanishes between two places of different sign."""
    form = orbit.cell.phases[p].event
    sign = np.sign(value_at(orbit, p, form, before))
    for _ in range(HALVINGS):
        middle = (before + after) / 2
        if np.sign(value_at(orbit, p, form, middle)) == sign:
            before = middle
        else:
            after = middle
    return after


def _is_a_switch(orbit: Motion, p: int, u: float, allowed: float) -> bool:
    """Return whether the phase would end where its event vanishes on the way."""
    phase = orbit.cell.phases[p]
    for _, form in phase.switch_demands:
        if value_at(orbit, p, form, u) < -allowed * scale_of(orbit, p, form):
            return False
    return (phase.rho, phase.d) != (1, 0) or _begins(orbit, p, u, allowed)


def _begins(orbit: Motion, p: int, u: float, allowed: float) -> bool:
    """Return whether the phase that follows can begin at a local time of phase `p`.

    What it demands of the force on a body is looked at where it is not near its limit alone.
    """
    q = (p + 1) % len(orbit.cell.phases)
    seen, rates, unknown = _behind(orbit, p, q, u)
    of = q if isinstance(orbit.cell, BodyCell) else p  # forces may vanish before the switch
    for _, form in orbit.cell.phases[q].demands:
        found = float(np.dot(form, seen))
        if abs(found) <= allowed * scale_of(orbit, of, form):
            found = 0.0 if any(form[j] for j in unknown) else float(np.dot(form, rates))
        if found < 0:
            return False
    return True


def _behind(orbit: Motion, p: int, q: int, u: float) -> tuple[Vector, Vector, list[int]]:
    """Return what forms are of where phase `q` would begin, at a local time of phase `p`.

    Then how fast each changes, and of which of them that is not known.
    """
    cell, at = orbit.cell, np.array([u])
    seen, sign = orbit.signals(p, at)[:, 0], 1 if q else cell.sign
    turned = -sign * cell.omega * float(np.sin(orbit.angle_at(p, at))[0])
    if isinstance(cell, BodyCell):
        seen = under(cell, cell.phases[q], seen, sign)
        x, v, force, a = places(cell.body.at.shape[1])
        rates = np.zeros(len(seen))
        rates[x], rates[v], rates[2] = seen[v], seen[a], turned
        return seen, rates, [*force, *a]
    x, v, wave = sign * seen[:3]
    rates = np.array([v, cell.phases[q].acceleration(x, v, wave), turned, 0.0])
    return np.array([x, v, wave, 1.0]), rates, []
