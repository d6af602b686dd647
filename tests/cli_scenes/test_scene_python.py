"""Scenes from Python: one `solve`, `sweep` and `exact` for every oscillator."""

from dataclasses import replace

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.solver.accuracy.estimate import MORE, MOST, estimate
from nonsmooth.solver.accuracy.rates import FLOORS, rate
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.orbit.solution import attempt
from nonsmooth.solver.results.orbit import Orbit
from nonsmooth.solver.solve import solve_case

IMPACT = registry.load("impact")


def test_the_module_and_the_function_are_one() -> None:
    import nonsmooth.scene as module
    from nonsmooth import codegen

    assert ns.scene is module
    assert module("impact") == module.find("impact") == IMPACT
    assert module.Parameter is codegen.scene.Parameter
    with pytest.raises(AttributeError, match="nothing"):
        _ = module.nothing
    assert all(getattr(module, name) is not None for name in module.__all__)


def test_solve_of_a_case() -> None:
    case = IMPACT(gap=0.2)
    orbit = ns.solve(case, method="ck-tau", order=8)
    assert isinstance(orbit, ns.Orbit)
    assert orbit.unknowns.tolist() == solve_case(case, "ck-tau", 8).unknowns.tolist()
    assert ns.solve(case).method == "ck-tau"
    assert ns.solve(case).order == 10
    assert ns.solve(case, "hb-c0", 4).functions == 2
    assert ns.solve(case, "hb-c0", 4, functions=3).functions == 3


def test_solve_to_a_tolerance() -> None:
    case = IMPACT()
    orbit = ns.solve(case, tol=1e-6)
    assert orbit.estimate.times <= 1e-6 < ns.solve(case, order=orbit.order - 1).estimate.times
    by_ck = ns.solve(case, "ck", tol=1e-6)
    assert by_ck.method == "ck"
    assert by_ck.order > orbit.order
    free = ns.solve(registry.load("stick-slip-damped")(), tol=1e-5)
    assert max(free.estimate.times, free.estimate.period) <= 1e-5
    with pytest.raises(ns.NotCertified, match="2e-15") as caught:
        ns.solve(case, tol=1e-15)
    assert not caught.value.tried
    with pytest.raises(ns.NotCertified, match=r"best tried was .* by hb, N = "):
        ns.solve(case, "hb", tol=1e-8)
    with pytest.raises(ns.NoOrbit):
        ns.solve(IMPACT(gap=5), tol=1e-2)


def test_a_tolerance_between_orders_that_are_tried_is_met_by_the_lowest() -> None:
    case = IMPACT()
    tol = 1.05 * ns.solve(case, "hb", 26).estimate.times / 0.9
    orbit = ns.solve(case, "hb", tol=tol)
    assert orbit.order in (25, 26)
    assert ns.solve(case, "hb", orbit.order - 1).estimate.times > 0.9 * tol


def test_orders_are_whole_numbers_of_any_type() -> None:
    rows = ns.sweep(IMPACT(), orders=np.arange(2, 4)).rows
    assert rows == tuple(
        replace(a, seconds=b.seconds)
        for a, b in zip(ns.sweep(IMPACT(), orders=[2, 3]).rows, rows, strict=True)
    )


def test_sweeps() -> None:
    case, told = IMPACT(), []
    result = ns.sweep(case, orders=[2, 4], progress=told.append)
    assert tuple(told) == result.rows
    found = [(row.method, row.order) for row in result.rows]
    assert found == [(name, N) for name in ("hb", "hb-ck", "ck", "ck-tau") for N in (2, 4)]
    assert [row.order for row in result.of("c0-tau")] == [2, 4]
    row = result.of("hb")[1]
    orbit = ns.solve(case, "hb", 4)
    assert (row.period, row.durations) == (orbit.period, orbit.durations)
    assert row.errors == orbit.errors
    assert row.estimate == orbit.estimate
    assert "c0-tau      2  not-converged: impact" in str(result)
    assert "<pre>method" in result._repr_html_()
    with pytest.raises(ValueError, match="order: got 1, expected a whole number from 2"):
        ns.sweep(case, "ck", [1])
    with pytest.raises(ValueError, match="method"):
        ns.sweep(case, "c2", [4])
    assert (
        ns.sweep(case, "hb-ck", [3], functions=3).rows[0].errors
        == ns.solve(case, "hb-ck", 3, functions=3).errors
    )


def test_sweeps_of_several_motions_check_their_arguments_first(monkeypatch) -> None:
    monkeypatch.setattr("nonsmooth.solver.sweep.with_motion", None)
    for methods, orders in ((["ck-taw"], [4]), (["hb"], [4, 0]), (None, [0])):
        with pytest.raises(ValueError, match=r"(method|order): got ('ck-taw'|0), expected"):
            ns.sweep(ns.scene("dry-friction")(), methods, orders)


def test_rates_are_least_squares_over_six_orders_above_rounding() -> None:
    def rows(error, orders):
        return [(N, dict.fromkeys(FLOORS, error(N))) for N in orders]

    power = rate("hb-ck", rows(lambda N: 3.0 * N**-2.5, range(2, 8)))
    assert (power.kind, power.times) == ("power", pytest.approx(2.5))
    assert power.text("discontinuous") == "N^-2.500"
    assert rate("hb", rows(lambda N: 1 / N, range(2, 7))).text("times") == "too few orders"
    geometric = rate("ck-tau", rows(lambda N: 10.0 ** (-1.5 * N), range(1, 20)))
    assert geometric.kind == "geometric"
    assert geometric.times == pytest.approx(1.5)
    assert geometric.text("times") == "10^(-1.50 N)"
    assert rate("ck", rows(lambda N: 1e-14, range(1, 20))).times is None


def test_the_estimate_of_a_high_order_is_cheap_and_right(monkeypatch) -> None:
    """It solves two systems of the better method, of an order that does not grow with N."""
    orbit = solve_case(IMPACT(), "hb", 100)
    solved: list[Orbit] = []

    def counted(*arguments):
        solved.append(attempt(*arguments))
        return solved[-1]

    monkeypatch.setattr("nonsmooth.solver.accuracy.estimate.attempt", counted)
    found = estimate(replace(orbit))
    assert [each.order for each in solved] == [MOST, MOST + MORE]
    assert sum(each.outcome.iterations for each in solved) <= 10
    assert found.times == pytest.approx(orbit.errors.times, rel=1e-6)


def test_an_orbit_shows_itself() -> None:
    orbit = ns.solve(IMPACT(), "ck-tau", 6)
    html = orbit._repr_html_()
    for words in ("impact: a driven mass", "c0-tau, N = 6", f"{orbit.period:.10g} s", "rad"):
        assert words in html
    assert html.startswith("<table>")
    belt = ns.solve(registry.load("stick-slip-damped")(), order=6)
    assert "stick 0." in belt._repr_html_()
    assert "forcing" not in belt._repr_html_()
