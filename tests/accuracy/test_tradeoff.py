"""Time against error: the front, the two regimes, table, document and picture."""

import json

import pytest

from nonsmooth.shortcuts import tradeoff
from nonsmooth.shortcuts.tradeoff import Point, with_front
from nonsmooth.solver import solve as scenes_solve
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT


def point(seconds: float, error: float) -> Point:
    return Point("float64", "c1", 1, 1, None, seconds, error, error)


def test_the_front_is_what_nothing_faster_matches() -> None:
    points = [point(3, 1e-9), point(1, 1e-2), point(2, 1e-2), point(4, 1e-8), point(5, 1e-12)]
    assert [p.front for p in with_front(points)] == [True, True, False, False, True]
    assert [p.seconds for p in with_front(points)] == [3, 1, 2, 4, 5]


@pytest.fixture
def few(monkeypatch) -> None:
    orders = {
        ("hb", 1): (2, 8), ("hb-c1", 1): (2,), ("hb-c1", 3): (8,), ("c1", 1): (4, 5, 7, 10),
        ("c1-tau", 1): (4, 7),
    }  # fmt: skip
    monkeypatch.setattr(tradeoff, "ORDERS", orders)
    monkeypatch.setattr(tradeoff, "DIGITS", (20, 30))


@pytest.mark.usefixtures("few")
def test_points_of_both_regimes() -> None:
    seen = []
    points = tradeoff.measure(DEFAULT, seen.append)
    assert len(seen) == tradeoff.count() == len(points)
    for p in points:
        assert p.seconds > 0
        if p.regime == "float64":
            assert p.estimate == pytest.approx(p.error, rel=0.1)
        else:
            assert p.error <= 10.0**-p.digits * 1.0001
    assert [p.order for p in points if p.c1_terms == 3] == [8]
    assert points[-1].front  # nothing else has 30 digits
    errors = {(p.method, p.order): p.error for p in points}
    assert errors["c1-tau", 7] < 1e-3 * errors["c1", 7]
    assert errors["c1-tau", 4] < errors["c1", 4]
    fastest = min(points, key=lambda p: p.seconds)
    assert fastest.front


@pytest.mark.usefixtures("few")
def test_the_command_prints_a_document_and_writes_a_picture(run, tmp_path) -> None:
    target = tmp_path / "tradeoff.svg"
    status, out, _ = run("tradeoff", "--json", "-o", target)
    document = json.loads(out)
    assert status == 0
    assert document["parameters"]["normal_force"] == 400
    assert {p["regime"] for p in document["points"]} == {"float64", "precise"}
    assert target.read_text().count("<svg") == 1


@pytest.mark.parametrize("method", tradeoff.ORDERS, ids=str)
def test_a_method_without_an_orbit_has_no_points(
    method: tuple[str, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    def nothing(*arguments: object, **options: object) -> None:
        raise NoOrbit("none", False, ())

    monkeypatch.setattr(tradeoff, "solve", nothing)
    monkeypatch.setattr(scenes_solve, "solve_case", nothing)
    monkeypatch.setattr(tradeoff, "ORDERS", {method: (4, 5)})
    monkeypatch.setattr(tradeoff, "find_spec", lambda name: None)
    assert tradeoff.measure(DEFAULT) == []


def test_a_case_that_float64_cannot_hold(run) -> None:
    status, out, err = run("tradeoff", "--normal-force", 1e-12)
    assert (status, out) == (2, "")
    assert "alpha" in err
