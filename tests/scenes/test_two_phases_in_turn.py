"""Phases that move alike follow each other where their demands differ.

A mass on a belt sticks, and goes on sticking as it comes to an elastic stop: friction holds
other forces.  A tool out of the work goes on moving freely where the tooth is out, too.
"""

import pickle
import runpy
from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from made_scenes import parameters
from scipy.integrate import solve_ivp
from shown import ROOT

import nonsmooth as ns
from nonsmooth.codegen.equations.of_scene import scene_equations
from nonsmooth.codegen.scene import SceneError
from nonsmooth.scene import Body, Event, Phase, Scene, a, forcing, v, x

m, k, V, S, K, k_1, g = sp.symbols("m k V S K k_1 g", positive=True)
c, w = sp.symbols("c w", nonnegative=True)
SLIDES, FREE, PRESSED = m * a + c * v + k * x - K + w * (V - v), k * x + c * V, k_1 * (x - g)
MET, STUCK = Event(x - g), Event(v - V)


def stick(name: str, load: sp.Expr, demands: Mapping[str, sp.Expr]) -> Phase:
    holds = {"friction holds": S - load, "either way": S + load}
    return Phase(name, a, ends=Event(load - S) | MET, demands=holds | demands, held=V)


SCENE = Scene(
    "belt-and-stop",
    "a belt and a stop",
    parameters=parameters(
        mass=(m, "kg", 1.0), damping=(c, "N s/m", 0.05), stiffness=(k, "N/m", 1.0),
        belt=(V, "m/s", 0.5), static=(S, "N", 1.0), kinetic=(K, "N", 0.7),
        weak=(w, "N s/m", 0.15), contact=(k_1, "N/m", 4.0), gap=(g, "m", 0.9),
    ),
    phases=(
        stick("stick", FREE, {"before": g - x}),
        Phase("slip", SLIDES, ends=STUCK | MET, demands={"slower": V - v, "before": g - x}),
        stick("hold", FREE + PRESSED, {"behind": x - g}),
        Phase(
            "slide",
            SLIDES + PRESSED,
            ends=STUCK | MET,
            demands={"slower": V - v, "behind": x - g},
        ),
    ),
)  # fmt: skip
BELT, ORDER = ns.scene(SCENE), "slip,stick,hold,slide"


def period(values: Mapping[str, float]) -> float:
    """Return the period by SciPy: sliding from the break-away to the belt's speed, and back."""
    M, C, k0, belt, static, kinetic, weak, k1, gap = values.values()
    begin = (static - C * belt) / k0
    on = begin > gap
    begin = (static - C * belt + k1 * gap) / (k0 + k1) if on else begin
    state, passed = np.array([begin, belt]), 0.0

    def rates(_, y):
        force = kinetic - weak * (belt - y[1]) - C * y[1] - k0 * y[0]
        return [y[1], (force - k1 * (y[0] - gap) * on) / M]

    def met(_, y):
        return y[0] - gap

    def stuck(_, y):
        return y[1] - belt

    stuck.direction, met.terminal, stuck.terminal = 1, True, True
    while True:
        met.direction = -1 if on else 1
        arguments = rates, (0, 100), state, "DOP853"
        found = solve_ivp(*arguments, events=[met, stuck], rtol=1e-13, atol=1e-14)
        state, passed, on = found.y[:, -1], passed + found.t[-1], not on
        if len(found.t_events[1]):
            return float(passed + (begin - state[0]) / belt)


@pytest.mark.parametrize("phases", [None, ORDER])
@pytest.mark.parametrize(("method", "order"), [("ck-tau", 10), ("ck", 12)])
def test_the_orbit_has_both(phases, method, order) -> None:
    """In closed form: the stop is met at its place, and left at the limit of friction."""
    orbit = ns.solve(BELT(), method, order, phases=phases)
    assert [q.name.split("_")[0] for q in orbit.phases] == ORDER.split(",")
    assert orbit.period == pytest.approx(period(BELT().values), rel=1e-10)
    assert orbit.durations[2] == pytest.approx(
        ((1 - 0.025 + 4 * 0.9) / 5 - 0.9) / 0.5, rel=1e-9
    )
    assert orbit.stable
    assert orbit.multipliers.tolist() == [0.0]
    assert pickle.loads(pickle.dumps(orbit)).case == orbit.case


def test_a_scene_may_declare_both_in_turn() -> None:
    by = {phase.name: phase for phase in SCENE.phases}
    ends = STUCK, MET, Event(FREE + PRESSED - S), MET
    in_turn = [replace(by[q], ends=e) for q, e in zip(ORDER.split(","), ends, strict=True)]
    scene = ns.scene(replace(SCENE, name="belt-in-turn", phases=tuple(in_turn)))
    assert scene.classes == (2, 1, 8, 1)
    assert ns.solve(scene()).period == pytest.approx(period(scene().values), rel=1e-12)
    twice = (in_turn[0], in_turn[1], replace(in_turn[1], name="again"), in_turn[3])
    with pytest.raises(SceneError, match="again: its motion is that of stick; nothing changes"):
        ns.scene(replace(SCENE, name="belt-twice", phases=twice))


@pytest.mark.parametrize("start", [0.85, 1.1])
def test_a_branch_goes_on_where_friction_yields_at_the_stop(start) -> None:
    """Where the gap is ``(S - c V) / k``: beyond, the mass slides before the stop behind it."""
    case = BELT(gap=start)
    branch = ns.branch(case, "gap", 0.85, 1.1)
    assert branch.why_it_ended == ("the end of the range",) * 2
    (event,) = branch.events
    assert event.parameter == pytest.approx(0.975, rel=1e-12)
    rows = [row for row in branch if row.value != event.parameter]
    for row in rows[:: len(rows) // 6]:
        values = dict(case.values) | {"gap": row.value}
        assert sum(row.durations) == pytest.approx(period(values), rel=1e-10)
        assert ("hold" in row.motion) == (row.value < 0.975)
        assert row.stable


def switches_of_a_cut(orbit: ns.Orbit) -> tuple[list[float], np.ndarray]:
    """Return the times in which a tool cuts or does not, by SciPy, and its last state.

    From the beginning of an orbit, for one period: where it cuts follows from the state alone.
    """
    _, damping, stiffness, cutting, feed, omega = orbit.case.values.values()
    first, turn, passed = orbit.phases[0], orbit.forcing_phase, [0.0]
    state = np.array([first.displacement, first.velocity])

    def tooth(t, y):
        return np.cos(omega * t + turn)

    def edge(t, y):
        return y[0] - feed

    tooth.terminal = edge.terminal = True
    while passed[-1] < orbit.period * (1 - 1e-9):
        step, begins = 1e-4, passed[-1]
        ahead = state + step * np.array([state[1], 0.0])
        inside = tooth(begins + step, ahead) > 0
        cuts = inside and edge(begins + step, ahead) < 0

        def rates(_, y, cuts=cuts):
            return [y[1], -damping * y[1] - stiffness * y[0] + cuts * cutting * (feed - y[0])]

        options = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-14}
        beyond = solve_ivp(rates, (begins, begins + step), state, **options)
        span = begins + step, begins + orbit.period
        events = [tooth, edge] if inside else [tooth]
        found = solve_ivp(rates, span, beyond.y[:, -1], events=events, **options)
        state = found.y[:, -1]
        passed.append(found.t[-1])
    return np.diff(passed).tolist(), state


FILE = ROOT / "examples/scenes/interrupted_cut.py"
CUTS = ns.scene(str(FILE))


@pytest.mark.parametrize(
    ("frequency", "names"),
    [
        (1.0, "cut,out,cut_by_2,off_by_2"),
        (1.01, "out,cut_by_2,off"),
        (0.56, "cut,out,cut_by_2,off_by_2"),
    ],
)
def test_a_tool_off_the_work_goes_on_where_the_tooth_is_out(frequency, names) -> None:
    """Both phases are free: each demands what the other excludes."""
    orbit = ns.solve(CUTS(frequency=frequency), order=14)
    assert orbit.case.scene.motion == names
    assert orbit.stable
    durations, state = switches_of_a_cut(orbit)
    assert orbit.durations == pytest.approx(durations, abs=1e-9)
    first = orbit.phases[0]
    assert state == pytest.approx([first.displacement, first.velocity], abs=1e-9)
    asked = ns.solve(CUTS(frequency=frequency), order=14, phases=names)
    assert asked.durations == pytest.approx(orbit.durations, rel=1e-12)


@pytest.mark.parametrize(("method", "most"), [("ck", 1e-11), ("ck-tau", 1e-10)])
def test_where_nothing_jumps_functions_are_of_some_class(method, most) -> None:
    orbit = ns.solve(CUTS(frequency=1.01), method, 11, phases="out,cut_by_2,off")
    assert orbit.errors.times < most


def test_the_printed_equations_say_where_nothing_jumps() -> None:
    """There the functions are of one class in all equations: tests, unknowns, continuity."""
    scene = runpy.run_path(str(FILE))["SCENE"]
    titles = [each.title for each in scene_equations(scene)]
    assert "no derivative jumps where off begins" in titles
    assert "the motion is `C^1` where cut begins: its second derivative jumps" in titles
    derived = ns.equations("ck", scene).equations
    titles = [each.title for each in derived]
    assert "test function in off, `P_n` integrated 5 times from the switch" in titles
    assert "what no test in off sees, of degree up to `N + 5`" in titles
    assert "derivative 4 is continuous where off begins" in titles
    assert "derivative 5 is continuous where off begins" not in titles


@pytest.mark.parametrize("start", [0.99, 1.005])
def test_a_branch_passes_from_one_phase_into_the_other(start) -> None:
    """The tool comes back to the work as the tooth leaves it, at a speed: a cut vanishes."""
    branch = ns.branch(CUTS(frequency=start), "frequency", 0.98, 1.01)
    assert branch.why_it_ended == ("the end of the range",) * 2
    (event,) = branch.events
    assert event.kind == "vanishing"
    for row in branch:
        count = 4 if row.value < event.parameter else 3
        assert len(row.durations) == count or row.value == event.parameter


@pytest.mark.parametrize("start", [-0.9, -0.75, -0.3])
def test_a_phase_vanishes_from_either_side(start) -> None:
    """Behind an edge a spring acts for half of the period; the edge is passed as it begins."""
    F, Omega, edge = *sp.symbols("F Omega", positive=True), sp.Symbol("g", real=True)
    law = m * a + c * v + k * x - F * forcing
    ends = Event(forcing) | Event(x - edge)
    phases = (
        Phase("below", law, ends, {"on": forcing, "below": edge - x}),
        Phase("above", law + k_1 * (x - edge), ends, {"on": forcing, "above": x - edge}),
        Phase("off", law, Event(forcing), {"off": -forcing}),
    )
    known = parameters(
        mass=(m, "kg", 1.0), damping=(c, "N s/m", 0.6), stiffness=(k, "N/m", 1.0),
        spring=(k_1, "N/m", 0.5), edge=(edge, "m", start), force=(F, "N", 1.0),
        frequency=(Omega, "rad/s", 1.3),
    )  # fmt: skip
    case = ns.scene(Scene("window", "a spring", known, phases, frequency=Omega))()
    (event,) = ns.branch(case, "edge", -0.95, -0.2).events
    assert event.kind == "vanishing"
    beside = ns.exact(case.scene(edge=event.parameter + 1e-7))
    (opens,) = [q for q in beside.phases if q.name.startswith("below")]
    assert opens.displacement == pytest.approx(event.parameter, abs=1e-6)
    assert opens.velocity < -0.1


def test_a_structure_may_move_alike_in_two_phases() -> None:
    """Two masses that nothing joins: that of the tool moves as it does alone."""
    Omega = sp.Symbol("Omega", positive=True)
    body = Body(
        M=[[1, 0], [0, 3]], C=[[0.05, 0], [0, 0.5]], K=[[1, 0], [0, 2]],
        forcing=[0, 1], at={"tool": [1, 0]},
    )  # fmt: skip
    tool = body.at["tool"]
    tooth, edge = Event(forcing), Event(tool.x - g)
    cut, off = {"cuts": g - tool.x}, {"off": tool.x - g}
    phases = (
        Phase("cut", tool.force - k * (g - tool.x), tooth | edge, {"in": forcing} | cut),
        Phase("out", tool.force, tooth, {"out": -forcing}),
        Phase("off", tool.force, tooth | edge, {"in": forcing} | off),
    )
    known = parameters(
        cutting=(k, "N/m", 0.5), feed=(g, "m", 0.1), frequency=(Omega, "rad/s", 1.0)
    )
    data = {"body": body, "frequency": Omega, "phases": phases, "parameters": known}
    orbit = ns.solve(ns.scene(Scene("cut-2", "a tool", **data))(), order=14)
    alone = ns.solve(CUTS(), order=14)
    assert orbit.case.scene.motion == alone.case.scene.motion
    assert orbit.durations == pytest.approx(alone.durations, rel=1e-9)
