"""Simulated bodies: against exact orbits, an integrator, and matrix exponentials."""

import json
import math

import numpy as np
import pytest
import sympy as sp
from bodies import test_random_chains as chains
from bodies.reference_bodies import body, case, of
from every_run import tried
from exponentials import generator
from made_scenes import in_a_row, parameters, scene_of
from refusals import refused
from scipy.integrate import solve_ivp
from scipy.linalg import expm

import nonsmooth as ns
from nonsmooth.scene import Body, Event, Phase
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.existence.bodies import solutions
from nonsmooth.solver.in_order import cases_in_order
from nonsmooth.solver.orbit.exact_orbit import from_times
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.simulation.settle import rough_times_by_simulation

#: Orbits that a motion from rest comes to; of the others of the file three are ghosts, five
#: are not stable, one has no phase for what happens on the way, and two begin beyond a stop
#: that their scenes do not have alone: these are reached from a phase in balance.
REACHED = (
    *("impact-2", "impact-2-two-cycles", "impact-3-two-impacts", "impact-3-not-proportional"),
    *("absorber-stick", "absorber-stick-full-period", "chain-3-stick", "chain-5-stick"),
    *("chain-3-static-above-kinetic", "chain-20-stick", "belt-2", "jenkins-absorber"),
    *("jenkins-absorber-full-period", "clearance-2", "clearance-2-four-cycles"),
    *("clearance-2-damped-contact", "beam-4-spring", "beam-10-spring", "beam-20-spring"),
    *("beam-4-impact", "beam-10-impact", "beam-20-impact"),
)
#: One of each law; a simulation leads to each of the others in every run all the same.
EACH_LAW = (
    *("impact-2-two-cycles", "impact-3-not-proportional", "absorber-stick-full-period"),
    *("chain-5-stick", "belt-2", "jenkins-absorber", "clearance-2-damped-contact"),
    *("beam-4-spring", "beam-4-impact"),
)
IN_BALANCE = ("two-stops-six-phases", "two-stops-four-phases")


@pytest.mark.parametrize("name", tried(REACHED, every_run=EACH_LAW))
def test_a_motion_from_rest_comes_to_the_reference(name: str) -> None:
    """Behind so many periods that 1e-12 of the transient is left."""
    r, own = of(name), case(name)
    periods = 20 + math.log(1e-12) / math.log(r.radius)
    time = (periods + 2) * r.period * (2 if r.half_period else 1)
    motion = ns.simulate(own, time=time)
    assert motion.ended == ""
    cells = 2 if r.half_period else 1
    count = len(r.durations) * cells
    last = motion.phases[-1 - count : -1]
    turns = [
        max(abs(q.duration - s) for q, s in zip(last, expected, strict=True))
        for i in range(count)
        for expected in [(r.durations * cells)[i:] + (r.durations * cells)[:i]]
    ]
    assert min(turns) <= 1e-9 * r.period


@pytest.mark.parametrize("name", [*REACHED, *IN_BALANCE])
def test_a_simulation_leads_to_the_reference(name: str) -> None:
    """Newton's method takes it to rounding, from one of the phases that are alike."""
    r, own = of(name), case(name)
    settled = next(q for q in rough_times_by_simulation(own) if q.times is not None)
    found = from_times(own, settled.times)
    assert found.admissible
    count = len(r.durations)
    turns = [r.durations[i:] + r.durations[:i] for i in range(count)]
    off = [np.abs(np.array(found.durations[:count]) - turn).max() for turn in turns]
    assert min(off) <= 2e-11 * r.period


def test_events_of_a_chain_are_those_of_an_integrator() -> None:
    """Fifty periods of the forcing with an elastic stop, in physical coordinates."""
    r, own = of("clearance-2"), case("clearance-2")
    p, arrays = r.parameters, {q: m.dense() for q, m in body(r).arrays.items()}
    C, K, end = arrays["C"], arrays["K"], arrays["at"][:, 0]
    pushed, omega = arrays["forcing"][:, 0], p["Omega"]
    time = 50 * 2 * math.pi / omega

    def rates(stop: float):
        def rate(t, z):
            q, v = z[:2], z[2:]
            push = stop * (end @ q - p["g"])
            return np.concatenate([v, pushed * np.cos(omega * t) - C @ v - K @ q - end * push])

        return rate

    def gap(t, z):
        return p["g"] - end @ z[:2]

    gap.terminal = True
    t, z, touching, switches = 0.0, np.zeros(4), False, []
    while t < time:
        gap.direction = 1.0 if touching else -1.0
        found = solve_ivp(
            rates(p["kc"] if touching else 0.0), (t, time), z, "DOP853", events=gap,
            rtol=1e-12, atol=1e-13,
        )  # fmt: skip
        t, z = found.t[-1], found.y[:, -1]
        touching = not touching
        switches.append(t)
    motion = ns.simulate(own, cycles=50)
    starts = [q.start for q in motion.phases[1:]]
    assert len(starts) == len(switches) - 1 > 90
    assert starts == pytest.approx(switches[:-1], abs=1e-9)


@pytest.fixture(scope="module", params=["rigid", "elastic"])
def scene(request):
    """Return a random chain's scene, derived once."""
    return chains.chain(request.param)


@pytest.mark.parametrize("seed", range(8))
def test_random_chains_keep_their_demands(scene, seed: int) -> None:
    """By matrix exponentials in physical coordinates, from rest on: no event is missed."""
    random, rigid = np.random.default_rng(100 + seed), scene.name == "rigid-stop"
    values = {q.name: random.uniform(0.3, 1.5) for q in scene.parameters}
    values["damping"] = random.uniform(0.02, 0.3)
    if rigid:
        values["restitution"] = random.uniform(0.2, 0.9)
    motion = ns.simulate(scene(**values), cycles=8)
    n, gap, X = chains.COUNT, values["gap"], np.zeros(2 * chains.COUNT + 3)
    X[[-3, -1]] = 1.0
    for i, phase in enumerate(q for q in motion.phases if q.duration > 1e-6):
        pressed = phase.name == "touch"
        assert phase.displacement == pytest.approx(X[n - 1], abs=1e-9)
        A = chains.moved(values, values["stop"] if pressed else 0.0)
        step = expm(A * phase.duration / chains.POINTS)
        for _ in range(chains.POINTS):
            assert (1.0 if pressed else -1.0) * (X[n - 1] - gap) >= -1e-9, i
            X = step @ X
        if rigid:
            X[2 * n - 1] *= -values["restitution"]


def test_an_order_that_is_not_declared_is_found() -> None:
    """At half the frequency the motion has six contacts in four periods."""
    r, base = of("clearance-2-four-cycles"), case("clearance-2")
    values = dict(base.values) | {"frequency": r.parameters["Omega"]}
    found = exact_orbit(Case(base.scene, values, r.cycles))
    assert sorted(found.case.scene.phases) == ["contact_1"] * 6 + ["open_0"] * 6
    assert sorted(found.durations) == pytest.approx(sorted(r.durations), rel=1e-11)


def test_an_order_is_asked_for_by_its_phases() -> None:
    own = case("absorber-stick")
    found = [q.scene.motion for q in cases_in_order(own, "slip_0,stick_1,slip_0,stick_1")]
    assert "slip_0,stick_1,mirrored" in found
    assert "slip_0,stick_1,-slip_0,-stick_1" in found
    orbit = ns.solve(own, phases="slip_0,stick_1,-slip_0,-stick_1", order=10)
    assert orbit.durations == pytest.approx(of("absorber-stick-full-period").durations)
    with pytest.raises(ValueError, match="where one cannot follow another"):
        ns.solve(own, phases="stick_1,-stick_1")


def test_an_orbit_in_which_another_phase_would_follow_is_none() -> None:
    """It slips through the velocity at which, with enough static friction, it would stick."""
    r = of("absorber-slip")
    values = dict(case("absorber-stick").values) | {"frequency": r.parameters["Omega"]}

    def crossing(static: float) -> Case:
        friction = {"kinetic": r.parameters["R"], "static": static}
        own = Case(case("absorber-stick").scene, values | friction)
        return next(
            q for q in cases_in_order(own, "slip_0") if q.scene.motion == "slip_0,mirrored"
        )

    found = exact_orbit(crossing(r.parameters["Rs"]))
    assert found.durations == pytest.approx(r.durations, rel=1e-11)
    with pytest.raises(ns.NoOrbit, match=r"where slip_0 ends, -?stick_1 follows, not -slip_0"):
        exact_orbit(crossing(10.0))


def test_a_search_says_what_the_motion_does_instead() -> None:
    scene = ns.scene("chain-impact")
    with pytest.raises(ns.NoOrbit, match="without switches"):
        ns.exact(scene(gap=50.0))


def test_the_contact_force_is_that_of_the_law() -> None:
    own = ns.scene("absorber-friction")()
    motion = ns.simulate(own, cycles=3)
    assert {q.name for q in motion.phases} == {"slip", "stick"}
    for phase in motion.phases:
        t = phase.start + phase.duration * np.linspace(0.1, 0.9, 5)
        force, limit = motion.force(t), own.values["friction"]
        assert np.abs(force).max() <= limit * (1 + 1e-12)
        if phase.name == "slip":
            assert force == pytest.approx([limit if phase.mirrored else -limit] * 5)
    table = motion.table()
    assert table.units["force"] == "N"
    assert np.abs(table.columns["force"]).max() == pytest.approx(own.values["friction"])
    with pytest.raises(ValueError, match="force: the motion is that of one mass"):
        ns.simulate(ns.scene("clearance")(), cycles=1).force(0.0)


def test_the_command(run, tmp_path) -> None:
    _, out, _ = run("simulate", "chain-impact", "--cycles", "4", "--json")
    motion = ns.simulate(ns.scene("chain-impact")(), cycles=4)
    document = json.loads(out)
    assert [q["time"] for q in document["phases"]] == [q.start for q in motion.phases]
    _, out, _ = run("simulate", "chain-impact", "--cycles", "4", "--state", "0,0")
    assert f"{len(motion.phases)} phases in" in out
    beam = ("simulate", "beam-clearance", "--modes", "3", "--cycles", "2")
    for name in ("a.png", "a.csv"):
        assert run(*beam, "-o", tmp_path / name)[0] == 0
    assert "force" in (tmp_path / "a.csv").read_text("utf-8").splitlines()[0]
    _, out, _ = run("simulate", "chain-impact", "--cycles", "4", "--state", "0.1,-1", "--json")
    begun = json.loads(out)["phases"][0]["start"]
    assert tuple(begun.values()) == pytest.approx((0.1, -1.0), rel=1e-14)
    message = refused(run, "simulate", "chain-impact", "--state", "1,1")
    assert "state: got (1.0, 1.0), expected one that a phase of chain-impact takes" in message


def on_a_stop(body: Body, gap: float, frequency: float):
    """Return the scene of a body whose end stays on a stop until it is pulled off."""
    g, Omega, end = sp.Symbol("g", real=True), sp.Symbol("Omega", positive=True), body.at["end"]
    stop = Event(end.x - g, jump={end.v: 0})
    flight = Phase("flight", end.force, stop, {"before the stop": g - end.x})
    rest = Phase("rest", end.a, Event(end.force), {"it presses": -end.force}, held=0)
    own = parameters(gap=(g, "m", gap), frequency=(Omega, "rad/s", frequency))
    return scene_of("stop", own, flight, rest, body=body)


def test_a_row_rests_on_a_stop_until_it_is_pulled_off() -> None:
    """By matrix exponentials of the row, with its end free and held."""
    n, gap = 3, 0.2
    K, C, pulled = in_a_row([1.0] * n), 0.1 * np.eye(n), np.array([0, 0, 1.0])
    row = Body(M=np.eye(n), K=K, C=C, forcing=pulled, at={"end": [0, 0, 1]})
    own = on_a_stop(row, gap, 0.3)
    pressed = ns.simulate(own(gap=-5.0), cycles=8)  # by 5/3 N, and pulled by 1 N
    assert [(q.name, q.displacement) for q in pressed.phases] == [("rest", pytest.approx(-5))]
    motion = ns.simulate(own(), cycles=8)
    free = generator(np.eye(n), K, C, pulled, 0.3)
    held = free.copy()
    held[2 * n - 1] = 0.0
    force = -free[2 * n - 1]  # what keeps the end where it is
    X = np.zeros(2 * n + 3)
    X[-3] = 1.0
    assert motion.ended == ""
    assert [q.name for q in motion.phases[:3]] == ["flight", "rest", "flight"]
    for phase in motion.phases:
        rests = phase.name == "rest"
        assert phase.displacement == pytest.approx(X[n - 1], abs=1e-10)
        step = expm((held if rests else free) * phase.duration / chains.POINTS)
        for _ in range(chains.POINTS):
            assert (-(force @ X) if rests else gap - X[n - 1]) >= -1e-10
            X = step @ X
        X[2 * n - 1] *= rests


def test_without_rebound_rounding_is_no_velocity() -> None:
    """A body of one mass on a stop, and the scene of one mass."""
    body = Body(M=[[0.7]], K=[[3.3]], C=[[0.2]], forcing=[1], at={"end": [1]})
    values = {"gap": 0.17, "frequency": 0.9, "mass": 0.7, "stiffness": 3.3, "damping": 0.2}
    one, case = ns.scene("impact-inelastic")(**values), on_a_stop(body, 0.17, 0.9)()
    for angle in range(5):
        motion = ns.simulate(case, cycles=8, forcing_phase=angle)
        expected = ns.simulate(one, (0, 0), cycles=8, forcing_phase=angle)
        assert motion.ended == ""
        assert [q.name for q in motion.phases] == [q.name for q in expected.phases]
        starts = [[q.start for q in each.phases] for each in (motion, expected)]
        assert starts[0] == pytest.approx(starts[1], abs=1e-12)


def no_gap(stiffer: float = 4.0):
    """Return the scene of two masses of which the second has no gap to what is stiffer."""
    k, F, Omega = sp.symbols("k F Omega", positive=True)
    pair = Body(
        M=np.eye(2), K=k * sp.Matrix([[1, -1], [-1, 1]]), ratio=0.1, forcing=sp.Matrix([F, 0]),
        at={"end": [0, 1]},
    )  # fmt: skip
    end = pair.at["end"]
    on = Phase("on", end.force + stiffer * k * end.x, Event(end.x), {"pressed": end.x})
    off = Phase("off", end.force + k * end.x / 4, Event(end.x), {"off": -end.x})
    own = parameters(
        stiffness=(k, "N/m", 1.0), force=(F, "N", 1.0), frequency=(Omega, "rad/s", 0.6)
    )
    return scene_of("no-gap", own, on, off, body=pair)


@pytest.mark.parametrize("frequency", [0.5, 0.6, 0.65])
def test_from_rest_where_phases_meet_a_body_moves(frequency) -> None:
    """What pulls elsewhere comes later: until then all is rounding.  A scan finds the orbit."""
    own = no_gap()(frequency=frequency)
    motion = ns.simulate(own, cycles=60)
    (orbit,) = (q for q in solutions(own) if q.admissible)
    assert (motion.phases[0].name, motion.ended) == ("on", "")
    last = sorted(q.duration for q in motion.phases[-3:-1])
    assert last == pytest.approx(sorted(orbit.cell_durations * own.units.time), rel=1e-6)


def test_what_pulls_at_the_other_end_of_a_row_is_felt_late() -> None:
    """The fifth mass is pressed from the beginning on: by less than rounding for a while."""
    motion = ns.simulate(ns.scene("chain-impact")(gap=0.0), cycles=2)
    assert motion.ended.startswith("chatter")
    assert sum(q.duration for q in motion.phases) < 0.2
