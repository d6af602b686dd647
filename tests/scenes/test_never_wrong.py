"""Solutions of the equations that are not orbits, made on purpose and refused with reasons."""

import math
from pathlib import Path

import numpy as np
import pytest
from made_scenes import Given, made
from numpy.polynomial import Polynomial

from nonsmooth.solver.case import registry
from nonsmooth.solver.flow.exact import exact_orbit
from nonsmooth.solver.flow.exact_system import exact_kernel
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.orbit.admissible import violations

IMPACT, FRICTION = registry.load("impact"), registry.load("dry-friction")


def reason(case, durations, angle=0.0):
    """Return why no orbit is found from given times; without units they are those in SI."""
    with pytest.raises(NoOrbit) as caught:
        exact_orbit(case, [s * case.units.time for s in durations], angle)
    (why,) = caught.value.tried
    return why


def test_an_impact_from_beyond_the_stop():
    """The other root of the equations, half a turn on: the mass hits the stop from behind."""
    orbit = exact_orbit(IMPACT())
    why = reason(IMPACT(), orbit.cell_durations, orbit.angle + math.pi)
    assert "flight ends from beyond its limit" in why or "not true that the mass stays" in why


def test_a_mass_that_touches_the_stop_again_within_the_period():
    """Beyond grazing, of the motion between impacts: two cycles with too low a frequency."""
    scene = registry.load("impact")
    with pytest.raises(NoOrbit) as caught:
        exact_orbit(scene(frequency=0.9, gap=0.0, restitution=0.9, cycles=2))
    assert "not true that the mass stays before the stop" in " ".join(caught.value.tried)


def test_sliding_where_the_mass_would_stop():
    case = FRICTION(frequency=0.4, mu_s=0.6, mu_k=0.5).of_motion("sliding")
    start = reason(case, [math.pi], 1.5)
    assert "where slide ends, not true that the load exceeds the static limit" in start
    # a higher static limit alone, of an orbit that is one at a lower limit
    assert exact_orbit(FRICTION(mu_s=0.5)).violations == ()
    orbit = exact_orbit(FRICTION())
    high = FRICTION(mu_s=2.0).of_motion("sliding")
    assert "by 0." in reason(high, orbit.cell_durations, orbit.angle)


def test_a_stop_whose_load_exceeds_the_limit():
    """Rest that begins while the load is beyond the limit: the mass would not stay there."""
    case = FRICTION(frequency=0.4, mu_s=0.6, mu_k=0.5).of_motion("two-stops")
    orbit = exact_orbit(case)
    rest, start = float(orbit.phases[1].displacement), orbit.angle + orbit.cell_durations[0]
    assert abs(math.cos(start) - rest) < 0.6  # within the limit, in units of k and F
    still = Given(
        case, tuple(orbit.cell_durations), Polynomial([0.0]), -orbit.cell_durations[0]
    )
    (why,) = [each for each in violations(still) if "static limit" in each]
    assert why.startswith("in stop, not true that the load stays within the static limit")


def test_a_slip_of_no_duration():
    """Pure sticking: the stick ends at the limit, and the slip at once."""
    case = registry.load("stick-slip")()
    (why,) = violations(Given(case, (2.0, 1e-13), Polynomial([0.0, 1.0])))
    assert why.startswith("slip lasts")
    assert why.endswith("it has no duration")


def test_several_cycles_are_not_one_of_them_repeated():
    """Two flights, each of one cycle: an orbit of one cycle, twice."""
    flight = (1.0, 0.1, 1.0, 0.0, 1.0)
    stop, law = (1.0, 0.0, 0.0, -0.1), (-0.6, 0.0)
    scene = made(
        [flight, flight], [stop, stop], omega=1.8, jumps=(law, law), k=0, folder=Path("none")
    )
    single = exact_orbit(IMPACT()).cell_durations[0] / 1.8
    angle = exact_orbit(IMPACT()).angle
    why = reason(scene(cycles=2), [single, single], angle)
    assert "it is an orbit of 1 cycle of the forcing, 2 times in a row" in why


def test_the_jacobian_of_the_exact_equations_with_a_memory():
    """By differences, of a memory of displacement, velocity and forcing set within the cell."""
    cell = registry.load("elastic-plastic")().cell
    (memory,) = cell.memory
    general = type(memory)("w", 1, 0, (0.7, -0.4, 0.3, 0.2))
    for one in (cell, type(cell)(**{**vars(cell), "memory": (general,)})):
        kernel = exact_kernel(one)
        z = np.array([2.4, 0.1, 1.4, -1.5, 2.2, 1.1, 2.7, 2.3])
        J, size = np.empty((8, 8)), 1e-6
        kernel.jacobian(one, z, J)
        for i in range(8):
            above, below = np.empty(8), np.empty(8)
            kernel.residual(one, z + size * np.eye(8)[i], above)
            kernel.residual(one, z - size * np.eye(8)[i], below)
            expected = (above - below) / (2 * size)
            np.testing.assert_allclose(J[:, i], expected, rtol=0, atol=1e-8)
