"""Bodies without a forcing, of which a mode is negatively damped, and a stop.

At given durations their periodic motion may be shifted in time: equations that leave this open
are singular on the orbit.  Against matrix exponentials.
"""

from functools import cache

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import expm
from scipy.optimize import brentq, fsolve

import nonsmooth as ns
from nonsmooth.codegen.scene import SceneError
from nonsmooth.scene import Body, Event, Parameter, Phase, Scene, a, v, x
from nonsmooth.solver.existence.known import known_orbits
from nonsmooth.solver.precision import digits
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.solve import orbits_of

g, r, k, d, V, P, static, kinetic, w = sp.symbols("g r k1 d V P f_s f_k w_f", positive=True)
K = np.array([[3.0, -2.0], [-2.0, 2.0]])
C = np.array([[0.12, -0.1], [-0.1, 0.06]])
REBOUND, STOP = 0.7, 5.0
GAP = Parameter("gap", g, "m", 1.0, "way to the stop")

#: Of ``X' = A X`` for q, q', 1: free, and at the stop.
FREE = np.block([[np.zeros((2, 2)), np.eye(2)], [-K, -C]])
TURN = np.diag([1.0, 1.0, 1.0, -REBOUND])


@cache
def impact() -> Case:
    """Return two masses before a rigid stop."""
    body = Body(M=np.eye(2), K=K, C=C, at={"end": [0, 1]})
    end = body.at["end"]
    flight = Phase(
        "flight", end.force, Event(end.x - g, jump={end.v: -r * end.v}), {"before": g - end.x}
    )
    restitution = Parameter("restitution", r, "", REBOUND, "restitution", most=1)
    return ns.scene(
        Scene("loud-stop", "", (GAP, restitution), (flight,), body=body, scales={"length": g})
    )()


@cache
def elastic() -> Case:
    """Return two masses before an elastic stop."""
    body = Body(M=np.eye(2), K=K, C=C, at={"end": [0, 1]})
    end = body.at["end"]
    meets = Event(end.x - g)
    phases = (
        Phase("touch", end.force + k * (end.x - g), meets, {"presses": end.x - g}),
        Phase("free", end.force, meets, {"before": g - end.x}),
    )
    stop = Parameter("stop", k, "N/m", STOP, "stiffness of the stop")
    return ns.scene(
        Scene("loud-spring", "", (GAP, stop), phases, body=body, scales={"length": g})
    )()


def by_saltation(period: np.ndarray) -> np.ndarray:
    """Return the moduli of the multipliers by a map, the trivial one first."""
    moduli = np.sort(np.abs(np.linalg.eigvals(period)))[::-1]
    return moduli[np.argsort(np.abs(moduli - 1), kind="stable")]


@pytest.mark.parametrize("method", ["exact", "ck-tau", "hb", "hb-ck"])
def test_a_rigid_stop(method: str) -> None:
    """The period is a root of ``det(1 - J e^(A T))``: all else scales with the gap."""
    off = lambda T: np.linalg.det(np.eye(4) - TURN @ expm(FREE * T))  # noqa: E731
    T = brentq(off, 8.9, 9.4, xtol=1e-14)
    found = ns.exact(impact()) if method == "exact" else ns.solve(impact(), method, 6)
    assert found.period == pytest.approx(T, rel=1e-13)
    start = np.linalg.svd(TURN @ expm(FREE * T) - np.eye(4))[2][-1]
    before = expm(FREE * T) @ start
    jump = FREE @ start - TURN @ FREE @ before
    switch = TURN + np.outer(jump, [0, 1, 0, 0]) / before[3]
    trivial, *others = by_saltation(switch @ expm(FREE * T))
    assert trivial == pytest.approx(1.0, abs=1e-11)
    if method == "exact":
        assert np.abs(found.multipliers)[:1] == pytest.approx(others[:1], rel=1e-9)
        assert found.stable


@pytest.mark.parametrize("method", ["exact", "ck-tau", "hb", "hb-ck"])
def test_an_elastic_stop(method: str) -> None:
    """Its events and its period close by matrix exponentials."""
    order = {"ck-tau": 16, "hb": 40, "hb-ck": 40}.get(method, 0)
    found = ns.solve(elastic(), method, order) if order else ns.exact(elastic())
    touch, free = (phase.duration for phase in ns.exact(elastic()).phases)
    error = {"hb": 1e-4, "hb-ck": 1e-7}.get(method, 1e-12)
    assert found.durations == pytest.approx((touch, free), rel=error)
    pressed = np.zeros((5, 5))
    pressed[:4, :4] = FREE
    pressed[3, 1] -= STOP
    pressed[3, 4] = STOP
    before = np.zeros((5, 5))
    before[:4, :4] = FREE
    period = expm(before * free) @ expm(pressed * touch)
    start = np.linalg.svd(np.vstack([period - np.eye(5), [0, 1, 0, 0, -1]]))[2][-1]
    start /= start[4]
    assert np.abs(period @ start - start).max() < 1e-12
    assert [start[1], (expm(pressed * touch) @ start)[1]] == pytest.approx([1, 1], abs=1e-12)
    assert found.stable


def test_its_times_may_be_given() -> None:
    orbit = ns.exact(elastic())
    given = ns.exact(elastic(), durations=[q.duration for q in orbit.phases])
    assert given.durations == pytest.approx(orbit.durations, rel=1e-13)


def test_a_phase_that_hardly_lasts_is_no_orbit() -> None:
    """At rest at the stop all equations hold to rounding."""
    with pytest.raises(ns.NoOrbit, match="and rounding may be as much"):
        ns.exact(impact(), durations=[4.4e-8])


RESTITUTION = Parameter("restitution", r, "", REBOUND, "restitution")


@pytest.mark.parametrize("gap", [0.9999, 0.9995, 0.999, 0.998])
def test_a_mass_that_is_pressed_on_a_stop_rests(gap: float) -> None:
    """Bounces of ever less duration fulfil all equations to rounding."""
    body = Body(M=[[1.0]], K=[[1.0]], C=[[-0.02]], at={"end": [1]})
    end = body.at["end"]
    meets = Event(end.x - g, jump={end.v: -r * end.v})
    flight = Phase("flight", end.force - P, meets, {"before": g - end.x})
    numbers = (GAP, RESTITUTION, Parameter("load", P, "N", 1.0, "load"))
    made = Scene("pressed", "", numbers, (flight,), body=body, scales={"length": g})
    with pytest.raises(ns.NoOrbit, match=r"a rest|rounding may be as much"):
        ns.exact(ns.scene(made)(gap=gap, restitution=0.6))


@pytest.mark.parametrize("first", ["still", "moves"])
def test_a_body_moves_if_any_of_its_contacts_does(first: str) -> None:
    """Two masses that nothing joins: one is at rest, the other drives itself against a stop."""
    at = {"still": [1, 0], "moves": [0, 1]}
    at = {first: at[first], **at}
    body = Body(M=np.eye(2), C=np.diag([0.1, -0.1]), K=np.eye(2), at=at)
    end, dashpot = body.at["moves"], sp.Symbol("c1", positive=True)
    meets = Event(end.x - g)

    def laws(force: sp.Expr) -> tuple[sp.Expr, ...]:
        forces = {"still": 0, "moves": force}
        return tuple(body.at[q].force + forces[q] for q in body.at)

    pushes = k * (end.x - g) + dashpot * end.v
    phases = (
        Phase("touch", laws(pushes), meets, {"behind": end.x - g}),
        Phase("free", laws(sp.Integer(0)), meets, {"before": g - end.x}),
    )
    own = (
        GAP,
        Parameter("stop", k, "N/m", STOP, "stiffness of the stop"),
        Parameter("dashpot", dashpot, "N s/m", 0.5, "damping of the stop"),
    )
    scene = Scene(f"one-{first}", "", own, phases, body=body, scales={"length": g})
    orbit = ns.solve(ns.scene(scene)(), order=14)
    assert orbit.stable

    def misses(state: np.ndarray) -> np.ndarray:
        """Return how far a mass is from its start, after one phase in contact and one free."""
        speed, touch, free = state
        touches = np.array([[0, 1, 0], [-1 - STOP, -0.4, STOP], [0, 0, 0]])
        moves = np.array([[0, 1, 0], [-1, 0.1, 0], [0, 0, 0]])
        middle = expm(touch * touches) @ [1.0, speed, 1.0]
        last = expm(free * moves) @ middle
        return np.array([middle[0] - 1.0, last[0] - 1.0, last[1] - speed])

    found = fsolve(misses, [1.0, *orbit.durations], xtol=1e-13)
    assert orbit.durations == pytest.approx(found[1:], abs=1e-9)


def test_a_stop_that_gives_energy() -> None:
    """By the flight of a damped mass: its root in closed form."""
    body = Body(M=[[1.0]], K=[[6.423153]], C=[[0.647723]], at={"end": [1]})
    end = body.at["end"]
    meets = Event(end.x + g, jump={end.v: -r * end.v})
    flight = Phase("flight", end.force, meets, {"behind the stop": -g - end.x})
    numbers = (GAP, RESTITUTION)
    gain = ns.scene(Scene("gain", "", numbers, (flight,), body=body, scales={"length": g}))
    found = ns.exact(gain(gap=0.2, restitution=1.404748))
    assert found.stable
    A = np.array([[0.0, 1.0], [-6.423153, -0.647723]])
    turn = np.diag([1.0, -1.404748])
    off = lambda T: np.linalg.det(np.eye(2) - turn @ expm(A * T))  # noqa: E731
    assert found.period == pytest.approx(brentq(off, 1.1, 1.2, xtol=1e-14), rel=1e-12)


def test_friction_that_balances_a_negative_damper() -> None:
    """Half a period is one slide: amplitude and multiplier are in closed form."""
    body = Body(M=[[1.0]], K=[[1.0]], C=[[-0.1]], at={"c": [1]})
    c = body.at["c"]
    slide = Phase("slide", c.force + w * g, Event(c.v), {"forward": c.v})
    numbers = (GAP, Parameter("friction", w, "N/m", 1.0, "friction over the length"))
    made = Scene(
        "balanced", "", numbers, (slide,), body=body, half_period=True, scales={"length": g}
    )
    found = ns.exact(ns.scene(made)())
    rate = np.sqrt(1 - 0.05**2)
    growth = np.exp(0.05 * np.pi / rate)
    assert found.period == pytest.approx(2 * np.pi / rate, rel=1e-12)
    amplitude = (growth + 1) / (growth - 1)
    assert found.extremes["displacement"] == pytest.approx((-amplitude, amplitude), rel=1e-10)
    assert [abs(q) for q in found.multipliers] == pytest.approx([growth**2], rel=1e-9)


def test_orbits_of_a_clock_that_coexist() -> None:
    """All durations of its one phase are found by a scan."""
    body = Body(M=np.eye(2), K=K, C=0.1 * np.eye(2), at={"end": [0, 1]})
    end = body.at["end"]
    kicked = Event(end.x, jump={end.v: end.v + g / d}, demands={"forward": end.v})
    swing = Phase("swing", end.force, kicked)
    numbers = (GAP, Parameter("unit", d, "s", 1.0, "unit of time"))
    made = Scene("clock", "", numbers, (swing,), body=body, scales={"length": g})
    clock = ns.scene(made)(gap=0.3)
    periods = sorted(orbit.period for orbit in known_orbits(clock) if orbit.stable)
    A = np.block([[np.zeros((2, 2)), np.eye(2)], [-K, -0.1 * np.eye(2)]])
    for T, about in zip(periods, (2.92288, 9.48188), strict=True):
        assert about - 1e-5 < T < about + 1e-5
        start = np.linalg.solve(np.eye(4) - expm(A * T), [0, 0, 0, 0.3])
        assert abs((expm(A * T) @ start)[1]) < 1e-12


def test_a_body_of_one_mass_is_the_mass() -> None:
    """A negatively damped one, with a damper behind an elastic stop."""
    m, K1 = sp.symbols("m K", positive=True)
    stop = Parameter("stop", k, "N/m", STOP, "stiffness of the stop")
    damper = Parameter("damper", d, "N s/m", 0.1, "damper")
    more = (
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("stiffness", K1, "N/m", 1.0, "stiffness"),
    )
    own = m * a - d * v + K1 * x
    alone = (
        Phase("touch", own + k * (x - g) + 8 * d * v, Event(x - g), {"presses": x - g}),
        Phase("free", own, Event(x - g), {"before": g - x}),
    )
    body = Body(M=[[1.0]], K=[[1.0]], C=[[-0.1]], at={"end": [1]})
    end = body.at["end"]
    law = end.force + k * (end.x - g) + 8 * d * end.v
    phases = (
        Phase("touch", law, Event(end.x - g), {"presses": end.x - g}),
        Phase("free", end.force, Event(end.x - g), {"before": g - end.x}),
    )
    numbers = (GAP, stop, damper)
    mass = Scene("mass-alone", "", (*numbers, *more), alone, scales={"length": g})
    as_body = Scene("mass-as-body", "", numbers, phases, body=body, scales={"length": g})
    one, other = (ns.exact(ns.scene(q)()) for q in (mass, as_body))
    assert other.durations == pytest.approx(one.durations, rel=1e-11)
    assert other.multipliers[:1] == pytest.approx(one.multipliers[:1], rel=1e-8)


def test_branches_along_a_stop() -> None:
    """All lengths are proportional to the gap: the period is the same along it."""
    found = ns.branch(impact(), "gap", 0.5, 2.0)
    assert found.why_it_ended == ("the end of the range",) * 2
    assert np.ptp([row.period for row in found.rows]) < 1e-11


def test_where_the_stop_does_not_limit_it_an_orbit_grows_without_bound() -> None:
    """There it does not know the gap: with none all its multiples are orbits."""
    found = ns.branch(elastic(), "stop", 0.5, 6.0)
    assert "the orbit grows beyond all bounds" in found.why_it_ended
    end = min(found.rows, key=lambda row: row.extremes["displacement"][0])

    def off(unknown: np.ndarray) -> np.ndarray:
        (touch, free, stiffness), y = unknown[:3], unknown[3:]
        pressed = FREE.copy()
        pressed[3, 1] -= stiffness
        met = expm(pressed * touch) @ y
        return np.array([*(expm(FREE * free) @ met - y), y[1], met[1], y @ y - 1])

    pressed = FREE.copy()
    pressed[3, 1] -= end.value
    period = expm(FREE * end.durations[1]) @ expm(pressed * end.durations[0])
    start = np.linalg.svd(period - np.eye(4))[2][-1]
    unknown, _, status, _ = fsolve(
        off, [*end.durations, end.value, *start], xtol=1e-13, full_output=True
    )
    assert status == 1
    assert np.abs(off(unknown)).max() < 1e-12
    assert end.value == pytest.approx(unknown[2], rel=1e-4)
    assert end.value != pytest.approx(unknown[2], rel=1e-12)


#: A mass on a belt, with another one behind it, at which a steady slip is stable too.
BELT_K = np.array([[4.7, -2.83], [-2.83, 2.83]])
BELT_C = np.array([[0.09, -0.046], [-0.046, 0.062]])


@pytest.mark.parametrize(("belt", "asked"), [(0.6, None), (0.79, None), (0.79, "stick,slip")])
def test_stick_and_slip_beside_a_steady_slip(belt: float, asked: str | None) -> None:
    """In an order that the scene does not declare: it lists a phase that does not occur."""
    body = Body(M=np.diag([0.448, 0.5075]), K=BELT_K, C=BELT_C, at={"c": [1, 0]})
    c = body.at["c"]
    phases = (
        Phase(
            "stick",
            c.a,
            Event(static - c.force, to="slip") | Event(c.force + static, to="over"),
            {"holds": static - sp.Abs(c.force)},
            held=V,
        ),
        Phase("slip", c.force - (kinetic - w * (V - c.v)), Event(c.v - V), {"slower": V - c.v}),
        Phase("over", c.force + (kinetic - w * (c.v - V)), Event(c.v - V), {"faster": c.v - V}),
    )
    parameters = (
        Parameter("belt", V, "m/s", 0.79, "speed of the belt"),
        Parameter("static", static, "N", 1.0, "static friction"),
        Parameter("kinetic", kinetic, "N", 0.301, "kinetic friction"),
        Parameter("weakening", w, "N s/m", 0.043, "how it falls with the speed"),
    )
    case = ns.scene(Scene("two-on-a-belt", "", parameters, phases, body=body))(belt=belt)
    found = ns.solve(case, order=16, phases=asked) if asked else ns.solve(case, order=16)
    assert [phase.name for phase in found.phases] == ["stick", "slip"]
    assert found.stable


def between_walls(K: list, C: list) -> Case:
    """Return free masses, of which the first bounces to and fro between two walls."""
    body = Body(M=np.eye(len(K)), K=K, C=C, at={"first": np.eye(len(K))[0]})
    first = body.at["first"]
    hit = {first.v: -r * first.v}
    flight = Phase(
        "flight",
        first.force,
        Event(first.x - g, jump=hit) | Event(first.x + g, jump=hit),
        {"between the walls": g - sp.Abs(first.x)},
    )
    scales = {"length": g, "time": 1.0}
    walls = Scene("walls", "", (GAP, RESTITUTION), (flight,), body=body, scales=scales)
    return ns.scene(walls)()


@pytest.mark.parametrize("method", ["exact", "ck-tau"])
def test_a_free_mass_that_drives_itself_between_walls(method: str) -> None:
    """It is its own speed that periodicity leaves open: r times its growth is 1."""
    case = between_walls([[0.0]], [[-0.2]])
    found = ns.exact(case) if method == "exact" else ns.solve(case, method, 10)
    assert found.period == pytest.approx(2 * np.log(1 / REBOUND) / 0.2, rel=1e-13)
    fastest = 2 * 0.2 / (1 - REBOUND)
    assert found.extremes["velocity"] == pytest.approx((-fastest, fastest), rel=1e-11)
    assert [abs(q) for q in found.multipliers] == pytest.approx([REBOUND**2], rel=1e-9)


@pytest.mark.parametrize("method", ["exact", "ck-tau", "hb-ck"])
def test_free_masses_that_drive_themselves_between_walls(method: str) -> None:
    """Their place and their speed are left open; both walls are hit twice in a row."""
    C = [[0.1, -0.3], [-0.3, 0.3]]
    case = between_walls([[5.0, -5.0], [-5.0, 5.0]], C)
    orbit = ns.exact(case)
    found = orbit if method == "exact" else ns.solve(case, method, 40)
    error = 2e-3 if method == "hb-ck" else 1e-12
    assert found.durations == pytest.approx(orbit.durations, rel=error)
    A = np.zeros((5, 5))
    A[:2, 2:4], A[2:4, :2], A[2:4, 2:4] = np.eye(2), [[-5, 5], [5, -5]], -np.array(C)
    turn, place, rows = np.diag([1.0, 1.0, -REBOUND, 1.0, 1.0]), np.eye(5), []
    for phase in orbit.phases:
        place = expm(A * phase.duration) @ place
        rows.append(place[0] + [0, 0, 0, 0, 1 if phase.name == "flight_by_2" else -1])
        place = turn @ place
    *_, sizes, directions = np.linalg.svd(np.vstack([place - np.eye(5), *rows]))
    assert sizes[-1] < 1e-12
    assert sizes[-2] > 1e-3
    assert abs(directions[-1][4]) > 1e-3
    assert [q.name for q in orbit.phases] == [*["flight"] * 2, *["flight_by_2"] * 2]
    assert found.stable


def test_their_times_in_balls() -> None:
    case = between_walls([[0.0]], [[-0.2]])
    for kept in digits.at("", case, (10,), ("hb-ck", "ck-tau")):
        assert kept.status == "ok", kept
        assert kept.error < 1e-14, kept


def test_a_free_mass_has_no_time_of_its_own() -> None:
    body = Body(M=[[1.0]], K=[[0.0]], C=[[-0.2]], at={"end": [1]})
    end = body.at["end"]
    flight = Phase("flight", end.force, Event(end.x - g, jump={end.v: -r * end.v}))
    numbers = (GAP, RESTITUTION)
    with pytest.raises(SceneError, match="scales: no time can be worked out"):
        Scene("walls", "", numbers, (flight,), body=body, scales={"length": g})


def test_all_orbits_have_the_one_on_which_motions_settle_from_rest() -> None:
    """A drill string: two more orbits, stable as well, are found by starts on a grid."""
    string = Body(
        M=np.diag([1.0, 0.5]), K=[[2.5, -1.5], [-1.5, 1.5]], C=np.diag([0.1, 0.0]),
        at={"bit": [0, 1]},
    )  # fmt: skip
    bit = string.at["bit"]
    phases = (
        Phase("stick", bit.a, Event(bit.force + static), {"h": static + bit.force}, held=-V),
        Phase("slip", bit.force + kinetic, Event(bit.v + V), {"turns on": bit.v + V}),
    )
    parameters = (
        Parameter("speed", V, "m/s", 0.3, "speed of the drive"),
        Parameter("static", static, "N", 1.0, "static torque"),
        Parameter("kinetic", kinetic, "N", 0.5, "kinetic torque"),
    )
    case = ns.scene(Scene("drill-string", "", parameters, phases, body=string))()
    at_rest = ns.simulate(case, cycles=120).phases[-3:-1]
    orbits = orbits_of(case, order=12)
    durations = [sorted(phase.duration for phase in orbit.phases) for orbit in orbits]
    assert sorted(phase.duration for phase in at_rest) == pytest.approx(durations[-1], rel=1e-6)
    assert durations[-1] == pytest.approx([4.418128, 4.781155], abs=1e-6)
    assert [orbit.stable for orbit in orbits] == [True] * 3
