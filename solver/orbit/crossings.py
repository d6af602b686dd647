"""Whether a phase would have ended before its end: its event, met on the way.

A demand that ends with a phase keeps its event from being met earlier.  Where none does, the
event is followed through its critical points.  Where it changes its sign on the way, the phase
ends there if the velocity jumps at it, or if the phase that follows can begin: else the event
is crossed from beyond, as by a mass that comes back through the place where it left a spring.
"""

import numpy as np

from ..arrays import Vector
from ..bodies.laws import places, under
from ..scenes.bodies.cell import BodyCell
from ..scenes.cell import Form
from . import chebyshev
from .forms import scale_of, terms
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
    points = chebyshev.candidates(chebyshev.pieces(lambda u: _value(orbit, p, form, u), scale))
    points = np.sort(points)
    values = _value(orbit, p, form, points)
    kept = np.flatnonzero(np.abs(values) > allowed * scale)
    sides = np.sign(values[kept])
    turns = np.flatnonzero(sides[:-1] != sides[1:])
    return [(float(points[kept[i]]), float(points[kept[i + 1]])) for i in turns]


def _value(orbit: Motion, p: int, form: Form, u: Vector) -> Vector:
    return np.asarray(terms(orbit, p, form, u).sum(axis=0))


def _between(orbit: Motion, p: int, before: float, after: float) -> float:
    """Return where the event vanishes between two places of different sign."""
    form = orbit.cell.phases[p].event
    sign = np.sign(_value(orbit, p, form, np.array([before])))
    for _ in range(HALVINGS):
        middle = (before + after) / 2
        if np.sign(_value(orbit, p, form, np.array([middle]))) == sign:
            before = middle
        else:
            after = middle
    return after


def _is_a_switch(orbit: Motion, p: int, u: float, allowed: float) -> bool:
    """Return whether the phase would end where its event vanishes on the way."""
    cell, phase, at = orbit.cell, orbit.cell.phases[p], np.array([u])

    def holds(form: Form, value: float) -> bool:
        return value >= -allowed * scale_of(orbit, p, form)

    if not all(holds(f, float(_value(orbit, p, f, at)[0])) for _, f in phase.switch_demands):
        return False
    if (phase.rho, phase.d) != (1, 0):
        return True
    last = p == len(cell.phases) - 1
    sign, following = (cell.sign if last else 1), cell.phases[0 if last else p + 1]
    if isinstance(cell, BodyCell):
        return _begins(orbit, p, u, allowed)
    begun = np.sum(orbit.cell_durations[:p]) + u * orbit.cell_durations[p]
    angle = orbit.angle + cell.omega * float(begun)
    x, v = (sign * float(orbit.part(p, at, j)[0]) for j in (0, 1))
    wave, turned = sign * np.cos(angle), -sign * cell.omega * np.sin(angle)
    a = following.acceleration(x, v, wave)
    for _, form in following.demands:
        value = float(np.dot(form, (x, v, wave, 1.0)))
        near = abs(value) <= allowed * scale_of(orbit, p, form)
        rate = float(np.dot(form[:3], (v, a, turned)))
        if (rate if near else value) < 0:
            return False
    return True


def _begins(orbit: Motion, p: int, u: float, allowed: float) -> bool:
    """Return whether the phase that follows in a body can begin at a local time of phase `p`.

    What it demands of its force is looked at where it is not near its limit alone.
    """
    cell, count = orbit.cell, len(orbit.cell.phases)
    assert isinstance(cell, BodyCell)
    q, sign = (p + 1, 1) if p + 1 < count else (0, cell.sign)
    seen = under(cell, cell.phases[q], orbit.signals(p, np.array([u]))[:, 0], sign)
    x, v, force, a = places(cell.body.at.shape[1])
    rates, angle = (
        np.zeros(len(seen)),
        orbit.angle
        + cell.omega * float(np.sum(orbit.cell_durations[:p]) + u * orbit.cell_durations[p]),
    )
    rates[x], rates[v], rates[2] = seen[v], seen[a], -sign * cell.omega * np.sin(angle)
    for _, form in cell.phases[q].demands:
        value, size = float(np.dot(form, seen)), float(np.abs(form) @ orbit.sizes[q])
        near = abs(value) <= allowed * size
        unknown = any(form[place] for place in (*force, *a))
        if value < 0 and not near:
            return False
        if near and not unknown and float(np.dot(form, rates)) < 0:
            return False
    return True
