"""Solutions of 3.2 along the duration of stick, round their folds; several C1 functions."""

import os
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT
from nonsmooth.solver.shortcuts.search import continuation, kernels
from nonsmooth.solver.shortcuts.search.newton import newton
from nonsmooth.solver.shortcuts.search.start import cubic_slip, rough_times

EXAMPLES = int(os.environ.get("EXAMPLES", "1200")) // 12
KERNEL = kernels.compiled("hb-symmetric")


def oscillator(alpha: float) -> ns.StickSlip:
    return replace(DEFAULT, normal_force=400 * alpha)


def solution(alpha: float, terms: int, order: int) -> np.ndarray:
    start = cubic_slip(KERNEL, terms, order, *rough_times(alpha))
    outcome = newton(KERNEL.iterate, (alpha, terms), start)
    assert outcome.converged
    return outcome.unknowns


def along_t1(terms: int, order: int, last: float) -> list[np.ndarray]:
    curve = [solution(1.0, terms, order)]
    while curve[-1][-2] < last:
        ahead, _ = continuation.with_stick(KERNEL, terms, curve[-1], 1.02 * curve[-1][-2])
        assert ahead is not None
        curve.append(ahead)
    return curve


@pytest.mark.parametrize(
    ("order", "last", "turns"),
    [(7, 150.0, (8.581, 8.519)), (17, 150.0, (21.86, 17.72)), (40, 400.0, (59.95, 29.30))],
)
def test_the_curve_of_solutions_folds(
    order: int, last: float, turns: tuple[float, float]
) -> None:
    curve = along_t1(1, order, last)
    alphas = np.array([continuation.alpha_of(KERNEL, 1, z) for z in curve])
    rises = np.diff(alphas) > 0
    found = [alphas[i + 1] for i in range(len(rises) - 1) if rises[i] != rises[i + 1]]
    np.testing.assert_allclose(found, turns, rtol=3e-4)  # strides of 2 %, at a maximum


def test_every_point_of_the_curve_solves_all_equations() -> None:
    for z in along_t1(1, 7, 40.0)[::10]:
        R = np.empty(len(z))
        KERNEL.residual((continuation.alpha_of(KERNEL, 1, z), 1), z, R)
        assert np.abs(R).max() < 1e-5 * np.abs(z).max()


@pytest.mark.parametrize("terms", [1, 3])
@pytest.mark.parametrize("alpha", [0.05, 0.5, 3.0, 12.0])
def test_it_leads_to_the_solution_that_newton_finds(terms: int, alpha: float) -> None:
    near, iterations = continuation.follow(KERNEL, terms, solution(1.0, terms, 20), alpha)
    np.testing.assert_allclose(near[-2:], solution(alpha, terms, 20)[-2:], rtol=1e-3)
    assert 0 < iterations <= continuation.MOST_ITERATIONS + continuation.MOST_CORRECTIONS


def test_a_stride_that_changes_slip_too_much_is_refused(monkeypatch) -> None:
    """It would end on the same curve or on another: who knows."""
    z = solution(1.0, 1, 7)
    assert continuation.with_stick(KERNEL, 1, z, 1.5 * z[-2]) == (None, 1)
    monkeypatch.setattr(continuation, "SAME_CURVE", 1e9)
    ahead, _ = continuation.with_stick(KERNEL, 1, z, 1.5 * z[-2])
    assert ahead is not None


def test_corrections_that_do_not_contract_are_given_up(monkeypatch) -> None:
    monkeypatch.setattr(continuation, "SAME_CURVE", 1e9)
    z = solution(1.0, 1, 7)
    ahead, iterations = continuation.with_stick(KERNEL, 1, z, 3 * z[-2])
    assert ahead is None
    assert iterations == 3


def test_where_the_way_ends_it_says_so_by_where_it_is() -> None:
    near, _ = continuation.follow(KERNEL, 0, solution(1.0, 0, 5), 1000.0)
    assert not 0.9 < continuation.alpha_of(KERNEL, 0, near) / 1000.0 < 1.1


# Beyond the fold, where nothing but the way round it leads.
@pytest.mark.parametrize(("order", "force"), [(7, 3445.0), (7, 3465.0), (13, 7113.0)])
def test_beyond_the_fold_is_a_solution_and_its_error_is_said(order: int, force: float) -> None:
    orbit = ns.solve(replace(DEFAULT, normal_force=force), "hb-c1", order, many=True)
    assert 0.1 < orbit.errors.period < 0.6
    assert orbit.estimate.period == pytest.approx(orbit.errors.period, rel=0.01)


def test_beyond_the_fold_what_is_no_orbit_is_called_so() -> None:
    with pytest.raises(ns.NoOrbit) as caught:
        ns.solve(oscillator(70.0), "hb-c1", 40, many=True)
    assert caught.value.tried[-1].startswith("by continuation of t1 from alpha = 1: a solution")
    assert "mean velocity in stick" in caught.value.tried[-1]


@settings(max_examples=EXAMPLES)
@given(
    st.integers(2, 6),
    st.integers(1, 40),
    st.floats(np.log(0.01), np.log(4.0)).map(np.exp),
)
def test_several_functions_are_found(terms: int, order: int, alpha: float) -> None:
    orbit = ns.solve(oscillator(alpha), "hb-c1", order, c1_terms=terms, many=True)
    assert abs(orbit.errors.period) <= 2 * orbit.estimate.period
    assert abs(orbit.errors.period) < 0.01  # the largest of 4000 was 0.004, with K = 2


def test_it_is_not_tried_where_it_does_not_lead() -> None:
    with pytest.raises(ns.NoOrbit) as caught:
        ns.solve(oscillator(1e6), "hb-c1", 20)
    assert not any("by t1" in text for text in caught.value.tried)
