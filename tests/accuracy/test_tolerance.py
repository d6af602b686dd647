"""A tolerance is honoured, or said to be out of reach; and the choice is explained."""

import json
import math
import os

import mpmath as mp
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth.solver.shortcuts.choice import budget as budgets
from nonsmooth.solver.shortcuts.choice.budget import fitting
from nonsmooth.solver.shortcuts.choice.tolerance import cost, within
from nonsmooth.solver.shortcuts.orbit.methods import METHODS
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT

EXAMPLES = int(os.environ.get("EXAMPLES", "800"))


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


@settings(max_examples=EXAMPLES // 20)
@given(st.floats(-3, 3), st.floats(-13, -2))
def test_the_period_is_within_the_tolerance(exponent: float, digits: float) -> None:
    orbit = ns.solve(belt_at(10**exponent), tol=10**digits, many=True)
    assert true_error(orbit) <= 10**digits


@settings(max_examples=EXAMPLES // 40)
@given(st.floats(-2, 1), st.floats(-7, -1))
def test_the_acceleration_is_within_the_tolerance(exponent: float, digits: float) -> None:
    orbit = ns.solve(belt_at(10**exponent), tol_acceleration=10**digits, many=True)
    assert orbit.errors.acceleration <= 10**digits


@settings(max_examples=EXAMPLES // 60)
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
    assert last["estimate"].items() <= document["estimate"].items()


def test_the_choice_is_explained_in_80_columns(run) -> None:
    _, out, _ = run("solve", "--tol", "1e-6")
    assert "the cheapest of the candidates" in out
    assert max(map(len, out.splitlines())) <= 80


@pytest.mark.parametrize("tol", ["1e-10", "1e-14"])
def test_digits_beyond_the_table_are_shown_and_right(run, tol: str) -> None:
    _, out, _ = run("solve", "--tol", tol)
    line = next(line for line in out.splitlines() if "T = 0.67" in line)
    period = line.partition("T = ")[2].split()[0]
    assert len(period) - 2 >= round(-math.log10(float(tol)))
    exact = ns.exact(DEFAULT).period
    assert abs(float(period) - exact) <= 1.5 * 10.0 ** -(len(period) - 2)
    _, out, _ = run("solve", "--tol", "1e-8")
    assert "T = " not in out


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


@pytest.mark.parametrize("tol", [True, "1e-3", math.nan, 0])
def test_a_tolerance_of_another_kind(tol: object) -> None:
    with pytest.raises(ValueError, match="tol: got"):
        ns.solve(DEFAULT, tol=tol)  # type: ignore[arg-type]


def test_costs_rise_with_the_order() -> None:
    for method in METHODS:
        costs = [cost(method, N) for N in (1, 5, 20, 100, 256, 257, 1000)]
        assert costs == sorted(costs)


@pytest.fixture
def clock(monkeypatch) -> None:
    """Replace the clock by the costs: a solve takes as many microseconds as they say."""
    monkeypatch.setattr(budgets, "_seconds", lambda belt, name, N: 1e-6 * cost(name, N))


@pytest.mark.usefixtures("clock")
@pytest.mark.parametrize("budget", [8e-6, 20e-6, 1e-3])
def test_the_best_within_a_budget(budget: float) -> None:
    choice = fitting(DEFAULT, budget)
    fits = [t for t in choice.trials if t.seconds is not None and t.seconds <= budget]
    best = min(t.estimate.period for t in fits)
    assert choice.orbit.estimate.period == best
    assert ns.solve(DEFAULT, budget=budget).order == choice.orbit.order
    for name in METHODS:  # each is left at the first order that takes too long
        slow = [t for t in choice.trials if t.method == name and (t.seconds or 0) > budget]
        assert len(slow) <= 1


@pytest.mark.usefixtures("clock")
def test_nothing_fits(run) -> None:
    with pytest.raises(ns.TooSlow, match="fastest orbit takes"):
        ns.solve(DEFAULT, budget=1e-9)
    status, out, err = run("solve", "--budget", "0.001us")
    assert (status, out) == (1, "")
    assert "budget" in err


@pytest.mark.usefixtures("clock")
def test_a_budget_on_the_command_line(run) -> None:
    status, out, _ = run("solve", "--budget", "25us", "--json")
    document = json.loads(out)
    assert status == 0
    assert document["method"] == "c1"
    assert all(t["seconds"] is None or t["seconds"] > 0 for t in document["trials"])
    status, out, _ = run("solve", "--budget", "25 us", "--method", "hb")
    assert status == 0
    assert "candidates that" in out
    assert max(map(len, out.splitlines())) <= 80


@pytest.mark.parametrize("text", ["", "1", "ms", "-1ms", "0s", "1 m", "nan s", "1e999s", "1h"])
def test_a_time_that_is_none(run, text: str) -> None:
    status, out, err = run("solve", f"--budget={text}")
    assert (status, out) == (2, "")
    assert "expected a time like" in err


@pytest.mark.parametrize("budget", [0, -1.0, math.inf, math.nan, "1ms"])
def test_a_budget_that_is_none(budget: object) -> None:
    with pytest.raises(ValueError, match="budget: got"):
        ns.solve(DEFAULT, budget=budget)  # type: ignore[arg-type]


def test_a_budget_beside_a_tolerance(run) -> None:
    status, _, err = run("solve", "--tol", "1e-3", "--budget", "1ms")
    assert status == 2
    assert "--budget" in err
