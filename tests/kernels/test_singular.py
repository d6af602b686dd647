"""Orbits at which the equations of a method are singular: those of functions of class C^1."""

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.solver import search
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.kernels.start import is_reversible, is_singular
from nonsmooth.solver.orbit.solution import attempt
from nonsmooth.solver.trade import tolerance

CLEARANCE, BACKLASH = registry.load("clearance"), registry.load("backlash")
UNDAMPED = CLEARANCE(damping=0)


@pytest.fixture(scope="module")
def orbit():
    return ns.solve(UNDAMPED, method="ck-tau", order=10)


def test_an_orbit_that_is_its_own_reflection_is_found_to_all_digits(orbit):
    assert (orbit.method, orbit.label) == ("c1-tau", "c1-tau, N = 10")
    assert orbit.admissible
    assert orbit.errors.times < 1e-14
    assert orbit.estimate.times < 1e-13
    exact = ns.exact(UNDAMPED)
    assert orbit.period == pytest.approx(exact.period, rel=1e-12)
    np.testing.assert_allclose(orbit.durations, exact.durations, rtol=1e-12)
    assert orbit.as_dict()["method"] == "c1-tau"
    assert orbit.look == ns.solve(CLEARANCE(), method="ck-tau", order=5).look


@pytest.mark.parametrize("values", [{"gap": 0.1, "frequency": 0.8}, {"gap": -0.3}])
def test_at_orders_of_both_parities(values):
    case = CLEARANCE(damping=0, **values)
    for order in (10, 11):
        found = ns.solve(case, method="ck-tau", order=order)
        assert (found.method, found.order) == ("c1-tau", order)
        assert found.errors.times < 1e-12


def test_where_the_smoother_functions_are_regular_they_are_taken():
    for case in (BACKLASH(damping=0), CLEARANCE(damping=1e-4), CLEARANCE()):
        found = ns.solve(case, method="ck-tau", order=11)
        assert found.method == "ck-tau"
        assert found.errors.times < 1e-12


def test_what_is_singular(orbit):
    kernel = registry.kernel(CLEARANCE, "ck-tau")
    times = kernel.times(orbit.unknowns)
    for order in (7, 10):
        assert is_singular(kernel, UNDAMPED, order, times)
        assert not is_singular(kernel, CLEARANCE(damping=1e-6), order, times)
        assert not is_singular(registry.kernel(CLEARANCE, "c1-tau"), UNDAMPED, order, times)
    assert not is_singular(
        kernel, UNDAMPED, 5, np.add(times, [0.1, -0.3, 0.2])
    )  # no reflection


def test_what_may_run_backwards():
    assert is_reversible(UNDAMPED.cell)
    assert is_reversible(BACKLASH(damping=0).cell)
    assert not is_reversible(CLEARANCE().cell)
    assert not is_reversible(registry.load("elastic-plastic")(damping=0).cell)
    assert not is_reversible(registry.load("impact")(damping=0).cell)
    assert not is_reversible(registry.load("impact")(damping=0, restitution=1).cell)


def test_other_methods_are_judged_by_it_and_need_no_long_search():
    found = ns.solve(UNDAMPED, method="hb", order=10)
    assert found.iterations < 50  # from a coarse orbit of class C^1; 1054 without one
    assert found.estimate.times == pytest.approx(found.errors.times, rel=1e-3)


def test_the_name_is_one_of_a_method(orbit):
    assert ns.solve(CLEARANCE(), method="c1-tau", order=12).errors.times < 1e-14
    assert registry.class_one(CLEARANCE, "ck-tau") == "c1-tau"
    assert registry.class_one(CLEARANCE, "ck") is None
    assert registry.class_one(registry.load("impact"), "ck-tau") is None
    assert registry.generic_method(registry.load("dry-friction"), "c1-tau") == "ck-tau"
    for scene, method in (("impact", "c1-tau"), ("clearance", "c1"), ("clearance", "hb-c1")):
        with pytest.raises(ValueError, match=f"method: got '{method}', expected one of ck"):
            registry.generic_method(registry.load(scene), method)


def test_sweeps_say_which_functions_they_have(orbit, tmp_path):
    sweep = ns.sweep(UNDAMPED, methods=("ck-tau",), orders=(6, 8))
    assert [(row.method, row.order, row.status) for row in sweep] == [
        ("c1-tau", 6, "ok"), ("c1-tau", 8, "ok"),
    ]  # fmt: skip
    assert sweep[1].errors.times < 1e-4 * sweep[0].errors.times
    for kept in (sweep, orbit):
        ns.save(kept, tmp_path / "kept.json")
        again = ns.load(tmp_path / "kept.json")
        assert again.as_dict() == kept.as_dict()
    search = tolerance._Search(UNDAMPED, 1e-10, "ck-tau", None, [])
    assert search.meets(6).method == "c1-tau"
    assert search.trials[0].method == "c1-tau"


def test_without_them_it_is_said_that_there_is_an_exact_orbit(monkeypatch):
    monkeypatch.setattr(search.registry, "class_one", lambda scene, method: None)
    with pytest.raises(ns.NoOrbit, match=r"an exact orbit.*; a higher order may have it"):
        ns.solve(UNDAMPED, method="ck-tau", order=10)


def test_what_fails_where_nothing_is_singular_is_not_replaced():
    case, kernel = CLEARANCE(), registry.kernel(CLEARANCE, "ck-tau")
    times = ns.exact(case).times
    far = attempt(kernel, case, 10, times * 10.0)
    assert not far.converged
    searched = search.Search(case, "ck-tau", 10, None)
    assert searched.less_smooth(far, times) is far
    assert searched.iterations > 0  # it was tried
