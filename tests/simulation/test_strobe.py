"""Motions once a period of the forcing: their attractors are the stable orbits."""

import json
import math
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.plots.simulations import basins_figure, diagram_figure
from nonsmooth.solver import strobe
from nonsmooth.solver.existence.known import known_orbits

SPRING = ns.scene("clearance")(force=0.3, damping=0.1, gap=1.0, frequency=1.2)
STOP = ns.scene("impact")(damping=0.02, restitution=0.8, gap=0.0)
AXIS = np.linspace(-4, 4, 5)


def at_no_phase(orbit) -> np.ndarray:
    """Return the state of an orbit where the phase of the forcing is 0."""
    omega = float(orbit.case.values["frequency"])
    t = (-orbit.forcing_phase % (2 * math.pi)) / omega
    return np.array([orbit.displacement([t])[0], orbit.velocity([t])[0]])


@pytest.fixture(scope="module")
def found():
    return ns.basins(SPRING, AXIS, AXIS, 200)


def test_attractors_are_the_stable_orbits(found) -> None:
    (contact,) = (orbit for orbit in known_orbits(SPRING) if orbit.stable)
    m, w, c = 1.0, 1.2, 0.1
    response = 0.3 / complex(1 - m * w * w, c * w)  # without contact
    linear = np.array([response.real, (1j * w * response).real])
    states = [np.array(each.states) for each in found.attractors]
    assert [each.cycles for each in found.attractors] == [1, 1]
    for expected in (linear, at_no_phase(contact)):
        assert min(np.abs(state - expected).max() for state in states) < 1e-7


def test_each_start_goes_where_a_simulation_goes(found) -> None:
    assert set(found.index.ravel().tolist()) == {0, 1}
    for i, v in enumerate(AXIS[::2]):
        for j, x in enumerate(AXIS[::2]):
            motion = ns.simulate(SPRING, (x, v), cycles=200)
            end = np.array([motion.displacement([motion.time])[0]])
            state = found.attractors[found.index[2 * i, 2 * j]].states[0]
            assert end[0] == pytest.approx(state[0], abs=1e-6)


def test_a_motion_of_a_grid_is_followed_until_it_settles(monkeypatch) -> None:
    """Some 7 % of a transient decay in a period: more than 100 of them are left to it."""
    case = ns.scene("clearance")(force=0.01, damping=0.02, gap=1.0, frequency=0.8)
    assert (ns.basins(case, [0.3], [0.0]).index == 0).all()
    monkeypatch.setattr(strobe, "FURTHER", 0)
    assert (ns.basins(case, [0.3], [0.0]).index == -1).all()


def test_the_unstable_orbit_lies_between_the_basins() -> None:
    (between,) = (orbit for orbit in known_orbits(SPRING) if orbit.stable is False)
    x, v = at_no_phase(between)
    beside = ns.basins(SPRING, [x - 1e-3, x + 1e-3], [v], 300)
    assert sorted(beside.index.ravel().tolist()) == [0, 1]


def test_no_motion_begins_behind_the_stop() -> None:
    found = ns.basins(STOP, [-1.0, 0.5], [0.0])
    assert found.index[0, 1] == -2
    assert "1  no motion from there" in str(found)


def test_what_does_not_repeat_itself_has_no_attractor() -> None:
    undamped = ns.scene("clearance")(force=0.3, damping=0.0, gap=1.0, frequency=2.1)
    found = ns.basins(undamped, [0.1], [0.0])
    assert (found.index.tolist(), found.attractors) == ([[-1]], ())
    assert "1  not settled" in str(found)
    (every_second,) = ns.basins(undamped.with_value("frequency", 2.0), [0.1], [0.0]).attractors
    assert every_second.cycles == 2  # where only rounding is left of the velocity


def test_what_decays_in_millions_of_periods_has_not_settled() -> None:
    slow = ns.scene("clearance")(damping=1e-8, stiffness=4.0, frequency=1.0, gap=100.0)
    assert set(ns.basins(slow, [-1.0, 1.0], [0.0]).index.flat) == {-1}
    damped = slow.with_value("damping", 0.01)
    assert ns.basins(damped, [0.0, 1e9], [0.0]).index.tolist() == [[-1, -1]]


def test_a_transient_that_changes_sign_each_period_is_no_attractor() -> None:
    ringing = ns.scene("clearance")(damping=0.034, frequency=2.0, gap=100.0)
    (each_period,) = ns.basins(ringing, [-1.0, 1.0], [0.0], 300).attractors
    assert each_period.cycles == 1


@pytest.mark.parametrize("size", [1.0, 1e-3, 1e-6])
def test_each_place_where_friction_holds_a_mass_is_an_attractor(size: float) -> None:
    numbers = {"mass": 1, "damping": 0.1, "stiffness": 1, "frequency": 0.5}
    friction = {"mu_s": 0.3, "mu_k": 0.3, "normal_force": size, "force": 0.1 * size}
    places = [size * x for x in (-0.15, 0.0, 0.1, 0.15)]
    held = ns.basins(ns.scene("dry-friction")(**numbers, **friction), places, [0.0])
    assert held.index.tolist() == [[0, 1, 2, 3]]
    assert [q.states for q in held.attractors] == [((pytest.approx(x), 0.0),) for x in places]


@pytest.mark.parametrize("cycles", [12, 15])
def test_a_ball_may_be_back_after_a_dozen_periods_of_the_stop(cycles: int) -> None:
    case = ns.scene("impact")(frequency=2.0 * cycles, gap=0.0, force=30.0)
    orbit = ns.exact(replace(case, cycles=cycles))
    (found,) = ns.basins(case, *at_no_phase(orbit)[:, None]).attractors
    assert found.cycles == cycles


def test_rows_may_be_computed_elsewhere(found) -> None:
    with ThreadPoolExecutor(2) as executor:
        other = ns.basins(SPRING, AXIS, AXIS, 200, executor)
    np.testing.assert_array_equal(other.index, found.index)
    assert other.attractors == found.attractors


def test_a_period_doubles_where_a_multiplier_passes_minus_one() -> None:
    frequencies = [2.6, 2.7]
    once, twice = ns.diagram(STOP, "frequency", frequencies, 400, 8).states
    orbit = ns.exact(STOP.with_value("frequency", 2.6))
    assert orbit.stable
    np.testing.assert_allclose(once[:, :2], np.tile(at_no_phase(orbit), (8, 1)), atol=1e-6)
    assert ns.exact(STOP.with_value("frequency", 2.7).with_cycles(1)).stable is not True
    assert np.ptp(twice[::2, 0]) < 1e-6
    assert np.ptp(twice[:, 0]) > 0.1


def test_where_a_motion_ends_the_next_begins_at_rest() -> None:
    values = [2.86, 2.0]  # impacts accumulate at the first
    found = ns.diagram(STOP, "frequency", values, 400, 4)
    assert len(found.states[0]) == 0
    assert np.ptp(found.states[1][:, 0]) < 1e-6
    line, ended = diagram_figure(found).axes[0].lines
    assert (ended.get_label(), list(ended.get_xdata())) == ("the motion ends", [2.86])
    assert len(line.get_xdata()) == 4


def test_what_a_motion_remembers_is_handed_on() -> None:
    case = ns.scene("elastic-plastic")()
    found = ns.diagram(case, "frequency", [0.8, 0.8], 60, 2)
    assert found.states[0].shape == (2, 2 + len(case.cell.memory))
    orbit = ns.exact(case)
    np.testing.assert_allclose(found.states[1][-1, :2], at_no_phase(orbit), atol=1e-6)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: ns.diagram(STOP, "gape", [0.1]), "parameter: got 'gape'"),
        (lambda: ns.diagram(STOP, "gap", []), r"values: got \[\], expected numbers"),
        (lambda: ns.diagram(STOP, "gap", 0.1), "values: got 0.1, expected numbers"),
        (lambda: ns.basins(STOP, 0.0, [0.0]), "x: got 0.0, expected numbers in a sequence"),
        (lambda: ns.diagram(STOP, "frequency", [-1.0]), "frequency: got -1.0"),
        (lambda: ns.diagram(STOP, "gap", [0.1], -1), "transient: got -1"),
        (lambda: ns.diagram(STOP, "gap", [0.1], 1, 0), "cycles: got 0"),
        (lambda: ns.diagram(ns.scene("stick-slip")(), "mass", [1.0]), "nothing forces"),
        (lambda: ns.basins(STOP, [0.0], [math.nan]), "v: got"),
        (lambda: ns.basins(STOP, [], [0.0]), "x: got"),
        (lambda: ns.basins(STOP, [1e308], [0.0]), r"x: got \[1e.308\]"),
        (lambda: ns.basins(STOP, [0.0], [0.0], 5), "cycles: got 5"),
    ],
)
def test_what_cannot_be_looked_at(call, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        call()
    with pytest.raises(TypeError):
        ns.basins("impact", [0.0], [0.0])


FLAGS = ("--force", 0.3, "--damping", 0.1, "--gap", 1, "--frequency", 1.2)


def test_the_command_has_the_basins(found, run, tmp_path: Path) -> None:
    path, axis = tmp_path / "basins.csv", "=-4:4:3"
    grid = ("--grid", f"x{axis}", "--grid", f"v{axis}", "--cycles", 200)
    status, out, _ = run("simulate", "clearance", *FLAGS, *grid, "--json", "-o", path)
    document = json.loads(out)
    assert status == 0
    assert document["index"] == found.index[::2, ::2].tolist()
    assert [each["cycles"] for each in document["attractors"]] == [1, 1]
    assert len(path.read_text().splitlines()) == 10
    figure = basins_figure(found)
    assert len(figure.axes[0].lines) == 2


def test_the_command_says_that_longer_may_settle_the_others(run) -> None:
    flags = ("simulate", "clearance", *FLAGS[:2], *FLAGS[4:], "--damping", 0.001)
    grid = ("--grid", "x=0:1:2", "--grid", "v=0:1:2")
    _, out, _ = run(*flags, *grid, "--cycles", 40)
    assert out.endswith("More --cycles than 40 may settle what has not.\n")


def test_the_command_has_the_diagram(run, tmp_path: Path) -> None:
    flags = ("simulate", "clearance", *FLAGS[:-2], "--vary", "frequency=0.7:0.9:3")
    target = tmp_path / "diagram.svg"
    status, out, _ = run(*flags, "--cycles", 2, "--json", "-o", target)
    document = json.loads(out)
    assert status == 0
    assert document["values"] == [0.7, 0.8, 0.9]
    assert [len(states) for states in document["states"]] == [2, 2, 2]
    assert target.exists()
