"""Memories that hold in several phases, and events that say which phase follows.

A frame on two friction joints, against matrix exponentials of the frame in each phase.
"""

import pickle
import runpy
from dataclasses import replace
from functools import reduce
from itertools import product
from operator import or_
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from made_scenes import parameters, scene_of
from scipy.linalg import expm
from shown import ROOT

import nonsmooth as ns
from nonsmooth.codegen.scene import SceneError, in_order
from nonsmooth.codegen.scenes import load
from nonsmooth.described import document
from nonsmooth.scene import Body, Event, Memory, Phase
from nonsmooth.solver.in_order import cases_in_order
from nonsmooth.solver.no_orbit import NoOrbit

FILE = ROOT / "examples/scenes/two_joints.py"
FRAME = runpy.run_path(str(FILE))["SCENE"]
K = np.array([[2.0, -1.0], [-1.0, 1.0]])

#: Whether the joints stick (0) or slip, and which way, in each phase.
SLIPS = {"stick": (0, 0), "low": (1, 0), "top": (0, 1), "both": (1, 1), "apart": (1, -1)}


def joints(**values):
    """Return a case of the frame on two joints."""
    return ns.scene(FILE)(**values)


def case_of(scene, **values):
    """Return the case of a scene that was made in place."""
    return ns.scene(scene)(**values)


def modes(orbit) -> list[tuple[int, int]]:
    """Return which joint slips in each phase of an orbit, and which way."""
    steps = orbit.case.scene.order.steps
    names = orbit.case.scene.base.phases
    found = []
    for p, mirrored in steps:
        low, top = SLIPS[names[p].partition("_by_")[0]]
        found.append((-low, -top) if mirrored else (low, top))
    return found


def closed(orbit) -> tuple[np.ndarray, np.ndarray]:
    """Return the worst error of the events of an orbit, and the worst violated limit.

    The state is q, q', w, cos, sin, 1.  It changes its sign over the cell.
    """
    case, slips = orbit.case, modes(orbit)
    f = np.array([case.values["low_friction"], case.values["top_friction"]])
    k_t, force = case.values["joint_stiffness"], case.values["force"]
    omega = case.values["frequency"]
    flows, cell = [], np.eye(9)
    for p, phase in enumerate(orbit.phases[: len(slips)]):
        A, stuck = np.zeros((9, 9)), np.array([q == 0 for q in slips[p]])
        A[:2, 2:4], A[2:4, :2], A[2:4, 2:4] = np.eye(2), -K - k_t * np.diag(stuck), -K / 20
        A[2:4, 4:6], A[3, 6] = k_t * np.diag(stuck), force
        A[2:4, 8] = -f * slips[p]
        A[6, 7], A[7, 6] = -omega, omega
        set_by = np.eye(9)
        for j in (0, 1):
            if stuck[j] and slips[p - 1][j]:  # it stops: its spring has the force of the slider
                slip = slips[p - 1][j] * (-1 if p == 0 else 1)
                set_by[4 + j] = 0.0
                set_by[4 + j, j], set_by[4 + j, 8] = 1.0, -slip * f[j] / k_t
        flows.append((A, phase.duration, set_by))
        cell = expm(A * phase.duration) @ set_by @ cell
    waves = [np.cos(orbit.forcing_phase), np.sin(orbit.forcing_phase), 1.0]
    own = slice(0, 6)
    start = np.linalg.solve(cell[own, own] + np.eye(6), -cell[own, 6:] @ waves)
    X, errors, limits = np.concatenate([start, waves]), [], []
    for p, (A, s, set_by) in enumerate(flows):
        X = set_by @ X
        for u in np.linspace(0, 1, 101):
            Y = expm(A * s * u) @ X
            pull, speed = k_t * (Y[:2] - Y[4:6]), Y[2:4]
            sides = [
                f[j] - abs(pull[j]) if q == 0 else q * speed[j] for j, q in enumerate(slips[p])
            ]
            limits.append(min(sides))
        X = Y
        then = np.array(slips[p + 1] if p + 1 < len(slips) else tuple(-q for q in slips[0]))
        (j,) = np.flatnonzero(then != slips[p])
        errors.append(speed[j] if slips[p][j] else pull[j] - then[j] * f[j])
    return np.abs(errors).max(), min(limits)


def test_equal_joints_that_are_driven_alike_give_way_together(tmp_path: Path) -> None:
    """Each mass moves as one on an elastic-plastic element; no spring between them matters."""
    text = FILE.read_text().replace("[2, -1], [-1, 1]", "[2, -1], [-1, 2]")
    text = text.replace("forcing=[0, F]", "forcing=[F, F]").replace(
        "two-joints", "equal-joints"
    )
    path = tmp_path / "equal_joints.py"
    path.write_text(text)
    frame = ns.scene(path)(joint_stiffness=2.0, low_friction=0.15, top_friction=0.15, force=0.5)
    alone = ns.scene("elastic-plastic")(
        damping=0.05, stiffness=2, yield_force=0.15, hardening=1, force=0.5, frequency=0.6
    )
    expected, found = ns.exact(alone), ns.exact(frame)
    held, slips = (phase.duration for phase in expected.phases[:2])
    assert [phase.name.split("_")[0] for phase in found.phases] == ["stick", "both"] * 2
    assert found.durations == pytest.approx([held, slips] * 2, rel=1e-11)
    assert found.stable


@pytest.mark.parametrize(
    "values",
    [
        {},
        {"frequency": 0.61},
        {"low_friction": 0.05},
        {"force": 0.6, "frequency": 0.9},
        {"joint_stiffness": 3.0, "force": 1.0, "frequency": 1.3},
    ],
)
def test_an_orbit_of_two_joints_is_that_of_matrix_exponentials(values) -> None:
    orbit = ns.exact(joints(**values))
    assert orbit.stable
    error, limit = closed(orbit)
    assert error < 1e-13
    assert limit > -1e-13


def test_every_method_and_a_file_have_the_orbit(tmp_path: Path) -> None:
    case = joints()
    exact = ns.exact(case)
    assert exact.case.scene.motion == "stick,low,-stick_by_3,-top,mirrored"
    for method, error in (("hb", 1e-3), ("hb-ck", 1e-4), ("ck-tau", 1e-13)):
        orbit = ns.solve(case, method=method, order=12)
        assert orbit.durations == pytest.approx(exact.durations, abs=error * exact.period)
        ns.save(orbit, tmp_path / "orbit.json")
        assert ns.load(tmp_path / "orbit.json", scene=FILE) == orbit
        assert pickle.loads(pickle.dumps(orbit)) == orbit


def test_a_simulation_settles_on_the_orbit() -> None:
    case = joints()
    motion, exact = ns.simulate(case, cycles=60), ns.exact(case)
    last = [q.duration for q in motion.phases[-9:-1]]
    assert sorted(last) == pytest.approx(sorted(exact.durations), abs=1e-9)


def test_a_branch_goes_from_order_to_order() -> None:
    """A demand in a phase before the one that sets its memory has that of the cell before."""
    branch = ns.branch(joints(), "frequency", 0.597, 0.625)
    kinds = [(event.kind, event.phase) for event in branch.events]
    assert kinds == [("grazing", "-top"), ("vanishing", "low")]
    first, last = (event.parameter for event in branch.events)
    for value in (0.599, 0.612, 0.6155, 0.62):
        exact = ns.exact(joints(frequency=value))
        assert closed(exact)[0] < 1e-13
        assert len(modes(exact)) == 4 + 2 * (first < value < last)
    ends = branch[0], branch[-1]
    for row in ends:
        exact = ns.exact(joints(frequency=row.value))
        assert sorted(row.durations) == pytest.approx(sorted(exact.durations), rel=1e-12)
        assert np.abs(row.multipliers[0]) == pytest.approx(
            np.abs(exact.multipliers[0]), rel=1e-9
        )


def test_two_phases_of_a_branch_vanish_one_behind_the_other() -> None:
    """One begins where its event and its rate vanish, by the memory that it has just set."""
    branch = ns.branch(joints(frequency=0.6394), "frequency", 0.6393, 0.64)
    assert [event.kind for event in branch.events] == ["vanishing", "vanishing"]
    values = [event.parameter for event in branch.events]
    assert values == pytest.approx([0.639484676600113, 0.639739331618907], rel=1e-12)
    assert branch.why_it_ended == ("the end of the range",) * 2


def test_a_joint_that_never_slips_leaves_its_slider_anywhere() -> None:
    with pytest.raises(NoOrbit, match="none of them sets w_1, which may have any of many val"):
        ns.exact(joints(low_friction=0.2))
    (case,) = cases_in_order(joints(), "-stick_by_3,-top,mirrored")
    with pytest.raises(ValueError, match="phases: none of them sets a memory, which may have"):
        ns.exact(case)
    with pytest.raises(ValueError, match="none of them sets w_1, which may have any of many"):
        in_order(FRAME, "stick,top,mirrored")


def test_a_memory_is_not_set_within_the_phases_in_which_it_holds() -> None:
    """From where the upper joint slips to where both stick, the lower slider stays."""
    ordered = in_order(FRAME, "stick,low,-stick_by_3,-top,mirrored")
    assert [(str(q.symbol), q.at) for q in ordered.memory] == [
        ("w_1", "stick_by_3_m"),
        ("w_2", "stick"),
    ]
    own = ordered.memory[0]
    (f_1, k_t) = sp.symbols("f_1 k_t", positive=True)
    assert sp.expand(own.value - (FRAME.body.at["low"].x - f_1 / k_t)) == 0
    (case,) = cases_in_order(joints(), "stick,low,-stick_by_3,-top,mirrored")
    assert [q.phase for q in case.cell.memory] == [2, 0]
    names = case.scene.base.phases
    held = [{names[p].partition("_by_")[0] for p in q[1]} for q in case.scene.base.memory]
    assert held == [{"stick", "top"}, {"stick", "low"}]


def test_one_joint_is_that_of_a_memory_of_one_phase() -> None:
    """As shipped, and with a value by the force; an event says what it says anyway."""
    shipped = load("jenkins-absorber")
    slip, stick = shipped.phases
    (memory,) = shipped.memory
    (contact,) = shipped.body.at.values()
    k_t = sp.Symbol("k_t", positive=True)
    value = contact.x + contact.force / k_t
    again = replace(
        shipped,
        name="one-joint",
        phases=(
            replace(slip, ends=replace(slip.ends, to="stick")),
            replace(stick, ends=replace(stick.ends, to="-slip")),
        ),
        memory=(replace(memory, at=("stick",), value=value),),
    )
    assert (
        again.of_motion("as-listed").memory[0].value.free_symbols == memory.value.free_symbols
    )
    for values in ({}, {"frequency": 0.8}, {"friction": 0.02}):
        one, other = (
            ns.exact(ns.scene(shipped.name)(**values)),
            ns.exact(case_of(again, **values)),
        )
        assert other.durations == pytest.approx(one.durations, rel=1e-13)
        sizes = [np.sort(np.abs(q.multipliers)) for q in (one, other)]
        assert sizes[0] == pytest.approx(sizes[1], abs=1e-12)


def test_phases_may_be_listed_in_any_order() -> None:
    """Also in one that sets a memory twice."""
    stick, low, both, apart, top = FRAME.phases
    scene = replace(FRAME, name="listed-anew", phases=(stick, low, top, both, apart))
    assert [str(q.symbol) for q in scene.of_motion("as-listed").memory] == [
        "w_1",
        "w_1_2",
        "w_2",
    ]
    orbit, expected = ns.exact(case_of(scene)), ns.exact(joints())
    assert sorted(orbit.durations) == pytest.approx(sorted(expected.durations), rel=1e-13)
    (described,) = document(ns.scene(scene))["motions"]
    assert described["phases"][2]["sets"][0]["expression"] == "x + 1/k_t force"


def test_a_held_contact_has_no_force_by_which_a_memory_is_set() -> None:
    held = load("absorber-friction")
    _, stop = held.phases
    (contact,) = held.body.at.values()
    symbol = sp.Symbol("w", real=True)
    f_R = sp.Symbol("f_R", positive=True)
    value = contact.x * f_R + contact.force
    memory = Memory(symbol, (held.phases[0].name,), value, "what it was")
    assert stop.held is not None
    with pytest.raises(
        SceneError, match=r"got a force, but in .* it is not known: the contact is h"
    ):
        replace(held, memory=(memory,))


def test_orders_may_be_declared_as_motions() -> None:
    """Events say what follows there, too, and demands alone decide nothing more."""
    stick, low, both, _, top = FRAME.phases
    motions = {"in-turn": FRAME.phases, "round": (stick, low, both, top)}
    scene = replace(FRAME, name="declared", phases=(), motions=motions)
    orbit, expected = ns.exact(case_of(scene)), ns.exact(joints())
    assert orbit.case.scene.motion == expected.case.scene.motion
    assert orbit.durations == pytest.approx(expected.durations, rel=1e-13)
    texts = [motion["phases"][0]["ends"] for motion in document(ns.scene(scene))["motions"]]
    assert texts[0] == texts[1]
    assert texts[0].count(" or ") == 1  # the other two are of the mirror image


def test_what_neither_demands_nor_events_decide_is_no_motion() -> None:
    """Where the upper slider gives way, the lower one may hold or not, for all demands say."""
    phases = tuple(
        replace(q, ends=_or(*(replace(each, to="") for each in q.ends.each)))
        for q in FRAME.phases
    )
    case = case_of(replace(FRAME, phases=phases))
    words = r"where stick ends, both or top may follow: let `to` of its event say which"
    with pytest.raises(NoOrbit, match=words):
        ns.exact(case)
    assert "may follow: let `to`" in ns.simulate(case, cycles=10).ended


def _or(first: Event, *others: Event) -> Event:
    return replace(first, others=others)


def test_what_such_a_scene_may_not_be() -> None:
    stick, low, *others = FRAME.phases
    first, second = FRAME.memory
    contact = FRAME.body.at["low"]
    wrong = {
        "memory w_1: at: got 'stuck', expected some of stick, low": replace(
            first, at=("stuck",)
        ),
        "memory w_1: at: got 5 phases, expected some of stick": replace(
            first, at=tuple(q.name for q in FRAME.phases)
        ),
        "memory w_1: at: got 3, expected the name of a phase": replace(first, at=(3,)),
        "memory w_1: value: got the constant": replace(
            first,
            value=first.value
            + sp.Symbol("f_1", positive=True) / sp.Symbol("k_t", positive=True),
        ),
        "phase stick: got w_1, expected it in top alone": replace(first, at=("top",)),
        "memory w_1: value: got a": replace(first, value=contact.a),
    }
    for words, memory in wrong.items():
        with pytest.raises(SceneError, match=words):
            replace(FRAME, memory=(memory, second))
    with pytest.raises(
        SceneError, match=r"at: got 'top', which ends in several ways, exp.*'top',"
    ):
        replace(FRAME, memory=(replace(first, at="top"), second))
    with pytest.raises(SceneError, match="body: got 3, expected a Body"):
        replace(FRAME, body=3)
    nowhere = replace(low, ends=_or(*(replace(q, to="nowhere") for q in low.ends.each)))
    with pytest.raises(
        SceneError, match="phase low: ends: to: got 'nowhere', expected one of st"
    ):
        replace(FRAME, phases=(stick, nowhere, *others))
    crossed = replace(stick, ends=_or(*(replace(q, to="low") for q in stick.ends.each)))
    with pytest.raises(
        SceneError, match=r"ends: to: got 'low', expected '-low', as another ev"
    ):
        replace(FRAME, phases=(crossed, low, *others))
    with pytest.raises(SceneError, match="phase low: ends: to: got 3, expected the name of a"):
        replace(FRAME, phases=(stick, replace(low, ends=replace(low.ends, to=3)), *others))


@pytest.mark.parametrize("ends", [(0.03, 0.1), (0.02, 0.1), (0.04, 0.1)])
def test_a_phase_that_vanishes_is_no_grazing_of_the_next(ends) -> None:
    """There a demand of the next one vanishes too, and its place is known to 1e-8 only."""
    branch = ns.branch(joints(), "low_friction", *ends)
    assert branch.why_it_ended == ("the end of the range",) * 2
    first = branch.events[0]
    assert (first.kind, first.phase) == ("vanishing", "top"), branch
    assert first.parameter == pytest.approx(0.045859413882997, rel=1e-13)


def with_all_phases():
    """Return the frame with all nine phases declared, each with its events, and no half."""
    force, spring, frequency = sp.symbols("F k_t Omega", positive=True)
    limits = sp.symbols("f_low f_top", positive=True)
    sliders = sp.symbols("w_low w_top", real=True)
    stiffness = sp.Matrix([[2, -1], [-1, 1]])
    body = Body(
        M=sp.eye(2), K=stiffness, C=stiffness / 20, forcing=[0, force],
        at={"low": [1, 0], "top": [0, 1]},
    )  # fmt: skip
    contacts, phases = list(body.at.values()), []
    for name in map("".join, product("spm", repeat=2)):  # it sticks, or slips with or against
        laws, demands, ends = [], {}, []
        for i, (contact, limit, slider) in enumerate(
            zip(contacts, limits, sliders, strict=True)
        ):
            pull, others = spring * (contact.x - slider), (name[:i], name[i + 1 :])
            if name[i] == "s":
                ends += [Event(pull - limit, to="p".join(others))]
                ends += [Event(pull + limit, to="m".join(others))]
                demands[f"{i} sticks"] = limit - sp.Abs(pull)
            else:
                ends += [Event(contact.v, to="s".join(others))]
                demands[f"{i} slips"] = contact.v * (1 if name[i] == "p" else -1)
            laws.append(contact.force + {"s": pull, "p": limit, "m": -limit}[name[i]])
        phases.append(Phase(name, tuple(laws), reduce(or_, ends), demands))
    set_by = (
        tuple(phase.name for phase in phases if phase.name[i] == "s")
        for i in range(len(sliders))
    )
    places = (contact.x + contact.force / spring for contact in contacts)
    memory = tuple(map(Memory, sliders, set_by, places, ("low slider", "top slider")))
    values = {"low": (limits[0], "N", 0.1), "top": (limits[1], "N", 0.2)}
    values |= {"spring": (spring, "N/m", 1.0), "force": (force, "N", 0.3)}
    values |= {"frequency": (frequency, "rad/s", 0.6)}
    return scene_of("all", parameters(**values), *phases, body=body, memory=memory)


def test_phases_and_their_images_vanish_at_once_where_no_half_is_declared() -> None:
    """On the way two contacts switch in the other order, in both halves of the period."""
    branch = ns.branch(with_all_phases()(low=0.081), "low", 0.0797, 0.0815)
    assert branch.why_it_ended == ("the end of the range",) * 2
    of_half = ns.branch(joints(low_friction=0.081), "low_friction", 0.0797, 0.0815)
    found, expected = ([e.parameter for e in each.events] for each in (branch, of_half))
    assert found == pytest.approx(expected, rel=1e-12)
    assert len(found) == 1
