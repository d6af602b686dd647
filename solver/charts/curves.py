"""Curves of events in the plane of two parameters, each followed in both directions."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from ..arrays import Indices, Vector
from ..branch.events.locate import TURNED
from ..branch.follow import CLOSED, RANGE
from ..branch.walk import FOLD, MEETS, OUTSIDE, OWN, PAIRS
from ..stability.stability import stability
from .block import by
from .lines import Happening
from .plane import Plane

#: Least, first and largest step, in scaled coordinates; largest step in the plane.
LEAST, FIRST, MOST, MOST_SEEN = 1e-5, 0.01, 0.3, 0.03

#: The factor by which steps grow; least cosine of the angle between tangents of a step.
GROWTH, TURN = 1.3, 0.95

#: Most points of a curve in each direction.
MOST_POINTS = 1000

#: Other monitors are violated below the negative of this.
ROUNDING = 1e-6

#: Distance from a curve, in the plane, of an event that lies on it.
ON = 1e-8

#: Why a curve ends, beside the reasons of a branch.
LOST, VIOLATED = "beyond, no such event is found", "beyond, its orbits are not admissible"
REAL = "beyond, the multipliers whose product is 1 are real"

#: Monitors that vanish on a curve in place of those at an event of a branch; and that of a
#: pair of multipliers.  Both are counted from the last.
TORUS = PAIRS - OWN
ON_CURVE = {FOLD - OWN: MEETS - OWN, OUTSIDE - OWN: TORUS}


@dataclass(frozen=True, eq=False)
class Curve:
    """A curve of events: orbits of a plane on which a monitor vanishes; see `monitors_at`.

    Its points are unknowns and both parameters; `why` has the reasons of both ends.
    """

    kind: str
    plane: Plane
    monitor: int
    points: tuple[Vector, ...]
    why: tuple[str, str]


def curves_of(happened: Iterable[Happening], planes: Sequence[Plane]) -> list[Curve]:
    """Return the curves on which events lie, each once."""
    curves: list[Curve] = []
    for event in happened:
        plane = next((q for q in planes if q.course == event.course), None)
        monitor = None if plane is None else _monitor_of(plane, event)
        if plane is None or monitor is None:
            continue
        y = plane.inside(event.point[None])[0]
        if not any(_passes(q, event.kind, y[-2:], event.across) for q in curves):
            curves += _followed(event.kind, plane, monitor, y, event.across)
    return curves


def _monitor_of(plane: Plane, event: Happening) -> int | None:
    """Return which monitor of a plane vanishes at an event; None without such a one."""
    row, number = event.monitor
    if row is None:
        return ON_CURVE.get(number, number)
    return 3 * plane.rows.index(row) + number if row in plane.rows else None


def _followed(kind: str, plane: Plane, monitor: int, y: Vector, across: int) -> list[Curve]:
    """Return the curve through an event; none if it cannot be followed at all."""
    first, direction, monitors = _pinned(plane, monitor, y, np.eye(len(y))[across - 2])
    if first is None:
        return []
    watched = ~(np.abs(monitors) <= ROUNDING)  # else there is none as yet
    watched[-OWN:], watched[monitor] = False, False
    forth, why = _way(plane, monitor, watched, first, direction)
    if why == CLOSED:
        return [Curve(kind, plane, monitor, (first, *forth, first), (why, why))]
    back, before = _way(plane, monitor, watched, first, -direction)
    points = (*reversed(back), first, *forth)
    return [Curve(kind, plane, monitor, points, (before, why))] if len(points) > 1 else []


def _way(
    plane: Plane, monitor: int, watched: Indices, y: Vector, direction: Vector
) -> tuple[list[Vector], str]:
    """Return the points of a curve from y on in a direction, and why it ends.

    It ends where one of the `watched` monitors is negative.
    """
    start, ahead, weights = y, direction, np.append(plane.series.weights, 1.0)
    points: list[Vector] = []
    length, growth, why = FIRST, GROWTH, LOST
    while len(points) < MOST_POINTS:
        visible = float(np.abs(direction[-2:]).max())
        length = min(length, MOST, MOST_SEEN / visible if visible else MOST)
        ahead_of_y = y + length * direction / weights
        point, tangent, monitors = _pinned(plane, monitor, ahead_of_y, direction)
        accepted = point is not None and tangent @ direction >= TURN
        if point is not None and accepted:
            if np.abs(point[-2:]).max() > 1:
                end = _edge(plane, monitor, y, point)
                return ([*points, end], RANGE) if end is not None else (points, LOST)
            if (monitors[watched] < -ROUNDING).any():
                accepted, growth, why = False, 1.0, VIOLATED
            elif monitor == TORUS and not _turns(plane, point):
                accepted, growth, why = False, 1.0, REAL
        if point is None or not accepted:
            length /= 2
            if length < LEAST:
                return points, why
            continue
        offset = (start - y) * weights
        is_near = 0 <= offset @ direction <= length >= np.linalg.norm(offset)
        if len(points) > 2 and is_near and tangent @ ahead > 0:
            return points, CLOSED
        points.append(point)
        y, direction, length = point, tangent, length * growth
    return points, f"{MOST_POINTS} points are the most that a curve has each way"


def _turns(plane: Plane, y: Vector) -> bool:
    """Whether the two multipliers whose product is 1 are complex."""
    orbit = plane.orbit(y)
    if orbit is None:
        return False
    values = np.array(stability(orbit).multipliers)
    row, column = np.tril_indices(len(values), -1)
    nearest = int(np.argmin(np.abs(values[row] * values[column] - 1)))
    return bool(abs(values[row[nearest]].imag) > TURNED)


def _edge(plane: Plane, monitor: int, y: Vector, y_outside: Vector) -> Vector | None:
    """Return where a step leaves the rectangle; None if it is not found."""
    ends = np.sign(y_outside[-2:])
    with np.errstate(divide="ignore", invalid="ignore"):  # along an edge, or straight across
        parts = (ends - y[-2:]) / (y_outside[-2:] - y[-2:])
    parts[np.abs(y_outside[-2:]) <= 1] = np.inf
    index = int(np.argmin(parts))
    start = y + parts[index] * (y_outside - y)
    start[index - 2] = ends[index]
    return _pinned(plane, monitor, start, np.eye(len(y))[index - 2])[0]


def _passes(curve: Curve, kind: str, at: Vector, across: int) -> bool:
    """Whether an event lies on a curve: where the curve crosses the line of the event."""
    points, along = np.array(curve.points), 1 - across - 2
    side = points[:, across - 2] - at[across]
    crosses = (side[1:] * side[:-1] <= 0) | (np.minimum(abs(side[1:]), abs(side[:-1])) <= ON)
    for i in np.flatnonzero(crosses) if kind == curve.kind else ():
        change = side[i + 1] - side[i]
        part = np.clip(-side[i] / change, 0, 1) if change else 0.0
        y = points[i] + part * (points[i + 1] - points[i])
        y[across - 2] = at[across]
        distance = abs(y[along] - at[1 - across])
        if distance <= ON:
            return True
        if distance > MOST_SEEN:
            continue
        point, *_ = _pinned(curve.plane, curve.monitor, y, np.eye(len(y))[across - 2])
        if point is not None and abs(point[along] - at[1 - across]) <= ON:
            return True
    return False


def _pinned(
    plane: Plane, monitor: int, y: Vector, border: Vector
) -> tuple[Vector | None, Vector, Vector]:
    """Return the point on a curve orthogonal to a border, or None; tangent, monitors there.

    The unit vector of a parameter is a border that fixes it.
    """
    count = 3 * len(plane.rows) + len(plane.series.kinds) + OWN
    point = y.copy()
    converged, *others = by("pinned", plane, monitor % count, point, border)
    return (point if converged else None), *others
