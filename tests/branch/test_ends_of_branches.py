"""Where branches of bodies begin and end, and what they say of it."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
import sympy as sp
from made_scenes import in_a_row, made, parameters, scene_of
from scipy.optimize import brentq

import nonsmooth as ns
from nonsmooth.codegen.scenes import chain_impact as impacts
from nonsmooth.codegen.scenes import clearance as springs
from nonsmooth.scene import Body, Event, Phase, a, forcing, v, x
from nonsmooth.solver import branches
from nonsmooth.solver.bodies.motion import Given, signals
from nonsmooth.solver.branch import every_way
from nonsmooth.solver.branch.branch import go
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.results.branch import BranchEvent
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.parameter_error import ParameterError

#: Most of the range of a parameter in a step.
PART = 1 / 8


@pytest.fixture(autouse=True)
def few_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    """Follow branches by longer steps: events are located to rounding all the same."""
    for module in (branches, every_way):
        monkeypatch.setattr(module, "go", partial(go, part=PART))


def test_a_branch_ends_where_there_is_no_such_body() -> None:
    """With critical damping the poles of each mode are one: what was found is kept."""
    overdamped = ns.scene("beam-clearance")(modes=2, ratio=0.99, gap=1e-5)
    found = ns.branch(overdamped, "ratio", 0.98, 1.0)
    assert found.why_it_ended == ("the end of the range", "the step cannot get smaller")
    assert 0.999 < max(row.value for row in found.rows) < 1.0


def test_a_branch_begins_where_there_is_a_body() -> None:
    """At the case's own frequency the forcing is faster than all modes that are kept."""
    few = ns.scene("beam-clearance")(modes=3, frequency=2000.0)
    orbit = branches._start(few, "frequency", (100.0, 2500.0))
    assert orbit.case.values["frequency"] == 100.0
    with pytest.raises(ParameterError, match="keep more of them"):
        ns.branch(few, "frequency", 1800.0, 2500.0)


def test_a_branch_ends_where_the_forcing_is_as_fast_as_all_modes() -> None:
    one = ns.scene("beam-clearance")(modes=1, frequency=92.0)
    found = ns.branch(one, "frequency", 91.0, 96.0)
    words = "the forcing is faster than all modes that are kept: keep more of them"
    assert found.why_it_ended == ("the end of the range", f"beyond, body: {words}")
    (square,) = one.cell.body.squares
    assert found.rows[-1].value == pytest.approx(np.sqrt(square) / one.units.time, rel=1e-9)


def test_a_number_of_modes_is_swept_and_not_followed() -> None:
    beam = ns.scene("beam-clearance")(modes=3)
    assert [row.followed for row in ns.family(beam, "modes", [2, 3, 4])] == [False] * 3
    with pytest.raises(NoOrbit, match="modes = 3: the equations are not smooth along the par"):
        ns.branch(beam, "modes", 2, 4)


def answer(case: Case, omega: float, joint: float) -> np.ndarray:
    """Return the amplitudes of both masses with a spring of this stiffness between them."""
    v = case.values
    k, c = v["absorber_stiffness"] + joint, v["absorber_damping"]
    K = np.array([[v["stiffness"] + k, -k], [-k, k]])
    C = np.array([[v["damping"] + c, -c], [-c, c]])
    M = np.diag([v["mass"], v["absorber_mass"]])
    found = np.linalg.solve(K - omega**2 * M + 1j * omega * C, [v["force"], 0.0])
    return np.asarray(found)


def at_the_limit(case: Case, force: Callable[[float], float], near: float) -> float:
    """Return where along the frequency a force is that of friction."""

    def beyond(omega: float) -> float:
        return force(omega) - case.values["friction"]

    return float(brentq(beyond, 0.999 * near, 1.001 * near, xtol=1e-300, rtol=1e-15))


def test_a_slip_vanishes_where_friction_just_holds() -> None:
    """Both masses then move as one, which is no branch to follow: it ends.

    At the case's own frequency, at the ends and in the middle they do, too.
    """
    case = ns.scene("absorber-friction")(force=0.1)

    def force(omega: float) -> float:
        v = case.values
        mass, loss = v["mass"] + v["absorber_mass"], 1j * omega * v["damping"]
        moved = v["force"] / (v["stiffness"] - mass * omega**2 + loss)
        return float(v["absorber_mass"] * omega**2 * abs(moved))

    branch = ns.branch(case, "frequency", 0.5, 2.1)
    assert set(branch.why_it_ended) == {"sticking, beyond which the motion stays in stick"}
    assert {event.kind for event in branch.events} == {"sticking"}
    low, high = min(branch.events, key=_value), max(branch.events, key=_value)
    for event in (low, high):
        wanted = at_the_limit(case, force, event.parameter)
        assert event.parameter == pytest.approx(wanted, rel=1e-14)


@pytest.mark.parametrize(
    ("name", "ends", "expected"),
    [("gap", (-3, 0.2), -1.0), ("force", (0.1, 1), 0.5), ("stiffness", (1, 3), 2.0)],
)
def test_a_flight_vanishes_where_the_stop_holds_the_mass_for_ever(name, ends, expected) -> None:
    """Its force is there at most what the spring presses the mass on to the stop with."""
    values = {"force": 1.0, "stiffness": 1.0} | ({} if name == "gap" else {"gap": -0.5})
    found = ns.branch(ns.scene("impact-inelastic")(**values), name, *ends)
    (event,) = [q for q in found.events if q.phase == "flight"]
    assert event.kind == "sticking"
    assert f"{event.kind}, beyond which the motion stays in rest" in found.why_it_ended
    assert event.parameter == pytest.approx(expected, rel=2e-15)


def joined_row(damping: sp.Matrix):
    """Return five masses in a row, the last on friction with the one before it."""
    F, f, Omega = sp.symbols("F f Omega", positive=True)
    row = Body(
        M=np.eye(5), K=1.085 * in_a_row([1.0] * 5), C=damping, modes=3,
        forcing=sp.Matrix([F, 0, 0, 0, 0]), at={"joint": [0, 0, 0, -1, 1]},
    )  # fmt: skip
    joint = row.at["joint"]
    slip = Phase("slip", joint.force + f, Event(joint.v), {"it slips": joint.v})
    holds = {"it holds": f - sp.Abs(joint.force)}
    stick = Phase("stick", joint.a, Event(joint.force - f), holds, held=0)
    own = parameters(
        force=(F, "N", 0.345), friction=(f, "N", 0.1), frequency=(Omega, "rad/s", 0.74)
    )
    return scene_of("joined-row", own, slip, stick, half_period=True, body=row)


def test_a_slip_of_a_joint_vanishes_where_friction_just_holds() -> None:
    """What is below zero by rounding, as it vanishes, does not end the branch before."""
    damping = sp.zeros(5, 5)
    damping[0, 0], damping[1, 1], damping[2, 2], damping[4, 4] = 0.18, 0.18, 0.55, 0.037
    damping[1, 2] = damping[2, 1] = -0.061
    case = joined_row(damping)()
    body, omega = case.cell.body, case.cell.omega
    stiff = np.diag(body.squares - omega**2) + 1j * omega * body.damping
    free, pushed = np.linalg.solve(stiff, np.column_stack([body.forcing, body.at])).T
    force = abs((body.at[:, 0] @ free + body.beyond[0]) / (body.at[:, 0] @ pushed))
    law = case.cell.phases[0].laws[0]
    wanted = case.values["force"] * abs(law[3] / law[4]) / force
    branch = ns.branch(case, "force", 0.5 * wanted, 1.5 * wanted)
    assert "sticking, beyond which the motion stays in stick" in branch.why_it_ended
    (event,) = branch.events
    assert event.parameter == pytest.approx(wanted, rel=1e-12)


def test_a_slider_stops_where_its_spring_just_holds() -> None:
    case = ns.scene("jenkins-absorber")()
    k = case.values["tangential_stiffness"]

    def force(omega: float) -> float:
        first, second = answer(case, omega, k)
        return float(k * abs(second - first))

    branch = ns.branch(case, "frequency", 0.6, 1.8)
    assert {why.split(",")[0] for why in branch.why_it_ended} == {"vanishing"}
    for event in branch.events:
        wanted = at_the_limit(case, force, event.parameter)
        assert event.parameter == pytest.approx(wanted, rel=1e-14)


def test_no_motion_is_followed_of_which_there_is_one_for_each_memory() -> None:
    """Where the slider has stopped for ever it may be at any of many places."""
    case = ns.scene("jenkins-absorber")(
        mass=0.88, absorber_mass=0.068, stiffness=1.0, absorber_stiffness=0.032,
        tangential_stiffness=0.065, damping=0.036, absorber_damping=0.002, force=0.245,
        frequency=0.845,
    )  # fmt: skip
    branch = ns.branch(case, "friction", 0.039, 0.061)
    sets = "nothing sets w, which may have any of many values"
    assert branch.why_it_ended == ("the end of the range", f"vanishing, beyond which {sets}")
    assert {row.motion for row in branch.rows} == {None}


def _value(event: BranchEvent) -> float:
    return event.parameter


def test_a_demand_at_a_switch_ends_a_branch_where_it_is_just_met() -> None:
    """The chain must hit its stop with some speed: its branch ends at an impact of that."""
    least, end = sp.Symbol("v_0", positive=True), impacts.END
    hard = Event(
        end.x - impacts.g,
        jump={end.v: -impacts.r * end.v},
        demands={"it hits hard enough": end.v - least},
    )
    scene = replace(
        impacts.SCENE,
        name="chain-latch",
        phases=(replace(impacts.FLIGHT, ends=hard),),
        parameters=impacts.SCENE.parameters + parameters(least=(least, "m/s", 1.4)),
    )
    latch = ns.scene(scene)
    found = ns.branch(latch(), "gap", 0.9, 1.2)
    (event,) = found.events
    beyond = f"{event.kind}, beyond which no order of phases is found"
    assert found.why_it_ended == ("the end of the range", beyond)
    freely = exact_orbit(latch(gap=event.parameter, least=1e-3))
    _, speed, *_ = signals(Given(freely.case.cell, 0), freely.times, 0, np.ones(1))[:, 0]
    assert speed * freely.case.units.of_motion(1) == pytest.approx(1.4, rel=1e-13)


@pytest.mark.parametrize("size", [1e-6, 1e9])
def test_beyond_a_grazing_it_goes_on_whatever_the_units(size: float) -> None:
    """What the displacement is in the units of a scene may be far from 1."""

    def response(size: float) -> ns.Branch:
        contact, free = (1, 0.2, 5, 2 * size, size), (1, 0.2, 1, 0, size)
        demands = {"in contact": (1, 0, 0, -size / 2)}, {"free": (-1, 0, 0, size / 2)}
        scene = made([contact, free], [(1, 0, 0, -size / 2)] * 2, omega=1.3, demands=demands)
        return ns.branch(scene(), "frequency", 1.2, 2.6)

    one, found = response(1.0), response(size)
    (grazing,), (expected,) = found.events, one.events
    assert grazing.kind == "grazing"
    assert grazing.parameter == pytest.approx(expected.parameter, rel=1e-9)
    assert found.why_it_ended == one.why_it_ended == ("the end of the range",) * 2


def test_a_stick_on_a_belt_ends_where_the_linear_response_just_has_its_speed() -> None:
    """Beyond, the mass slips for ever: its motion is at rest elsewhere than where it stuck."""
    m, c, k, f, F, V, Omega = sp.symbols("m c k f F V Omega", positive=True)
    load = F * forcing - k * x - c * V
    stick = Phase(
        "stick", a, held=V, ends=Event(f + load), demands={"it sticks": f - sp.Abs(load)}
    )
    slip = Phase(
        "slip", a * m + c * v + k * x - F * forcing - f, ends=Event(v - V),
        demands={"it is slower than the belt": V - v},
    )  # fmt: skip
    own = parameters(
        m=(m, "kg", 0.2355), c=(c, "N s/m", 0.0447), k=(k, "N/m", 1.6), f=(f, "N", 0.05),
        F=(F, "N", 1.379), V=(V, "m/s", 0.67), frequency=(Omega, "rad/s", 0.7),
    )  # fmt: skip
    branch = ns.branch(scene_of("belt", own, stick, slip)(), "k", 1.5, 1.9)
    reach = np.sqrt((1.379 * 0.7 / 0.67) ** 2 - (0.0447 * 0.7) ** 2)
    assert [event.kind for event in branch.events] == ["sticking"]
    assert branch.events[0].parameter == pytest.approx(0.2355 * 0.7**2 + reach, rel=1e-12)
    assert branch.why_it_ended == ("the end of the range",) * 2
    assert branch[-1].motion == "only slip"
    amplitude = 1.379 / abs(1.9 - 0.2355 * 0.7**2 + 0.0447j * 0.7)
    mean = 0.05 / 1.9
    ends = mean - amplitude, mean + amplitude
    assert branch[-1].extremes["displacement"] == pytest.approx(ends, rel=1e-12)


def test_a_branch_of_a_motion_with_a_phase_that_no_longer_motion_has() -> None:
    """Far from the spring a mass that bounces off a stop is the scene `impact`."""
    g, r = sp.symbols("g_2 r", positive=True)
    hit = Phase(
        "hit", springs.SEPARATED.equation, ends=Event(x + g, jump={v: -r * v}),
        demands={"it is above the stop": x + g, **springs.SEPARATED.demands},
    )  # fmt: skip
    scene = replace(
        springs.SCENE, name="spring-or-stop", phases=(), guess=(), extremes={},
        motions={"spring": (springs.CONTACT, springs.SEPARATED), "stop": (hit,)},
        parameters=springs.SCENE.parameters
        + parameters(stop=(g, "m", 0.1), restitution=(r, "", 0.6)),
    )  # fmt: skip
    numbers = {"damping": 0.1, "frequency": 1.8}
    found = ns.branch(ns.scene(scene)(gap=50.0, **numbers), "frequency", 1.7, 1.9)
    expected = ns.branch(ns.scene("impact")(gap=0.1, **numbers), "frequency", 1.7, 1.9)
    assert {row.motion for row in found} == {"stop"}
    for i in (0, -1):
        assert found[i].multipliers == pytest.approx(expected[i].multipliers, rel=1e-9)


def test_a_branch_is_closed_where_the_angle_of_the_forcing_turns_round() -> None:
    """Once around this island, the forcing is ahead by a cycle: the orbits are the same."""
    M = np.diag([2.0, 1.5, 1.0])
    K = np.array([[500.0, -200.0, 0.0], [-200.0, 350.0, -150.0], [0.0, -150.0, 150.0]])
    g, omega = sp.symbols("g Omega", positive=True)
    chain = Body(M=M, K=K, C=0.002 * K + 0.1 * M, forcing=[6, 0, 0], at={"tip": [0, 0, 1]})
    tip = chain.at["tip"]
    stop = Event(tip.x - g, jump={tip.v: -0.7 * tip.v})
    flight = Phase("flight", tip.force, ends=stop, demands={"before the stop": g - tip.x})
    own = parameters(gap=(g, "m", 0.02), frequency=(omega, "rad/s", 5.8))
    found = ns.branch(scene_of("chain", own, flight, body=chain)(), "frequency", 4.0, 12.0)
    assert found.why_it_ended == ("the branch is closed",) * 2
    assert [event.kind for event in found.events] == ["grazing", "torus", "flip", "grazing"]
