"""The estimated error against the true one: calibration, rounding, nothing known."""

import math
import os
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from computed import belt_of
from hypothesis import given, settings
from hypothesis import strategies as st
from one_mass import NAMES as ONE_MASS

import nonsmooth as ns
from nonsmooth.report.case import DEFAULT
from nonsmooth.solver.accuracy import estimate as estimates
from nonsmooth.solver.accuracy.estimate import EPSILON, ROUNDING
from nonsmooth.solver.accuracy.estimate import condition as skeel
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.existence import one_phase
from nonsmooth.solver.flow.exact_system import exact_kernel
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.kernels.start import RoughTimes
from nonsmooth.solver.orbit.errors import difference
from nonsmooth.solver.orbit.exact_orbit import from_times
from nonsmooth.solver.orbit.solution import attempt
from nonsmooth.solver.precision import exact_balls
from nonsmooth.solver.precision.digits import condition
from nonsmooth.solver.precision.refine import refine
from nonsmooth.solver.results.orbit import Orbit
from nonsmooth.solver.scenes.case import Case

EXAMPLES = int(os.environ.get("EXAMPLES", "1200")) // 20


ORDERS = {"hb": st.integers(1, 80), "hb-c1": st.integers(1, 80), "c1": st.integers(1, 30)}

#: Errors below which rounding decides, not the method.
FLOORS = {"period": 2e-14, "times": 2e-14, "discontinuous": 1e-11, "switches": 2e-14}


@pytest.mark.parametrize("method", ORDERS)
def test_the_estimate_is_at_least_half_and_at_most_20_times_the_error(method: str) -> None:
    seen = []

    @settings(max_examples=EXAMPLES // 3)
    @given(st.floats(-3, 3), ORDERS[method])
    def run(exponent: float, order: int) -> None:
        try:
            orbit = ns.solve(belt_of(10**exponent), method, order)
        except ns.NoOrbit:
            return
        seen.append(order)
        for name, floor in FLOORS.items():
            error, estimated = abs(getattr(orbit.errors, name)), getattr(orbit.estimate, name)
            left = orbit.outcome.correction  # by Newton's method
            assert 0.5 * error <= estimated <= 20 * max(error, floor, left)

    run()
    assert len(seen) >= 0.5 * (EXAMPLES // 3)


@pytest.mark.parametrize("method", ["hb", "hb-c1"])
def test_what_the_better_orbit_may_be_off_by_is_added(monkeypatch, method: str) -> None:
    """As if it had converged at order 5."""
    orbit = ns.solve(DEFAULT, method, 40)
    near, beyond = (ns.solve(DEFAULT, "ck-tau", order) for order in (5, 9))
    monkeypatch.setattr(estimates, "MOST", 5)
    found = estimates.estimate(orbit)
    apart, doubt = difference(orbit, near, 40), difference(near, beyond, 9)
    left = 4 * orbit.outcome.correction
    assert found.times == pytest.approx(apart.times + doubt.times + left, rel=1e-8)
    expected = abs(apart.period) + abs(doubt.period) + left
    assert found.period == pytest.approx(expected, rel=1e-8)


@pytest.mark.parametrize("method", ["hb", "hb-c1", "c1"])
def test_what_newton_left_is_added(method: str) -> None:
    """The last correction says how large the rounding errors are; four of them count."""
    orbit = ns.solve(DEFAULT, method, 9)
    least, more = (
        estimates.estimate(replace(orbit, outcome=replace(orbit.outcome, correction=left)))
        for left in (0.0, 1e-6)
    )
    for name in FLOORS:
        assert getattr(more, name) - getattr(least, name) == pytest.approx(4e-6, rel=1e-3)


@pytest.mark.parametrize("order", [399, 400])
def test_the_highest_order_has_an_estimate(order: int) -> None:
    assert ns.solve(DEFAULT, "c1", order).estimate.times < 1e-14


IMPACT = registry.load("impact")
NAMES = ("mass", "damping", "stiffness", "force", "frequency", "gap", "restitution")


def solutions(case: Case) -> list[float]:
    """Return the phase of the forcing of each impact once a period, in closed form."""
    return [angle for _, speed, angle in one_phase.solutions(case.cell).states if speed < 0]


def orbits(case: Case, order: int) -> list[Orbit]:
    """Return the orbits of one impact a period by `ck-tau`, each from its exact times."""
    kernel = registry.quicker_kernel(case.scene, "ck-tau", None, order)
    starts = [RoughTimes((case.cell.duration,), angle, "") for angle in solutions(case)]
    exact = [from_times(case, start) for start in starts]
    found = [attempt(kernel, case, order, q.times) for q in exact if q.admissible]
    return [Orbit.of(q) for q in found if q.converged and q.exact is not None]


def error_of(orbit: Orbit) -> float:
    """Return the largest error of a time against 40 digits, as a part of the period."""
    case, kernel = orbit.case, exact_kernel(orbit.case.cell)
    near = orbit.exact.outcome.unknowns
    times = refine(kernel, case.cell, near, 40, exact_balls.residual)
    found = [*orbit.cell_durations, *([orbit.angle] if kernel.forced else [])]
    off = [float(time - float(own)) for time, own in zip(times, found, strict=True)]
    if kernel.forced:
        off[-1] = math.remainder(off[-1], 2 * math.pi) / case.cell.omega
    return max(map(abs, off)) / float(np.sum(orbit.cell_durations)) / case.cell.cells


#: Parameters of impacts near a fold, and an order at which the estimate, by the changes from
#: order to order and the last corrections alone, was 4 to 6000 times lower than an error.
FOLDS = [
    ((0.9574643891648096, 0.014411635576811759, 1.8659408919629774, 1.2013327125803726,
      2.1031810276684264, 0.913108186755273, 0.28988739839824096), 35),
    ((1.9011566121513606, 0.003379951815684783, 1.9409716400268713, 1.0902312981498985,
      1.7876409670602809, 0.8793483833215336, 0.7957130692271177), 49),
    ((0.6256190532201814, 0.0, 0.9727827015756341, 1.5793685369847021,
      2.125556250899557, 1.0684448332578513, 0.2279068539705483), 35),
    ((1.277781576213737, 0.0, 0.5398280356418628, 0.7270792570146942,
      1.2360958880270618, 0.529738218002739, 0.22252006723139822), 29),
]  # fmt: skip


@pytest.mark.parametrize(("values", "order"), FOLDS)
def test_near_a_fold_the_estimate_holds(values, order: int) -> None:
    found = orbits(IMPACT(**dict(zip(NAMES, values, strict=True))), order)
    assert len(found) == 2
    for orbit in found:
        assert np.abs(orbit.multipliers - 1).min() < 1e-4
        error = error_of(orbit)
        assert 1e-13 < error <= orbit.estimate.times
        rounding = EPSILON * condition(orbit.exact)
        assert rounding / 2 < orbit.estimate.times <= 20 * rounding


def near_folds(count: int, seed: int) -> Iterator[Orbit]:
    """Yield orbits at random distances from folds, which bisection finds in closed form."""
    rng = np.random.default_rng(seed)
    while count > 0:  # a case may have two
        damping = float(rng.choice([0, 10 ** rng.uniform(-6, -1)]))
        gap, restitution = rng.uniform(0.2, 1.2), rng.uniform(0.2, 0.99)

        def at(frequency, damping=damping, gap=gap, restitution=restitution):
            values = {"damping": damping, "gap": gap, "restitution": restitution}
            return IMPACT(**values, frequency=float(frequency))

        grid = np.linspace(1.1, 3.0, 12)
        many = [f for f in grid if solutions(at(f))]
        if len(many) in (0, len(grid)):
            continue
        inside, outside = many[-1], many[-1] + grid[1] - grid[0]
        for _ in range(60):
            middle = (inside + outside) / 2
            inside, outside = (middle, outside) if solutions(at(middle)) else (inside, middle)
        for orbit in orbits(at(inside * (1 - 10 ** rng.uniform(-12, -4))), rng.integers(8, 40)):
            yield orbit
            count -= 1


@pytest.mark.parametrize("count", [10, pytest.param(100, marks=pytest.mark.long)])
def test_at_random_distances_from_a_fold_the_estimate_holds(count: int) -> None:
    """The error is rounding, from what is usual to what is left where a multiplier is 1."""
    ratios, closest = [], 1.0
    for orbit in near_folds(count, seed=count):
        ratios.append(error_of(orbit) / orbit.estimate.times)
        closest = min(closest, np.abs(orbit.multipliers - 1).min())
    assert max(ratios) <= 2
    assert np.median(ratios) > 0.01  # it is not far above either
    assert closest < 1e-3


@pytest.mark.parametrize("alpha", [1e-4, 1e-7, 1e-8])
def test_a_short_stick_is_as_accurate_as_it_is_said_to_be(alpha: float) -> None:
    """Slip ends at the velocity at which it begins, with little acceleration."""
    for method in ("ck-tau", "hb"):
        orbit = ns.solve(belt_of(alpha), method, 20)
        assert orbit.errors.times <= orbit.estimate.times <= 10 * orbit.errors.times + 5e-15


def test_where_nothing_is_ill_conditioned_the_least_rounding_counts() -> None:
    """Skeel's number is above that by the parameters, found by differences, and not far."""
    for scene in map(registry.load, ONE_MASS):
        for damping in (None, 1e-3):
            values = {} if damping is None or scene.frequency is None else {"damping": damping}
            exact = exact_orbit(scene(**values))
            assert condition(exact) <= skeel(exact) <= 8 * condition(exact)
            if not values:
                assert EPSILON * skeel(exact) < ROUNDING


@pytest.mark.parametrize("order", [24, 64])
def test_it_covers_modes_that_ring_on_in_a_contact(order: int) -> None:
    """Where the change to the next orders is a tenth of the error and less."""
    case = ns.scene("beam-clearance")(modes=8, ratio=1e-4)
    orbit = ns.solve(case, "ck-tau", order)
    assert orbit.errors.times <= orbit.estimate.times <= 2 * orbit.errors.times


@pytest.mark.parametrize("order", [6, 8, 12])
@pytest.mark.parametrize("excess", [1e-3, 1e-4, 1e-5])
def test_it_covers_what_forces_that_nearly_cancel_are_rounded_by(order, excess) -> None:
    """Then a mass moves by little, and its displacement is rounded by that of a larger one."""
    case = ns.scene("dry-friction")(force=0.3 + excess)
    orbit = ns.solve(case, "c1-tau", order)
    off, found = orbit.errors, orbit.estimate
    assert off is not None
    assert off.switches <= 2 * found.switches
    assert off.discontinuous <= 2 * found.discontinuous


@pytest.mark.parametrize(("stiffness", "order"), [(112, 34), (1300, 24), (3800, 31)])
def test_it_covers_the_rounding_of_a_third_derivative(stiffness: float, order: int) -> None:
    """It is that of an acceleration, times the degree over the time: much in a short phase."""
    case = ns.scene("elastic-plastic")(stiffness=stiffness)
    orbit = ns.solve(case, "ck-tau", order)
    off, found = orbit.errors, orbit.estimate
    assert off is not None
    assert 1e-14 < off.discontinuous <= found.discontinuous <= 20 * off.discontinuous


@pytest.mark.parametrize(("mass", "order"), [(1e-4, 40), (1e-5, 20), (1e-7, 40)])
def test_it_covers_boundary_layers_that_no_order_resolves(mass: float, order: int) -> None:
    """There the next orders change little, and are as far off: once a 25th of the error."""
    case = ns.scene("dry-friction")(mass=mass, frequency=1.0)
    orbit = ns.solve(case, "ck-tau", order)
    assert orbit.errors.times <= orbit.estimate.times <= 1.1 * orbit.errors.times
