"""What happens on a branch, against values of other programs, in 20 digits and more.

Folds: Newton's method at 600 bits; flips and grazings of the impact oscillator and the boundary
of dry friction: closed forms; the ends of contact: the linear response; the end of the damped
stick-slip orbit: an ODE solver with events; of inelastic impacts: where the flight that leaves
a rest hits the stop as it begins to press, or a period later, in 40 digits.
"""

import itertools
from functools import cache
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.optimize import brentq
from shown import ROOT

import nonsmooth as ns
from nonsmooth.solver.branch import walk
from nonsmooth.solver.branch.course import Course
from nonsmooth.solver.branch.events import in_step
from nonsmooth.solver.branch.events.in_step import in_turn
from nonsmooth.solver.branch.events.locate import Found
from nonsmooth.solver.branch.piece import Piece
from nonsmooth.solver.branch.place import NoStepError
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.existence.known import are_one, known_orbits
from nonsmooth.solver.in_order import motion_of
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.solve import with_order

SPRING = {"force": 0.3, "damping": 0.1, "gap": 1.0}
FRICTION = {"damping": 0.0, "mu_s": 0.4, "mu_k": 0.4}
STOP = {"damping": 0.0, "restitution": 0.8, "gap": 0.5}
BOUNDARY = 0.535755336592705588

#: Scene, parameters, what varies, its range; what happens in turn, and where.
RESPONSES = {
    "impact": (
        "impact", STOP, "frequency", (0.9, 2.2),
        [
            ("flip", 1.01445763678408881), ("flip", 1.09497644619305227),
            ("fold", 1.93383878222628754), ("grazing", np.sqrt(3.0)),
        ],
    ),
    "impact, a second touch": (
        "impact", STOP | {"gap": 0.0, "frequency": 1.2}, "frequency", (1.0, 1.25),
        [("grazing", 1.00621643423140580), ("flip", 1.00634916395299999)],
    ),
    "backlash": (
        "backlash", SPRING | {"frequency": 0.7}, "frequency", (0.5, 1.2),
        [
            ("fold", 0.816874192230852792), ("fold", 0.541172577515344920),
            ("grazing", 0.543177377818286865),
        ],
    ),
    "clearance": (
        "clearance", SPRING | {"frequency": 1.0}, "frequency", (0.3, 2.0),
        [
            ("grazing", 0.84386793801144), ("fold", 1.23489905968420878),
            ("fold", 1.13004874973740283), ("grazing", 1.13043659848587),
        ],
    ),
    "dry-friction, from above": (
        "dry-friction", FRICTION | {"frequency": 0.8}, "frequency", (0.5, 0.9),
        [("sticking", BOUNDARY)],
    ),
    "dry-friction, from below": (
        "dry-friction", FRICTION | {"frequency": 0.4}, "frequency", (0.3, 0.9),
        [("sticking", BOUNDARY)],
    ),
    # it slides ever less, and rests for ever where friction is as large as the force
    "dry-friction, to rest": (
        "dry-friction", {"normal_force": 2.6}, "normal_force", (2.5, 5.0),
        [("sticking", 1 / 0.3)],
    ),
    # a further flight, of no duration at first, comes and goes before the rest
    "impact-inelastic": (
        "impact-inelastic", {"gap": 0.36}, "frequency", (0.15, 2.5),
        [
            *(
                ("sticking", value)
                for value in (
                    0.152174998207463243, 0.175634302726275168, 0.202767346379209949,
                    0.243920172273236434, 0.303002664284276000, 0.397274932907135740,
                    0.589914111625039429, 1.502194456490285041,
                )
            ),
            ("fold", 1.944029714127348675), ("grazing", 1.941901567308380107),
        ],
    ),
    # c = 2 zeta sqrt(k m)
    "stick-slip-damped": (
        "stick-slip-damped", {}, "damping", (1.0, 20.0),
        [("sticking", 200 * 0.0578291161376641)],
    ),
}  # fmt: skip


@cache
def response(name: str) -> tuple[ns.Branch, list[tuple[str, float]]]:
    """Return a branch, and what is to happen on it."""
    scene, values, vary, ends, expected = RESPONSES[name]
    return ns.branch(ns.scene(scene)(**values), vary, *ends), expected


@pytest.fixture(scope="module", params=RESPONSES)
def both(request) -> tuple[ns.Branch, list[tuple[str, float]]]:
    return response(request.param)


def test_what_happens_is_located_to_rounding(both) -> None:
    branch, expected = both
    assert [event.kind for event in branch.events] == [kind for kind, _ in expected]
    for event, (_, value) in zip(branch.events, expected, strict=True):
        assert event.parameter == pytest.approx(value, rel=1e-12)
        assert abs(event.parameter - value) <= 20 * event.estimate + 1e-14 * value
        assert event.estimate <= 1e-13 * value


def exactly(branch: ns.Branch, row):
    """Return the exact orbit to which the times of a row lead."""
    case = branch.case.with_value(branch.parameter, row.value)
    scene = motion_of(case.scene, row.motion) if row.motion else case.scene
    case = Case(scene, case.values, case.cycles)
    times = row.durations[: len(case.cell.phases)]
    return exact_orbit(case, times, row.forcing_phase or 0.0)


def test_every_orbit_is_one_and_as_stable_as_it_is_said(both) -> None:
    branch, _ = both
    rows = [
        row
        for row in branch
        if row.stable is not None and not (row.motion or "").startswith("only ")
    ]
    for row in rows[:: max(1, len(rows) // 6)]:
        exact = exactly(branch, row)  # admissible, or it raises
        assert exact.durations == pytest.approx(row.durations, rel=1e-9)
        assert exact.stable == row.stable
        assert exact.multipliers == pytest.approx(row.multipliers, rel=1e-6, abs=1e-9)
        for name, ends in exact.extremes.items():
            assert row.extremes[name] == pytest.approx(ends, rel=1e-9, abs=1e-12)


def test_beyond_the_contact_it_is_the_linear_response() -> None:
    branch, _ = response("clearance")
    rows = [row for row in branch if row.motion == "only separated"]
    m = k = 1.0
    assert [row.value for row in (rows[0], rows[-1])] == [0.3, 2.0]
    for row in rows:
        w, c, force = row.value, SPRING["damping"], SPRING["force"]
        reach = force / np.hypot(k - m * w * w, c * w)
        assert row.extremes["displacement"] == pytest.approx((-reach, reach), rel=1e-12)
        assert row.extremes["velocity"] == pytest.approx((-w * reach, w * reach), rel=1e-12)
        assert row.multipliers[0].real == pytest.approx(
            np.exp(-c / 2 * 2 * np.pi / w) * np.cos(np.sqrt(k - c * c / 4) * 2 * np.pi / w)
        )
        assert row.stable
    assert not any(0.84387 < row.value < 1.13043 for row in rows)


def test_between_folds_there_are_three_orbits_and_the_middle_one_is_unstable() -> None:
    branch, _ = response("clearance")
    inner = [row for row in branch if 1.1305 < row.value < 1.2348]
    assert {row.stable for row in inner} == {True, False}
    low, high = branch.events[2].parameter, branch.events[1].parameter
    turned = [row.stable for row in branch if row.value in {low, high}]
    assert turned == [None, None]
    unstable = [row.value for row in branch if row.stable is False]
    assert low < min(unstable) < max(unstable) < high


def test_phases_are_put_in_as_the_frequency_falls() -> None:
    case = ns.scene("dry-friction")(**FRICTION, frequency=0.8)
    branch = ns.branch(case, "frequency", 0.1, 0.9)
    motions = list(dict.fromkeys(row.motion for row in reversed(branch.rows)))
    four, six = "slide,-stop,slide,stop,mirrored", "slide,-stop,slide,-stop,slide,stop,mirrored"
    assert motions == ["sliding", "two-stops", four, six]
    assert [event.kind for event in branch.events] == ["sticking"] * 3
    for motion in motions:
        row = next(row for row in branch if row.motion == motion and row.multipliers)
        assert exactly(branch, row).durations == pytest.approx(row.durations, rel=1e-9)


def test_a_branch_is_the_same_from_any_of_its_orbits() -> None:
    scene, values, vary, ends, expected = RESPONSES["clearance"]
    spring = ns.scene(scene)(**values | {"frequency": 1.2})
    unstable = next(
        orbit for orbit in known_orbits(spring) if orbit.stable is False
    )  # between the folds
    branch = ns.branch(spring, vary, *ends, start=unstable)
    found = [(event.kind, event.parameter) for event in branch.events]
    found = found if found[0][1] < 1 else found[::-1]
    assert [kind for kind, _ in found] == [kind for kind, _ in expected]
    values_there = [value for _, value in found]
    assert values_there == pytest.approx([value for _, value in expected], rel=1e-12)


def test_half_a_period_loses_its_symmetry_where_a_reference_says() -> None:
    case = ns.scene("backlash")(**SPRING | {"frequency": 0.5})
    branch = ns.branch(case, "frequency", 0.3, 0.5)
    (event,) = branch.events
    assert (event.kind, event.phase) == ("branch-point", None)
    assert event.parameter == pytest.approx(0.369137, abs=1e-6)
    assert [row.stable for row in branch][:: len(branch) - 1] == [False, True]


def test_where_no_order_goes_on_it_is_said() -> None:
    branch, _ = response("backlash")  # without a spring in the gap, the mass may drift there
    assert [why.split(",")[0] for why in branch.why_it_ended] == [
        "the end of the range",
        "grazing",
    ]
    assert branch.rows[-1].stable is None


def test_an_orbit_that_grows_without_bound_ends_its_branch() -> None:
    case = ns.scene("dry-friction")(**FRICTION, frequency=0.8)
    branch = ns.branch(case, "frequency", 0.7, 1.3)  # resonance, and no damping
    assert branch.why_it_ended[1] == "the orbit grows beyond all bounds"
    assert branch["value"].max() == pytest.approx(1.0, abs=1e-6)


def test_an_island_is_a_closed_branch() -> None:
    case = ns.scene("clearance")(force=0.5, damping=0.05, gap=0.5, frequency=2.4, cycles=2)
    branch = ns.branch(case, "frequency", 1.0, 6.0)
    assert branch.why_it_ended == ("the branch is closed",) * 2
    assert [event.kind for event in branch.events] == ["fold", "fold"]
    low, high = sorted(event.parameter for event in branch.events)
    assert (branch["value"].min(), branch["value"].max()) == (low, high)
    for row in branch:
        if row.value in {low, high}:
            assert row.multipliers[0] == pytest.approx(1.0, abs=1e-6)


@pytest.mark.parametrize("before", [1e-9, 1e-7, 1e-5, 1e-3])
def test_an_island_has_both_folds_wherever_it_begins(before: float) -> None:
    case = ns.scene("clearance")(force=0.5, damping=0.05, gap=0.5, cycles=2)
    for orbit in known_orbits(case.with_value("frequency", 2.49631532884920 - before)):
        branch = ns.branch(case, "frequency", 1.0, 6.0, start=orbit)
        assert branch.why_it_ended == ("the branch is closed",) * 2
        assert [event.kind for event in branch.events] == ["fold", "fold"]


def test_an_island_is_closed_whichever_phase_its_orbit_begins_with() -> None:
    case = ns.scene("clearance")(
        force=1.1, damping=0.061, gap=0.39, contact_stiffness=4.2, frequency=2.05, cycles=2
    )
    order = "contact,separated,contact,separated"
    start = ns.solve(case, phases=order, method="ck-tau", order=10)
    branch = ns.branch(case, "frequency", 1.0, 6.0, start=start)
    assert branch.why_it_ended == ("the branch is closed",) * 2
    kinds = sorted(event.kind for event in branch.events)
    assert kinds == ["fold", "fold", "grazing", "grazing"]
    assert branch[0].value == pytest.approx(branch[-1].value, abs=1e-9)
    durations = (sorted(branch[i].durations) for i in (0, -1))  # from another phase on
    assert next(durations) == pytest.approx(next(durations), abs=1e-6)


def test_once_a_period_it_is_where_a_simulation_settles() -> None:
    branch, _ = response("clearance")
    rows = [row for row in branch if row.stable and 0.5 < row.value < 1.13]
    for row in rows[:: len(rows) // 5]:
        case = branch.case.with_value(branch.parameter, row.value)
        (states,) = ns.diagram(case, branch.parameter, [row.value], 400, 1).states
        if row.motion is None or row.value < 0.84:
            np.testing.assert_allclose(states[0], row.strobe, atol=1e-6)


def test_an_orbit_of_two_impacts_ends_where_the_one_with_a_single_impact_flips() -> None:
    stop = ns.scene("impact")(damping=0.02, restitution=0.8, gap=0.0, frequency=2.7)
    twice = with_order(stop, "flight,flight", 2)
    branch = ns.branch(twice, "frequency", 2.65, 2.72)
    assert branch.why_it_ended[0] == "the orbit becomes one of half its period"
    meeting, flip = branch.events
    assert (meeting.kind, flip.kind) == ("branch-point", "flip")
    single = ns.branch(stop.with_value("frequency", 2.6), "frequency", 2.6, 2.72)
    (doubles,) = single.events
    assert doubles.kind == "flip"
    assert abs(meeting.parameter - doubles.parameter) <= 1e-13
    assert meeting.estimate <= 1e-13
    assert [row.stable for row in single][:: len(single) - 1] == [True, False]


@pytest.mark.parametrize(
    ("scene", "values", "ends", "cycles"),
    [
        ("impact", STOP | {"frequency": 1.05}, (1.0, 1.12), 2),
        ("backlash", SPRING | {"frequency": 0.4}, (0.3, 0.5), 1),
    ],
)
def test_at_a_flip_there_is_an_orbit_of_twice_the_period(scene, values, ends, cycles) -> None:
    """And where the symmetry is lost, one without it, which may have flips of its own."""
    single, double, *_ = ns.branches(ns.scene(scene)(**values), "frequency", *ends)
    flips = [event.parameter for event in single.events]
    met = [event for event in double.events if event.kind == "branch-point"]
    assert len(met) == len(flips)
    assert double.case.cycles == cycles
    for event, value in zip(met, sorted(flips), strict=True):
        assert abs(event.parameter - value) <= 1e-13
        assert event.estimate <= 1e-13
    rows = [row for row in double if row.stable is not None]
    assert {row.stable for row in rows} == {True, False}
    inner = rows[5:-5]  # where branches meet the equations are singular
    for row in inner[:: len(inner) // 5]:
        exact = exactly(double, row)  # no repetition of a shorter one, or it raises
        assert exact.stable == row.stable
        assert exact.durations == pytest.approx(row.durations, rel=1e-8)


@pytest.mark.parametrize("load", [0.0, 0.3])
def test_flow_vanishes_where_elastic_motion_just_reaches_the_yield_force(load: float) -> None:
    """Under a load both flows vanish together, and no orbit is isolated there."""
    own = {"load": load} if load else {}
    file = str(ROOT / "examples/scenes/loaded_plasticity.py")
    scene = ns.scene(file if load else "elastic-plastic")
    found = ns.branch(scene(**own, frequency=1.3), "frequency", 1.2, 2.2)
    (event,) = found.events
    nothing = "nothing sets w, which may have any of many values"
    beyond_it = f"beyond which {'no order of phases is found' if load else nothing}"
    assert (event.kind, found.why_it_ended[1]) == ("vanishing", f"vanishing, {beyond_it}")

    def beyond(omega: float) -> float:
        """By amplitude 1 of the force, m = k = 1, c = 0.1, h = 0.2, F_y = 0.5."""
        return 1 / abs(1.2 - omega**2 + 0.1j * omega) - 0.5

    assert event.parameter == pytest.approx(brentq(beyond, 1.2, 2.2, xtol=1e-15), rel=1e-14)


def test_close_to_each_grazing_of_a_damped_mass_there_is_a_flip() -> None:
    """A multiplier comes from minus infinity as an impact begins, and soon passes -1."""
    stop = ns.scene("impact")(damping=2.0, frequency=1.0)
    found = ns.branch(stop, "frequency", 0.92, 1.0)
    assert [event.kind for event in found.events] == ["flip", "grazing"] * 3
    for flip, grazing in zip(found.events[::2], found.events[1::2], strict=True):
        assert 0 < grazing.parameter - flip.parameter < 2e-4
        (row,) = [row for row in found if row.value == flip.parameter]
        ordered = with_order(stop.with_value("frequency", row.value), row.motion, 1)
        exact = exact_orbit(ordered, row.durations, row.forcing_phase)
        assert exact.admissible
        assert np.min(np.abs(np.array(exact.multipliers) + 1)) < 1e-6


def test_a_branch_that_begins_where_something_happens_has_it() -> None:
    flip = 1.01445763678408881
    found = ns.branch(ns.scene("impact")(**STOP, frequency=flip), "frequency", 1.0, 1.05)
    (event,) = found.events
    assert event.kind == "flip"
    assert event.parameter == pytest.approx(flip, rel=1e-13)


def test_orbits_are_one_wherever_they_begin() -> None:
    """Of two flights that differ, either first."""
    stop = ns.scene("impact")(damping=0.02, restitution=0.8, gap=0.0, frequency=2.7)
    one = exact_orbit(with_order(stop, "flight,flight", 2))
    first, second = one.durations
    assert abs(first - second) > 0.1
    turned = one.forcing_phase + 2.7 * first
    other = exact_orbit(one.case, (second, first), turned)
    assert other.durations == pytest.approx((second, first), rel=1e-12)
    assert are_one(one, other)
    assert not are_one(one, exact_orbit(one.case.with_value("frequency", 2.71)))
    assert not are_one(one, exact_orbit(stop))


def test_the_same_flight_at_another_phase_of_the_forcing_is_another_orbit() -> None:
    """Of a ball on a table, which is free in flight, the one is stable and the other is not."""
    ball = ns.scene(ROOT / "examples" / "bouncing_ball.py")()
    one, other = known_orbits(ball)
    assert one.durations == pytest.approx(other.durations, rel=1e-12)
    assert not are_one(one, other)
    assert (one.stable, other.stable) == (True, False)


def test_impacts_that_follow_ever_faster_are_put_in() -> None:
    """A touch just behind an impact is not between two times of a grid, but in one step."""
    case = ns.scene("impact-two-sided")(damping=0.258, gap=0.309, restitution=0.406)
    branch = ns.branch(case, "frequency", 0.8461, 1.4)
    kinds = [event.kind for event in branch.events]
    assert kinds == ["fold", "grazing"] * 11
    assert len(branch.rows[0].durations) == 2 * 12
    for row in branch.rows[:: len(branch.rows) // 8]:
        assert exactly(branch, row).durations == pytest.approx(row.durations, rel=1e-7)


@pytest.mark.parametrize(
    ("values", "vary", "ends"),
    [
        ({"damping": 0, "gap": 0}, "frequency", (0.98, 1.1)),  # it turns at the touch itself
        ({}, "restitution", (2.05e-4, 2.2e-4)),  # hardly anything of a perturbation is left
    ],
)
def test_behind_a_touch_a_branch_has_one_impact_more(values, vary, ends) -> None:
    branch = ns.branch(ns.scene("impact")(**values), vary, *ends)
    assert {row.motion for row in branch.rows} >= {None, "flight,flight"}
    assert "grazing" not in " ".join(branch.why_it_ended)


def test_what_is_not_watched_ends_a_branch_by_the_solver(monkeypatch) -> None:
    """As if nothing were demanded: the orbits behind the second touch solve all equations."""
    monkeypatch.setattr(Course, "rows", lambda *found: [])
    branch, (touch, _) = response.__wrapped__("impact, a second touch")
    assert branch.why_it_ended[0].startswith("beyond, in flight, not true that the mass stays")
    assert branch["value"].min() > touch[1]
    assert [event.kind for event in branch.events] == ["flip"]


def test_an_orbit_at_rest_at_zero_at_every_switch_is_followed() -> None:
    """With the stop at x = 0 the states at switches are rounding: they have no size."""
    rest = ns.scene("impact-inelastic")(gap=0.0)
    found = ns.branch(rest, "frequency", 0.8, 1.5)
    assert found.why_it_ended == ("the end of the range",) * 2
    for row in found.rows[:: len(found.rows) // 3]:
        exact = ns.exact(rest.scene(gap=0.0, frequency=row.value))
        assert row.durations == pytest.approx([q.duration for q in exact.phases], rel=1e-12)


@pytest.mark.parametrize("frequency", [0.49, 0.495, 0.497, 0.499])
def test_a_flight_follows_a_rest_at_zero_but_for_rounding(frequency) -> None:
    orbit = ns.exact(ns.scene("impact-inelastic")(damping=0, gap=0, frequency=frequency))
    assert orbit.case.scene.motion == "flight,flight,rest"


#: An order of four phases.
FOUR = SimpleNamespace(along=SimpleNamespace(kinds=range(4)))


def test_what_is_not_seen_behind_a_change_of_the_order_does_not_count() -> None:
    """Beyond it there are no such orbits; before it a step is to be shorter."""
    fold = SimpleNamespace(changes=False, column=None, value=1.0)
    ends = SimpleNamespace(changes=True, column=None, phase=0, value=2.0, piece=FOUR)
    found = [(0.3, None), (0.2, ends), (0.1, fold)]
    assert in_turn(found) == [fold, ends]
    for entries in [(0.15, None), *found], [(0.3, None), (0.1, fold)]:
        with pytest.raises(NoStepError):
            in_turn(entries)


def test_few_orbits_are_computed_for_an_event(monkeypatch) -> None:
    """None for what vanishes where or beyond where the order changes, none among rounding."""
    count, stepped = itertools.count(), Piece.stepped
    monkeypatch.setattr(Piece, "stepped", lambda *args: next(count) + 1 and stepped(*args))
    events = ns.branch(ns.scene("impact")(), "frequency", 0.8, 3).events
    assert {event.kind for event in events} == {"grazing", "fold", "flip"}
    assert next(count) < 25 * len(events)


def test_a_phase_vanishes_where_what_it_demands_is_found_but_for_rounding() -> None:
    """What goes with a power of its duration is found to the root of rounding.

    So is what the phases beside it demand.
    """
    demand = SimpleNamespace(changes=True, column=2, phase=0, value=1.0, piece=FOUR)
    for phase, other in ((0, False), (1, False), (2, True), (3, False)):
        ends = SimpleNamespace(changes=True, column=None, phase=phase, value=1.0, piece=FOUR)
        expected = [demand] if other else [ends]
        assert in_turn([(0.3, demand), (0.3 + 1e-8, ends)]) == expected


TOUCH, FOLD = 0.8438679380114447, 1.2348990596842087


@pytest.mark.parametrize(
    ("start", "ends", "kinds"),
    [
        (1.0, (TOUCH, 1.2), "grazing"),
        (TOUCH, (TOUCH, 1.2), "grazing"),
        (1.0, (TOUCH, 1.5), "grazing fold fold grazing"),
        (FOLD, (1.0, 1.5), "fold fold grazing"),
        (1.0, (1.0, FOLD), "fold fold grazing"),
        (1.0, (1.0, FOLD - 1e-9), ""),  # to the end of the range, and not round the fold
        (1.0, (1.0, FOLD + 1e-9), "fold fold grazing"),
    ],
)
def test_an_event_at_an_end_of_the_range_or_at_the_start(start, ends, kinds) -> None:
    spring = ns.scene("clearance")(**SPRING, frequency=start)
    branch = ns.branch(spring, "frequency", *ends)
    assert [event.kind for event in branch.events] == kinds.split()
    least, most = branch["value"].min(), branch["value"].max()
    assert ends[0] * (1 - 1e-14) <= least <= most <= ends[1] * (1 + 1e-14)


@pytest.mark.parametrize("least", [1e-4, 1e-6])
def test_what_happens_just_beyond_the_range_is_no_event(least):
    """Where the element never is elastic, at no yield force, a branch ended at -1e-16 N."""
    branch = ns.branch(ns.scene("elastic-plastic")(), "yield_force", least, 1)
    assert branch.events == ()
    assert branch.why_it_ended == ("the end of the range", "the end of the range")


@pytest.mark.parametrize("ulps", range(-3, 4))
def test_a_branch_begins_at_a_touch_on_the_side_where_there_are_orbits(ulps: int) -> None:
    """Which side is ahead there is rounding; above the touch it is beyond the range."""
    start = TOUCH * (1 + ulps * 2.0**-52)
    spring = ns.scene("clearance")(**SPRING, frequency=start)
    branch = ns.branch(spring, "frequency", start, 1.2)
    kinds, edge = [event.kind for event in branch.events], "the end of the range"
    at_touch = kinds == ["grazing"] and any(
        why.startswith("grazing,") for why in branch.why_it_ended
    )
    assert at_touch or (ulps > 0 and not kinds and branch.why_it_ended == (edge, edge))


@pytest.mark.parametrize(("apart", "kind"), [(1e-8, "vanishing"), (1e-6, "grazing")])
def test_beside_a_phase_that_vanishes_the_next_one_is_known_less_well(apart, kind) -> None:
    piece = SimpleNamespace(along=SimpleNamespace(kinds=range(4)), value=lambda y: y[-1])

    def found(word: str, phase: int, column: int | None, value: float) -> Found:
        return Found(word, phase, column, piece, SimpleNamespace(y=[value]))

    grazing, vanishing = found("grazing", 2, 2, 1.0 + apart), found("vanishing", 1, None, 1.0)
    (event,) = in_turn([(0.5, grazing), (0.5 + apart, vanishing)])
    assert event.kind == kind


@pytest.mark.parametrize("meets", [True, False])
def test_a_fold_is_not_needed_where_branches_meet(monkeypatch, meets: bool) -> None:
    """No step succeeds beside that place, so that it is not located."""
    place = SimpleNamespace(y=np.zeros(2))

    def located(piece, before, after, length, i):
        if i == walk.FOLD:
            raise NoStepError
        yield 0.5, Found("branch-point", None, None, piece, place, i)

    monkeypatch.setattr(in_step, "located", located)
    monkeypatch.setattr(in_step, "torus_crossings", lambda *_: [])
    monitors = np.ones((2, walk.OWN))
    monitors[1, walk.FOLD] = -1.0
    monitors[1, walk.MEETS] = -1.0 if meets else 1.0
    before, after = (SimpleNamespace(y=np.zeros(2), monitors=q) for q in monitors)
    piece = SimpleNamespace(table=[])
    if meets:
        ((_, event),) = in_step.events_in(piece, before, after, 1.0)
        assert event.kind == "branch-point"
    else:
        with pytest.raises(NoStepError):
            in_step.events_in(piece, before, after, 1.0)
