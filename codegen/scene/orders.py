"""A scene with its phases in an undeclared order, for its equations.

An order is written as in the solver: names of phases joined by commas, with a minus before the
mirror image of one, and ``mirrored`` at the end if they are half a period.
"""

from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

import sympy as sp

from ...nearest import at_length, numbered, one_of
from .bodies.law import velocities
from .data import Memory, Phase, SceneData, a, forcing, once, v, with_values, x
from .error import SceneError
from .memories import behind, settings

if TYPE_CHECKING:
    from .scene import Scene

#: Last word of an order of half a period; and suffix of the name of a mirrored phase.
MIRRORED, IMAGE = "mirrored", "_m"

#: A phase by its index, and whether it is mirrored.
Place = tuple[int, bool]


class AllPhases(NamedTuple):
    """The phases of all motions of a scene, each once, and where each motion has them.

    Parameters
    ----------
    scene : SceneData
        With the phases of the longest motion, then those that only others have, then those
        that further events end.  One whose name occurs before has a number behind it.
    orders : mapping of str to tuple of Place
        The phases of each motion.  A motion in which another phase sets a memory has none
        here, and its phases may be missing.
    listed : tuple of str
        The name of each phase in the scene.
    """

    scene: SceneData
    orders: Mapping[str, tuple[Place, ...]]
    listed: tuple[str, ...]

    def to(self, p: int) -> tuple[Place, ...]:
        """Return the phases of which one follows phase `p`, if its event says so."""
        name = self.scene.phases[p].ends.to
        named = (q for q, listed in enumerate(self.listed) if listed == name.removeprefix("-"))
        return tuple((q, name.startswith("-")) for q in named)

    def followers(self, p: int) -> list[Place]:
        """Return the phases that motions have behind phase `p`, and whether mirrored.

        First that of the longest motion, whose demands at the switch the phase has.
        """
        found = []
        for places in sorted(self.orders.values(), key=len, reverse=True):
            first = [(q, mirrored != self.scene.half_period) for q, mirrored in places[:1]]
            for (q, mirrored), (after, turned) in pairwise((*places, *first)):
                found += [(after, turned != mirrored)] if q == p else []
        return found


@once
def all_phases(scene: SceneData) -> AllPhases:
    """Return the phases of all motions of a scene.

    Phases are the same, by whatever name, if they have the same law, end and demands.  Demands
    at their switches may differ: they tell what follows.
    """
    declared = scene.declared or {scene.motion: scene.phases}
    (first, longest), *others = sorted(declared.items(), key=lambda each: -len(each[1]))
    phases = [phase.each_end[0] for phase in longest]
    of_one = (q.at for q in scene.memory if isinstance(q.at, str))
    setters = {at: (_index(longest, at), False) for at in of_one}
    orders: dict[str, tuple[Place, ...]] = dict.fromkeys(declared, ())
    orders[first] = tuple((p, False) for p in range(len(phases)))
    for motion, order in others:
        places = [_place(phase, phases, scene) for phase in order]
        if any(places[_index(order, name)] != place for name, place in setters.items()):
            continue
        new = [q for q, place in zip(order, places, strict=True) if place is None]
        numbers = iter(range(len(phases), len(phases) + len(new)))
        orders[motion] = tuple(place or (next(numbers), False) for place in places)
        phases += [phase.each_end[0] for phase in new]
    listed = [phase.name for phase in phases]
    for phase in (phase for order in declared.values() for phase in order):
        for end in phase.each_end[1:]:
            place = _place(end, phases, scene)
            if place is None:
                phases.append(end)
                listed.append(phase.name)
            else:
                _check_to(end, phases[place[0]], place[1])
    names = numbered([phase.name for phase in phases])
    named = tuple(replace(q, name=name) for q, name in zip(phases, names, strict=True))
    values = {field.name: getattr(scene, field.name) for field in fields(SceneData)}
    whole = SceneData(**(values | {"phases": named, "motions": {}, "guess": ()}))
    return AllPhases(whole, orders, tuple(listed))


def _check_to(end: Phase, same: Phase, mirrored: bool) -> None:
    """Check that an event says the same follower as that of the same phase, or its image."""
    expected = same.ends.to
    if mirrored and expected:
        expected = expected[1:] if expected.startswith("-") else f"-{expected}"
    if end.ends.to != expected:
        what = f"as another event of the same phase{', mirrored,' if mirrored else ''} says"
        got = f"got {end.ends.to!r}, expected {expected!r}"
        raise SceneError(f"phase {end.name}: ends: to: {got}, {what}")


def _index(phases: Sequence[Phase], name: str) -> int:
    """Return the index of the phase of an order that has a name."""
    return [phase.name for phase in phases].index(name)


def in_order(scene: "Scene", phases: str) -> "Scene":
    """Return a scene with phases of its motions in another order.

    A phase or a memory that occurs again has a number after its name.

    Raises
    ------
    ValueError
        If there is no such phase, or no such mirror image, or one cannot follow another.

    Examples
    --------
    >>> from nonsmooth.codegen import scenes
    >>> found = in_order(scenes.load("dry-friction"), "slide,stop,-slide,-stop")
    >>> [phase.name for phase in found.phases]
    ['slide', 'stop', 'slide_m', 'stop_m']
    >>> found.phases[2].equation
    -F*forcing + F_N*mu_k + a*m + c*v + k*x
    """
    every = all_phases(scene)
    base = every.scene
    names = at_length(phases)
    motion = ",".join(names)
    half = names[-1:] == [MIRRORED]
    names = names[:-1] if half else names
    steps = [(name.removeprefix("-"), name.startswith("-")) for name in names]
    index = {phase.name: p for p, phase in enumerate(base.phases)}
    for name, minus in steps:
        if name not in index or (minus and not base.half_period):
            got = f"-{name}" if minus else name
            raise ValueError(f"phases: got {got!r}, expected {one_of(name, index)}")
    if half and not (base.half_period or _is_odd(base)):
        raise ValueError(
            f"phases: got {MIRRORED}, but a mirror image is no motion of {base.name}"
        )
    called = numbered([f"{name}{IMAGE}" if minus else name for name, minus in steps])
    places = [(index[name], minus) for name, minus in steps]
    phases_ = [_mirrored(base.phases[q], base) if m else base.phases[q] for q, m in places]

    def value(memory: Memory, p: int) -> sp.Expr:
        if not isinstance(memory.at, str):
            return behind(memory, phases_, p, base, -1 if half else 1)
        own = sp.sympify(memory.value)
        return -own.subs(_image(base)) if _begins_mirrored(every, places, p, half) else own

    listed = [every.listed[q] for q, _ in places]
    memory, substitutions = settings(base.memory, listed, called, value)
    ordered = []
    for p, phase in enumerate(phases_):
        ends = phase.ends
        if not _is_declared(every, places, p, half):
            ends = replace(ends, demands={})
        own = replace(phase, name=called[p], ends=ends)
        ordered.append(with_values(own, substitutions[p]))
    try:
        return replace(
            scene,
            motions={},
            phases=tuple(ordered),
            half_period=half,
            memory=memory,
            motion=motion,
            guess=(),
            start={},
        )
    except SceneError as error:
        raise ValueError(f"phases: got {phases}, which is no order: {error}") from error


def _begins_mirrored(every: AllPhases, steps: Sequence[Place], p: int, half: bool) -> bool:
    """Return whether phase `p` of an order begins as the mirror image of the declared phase.

    A phase with the same equation as its image is mirrored or not by its end.  If it follows a
    declared predecessor, or the image of one, it begins as that one was mirrored.
    """
    (q, minus), (before, mirrored) = steps[p], steps[p - 1]
    behind = [turned for after, turned in every.followers(before) if after == q]
    phase = every.scene.phases[q]
    images = zip(phase.laws, _mirrored(phase, every.scene).laws, strict=True)
    if not behind or any(sp.expand(a - b) for a, b in images):
        return minus
    return mirrored != ((p == 0 and half) != behind[0])


def _is_declared(every: AllPhases, steps: Sequence[Place], p: int, half: bool) -> bool:
    """Return whether behind phase `p` of an order comes what the demands at its end are for."""
    scene, (q, minus) = every.scene, steps[p]
    if not every.followers(q):
        return False
    after, turned = steps[(p + 1) % len(steps)]
    expected, mirrored = every.followers(q)[0]
    if p < len(steps) - 1 or not half or scene.half_period:
        turned ^= half and p == len(steps) - 1
        return (after, turned) == (expected, mirrored != minus)
    return _alike(_mirrored(scene.phases[after], scene), scene.phases[expected], scene)


def _image(scene: SceneData) -> dict[sp.Symbol, sp.Expr]:
    """Return the state of the motion ``-x``, half a period of the forcing later, by symbols."""
    state = [x, v, a, forcing, *(each.symbol for each in scene.memory)]
    state += [q for contact in scene.contacts for q in contact.symbols]
    return {symbol: -symbol for symbol in state}


def _mirrored(phase: Phase, scene: SceneData) -> Phase:
    """Return the mirror image of a phase of a scene."""
    image = _image(scene)
    mirrored = with_values(phase, image)
    of_mass = scene.body is None
    return replace(
        mirrored,
        equation=-mirrored.equation if of_mass else tuple(-law for law in mirrored.laws),
        ends=replace(
            mirrored.ends,
            jump={q: -sp.sympify(law).subs(image) for q, law in mirrored.ends.jump.items()},
            demands=_named(mirrored.ends.demands),
        ),
        demands=_named(mirrored.demands),
        held=None if phase.held is None else -sp.sympify(phase.held),
    )


def _is_odd(scene: SceneData) -> bool:
    """Return whether the mirror image of each phase is a phase: by law, event and jumps."""
    images = [_mirrored(phase, scene) for phase in scene.phases]
    return all(any(_alike(one, other, scene) for other in scene.phases) for one in images)


def _place(phase: Phase, phases: Sequence[Phase], scene: SceneData) -> Place | None:
    """Return where a phase, or its mirror image, is among some; None if it is not."""
    for mirrored in (False, True)[: 2 if scene.half_period else 1]:
        wanted = _mirrored(phase, scene) if mirrored else phase
        for p, other in enumerate(phases):
            if _alike(wanted, other, scene) and _demands(wanted) == _demands(other):
                return p, mirrored
    return None


def _demands(phase: Phase) -> set[sp.Expr]:
    return {sp.expand(sp.sympify(demand)) for demand in phase.demands.values()}


def _alike(one: Phase, other: Phase, scene: SceneData) -> bool:
    """Return whether two phases have the same law, event and jumps."""

    def said(phase: Phase, sign: int) -> sp.Matrix:
        behind = [phase.ends.jump.get(q, q) for q in velocities(scene)]
        return sp.Matrix([*phase.laws, phase.held or 0, *behind, sign * phase.ends.zero])

    return any((said(one, 1) - said(other, sign)).expand().is_zero_matrix for sign in (1, -1))


def _named(demands: Mapping[str, sp.Expr]) -> dict[str, sp.Expr]:
    return {f"{words} ({MIRRORED})": demand for words, demand in demands.items()}
