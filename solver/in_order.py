"""Cases with orders of phases that the scene does not declare."""

import math
from collections.abc import Iterator, Sequence
from functools import cache
from itertools import product

from ..nearest import at_length, one_of
from .existence.known import known
from .kernels.start import RoughTimes
from .scenes.case import Case
from .scenes.cell import Cell
from .scenes.loaded import LoadedScene, UnknownScene
from .scenes.ordered import MIRRORED, all_phases, declared_as, in_order, of_all_phases
from .scenes.orders import Order, Step, half_if_mirrored, image, is_odd, pairs
from .scenes.parameter_error import several
from .simulation.followers import may_follow
from .simulation.machine import Machine
from .simulation.machines import machine_of
from .simulation.settle import FEW, PHASES, from_several_states

#: Digits of durations, without units, and of the phase of the forcing, in which different
#: orbits of an order differ.
APART = 2

#: Most phases of an order, most readings of its names, and most different orders among these.
MOST_PHASES, MOST_WAYS, MOST_ORDERS = 100, 4096, 64


def cases_in_order(
    case: Case, phases: str | Sequence[str], cycles: int | None = None
) -> list[Case]:
    """Return the cases in which the phases of a scene follow a given order.

    There are several if the names do not tell which phases are mirrored, or if they may be
    those of half a period or of a whole one; half periods come first.

    Parameters
    ----------
    case : Case
        Its scene and parameters.
    phases : str or sequence of str
        Names of phases, in a text joined by commas; ``3 x`` before one of several that follow
        each other.  ``-`` before a name means the mirror image
        of the phase, ``mirrored`` at the end that they are half a period.  Without any minus,
        each may be the phase or its mirror image.
    cycles : int, optional
        Periods of the forcing in one period of the motion.  Even numbers exclude orders of half
        a period.  Default: those of the case.

    Raises
    ------
    ParameterError
        A `ValueError`: if `cycles` is not a number of cycles.
    TypeError
        If `phases` are no names.
    UnknownScene
        A `ValueError`: if there is no such phase, or one cannot follow another.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> case = registry.load("dry-friction")()
    >>> [each.scene.motion for each in cases_in_order(case, "slide,stop")]
    ['slide,stop,mirrored', 'slide,-stop']
    """
    base = all_phases(case.scene)
    names = at_length(phases) if isinstance(phases, str) else _names(phases)
    half = names[-1:] == [MIRRORED]
    machine = machine_of(Case(base, case.values).cell)
    ways = _ways(base, names[:-1] if half else names)
    orders = _different(machine.cell, _orders(machine, ways, half))
    count = case.cycles if cycles is None else cycles
    whole = [order for order in orders if not order.half_period]
    orders = whole if whole and count % 2 == 0 else orders
    if not orders:
        raise UnknownScene(f"phases: got {','.join(names)}, where one cannot follow another")
    if len(orders) > MOST_ORDERS:
        raise _too_many(names, len(orders))
    return [Case(in_order(base, order), case.values, count) for order in orders]


def _names(phases: Sequence[str]) -> list[str]:
    names = several("phases", phases, "names of phases")
    if not all(isinstance(name, str) for name in names):
        raise TypeError(f"phases: got {phases!r:.80}, expected names of phases in a sequence")
    return [name.strip() for name in names]


def settled_cases(
    case: Case, *, patiently: bool = False, as_declared: bool = False
) -> Iterator[tuple[Case, RoughTimes]]:
    """Yield the orders on which simulations settle: cases, and times of their cells.

    They may be declared orders, too; that of a scene of one motion is if `as_declared`.  Their
    motions have the period of the case.  For the starts see `from_several_states`.  Simulations
    are short where orbits can be listed; where they are to be followed `patiently`, as no orbit
    is known, longer ones come after these.
    """
    base = of_all_phases(case)
    listed = all(known(each).listed for each in case.each_motion)
    phases = [FEW] if listed else []
    if patiently or not listed:
        phases.append(PHASES)
    orders: set[Order] = set()
    declared: set[tuple[float, ...]] = set()
    for settled in from_several_states(case, *phases):
        if as_declared and settled.times is not None:
            times = *settled.times.durations, settled.times.angle
            about = tuple(round(q, APART) for q in times)
            if about not in declared:
                yield case, settled.times
            declared.add(about)
        other = settled.other.within(case.cycles) if settled.other else None
        if other is None or other.order in orders:
            continue
        if settled.conclusive:
            orders.add(other.order)
        scene = declared_as(base.scene, other.order) or in_order(base.scene, other.order)
        yield Case(scene, case.values, case.cycles), other.times


def choices(base: LoadedScene, name: str) -> list[Step]:
    """Return the phases of a name; with a minus before it their mirror images.

    Raises
    ------
    UnknownScene
        If there is none.
    """
    plain = name.removeprefix("-")
    steps = [Step(p, name != plain) for p in base.called(plain)]
    if not steps or (name != plain and not base.half_period):
        raise UnknownScene(f"phases: got {name!r}, expected {one_of(plain, base.phases)}")
    return steps


def motion_of(scene: LoadedScene, motion: object) -> LoadedScene:
    """Return the scene of one motion, from the name of the motion.

    An undeclared order has the name `OrderedScene.motion`; where several phases have one name,
    the first is meant.

    Raises
    ------
    UnknownScene
        If there is no such motion.
    """
    if motion == scene.motion:
        return scene
    scene = scene.whole
    base, names = all_phases(scene), motion.split(",") if isinstance(motion, str) else [""]
    if motion in scene.motions or not base.called(names[0].removeprefix("-")):
        return scene.of_motion(motion)
    half = names[-1] == MIRRORED
    steps = (choices(base, name)[0] for name in (names[:-1] if half else names))
    return in_order(base, Order(tuple(steps), half))


def _ways(base: LoadedScene, names: list[str]) -> list[tuple[Step, ...]]:
    """Return the sequences of phases that names may mean; the first is as it is named."""
    if not names:
        raise UnknownScene("phases: got none, expected at least one")
    if len(names) > MOST_PHASES:
        raise UnknownScene(f"phases: got {len(names)}, expected {MOST_PHASES} at most")
    signed = any(name.startswith("-") for name in names)
    alternatives = [choices(base, name) for name in names]
    if base.half_period and not signed:
        alternatives = [[*plain, *(Step(p, True) for p, _ in plain)] for plain in alternatives]
    count = math.prod(map(len, alternatives))
    if count > MOST_WAYS:
        raise _too_many(names, count)
    first = choices(base, names[0])
    return [steps for steps in product(*alternatives) if steps[0] in first]


def _too_many(names: list[str], count: int) -> UnknownScene:
    got = f"{len(names)} that may be meant in {count} ways"
    return UnknownScene(f"phases: got {got}, expected fewer, or a minus before the mirrored")


def _different(cell: Cell, orders: Iterator[Order]) -> list[Order]:
    """Return those of some orders that are neither rotations nor mirror images of others."""
    first: dict[object, Order] = {}
    for order in orders:
        mirrored = tuple(image(cell, step) for step in order.steps)
        whole = order.steps + mirrored if order.half_period else order.steps
        every = [whole] if order.half_period or None in mirrored else [whole, mirrored]
        rotations = ((*q[i:], *q[:i]) for q in every for i in range(len(q)))
        first.setdefault((order.half_period, min(rotations)), order)
    return list(first.values())


def _orders(machine: Machine, ways: list[tuple[Step, ...]], half: bool) -> Iterator[Order]:
    """Yield the possible orders: those of half periods, then, unless `half`, of whole ones.

    Before a whole period whose second half mirrors its first comes its half.
    """

    @cache
    def follows(step: Step, follower: Step | None) -> bool:
        return follower is not None and may_follow(machine, step, follower)

    def possible(order: Order) -> bool:
        return all(follows(*pair) for pair in pairs(machine.cell, order))

    if half or is_odd(machine.cell):
        yield from filter(possible, (Order(steps, True) for steps in ways))
    for order in filter(possible, map(Order, () if half else ways)):
        smaller = half_if_mirrored(machine.cell, order)
        yield from (order,) if smaller == order else (smaller, order)
