"""Orders of phases of bodies that their scenes do not declare."""

import math
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from bodies.reference_bodies import case, of, references
from made_scenes import in_a_row, parameters, scene_of

import nonsmooth as ns
from nonsmooth.scene import Body, Event, Phase
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.existence import bodies
from nonsmooth.solver.existence.known import known_orbits
from nonsmooth.solver.in_order import motion_of, settled_cases
from nonsmooth.solver.iteration.many import converged
from nonsmooth.solver.kernels import bodies as kernels
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.kernels.start import RoughTimes, rough_times
from nonsmooth.solver.orbit.exact_orbit import from_times
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.loaded import UnknownScene
from nonsmooth.solver.scenes.mirror import mirror
from nonsmooth.solver.scenes.ordered import MIRRORED, in_order
from nonsmooth.solver.scenes.orders import Order, Step, image

SHIPPED = {q.name: q for q in map(registry.load, registry.names()) if q.has_body}

#: Orbits of the references in an order of the phases of another one's scene.
OF_OTHERS = {
    "absorber-stick-full-period": ("absorber-stick", "slip_0,stick_1,-slip_0,-stick_1"),
    "jenkins-absorber-full-period": ("jenkins-absorber", "-slip_0,-stick_1,slip_0,stick_1"),
    "clearance-2-four-cycles": ("clearance-2", ",".join(["contact_1,open_0"] * 6)),
    "two-stops-four-phases": ("two-stops-six-phases", "both_2,second_3,open_0,second_1"),
}


def declared(scene) -> Order:
    """Return the order of the phases of a scene, as if it were not declared."""
    return Order(tuple(Step(p) for p in range(len(scene.phases))), scene.half_period)


@pytest.mark.parametrize("name", [*SHIPPED, *(r.name for r in references())])
def test_the_declared_order_has_the_declared_equations(name: str) -> None:
    """Its classes follow from numbers here, and from symbols there."""
    own = SHIPPED[name]() if name in SHIPPED else case(name)
    again = Case(in_order(own.scene, declared(own.scene)), own.values, own.cycles)
    assert again.scene.classes == own.scene.classes
    assert again.scene.memory == own.scene.memory
    assert again.cell.phases == own.cell.phases
    assert again.cell.memory == own.cell.memory
    assert (again.cell.body.squares == own.cell.body.squares).all()
    assert (
        again.cell.duration == own.cell.duration if own.cell.forced else not again.cell.forced
    )


@pytest.mark.parametrize("name", OF_OTHERS)
def test_an_orbit_in_an_order_of_another_scene(name: str) -> None:
    r, (base, phases) = of(name), OF_OTHERS[name]
    own = case(base)
    values = dict(own.values) | {"frequency": r.parameters["Omega"]}
    scene = motion_of(own.scene, phases)
    assert scene.motion == phases
    ordered = Case(scene, values, r.cycles)
    durations = np.array(r.durations) / ordered.units.time * (1 + 1e-4)
    found = from_times(ordered, RoughTimes(tuple(durations), r.angle + 1e-4, "near"))
    assert found.outcome.converged
    assert found.admissible
    assert np.abs(np.array(found.durations) - r.durations).max() <= 5e-13 * r.period
    assert abs(math.remainder(found.angle - r.angle, 2 * math.pi)) <= 5e-12
    assert np.abs(found.multipliers).max() == pytest.approx(r.radius, rel=1e-8)


@pytest.mark.parametrize("name", ["absorber-stick-full-period", "jenkins-absorber-full-period"])
def test_starts_nearest_to_their_events_lead_to_a_stable_orbit(name: str, monkeypatch) -> None:
    """Of four phases; then the others, ten times as many, are left out."""
    tried: list = []

    def counted(equations, starts, forced: int):
        tried.extend(starts)
        return converged(equations, starts, forced)

    monkeypatch.setattr(kernels, "converged", counted)
    (solution,) = bodies.solutions(case(name))
    assert solution.admissible
    assert 0 < len(tried) <= 12


def test_many_starts_at_once_lead_where_each_leads_alone() -> None:
    """Also beside one at which the equations are singular or overflow."""
    own = case("two-stops-four-phases")
    starts = [*rough_times(own.cell)]
    starts[1:1] = [RoughTimes((bad,) * 4, 0.0, "") for bad in (1e-300, 1e300)]
    alone = [q.times for q in (from_times(own, each) for each in starts) if q.outcome.converged]
    ends = [*kernels.ends(own.cell, starts)]
    assert len(ends) == len(alone) > 5
    for end, times in zip(ends, alone, strict=True):
        assert [*end.durations, end.angle] == pytest.approx(times, abs=1e-6)


@pytest.mark.parametrize(
    "scene", [q for q in SHIPPED.values() if q.half_period], ids=lambda q: q.name
)
def test_half_a_period_may_begin_with_any_of_its_phases(scene) -> None:
    """The order (second, mirrored first) is that of the declared half period, turned."""
    own = known_orbits(scene())[0]
    first, second = scene.phases
    turned = Case(motion_of(scene, f"{second},-{first},{MIRRORED}"), {})
    s, t = own.cell_durations
    angle = own.angle + own.case.cell.omega * s
    found = from_times(turned, RoughTimes((t, s), angle, "the declared orbit"))
    assert found.admissible
    assert found.cell_durations == pytest.approx([t, s], rel=1e-12)
    assert found.phases[1].velocity == pytest.approx(-own.phases[0].velocity, abs=1e-10)
    both = [own.phases[0].displacement, found.phases[1].displacement]
    assert both[1] == pytest.approx(-both[0], rel=1e-11)


def test_a_mirror_image_turns_all_of_a_form_but_its_constant() -> None:
    """Of every contact: the form of the image at a state is that of the phase at its image."""
    cell = case("two-stops-six-phases").cell
    phase, rng = cell.phases[2], np.random.default_rng(3)
    there = mirror(phase)
    state = rng.standard_normal(phase.width)
    state[3] = 1.0
    turned = np.where(np.arange(len(state)) == 3, state, -state)
    for one, other in zip(phase.laws, there.laws, strict=True):
        assert np.dot(other, state) == pytest.approx(np.dot(one, turned))
    assert mirror(there) == phase
    assert image(cell, Step(2)) is None


def test_an_order_in_which_nothing_changes_is_refused() -> None:
    scene = case("clearance-2").scene
    with pytest.raises(UnknownScene, match="nothing changes where open_0 ends and open_0 begi"):
        Case(motion_of(scene, "contact_1,open_0,open_0"), {}).cell  # noqa: B018


def test_a_slip_below_the_rounding_of_the_modes_is_one() -> None:
    """Where friction nearly holds: the velocity is a difference of those of both masses."""
    case = registry.load("absorber-friction")(
        mass=1.055200042676784, absorber_mass=0.143209, stiffness=0.8635312907465575,
        absorber_stiffness=0.1095921217335512, damping=0.01534874183030745,
        absorber_damping=0.0027056707934270193, friction=0.02887758894906608,
        force=0.137975624814348, frequency=0.6773265747666765,
    )  # fmt: skip
    orbit = exact_orbit(case)
    assert orbit.stable
    assert 0.02 < orbit.phases[0].duration < 0.03


def test_harmonics_that_err_have_the_order_of_the_exact_orbit_beside_them() -> None:
    """Of an order that is asked for; by themselves they slip a little where it sticks."""
    own, phases = registry.load("absorber-friction")(), "slip,stick,-slip,-stick"
    orbit = ns.solve(own, "hb", 10, phases=phases)
    assert 1e-3 < orbit.errors.times < 1e-2


def test_a_slider_that_holds_and_goes_on_as_before() -> None:
    """The second rest begins as a mirror image, and ends as the first does."""
    case = registry.load("jenkins-absorber")(
        frequency=0.27, friction=0.01, tangential_stiffness=1.0, absorber_mass=0.3,
        absorber_stiffness=0.05, force=0.5,
    )  # fmt: skip
    orbit, motion = exact_orbit(case), ns.simulate(case, cycles=100)
    assert orbit.case.scene.motion == "slip,stick,-slip,stick,mirrored"
    found = [q.duration for q in motion.phases[-5:-1]]
    turned = [np.roll(orbit.durations[:4], turn) for turn in range(4)]
    assert min(np.abs(np.subtract(own, found)).max() for own in turned) < 1e-9


def test_where_motions_settle_on_no_stable_orbit_the_others_of_their_orders_are_tried() -> None:
    """A ball between two stops: motions come near to unstable orbits, one of two phases."""
    body = Body(
        M=[[1, 0], [0, 0.5]], C=[[0.1, -0.05], [-0.05, 0.05]], K=[[2, 0], [0, 0]],
        forcing=[1, 0], at={"contact": [-1, 1]},
    )  # fmt: skip
    contact, (g, k, Omega) = body.at["contact"], sp.symbols("g k Omega", positive=True)
    above, below = Event(contact.x - g), Event(contact.x + g)
    away = {"above": contact.x + g, "below": g - contact.x}
    phases = (
        Phase("open", contact.force, above | below, away),
        Phase("up", contact.force + k * (contact.x - g), above, {"on": contact.x - g}),
        Phase("down", contact.force + k * (contact.x + g), below, {"on": -g - contact.x}),
    )
    known = parameters(gap=(g, "m", 0.2), stop=(k, "N/m", 3), frequency=(Omega, "rad/s", 0.9))
    own = scene_of("ball", known, *phases, body=body)()
    reached = (from_times(*settled) for settled in settled_cases(own))
    assert {q.stable for q in reached if q.outcome.converged and q.admissible} == {False}
    orbit = exact_orbit(own)
    assert orbit.stable
    assert orbit.case.scene.motion == "open,up,mirrored"
    assert [phase.name for phase in orbit.phases] == ["open", "up", "open_by_2", "down"]


def test_a_motion_that_stops_switching_may_stay_in_its_phase() -> None:
    """The slider never slips again, and its spring rings on about any length."""
    with pytest.raises(ns.NoOrbit, match=r"in the last \d+, it may stay in stick"):
        exact_orbit(SHIPPED["jenkins-absorber"](friction=50.0))


def on_a_belt(masses, springs, ratio: float, values, first: str = "slip"):
    """Return a row of masses, fixed at its begin, of which the first is on a belt."""
    belt, static, kinetic, weak = sp.symbols("V f_s f_k w", positive=True)
    at = {"tip": np.eye(len(masses))[0]}
    body = Body(M=np.diag(masses), K=in_a_row(springs), ratio=ratio, at=at)
    tip = body.at["tip"]
    holds = {"forwards": static - tip.force, "back": static + tip.force}
    stick = Phase("stick", tip.a, Event(tip.force - static), holds, held=belt)
    law = tip.force - kinetic + weak * (belt - tip.v)
    slip = Phase("slip", law, Event(tip.v - belt), {"slower": belt - tip.v})
    own = parameters(
        belt=(belt, "m/s", values[0]), static=(static, "N", values[1]),
        kinetic=(kinetic, "N", values[2]), weakening=(weak, "N s/m", values[3]),
    )  # fmt: skip
    phases = (slip, stick) if first == "slip" else (stick, slip)
    return scene_of("on-a-belt", own, *phases, body=body)()


#: Two masses that settle, and three that come near to their orbit for too long.
TWO = ([0.2587, 2.9835], [4.15, 0.2279], 0.0503, (0.0356, 1.0, 0.5615, 0.0535))
THREE = ([0.328, 1.818, 1.776], [2.068, 0.917, 0.405], 0.0178, (0.0781, 1.0, 0.555, 0.0843))


@pytest.mark.parametrize(
    ("structure", "first", "durations", "slowest"),
    [
        (TWO, "slip", {"slip": 0.807277913, "stick": 5.379484758}, 0.92),
        (TWO, "stick", {"slip": 0.807277913, "stick": 5.379484758}, 0.92),
        (THREE, "slip", {"slip": 1.115053673, "stick": 3.649926284}, 0.978),
    ],
)
def test_what_winds_about_its_orbit_comes_to_it(structure, first, durations, slowest) -> None:
    """Its multipliers turn it by 95 degrees: after four periods it is back first."""
    orbit = ns.exact(on_a_belt(*structure, first))
    found = {phase.name: phase.duration for phase in orbit.phases}
    assert found == pytest.approx(durations, rel=1e-9)
    assert orbit.phases[0].name == first
    assert len(orbit.phases) == 2
    assert np.abs(orbit.multipliers).max() == pytest.approx(slowest, abs=2e-3)


def test_an_orbit_is_found_where_simulations_settle_on_one_of_twice_its_period() -> None:
    """Both are stable: that of one period has two contacts, one at either stop."""
    frequency, gap, other_gap = sp.symbols("Omega g d", positive=True)
    stiffness, other_stiffness, damper = sp.symbols("k h c", positive=True)
    K = in_a_row([1.506, 0.673, 1.844, 1.787, 0.504])
    masses = np.diag([1.92, 0.784, 0.769, 1.025, 0.846])
    places = {"low": np.eye(5)[1], "high": np.eye(5)[2]}
    body = Body(M=masses, K=K, C=0.0633 * K + 0.02 * masses, forcing=np.eye(5)[3], at=places)
    low, high = body.at["low"], body.at["high"]
    off, others = (low.x + gap, high.x - other_gap)
    ends = Event(off) | Event(others)
    pushed = low.force + stiffness * off + damper * low.v, high.force + other_stiffness * others
    phases = []
    for on_low, on_high in ((0, 0), (1, 0), (1, 1), (0, 1)):
        laws = (pushed[0] if on_low else low.force, pushed[1] if on_high else high.force)
        sides = {"low": -off if on_low else off, "high": others if on_high else -others}
        phases.append(Phase(f"p{on_low}{on_high}", laws, ends, sides))
    own = parameters(
        frequency=(frequency, "rad/s", 1.079), gap=(gap, "m", 0.7493),
        other_gap=(other_gap, "m", 0.145), stiffness=(stiffness, "N/m", 9.895),
        other_stiffness=(other_stiffness, "N/m", 17.725), damper=(damper, "N s/m", 0.0645),
    )  # fmt: skip
    case_of_row = scene_of("row", own, *phases, body=body)()
    settled = next(settled_cases(replace(case_of_row, cycles=2)))
    assert sum(settled[1].durations) == pytest.approx(4 * math.pi)  # over the frequency
    orbit = ns.exact(case_of_row)
    assert orbit.period == pytest.approx(2 * math.pi / 1.079)
    names = [phase.name.partition("_")[0] for phase in orbit.phases]
    assert names == ["p00", "p10", "p00", "p01"]
    assert orbit.stable


def test_an_order_that_is_asked_for_is_found_beside_one_on_which_motions_settle() -> None:
    """Both are stable; the durations are of an event-driven integration of the motion."""
    frequency, g, d, r, k = sp.symbols("Omega g d r k", positive=True)
    K = np.array([[2.0, -1, 0], [-1, 2, -1], [0, -1, 1]])
    C = np.array([[0.18, -0.02, 0], [-0.02, 0.25, -0.02], [0, -0.02, 0.118]])
    at = {"last": [0, 0, 1], "first": [1, 0, 0]}
    body = Body(M=np.diag([1, 1.5, 0.7]), C=C, K=K, forcing=[0.6, 0, 0], at=at)
    last, first = body.at["last"], body.at["first"]
    before, behind = {"before": g - last.x}, first.x + d

    def phase(name: str, law: sp.Expr, other: str, side: dict) -> Phase:
        hit = Event(last.x - g, jump={last.v: -r * last.v}, to=name)
        return Phase(name, (last.force, law), hit | Event(behind, to=other), before | side)

    own = parameters(
        frequency=(frequency, "rad/s", 0.525), gap=(g, "m", 1.1), other_gap=(d, "m", 0.4),
        restitution=(r, "", 0.7), stiffness=(k, "N/m", 3.0),
    )  # fmt: skip
    off = phase("off", first.force, "on", {"off": behind})
    on = phase("on", first.force + k * behind, "off", {"presses": -behind})
    two = scene_of("impact-and-stop", own, off, on, body=body)()
    asked = ns.solve(two, order=16, phases="off,off,off_by_2,on_by_2")
    assert asked.stable
    found = (3.917353370, 2.062697177, 1.795473754, 4.192447713)
    assert asked.durations == pytest.approx(found, abs=2e-9)
