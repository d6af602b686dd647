"""A tolerance is honoured, or said to be out of reach; and the choice is explained."""

import json
import math

import mpmath as mp
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth.solver.belt import DEFAULT
from nonsmooth.solver.methods import METHODS
from nonsmooth.solver.tolerance import cost, within


def belt_at(alpha: float) -> ns.StickSlip:
    return ns.StickSlip(
        mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
    )


def true_error(orbit: ns.Orbit) -> float:
    """Return the relative error of the period, the exact one in 40 digits."""
    with mp.workdps(40):
        alpha = mp.mpf(orbit.belt.alpha)
        exact = 2 * alpha + mp.pi + 2 * mp.atan(1 / alpha)
        return abs(float(mp.mpf(float(orbit.unknowns[-1])) / exact - 1))


@settings(max_examples=150)
@given(st.floats(-3, 3), st.floats(-13, -2))
def test_the_period_is_within_the_tolerance(exponent: float, digits: float) -> None:
    orbit = ns.solve(belt_at(10**exponent), tol=10**digits, many=True)
    assert true_error(orbit) <= 10**digits


@settings(max_examples=60)
@given(st.floats(-2, 1), st.floats(-7, -1))
def test_the_acceleration_is_within_the_tolerance(exponent: float, digits: float) -> None:
    orbit = ns.solve(belt_at(10**exponent), tol_acceleration=10**digits, many=True)
    assert orbit.errors.acceleration <= 10**digits


@settings(max_examples=40)
@given(st.sampled_from(["hb", "hb-c1"]), st.floats(-2, 0.7), st.floats(-6, -2))
def test_a_method_is_kept_to(method: str, exponent: float, digits: float) -> None:
    orbit = ns.solve(belt_at(10**exponent), method, tol=10**digits, many=True)
    assert orbit.method == method
    assert true_error(orbit) <= 10**digits


@pytest.mark.parametrize("tol", [1e-3, 1e-8, 1e-12])
def test_nothing_that_was_tried_before_is_as_good_or_dearer(tol: float) -> None:
    choice = within(DEFAULT, tol)
    *before, last = choice.trials
    assert (last.method, last.order) == (choice.orbit.method, choice.orbit.order)
    for trial in before:
        assert trial.estimate is None or trial.estimate.period > 0.9 * tol
        assert cost(trial.method, trial.order) <= cost(last.method, last.order)


def test_both_tolerances_hold_together() -> None:
    loose, both = within(DEFAULT, 1e-3), within(DEFAULT, 1e-3, 1e-4)
    assert both.orbit.estimate.acceleration <= 1e-4
    assert both.orbit.order > loose.orbit.order


@pytest.mark.parametrize(("method", "tol"), [("hb", 1e-9), (None, 1e-16), ("c1", 1e-15)])
def test_what_float64_cannot_is_said(run, method: str | None, tol: float) -> None:
    with pytest.raises(ns.NotCertified):
        ns.solve(DEFAULT, method, tol=tol)
    chosen = () if method is None else ("--method", method)
    status, out, err = run("solve", "--tol", tol, *chosen)
    assert status == 1
    assert out == ""
    assert "--digits" in err


def test_a_far_away_order_is_foretold_not_tried() -> None:
    with pytest.raises(ns.NotCertified, match="hb would need N of about 2e"):
        ns.solve(DEFAULT, "hb", tol=1e-9)


def test_the_document_has_the_trials(run) -> None:
    status, out, _ = run("solve", "--tol", "1e-6", "--json")
    document = json.loads(out)
    assert status == 0
    assert document["estimate"]["period"] <= 1e-6
    last = document["trials"][-1]
    assert (last["method"], last["order"]) == (document["method"], document["order"])
    assert last["estimate"] == document["estimate"]


def test_the_choice_is_explained_in_80_columns(run) -> None:
    _, out, _ = run("solve", "--tol", "1e-6")
    assert "the cheapest of the candidates" in out
    assert max(map(len, out.splitlines())) <= 80


@pytest.mark.parametrize("value", ["0", "-1e-3", "1", "nan", "inf", "2"])
@pytest.mark.parametrize("flag", ["--tol", "--tol-acceleration"])
def test_a_tolerance_that_is_none(run, flag: str, value: str) -> None:
    status, out, err = run("solve", f"{flag}={value}")
    assert (status, out) == (2, "")
    assert flag in err
    assert "between 0 and 1" in err


def test_an_order_beside_a_tolerance(run) -> None:
    status, _, err = run("solve", "--tol", "1e-3", "--order", "5")
    assert status == 2
    assert "--order" in err
    with pytest.raises(ValueError, match="order: got 5 beside"):
        ns.solve(DEFAULT, "c1", 5, tol=1e-3)


@pytest.mark.parametrize("arguments", [(), ("c1",)])
def test_neither_order_nor_tolerance(arguments: tuple[str, ...]) -> None:
    with pytest.raises(ValueError, match="got None"):
        ns.solve(DEFAULT, *arguments)


@pytest.mark.parametrize("tol", [True, "1e-3", math.nan, 0])
def test_a_tolerance_of_another_kind(tol: object) -> None:
    with pytest.raises(ValueError, match="tol: got"):
        ns.solve(DEFAULT, tol=tol)  # type: ignore[arg-type]


def test_costs_rise_with_the_order() -> None:
    for method in METHODS:
        costs = [cost(method, N) for N in (1, 5, 20, 100, 256, 257, 1000)]
        assert costs == sorted(costs)
