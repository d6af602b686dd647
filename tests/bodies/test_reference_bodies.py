"""Orbits of bodies against ball arithmetic: exact ones, those of the force series, ghosts."""

import math
from functools import partial

import numpy as np
import pytest
from bodies.reference_bodies import Reference, body, case, of, references
from galerkin.solving import OF_TWO, differences, jacobian, residual

from nonsmooth.solver.bodies import motion
from nonsmooth.solver.bodies.force_series import layout
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.kernels.bodies import exact_kernel
from nonsmooth.solver.kernels.start import RoughTimes
from nonsmooth.solver.orbit.exact_orbit import ExactOrbit, from_times
from nonsmooth.solver.orbit.solution import Solution, attempt

#: Errors of the force series at N = 10 of stiff beams, from the table of the measurement; all
#: others are within 1e-10.
STIFF = {
    "beam-4-spring": 1.2e-5,
    "beam-4-spring-ghost": 2e-3,
    "beam-10-spring": 1e-5,
    "beam-20-spring": 1e-5,
    "beam-10-spring-unstable": 1e-8,
    "clearance-2-ghost": 1e-9,
}

EVERY = pytest.mark.parametrize("r", references(), ids=lambda r: r.name)


def start(r: Reference, off: float = 1e-3) -> np.ndarray:
    """Return the times of a reference without units, a little off."""
    rng = np.random.default_rng(7)
    turns = 1 + off * rng.standard_normal(len(r.durations))
    durations = np.array(r.durations) / case(r.name).units.time * turns
    return np.append(durations, [] if r.angle is None else r.angle + off)


def error(r: Reference, found: ExactOrbit | Solution) -> float:
    """Return the largest error of a duration and of the phase, as a part of the period."""
    own = np.array(found.durations[: len(r.durations)])
    off = float(np.abs(own - r.durations).max()) / r.period
    if r.angle is None:
        return off
    turn = math.remainder(found.angle - r.angle, 2 * math.pi)
    return max(off, abs(turn) / (2 * math.pi) * r.cycles)


@EVERY
def test_exact_orbit(r: Reference) -> None:
    """Its times, states and multipliers; ghosts are refused, and orbits are not."""
    times, count = start(r), len(r.durations)
    angle = 0.0 if r.angle is None else float(times[-1])
    found = from_times(case(r.name), RoughTimes(tuple(times[:count]), angle, "near"))
    assert found.outcome.converged
    assert error(r, found) <= 1e-13
    assert found.admissible == r.admissible == (not found.violations), found.violations
    multipliers = np.asarray(found.multipliers)
    assert np.abs(multipliers).max() == pytest.approx(r.radius, rel=1e-11)
    for value in r.multipliers:
        assert np.abs(multipliers - value).min() <= 1e-11 * max(1.0, r.radius)
    column, count = body(r).arrays["at"].dense()[:, 0], body(r).size
    for phase, state in zip(found.phases, r.states, strict=False):
        x, v = (float(column @ state[i * count : (i + 1) * count]) for i in (0, 1))
        assert phase.displacement == pytest.approx(x, abs=1e-12)
        assert phase.velocity == pytest.approx(v, abs=1e-10)


@EVERY
def test_force_series(r: Reference) -> None:
    own = case(r.name)
    kernel = registry.kernel(own.scene, "ck-tau")
    found = attempt(kernel, own, 10, start(r))
    assert found.converged
    assert error(r, found) <= STIFF.get(r.name, 1e-10)


@pytest.mark.parametrize("name", ["beam-10-spring", "clearance-2", "two-stops-four-phases"])
def test_pieces_of_a_phase(name: str) -> None:
    """Beyond 32 polynomials a phase is cut into pieces, and converges on."""
    r = of(name)
    own = case(name)
    found = attempt(registry.kernel(own.scene, "ck-tau"), own, 40, start(r))
    assert layout._pieces(40)[1] == 2
    assert found.converged
    assert error(r, found) <= 1e-11


#: Of each kind of law: springs, a memory, nothing that forces, impulses, several contacts.
KINDS = (
    *("clearance-2", "jenkins-absorber", "belt-2", "impact-3-two-impacts"),
    *("two-stops-six-phases", "impact-3-not-proportional"),
)


@pytest.mark.parametrize("order", [0, 5, 40])
@pytest.mark.parametrize("name", KINDS)
def test_jacobian_against_differences(name: str, order: int) -> None:
    r = of(name)
    cell, times = case(name).cell, start(r, 1e-2)
    kernel = registry.kernel(case(name).scene, "ck-tau") if order else exact_kernel(cell)
    given = kernel.given(case(name), order)
    rows = differences(partial(residual, kernel, given), times, 1e-6, OF_TWO)
    found = jacobian(kernel, given, times)
    assert found == pytest.approx(np.array(rows).T, abs=1e-7 * np.abs(found).max())


@pytest.mark.parametrize("name", KINDS)
def test_derivatives(name: str) -> None:
    """Those of the exact motion against differences, those of the series against it."""
    cell, times, step = case(name).cell, start(of(name), 0.0), 1e-4
    exact, by_series = motion.Given(cell, 0), motion.Given(cell, 24)
    u = np.linspace(0.1, 0.9, 5)
    for p in range(len(cell.phases)):
        h = step / times[p]
        for number in (1, 2, 3, 4):
            ahead, behind = (
                motion.derivative(exact, times, p, u + q, number - 1) for q in (h, -h)
            )
            found = motion.derivative(exact, times, p, u, number)
            size = 1e-5 * max(1.0, float(np.abs(found).max()))
            assert found == pytest.approx((ahead - behind) / (2 * step), abs=size)
            series_ = motion.derivative(by_series, times, p, u, number)
            assert series_ == pytest.approx(found, abs=1e-7 * max(1.0, np.abs(found).max()))
