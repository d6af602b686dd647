"""Phases that end in several ways: the same oscillators as with a phase for each event."""

import pickle
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from exponentials import generator, repeating
from scenes.test_motions_of_different_phases import (
    CHAIN,
    MOVES,
    ONE,
    TIP,
    between,
    scene,
    springs,
)
from scipy.linalg import expm
from shown import ROOT

import nonsmooth as ns
from nonsmooth.codegen.equations.registry import sections
from nonsmooth.codegen.scene import SceneError
from nonsmooth.codegen.scene.orders import all_phases
from nonsmooth.described import document
from nonsmooth.scene import Event, Phase, v, x
from nonsmooth.solver.in_order import cases_in_order

g = sp.Symbol("g", positive=True)
BACK = {v: -v / 2}
FRAME = ROOT / "examples/scenes/two_elastic_stops.py"


def listed(law, place, **fields):
    """Return the scene of `springs` with one phase between them, which either ends."""
    (right, free), (left, other) = springs(law, place)
    return scene((right, replace(free, ends=other.ends | free.ends), left), **fields)


SPRINGS, ON_CHAIN = listed(MOVES, x), listed(TIP.force, TIP.x, body=CHAIN)


@pytest.mark.parametrize(
    ("made", "name", "values"),
    [
        (SPRINGS, "springs", {"frequency": 0.8}),
        (ON_CHAIN, "chain", {"frequency": 0.6, "force": 0.3}),
    ],
)
def test_the_orbit_is_that_of_phases_with_one_event_each(made, name, values) -> None:
    orbit, expected = ns.exact(ns.scene(made)(**values)), ns.exact(ONE[name](**values))
    assert orbit.stable
    assert sorted(orbit.durations) == pytest.approx(sorted(expected.durations), rel=1e-12)
    sizes = [np.abs(q.multipliers).tolist() for q in (orbit, expected)]
    assert sizes[0] == pytest.approx(sizes[1], abs=1e-11)
    assert pickle.loads(pickle.dumps(orbit)).case == orbit.case


def test_a_branch_has_the_events_of_phases_with_one_event_each() -> None:
    own, other = (
        ns.branch(q(), "frequency", 0.33, 0.45) for q in (ns.scene(SPRINGS), ONE["springs"])
    )
    events = [q.parameter for q in other.events]
    assert [q.parameter for q in own.events] == pytest.approx(events, rel=1e-14)
    assert "left,free_by_2,mirrored" in {q.motion for q in own}


def test_a_simulation_have_the_phase_by_its_own_name() -> None:
    case = ns.scene(SPRINGS)(frequency=0.8)
    assert {q.name for q in ns.simulate(case).phases} == {"right", "free", "left"}


def test_two_contacts_meet_their_stops_at_the_times_of_the_orbit() -> None:
    """By matrix exponentials of the whole frame: the state repeats, each switch is an event."""
    case = ns.scene(FRAME)()
    orbit = ns.exact(case)
    names = [q.name for q in orbit.phases]
    assert names == ["free", "top", "both_by_2", "top_by_2"]
    K, period, steps = np.array([[2.0, -1.0], [-1.0, 1.0]]), np.eye(7), []
    for phase in orbit.phases:
        pressed = np.array(
            [phase.name[:3] in where for where in (("low", "bot"), ("top", "bot"))]
        )
        stiff, back = K + 5 * np.diag(pressed), 5 * pressed * [0.4, 0.6]
        A = generator(np.eye(2), stiff, 0.05 * K, [0.0, 0.3], 0.7, back)
        steps.append(expm(A * phase.duration))
        period = steps[-1] @ period
    X, places = repeating(period, orbit.forcing_phase), []
    for step in steps:
        X = step @ X
        places.append(X[:2] - [0.4, 0.6])
    met = [1, 0, 0, 1]  # the top mass, the lower one, the lower one, the top mass
    assert [place[i] for place, i in zip(places, met, strict=True)] == pytest.approx(
        [0] * 4, abs=1e-13
    )


@pytest.mark.parametrize(
    "phases",
    [
        "free,top,both,top",
        "top,both,top,free",
        "both_by_2,top_by_2,free,top",
        "both,top,free,top",
    ],
)
def test_an_order_is_found_wherever_it_begins(phases, tmp_path: Path) -> None:
    case = ns.scene(FRAME)()
    expected = sorted(ns.exact(case).durations)
    (asked,) = cases_in_order(case, phases)
    orbit = ns.solve(asked, order=12)
    assert sorted(orbit.durations) == pytest.approx(expected, rel=1e-13)
    ns.save(orbit, tmp_path / "orbit.json")
    assert ns.load(tmp_path / "orbit.json", scene=FRAME) == orbit


def test_half_of_an_odd_motion_may_begin_with_an_image() -> None:
    case = ns.scene(SPRINGS)(frequency=0.8)
    first, second = (
        ns.solve(case, phases=q) for q in ("right,free,mirrored", "left,free_by_2,mirrored")
    )
    turned = np.pi + first.forcing_phase - second.forcing_phase
    assert second.durations == pytest.approx(first.durations, rel=1e-12)
    assert np.cos(turned) == pytest.approx(1, abs=1e-12)


def test_a_demand_does_not_go_on_to_fall() -> None:
    """Behind the event at which the lower mass meets its stop, it is not before the stop."""
    case = ns.scene(FRAME)()
    read = [q.scene.motion for q in cases_in_order(case, "free,low,both,low")]
    assert read == ["free_by_2,low_by_2,both,low"]
    with pytest.raises(ValueError, match="where one cannot follow another"):
        cases_in_order(case, "free,top_by_2,low_by_2")


def test_of_an_odd_scene_the_image_of_a_phase_has_its_other_event() -> None:
    either = Event(x - g, BACK) | Event(x + g, BACK)
    assert [q.zero for q in either.each] == [x - g, x + g]
    assert either.each[0].others == ()
    walls = scene((Phase("flight", MOVES, either, between(x)),), half_period=True)
    assert [q.name for q in all_phases(walls).scene.phases] == ["flight"]


def test_the_document_names_every_event() -> None:
    (right, free, left) = SPRINGS.phases
    kicked = replace(free, ends=free.ends.each[0] | Event(x - g, BACK))
    (motion,) = document(ns.scene(replace(SPRINGS, phases=(right, kicked, left))))["motions"]
    assert motion["phases"][1]["ends"] == "x + g = 0 or x - g = 0"
    assert motion["phases"][1]["jump"] == "nothing or x' -> -1/2 x'"
    assert motion["phases"][0]["ends"] == "x - g = 0"


def test_equations_name_every_event_and_those_of_an_order_the_one_that_ends_a_phase() -> None:
    words = [e.title for e in sections(SPRINGS, ["ck-tau"])[0].equations]
    assert "in another order free ends, as free_by_2" in words
    ordered = sections(SPRINGS, ["ck-tau"], phases="right,free_by_2,left,free")
    titles = [e.title for e in ordered[0].equations]
    assert not any("in another order" in title for title in titles)
    assert titles.index("free_by_2 ends") < titles.index("free ends")


def test_what_several_events_may_not_have() -> None:
    forward = Event(x, demands={"it moves forward": v})
    (right, free, left) = SPRINGS.phases
    for ends in (forward | Event(x - 1), Event(x - 1) | forward):
        with pytest.raises(
            SceneError, match="free: ends: demand: got demands at a switch, exp"
        ):
            replace(SPRINGS, phases=(right, replace(free, ends=ends), left))
    with pytest.raises(SceneError, match=r"phase free_by_2: ends: .* v is in m/s, -g in m"):
        replace(SPRINGS, phases=(right, replace(free, ends=Event(x + g) | Event(v - g)), left))
    with pytest.raises(SceneError, match="free: ends: got 3, expected an Event"):
        replace(SPRINGS, phases=(right, replace(free, ends=Event(x, others=(3,))), left))
    with pytest.raises(TypeError, match="unsupported operand"):
        Event(x) | 3
    with pytest.raises(SceneError, match="guess: got 'round', expected one of as-listed"):
        replace(SPRINGS, guess={"round": (1.0,)})


def test_phases_of_two_names_in_turn_are_listed_in_an_order() -> None:
    """Neighbours in the list differ, as in every order."""
    right, free, left = SPRINGS.phases
    same = replace(free, name="same")
    with pytest.raises(SceneError, match="phase same: its motion is that of free"):
        replace(SPRINGS, phases=(right, free, same, left))
    names = [q.name for q in all_phases(SPRINGS).scene.phases]
    assert names == ["right", "free", "left", "free_by_2"]
