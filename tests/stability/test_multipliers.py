"""Multipliers against proved references, closed forms, and what they must be exactly."""

import math
import os
from types import SimpleNamespace

import numpy as np
import one_mass
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from made_scenes import made
from scipy.integrate import solve_ivp

import nonsmooth as ns
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.in_order import cases_in_order
from nonsmooth.solver.iteration.linear import product
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.stability.in_words import in_words
from nonsmooth.solver.stability.monodromy import NoMultipliersError, monodromy
from nonsmooth.solver.stability.stability import of_monodromy, stability

IMPACT, CLEARANCE = registry.load("impact"), registry.load("clearance")
BACKLASH, FRICTION = registry.load("backlash"), registry.load("dry-friction")
UNIT = {"damping": 0, "gap": 0, "restitution": 0.8}


def rubbing(mu, **values):
    return FRICTION(mu_s=mu, mu_k=mu, damping=0, **values)


def pair(real, imaginary):
    return [complex(real, imaginary), complex(real, -imaginary)]


#: Case; rough durations of a cell, rough phase of the forcing; multipliers, each proved to
#: these digits with ball arithmetic by another program; stable or not.
PROVED = {
    "impact, unstable": (
        IMPACT(**UNIT, frequency=2.8), (2.2439,), 3.06,
        [-2.958095066993599516067997, -0.2163554535961723300505215], False,
    ),
    "impact, stable": (
        IMPACT(**UNIT, frequency=2.1), (2.992,), 2.53,
        pair(0.7602142860965303903929311, 0.2491470232909529271925145), True,
    ),
    "friction": (
        rubbing(0.2, frequency=0.7).of_motion("sliding"), (4.488,), 0.18,
        pair(-0.5830889919300008381584406, 0.2884512249739852819891529), True,
    ),
    "friction with stops": (
        rubbing(0.4, frequency=0.4).of_motion("two-stops"), (5.3769, 2.47714), 0.78,
        [0.3802275662581503612051452, 0.0], True,
    ),
    "bilinear": (
        CLEARANCE(contact_stiffness=3, damping=0.1, gap=0, frequency=0.8),
        (1.97135, 5.88263), 5.53,
        pair(-0.6721901320645979260514246, 0.06401995096042042332487247), True,
    ),
    "backlash": (
        BACKLASH(force=1, frequency=0.6), (4.10754, 1.12845), 5.267,
        pair(-0.5773129605589840809410903, 0.1327763260111977135562074), True,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", PROVED)
def test_proved_multipliers(name) -> None:
    case, durations, angle, expected, stable = PROVED[name]
    orbit = exact_orbit(case, durations, angle)
    assert orbit.multipliers.dtype == complex
    assert orbit.multipliers == pytest.approx(np.array(expected), rel=1e-12, abs=1e-15)
    assert orbit.stable is stable
    assert orbit.margin == pytest.approx(1 - abs(expected[0]), rel=1e-11)
    assert orbit.trivial_multiplier is None
    assert orbit.stability.rounding < 1e-9
    if expected[1] == 0.0:
        assert orbit.multipliers[1] == 0.0  # set, not computed


@given(omega=st.floats(1.3, 3.8), gap=st.floats(-0.3, 0.5), restitution=st.floats(0.2, 1.0))
@settings(max_examples=100 if "EXAMPLES" in os.environ else 20)
def test_the_closed_form_of_one_impact_a_period(omega, gap, restitution) -> None:
    case = IMPACT(damping=0, gap=gap, restitution=restitution, frequency=omega)
    try:
        (declared,) = cases_in_order(case, "flight")
        orbit = exact_orbit(declared)
    except NoOrbit:
        return
    T = 2 * math.pi / omega
    r, g, cot = restitution, 1 / (1 - omega**2), 1 / math.tan(math.pi / omega)
    v = -orbit.phases[0].velocity / r
    q = (1 + r) / 2 * cot
    cosine = (gap + q * v) / g
    trace = -2 * r * math.cos(T) + (1 + r) * (cosine - gap) * math.sin(T) / v
    size = max(1.0, abs(trace))
    assert complex(orbit.multipliers.sum()) == pytest.approx(trace, abs=1e-9 * size)
    assert complex(orbit.multipliers.prod()) == pytest.approx(r**2, abs=1e-9 * size)
    edge = 1 + r**2 - abs(trace)  # |tr M| < 1 + det M
    if r < 0.999 and abs(edge) > 1e-6:
        assert orbit.stable is bool(edge > 0)


def test_stick_forgets_the_velocity() -> None:
    for scene in ("stick-slip", "stick-slip-damped"):
        orbit = exact_orbit(registry.load(scene)())
        assert orbit.multipliers.tolist() == [0.0]
        assert orbit.trivial_multiplier == pytest.approx(1, abs=1e-13)
        assert orbit.stable is True
        assert orbit.margin == 1.0


def test_stick_between_other_phases_gives_an_exact_zero_too() -> None:
    # the cell begins during slip, where x passes 0
    scene = made(
        [(1, 0, 1, 0, 0), (1, 0, 0, 0, 0), (1, 0, 1, 0, 0)],
        [(0, 1, 0, -1), (1, 0, 0, -1), (1, 0, 0, 0)],
        held=(None, 1.0, None),
    )
    orbit = exact_orbit(scene(), (2.3, 2.1, 2.4))
    assert orbit.durations == pytest.approx([3 * math.pi / 4, 2, 3 * math.pi / 4])
    assert orbit.multipliers.tolist() == [0.0]
    assert orbit.trivial_multiplier == pytest.approx(1, abs=1e-13)
    assert np.abs(np.linalg.eigvals(monodromy(orbit)[0])).min() > 0  # if it were computed


@pytest.mark.parametrize("force", [200.0, 400.0, 900.0])
def test_the_paper_s_orbits_have_them_in_closed_form(force) -> None:
    belt = ns.StickSlip(
        mass=10, stiffness=1000, belt_speed=1, mu_s=0.5, mu_k=0.25, normal_force=force
    )
    exact, orbit = ns.exact(belt), ns.solve(belt, "c1", 12)
    assert exact.multipliers.tolist() == orbit.multipliers.tolist() == [0.0]
    assert exact.stable
    assert exact.trivial_multiplier == pytest.approx(1, abs=1e-13)
    generic = ns.solve(belt, "c1-tau", 5)
    s, own = float(generic.cell_durations[1]), stability(generic)
    expected = math.cos(s) - belt.alpha * math.sin(s)  # 1 but for the error of the times
    assert own.trivial_multiplier == pytest.approx(expected, abs=1e-7)
    assert 1e-9 < abs(own.trivial_multiplier - 1) < 1e-3
    assert own.stable is True
    assert generic.trivial_multiplier == pytest.approx(1, abs=1e-13)


def test_without_damping_a_clearance_is_on_the_unit_circle() -> None:
    orbit = exact_orbit(CLEARANCE(damping=0), (1.39, 3.45), 0.35)
    assert np.abs(orbit.multipliers) == pytest.approx(1, abs=1e-13)
    assert abs(orbit.multipliers[0].imag) > 0.1
    assert orbit.stable is None
    assert exact_orbit(CLEARANCE(damping=1e-6), (1.39, 3.45), 0.35).stable is True


@pytest.mark.parametrize(("method", "order", "off"), [("ck-tau", 8, 1e-6), ("hb", 40, 5e-2)])
def test_at_its_own_times_an_expansion_has_them_as_well_as_those(method, order, off) -> None:
    orbit = ns.solve(IMPACT(**UNIT, frequency=2.1), method, order)
    expected = np.array(PROVED["impact, stable"][3])
    assert stability(orbit).multipliers == pytest.approx(expected, abs=off)
    assert orbit.multipliers == pytest.approx(expected, rel=1e-12)
    assert orbit.stable is True


def test_the_multipliers_of_an_expansion_are_those_of_the_exact_orbit_next_to_it() -> None:
    """At its own times, a slow impact makes nearly ten times as much of a perturbation."""
    slow = IMPACT(damping=0.1052, restitution=0.86, frequency=2.272, gap=0.23612)
    orbit, exact = ns.solve(slow, "ck-tau", 4), ns.exact(slow)
    assert abs(exact.phases[0].velocity) < 0.02
    assert stability(orbit).multipliers[0].real == pytest.approx(-325.8, rel=1e-3)
    assert exact.multipliers[0].real == pytest.approx(-33.5925, rel=1e-5)
    assert orbit.multipliers == pytest.approx(exact.multipliers, rel=1e-9)
    assert in_words(orbit) == in_words(exact)
    first = orbit.as_dict()["multipliers"][0]
    assert complex(first["re"], first["im"]) == orbit.multipliers[0]
    assert orbit.facts["stability"] == in_words(exact)


def test_an_order_that_is_low_does_not_change_the_verdict() -> None:
    # the flip is at 2.6533..., and four harmonics have the times to some per cent
    case = IMPACT(**UNIT, frequency=2.64)
    orbit = ns.solve(case, "hb", 4)
    assert stability(orbit).stable is False
    assert orbit.stable is ns.exact(case).stable is True


def test_where_no_exact_orbit_is_found_it_has_none() -> None:
    """At its own times they are not those of an orbit."""
    orbit = ns.solve(IMPACT(), "hb", 5)
    orbit.__dict__["_exact_solution"] = None
    del orbit.__dict__["stability"]  # known since the orbit is
    with pytest.raises(NoMultipliersError, match="no exact orbit is found next to it"):
        _ = orbit.multipliers
    assert orbit.stable is None
    assert "stable" not in repr(orbit)
    assert orbit.as_dict()["stable"] is None


@pytest.mark.parametrize("order", [4, 5, 6, 7])
def test_a_crude_orbit_before_a_stiff_contact_has_those_of_the_exact_one(order) -> None:
    """From some of its times Newton's method leads to another solution, which is no orbit."""
    stiff = CLEARANCE(
        damping=0.006720994839077621, contact_stiffness=1656.049069912543,
        gap=-0.12908807242029585, frequency=2.151481196982099,
    )  # fmt: skip
    orbit = ns.solve(stiff, "hb", order)
    assert orbit.stable is ns.exact(stiff).stable is True
    assert orbit.errors.times == pytest.approx(orbit.estimate.times, rel=1e-3)


def some_orbits(count: int, seed: int):
    """Yield orbits of every scene by every method, at random parameters and orders."""
    rng = np.random.default_rng(seed)
    for _ in range(count):
        for scene in map(registry.load, one_mass.NAMES):
            values = {q.name: q.default * rng.uniform(0.7, 1.4) for q in scene.parameters}
            methods = registry.methods(scene)
            method = methods[rng.integers(len(methods))]
            try:
                yield ns.solve(scene(**values), method, int(rng.integers(4, 13)))
            except (ValueError, NoOrbit):  # of parameters that do not go together
                continue


@pytest.mark.parametrize("count", [1, pytest.param(12, marks=pytest.mark.long)])
def test_every_orbit_has_the_multipliers_of_the_exact_one_from_its_times(count: int) -> None:
    seen = set()
    for orbit in some_orbits(count, seed=count):
        exact = exact_orbit(
            orbit.case, orbit.durations[: len(orbit.cell_durations)], orbit.angle
        )
        assert orbit.multipliers == pytest.approx(exact.multipliers, rel=1e-9, abs=1e-12)
        assert orbit.stable is exact.stable
        seen.add((orbit.case.scene.name, orbit.method))
    assert len(seen) >= 4 * min(count, 6)


def test_what_an_event_that_is_touched_comes_to() -> None:
    # the speed of the impact vanishes at the grazing of the closed form, sqrt(3)
    case = IMPACT(damping=0, gap=0.5, restitution=0.8, frequency=math.sqrt(3) * (1 + 1e-7))
    orbit = exact_orbit(case, (2 * math.pi / float(case.values["frequency"]),), math.pi)
    assert abs(orbit.multipliers[0]) > 1e3  # it grows as 1 over the speed
    del orbit.__dict__["stability"]  # it is kept
    grazing = orbit.part

    def at_rest(p, u, derivative):
        return grazing(p, u, derivative) * (0.0 if derivative == 1 else 1.0)

    object.__setattr__(orbit, "part", at_rest)
    with pytest.raises(NoMultipliersError, match="flight is touched, not crossed"):
        monodromy(orbit)
    assert orbit.stable is None


@pytest.mark.parametrize("scene", one_mass.NAMES)
def test_the_determinant_is_that_of_its_formula(scene: str) -> None:
    """``prod det S exp(-sum c s/m)``: of the saltations by the rates on both sides."""
    orbit = exact_orbit(registry.load(scene)())
    cell, expected, ends = orbit.cell, 1.0, np.array([0.0, 1.0])
    if orbit.case.cell.memory:
        pytest.skip("its state is more than displacement and velocity")
    total = np.cumsum(orbit.cell_durations)
    for p, phase in enumerate(cell.phases):
        q = (p + 1) % len(cell.phases)
        sign, after = cell.sign if q == 0 else 1, cell.phases[q]
        turn = orbit.angle + cell.omega * total[p]
        x, v = (float(orbit.part(p, ends, j)[1]) for j in (0, 1))
        y, w = (sign * float(orbit.part(q, ends, j)[0]) for j in (0, 1))
        rate = np.array([v, acceleration(phase, x, v, np.cos(turn))])
        behind = acceleration(after, sign * y, sign * w, sign * np.cos(turn))
        law = np.diag([1.0, phase.rho])
        jump = np.array([w, sign * behind]) - law @ rate
        ex, ev, ec, _ = phase.event
        approach = ex * rate[0] + ev * rate[1] - ec * cell.omega * np.sin(turn)
        S = law + np.outer(jump, [ex, ev]) / approach
        flow = 0.0 if phase.held else np.exp(-phase.c / phase.m * orbit.cell_durations[p])
        expected *= flow * np.linalg.det(S)
    found, size = monodromy(orbit)
    assert np.linalg.det(found) == pytest.approx(expected, abs=1e-12 * size.max())


def acceleration(phase, x: float, v: float, cosine: float) -> float:
    """Return the acceleration in a phase; 0 where the velocity is held."""
    force = phase.f + phase.g * cosine - phase.c * v - phase.k * x
    return 0.0 if phase.held else force / phase.m


def element(state, t0: float, t1: float, case) -> np.ndarray:
    """Return x, x' and the force z of the elastic-plastic element at t1, by an integrator.

    Written from the scene's own words: z' = k x' but while it flows at the yield force.
    """
    m, c, k, limit, h, F, omega = case.values.values()
    flows = False

    def rate(t, y):
        x, v, z = y
        return [v, (F * np.cos(omega * t) - c * v - h * x - z) / m, 0.0 if flows else k * v]

    y, t = np.array(state, dtype=float), t0
    while t < t1:
        events = (lambda t, y: y[1],) if flows else (
            lambda t, y: limit - y[2], lambda t, y: limit + y[2]
        )  # fmt: skip
        for event in events:
            event.terminal, event.direction = True, 0 if flows else -1
        found = solve_ivp(
            rate, (t, t1), y, events=events, method="DOP853", rtol=1e-12, atol=1e-13
        )
        y, t = found.y[:, -1], found.t[-1]
        if found.status == 1:
            flows = not flows
            if not flows:  # a hair inside the limit, from which it unloads
                y[2] -= np.sign(y[2]) * 1e-13
    return y


@pytest.mark.parametrize("hardening", [0.2, 0.0])
def test_a_motion_that_remembers_is_followed_with_what_it_remembers(hardening: float) -> None:
    case = ns.scene("elastic-plastic")(hardening=hardening)
    orbit = ns.exact(case)
    start = orbit.phases[0].duration / 2
    x0 = orbit.displacement(0.0)
    t0 = start + orbit.forcing_phase / case.values["frequency"]
    x, v = orbit.displacement(start), orbit.velocity(start)
    z = case.values["yield_force"] + case.values["stiffness"] * (x - x0)  # before, it flowed
    state, step = np.array([x, v, z], dtype=float), 1e-4
    columns = []
    for i in range(3):
        ends = [
            element(state + sign * step * np.eye(3)[i], t0, t0 + orbit.period, case)
            for sign in (1, -1)
        ]
        columns.append((ends[0] - ends[1]) / (2 * step))
    expected = np.linalg.eigvals(np.array(columns).T)
    expected = expected[np.argsort(-np.abs(expected))]
    assert np.abs(element(state, t0, t0 + orbit.period, case) - state).max() < 1e-9
    assert np.abs(orbit.multipliers) == pytest.approx(np.abs(expected), abs=1e-6)
    assert orbit.multipliers[-1] == 0
    if hardening == 0:
        assert orbit.multipliers[0] == pytest.approx(1, abs=1e-12)
        assert orbit.stable is None
    assert orbit.multipliers.sum() == pytest.approx(expected.sum(), abs=1e-6)


def test_of_a_stop_too_stiff_for_float64_it_is_not_told_whether_it_is_stable() -> None:
    stiff = ns.exact(CLEARANCE(contact_stiffness=1e12)).stability
    assert stiff.stable
    assert stiff.margin == pytest.approx(1 - math.hypot(0.23522, 0.57011), abs=1e-4)
    assert ns.exact(CLEARANCE(contact_stiffness=1e18)).stable is None


def test_at_a_fold_it_is_not_told_whether_an_orbit_is_stable() -> None:
    """The multiplier is 1 but for the root of what rounding makes of the frequency."""
    fold = 1.2348990596842088
    at, before = (
        ns.exact(CLEARANCE(force=0.3, damping=0.1, gap=1.0, frequency=value))
        for value in (fold, fold - 1e-12)
    )
    assert abs(at.margin) < 5e-8
    assert at.stable is None
    assert before.stable == (before.margin > 0)
    assert abs(before.margin) > 1e-6


def test_words_name_each_pair_once_and_say_where_an_orbit_is_not_isolated() -> None:
    """Without damping a sliding mass has a continuum of orbits at half its frequency."""
    plastic = in_words(ns.exact(ns.scene("elastic-plastic")()))
    assert plastic == "multipliers -0.26174 +- 0.11629i of modulus 0.28641, 0: stable"
    orbit = ns.exact(rubbing(0.1, frequency=0.5).of_motion("sliding"))
    assert orbit.stable is None
    assert in_words(orbit).endswith("1: the orbit is not isolated to first order")
    assert "isolated" not in in_words(ns.exact(CLEARANCE(damping=0)))


@pytest.mark.parametrize(
    ("count", "words"),
    [(8, "0.01: stable"), (9, "0.01 and 1 smaller one: st"), (10, " and 2 smaller ones: st")],
)
def test_multipliers_that_are_not_shown_are_counted(count: int, words: str) -> None:
    values = np.full(count, 0.01 + 0j)
    assert words in in_words(SimpleNamespace(multipliers=values, stable=True))


def test_rounding_of_many_phases_is_not_the_product_of_their_sizes() -> None:
    random = np.random.default_rng(1)
    turns = np.linalg.qr(random.normal(size=(24, 8, 8)))[0]
    found, size = product(turns, np.abs(turns))
    assert abs(found - np.linalg.multi_dot(turns[::-1])).max() < 1e-14
    assert 24 < size.max() < 24 * 8  # of all sizes multiplied it would be 1e9


def test_multipliers_of_which_nothing_is_left_are_stable() -> None:
    """The squares of what rounding may be of 1e-270 are 0."""
    matrix = np.array([[0.0, 8.373540013977102e-273], [-8.373540013977103e-269, 0.0]])
    found = of_monodromy(CLEARANCE().cell, matrix, 1e5 * np.abs(matrix))
    assert found.stable


def test_a_multiplier_of_a_matrix_of_large_entries_may_be_all_rounding() -> None:
    """The number beside the eigenvalue is one itself; in 40 digits the bound is 0.50811025."""
    entries = [
        [-161725.60673944774, -110545.10166328604],
        [236603.29215145778, 161726.61529649256],
    ]
    size = [[935972.3022492512, 639769.7643071994], [909210.0975595993, 621476.8625348944]]
    found = of_monodromy(CLEARANCE().cell, np.array(entries), np.array(size))
    assert found.rounding == pytest.approx(0.50811025, rel=1e-5)
    assert found.stable is None


def test_an_orbit_of_many_phases_is_decided() -> None:
    """Rounding errors do not grow with all factors: 42 phases forget a perturbation."""
    case = ns.scene("clearance")(
        frequency=0.05, damping=0.1, stiffness=1, contact_stiffness=100, gap=0.5
    )
    orbit = ns.exact(case)
    assert len(orbit.phases) == 42
    assert orbit.stable
    assert orbit.stability.rounding < 1e-9
