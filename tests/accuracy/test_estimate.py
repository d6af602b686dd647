"""The estimated error against the true one: calibration, rounding, nothing known."""

import json
import math
import os
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth.solver.accuracy.estimate import EPSILON, ROUNDING
from nonsmooth.solver.accuracy.skeel import condition as skeel
from nonsmooth.solver.case import registry
from nonsmooth.solver.case.case import Case
from nonsmooth.solver.flow import one_phase
from nonsmooth.solver.flow.exact import exact_orbit
from nonsmooth.solver.flow.exact_motion import from_times
from nonsmooth.solver.flow.exact_system import exact_kernel
from nonsmooth.solver.iteration.attempt import attempt
from nonsmooth.solver.iteration.start import RoughTimes
from nonsmooth.solver.orbit.orbit import SceneOrbit
from nonsmooth.solver.precision import exact_balls
from nonsmooth.solver.precision.condition import condition
from nonsmooth.solver.precision.refine import refine
from nonsmooth.solver.shortcuts.accuracy import estimate
from nonsmooth.solver.shortcuts.accuracy.estimate import Estimate, _sines
from nonsmooth.solver.shortcuts.orbit import exact
from nonsmooth.solver.shortcuts.orbit.methods import METHODS
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT
from nonsmooth.solver.shortcuts.search import kernels
from nonsmooth.solver.shortcuts.search.newton import newton
from nonsmooth.solver.shortcuts.search.start import rough_times, with_coefficients

EXAMPLES = int(os.environ.get("EXAMPLES", "1200")) // 20


def belt_at(alpha: float) -> ns.StickSlip:
    return ns.StickSlip(
        mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
    )


def rounding(orbit: ns.Orbit) -> Estimate:
    """Return errors below which rounding decides, not the method."""
    t1, T = orbit.unknowns[-2:]
    return Estimate(1e-14, 1e-14 * T / t1, 2e-7 * math.sqrt(T / (T - t1)))


orders = {
    "hb": st.one_of(st.integers(1, 60), st.integers(61, 600)),
    "hb-c1": st.one_of(st.integers(1, 60), st.integers(61, 600)),
    "c1": st.integers(1, 40),
}


@pytest.mark.parametrize("method", METHODS)
def test_the_estimate_is_at_least_half_and_at_most_20_times_the_error(method: str) -> None:
    """Measured on 1034 orbits: 1.0 to 1.6 (period), 0.97 to 1.3 (t1), 1.0 to 1.1 (22)."""
    seen = []

    @settings(max_examples=EXAMPLES // 3)
    @given(st.floats(-3, 3), orders[method])
    def run(exponent: float, order: int) -> None:
        try:
            orbit = ns.solve(belt_at(10**exponent), method, order, many=True)
        except ns.NoOrbit:
            return
        seen.append(order)
        floor = rounding(orbit)
        for name in ("period", "t1", "acceleration"):
            error, estimated = abs(getattr(orbit.errors, name)), getattr(orbit.estimate, name)
            assert estimated >= 0.5 * error
            if error > getattr(floor, name):
                assert estimated <= 20 * error
            else:
                assert estimated <= 20 * getattr(floor, name)

    run()
    assert len(seen) >= 0.5 * (EXAMPLES // 3)


@pytest.mark.parametrize("method", ["hb", "hb-c1"])
def test_what_the_better_orbit_may_be_off_by_is_added(monkeypatch, method: str) -> None:
    """As if the series had converged at order 5: it is off by 5.46e-5 there."""
    monkeypatch.setattr(estimate, "CONVERGED_ORDER", 1)
    orbit = ns.solve(DEFAULT, method, 40)
    near, beyond = (ns.solve(DEFAULT, "c1", order) for order in (5, 9))
    change = np.abs(orbit.unknowns[-2:] - near.unknowns[-2:])
    doubt = np.abs(beyond.unknowns[-2:] - near.unknowns[-2:])
    t1, T = near.unknowns[-2:]
    assert orbit.estimate.t1 == pytest.approx((change + doubt)[0] / t1, rel=1e-9)
    assert orbit.estimate.period == pytest.approx((change + doubt)[1] / T, rel=1e-9)


def test_an_error_like_that_of_the_better_orbit_is_seen(monkeypatch) -> None:
    """Both are off to the same side, by 9.3e-5 and 5.5e-5: their difference says too little."""
    monkeypatch.setattr(estimate, "CONVERGED_ORDER", 1)
    orbit = ns.solve(DEFAULT, "hb-c1", 8)
    assert orbit.errors.period == pytest.approx(9.3e-5, rel=0.01)
    assert 0.99 * orbit.errors.period <= orbit.estimate.period <= 1.1 * orbit.errors.period


@pytest.mark.parametrize("method", ["hb", "hb-c1"])
def test_the_estimate_holds_for_very_many_harmonics(method: str) -> None:
    orbit = ns.solve(DEFAULT, method, 5000)
    for name in ("period", "t1", "acceleration"):
        error, estimated = abs(getattr(orbit.errors, name)), getattr(orbit.estimate, name)
        assert 0.9 * error <= estimated <= 1.2 * error + 1e-14


@pytest.mark.parametrize(("method", "order"), [("hb", 9), ("hb-c1", 9), ("c1", 9)])
def test_what_newton_left_and_rounding_are_added(method: str, order: int) -> None:
    """The last correction says how large the rounding errors are; four of them count."""
    outcome = ns.solve(DEFAULT, method, order).outcome
    least = []
    for correction in (0.0, 1e-6):
        left = replace(outcome, correction=correction)
        least.append(estimate.estimate(METHODS[method], order, 1.0, left))
    assert least[1].period - least[0].period == pytest.approx(4e-6, rel=0.01)
    T, t1 = exact.times(1.0)[1], 2.0
    assert least[1].t1 - least[0].t1 == pytest.approx(4e-6 * T / t1, rel=0.01)


@pytest.mark.parametrize(("order", "alpha"), [(1, 1e-3), (2, 1e-3), (6, 1e-3), (10, 1e-3)])
def test_a_spurious_solution_is_no_better_orbit(order: int, alpha: float) -> None:
    """The rough start leads to one whose stick is much too long or too short."""
    kernel = kernels.compiled("c1")
    start = with_coefficients(kernel, alpha, order, *rough_times(alpha))
    found = newton(kernel.iterate, alpha, start)
    assert found.converged
    assert abs(found.unknowns[-2] / (2 * alpha) - 1) > 1 / (2 * order)
    assert estimate._c1_orbit(alpha, order) is None


def test_a_second_turn_is_no_better_orbit(monkeypatch) -> None:
    """Its stick is right, and its slip lasts 2 pi longer."""

    def later(alpha: float) -> tuple[float, float]:
        t1, T = rough_times(alpha)
        return t1, T + 2 * math.pi

    alpha, kernel = 1.0009765625, kernels.compiled("c1")
    found = newton(kernel.iterate, alpha, with_coefficients(kernel, alpha, 30, *later(alpha)))
    t1, T = exact.times(alpha)
    assert found.converged
    assert found.unknowns[-2:] == pytest.approx([t1, T + 2 * math.pi], rel=1e-9)
    estimate._c1_orbit.cache_clear()
    monkeypatch.setattr(estimate, "rough_times", later)
    assert estimate._c1_orbit(alpha, 30) is None
    estimate._c1_orbit.cache_clear()


@pytest.mark.parametrize(("method", "order"), [("hb", 5), ("hb-c1", 5), ("c1", 9)])
def test_where_no_better_orbit_is_found_nothing_is_claimed(
    monkeypatch, run, method: str, order: int
) -> None:
    monkeypatch.setattr(estimate, "_c1_orbit", lambda alpha, order: None)
    assert ns.solve(DEFAULT, method, order).estimate.period == math.inf
    _, out, _ = run("solve", "--method", method, "--order", order, "--json")
    document = json.loads(out)
    assert document["admissible"] is True
    assert set(document["estimate"].values()) == {None}
    assert {"period", "t1", "acceleration", "times"} <= set(document["estimate"])


@pytest.mark.parametrize("order", [399, 400])
def test_the_highest_order_has_an_estimate(order: int) -> None:
    assert ns.solve(DEFAULT, "c1", order, many=True).estimate.period < 1e-14


def test_sines_of_a_c1_series_are_its_harmonics() -> None:
    orbit = ns.solve(DEFAULT, "c1", 24)
    z, (t1, T) = orbit.unknowns, orbit.unknowns[-2:]
    tau = T * np.arange(4096) / 4096
    t = np.mod(tau + t1 / 2, T)
    acceleration = METHODS["c1"].evaluate(z, 24, t, 2, 1.0)
    expected = -np.fft.rfft(acceleration)[1:6].imag / 2048
    np.testing.assert_allclose(_sines(z, 5), expected, atol=1e-3)  # it jumps: 1/4096


def test_rows_and_csv_have_the_estimate(run, tmp_path) -> None:
    target = tmp_path / "rows.csv"
    status, out, _ = run("sweep", "--methods", "c1", "--orders", "5,9", "-o", target, "--json")
    assert status == 0
    row = json.loads(out)["rows"][0]
    assert row["estimate"]["period"] == pytest.approx(5.46e-5, rel=0.1)
    header, first, _ = target.read_text().splitlines()
    values = dict(zip(header.split(","), first.split(","), strict=True))
    assert float(values["estimate_period"]) == row["estimate"]["period"]


IMPACT = registry.load("impact")
NAMES = ("mass", "damping", "stiffness", "force", "frequency", "gap", "restitution")


def solutions(case: Case) -> list[float]:
    """Return the phase of the forcing of each impact once a period, in closed form."""
    return [angle for _, speed, angle in one_phase.solutions(case.cell).found if speed < 0]


def orbits(case: Case, order: int) -> list[SceneOrbit]:
    """Return the orbits of one impact a period by `ck-tau`, each from its exact times."""
    kernel = registry.quicker_kernel(case.scene, "ck-tau", None, order)
    starts = [RoughTimes((case.cell.duration,), angle, "") for angle in solutions(case)]
    exact = [from_times(case, start) for start in starts]
    found = [attempt(kernel, case, order, q.times) for q in exact if q.admissible]
    return [orbit for orbit in found if orbit.converged and orbit.exact is not None]


def error_of(orbit: SceneOrbit) -> float:
    """Return the largest error of a time against 40 digits, as a part of the period."""
    case, kernel = orbit.case, exact_kernel(orbit.case.cell)
    near = orbit.exact.outcome.unknowns
    times = refine(kernel, case.cell, near, 40, lambda: exact_balls.residual).times
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
        assert orbit.estimate.times <= 20 * EPSILON * condition(orbit.exact)


def near_folds(count: int, seed: int) -> Iterator[SceneOrbit]:
    """Yield orbits at random distances from folds, which bisection finds in closed form."""
    rng = np.random.default_rng(seed)
    while count:
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


def test_where_nothing_is_ill_conditioned_the_least_rounding_counts() -> None:
    """Skeel's number is above that by the parameters, found by differences, and not far."""
    for scene in map(registry.load, registry.names()):
        for damping in (None, 1e-3):
            values = {} if damping is None or scene.frequency is None else {"damping": damping}
            exact = exact_orbit(scene(**values))
            assert condition(exact) <= skeel(exact) <= 8 * condition(exact)
            if not values:
                assert EPSILON * skeel(exact) < ROUNDING
