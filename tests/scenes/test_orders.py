"""Orders of phases that no scene declares: found, asked for, refused."""

import pickle
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from made_scenes import made, parameters, scene_of
from one_mass import NAMES

import nonsmooth as ns
from nonsmooth.scene import Event, Phase, a, forcing, v, x
from nonsmooth.solver import solve as solving
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.in_order import cases_in_order
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.loaded import UnknownScene
from nonsmooth.solver.scenes.ordered import in_order
from nonsmooth.solver.scenes.orders import Order, Step, in_cell
from nonsmooth.solver.solve import orbits_of, solve_case, with_order

MOTIONS = [motion for name in NAMES for motion in registry.load(name).each_motion]
ODD = [motion for motion in MOTIONS if motion.half_period]

#: Four stops a period: slide, stop, slide, stop, then mirrored.
FOUR_STOPS = ns.scene("dry-friction")(frequency=0.12, mu_s=0.3, mu_k=0.3, damping=0.05)

#: The orbit with one impact a cycle is not stable here.
BOUNCES = ns.scene("impact")(damping=0.02, restitution=0.8, gap=0, frequency=2.7, cycles=2)


def declared(motion):
    """Return the order of the phases of a motion, as if it were not declared."""
    return Order(tuple(Step(p) for p in range(len(motion.phases))), motion.half_period)


def of_a_period(motion):
    """Return the order of all phases of a period of an odd motion, without its symmetry."""
    steps = declared(motion).steps
    return Order((*steps, *(Step(step.phase, True) for step in steps)))


@pytest.mark.parametrize("motion", MOTIONS, ids=lambda motion: motion.label)
def test_the_declared_order_has_the_declared_equations(motion) -> None:
    again, case = in_order(motion, declared(motion)), motion()
    assert again.classes == motion.classes
    assert again.kinds == motion.kinds
    assert again.memory == motion.memory
    cell = again.cell(case.numbers)
    assert cell.phases == case.cell.phases
    assert cell.memory == case.cell.memory


@pytest.mark.parametrize("motion", ODD, ids=lambda motion: motion.label)
def test_a_whole_period_is_half_of_it_and_its_image(motion) -> None:
    half = motion(frequency=0.4) if motion.motion == "two-stops" else motion()
    whole = Case(in_order(motion, of_a_period(motion)), half.values)
    exact = exact_orbit(half)
    times = np.array([*exact.cell_durations, *exact.cell_durations]) * half.units.time
    found = exact_orbit(whole, times, exact.angle)
    assert found.durations == pytest.approx(exact.durations, rel=1e-12)
    # a memory that is set twice a period adds a multiplier that is 0
    assert found.multipliers[:2] == pytest.approx(exact.multipliers[:2], abs=1e-10)
    start = np.linspace(0, exact.period, 50)
    x = exact.displacement(start)
    assert found.displacement(start) == pytest.approx(x, abs=1e-12 * np.abs(x).max())


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ({"frequency": 0.12, "damping": 0.05}, (8.778200, 12.150966, 0.775803, 4.474970)),
        ({"frequency": 0.10, "damping": 0.02}, (13.646895, 12.195986, 0.566498, 5.006548)),
    ],
)
def test_four_stops_a_period(values, expected) -> None:
    """Durations from a stop on, by another program; the first order declared has two."""
    orbit = solve_case(ns.scene("dry-friction")(mu_s=0.3, mu_k=0.3, **values), order=24)
    slide, *others = orbit.durations[:4]
    assert [*others, slide] == pytest.approx(expected, abs=6e-7)
    assert orbit.case.scene.motion == "slide,stop,-slide,stop,mirrored"
    assert orbit.stable
    assert orbit.errors.times < 1e-12


def test_two_impacts_that_differ() -> None:
    orbit = solve_case(BOUNCES)
    assert sorted(orbit.durations) == pytest.approx([1.961370383, 2.692840956], abs=6e-10)
    assert orbit.case.scene.motion == "flight,flight"
    assert orbit.stable
    assert not solve_case(BOUNCES.with_cycles(1)).stable


def test_an_orbit_that_is_not_stable_stays_where_a_method_lacks_the_stable_one(
    monkeypatch,
) -> None:
    other = exact_orbit(BOUNCES)
    monkeypatch.setattr(solving, "settled_orbit", lambda case, **how: other)
    monkeypatch.setattr(solving.Search, "aside", lambda search, times: iter(()))
    monkeypatch.setattr(solving.Search, "starts", lambda search: iter(()))
    single = BOUNCES.with_cycles(1)
    assert solve_case(single, "hb", 10).case == single
    assert solve_case(single, "ck-tau", 10).case == other.case


@pytest.mark.parametrize("order", [20, 60])
def test_harmonics_find_an_orbit_that_is_half_a_wave_away(order) -> None:
    """Their times are off by up to half a wave of the highest harmonic, after T/N."""
    orbit = solve_case(BOUNCES, "hb", order)
    assert orbit.case.scene.motion == "flight,flight"
    assert orbit.errors.times * order < 0.5


@pytest.mark.parametrize("method", ["ck", "hb-ck"])
def test_every_method_has_the_orbit(method) -> None:
    for case in (FOUR_STOPS, BOUNCES):
        orbit = solve_case(case, method, 20)
        assert orbit.errors.times < 1e-3
        assert orbit.estimate.times == pytest.approx(orbit.errors.times, rel=0.5)


def test_all_orbits_have_those_of_other_orders_on_which_simulations_settle() -> None:
    case = ns.scene("impact-two-sided")(frequency=0.6)
    orbits = orbits_of(case, order=12)
    assert [orbit.stable for orbit in orbits] == [True, True]
    assert [orbit.case.scene.motion for orbit in orbits] == [None, "crossing,crossing,mirrored"]
    others = orbits_of(orbits[1].case, order=12)  # of this order alone: an unstable one, too
    assert [orbit.stable for orbit in others] == [True, False]
    assert others[0].durations == pytest.approx(orbits[1].durations, rel=1e-12)


def test_an_order_is_asked_for_with_or_without_signs() -> None:
    names = "slide,stop,slide,stop"
    found = [case.scene.motion for case in cases_in_order(FOUR_STOPS, names)]
    assert "slide,stop,-slide,stop,mirrored" in found
    assert len(found) == len(set(found)) > 1
    one = ns.solve(FOUR_STOPS, order=24, phases=names)
    assert one.durations == pytest.approx(solve_case(FOUR_STOPS, order=24).durations)
    (signed,) = cases_in_order(FOUR_STOPS, "slide, stop, -slide, stop, mirrored")
    assert signed.scene == one.case.scene
    (several,) = cases_in_order(ns.scene("impact")(), "3 x flight, flight")
    assert several.scene.motion == "flight,flight,flight,flight"


@pytest.mark.parametrize("phases", [None, ",".join(["engaged,loose,-engaged,-loose"] * 2)])
def test_an_orbit_of_the_period_that_is_asked_for_is_looked_for_from_more_states(
    phases,
) -> None:
    """From rest motions settle on orbits of one period and of two."""
    play = ns.scene("backlash")(
        damping=0.0404588, frequency=1.25527167, gap=0.449918, gap_stiffness=0.0, cycles=3,
        mass=1.0, stiffness=1.0, force=1.0,
    )  # fmt: skip
    orbit = ns.solve(play, phases=phases)
    assert orbit.stable
    assert orbit.durations[:2] == pytest.approx([5.34246, 0.486445], rel=1e-4)


def test_of_orders_that_differ_by_where_they_begin_there_is_one() -> None:
    """Eight crossings alike: each goes on as the one before or not, 2^8 in all."""
    case = ns.scene("impact-two-sided")()
    orders = [each.scene.order for each in cases_in_order(case, ["crossing"] * 8)]
    assert sum(not order.half_period for order in orders) == 20  # necklaces, colours swapped
    assert sum(order.half_period for order in orders) == 16 + 2  # of twice as many, and halves


def test_an_order_of_an_odd_scene_may_have_even_cycles() -> None:
    with pytest.raises(ValueError, match="cycles: got 2, expected an odd number"):
        ns.scene("impact-two-sided")(cycles=2)
    case = ns.scene("impact-two-sided")()
    (found,) = cases_in_order(case, "crossing,-crossing,crossing,-crossing", 2)
    assert (found.cycles, found.scene.half_period) == (2, False)


def test_an_orbit_of_even_cycles_is_printed_and_has_no_others(run) -> None:
    numbers = (
        "--gap",
        0.5689,
        "--restitution",
        0.584,
        "--damping",
        0.0197,
        "--frequency",
        3.3703,
    )
    given = "impact-two-sided", *numbers, "--cycles", 2
    status, out, _ = run("solve", *given, "--phases", "crossing,-crossing")
    assert status == 0
    assert "stable" in out
    status, _, err = run("solve", *given)
    assert status == 2
    assert "--cycles: got 2, expected an odd number" in err
    assert "unless phases are given" in err


@pytest.mark.parametrize(
    ("scene", "names", "why"),
    [
        ("dry-friction", "slide,sop", "got 'sop', expected one of slide, stop; did you mean"),
        ("dry-friction", "slide,-slide,-slide", "one cannot follow another"),
        ("impact", "-flight", "got '-flight', expected one of flight"),
        ("stick-slip", "stick,stick", "one cannot follow another"),
        ("elastic-plastic", "plastic,-plastic", "phase 1 of the scene among them"),
        ("backlash", "engaged,engaged", "one cannot follow another"),
        ("dry-friction", ",".join(["slide", "stop"] * 30), "may be meant in"),
        ("impact-two-sided", ",".join(["crossing"] * 10), "may be meant in 112 ways"),
        ("impact", "123456 x flight", "phases: got 123456, expected 100 at most"),
        ("impact", "", "got '', expected one of flight"),
        ("impact", "mirrored", "got none, expected at least one"),
    ],
)
def test_what_is_no_order_is_refused(scene, names, why) -> None:
    with pytest.raises(UnknownScene, match=why):
        ns.solve(ns.scene(scene)(), phases=names)


@pytest.mark.parametrize("phases", [[1], (1, 2), np.array([1.0])])
def test_phases_that_are_no_names_are_named(phases) -> None:
    with pytest.raises(TypeError, match=r"^phases: got .*, expected names of phases"):
        with_order(registry.load("impact")(), phases)


def test_a_repetition_is_no_new_orbit() -> None:
    twice = ("impact", "flight,flight", 2), ("stick-slip", "stick,slip,stick,slip", 1)
    for scene, names, cycles in twice:
        with pytest.raises(NoOrbit) as caught:
            ns.solve(ns.scene(scene)(), phases=names, cycles=cycles)
        assert any("2 times in a row" in why for why in caught.value.tried)


def test_an_orbit_that_would_stop_on_the_way_is_none() -> None:
    """The mass slides back without a stop only where the load exceeds the static limit."""
    found = [
        cases_in_order(ns.scene("dry-friction")(mu_s=mu_s, mu_k=0.2), "slide,mirrored")[0]
        for mu_s in (0.25, 3.0)
    ]
    assert exact_orbit(found[0]).admissible
    with pytest.raises(NoOrbit) as caught:
        exact_orbit(found[1])
    words = "where slide ends, stop follows, not -slide"
    assert any(words in why for why in caught.value.tried)


def test_an_orbit_comes_back_from_its_file_and_from_a_pickle(tmp_path: Path) -> None:
    for case in (FOUR_STOPS, BOUNCES):
        orbit = solve_case(case)
        assert pickle.loads(pickle.dumps(orbit)) == orbit
        ns.save(orbit, tmp_path / "orbit.json")
        again = ns.load(tmp_path / "orbit.json")
        assert again == orbit
        assert again.case.scene.order == orbit.case.scene.order


def test_a_family_goes_on_in_the_order_of_the_orbit_before() -> None:
    found = ns.family(FOUR_STOPS, "damping", [0.05, 0.045, 0.04], "ck-tau", 12)
    assert {row.motion for row in found.rows} == {"slide,stop,-slide,stop,mirrored"}
    assert [row.followed for row in found.rows] == [False, True, True]


def backlash(preload):
    """Return a mass with play, both sides declared: no order of it says that it is odd."""
    gap, stiff = 1.0, 1.0
    on, off = gap + preload, -gap + preload
    free = (1.0, 0.1, 0.0, 0.0, 0.8)
    above, below = ({"above": (1.0, 0, 0, -on)}, {"below": (-1.0, 0, 0, off)})
    within = {"not above": (-1.0, 0, 0, on), "not below": (1.0, 0, 0, -off)}
    return made(
        [(1.0, 0.1, stiff, stiff * on, 0.8), free, (1.0, 0.1, stiff, stiff * off, 0.8), free],
        [(1.0, 0, 0, -on), (1.0, 0, 0, -off), (1.0, 0, 0, -off), (1.0, 0, 0, -on)],
        omega=0.7,
        demands=(above, within, below, within),
        k=2,
    )


def test_that_a_scene_is_odd_is_deduced() -> None:
    names = "phase 0,phase 1,phase 2,phase 3"
    expected = exact_orbit(ns.scene("backlash")()).durations
    half, whole = cases_in_order(backlash(0.0)(), names)
    assert [half.scene.half_period, whole.scene.half_period] == [True, False]
    for case in (half, whole):
        assert exact_orbit(case).durations == pytest.approx(expected, rel=1e-12)
    (preloaded,) = cases_in_order(backlash(0.1)(), names)
    assert not preloaded.scene.half_period
    with pytest.raises(ValueError, match="is not a motion for these parameters"):
        Case(in_order(backlash(0.1), half.scene.order), {}).cell  # noqa: B018


def test_a_preloaded_play_touches_on_both_sides_or_on_one() -> None:
    both = exact_orbit(with_order(backlash(0.1)(), "phase 0,phase 1,phase 2,phase 3"))
    assert both.admissible
    low, high = both.extremes["displacement"]
    assert low < -0.9 < 1.1 < high


def test_a_declared_order_that_is_asked_for_has_no_other_orbit_beside_it() -> None:
    case = registry.load("dry-friction")()
    assert solving.solve_case(case, method="ck-tau", order=8).others == []
    asked = with_order(case, "-slide,slide")
    assert solving.solve_case(asked, method="ck-tau", order=8).others == []


def test_a_phase_that_comes_again_is_made_once() -> None:
    """Along a branch near chatter a cell of 40 flights is made thousands of times."""
    phases = in_cell(registry.load("impact")().cell, Order((Step(0),) * 40)).phases
    assert (len(phases), len({*map(id, phases)})) == (40, 1)


def test_a_scene_with_a_phase_that_has_no_image_has_no_half_periods() -> None:
    """Friction both ways, and a rest that ends forward: asked for is a whole period."""
    rubbing = made(
        [(1.0, 0.2, 40.0, -3.0, 8.0), (1, 0, 0, 0, 0), (1.0, 0.2, 40.0, 3.0, 8.0)],
        [(0, 1, 0, 0), (-40, 0, 8, 3), (0, 1, 0, 0)],
        omega=2.0,
        held=(None, 0.0, None),
        demands=(
            {"forward": (0, 1, 0, 0)},
            {"held": (-40, 0, 8, 3), "held there": (40, 0, -8, 3)},
            {"backward": (0, -1, 0, 0)},
        ),
    )
    with pytest.raises(ValueError, match="where one cannot follow another"):
        cases_in_order(rubbing(), "phase 0,phase 1,phase 2,phase 1")


def test_of_two_orbits_of_one_undeclared_order_all_ways_take_the_stable_one() -> None:
    """A loaded gear pair with backlash: simulations come near to the unstable one first."""
    m, c, k, P, g, F, Omega = sp.symbols("m c k P g F Omega", positive=True)
    own = m * a + c * v - P - F * forcing
    above, below = Event(x - g), Event(x + g)
    phases = (
        Phase("drive", own + k * (x - g), above, {"drive flank": x - g}),
        Phase("play", own, above | below, {"in the play": g - sp.Abs(x)}),
        Phase("coast", own + k * (x + g), below, {"coast flank": -x - g}),
    )
    known = parameters(
        mass=(m, "kg", 1.0), damping=(c, "N s/m", 0.1), mesh=(k, "N/m", 1.0),
        load=(P, "N", 0.1), play=(g, "m", 1.0), force=(F, "N", 0.3),
        frequency=(Omega, "rad/s", 0.8),
    )  # fmt: skip
    gear = scene_of("gear", known, *phases)()
    order = "drive,play_by_2,coast,play"
    for found in (
        exact_orbit(cases_in_order(gear, order)[0]),
        ns.solve(gear, phases=order),
        ns.solve(gear, tol=1e-8),
        ns.exact(gear),
    ):
        durations = {phase.name: phase.duration for phase in found.phases}
        wanted = {"drive": 3.254292, "play_by_2": 0.747638, "coast": 3.105907, "play": 0.746145}
        assert durations == pytest.approx(wanted, abs=1e-6)
        assert found.stable
