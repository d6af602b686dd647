"""What `nonsmooth digits` measures: the printed forms are the same equations."""

import json
from pathlib import Path

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.cli import progress
from nonsmooth.shortcuts import printed
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT

pytest.importorskip("flint")

from nonsmooth.shortcuts import digits

OTHER = ns.StickSlip(
    mass=0.3, stiffness=40.0, belt_speed=0.7, mu_s=0.6, mu_k=0.25, normal_force=6.0
)


@pytest.mark.parametrize("belt", [DEFAULT, OTHER])
@pytest.mark.parametrize(
    ("method", "order"),
    [("hb", 1), ("hb", 5), ("hb-c1", 1), ("hb-c1", 3), ("c1", 2), ("c1", 3), ("c1", 5)],
)
def test_printed_equations_have_the_same_solution(
    belt: ns.StickSlip, method: str, order: int
) -> None:
    orbit = ns.solve(belt, method, order)
    outcome, _ = printed.solve(method, order, belt, (orbit.t1, orbit.period))
    assert outcome.converged
    # The printed forms lose digits; that is their point.
    assert outcome.unknowns[-1] == pytest.approx(orbit.period, rel=1e-9)
    assert outcome.unknowns[-2] == pytest.approx(orbit.t1, rel=1e-8)
    found = np.concatenate([np.atleast_1d(value) for value in orbit.coefficients.values()])
    size = np.abs(found).max()
    np.testing.assert_allclose(outcome.unknowns[:-2], found, rtol=1e-4, atol=1e-6 * size)


@pytest.mark.parametrize(("method", "order"), [("hb", 3), ("hb-c1", 2), ("c1", 3)])
def test_printed_jacobian_is_the_derivative(method: str, order: int) -> None:
    evaluate, size = printed.system(method, order, OTHER)
    z = np.random.default_rng(5).normal(size=size)
    z[-2:] = 0.4, 1.1
    _, J = evaluate(z)
    h = 1e-6
    for column in range(size):
        step = np.zeros(size)
        step[column] = h
        difference = (evaluate(z + step)[0] - evaluate(z - step)[0]) / (2 * h)
        scale = np.abs(J).max(axis=1) + np.abs(difference)
        assert (np.abs(difference - J[:, column]) < 1e-6 * scale).all()


def test_scaled_condition_of_a_badly_scaled_identity_is_one() -> None:
    J = np.diag([1e-12, 1.0, 1e9])
    assert digits.scaled_condition(J) == pytest.approx(1)


def test_the_grid_reaches_the_extremes() -> None:
    grid = digits.cells()
    alphas = {method: [a for m, a, _ in grid if m == method] for method in digits.TARGETS}
    assert (min(alphas["c1"]), max(alphas["c1"])) == (1e-6, 1e6)
    for method in ("hb", "hb-c1"):
        assert (min(alphas[method]), max(alphas[method])) == (0.01, 30)
        assert max(order for m, _, order in grid if m == method) == 500
    assert max(order for m, _, order in grid if m == "c1") == 60


def test_a_cell_compares_both_forms() -> None:
    cells = [("hb-c1", 1.0, 5), ("c1", 1.0, 7), ("c1", 0.25, 4)]
    series, polynomial, none = digits.measure(cells)
    assert series.met
    assert series.stable.digits > 15
    assert polynomial.stable.digits > 15
    assert polynomial.printed.digits is None or polynomial.printed.digits < 12
    assert polynomial.printed.condition > 1e6 * polynomial.stable.condition
    assert none.stable.status == "no-orbit"
    assert none.met


def test_a_missed_target_is_not_met() -> None:
    good = digits.Form("ok", 1e-15, 10.0, 5)
    assert digits.Cell("c1", 1.0, 5, good, good).met
    for bad in (
        digits.Form("ok", 2e-13, 10.0, 5),
        digits.Form("ok", 1e-15, 10.0, 13),
        digits.Form("not-converged", None, None, 40),
    ):
        assert not digits.Cell("c1", 1.0, 5, bad, good).met


def test_the_command_prints_a_table_and_writes_json_and_picture(
    run, tmp_path: Path, monkeypatch
) -> None:
    grid = [("hb", 1.0, 10), ("c1", 1.0, 5), ("c1", 0.25, 4), ("c1", 1.0, 20)]
    monkeypatch.setattr(digits, "cells", lambda quick: grid)
    monkeypatch.setattr(progress, "QUIET", 0.0)
    status, out, err = run("digits", "-o", tmp_path / "digits.json")
    assert status == 0
    assert "4 of 4 cells meet their target" in out
    assert max(map(len, out.splitlines())) <= 80
    assert "digits: 4 of 4 done (" in err
    assert err.endswith(f"wrote {tmp_path / 'digits.json'}\n")
    status, out, _ = run("digits", "--json", "-o", tmp_path / "digits.png")
    document = json.loads(out)
    assert document["schema"] == 1
    assert document["met"] is True
    assert [row["method"] for row in document["rows"]] == ["hb", "c1", "c1", "c1"]
    assert document["rows"][0]["stable"]["digits"] > 14
    assert document["rows"][3]["printed"]["status"] == "not-converged"
    assert json.loads((tmp_path / "digits.json").read_text())["rows"] == document["rows"]
    assert (tmp_path / "digits.png").read_bytes().startswith(b"\x89PNG")


def test_the_old_name_still_works_and_says_the_new_one(run, monkeypatch) -> None:
    grid = [("c1", 1.0, 5)]
    monkeypatch.setattr(digits, "cells", lambda quick: grid)
    status, out, err = run("stability", "--json")
    assert (status, json.loads(out)["rows"][0]["order"]) == (0, 5)
    assert err.startswith("nonsmooth: stability: it is now `nonsmooth digits`; ")
    assert "stability" not in run("--help")[1].replace("Stability", "")
