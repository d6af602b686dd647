"""Whether a phase passes its event before its end.

A demand whose form is the event keeps it from being met early.  Without such a demand, the
event function is followed through its critical points.  Where it changes sign before the end,
the phase ends there if the velocity jumps, or if the phase that follows can begin.  Else the
event is crossed in the other direction, as by a mass that returns through the place where it
left a spring.
"""

from functools import partial

import numpy as np

from ..arrays import Vector
from ..bodies.laws import places, under
from ..scenes.bodies.cell import BodyCell
from . import chebyshev
from .forms import scale_of, value, value_at
from .motion import Motion
from .transients import cuts

#: Halvings of the interval in which a sign changes.
HALVINGS = 60


def met_before(orbit: Motion, p: int, allowed: float) -> float | None:
    """Return the local time of the first event before the end of a phase; None without one.

    Parameters
    ----------
    p : int
        A phase of the cell; none of its demands has the form of its event.
    allowed : float
        Values of the event function that count as 0, relative to its scale.
    """
    for before, after in _changes(orbit, p, allowed):
        u = _between(orbit, p, before, after)
        if _is_a_switch(orbit, p, u, allowed):
            return u
    return None


def _changes(orbit: Motion, p: int, allowed: float) -> list[tuple[float, float]]:
    """Return intervals at whose ends the event function has different signs."""
    form = orbit.cell.phases[p].event
    scale = scale_of(orbit, p, form)
    if not np.isfinite(scale):
        return []
    parts = chebyshev.pieces(partial(value, orbit, p, form), scale, cuts(orbit, p))
    points = np.sort(chebyshev.candidates(parts))
    values = value(orbit, p, form, points)
    clear = np.flatnonzero(np.abs(values) > allowed * scale)
    sides = np.sign(values[clear])
    changes = np.flatnonzero(sides[:-1] != sides[1:])
    return [(float(points[clear[i]]), float(points[clear[i + 1]])) for i in changes]


def _between(orbit: Motion, p: int, before: float, after: float) -> float:
    """Return the root of the event function in an interval, by bisection."""
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
    """Return whether a phase ends at local time `u`, at which its event function vanishes."""
    phase = orbit.cell.phases[p]
    for _, form in phase.switch_demands:
        if value_at(orbit, p, form, u) < -allowed * scale_of(orbit, p, form):
            return False
    return (phase.rho, phase.d) != (1, 0) or _begins(orbit, p, u, allowed)


def _begins(orbit: Motion, p: int, u: float, allowed: float) -> bool:
    """Return whether the phase after `p` can begin at local time `u` of phase `p`.

    Its demands must hold; one that is 0 must not decrease, where its rate is known.
    """
    q = (p + 1) % len(orbit.cell.phases)
    signals, rates, unknown = _after_switch(orbit, p, q, u)
    of = q if isinstance(orbit.cell, BodyCell) else p  # forces may vanish before the switch
    for _, form in orbit.cell.phases[q].demands:
        demand = float(np.dot(form, signals))
        if abs(demand) <= allowed * scale_of(orbit, of, form):
            demand = 0.0 if any(form[j] for j in unknown) else float(np.dot(form, rates))
        if demand < 0:
            return False
    return True


def _after_switch(orbit: Motion, p: int, q: int, u: float) -> tuple[Vector, Vector, list[int]]:
    """Return the signals with which phase `q` would begin at local time `u` of phase `p`.

    Then their rates, and the indices of signals whose rate is not known.
    """
    cell, at = orbit.cell, np.array([u])
    signals, sign = orbit.signals(p, at)[:, 0], 1 if q else cell.sign
    cosine_rate = -sign * cell.omega * float(np.sin(orbit.angle_at(p, at))[0])
    if isinstance(cell, BodyCell):
        signals = under(cell, cell.phases[q], signals, sign)
        x, v, force, a = places(cell.body.at.shape[1])
        rates = np.zeros(len(signals))
        rates[x], rates[v], rates[2] = signals[v], signals[a], cosine_rate
        return signals, rates, [*force, *a]
    x, v, cosine = sign * signals[:3]
    rates = np.array([v, cell.phases[q].acceleration(x, v, cosine), cosine_rate, 0.0])
    return np.array([x, v, cosine, 1.0]), rates, []
