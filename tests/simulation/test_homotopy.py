"""Starts from the linear response of a structure, by homotopy in its contact forces."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
import sympy as sp
from exponentials import generator, repeating
from made_scenes import in_a_row, parameters, scene_of
from scipy.linalg import expm

import nonsmooth as ns
from nonsmooth.scene import Body, Event, Phase
from nonsmooth.solver.existence import bodies
from nonsmooth.solver.existence.known import known
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.orbit.exact_orbit import from_times
from nonsmooth.solver.simulation import homotopy
from nonsmooth.solver.simulation.settle import rough_times_by_simulation

#: Masses of the chain, and points of a phase at which demands are looked at.
COUNT, POINTS = 6, 400

LINKS = in_a_row([1] * COUNT)
PUSHED = np.eye(COUNT)[0]

#: Places of the stops, and which of them are met in each phase: they are met one by one.
STOPS = (1, 3, 5)
MET = ((0,), (0, 1), (0, 1, 2), (0, 1), (0,), ())

#: Gaps as parts of the amplitude of the linear response at each stop: in the order above.
PARTS = (0.3, 0.5, 0.7)


def stopped(by_force: bool = False):
    """Return a chain with three stops; what ends a contact is said by its force, if wanted."""
    k, c, w = sp.symbols("k c w", positive=True)
    gaps = sp.symbols("gap_1:4", positive=True)
    body = Body(
        M=sp.eye(COUNT), K=sp.Matrix(LINKS), C=c * sp.Matrix(LINKS),
        forcing=sp.Matrix(PUSHED), at={f"place{i}": np.eye(COUNT)[i] for i in STOPS},
    )  # fmt: skip
    at, phases = list(body.at.values()), []
    for p, (met, then) in enumerate(pairwise((*MET, MET[0]))):
        beyond = [q.x - gap for q, gap in zip(at, gaps, strict=True)]
        seen = [-at[i].force if by_force and i in met else beyond[i] for i in range(3)]
        laws = tuple(q.force + (k * beyond[i] if i in met else 0) for i, q in enumerate(at))
        demands = {f"stop {i}": q if i in met else -q for i, q in enumerate(seen)}
        (changed,) = set(met) ^ set(then)
        phases.append(Phase(f"p{p}", laws, Event(seen[changed]), demands))
    own = {"stop": (k, "N/m", 0.5), "damping": (c, "N s/m", 0.5)}
    own |= {f"gap{i}": (gap, "m", 0.5) for i, gap in enumerate(gaps)}
    known = parameters(frequency=(w, "rad/s", 0.5), **own)
    return scene_of("stops", known, *phases, body=body)


def amplitudes(frequency: float, damping: float) -> np.ndarray:
    """Return the linear response of the chain at its stops."""
    stiffness = LINKS * (1 + 1j * frequency * damping) - frequency**2 * np.eye(COUNT)
    return np.linalg.solve(stiffness, PUSHED)[list(STOPS)]


@pytest.fixture(scope="module", params=[False, True], ids=["by places", "by forces"])
def scene(request):
    """Return the chain, derived once."""
    return stopped(request.param)


def at(scene, stop: float, damping: float, frequency: float, parts=PARTS):
    """Return the case of gaps that are parts of the amplitudes."""
    gaps = np.abs(amplitudes(frequency, damping)) * parts
    named = {f"gap{i}": gap for i, gap in enumerate(gaps)}
    return scene(stop=stop, damping=damping, frequency=frequency, **named)


@pytest.fixture
def blind(monkeypatch) -> list:
    """Return the cells for which starts all around are asked for, of which there are none."""
    asked: list = []
    monkeypatch.setattr(bodies, "rough_times", lambda cell: asked.append(cell) or iter(()))
    return asked


@pytest.fixture
def steps(monkeypatch) -> list:
    """Return whether each step of the homotopy found times."""
    found, own = [], homotopy._newton

    def newton(cell, guess):
        result = own(cell, guess)
        found.append(result[0] is not None)
        return result

    monkeypatch.setattr(homotopy, "_newton", newton)
    return found


def test_a_stable_orbit_is_found_that_simulations_do_not_reach(scene, blind) -> None:
    case = at(scene, 0.03, 1e-4, 0.28)
    assert {q.times for q in rough_times_by_simulation(case)} == {None}
    found = known(case)
    assert len(found.orbits) == 1
    assert found.orbits[0].stable
    assert not blind  # no other start was needed
    assert off(ns.exact(case)) < 1e-9
    assert ns.solve(case, order=12).errors.times < 1e-6


def test_starts_all_around_follow_an_orbit_that_is_not_stable(scene, blind) -> None:
    case = at(scene, 0.2, 1e-3, 0.2)
    (orbit,) = known(case).orbits
    assert orbit.stable is False
    assert off(orbit) < 1e-9
    assert len(blind) == 1


def test_steps_are_halved_where_a_stop_is_stiff(scene, steps) -> None:
    case = at(scene, 0.05, 0.01, 0.26)
    start = homotopy.from_linear_response(case.cell)
    assert start is not None
    assert steps[-1]
    assert not all(steps)
    assert from_times(case, start).admissible


def test_a_homotopy_that_fails_ends(scene, steps) -> None:
    assert homotopy.from_linear_response(at(scene, 5, 1e-3, 0.3).cell) is None
    assert len(steps) <= homotopy.MOST
    assert not steps[-1]


@pytest.mark.parametrize(("part", "reached"), [(0.99, True), (1.01, False)])
def test_a_start_asks_for_a_response_that_reaches_all_stops(scene, part, reached) -> None:
    case = at(scene, 1e-5, 1e-2, 0.3, (0.3, 0.5, part))
    assert (homotopy.from_linear_response(case.cell) is not None) == reached


def test_the_first_times_are_those_at_which_the_linear_response_meets_stops(scene) -> None:
    case = at(scene, 1.0, 0.01, 0.3)
    (times,) = homotopy._crossings(case.cell)
    omega, response = case.cell.omega, amplitudes(0.3, 0.01)
    begins = times[-1] + omega * np.cumsum([0, *times[:-1]])
    for angle, now, then in zip(begins, (MET[-1], *MET), (*MET, MET[0]), strict=True):
        (i,) = set(now) ^ set(then)
        x = (response[i] * np.exp(1j * angle)).real
        assert x == pytest.approx(PARTS[i] * abs(response[i]), rel=1e-12)
    assert sum(times[:-1]) == pytest.approx(case.cell.duration, rel=1e-12)


def test_a_part_of_the_laws_is_all_but_the_forces(scene) -> None:
    cell = at(scene, 1.0, 0.01, 0.3).cell
    assert homotopy.under_part(cell, 1.0).phases == cell.phases
    weak = at(scene, 0.25, 0.01, 0.3).cell
    assert [q.laws for q in homotopy.under_part(cell, 0.25).phases] == [
        tuple(pytest.approx(law) for law in phase.laws) for phase in weak.phases
    ]


@pytest.mark.parametrize("name", ["chain-impact", "jenkins-absorber", "absorber-friction"])
def test_impacts_memory_and_held_contacts_have_no_such_start(name) -> None:
    assert homotopy.from_linear_response(registry.load(name)().cell) is None


def test_several_cycles_have_no_such_start(scene) -> None:
    cell = at(scene, 0.03, 1e-4, 0.28).cell
    assert homotopy.from_linear_response(cell) is not None
    assert homotopy.from_linear_response(replace(cell, cycles=2)) is None


def test_a_half_cell_of_friction_has_such_a_start() -> None:
    case = rubbed()(frequency=0.4, damping=0.01, friction=0.01)
    start = homotopy.from_linear_response(case.cell)
    assert start is not None
    orbit = from_times(case, start)
    assert orbit.admissible
    assert orbit.stable
    assert known(case).orbits[0].times == pytest.approx(orbit.times)


def rubbed():
    """Return a chain with three contacts that slip, in half a period: the driven end first."""
    c, w, force = sp.symbols("c w force", positive=True)
    body = Body(
        M=sp.eye(COUNT), K=sp.Matrix(LINKS), C=c * sp.Matrix(LINKS),
        forcing=sp.Matrix(PUSHED), at={f"place{i}": np.eye(COUNT)[i] for i in STOPS},
    )  # fmt: skip
    contacts, phases = list(body.at.values()), []
    for p in range(3):
        signs = [1 if i < p else -1 for i in range(3)]
        laws = tuple(q.force + s * force for q, s in zip(contacts, signs, strict=True))
        demands = {
            f"{i}": s * q.v for i, (q, s) in enumerate(zip(contacts, signs, strict=True))
        }
        phases.append(Phase(f"p{p}", laws, Event(contacts[p].v), demands))
    own = parameters(
        damping=(c, "N s/m", 0.5), frequency=(w, "rad/s", 0.5), friction=(force, "N", 0.5)
    )
    return scene_of("rubbed", own, *phases, body=body, half_period=True)


def off(orbit) -> float:
    """Return how far an orbit is from its switches and beyond its demands, as a part of gaps.

    The chain is moved on by matrix exponentials, from the periodic state that its times leave.
    """
    values = orbit.case.values
    gaps = np.array([values[f"gap{i}"] for i in range(3)])
    flows = [moved(values, met, gaps) for met in MET]
    period = np.eye(2 * COUNT + 3)
    for A, phase in zip(flows, orbit.phases, strict=True):
        period = expm(A * phase.duration) @ period
    X, worst = repeating(period, orbit.forcing_phase), 0.0
    for A, phase, met, then in zip(flows, orbit.phases, MET, (*MET[1:], MET[0]), strict=True):
        step = expm(A * phase.duration / POINTS)
        side = np.array([-1.0 if i in met else 1.0 for i in range(3)])
        for _ in range(POINTS):
            worst = max(worst, (side * (X[list(STOPS)] / gaps - 1)).max())
            X = step @ X
        (i,) = set(met) ^ set(then)
        worst = max(worst, abs(X[STOPS[i]] / gaps[i] - 1))
    return float(worst)


def moved(values, met, gaps) -> np.ndarray:
    """Return the generator of the chain on these of its stops."""
    pressed, back = np.zeros(COUNT), np.zeros(COUNT)
    for i in met:
        pressed[STOPS[i]], back[STOPS[i]] = values["stop"], values["stop"] * gaps[i]
    K, C = LINKS + np.diag(pressed), values["damping"] * LINKS
    return generator(np.eye(COUNT), K, C, PUSHED, values["frequency"], back)
