"""Digits at the extremes, for random oscillators, against the high-precision twin.

``EXAMPLES`` in the environment sets how many; `make test-long` asks for 100,000.
"""

import json
import math
import os
import warnings

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.shortcuts.orbit import exact

pytest.importorskip("flint")

from nonsmooth.shortcuts.digits import MOST_ITERATIONS, TARGETS, lowest_order
from nonsmooth.shortcuts.twin import refine

EXAMPLES = int(os.environ.get("EXAMPLES", "300"))
#: Parts of the examples: the Fourier series cost the twin a hundred times as much.
SHARES = {"c1": 0.8, "hb": 0.15, "hb-c1": 0.05}


def log_uniform(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(math.log10(low), math.log10(high)).map(lambda exponent: 10.0**exponent)


@st.composite
def belts(draw: st.DrawFn, low: float, high: float) -> ns.StickSlip:
    """Return an oscillator with alpha in a range, in units a trillion times apart."""
    alpha = draw(log_uniform(low, high))
    kg, m, s = (draw(log_uniform(1e-12, 1e12)) for _ in range(3))
    mu_s = draw(log_uniform(1e-3, 1e3))
    closeness = draw(st.one_of(st.just(1.0), log_uniform(1e-9, 1)))
    mu_k = mu_s * (1 - closeness)
    mass, stiffness, speed = kg, kg / s / s, m / s
    force = alpha * (stiffness * mass) ** 0.5 * speed / (mu_s - mu_k)
    return ns.StickSlip(
        mass=mass,
        stiffness=stiffness,
        belt_speed=speed,
        mu_s=mu_s,
        mu_k=mu_k,
        normal_force=force,
    )


def found_or_proven_absent(belt: ns.StickSlip, method: str, order: int) -> ns.Orbit | None:
    """Return the orbit, or None where it is shown that there is none."""
    try:
        return ns.solve(belt, method, order, many=True)
    except NoOrbit as finding:
        if not finding.proven:
            raise
        return None


def check(belt: ns.StickSlip, method: str, order: int) -> bool:
    """Solve without a warning, and compare with the twin; or accept a proven absence.

    Returns whether there was an orbit.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        orbit = found_or_proven_absent(belt, method, order)
    if orbit is None:
        return False
    assert orbit.admissible
    assert orbit.iterations <= MOST_ITERATIONS
    twin = refine(method, belt.alpha, orbit.unknowns, 22)
    t1, T = orbit.unknowns[-2:]
    error = max(abs(float(twin.t1 - t1)), abs(float(twin.T - T))) / float(twin.T)
    assert error <= TARGETS[method]
    exact_t1, _ = exact.times(belt.alpha)
    # Not another root: pure slip has t1 = 0, a second turn has T larger by 2 pi.
    assert 0.05 * exact_t1 < t1 < 2 * exact_t1
    assert T - t1 < 2 * math.pi * 1.3
    return True


def test_c1_keeps_thirteen_digits() -> None:
    examples, seen = round(EXAMPLES * SHARES["c1"]), []

    @settings(max_examples=examples)
    @given(belts(1e-6, 1e6), st.integers(1, 60))
    def run(belt: ns.StickSlip, order: int) -> None:
        seen.append(check(belt, "c1", order))

    run()
    assert sum(seen) >= 0.7 * examples


@pytest.mark.parametrize("method", ["hb", "hb-c1"])
def test_fourier_series_keep_twelve_digits(method: str) -> None:
    """From this order on there is always an orbit."""

    @settings(max_examples=round(EXAMPLES * SHARES[method]))
    @given(belts(1e-2, 30), log_uniform(1, 10))
    def run(belt: ns.StickSlip, factor: float) -> None:
        lowest = lowest_order(method, belt.alpha)
        assert check(belt, method, min(round(lowest * factor), max(60, lowest)))

    run()


@pytest.mark.parametrize(
    ("method", "alpha"),
    [
        *(
            pytest.param(method, alpha, marks=pytest.mark.long)
            for method in ("hb", "hb-c1")
            for alpha in (0.01, 1.0)
        ),
        *(("hb", 30.0), ("hb-c1", 30.0)),
    ],
)
def test_order_200_keeps_twelve_digits(method: str, alpha: float) -> None:
    belt = ns.StickSlip(
        mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
    )
    assert check(belt, method, 200)


@pytest.mark.parametrize("method", ["hb", "hb-c1", "c1"])
@pytest.mark.parametrize(
    ("mass", "stiffness"), [(1e-300, 1e300), (1e300, 1e-300), (1e-12, 1e12), (1e12, 1e-12)]
)
def test_results_beyond_float64_are_infinite_and_null_not_errors(
    method: str, mass: float, stiffness: float, run
) -> None:
    belt = ns.StickSlip(
        mass=mass, stiffness=stiffness, belt_speed=1, mu_s=0.5, mu_k=0.25, normal_force=4
    )
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        orbit = ns.solve(belt, method, 40)
        found = orbit.coefficients
        values = orbit.displacement([0.0, orbit.t1 / 2]), orbit.acceleration(orbit.t1)
        status, out, _ = run(
            *("solve", "--method", method, "--order", 40, "--json"),
            *(f"--mass={mass}", f"--stiffness={stiffness}", "--normal-force=4"),
        )
    assert status == 0
    assert np.isfinite(np.concatenate([np.ravel(v) for v in values])).all()
    written = json.loads(out)["coefficients"]
    assert written.keys() == found.keys()
    if method == "c1":
        beyond = [not math.isfinite(d) for d in found["d"]]
        assert any(beyond) == (mass < stiffness and mass < 1e-5)
        assert [d is None for d in written["d"]] == beyond


def test_any_parameters_are_refused_or_survived() -> None:
    """All of float64: an error that names the parameters, or results without a warning."""
    ends = {"refused": 0, "no orbit": 0, "orbit": 0}

    @settings(max_examples=150)
    @given(
        st.tuples(*(log_uniform(1e-200, 1e200) for _ in range(4))),
        log_uniform(1e-9, 1e9),
        st.sampled_from([0.0, 0.5, 1 - 1e-9]),
        st.sampled_from([("c1", 9), ("c1", 25), ("hb", 5), ("hb-c1", 5)]),
    )
    @example((1.0, 1.0, 1.0, 1.0), 1e-6, 0.5, ("c1", 9))  # the three of which no orbit is
    @example((1.0, 1.0, 1.0, 1.0), 1e6, 0.5, ("hb", 5))  # known, whatever else is drawn
    @example((1.0, 1.0, 1.0, 1.0), 1e6, 0.5, ("hb-c1", 5))
    def run(sizes: tuple[float, ...], alpha: float, part: float, job: tuple[str, int]) -> None:
        mass, stiffness, speed, mu_s = sizes
        force = alpha * math.sqrt(mass) * math.sqrt(stiffness) * speed / (mu_s * (1 - part))
        try:
            belt = ns.StickSlip(
                mass=mass,
                stiffness=stiffness,
                belt_speed=speed,
                mu_s=mu_s,
                mu_k=part * mu_s,
                normal_force=force,
            )
            orbit = ns.solve(belt, *job, many=True)
        except ns.ParameterError:
            ends["refused"] += 1
            return
        except NoOrbit:
            ends["no orbit"] += 1
            return
        ends["orbit"] += 1
        assert np.isfinite(orbit.acceleration([0.0, orbit.t1, 0.9 * orbit.period])).all()
        assert np.isfinite([orbit.transition_mismatch, orbit.errors.period]).all()
        assert orbit.coefficients

    with warnings.catch_warnings():
        warnings.simplefilter("error")
        run()
    assert ends["orbit"] >= 75
    assert min(ends.values()) >= 3, ends


@pytest.mark.parametrize("power", range(-12, 13, 4))
@pytest.mark.parametrize("method", ["hb", "hb-c1", "c1"])
def test_units_change_no_more_than_the_last_two_digits(method: str, power: int) -> None:
    """Each of mass, stiffness, speed, force by powers of ten, with alpha as it is."""
    reference = ns.solve(ns.StickSlip(
        mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2
    ), method, 12)  # fmt: skip
    scale = 10.0**power
    for mass, stiffness, speed, force in (
        (scale, scale, 1.0, scale),
        (1.0, 1.0, scale, scale),
        (scale, 1 / scale, 1.0, 1.0),
        (1 / scale, scale, scale, scale),
    ):
        belt = ns.StickSlip(
            mass=mass,
            stiffness=stiffness,
            belt_speed=speed,
            mu_s=1,
            mu_k=0.5,
            normal_force=2 * force,
        )
        assert belt.alpha == pytest.approx(1, rel=3e-16)
        orbit = ns.solve(belt, method, 12)
        # Two last digits: alpha itself may differ by two roundings.
        assert orbit.unknowns[-1] == pytest.approx(reference.unknowns[-1], rel=1e-14)
        assert orbit.unknowns[-2] == pytest.approx(reference.unknowns[-2], rel=1e-14)
        assert orbit.errors.period == pytest.approx(reference.errors.period, abs=1e-14)
