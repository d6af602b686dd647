"""A mass that rests on a stop: its orbit against a closed form that needs one root.

It lifts off, at rest at g, where the falling force no longer presses it on to the stop: at
``cos(phi) = k g/F`` with phi from 0 to pi.  So the flight is known, and lasts to the first root
of ``x(t) = g``.  There is an orbit if that is within the period, at a time at which the force
presses again.
"""

import mpmath as mp
import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.in_order import cases_in_order
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.orbit.solution import attempt
from nonsmooth.solver.solve import solve_case
from nonsmooth.solver.stability.in_words import in_words

SCENE = registry.load("impact-inelastic")

#: Steps in which the first landing is looked for, over a period.
STEPS = 400


def flown(values, phi):
    """Return how far beyond the stop a mass is that leaves it at rest at some phase."""
    m, c, k, F, W, g = map(mp.mpf, values.values())
    wave = F * mp.expj(phi) / mp.mpc(k - m * W**2, c * W)
    one, two = mp.polyroots([m, c, k], maxsteps=200, extraprec=200)
    free = mp.lu_solve(
        mp.matrix([[1, 1], [one, two]]), mp.matrix([g - mp.re(wave), -mp.re(1j * W * wave)])
    )

    def beyond(t):
        moving = free[0] * mp.exp(one * t) + free[1] * mp.exp(two * t)
        return mp.re(moving + wave * mp.expj(W * t)) - g

    return beyond


def landing(**values):
    """Return phi and the duration of the flight to 30 digits; None where it has no such end."""
    with mp.workdps(40):
        stiffness, force, frequency, gap = (
            mp.mpf(values[name]) for name in ("stiffness", "force", "frequency", "gap")
        )
        phi, period = mp.acos(stiffness * gap / force), 2 * mp.pi / frequency
        beyond = flown(values, phi)
        times = [period * i / STEPS for i in range(4, STEPS + 1)]
        signs = [beyond(t) > 0 for t in times]
        if True not in signs:
            return None
        first = signs.index(True)
        # behind a lift-off it is below the stop, and lands once: where it is above, it is late
        flight = mp.findroot(beyond, (times[first - 1], times[first]), solver="anderson")
        return (phi, flight) if frequency * flight >= 2 * mp.pi - 2 * phi else None


def drawn(seed, count):
    """Yield parameters, gaps of both signs and zero, in units of all sizes."""
    random = np.random.default_rng(seed)
    for i in range(count):
        m, k, F = 10.0 ** random.uniform(-2, 2, 3)
        ratio, damping, gap = random.uniform((0.3, 0, -0.8), (2.2, 1, 0.8))
        yield {
            "mass": m,
            "damping": damping * np.sqrt(m * k),
            "stiffness": k,
            "force": F,
            "frequency": ratio * np.sqrt(k / m),
            "gap": 0.0 if i % 5 == 0 else gap * F / k,
        }


def as_declared(case):
    """Return a case whose phases have the declared order, and no other."""
    (found,) = cases_in_order(case, case.scene.phases)
    return found


def check_drawn(seed, count, refused=0):
    """Compare what is found with the closed form; return how often there is an orbit.

    That there is none takes long to find: so often it is checked.
    """
    found = 0
    for values in drawn(seed, count):
        case, expected = SCENE(**values), landing(**values)
        if expected is None:
            refused -= 1
            if refused >= 0:
                with pytest.raises(NoOrbit):
                    exact_orbit(as_declared(case))
            continue
        found += 1
        orbit = exact_orbit(case)
        phi, flight = map(float, expected)
        assert orbit.forcing_phase == pytest.approx(phi, abs=1e-13)
        # a slow landing turns rounding of the place into one of the time
        slow = orbit.extremes["velocity"][1] / abs(orbit.part(0, np.ones(1), 1)[0])
        slow /= case.units.of_motion(1)
        assert orbit.durations[0] == pytest.approx(flight, abs=1e-14 * orbit.period * slow)
        assert sum(orbit.durations) == pytest.approx(2 * np.pi / values["frequency"])
        assert orbit.multipliers.tolist() == [0, 0]
        assert orbit.stable
        tau = solve_case(case, "ck-tau", 16)
        assert tau.durations[0] == pytest.approx(flight, abs=1e-7 * orbit.period)
    return found


def test_random_parameters_against_the_closed_form() -> None:
    assert check_drawn(3, 10, refused=1) >= 4


@pytest.mark.long
def test_many_random_parameters_against_the_closed_form() -> None:
    assert check_drawn(11, 150, refused=30) >= 60


def test_each_method_comes_to_the_closed_form_at_its_rate() -> None:
    """As at an impact that rebounds: hb by 1/N, K = 2 by N^-3, polynomials faster."""
    values = {q.name: q.default for q in SCENE.parameters}
    _, flight = landing(**values)

    times = exact_orbit(SCENE()).times

    def errors(method, orders, functions=None):
        kernel = registry.kernel(SCENE, method, functions)
        orbits = [attempt(kernel, SCENE(), n, times, functions) for n in orders]
        assert all(orbit.admissible for orbit in orbits), [each.violations for each in orbits]
        return np.abs([orbit.durations[0] - float(flight) for orbit in orbits])

    for functions, power in ((None, 1), (1, 1), (2, 3)):
        first, last = errors("hb-ck" if functions else "hb", (12, 36), functions)
        assert np.log(first / last) / np.log(3) == pytest.approx(power, abs=0.15), functions
    for method, most in (("ck", 3e-9), ("ck-tau", 1e-13)):  # of 5.2 s
        assert errors(method, (12,))[0] < most


def test_a_stop_where_the_spring_is_free_has_states_of_zero() -> None:
    """All states at the switches are 0 there: their corrections are rounding from the start."""
    case = SCENE(gap=0)
    orbit = exact_orbit(case)
    again = exact_orbit(case, orbit.durations, orbit.angle)
    assert again.durations == pytest.approx(orbit.durations, rel=1e-14)
    assert solve_case(case, order=12).errors.times < 1e-14


@pytest.mark.parametrize(
    ("gap", "frequency", "why"),
    [
        (1.2, 1.2, "settles on another sequence of phases: flight"),  # the force never presses
        (-1.2, 1.2, "without switches"),  # nor lifts it off
        (0.5, 0.5, "another sequence of phases: flight, flight, rest"),  # it lands too early
        (1.2, 3.0, "the mass can move in flight for ever"),  # too near for the stop
    ],
)
def test_where_there_is_no_such_orbit_the_reason_is_said(gap, frequency, why) -> None:
    case = as_declared(SCENE(gap=gap, frequency=frequency))
    with pytest.raises(NoOrbit) as caught:
        exact_orbit(case)
    assert why in f"{caught.value}; {'; '.join(caught.value.tried)}"


def test_where_it_lands_too_early_it_flies_twice() -> None:
    """The second flight begins where the first ends; it lands where the force presses."""
    case = SCENE(gap=0.5, frequency=0.5)
    orbit = exact_orbit(case)
    assert orbit.case.scene.motion == "flight,flight,rest"
    phi = np.arccos(0.5)
    assert orbit.forcing_phase == pytest.approx(phi, abs=1e-13)
    start = 0.0
    for duration in orbit.durations[:2]:
        flight = flown(dict(case.values), phi + 0.5 * start)
        assert float(flight(duration)) == pytest.approx(0, abs=1e-12)
        inside = [float(flight(duration * u)) for u in np.linspace(0.01, 0.99, 99)]
        assert max(inside) < 0
        start += duration
    assert np.cos(phi + 0.5 * start) > 0.5


@pytest.mark.parametrize("gap", [-0.3, 0.0, 0.1, 0.3])
def test_simulation_begins_at_rest_on_the_stop_and_comes_to_the_orbit(gap) -> None:
    case = SCENE(gap=gap)
    orbit = exact_orbit(case)
    motion = ns.simulate(case, (gap, 0.0), cycles=3)
    assert motion.phases[0].name == "rest"
    # at once: the first flight is that of the orbit, from where the force lets go
    lift, lands = (phase.start for phase in motion.phases[1:3])
    assert lift == pytest.approx(orbit.forcing_phase / case.values["frequency"], abs=1e-13)
    assert lands - lift == pytest.approx(orbit.durations[0], abs=1e-12)
    rests = [phase.displacement for phase in motion.phases if phase.name == "rest"]
    assert rests == pytest.approx([gap] * len(rests), rel=1e-15)


def test_a_mass_at_rest_before_the_stop_is_not_held() -> None:
    motion = ns.simulate(SCENE(), (0.05, 0.0), 1)
    assert motion.phases[0].name == "flight"
    with pytest.raises(ValueError, match="the place is not that of rest"):
        ns.simulate(SCENE(), (0.2, 0.0))


def test_perturbations_of_any_size_die_on_the_stop() -> None:
    """The multipliers are 0: not small but gone, once the mass has landed."""
    orbit = exact_orbit(SCENE())
    assert in_words(orbit) == "multipliers 0, 0: stable"
    frequency, start = orbit.case.values["frequency"], 2.0
    state = np.array([orbit.displacement(start), orbit.velocity(start)], dtype=float)
    turn = orbit.forcing_phase + frequency * start
    for change in ((0.05, 0.0), (0.0, 0.05), (-0.1, 0.1)):
        motion = ns.simulate(SCENE(), state + change, 1, forcing_phase=turn)
        assert motion.displacement(motion.time) == pytest.approx(state[0], abs=1e-12)
        assert motion.velocity(motion.time) == pytest.approx(state[1], abs=1e-12)


def test_a_family_over_gaps_of_both_signs() -> None:
    gaps = np.linspace(-0.3, 0.3, 7)
    found = ns.family(SCENE(), "gap", gaps)["forcing_phase"]
    assert found == pytest.approx(np.arccos(gaps), abs=1e-13)


def test_the_place_where_a_mass_is_held_is_that_of_its_landing() -> None:
    cell = SCENE().cell
    assert cell.place(1) == pytest.approx(0.144)  # 0.1 m, in units of F/(m Omega^2)
    assert cell.place(0) is None
    friction = registry.load("dry-friction")(frequency=0.4).of_motion("two-stops").cell
    assert [friction.place(p) for p in (0, 1)] == [None, None]  # it stops anywhere


def test_orders_below_the_lowest_of_the_order_that_settles_have_no_orbit() -> None:
    """One flight and no rest, of whose expansion the lowest order is higher."""
    short = SCENE(mass=0.53, force=0.35, frequency=2.25)
    orbit = ns.solve(short, tol=1e-4)
    assert [phase.name for phase in orbit.phases] == ["flight"]
    with pytest.raises(NoOrbit):
        ns.solve(short, order=1)
