"""Beyond a place next to which no step of a branch succeeds, as several phases vanish there."""

from .events.locate import Found
from .follow import Segment, follow
from .orders.change import moved_on
from .piece import Piece
from .place import Place

#: Most orbits followed back to an event, about.
FEW = 16

#: How near to the last orbit the event must be, as a part of the range of the parameter.
CLOSE = 1e-4


def across(segment: Segment, part: float) -> tuple[Piece, Place] | None:
    """Return an orbit beyond the end of a segment, to which the event there is added.

    The event is that at which the orbits beyond end, followed back.  None without one.
    """
    piece, place = segment.points[-1]
    orbit = moved_on(Found("", None, None, piece, place))
    if orbit is None:
        return None
    back = followed_back(orbit, part)
    close = CLOSE * (piece.bounds[1] - piece.bounds[0])
    if back.end is None or abs(back.end.value - piece.value(place.y)) > close:
        return None
    segment.events.append(back.end)
    segment.why = back.end.kind
    return orbit


def followed_back(orbit: tuple[Piece, Place], part: float) -> Segment:
    """Return the orbits before one, up to an event, if that is near."""
    piece, place = orbit
    turned = piece, piece.place(place.y, -place.tangent)
    back = Segment([turned])
    follow(back, turned, part, most=FEW)
    return back
