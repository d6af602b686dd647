"""All branches of a case: of orbits that are found at some values, and those beside them."""

from collections.abc import Callable, Container, Iterable, Iterator, Sequence
from contextlib import suppress

import numpy as np

from ..exact import exact_orbit, settled_orbits
from ..existence.known import are_one, known_orbits
from ..existence.reasons import WithoutSwitches, motions_without_switches
from ..no_orbit import NoOrbit
from ..orbit.exact_orbit import ExactOrbit
from ..scenes.case import Case, index_of
from ..scenes.loaded import UnknownScene
from ..scenes.ordered import OrderedScene
from ..scenes.parameter_error import ParameterError
from .branch import BothWays, Bounds, go, lasts_at, orbits_at, start_of
from .follow import TWICE
from .orders.change import doubled
from .piece import Piece
from .place import Place

#: Differences of values at which branches meet, as parts of them, that are one.
NEAR = 1e-5

Seen = Callable[[float], None]

#: What a branch may begin with.
Start = ExactOrbit | WithoutSwitches


def every_way(
    case: Case, parameter: str, bounds: Bounds, values: int, beside: Container[str],
    progress: Seen = lambda value: None, least: float = 0.0,
) -> Iterator[BothWays]:  # fmt: skip
    """Yield the branches of all orbits that are found at so many values, each when followed.

    Then those that begin at events of the kinds `beside`: of twice the period at a flip, and
    without its symmetry where an orbit loses it.  For `least` see `go`.
    """
    earlier: list[BothWays] = []
    for value, start in _starts(case, parameter, map(float, np.linspace(*bounds, values))):
        if any(_is_on(followed, start, value) for followed in earlier):
            continue
        followed = BothWays(index_of(case, parameter))
        with suppress(ArithmeticError):  # it is not isolated
            begun = start_of(start, followed.index, bounds)
            go(followed, begun, progress=progress, least=least)
            earlier.append(followed)
            yield followed
    met = [value for followed in earlier for value in _met(followed)]
    for followed in tuple(earlier):
        for other in _doubled(followed, beside, met, earlier, progress, least):
            earlier.append(other)
            yield other


def _met(followed: BothWays) -> list[float]:
    """Return the values at which a branch meets that of orbits of half the period."""
    events, ends = followed.events(), zip((0, -1), followed.why(), strict=True)
    return [events[i].value for i, why in ends if why == TWICE]


def _starts(
    case: Case, parameter: str, values: Iterable[float]
) -> Iterator[tuple[float, Start]]:
    """Yield the orbits that are found at some values, then the motions without switches."""
    cases = []
    for value in values:
        with suppress(ParameterError):  # there is no such oscillator
            cases.append((value, case.with_value(parameter, value)))
    for find in (_orbits, motions_for_ever):
        for value, at_value in cases:
            yield from ((value, start) for start in find(at_value))


def _is_on(followed: BothWays, start: Start, value: float) -> bool:
    """Whether an orbit or a motion without switches is on a branch."""
    if isinstance(start, WithoutSwitches):
        return lasts_at(followed, start.phase, value)
    return any(are_one(start, other) for other in orbits_at(followed, value))


def motions_for_ever(case: Case) -> list[WithoutSwitches]:
    """Return the motions of a case without switches; none if orbits of another kind are meant.

    Such are those of a given order of phases, or of several periods of the forcing.
    """
    any_order = not isinstance(case.scene, OrderedScene) and case.cycles == 1
    return motions_without_switches(case) if any_order else []


def _doubled(
    parent: BothWays, kinds: Container[str], met: Sequence[float], known: Sequence[BothWays],
    progress: Seen, least: float,
) -> Iterator[BothWays]:  # fmt: skip
    """Yield the branches at the flips of another, and where symmetry is lost on it.

    Left out are those at the values `met` at which they are known, and those of orbits that
    are on `known` branches.
    """
    met = list(met)
    for event in parent.events():
        begins = event.kind in kinds and event.monitor >= 0
        if not begins or any(abs(end - event.value) <= NEAR * abs(end) for end in met):
            continue
        start = None
        with suppress(ArithmeticError, ParameterError, UnknownScene):
            start = doubled(event)
        if start is not None and not _is_known(known, *start):
            followed = BothWays(parent.index, start[0].course)
            go(followed, start, progress=progress, least=least)
            met += [each.value for each in followed.events()]
            yield followed


def _is_known(known: Iterable[BothWays], piece: Piece, place: Place) -> bool:
    """Whether an orbit is on one of some branches."""
    orbit, value = piece.orbit(place.y), piece.value(place.y)
    return orbit is not None and any(_is_on(followed, orbit, value) for followed in known)


def _orbits(case: Case) -> list[ExactOrbit]:
    """Return the orbits of a case that are known, and others on which simulations settle.

    Else one that is found; none if it is none.
    """
    orbits: list[ExactOrbit] = []
    with suppress(NoOrbit, ParameterError):
        orbits = known_orbits(case)
        for orbit in settled_orbits(case, as_declared=True) if orbits else [exact_orbit(case)]:
            if not any(are_one(orbit, other) for other in orbits):
                orbits.append(orbit)
    return orbits
