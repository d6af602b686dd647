"""Branches of bodies: what happens on them, against closed forms by matrix exponentials."""

from collections import Counter
from functools import cache, partial

import numpy as np
import pytest
import sympy as sp
from bodies import test_random_chains as chains
from bodies.reference_bodies import case, chain, of
from exponentials import generator
from galerkin.solving import OF_TWO, differences
from made_scenes import in_a_row, parameters, scene_of
from scipy.linalg import expm
from scipy.optimize import brentq

import nonsmooth as ns
from nonsmooth.scene import Body, Event, Phase
from nonsmooth.solver import branches, chart
from nonsmooth.solver.bodies.exact import evaluated
from nonsmooth.solver.branch import every_way
from nonsmooth.solver.branch.bodies import course, equations
from nonsmooth.solver.branch.bodies.arrays import case_of
from nonsmooth.solver.branch.branch import BothWays, course_of, go, start_of
from nonsmooth.solver.branch.orders.change import doubled
from nonsmooth.solver.branch.rows import row_of
from nonsmooth.solver.charts import curves, lines
from nonsmooth.solver.charts.curves import REAL, TORUS, _followed
from nonsmooth.solver.charts.plane import Plane
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.in_order import motion_of
from nonsmooth.solver.scenes.case import Case, index_of
from nonsmooth.solver.scenes.loaded import LoadedScene
from nonsmooth.solver.simulation import settle
from nonsmooth.solver.stability.stability import stability

#: Most of the range of a parameter in a step.
PART = 1 / 8

#: Bodies of the reference file, and ranges of the frequency.
RANGES = {
    "impact-2-neimark-sacker": (0.89, 0.95),
    "impact-2": (1.46, 1.56),
    "clearance-2": (1.75, 1.85),
    "absorber-stick": (0.71, 0.76),
}


@pytest.fixture(autouse=True)
def few_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    """Follow branches by longer steps: events are located to rounding all the same."""
    for module in (branches, every_way):
        monkeypatch.setattr(module, "go", partial(go, part=PART))


@cache
def branch(name: str) -> ns.Branch:
    return ns.branch(case(name), "frequency", *RANGES[name])


class Impacts:
    """Masses of which one impacts once a period, by the exponential of their equations."""

    def __init__(self, links: np.ndarray, damping: float, gap: float, restitution: float):
        n = len(links)
        self.M, self.K, self.C = np.eye(n), links, damping * links
        self.f, self.w = np.eye(n)[0], np.eye(n)[-1]
        self.gap, self.restitution = gap, restitution

    @classmethod
    def of(cls, name: str) -> "Impacts":
        """Return a chain of the reference file; unit masses, springs and force."""
        p = of(name).parameters
        return cls(chain(p)["K"], p["ck"], p["g"], p.get("r", 0.0))

    def flow(self, omega: float) -> np.ndarray:
        """Return the map over a period of (q, q', cos, sin)."""
        self.A = generator(self.M, self.K, self.C, self.f, omega)[:-1, :-1]
        return expm(self.A * 2 * np.pi / omega)

    def jump(self) -> np.ndarray:
        n = len(self.M)
        inverse = np.linalg.inv(self.M)
        found = np.eye(2 * n)
        away = (1 + self.restitution) / (self.w @ inverse @ self.w)
        found[n:, n:] -= away * np.outer(inverse @ self.w, self.w)
        return found

    def amplitude(self, omega: float) -> tuple[np.ndarray, float]:
        """Return the contact's place at the impact by cos and sin, and how large it can be."""
        n, flow, R = len(self.M), self.flow(omega), self.jump()
        start = np.linalg.solve(np.eye(2 * n) - R @ flow[: 2 * n, : 2 * n],
                                R @ flow[: 2 * n, 2 * n :])  # fmt: skip
        return start, float(np.linalg.norm(self.w @ start[:n]))

    def multipliers(self, omega: float, angle: float) -> np.ndarray:
        """Return the multipliers of the orbit near an angle of the forcing at the impact."""
        n = len(self.M)
        start, size = self.amplitude(omega)
        a, b = self.w @ start[:n]
        middle, half = np.arctan2(b, a), np.arccos(self.gap / size)
        turns = np.array([middle - half, middle + half])
        off = np.angle(np.exp(1j * (turns - angle)))
        phi = turns[int(np.argmin(np.abs(off)))]
        wave, R = np.array([np.cos(phi), np.sin(phi)]), self.jump()
        after = start @ wave
        before = np.linalg.solve(R, after)
        rates = [(self.A @ np.append(q, wave))[: 2 * n] for q in (before, after)]
        normal = np.append(self.w, np.zeros(n))
        S = R + np.outer(rates[1] - R @ rates[0], normal) / (normal @ rates[0])
        return np.linalg.eigvals(S @ self.flow(omega)[: 2 * n, : 2 * n])


@pytest.mark.parametrize(
    ("name", "kind"), [("impact-2-neimark-sacker", "torus"), ("impact-2", "flip")]
)
def test_where_multipliers_leave_the_unit_circle(name: str, kind: str) -> None:
    found, own = branch(name), Impacts.of(name)
    (event,) = [q for q in found.events if q.kind == kind]
    rows = [row for row in found if row.motion is None]
    near = min(rows, key=lambda row: abs(row.value - event.parameter))

    def beyond(omega: float) -> float:
        multipliers = own.multipliers(omega, near.forcing_phase)
        if kind == "flip":
            return float(np.prod(multipliers + 1).real)
        return float(np.abs(multipliers[np.abs(multipliers.imag) > 0.1]).max() - 1)

    expected = brentq(beyond, event.parameter - 0.01, event.parameter + 0.01, xtol=1e-15)
    assert event.parameter == pytest.approx(expected, abs=1e-13)
    stable = [row.stable for row in rows if abs(row.value - event.parameter) > 1e-9]
    assert True in stable
    assert False in stable


#: Branches of chains, and how often something happens to their orbits.
UNSTABLE = {
    # close to each grazing, where a multiplier comes from infinity; and passes another
    "strong damping": ({"damping": 5.0}, "gap", (0.15, 0.2), {"flip": 2}),
    # of two multipliers, both real, the product is 1: nothing bifurcates there
    "real pairs": ({"damping": 1.0}, "stiffness", (1.3, 3.75), {"flip": 1, "fold": 1}),
    # the complex pair that crosses the circle becomes real within a step
    "a pair that becomes real": (
        {"mass": 0.893, "damping": 0.1383, "stiffness": 1.3825}, "frequency", (0.5, 0.52),
        {"torus": 1, "fold": 1},
    ),
    # another multiplier crosses it in the same step
    "a flip before a torus": (
        {"mass": 1.193, "damping": 0.06, "gap": 0.202, "restitution": 0.68}, "frequency",
        (0.543, 0.6), {"flip": 1, "torus": 1},
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", UNSTABLE)
def test_what_is_unstable_changes_only_where_something_happens(name: str) -> None:
    values, vary, ends, expected = UNSTABLE[name]
    start = exact_orbit(ns.scene("chain-impact")(**values).with_value(vary, ends[0]))
    found = BothWays(index_of(start.case, vary))
    go(found, start_of(start, found.index, ends), PART)
    events = {id(event.place): event for event in found.events()}
    kinds = Counter(event.kind for event in events.values() if not event.changes)
    assert kinds == expected
    assert max(event.estimate for event in events.values()) < 1e-12
    before, crossed = None, 0
    for piece, place in found.points():
        event = events.get(id(place))
        if event is None:
            multipliers = row_of(piece, place).multipliers
            assert multipliers is not None
            outside = int((np.abs(multipliers) > 1).sum())
            if before is not None:
                assert abs(outside - before) in range(crossed, -1, -2), piece.value(place.y)
            before, crossed = outside, 0
        elif event.changes:
            before = None
        else:
            crossed += 2 if event.kind == "torus" else 1


def test_a_torus_without_loss_is_where_pairs_leave_the_circle() -> None:
    """All are on it at the one side, beyond a pair is outside by the root of the way to it."""
    own = ns.scene("chain-impact")(damping=0, restitution=1)
    (event,) = ns.branch(own, "frequency", 0.4945, 0.4952).events
    assert event.kind == "torus"
    assert event.estimate < 1e-14
    sizes = []
    for off in (-4e-11, -1e-11, 1e-11):
        there = own.with_value("frequency", event.parameter + off)
        sizes.append(np.abs(stability(exact_orbit(there)).multipliers).max() - 1)
    assert sizes[0] / sizes[1] == pytest.approx(2, rel=0.1)
    assert sizes[2] < 1e-10


#: Imaginary part below which a pair of multipliers is nearly one: errors grow like 1 over it.
NEAR = 0.01


def test_a_torus_begins_where_its_multipliers_are_one(monkeypatch) -> None:
    """Next to a fold, and in the same step: two multipliers come out and one goes back."""
    own = case("impact-2-neimark-sacker").with_value("restitution", 0.65)
    start = exact_orbit(own.with_value("frequency", 0.9))
    found = BothWays(index_of(own, "frequency"))
    go(found, start_of(start, found.index, (0.87, 0.9)))
    (fold,) = [event for event in found.events() if event.kind == "fold"]
    (torus,) = [event for event in found.events() if event.kind == "torus"]
    assert 0 < fold.value - torus.value < 2e-6
    piece, z = torus.piece, torus.place.y[:-1] * torus.piece.sizes[:-1]
    indices, ends = (found.index, index_of(own, "restitution")), ((0.88, 0.8825), (0.64, 0.69))
    plane = Plane.over(piece.course, piece.course.case(piece.case), indices, ends, z)
    first = plane.inside(np.array([[*z, torus.value, 0.65]]))[0]
    monkeypatch.setattr(curves, "MOST_SEEN", 0.15)
    (curve,) = _followed("torus", plane, TORUS, first, 1)
    assert curve.why == ("the end of the range", REAL)
    pairs = []
    for y in curve.points[::2]:
        multipliers = stability(plane.orbit(y)).multipliers
        pairs.append(max(multipliers, key=lambda value: (abs(value), value.imag)))
    pairs = [value for value in pairs if value.imag > NEAR]
    assert len(pairs) > 6
    assert np.abs(pairs) == pytest.approx(np.ones(len(pairs)), abs=1e-9)
    last = stability(plane.orbit(curve.points[-1])).multipliers
    assert np.min(np.abs(np.array(last) - 1)) < 1e-3


def test_a_fold_of_impacts_is_where_the_closed_form_just_reaches_the_stop() -> None:
    found = ns.branch(ns.scene("chain-impact")(frequency=0.5), "gap", 0.5, 2.0)
    (fold,) = [q for q in found.events if q.kind == "fold"]
    own = Impacts(chain({"n": 5, "ck": 0.05})["K"], 0.05, gap=0.5, restitution=0.7)
    assert fold.parameter == pytest.approx(own.amplitude(0.5)[1], rel=1e-13)


def test_contact_ends_in_the_linear_response_and_begins_there() -> None:
    """Where the dynamic compliance of the contact, times the force, is the gap."""
    found = branch("clearance-2")
    (end,) = [q for q in found.events if q.kind == "grazing"]
    own = Impacts.of("clearance-2")

    def beyond(omega: float) -> float:
        rows = own.K - omega**2 * own.M + 1j * omega * own.C
        return float(abs(own.w @ np.linalg.solve(rows, own.f)) - own.gap)

    expected = brentq(beyond, end.parameter - 0.01, end.parameter + 0.01, xtol=1e-15)
    assert end.parameter == pytest.approx(expected, abs=1e-13)
    assert found.rows[-1].motion == "only open_0"
    assert all(len(row.durations) == 1 for row in found if row.motion == "only open_0")


def test_sticking_is_one_event_from_both_sides() -> None:
    up = branch("absorber-stick")
    (event,) = [q for q in up.events if q.kind == "sticking"]
    slipping = [row for row in up if row.motion == "slip_0,mirrored"]
    assert len(slipping) > 5
    without = motion_of(case("absorber-stick").scene, "slip_0,mirrored")
    start = exact_orbit(
        Case(without, {"frequency": slipping[3].value}),
        slipping[3].durations[:1],
        slipping[3].forcing_phase,
    )
    down = ns.branch(start.case, "frequency", 0.71, 0.76, start=start)
    (other,) = [q for q in down.events if q.kind == "sticking"]
    assert other.parameter == pytest.approx(event.parameter, abs=1e-12)


def test_ever_more_impacts_end_a_branch(monkeypatch) -> None:
    monkeypatch.setattr(course, "MOST", 2)
    chain_impact = ns.scene("chain-impact")(
        mass=1.6279, damping=0.0417, gap=0.72378, restitution=0.62776, force=0.93977,
        frequency=0.44025,
    )  # fmt: skip
    found = ns.branch(chain_impact, "stiffness", 2.0, 2.13)
    assert found.why_it_ended[1] == "beyond, an orbit has more than 2 phases"
    assert len(found.rows[-1].durations) == 2


def test_an_orbit_that_loses_an_impact_keeps_its_cycles() -> None:
    """Of twice the period, with two impacts and then with one: not that of one period."""
    bounds, start = (1.66, 1.709), exact_orbit(ns.scene("chain-impact")(frequency=1.66))
    single = BothWays(index_of(start.case, "frequency"))
    go(single, start_of(start, single.index, bounds), PART)
    (flip,) = [event for event in single.events() if event.kind == "flip"]
    begin = doubled(flip)
    assert begin is not None
    double = BothWays(single.index, begin[0].course)
    go(double, begin, PART)
    piece, place = double.forth[-1].points[-1]
    assert (len(piece.course.order.steps), piece.course.cycles) == (1, 2)
    orbit = piece.orbit(place.y)
    assert orbit is not None
    assert orbit.admissible
    assert orbit.period == pytest.approx(4 * np.pi / piece.value(place.y), rel=1e-12)


def test_orbits_of_a_branch_are_those_that_the_solver_finds() -> None:
    found = branch("clearance-2")
    own = case("clearance-2")
    for row in found.rows[:: len(found.rows) // 6]:
        if row.motion is not None or row.multipliers is None:
            continue
        case_there = own.with_value("frequency", row.value)
        exact = exact_orbit(case_there, row.durations, row.forcing_phase)
        assert exact.admissible
        assert exact.durations == pytest.approx(row.durations, abs=1e-12 * row.period)
        assert stability(exact).stable == row.stable


@pytest.mark.parametrize("name", ["clearance-2", "absorber-stick"])
def test_equations_have_the_exact_orbit_as_solution_and_right_derivatives(name: str) -> None:
    exact = ns.exact(case(name))
    cell, times = exact.case.cell, exact.times
    z = np.append(evaluated(cell, times).starts[0], times)
    arrays, n = case_of(cell, []), len(z)

    def filled(z: np.ndarray, divided: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        R, J = np.empty(n), np.empty((n, n))
        equations.residual_and_jacobian(arrays, divided, z, R, J)
        return R, J

    def residual(divided: np.ndarray, z: np.ndarray) -> np.ndarray:
        return filled(z, divided)[0]

    for divided in np.eye(len(cell.phases) + 1, len(cell.phases)):  # each, and none
        R, J = filled(z, divided)
        if not divided.any():
            assert np.abs(R).max() < 1e-12
        rows = differences(partial(residual, divided), z, 1e-6, OF_TWO)
        np.testing.assert_allclose(J.T, rows, rtol=0, atol=1e-7)
    first = len(z) - len(times)
    for often, s in ((1, 0.0), (1, 1e-17), (2, 0.0), (2, -1e-9), (2, float(z[first]))):
        divided, there = often * np.eye(len(cell.phases))[0], z.copy()
        there[first] = s
        _, J = filled(there, divided)
        rows = differences(partial(residual, divided), there, 1e-5, OF_TWO)
        np.testing.assert_allclose(J.T, rows, rtol=1e-5, atol=1e-5)


def test_a_map_over_the_frequency_has_the_orbits_of_the_solver(monkeypatch) -> None:
    """Units change with the frequency, and matrices of numbers with the units."""
    beam = ns.scene("beam-clearance")(modes=2)
    monkeypatch.setattr(settle, "FEW", 5)
    monkeypatch.setattr(chart, "LINES", 2)
    monkeypatch.setattr(lines, "VALUES", 2)
    found = ns.chart(beam, {"frequency": (85.0, 100.0, 2), "contact_stiffness": (1e3, 2e3, 2)})
    for i, j in np.ndindex(2, 2):
        values = (found.values[0][j], found.values[1][i])
        here = dict(zip(found.parameters, map(float, values), strict=True))
        orbit = exact_orbit(ns.scene("beam-clearance")(modes=2, **here))
        assert found.motion[i][j] == ",".join(orbit.case.scene.phases)
        assert bool(found.stable[i, j]) == orbit.stable


def test_a_flip_without_any_loss_is_a_double_one_and_not_missed() -> None:
    """Behind it both multipliers are on the unit circle, near -1: what vanishes is small."""
    row = ns.scene("chain-impact")(damping=0.0, restitution=1.0)
    branch = ns.branch(row, "frequency", 0.5325, 0.533)
    assert [event.kind for event in branch.events] == ["flip"]
    first, last = (np.array(branch.rows[i].multipliers) for i in (0, -1))
    assert (first.real < -1.01).any()
    assert np.abs(last) == pytest.approx(1.0, abs=1e-6)


@pytest.mark.parametrize("damping", [1e-2, 3e-2])
def test_between_two_resonances_a_row_leaves_its_stop(damping) -> None:
    """From contact through the response without it, whose phase hardly changes, to contact."""

    def over(frequency: float) -> float:
        rows = chains.LINKS * (1 + 1j * frequency * damping) - frequency**2 * np.eye(4)
        return abs(np.linalg.inv(rows)[3, 0]) - 1.0

    row = chains.chain("elastic")
    values = {"mass": 1.0, "stiffness": 1.0, "force": 1.0, "stop": 0.3, "gap": 1.0}
    found = ns.branch(row(damping=damping, frequency=0.59, **values), "frequency", 0.59, 0.8)
    touches = [brentq(over, *ends, xtol=1e-15) for ends in ((0.5, 0.68), (0.68, 0.9))]
    grazing = [event.parameter for event in found.events if event.kind == "grazing"]
    assert grazing == pytest.approx(touches, rel=1e-12)
    assert max(row.value for row in found) == pytest.approx(0.8)


def test_a_dip_just_behind_an_impact_of_a_stiff_beam_is_an_event() -> None:
    """In 0.0001 s of 0.16, by waves of the fast modes: an impact more begins there."""
    beam = ns.scene("beam-impact")(modes=10, restitution=0.27)
    found = ns.branch(beam, "restitution", 0.2695, 0.2705)
    assert [event.kind for event in found.events] == ["flip", "grazing"]
    assert found.why_it_ended == ("the end of the range",) * 2
    orders = {row.motion: len(row.durations) for row in found}
    assert [orders[motion] for motion in sorted(orders)] == [3, 4]


@cache
def apart() -> LoadedScene:
    """Return two masses that nothing joins, with a stop each, in all orders of contacts."""
    omega, g, d, k = sp.symbols("Omega g d k", positive=True)
    numbers = {"M": np.eye(2), "K": np.diag([1.0, 1.1]), "C": 0.2 * np.eye(2)}
    body = Body(**numbers, forcing=[1.0, 1.0], at={"one": [1, 0], "other": [0, 1]})
    contacts = body.at.values()
    off = [contact.x - gap for contact, gap in zip(contacts, (d, g), strict=True)]

    def phase(one: int, other: int, changes: int) -> Phase:
        pressed = list(zip(contacts, off, (one, other), strict=True))
        laws = tuple(contact.force + k * way * on for contact, way, on in pressed)
        demands = {q.name: way if on else -way for q, way, on in pressed}
        return Phase(f"p{one}{other}{changes}", laws, ends=Event(off[changes]), demands=demands)

    own = parameters(
        fixed=(d, "m", 0.5), gap=(g, "m", 0.8), stop=(k, "N/m", 4.0),
        frequency=(omega, "rad/s", 1.3),
    )  # fmt: skip
    order = ("000", "101", "110", "011", "001", "010", "111", "100")
    return scene_of("apart", own, *(phase(*map(int, name)) for name in order), body=body)


def test_two_contacts_that_switch_at_once_do_so_in_the_other_order_beyond() -> None:
    """Each mass has the orbit that it has alone."""
    found = ns.branch(apart()(), "gap", 0.7, 1.2)

    def alone(stiffness: float, gap: float) -> np.ndarray:
        """Return the angles at which a contact begins and ends."""
        orbit = ns.exact(ns.scene("clearance")(stiffness=stiffness, gap=gap, frequency=1.3))
        return orbit.forcing_phase + np.array([0.0, 1.3 * orbit.durations[0]])

    def later(gap: float, i: int) -> float:
        return (alone(1.1, gap) - alone(1.0, 0.5))[i]

    at_once = [brentq(later, 0.7, 1.2, (i,)) for i in (0, 1)]
    assert [event.kind for event in found.events] == ["vanishing"] * 2
    assert [event.parameter for event in found.events] == pytest.approx(at_once, rel=1e-11)
    assert found.why_it_ended == ("the end of the range",) * 2
    for row in found:
        ends = np.exp(1j * (row.forcing_phase + 1.3 * np.cumsum(row.durations)))
        for angle in (*alone(1.0, 0.5), *alone(1.1, row.value)):
            assert np.abs(ends - np.exp(1j * angle)).min() <= 1e-9


@cache
def twins(says: bool = False) -> LoadedScene:
    """Return two equal masses before equal stops, which they meet together.

    Each event `says` which phase follows it, or demands decide.
    """
    omega, g, k, F = sp.symbols("Omega g k F", positive=True)
    K = sp.Matrix([[2, -1], [-1, 2]])
    at = {"one": [1, 0], "other": [0, 1]}
    body = Body(M=sp.eye(2), K=K, C=K / 20, forcing=[F, F], at=at)
    one, other = body.at.values()
    names = {(0, 0): "off", (1, 0): "first", (0, 1): "second", (1, 1): "on"}

    def phase(*on: int) -> Phase:
        to = names[1 - on[0], on[1]], names[on[0], 1 - on[1]]
        first, second = (
            Event(q.x - g, to=then) if says else Event(q.x - g)
            for q, then in zip((one, other), to, strict=True)
        )
        pressed = list(zip((one, other), on, strict=True))
        laws = tuple(q.force + k * (q.x - g) * there for q, there in pressed)
        demands = {q.name: (q.x - g) * (2 * there - 1) for q, there in pressed}
        return Phase(names[on], laws, first | second, demands)

    own = parameters(
        stop=(k, "N/m", 5.0), gap=(g, "m", 0.3), force=(F, "N", 0.5),
        frequency=(omega, "rad/s", 0.7),
    )  # fmt: skip
    phases = (phase(*on) for on in names)
    return scene_of(f"twins{'-that-say' * says}", own, *phases, body=body)


def test_contacts_that_always_switch_together_are_as_one() -> None:
    """The branch is that of one of the masses, whose spring to the other does not matter."""
    found = ns.branch(twins()(), "frequency", 0.56, 0.84)
    alone = ns.scene("clearance")(
        mass=1, damping=0.05, stiffness=1, contact_stiffness=5, gap=0.3, force=0.5
    )
    expected = ns.branch(alone, "frequency", 0.56, 0.84)
    assert found.why_it_ended == expected.why_it_ended == ("the end of the range",) * 2
    assert [q.kind for q in found.events] == [q.kind for q in expected.events]
    values = [event.parameter for event in expected.events]
    assert [event.parameter for event in found.events] == pytest.approx(values, rel=1e-11)


def test_events_that_say_what_follows_may_be_met_together() -> None:
    said, not_said = (ns.exact(twins(says)()) for says in (True, False))
    assert [phase.name for phase in said.phases] == ["off", "on"]
    assert said.durations == pytest.approx(not_said.durations, rel=1e-13)


def test_a_map_of_contacts_that_always_switch_together(monkeypatch) -> None:
    monkeypatch.setattr(chart, "LINES", 2)
    monkeypatch.setattr(lines, "VALUES", 2)
    axes = {"frequency": (0.69, 0.71, 2), "force": (0.49, 0.51, 2)}
    found = ns.chart(twins()(), axes)
    assert found.motion == [["off,on"] * 2] * 2
    assert found.stable.tolist() == [[1, 1], [1, 1]]
    assert not found.curves


def test_where_a_second_contact_ends_the_linear_response_is_beyond() -> None:
    """Whatever the first contact does there: that mass does not reach its stop."""
    case_of_two = apart()(fixed=5.0)
    found = ns.branch(case_of_two, "gap", 1.0, 2.0)
    reach = 1 / abs(1.1 - 1.3**2 + 0.26j)
    assert found.events[-1].kind == "grazing"
    assert found.events[-1].parameter == pytest.approx(reach, rel=1e-12)
    assert found.why_it_ended == ("the end of the range",) * 2
    assert found[-1].motion in ("only p000", "only p001")
    assert course_of(case_of_two).most == 2 * course.MOST


def test_a_mode_keeps_its_side_along_a_mass() -> None:
    """By itself the second mode of this row turns to the other side at 2.003 and 2.013 kg."""
    n, tip, gap, Omega = 4, *sp.symbols("m_t g Omega", positive=True)
    K, M = sp.Matrix(in_a_row([1.0] * n)), sp.diag(*[1] * (n - 1), tip)
    push, end = [1.0] + [0.0] * (n - 1), [0.0] * (n - 1) + [1.0]
    body = Body(M=M, K=K, C=K / 20, forcing=sp.Matrix(push), at={"end": end})
    at = body.at["end"]
    bounce = Event(at.x - gap, jump={at.v: -0.6 * at.v})
    own = parameters(tip=(tip, "kg", 2.2), gap=(gap, "m", 0.2), frequency=(Omega, "rad/s", 0.4))
    flight = Phase("flight", at.force, bounce, {"before the stop": gap - at.x})
    case_of_row = scene_of("row", own, flight, body=body)()
    found = ns.branch(case_of_row, "tip", 1.99, 2.06)
    assert found.why_it_ended == ("the end of the range",) * 2
    assert found.events == ()
    for row in (found.rows[0], found.rows[-1]):
        exact = exact_orbit(case_of_row.with_value("tip", row.value))
        assert row.durations == pytest.approx(exact.durations, rel=1e-9)
