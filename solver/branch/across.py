"""Orbits beyond an event, or a place where no step succeeds, in the order of a motion there.

Such an orbit is not taken if its branch, followed back, comes to an event elsewhere first.
"""

from .events.locate import Found
from .follow import Segment, follow
from .orders.change import moved_on
from .piece import Piece
from .place import Place

#: Most orbits followed back to an event, about.
FEW = 16

#: How near to that place an event must be, as a part of the range of the parameter.
CLOSE = 1e-8


def after(event: Found, part: float) -> tuple[Piece, Place] | None:
    """Return an orbit beyond an event in the order of phases of a motion; None without one."""
    orbit = moved_on(event)
    if orbit is None:
        return None
    before = followed_back(orbit, part).end
    return orbit if before is None or _is_at(before, event.value) else None


def across(segment: Segment, part: float) -> tuple[Piece, Place] | None:
    """Return an orbit beyond the end of a segment, to which the event there is added.

    No step leads there, as several phases vanish at once.  None without one.
    """
    piece, place = segment.points[-1]
    orbit = moved_on(Found("", None, None, piece, place))
    event = None if orbit is None else followed_back(orbit, part).end
    if event is None or not _is_at(event, piece.value(place.y)):
        return None
    segment.events.append(event)
    segment.why = event.kind
    return orbit


def _is_at(event: Found, value: float) -> bool:
    """Whether an event is at a value of the parameter."""
    low, high = event.piece.bounds
    return abs(event.value - value) <= CLOSE * (high - low)


def followed_back(orbit: tuple[Piece, Place], part: float) -> Segment:
    """Return the orbits before one, up to an event, if that is near."""
    piece, place = orbit
    turned = piece, piece.place(place.y, -place.tangent)
    back = Segment([turned])
    follow(back, turned, part, most=FEW)
    return back
