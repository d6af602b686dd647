"""Motions of which none has all phases: orders of the phases of all of them are found.

Each scene is declared twice: by a motion to either side, and by one motion that has the phases
of both.  The orbits must be the same.
"""

import pickle
from dataclasses import replace

import pytest
import sympy as sp
from made_scenes import parameters

import nonsmooth as ns
from nonsmooth.codegen.scene.orders import all_phases as phases_of
from nonsmooth.codegen.scene.orders import in_order
from nonsmooth.scene import Body, Event, Memory, Phase, Scene, a, forcing, v, x
from nonsmooth.solver.branch.orders.itinerary import Itinerary
from nonsmooth.solver.existence.reasons import motions_without_switches
from nonsmooth.solver.in_order import cases_in_order, motion_of
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.scenes.loaded import UnknownScene
from nonsmooth.solver.scenes.ordered import all_phases, declared_as, placed
from nonsmooth.solver.scenes.orders import Order, Step, in_cell
from nonsmooth.solver.simulation.settle import rough_times_by_simulation

c, F, g, k, m, Omega = sp.symbols("c F g k m Omega", positive=True)
w = sp.Symbol("w", real=True)
PARAMETERS = parameters(
    mass=(m, "kg", 1.0), damping=(c, "N s/m", 0.1), stiffness=(k, "N/m", 1.0),
    gap=(g, "m", 0.5), force=(F, "N", 0.5), frequency=(Omega, "rad/s", 1.0),
)  # fmt: skip
LOAD = F * forcing - k * x
MOVES = m * a + c * v - LOAD

#: Of a chain of two masses: stops at the second one.
CHAIN = Body(
    M=sp.diag(m, m), K=sp.Matrix([[2 * k, -k], [-k, k]]), C=sp.Matrix([[c, -c], [-c, c]]),
    forcing=[F, 0], at={"tip": [0, 1]},
)  # fmt: skip
TIP = CHAIN.at["tip"]


def between(place):
    """Return demands on a displacement: it is between the stops."""
    return {"before the right stop": g - place, "behind the left stop": place + g}


def springs(law, place):
    """Return the phases of contact with springs four times as stiff, and those between."""
    right = Phase("right", law + 4 * k * (place - g), Event(place - g), {"right": place - g})
    left = Phase("left", law + 4 * k * (place + g), Event(place + g), {"left": -place - g})
    free = Phase("free", law, Event(place - g), between(place))
    return (right, free), (left, replace(free, ends=Event(place + g)))


def walls():
    """Return the phases of flight to walls without rebound, and of rest there."""
    rest = Phase("rest", a, Event(LOAD), {"right": LOAD, "there": x}, held=sp.Integer(0))
    flight = Phase("flight", MOVES, Event(x - g, jump={v: 0}), between(x))
    return (flight, rest), (
        replace(flight, ends=Event(x + g, jump={v: 0})),
        replace(rest, demands={"left": -LOAD, "there": -x}),
    )


def scene(right, left=(), **fields):
    """Return a scene with a motion to either side; or with one motion."""
    how = {"motions": {"to-right": right, "to-left": left}} if left else {"phases": right}
    what = "a mass between two stops"
    return Scene("two-sided", what, PARAMETERS, frequency=Omega, **how, **fields)


def in_turn(right, left):
    """Return the phases of two motions as those of one, with the names of `all_phases`."""
    first, second = right
    third, fourth = left
    third = replace(third, name="flight_2") if third.name == first.name else third
    return first, second, third, replace(fourth, name=f"{second.name}_2")


SCENES = {
    "springs": (springs(MOVES, x), {}),
    "walls": (walls(), {}),
    "chain": (springs(TIP.force, TIP.x), {"body": CHAIN}),
}
TWO = {name: ns.scene(scene(*q, **fields)) for name, (q, fields) in SCENES.items()}
ONE = {name: ns.scene(scene(in_turn(*q), **fields)) for name, (q, fields) in SCENES.items()}


@pytest.mark.parametrize(
    ("name", "values", "order"),
    [
        ("springs", {"frequency": 0.8}, "right,free_2,mirrored"),
        ("walls", {"frequency": 0.7, "gap": 0.2}, "flight,rest,mirrored"),
        ("walls", {"frequency": 0.42, "gap": 0.3, "force": 0.4}, "flight,flight,rest,mirrored"),
        ("chain", {"frequency": 0.6, "force": 0.3}, "right,free_2,mirrored"),
    ],
)
def test_an_orbit_of_phases_of_both_motions_is_found(name, values, order) -> None:
    orbit = ns.exact(TWO[name](**values))
    expected = ns.exact(ONE[name](**values))
    assert orbit.case.scene.motion == order
    assert orbit.stable
    assert orbit.period == pytest.approx(expected.period, rel=1e-15)
    assert orbit.durations == pytest.approx(expected.durations, rel=1e-12)
    assert orbit.multipliers[:2] == pytest.approx(expected.multipliers[:2], abs=1e-11)
    assert pickle.loads(pickle.dumps(orbit)).case == orbit.case


def test_a_branch_goes_through_orders_of_phases_of_both_motions() -> None:
    two, one = (ns.branch(q["springs"](), "frequency", 0.33, 0.45) for q in (TWO, ONE))
    assert [row.motion for row in two] == [row.motion for row in one]
    events = [q.parameter for q in one.events]
    assert [q.parameter for q in two.events] == pytest.approx(events, rel=1e-14)
    assert two[-1].multipliers == pytest.approx(one[-1].multipliers, abs=1e-12)


def test_basins_of_orbits_of_phases_of_both_motions() -> None:
    two, one = (
        ns.basins(q["springs"](frequency=1.7), [-1, 0, 1], [-1, 0, 1]) for q in (TWO, ONE)
    )
    assert two.case.scene == TWO["springs"]  # whose parameters a caption shows
    assert len(two.attractors) == 2
    assert two.index.tolist() == one.index.tolist()
    assert str(two) == str(one)


def test_a_simulation_for_one_motion_has_the_phases_of_all() -> None:
    """It settles on an order of all, or on a motion, from whichever phase that begins."""
    case = TWO["springs"](frequency=0.8)
    assert ns.simulate(case.of_motion("to-right")).phases == ns.simulate(case).phases
    with pytest.raises(
        NoOrbit, match=r"settles on another sequence of phases: right, free_2, l"
    ):
        ns.exact(TWO["springs"](frequency=0.8).of_motion("to-right"))
    (right, free), (left, back) = springs(MOVES, x)
    motions = {
        "round": (right, replace(back, name="back"), left, free),
        "right": (right, free),
        "left": (left, back),
    }
    parts = Scene("sides", "a mass between stops", PARAMETERS, motions=motions, frequency=Omega)
    case = ns.scene(parts)(frequency=0.63, force=0.4)
    assert all_phases(case.scene).orders[2] == ((2, False), (1, False))
    found = {
        each.scene.motion: times
        for each in case.each_motion
        for times in (q.times for q in rough_times_by_simulation(each)) if times
    }  # fmt: skip
    assert [*found] == ["left"]
    durations = ns.exact(case.of_motion("left")).cell_durations
    assert found["left"].durations == pytest.approx(durations, rel=1e-3)


@pytest.mark.parametrize("first", [(0, 3), (3, 2), (2, 1), (1, 0)])
def test_a_map_calls_an_order_as_it_is_called_where_a_simulation_settles(first) -> None:
    order = Order(tuple(map(Step, first)), half_period=True)
    assert Itinerary(all_phases(TWO["springs"]), order).called == "right,free_2,mirrored"


def test_phases_of_any_motion_can_be_asked_for() -> None:
    case = TWO["springs"](frequency=0.8)
    assert case.scene.classes == ()
    assert case.scene.default_classes == {}
    every = all_phases(case.scene)
    assert every.phases == ("right", "free", "left", "free_2")
    meant = [q.scene.motion for q in cases_in_order(case, "right,free,left,free")]
    assert meant[-2:] == ["right,free_2,mirrored", "right,free_2,left,free"]
    assert motion_of(case.scene, "right,free_2,left,free").phases[1] == "free_2"
    assert motion_of(case.scene, "to_left") == case.scene.of_motion("to-left")
    with pytest.raises(UnknownScene, match="expected one of right, free, left, free_2"):
        cases_in_order(case, "right,fre")
    with pytest.raises(UnknownScene, match="motion: got 'top'"):
        motion_of(case.scene, "top")
    with pytest.raises(
        UnknownScene, match="expected one of to-right, to-left; for an order take"
    ):
        case.of_motion("right,free_2")
    assert pickle.loads(pickle.dumps(every)) == every != case.scene


def test_the_equations_of_such_an_order_are_those_that_are_solved() -> None:
    right, left = springs(MOVES, x)
    ordered = in_order(scene(right, left), "right,free_2,mirrored")
    own = ns.scene(replace(ordered, name="ordered", motion=""))(frequency=0.8)
    orbit = ns.exact(TWO["springs"](frequency=0.8))
    assert ns.exact(own).durations == pytest.approx(orbit.durations, rel=1e-14)


def test_a_phase_without_switches_is_called_as_in_orders() -> None:
    """The second phase of one name is another where its demands are others."""
    (right, free), (left, other) = springs(MOVES, x)
    other = replace(other, demands={"behind the left stop": x + g})
    unlikely = replace(free, demands={"far to the left": -x - 9 * g})
    case = ns.scene(scene((right, unlikely), (left, other)))(gap=3, frequency=2)
    assert [q.phase for q in motions_without_switches(case)] == ["free_2"]
    assert [q.phase for q in motions_without_switches(case.of_motion("to-left"))] == ["free_2"]
    (last,) = {row.motion for row in ns.branch(case, "frequency", 1.9, 2.1)}
    assert last == "only free_2"


def test_a_phase_is_the_same_by_any_name_or_mirrored() -> None:
    (right, free), (left, other) = springs(MOVES, x)
    longest = right, free, replace(right, name="again"), replace(other, name="back")
    shorter = replace(other, name="left"), replace(left, name="right")
    found = phases_of(scene(longest, shorter))
    assert found.orders["to-left"] == ((3, False), (4, False))
    assert [q.name for q in found.scene.phases[3:]] == ["back", "right_2"]
    odd = phases_of(scene(longest, shorter, half_period=True))
    assert odd.orders["to-left"] == ((3, False), (0, True))
    assert len(odd.scene.phases) == 4


#: The displacement where contact began, of which the law has a part.
MEMORY = Memory(w, "right", x, "displacement where contact began")


def remembering(*motions):
    """Return a scene with the memory and these motions."""
    return ns.scene(scene(*motions, memory=(MEMORY,)))


def test_a_memory_is_set_by_one_phase_of_all_motions() -> None:
    (right, free), (left, other) = springs(MOVES - k * w / 9, x)
    back = replace(free, name="back")
    round_trip = right, other, left, back
    two, one = remembering((right, free), round_trip), remembering(round_trip)
    assert all_phases(two).orders == (
        ((0, False), (3, False)),
        tuple((p, False) for p in range(4)),
    )
    orbit, expected = (ns.exact(q(frequency=0.3)) for q in (two, one))
    assert orbit.case.scene.motion == "to-right"
    assert expected.case.scene.motion == "right,back"  # as the last of the round trip ends
    assert orbit.durations == pytest.approx(expected.durations, rel=1e-13)
    assert orbit.memory == pytest.approx(expected.memory, rel=1e-13)


def test_where_another_phase_sets_a_memory_a_motion_stands_alone() -> None:
    (right, free), (left, other) = springs(MOVES - k * w / 9, x)
    alone = remembering((right, free), (replace(left, name="right"), other))
    every = all_phases(alone)
    assert every.phases == ("right", "free")
    assert every.orders == (((0, False), (1, False)), ())
    to_right, to_left = alone.each_motion
    assert declared_as(every, Order((Step(0), Step(1)))) == to_right
    assert placed(to_right)[0] == every
    assert placed(to_left) == (to_left, Order((Step(0), Step(1))))


def test_demands_at_a_switch_are_for_the_phase_behind_it_in_the_first_motion() -> None:
    """A mass reverses where the load exceeds friction; in the orbit found it stops there."""
    friction = k * g
    holds = {"to the left": friction + LOAD, "to the right": friction - LOAD}
    forth = Phase("forth", MOVES + friction, Event(v), {"to the right": v})
    back = Phase("back", MOVES - friction, Event(v), {"to the left": -v})
    up = Phase("up", a, Event(LOAD - friction), holds, held=sp.Integer(0))
    down = Phase("down", a, Event(LOAD + friction), holds, held=sp.Integer(0))
    reverses = (
        replace(forth, ends=Event(v, demands={"it exceeds": -LOAD - friction})),
        replace(back, ends=Event(v, demands={"it exceeds": LOAD - friction})),
    )
    motions = {"reverses": reverses, "right": (forth, up), "left": (back, down)}
    two = Scene("rough", "a mass with friction", PARAMETERS, motions=motions, frequency=Omega)
    orbit = ns.exact(ns.scene(two)(frequency=0.43, force=0.67, gap=0.137))
    assert orbit.case.scene.motion == "forth,down,mirrored"
    assert orbit.stable
    ordered = in_order(two, "forth,back,forth,down,back,up").phases
    assert [len(q.ends.demands) for q in ordered] == [1, 1, 0, 0, 0, 0]
    steps = tuple(map(Step, (0, 1, 0, 3, 1, 2)))
    phases = in_cell(all_phases(ns.scene(two)).cell((0.4,) * 6), Order(steps)).phases
    assert [len(q.switch_demands) for q in phases] == [1, 1, 0, 0, 0, 0]


def test_a_phase_begins_as_the_one_before_it_leaves_it_in_any_motion() -> None:
    """The first phase of the longest motion sets a memory; its last is not the last of all."""
    law = MOVES + k * (x - w)
    elastic = Phase("elastic", law, Event(x - w + g), {"yields": x - w + g, "other": g + w - x})
    plastic = Phase("plastic", MOVES - k * g, Event(x + 3 * g), {"back": -v})
    pressed = Phase("pressed", MOVES - k * g + k * (x + 3 * g), Event(v), {"back": -v})
    short = elastic, replace(plastic, ends=Event(v), name="turns")
    longest, memory = (elastic, plastic, pressed), Memory(w, "elastic", x - g, "middle")
    one = scene(longest, memory=(memory,), half_period=True)
    two = scene(longest, short, memory=(memory,), half_period=True)
    names = "elastic,plastic,pressed,elastic,plastic,pressed"
    expected, found = (in_order(q, names).memory for q in (one, two))
    assert found == expected
    assert [q.value for q in found] == [x + g, x + g]
    steps = tuple(map(Step, (0, 1, 2, 0, 1, 2)))
    bases = (all_phases(ns.scene(q)).cell((0.4,) * 6) for q in (one, two))
    expected, found = (in_cell(q, Order(steps)).memory for q in bases)
    assert found == expected
