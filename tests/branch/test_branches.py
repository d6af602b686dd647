"""Branches as users hold them: what is refused, shown, written, interrupted."""

import csv
import json
import math
import signal
from functools import partial
from itertools import islice
from pathlib import Path

import numpy as np
import one_mass
import pytest
from galerkin.solving import differences
from scipy.optimize import brentq

import nonsmooth as ns
from nonsmooth.plots.families import branch_figure
from nonsmooth.solver import branches
from nonsmooth.solver.branch import branch, every_way, piece, walk, watch
from nonsmooth.solver.branch.along import Interval
from nonsmooth.solver.branch.bodies import watched, ways
from nonsmooth.solver.branch.bodies.arrays import UNKNOWN
from nonsmooth.solver.branch.branch import course_of, start_of
from nonsmooth.solver.branch.extended import case_at, jacobian_along, residual_along
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.existence.reasons import motions_without_switches
from nonsmooth.solver.flow.exact_system import arrays
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.results.interrupted import Interrupted
from nonsmooth.solver.scenes.case import Case

SPRING = ns.scene("clearance")(force=0.3, damping=0.1, gap=1.0, frequency=1.0)
FLAGS = ("clearance", "--force", 0.3, "--damping", 0.1, "--gap", 1, "--frequency", 1)
MOTIONS = [motion for name in one_mass.NAMES for motion in registry.load(name).each_motion]


@pytest.fixture(scope="module")
def found() -> ns.Branch:
    return ns.branch(SPRING, "frequency", 0.8, 1.3)


def started(motion):
    """Return a piece about the exact orbit of a scene's defaults, its last parameter varied."""
    orbit = exact_orbit(motion(frequency=0.4) if motion.motion == "two-stops" else motion())
    index = len(motion.parameters) - 1
    value = tuple(orbit.case.values.values())[index]
    ends = (0.9 * value, 1.05 * value) if value else (-0.1, 0.1)
    return start_of(orbit, index, ends)


@pytest.mark.parametrize("motion", MOTIONS, ids=lambda motion: motion.label)
def test_series_are_the_equations_along_the_parameter(motion) -> None:
    there, place = started(motion)
    for q in (-0.7, float(place.y[-1]), 0.9):
        y = np.append(place.y[:-1], q)
        case = case_at(there.along, q)
        expected = arrays(there.course.cell(there.numbers(y)))
        for one, other in zip(case[1:5], expected[1:], strict=True):
            np.testing.assert_allclose(one, other, rtol=2e-15, atol=1e-15)


def rows_at(equations, y: np.ndarray) -> np.ndarray:
    """Return the residual at unknowns and the parameter."""
    R = np.empty(len(y) - 1)
    residual_along(equations, y[:-1], y[-1], R)
    return R


@pytest.mark.parametrize("motion", MOTIONS, ids=lambda motion: motion.label)
def test_the_derivatives_are_those_of_the_equations(motion) -> None:
    there, place = started(motion)
    divided = there.along._replace(divided=np.ones_like(there.along.divided))
    for equations in (there.along, divided):  # rows divided by durations too
        n = len(place.y) - 1
        J = np.empty((n, n + 1))
        jacobian_along(equations, place.y[:-1], place.y[-1], J)
        expected = differences(partial(rows_at, equations), place.y, 1e-6)
        np.testing.assert_allclose(J.T, expected, rtol=1e-6, atol=1e-7)


@pytest.mark.parametrize("motion", MOTIONS[::4], ids=lambda motion: motion.label)
def test_divided_equations_and_derivatives_have_a_limit(motion) -> None:
    """Of a duration that is exactly 0, or next to nothing."""
    there, place = started(motion)
    along = there.along._replace(divided=np.ones_like(there.along.divided))
    n = len(place.y) - 1
    for s in (0.0, 1e-17, -1e-12):
        y, J = np.array([*place.y[:-1], 0.3]), np.empty((n, n + 1))
        y[along.before] = s
        jacobian_along(along, y[:-1], y[-1], J)
        expected = differences(partial(rows_at, along), y, 1e-5)[:-1]
        np.testing.assert_allclose(J.T[:-1], expected, rtol=1e-5, atol=1e-5)


def test_the_determinant_of_singular_equations_is_zero() -> None:
    there, place = started(MOTIONS[0])
    nowhere = np.zeros(len(place.y))
    direction, determinant = there.course.by("tangent", there.along, place.y, nowhere)
    assert determinant == 0.0
    assert np.isnan(direction).all()


@pytest.mark.parametrize("motion", MOTIONS, ids=lambda motion: motion.label)
def test_what_is_watched_is_not_negative_on_an_orbit(motion) -> None:
    there, place = started(motion)
    monitors = place.monitors[: -walk.OWN]
    assert not (monitors < 0).any()
    assert (monitors[-len(there.along.kinds) :] > 0).all()
    orbit = there.orbit(place.y)
    assert orbit is not None
    ends = [place.extremes[j] * there.case.units.of_motion(j) for j in (0, 1)]
    if there.cell.sign > 0:
        for name, own in zip(("displacement", "velocity"), ends, strict=True):
            assert orbit.extremes[name] == pytest.approx(own, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("slow", [0.4, 0.04, 1e-6])
def test_a_form_that_falls_and_rises_again_within_a_step_has_its_least(slow: float) -> None:
    """A mass without a spring, whose velocity is (t - t_1)(t - 3 t_1) but for t^3."""
    t_1, omega = 0.05 * slow, 1.0
    equation = np.array([1.0, 0.0, 0.0, -4 * t_1, 2 / omega])  # m, c, k, f, g
    angle, v = -np.pi / 2, 3 * t_1**2
    t = np.linspace(0, 1, 8)
    turned = angle + omega * t
    waves = np.cos(turned), np.sin(turned)
    speed = v - 4 * t_1 * t + 2 * (1 - np.cos(t))
    place = v * t - 2 * t_1 * t**2 + 2 * (t - np.sin(t))
    grid = np.column_stack([t, place, speed, *waves])
    least, when = watch.least_inside(equation, omega, angle, grid, (1.0, 0, 0, 0), 0)
    assert when == pytest.approx(3 * t_1, rel=0.01)
    assert least == pytest.approx(0.0, abs=0.01 * t_1**3)


@pytest.mark.parametrize("t_1", [2e-3, 5e-5])
def test_a_form_of_a_body_that_falls_and_rises_again_has_its_least(t_1: float) -> None:
    """The same motion, as that of a body; its state has the wave and 1 behind it."""
    generator = np.zeros((5, 5))
    generator[0, 1] = generator[3, 2] = 1.0
    generator[1, 2:] = 2.0, 0.0, -4 * t_1
    generator[2, 3] = -1.0
    begin = np.array([0.0, 3 * t_1**2, 0.0, -1.0, 1.0])  # x, v, cos, sin, 1
    case = (None, generator[None], *[None] * 5, UNKNOWN)
    way = ways.way_of(case, 0)
    grid = ways.along(way, 1.0, begin)
    step = 1 / (grid.shape[1] - 1)
    assert 3 * t_1 < step
    finer, terms = ways.halves(way, step), ways.expanded(way, np.eye(5)[0])
    least, when = watched.least_inside(way, grid, 1.0, finer, terms, 0)
    assert when == pytest.approx(3 * t_1, rel=0.01)
    assert least == pytest.approx(0.0, abs=0.01 * t_1**3)


@pytest.mark.parametrize("seed", range(12))
def test_the_least_of_many_minima_of_a_body_is_found(seed: int) -> None:
    """Of a sum of cosines, against all its minima between many more times."""
    rng, m = np.random.default_rng(seed), 5
    omega, parts = rng.uniform(2, 8, m), rng.normal(size=m)
    generator = np.zeros((2 * m + 3, 2 * m + 3))
    generator[:m, m : 2 * m], generator[m : 2 * m, :m] = np.eye(m), -np.diag(omega**2)
    angle = rng.uniform(0, 6, m)
    begin = np.array([*np.cos(angle), *(-omega * np.sin(angle)), 0.0, 0.0, 1.0])
    case = (None, generator[None], *[None] * 5, UNKNOWN)
    way, s, form = ways.way_of(case, 0), 9.0, np.array([*parts, *[0.0] * (m + 2), 2.0])
    grid = ways.along(way, s, begin)
    finer, terms = ways.halves(way, s / (grid.shape[1] - 1)), ways.expanded(way, form)
    least, when = watched.least_inside(way, grid, s, finer, terms, 0)

    def derivative(t: float, j: int) -> float:
        return float(parts @ (omega**j * np.cos(omega * t + angle + j * np.pi / 2)))

    times = np.linspace(0, s, 4000)
    rates = np.array([derivative(t, 1) for t in times])
    rises = np.flatnonzero((rates[:-1] < 0) & (rates[1:] >= 0))
    minima = [brentq(derivative, times[i], times[i + 1], (1,), xtol=1e-13) for i in rises]
    assert len(minima) > 2
    expected = min(minima, key=lambda t: derivative(t, 0))
    assert when == pytest.approx(expected, abs=1e-8)
    assert least == pytest.approx(2 + derivative(expected, 0), abs=1e-12)


def test_from_the_branch_itself_corrections_do_not_count() -> None:
    """They are rounding, of which the second may be as large as the first."""
    for motion in MOTIONS:
        there, place = started(motion)
        own, y = walk.FAMILY.plain(walk.__name__)["corrected"], place.y.copy()
        own(there.along, y, place.tangent)
        assert own(there.along, y, place.tangent) == (True, 0.0)


def test_compiled_and_plain_steps_have_the_same_bits() -> None:
    for motion in MOTIONS[::3]:
        there, place = started(motion)
        results = []
        for make in (walk.FAMILY.plain, walk.FAMILY.compiled):
            own = make(walk.__name__)
            converged, fall, y = own["stepped"](there.along, place.y, place.tangent, 0.01)
            assert converged
            results.append([fall, *y])
        assert results[0] == results[1]


def test_an_interval_has_exact_ends() -> None:
    interval = Interval(0.1, 0.7)
    assert [interval.value(q) for q in (-1.0, 1.0)] == [0.1, 0.7]
    assert interval.q(0.4) == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize("off", [-2e-16, 0.0, 2e-16, 5e-11])
def test_halves_about_an_end_keep_it_and_are_few(off: float) -> None:
    """Else an orbit at an end of the range would never be at an end of its piece."""
    at_low = list(islice(Interval(0.1, 0.7).halves_about(0.1 * (1 + off)), 50))
    at_high = list(islice(Interval(0.1, 0.7).halves_about(0.7 * (1 + off)), 50))
    assert len(at_low) < 40 > len(at_high)
    if abs(off) < 1e-15:
        assert {part.low for part in at_low} == {0.1}
        assert {part.high for part in at_high} == {0.7}


def test_halves_near_an_end_keep_it_until_the_other_is_as_near() -> None:
    """Else a branch would only ever go a part of the way to an end."""
    parts = list(islice(Interval(0.1, 0.7).halves_about(0.11), 7))
    assert [part.low for part in parts[:5]] == [0.1] * 5
    assert parts[6].low > 0.1


def test_the_course_of_a_declared_motion_has_its_name() -> None:
    for motion in MOTIONS:
        case = motion()
        course = course_of(case)
        assert course.motion == motion.motion
        assert course.case(case) is case


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("frequenzy", 1.0, 2.0), "parameter: got 'frequenzy', expected one of mass"),
        (("frequenzy", 1.0, 2.0), "; did you mean frequency?"),
        (("frequency", 1.0, 1.0), "range: got 1.0 to 1.0, expected two different values"),
        (("frequency", 1.3, np.nextafter(1.3, 2)), "expected two different values, not by r"),
        (("frequency", 0.0, 1.0), "frequency: got 0.0"),
        (("frequency", "a", 1.0), "range: got 'a', expected a finite number"),
        (("frequency", 1.0, np.inf), "range: got inf"),
    ],
)
def test_what_cannot_be_followed(arguments, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        ns.branch(SPRING, *arguments)
    with pytest.raises(TypeError):
        ns.branch("clearance", "frequency", 1.0, 2.0)


def test_a_branch_is_looked_for_at_the_very_ends_of_its_range(monkeypatch) -> None:
    """Of these ends ``low + (high - low)`` is beyond `high`: an orbit there is not in it."""
    low, high = 0.663512314592264, 1.7693661722460374
    assert low + (high - low) > high
    tried = []

    def none(case: ns.Case) -> ns.ExactOrbit:
        tried.append(case.values["frequency"])
        raise NoOrbit("none", False, ())

    monkeypatch.setattr(branches, "exact_orbit", none)
    with pytest.raises(NoOrbit):
        ns.branch(ns.scene("impact")(frequency=5.0), "frequency", low, high)
    assert tried[:2] == [low, high]
    assert len(tried) == 5
    assert min(tried) == low
    assert max(tried) == high


def test_an_orbit_of_singular_equations_is_not_said_to_be_no_isolated_one() -> None:
    """Of a very soft spring the multipliers are 0.978 and 0.389, and 7 digits are rounding."""
    with pytest.raises(NoOrbit, match=r"frequency = 1.3: its equations are singular, to round"):
        ns.branch(ns.scene("clearance")(stiffness=1e-9), "frequency", 1.2, 1.4)


@pytest.mark.parametrize("end", [1.9, 1.8])
def test_a_branch_that_begins_at_an_end_has_it_once_and_exactly(end) -> None:
    case = ns.scene("impact")(frequency=1.8)
    other = 1.9 if end == 1.8 else 1.8
    values = ns.branch(case, "frequency", end, other, start=ns.exact(case))["value"]
    assert (values.min(), values.max()) == (1.8, 1.9)
    assert (np.diff(values) > 0).all()


def test_no_orbit_to_start_from_says_what_was_tried() -> None:
    with pytest.raises(NoOrbit) as caught:
        ns.branch(ns.scene("dry-friction")(force=0.1), "damping", 0.05, 0.9)
    assert "no orbit was found from which a branch could be followed" in str(caught.value)
    tried = caught.value.reasons
    assert [text.partition(":")[0] for text in tried[:2]] == [
        "at damping = 0.1",
        "at damping = 0.05",
    ]


@pytest.mark.parametrize(
    ("name", "values", "ends"),
    [
        ("clearance", {"gap": 20.0}, (0.3, 3.0)),
        ("impact", {"gap": 50.0, "damping": 0.05}, (0.4, 0.9)),
        ("beam-clearance", {"gap": 1.0}, (20.0, 80.0)),
    ],
)
def test_without_an_orbit_a_branch_begins_at_a_motion_without_switches(
    name, values, ends
) -> None:
    case = ns.scene(name)(**values)
    (found,) = ns.branches(case, "frequency", *ends)
    assert {row.value for row in ns.branch(case, "frequency", *ends)} >= set(ends)
    assert found.why_it_ended == ("the end of the range",) * 2
    for row in found.rows[:: len(found) // 5]:
        (motion,) = motions_without_switches(case.with_value("frequency", row.value))
        expected = motion.least, motion.largest
        assert row.motion == f"only {motion.phase}"
        assert row.stable is motion.stable
        assert row.extremes["displacement"] == pytest.approx(expected, rel=1e-11)


def test_a_motion_without_switches_may_be_neutral_at_the_start() -> None:
    """A mode of twice the frequency leaves the periodic state open, but not the response."""
    beam = ns.scene("beam-clearance")(gap=1.0, modes=2, ratio=0.0)
    fast = float(np.sqrt(beam.cell.body.squares[1])) / beam.units.time
    found = ns.branch(beam.with_value("frequency", fast / 2), "frequency", 290, 300)
    assert {row.motion for row in found} == {"only separated"}


def test_motions_that_are_not_isolated_are_not_followed() -> None:
    """In a play without a spring a mass that moves less may be anywhere."""
    play = ns.scene("backlash")(frequency=1.0)
    (found,) = ns.branches(play, "force", 0.48, 1.2)
    assert found["value"].min() == pytest.approx(np.sqrt(1.01), rel=1e-14)
    for follow in (ns.branch, ns.branches):
        with pytest.raises(NoOrbit, match=r"force = 0.8: its equations are singular"):
            follow(play, "force", 0.48, 0.9)
    motions = ns.chart(play, {"frequency": (0.9, 1.0, 2), "force": (0.48, 1.2, 2)}).motion
    assert motions == [[None] * 2, ["engaged,loose,mirrored"] * 2]


def test_where_no_value_has_an_orbit_all_branches_are_that_of_the_case(monkeypatch) -> None:
    """Its own value may have the only one."""
    monkeypatch.setattr(branches, "every_way", lambda *arguments: iter(()))
    (found,) = ns.branches(SPRING, "frequency", 0.9, 1.1)
    assert found == ns.branch(SPRING, "frequency", 0.9, 1.1)


def test_a_motion_without_switches_is_followed_to_where_it_touches() -> None:
    """Near resonance, between all values at which orbits are looked for."""
    spring = ns.scene("clearance")(force=0.05, damping=0.05, gap=0.8, contact_stiffness=0.3)
    found = ns.branch(spring, "frequency", 0.2, 2.07)
    touches = [
        math.sqrt(1 - 0.05**2 / 2 + sign * math.sqrt(0.05**4 / 4 - 0.05**2 + (0.05 / 0.8) ** 2))
        for sign in (-1, 1)
    ]
    ends = [q.parameter for q in found.events if q.kind == "grazing"]
    assert ends == pytest.approx(touches, rel=1e-12)
    assert {row.motion for row in found} == {None, "only separated"}
    with pytest.raises(NoOrbit):
        ns.branch(spring.with_cycles(2), "frequency", 0.2, 0.5)


def test_an_orbit_that_is_outside_of_the_range_is_refused() -> None:
    with pytest.raises(ValueError, match="start: got one at frequency = 1, expected an orbit"):
        ns.branch(SPRING, "frequency", 1.1, 1.2, start=ns.exact(SPRING))


@pytest.mark.parametrize(
    ("case", "message"),
    [
        (ns.scene("impact")(), "an orbit of another scene, clearance, expected one of impact"),
        (SPRING.with_value("gap", 0.9), "one with gap = 1.0, and the case has 0.9; expected"),
    ],
)
def test_an_orbit_of_another_case_is_refused(case: Case, message: str) -> None:
    with pytest.raises(ValueError, match=f"start: got {message}"):
        ns.branch(case, "frequency", 0.9, 1.2, start=ns.exact(SPRING))


def test_an_orbit_may_differ_in_what_varies_and_in_its_order_of_phases() -> None:
    case = SPRING.with_value("frequency", 1.1)
    start = ns.solve(case, phases="contact,separated", method="ck-tau", order=8)
    assert len(ns.branch(SPRING, "frequency", 1.09, 1.11, start=start)) > 1


def test_words_and_documents(found: ns.Branch) -> None:
    assert repr(found) == (
        f"<branch of clearance along frequency = 0.8 to 1.3: {len(found)} orbits, "
        "2 grazing, 2 fold>"
    )
    assert str(found).splitlines()[-1] == (
        "from frequency = 0.8 (the end of the range) to 1.3 (the end of the range)"
    )
    document = found.as_dict()
    assert document["vary"] == "frequency"
    assert document["why_it_ended"] == dict.fromkeys(("start", "end"), "the end of the range")
    keys = {"strobe", "parameter", "motion", "period", "forcing_phase", "durations", "extremes"}
    assert {*document["points"][0]} == keys | {"multipliers", "stable"}
    assert {*document["events"][0]} == {"kind", "parameter", "motion", "phase", "estimate"}


@pytest.fixture(scope="module")
def beside() -> ns.Branch:
    return ns.branch(SPRING, "frequency", 0.8, 1.0, method="c2-tau", order=8)


def test_an_expansion_is_solved_beside_each_orbit(beside: ns.Branch) -> None:
    assert (beside.method, beside.order) == ("ck-tau", 8)
    rows = [row for row in beside if row.motion is None and row.multipliers]
    assert all(row.beside for row in rows)
    assert {row.beside for row in beside if row.motion == "only separated"} == {None}
    for row in rows[:: len(rows) // 3]:
        orbit = ns.solve(SPRING.with_value("frequency", row.value), "ck-tau", 8)
        assert row.beside.durations == pytest.approx(orbit.durations, rel=1e-12)
        assert row.beside.errors.times == pytest.approx(orbit.errors.times, rel=1e-3)
        off = np.subtract(row.beside.durations, row.durations)
        rounding = 1e-12 * row.period  # beside a grazing
        assert np.abs(off).max() <= row.beside.errors.times * row.period + rounding


def test_the_command_solves_an_expansion_beside(run, tmp_path: Path) -> None:
    path, vary = tmp_path / "branch.csv", ("--vary", "frequency=0.9:1")
    status, out, _ = run("branch", *FLAGS, *vary, "--order", 8, "--json", "-o", path)
    document = json.loads(out)
    assert (status, document["method"], document["order"]) == (0, "ck-tau", 8)
    errors = [point["beside"]["errors"]["times"] for point in document["points"]]
    assert 0 < max(errors) < 1e-4
    with path.open(newline="") as file:
        assert [float(row["beside_error_times"]) for row in csv.DictReader(file)] == errors


@pytest.mark.parametrize(
    ("how", "words"),
    [
        ({"method": "c9"}, "c9"),
        ({"order": 0}, "order: got 0, expected a whole number from"),
        ({"functions": 2}, "functions: got 2, expected beside a method"),
    ],
)
def test_expansions_that_cannot_be_beside(how, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        ns.branch(SPRING, "frequency", 0.8, 1.0, **how)


@pytest.mark.parametrize("name", ["found", "beside"])  # alone, and with an expansion
@pytest.mark.parametrize("suffix", [".json", ".nc"])
def test_a_branch_is_saved_and_loaded(request, tmp_path: Path, name: str, suffix: str) -> None:
    pytest.importorskip("xarray")
    branch, path = request.getfixturevalue(name), tmp_path / f"branch{suffix}"
    ns.save(branch, path)
    assert ns.load(path) == branch


def test_the_command_writes_what_python_has(found: ns.Branch, run, tmp_path: Path) -> None:
    target, flags = tmp_path / "response.csv", (*FLAGS, "--vary", "frequency=0.8:1.3")
    status, out, _ = run("branch", *flags, "--json", "-o", target)
    document = json.loads(out)
    assert (status, document["scene"]) == (0, "clearance")
    assert [point["parameter"] for point in document["points"]] == found["value"].tolist()
    with target.open(newline="") as file:
        lines = list(csv.DictReader(file))
    assert [float(line["frequency"]) for line in lines] == found["value"].tolist()
    _, out, _ = run("branch", *flags)
    shown = [line.split()[:2] for line in out.splitlines() if line.startswith(("fold", "graz"))]
    assert [(kind, float(value)) for kind, value in shown] == [
        (event.kind, pytest.approx(event.parameter, rel=1e-14)) for event in found.events
    ]
    assert out.splitlines()[-1].startswith("Omega from 0.8 (the end of the range) to 1.3")


def test_a_branch_from_an_orbit_in_a_file(run, tmp_path: Path) -> None:
    path = tmp_path / "orbit.json"
    assert run("solve", *FLAGS, "--method", "ck-tau", "-o", path)[0] == 0
    vary = ("--vary", "frequency=0.8:1.3", "--from-orbit", path)
    status, out, _ = run("branch", "clearance", *vary, "--json")
    assert status == 0
    kinds = [event["kind"] for event in json.loads(out)["events"]]
    assert kinds == ["grazing", "fold", "fold", "grazing"]
    assert run("solve", *FLAGS, "-o", path)[0] == 0  # by every method
    status, out, _ = run("branch", "clearance", *vary, "--json")
    assert status == 0
    assert [event["kind"] for event in json.loads(out)["events"]] == kinds
    status, _, err = run("branch", *FLAGS, *vary)
    assert status == 2
    assert "given beside --from-orbit" in err
    _, _, err = run("branch", "clearance", *vary[:1], "frequency=2:3", *vary[2:])
    assert err.startswith("nonsmooth: --from-orbit: got one at frequency = ")
    others = (SPRING.with_value("frequency", value) for value in (1.0, 1.1))
    ns.save([ns.solve(other, method="ck-tau", order=10) for other in others], path)
    assert "holds 2 different orbits, expected one" in run("branch", "clearance", *vary)[2]


def test_all_branches_have_those_that_coexist(run, tmp_path: Path) -> None:
    target = tmp_path / "all.svg"
    flags = ("--vary", "frequency=0.9:1.3", "--damping", 0, "--restitution", 0.8, "--gap", 0.5)
    status, out, _ = run("branch", "impact", *flags, "--all", "--json", "-o", target)
    documents = json.loads(out)["branches"]
    assert status == 0
    assert target.exists()
    assert all(document["points"] for document in documents)
    starts = [document["points"][0]["parameter"] for document in documents]
    assert starts[0] == 0.9


def test_ctrl_c_keeps_what_was_found(found: ns.Branch, run, monkeypatch, tmp_path) -> None:
    calls = iter(range(2))
    original = piece.Piece.walk

    def walked(*arguments):
        if next(calls, None) is None:
            signal.raise_signal(signal.SIGINT)
        return original(*arguments)

    monkeypatch.setattr(piece.Piece, "walk", walked)
    path = tmp_path / "part.json"
    status, _, err = run("branch", *FLAGS, "--vary", "frequency=0.8:1.3", "-o", path)
    assert status == 130
    part = ns.load(path)
    assert 0 < len(part) < len(found)
    assert f"interrupted: {len(part)} orbits found" in err


def test_ctrl_c_keeps_the_orbits_that_were_found(monkeypatch) -> None:
    def stopped(*given, **more):
        raise KeyboardInterrupt

    monkeypatch.setattr(branch, "cut_where_violated", stopped)
    with pytest.raises(Interrupted) as caught:
        ns.branch(SPRING, "frequency", 0.8, 1.3)
    (found,) = caught.value.done
    assert len(found) > 3
    assert found.why_it_ended[1] == "it was followed no further"


def test_ctrl_c_keeps_the_branches_that_were_followed(monkeypatch) -> None:
    original, calls = branches._result, iter(range(1))

    def result(*arguments):
        if next(calls, None) is None:
            raise KeyboardInterrupt
        return original(*arguments)

    monkeypatch.setattr(branches, "_result", result)
    stop = ns.scene("impact")(damping=0, restitution=0.8, gap=0.5, frequency=1.05)
    with pytest.raises(Interrupted) as caught:
        ns.branches(stop, "frequency", 1.0, 1.12)
    (done,) = caught.value.done
    assert [event.kind for event in done.events] == ["flip", "flip"]


def test_the_picture_tells_stable_from_unstable_without_colour(found: ns.Branch) -> None:
    upper, lower = branch_figure([found]).axes
    styles = {line.get_label(): line.get_linestyle() for line in upper.lines}
    assert (styles["stable"], styles["unstable"]) == ("-", "--")
    marks = {line.get_label(): line for line in upper.lines if len(line.get_xdata()) == 1}
    assert {"fold", "grazing"} <= marks.keys()
    drawn = [x for line in upper.lines if len(line.get_xdata()) > 1 for x in line.get_xdata()]
    assert {*drawn} == {*found["value"]}
    assert r"frequency $\Omega$ [rad/s]" in lower.get_xlabel()
    with pytest.raises(ValueError, match="quantity: got 'colour'"):
        found.plot(quantity="colour")


def test_orbits_at_a_value_are_those_of_the_branch() -> None:
    value = 1.2
    orbits = [
        orbit
        for orbit in every_way._orbits(SPRING.with_value("frequency", value))
        if orbit.case.scene.motion is None
    ]
    family = ns.family(SPRING, "frequency", [0.9, value, 1.3], order=20)
    rows = [row for row in family if row.value == value]
    expected = sorted(orbit.extremes["displacement"][1] for orbit in orbits)
    assert sorted(row.extremes["displacement"][1] for row in rows) == pytest.approx(expected)
