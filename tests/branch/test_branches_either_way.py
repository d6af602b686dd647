"""A branch is the same from any of its orbits, and nothing is missed in a step of it."""

import numpy as np
import pytest
import sympy as sp
from made_scenes import parameters, scene_of

import nonsmooth as ns
from nonsmooth.scene import Body, Event, Memory, Phase, a, forcing, v, x
from nonsmooth.solver import branches
from nonsmooth.solver.branch import course
from nonsmooth.solver.branch.walk import OUTSIDE, OWN, dips
from nonsmooth.solver.branch.watch import rises
from nonsmooth.solver.exact import exact_orbit

F, Omega, m, k = sp.symbols("F Omega m k", positive=True)
c, V = sp.symbols("c V", nonnegative=True)
f_k, f_s = sp.symbols("f_k f_s", positive=True)


def oscillator(mass: float, damping: float, stiffness: float, frequency: float):
    """Return the parameters of a mass, and a force of 1 N."""
    return parameters(
        mass=(m, "kg", mass), damping=(c, "N s/m", damping), stiffness=(k, "N/m", stiffness),
        force=(F, "N", 1.0), frequency=(Omega, "rad/s", frequency),
    )  # fmt: skip


def on_a_belt(name: str, mass, damping, stiffness, frequency, kinetic, static, belt):
    """Return a mass on a belt, in an order of phases that is not half of one."""
    load, moved = c * V + k * x - F * forcing, m * a + c * v + k * x - F * forcing
    holds = {"up": f_s - load, "down": f_s + load}
    phases = (
        Phase("ahead", moved + f_k, Event(v - V), {"ahead": v - V}),
        Phase("stick_b", a, Event(load - f_s), holds, held=V),
        Phase("back", moved - f_k, Event(v - V), {"back": V - v}),
        Phase("stick_f", a, Event(load + f_s), holds, held=V),
    )
    own = parameters(
        kinetic=(f_k, "N", kinetic), static=(f_s, "N", static), belt=(V, "m/s", belt)
    )
    known = oscillator(mass, damping, stiffness, frequency)
    return scene_of(name, known + own, *phases)()


def both_ways(case, name: str, ends, starts):
    """Return what happens on the branch from each of two orbits: the same, and no end."""
    orbits = [exact_orbit(case.with_value(name, at)) for at in starts]
    found = [ns.branch(case, name, *ends, start=orbit) for orbit in orbits]
    for branch in found:
        assert branch.why_it_ended == ("the end of the range",) * 2
    events = [sorted(branch.events, key=lambda event: event.parameter) for branch in found]
    for one, other in zip(*events, strict=True):
        assert one.parameter == pytest.approx(other.parameter, rel=1e-11)
    return events


def test_no_orbit_is_beyond_the_range_that_begins_at_a_flip() -> None:
    values = {"damping": 0.0, "restitution": 0.8, "gap": 0.5, "frequency": 1.01445763678408881}
    found = ns.branch(ns.scene("impact")(**values), "frequency", 0.9, values["frequency"])
    assert found["value"].max() == values["frequency"]


def test_a_flight_that_leaves_a_stop_softly_touches_it_where_it_does() -> None:
    """Its distance falls again in one step of a grid, in which its rate falls first."""
    case = ns.scene("impact-inelastic")(frequency=0.9, mass=1, stiffness=1, damping=0.1)
    events = both_ways(case, "gap", (0.985, 1.12), (0.987, 1.1006))
    assert [event.kind for event in events[1]] == ["sticking", "grazing", "fold"]


def test_a_flight_from_a_rest_may_last_a_quarter_of_a_cycle() -> None:
    """There the force that it begins with would move the rest by as much as holds it."""
    case = ns.scene("impact-inelastic")(
        mass=1.2743, damping=0.05, stiffness=1.6528, gap=-0.26, frequency=1.505
    )
    assert both_ways(case, "force", (0.45, 0.6), (0.47, 0.55)) == [[], []]


def test_a_rate_rises_through_zero_where_it_falls_at_first() -> None:
    """Of the polynomial t^3/3 - t^2/2 - t/5, whose rate is t^2 - t - 1/5."""
    terms = np.array([0.0, -0.2, -0.5, 1 / 3])
    assert rises(terms, 0.0, 1.5) == pytest.approx((1 + np.sqrt(1.8)) / 2, rel=1e-14)


def on_a_spring(cycles: int, **values: float):
    """Return a body of one mass with a spring behind a gap."""
    c, k, g = sp.symbols("c k_c g", positive=True)
    body = Body(M=[[1]], K=[[1]], C=[[c]], forcing=[F], at={"end": [1]})
    end = body.at["end"]
    pressed, touched = end.force + k * (end.x - g), Event(end.x - g)
    contact = Phase("contact", pressed, touched, {"it presses": end.x - g})
    separated = Phase("separated", end.force, touched, {"before the spring": g - end.x})
    own = parameters(
        damping=(c, "N s/m", 0.1), contact_stiffness=(k, "N/m", 4.0), gap=(g, "m", 0.1),
        force=(F, "N", 1.0), frequency=(Omega, "rad/s", 2.5),
    )  # fmt: skip
    scene = scene_of("on-a-spring", own, contact, separated, body=body)
    return scene(cycles=cycles, **values)


@pytest.mark.parametrize("on_it", [ns.scene("clearance"), on_a_spring])
def test_a_surface_may_be_touched_just_before_a_phase_ends_on_it(on_it) -> None:
    """The way there is 3e-8 of the gap at most: it falls, rises and falls in a step."""
    values = {"gap": 0.0079, "contact_stiffness": 35.6016, "damping": 0.1044, "force": 0.3328}
    found = ns.branch(on_it(**values, frequency=2.5, cycles=3), "frequency", 2.49, 2.51)
    assert found.why_it_ended == ("the end of the range", "the end of the range")
    one, flip, other = sorted(found.events, key=lambda event: event.parameter)
    assert [one.kind, flip.kind, other.kind] == ["grazing", "flip", "grazing"]
    assert one.parameter == pytest.approx(2.49463702084478, rel=1e-12)
    assert flip.parameter == pytest.approx(2.49463921818483, rel=1e-12)
    assert other.parameter == pytest.approx(2.49464575147096, rel=1e-12)


def on_a_stop(**values: float):
    """Return a body of one mass that comes to rest on a stop."""
    g = sp.Symbol("g", real=True)
    body = Body(M=[[1.0]], K=[[1.0]], C=[[0.1]], forcing=[F], at={"end": [1]})
    end = body.at["end"]
    stop = Event(end.x - g, jump={end.v: 0})
    flight = Phase("flight", end.force, stop, {"before the stop": g - end.x})
    rest = Phase("rest", end.a, Event(end.force), {"it presses": -end.force}, held=0)
    own = parameters(gap=(g, "m", 0.9913), force=(F, "N", 1.0), frequency=(Omega, "rad/s", 0.9))
    return scene_of("on-a-stop", own, flight, rest, body=body)(**values)


def test_a_body_comes_to_rest_where_the_same_mass_does() -> None:
    events = both_ways(on_a_stop(), "gap", (0.9905, 0.9915), (0.9908, 0.9913))
    assert [event.kind for (event,) in events] == ["sticking", "sticking"]
    assert events[0][0].parameter == pytest.approx(0.99102243197694, rel=1e-12)


def test_the_flight_of_a_body_vanishes_where_its_stop_holds_it_for_ever() -> None:
    found = ns.branch(on_a_stop(gap=-0.5, force=0.6), "force", 0.4, 0.61)
    (event,) = found.events
    assert (event.kind, event.phase) == ("sticking", "flight")
    beyond = "sticking, beyond which the motion stays in rest"
    assert found.why_it_ended == (beyond, "the end of the range")
    assert event.parameter == pytest.approx(0.5, rel=1e-13)


@pytest.mark.parametrize("belt", [0.5, 0.0])
def test_rests_on_a_belt_vanish_from_either_side(belt: float) -> None:
    """One of an orbit, or both together of one that is symmetric, by one word."""
    case = on_a_belt("on-a-belt", 1.0, 0.1, 1.0, 0.7, 0.3, 0.36, belt)
    events = both_ways(case, "force", (0.5, 2.0), (0.515, 1.5))
    assert [event.kind for (event,) in events] == ["sticking", "sticking"]


def test_a_further_slip_of_a_slider_comes_and_goes() -> None:
    """The rest behind it ends where it begins, by the memory that it sets itself."""
    f, t, w = *sp.symbols("f k_t", positive=True), sp.Symbol("w", real=True)
    moved, held = m * a + c * v + k * x - F * forcing, t * (x - w)
    phases = (
        Phase("slip", moved + f, Event(v), {"forward": v}),
        Phase("stick", moved + held, Event(held + f), {"up": f - held, "down": f + held}),
    )
    own = parameters(limit=(f, "N", 0.189), joint=(t, "N/m", 15.4))
    own += oscillator(0.746, 0.4562, 1.0985, 0.5949)
    memory = (Memory(w, "stick", x - f / t, "slider"),)
    scene = scene_of("slider", own, *phases, half_period=True, memory=memory)
    events = both_ways(scene(), "force", (0.235, 0.25), (0.2367, 0.2475))
    assert len(events[0]) == 2


@pytest.mark.parametrize(
    ("values", "looked_at"),
    [([0.4, 0.1, 0.4], False), ([0.4, 0.05, 0.1], True), ([0.5, 0.25, 0.1], False)],
)
def test_what_may_happen_twice_in_a_step_is_looked_at(values, looked_at: bool) -> None:
    """By the parabola through what is watched, where it leaves its sign."""
    rows = [np.ones(OWN + 1) for _ in values]
    for row, value in zip(rows, values, strict=True):
        row[0], row[1 + OUTSIDE] = value, 0.0
    assert (dips(*rows, 1.0, 1.0) != 0) == looked_at


def test_two_flips_in_a_step_are_found() -> None:
    """Between them the orbit is unstable, and it is stable again where the step would end."""
    case = ns.scene("impact")(damping=0.0, restitution=0.7216, gap=0.5)
    found = ns.branch(case, "frequency", 0.9, 1.3)
    flips = [event.parameter for event in found.events if event.kind == "flip"]
    assert flips == pytest.approx([1.052845, 1.055465], abs=1e-6)


def on_a_vibrating_wall():
    """Return a mass that comes to rest on a wall; the forcing changes its sign at 1 rad/s."""
    A, W = sp.symbols("A W", positive=True)
    presses = W - A * (m * Omega**2 - k) * forcing
    flight = Phase("flight", m * a + c * v + k * x + presses, Event(x, jump={v: 0}), {"off": x})
    rest = Phase("rest", a, Event(presses), {"it presses": presses}, held=0)
    own = parameters(
        mass=(m, "kg", 1.0), damping=(c, "N s/m", 0.1), stiffness=(k, "N/m", 1.0),
        pull=(W, "N", 0.5), amplitude=(A, "m", 0.5), frequency=(Omega, "rad/s", 2.0),
    )  # fmt: skip
    return scene_of("wall", own, flight, rest)()


def test_an_end_of_the_range_may_be_special() -> None:
    """Half of 2 rad/s: there the wall does not move the mass, which vanishes as it leaves."""
    found = ns.branch(on_a_vibrating_wall(), "frequency", 0.8, 2.5)
    assert [event.kind for event in found.events] == ["sticking"]
    assert found.events[0].parameter == pytest.approx(np.sqrt(2), rel=1e-12)
    for row in found.rows[10::20]:
        exact = exact_orbit(on_a_vibrating_wall().with_value("frequency", row.value))
        assert row.durations == pytest.approx(exact.durations, rel=1e-9)


def test_rows_are_those_of_orbits(monkeypatch) -> None:
    """Where the equations of a branch have other solutions too, it does not follow them."""
    wrong = np.array([1, 0])  # that the flight gains nothing: it may begin anywhere
    monkeypatch.setattr(course, "divided_phases", lambda *_: wrong)
    found = ns.branch(on_a_vibrating_wall(), "frequency", 1.9, 2.1)
    for row in found.rows:
        exact = exact_orbit(on_a_vibrating_wall().with_value("frequency", row.value))
        assert row.durations == pytest.approx(exact.durations, rel=1e-5)
    assert "its durations are not those of an orbit" in " ".join(found.why_it_ended)


@pytest.mark.parametrize("start", [-0.4, -0.2, -0.1])
def test_where_a_surface_lies_does_not_matter(start: float) -> None:
    """At 0, all displacements at switches vanish, and at a touch all velocities as well."""
    Q, h, k_1 = sp.symbols("Q h k_1", real=True)
    own = {
        **{"mass": (m, "kg", 1.0), "damping": (c, "N s/m", 0.1), "stiffness": (k, "N/m", 1.0)},
        **{"contact": (k_1, "N/m", 5.0), "load": (Q, "N", start), "force": (F, "N", 0.05)},
        **{"frequency": (Omega, "rad/s", 1.1)},
    }
    found = []
    for at, place in ((0, {}), (h, {"place": (h, "m", 1.0)})):
        moved = m * a + c * v + k * (x - at) + Q - F * forcing
        free = Phase("free", moved, Event(x - at), {"above": x - at})
        pressed = Phase("pressed", moved + k_1 * (x - at), Event(x - at), {"below": at - x})
        scene = scene_of("shifted", parameters(**own, **place), free, pressed)
        found.append(ns.branch(scene(), "load", -0.4, -0.1))
    assert [len(branch) for branch in found] == [len(found[0])] * 2
    for branch in found:
        assert [event.kind for event in branch.events] == ["grazing", "fold", "fold"]
        assert branch.why_it_ended == ("the end of the range",) * 2
    values = ([event.parameter for event in branch.events] for branch in found)
    np.testing.assert_allclose(*values, rtol=1e-12)


def between_stops(
    damping: float,
    y: sp.Expr,
    low: sp.Symbol,
    high: sp.Symbol,
    /,
    **own: tuple[sp.Symbol, str, float],
):
    """Return a mass, displaced by y from its middle, between two elastic stops."""
    moved = m * a + c * v + k * y - F * forcing
    below, above = Event(y + low), Event(y - high)
    phases = (
        Phase("free", moved, above | below, {"above": y + low, "below": high - y}),
        Phase("up", moved + 3 * k * (y - high), above, {"on": y - high}),
        Phase("down", moved + 3 * k * (y + low), below, {"on": -low - y}),
    )
    known = oscillator(1.0, damping, 1.0, 1.1) + parameters(**own)
    return scene_of("between", known, *phases)


def test_a_branch_begins_at_a_symmetric_orbit_where_the_parameter_breaks_the_symmetry() -> None:
    """There half a period is an order of its own, which is none beside it.

    The forces of the two stops differ by rounding: 1.5 and 1.5000000000000002.
    """
    low, high = sp.symbols("low high", positive=True)
    gaps = {"low": (low, "m", 0.5), "high": (high, "m", 0.5)}
    case = between_stops(0.1, x, low, high, **gaps)()
    assert exact_orbit(case).case.scene.half_period
    assert both_ways(case, "high", (0.3, 0.8), (0.5, 0.55)) == [[], []]


def test_where_the_middle_lies_does_not_matter() -> None:
    """An orbit symmetric about another place touches both stops at once, and loses symmetry."""
    s, g = sp.Symbol("s", real=True), sp.Symbol("g", positive=True)
    stops = between_stops(0.02, x - s, g, g, middle=(s, "m", 0.0), gap=(g, "m", 0.7))
    found = []
    for middle in (0.0, 0.3):
        branch = ns.branch(stops(middle=middle), "frequency", 0.2, 1.2)
        assert branch.why_it_ended == ("the end of the range",) * 2
        found.append(sorted(branch.events, key=lambda event: event.parameter))
    kinds = [event.kind for event in found[0]]
    assert (kinds.count("branch-point"), kinds.count("grazing")) == (6, 5)
    for one, other in zip(*found, strict=True):
        off = 1e-12 + other.estimate
        assert (one.kind, one.parameter) == (
            other.kind,
            pytest.approx(other.parameter, abs=off),
        )
        assert other.estimate < 2e-11


def test_where_an_orbit_loses_a_symmetry_about_another_place_there_are_others(
    monkeypatch,
) -> None:
    """They are as many as about 0, where half a period of the symmetric orbit is followed."""
    s, g = sp.Symbol("s", real=True), sp.Symbol("g", positive=True)
    stops = between_stops(0.02, x - s, g, g, middle=(s, "m", 0.0), gap=(g, "m", 0.7))
    unsymmetric = []
    monkeypatch.setattr(branches, "VALUES", 2)  # at the ends there are none
    for middle in (0.0, 0.3):
        found = ns.branches(stops(middle=middle), "frequency", 0.65, 1.2)
        assert [event.kind for event in found[0].events] == ["branch-point"] * 2
        (other,) = (q for q in found[1:] if any(e.kind == "fold" for e in q.events[:6]))
        unsymmetric.append({round(e.parameter, 8) for e in other.events if e.kind == "fold"})
    assert unsymmetric[0] == unsymmetric[1]
    assert len(unsymmetric[0]) == 4


def test_a_branch_goes_on_from_an_event_in_the_first_step_in_new_units() -> None:
    """From this start, and no other tried, the step to the branch point follows a change."""
    case = ns.scene("impact-two-sided")(
        damping=0.133, stiffness=1.905, force=0.408, gap=0.926, restitution=0.933, mass=1.066
    )
    ((event,), _) = both_ways(case, "frequency", (1.2, 1.5), (1.2, 1.3))
    assert event.kind == "branch-point"
    assert event.parameter == pytest.approx(1.33327947882415, abs=1e-12)


def test_a_phase_ends_by_its_velocity_where_it_no_longer_reaches_a_stop() -> None:
    """With friction, a mass that turns before the stop ends its way by another event."""
    g, r = sp.symbols("g r", positive=True)
    law = m * a + k * x - F * forcing
    impact = Event(x - g, jump={v: -r * v})
    ahead = {"before the stop": g - x, "ahead": v}
    phases = (
        Phase("ahead", law + f_s, impact | Event(v), ahead),
        Phase("back", law - f_k, Event(v), {"back": -v}),
    )
    own = parameters(
        f_s=(f_s, "N", 0.15), f_k=(f_k, "N", 0.1), gap=(g, "m", 2.6), r=(r, "", 0.5)
    )
    known = tuple(q for q in oscillator(1.0, 0.0, 1.0, 0.8) if q.name != "damping")
    case = scene_of("rub", known + own, *phases)()
    for (event,) in both_ways(case, "gap", (2.2, 3.3), (2.6, 3.0)):
        assert (event.kind, event.parameter) == ("grazing", pytest.approx(2.72704538454870))


def test_two_phases_behind_a_surface_vanish_where_it_is_no_longer_reached() -> None:
    """A spring and a one-way damper: nearer, pressed, back, away; beyond, two of them."""
    g, d, stop = sp.symbols("g d k_c", positive=True)
    law, push = m * a + k * x - F * forcing, stop * (x - g)
    phases = (
        Phase("nearer", law + 3 * c * v, Event(x - g) | Event(v), {"off": g - x, "up": v}),
        Phase("press", law + push + (3 * c + d) * v, Event(v), {"on": x - g, "up": v}),
        Phase("back", law + push + c * v, Event(x - g), {"on": x - g, "down": -v}),
        Phase("away", law + c * v, Event(v), {"off": g - x, "down": -v}),
    )
    own = parameters(gap=(g, "m", 1.7), d=(d, "N s/m", 1.0), stop=(stop, "N/m", 5.0))
    case = scene_of("one-way", oscillator(1.0, 0.2, 1.0, 0.8) + own, *phases)()
    for (event,) in both_ways(case, "gap", (1.45, 2.18), (1.7, 2.0)):
        assert event.parameter == pytest.approx(1.82135084396810)


@pytest.mark.parametrize("friction", [0.5, 0.87])
def test_a_phase_begins_just_before_a_landing_with_the_speed_before_it(friction: float) -> None:
    """The mass reaches the speed of the belt as it lands on a stop, from either side."""
    f, g = sp.symbols("f g", positive=True)
    moves, land = m * a + c * v + k * x - F * forcing, Event(x - g, jump={v: 0})
    pull, presses = k * x + c * V - F * forcing, F * forcing + f - k * g
    before = {"before the stop": g - x}
    holds = {"forwards": f - pull, "back": f + pull, **before}
    slip = Phase("slip", moves - f, Event(v - V) | land, {"slower": V - v, **before})
    stick = Phase("stick", a, Event(pull - f) | Event(pull + f) | land, holds, held=V)
    ahead = Phase("ahead", moves + f, land | Event(v - V), {"faster": v - V, **before})
    rest = Phase("rest", a, Event(presses), {"it presses": presses}, held=0)
    own = parameters(friction=(f, "N", 0.5), gap=(g, "m", 0.53), belt=(V, "m/s", 1.35))
    own += oscillator(1.0, 0.4, 1.0, 1.42)
    scene = scene_of("landing", own, slip, stick, ahead, rest)
    found = ns.branch(scene(friction=friction), "friction", 0.5, 0.87)
    assert [event.kind for event in found.events] == ["sticking"]
    assert found.events[0].parameter == pytest.approx(0.551930651358, rel=1e-11)
    assert found.why_it_ended == ("the end of the range",) * 2
    motions = {"".join(sorted(row.motion.split(","))) for row in found.rows}
    assert motions == {"restslip_by_2", "restslipstick_by_3"}
    for row in (found.rows[0], found.rows[-1]):
        exact = exact_orbit(scene(friction=row.value))
        assert sorted(row.durations) == pytest.approx(sorted(exact.durations), rel=1e-9)


def test_an_orbit_that_hardly_moves_is_followed_though_it_does_not_change() -> None:
    """Its first corrections are rounding, a hundred times that of a motion of unit size."""
    f, h = sp.symbols("f h", positive=True)
    pull, own = k * x - F * forcing, oscillator(1.0, 0.0, 1.0, 1.0332)
    slip = Phase("slip", m * a + c * v + pull + f, Event(v), {"forwards": v, "far": h - x})
    stick = Phase("stick", a, Event(pull + f), {"holds": f - sp.Abs(pull)}, held=0)
    own += parameters(friction=(f, "N", 0.97), far=(h, "m", 1.0))
    slider = scene_of("slider", own, slip, stick, half_period=True)()
    found = ns.branch(slider, "far", 0.5, 2.0)
    assert found.why_it_ended == ("the end of the range",) * 2
    first, last = found.rows[0], found.rows[-1]
    assert last.durations == pytest.approx(first.durations, rel=1e-9)
