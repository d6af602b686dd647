"""Time against error of a scene's methods, and the best orbit within a time."""

import json
from pathlib import Path

import pytest
from matplotlib.figure import Figure
from printed_table import Columns, compare, read

import nonsmooth as ns
from nonsmooth.plots.sweeps import trade_figure
from nonsmooth.solver.kernels.registry import load
from nonsmooth.solver.scenes.methods import EXACT
from nonsmooth.solver.trade import budget as budgets
from nonsmooth.solver.trade import measured as trades
from nonsmooth.solver.trade.choice import TooSlow
from nonsmooth.solver.trade.measured import Trade, TradePoint, front, trade

IMPACT = load("impact")

#: What the table shows of a point of the document.
COLUMNS: Columns = {
    "method": (lambda point: point["method"].replace("ck", "c0"), ""),
    "N": (lambda point: point["order"], ""),
    "time [s]": (lambda point: point["seconds"], ".1e"),
    "times": (lambda point: point["error"], ".1e"),
    "estimate": (lambda point: point["estimate"] if point["order"] else None, ".1e"),
    "front": (lambda point: "*" if point["front"] else "", ""),
}


@pytest.fixture(autouse=True)
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    """Try few orders, and let each take as long as its number of unknowns says."""
    monkeypatch.setattr(trades, "POWER_ORDERS", (2, 6))
    monkeypatch.setattr(trades, "FACTOR_ORDERS", (2, 4, 8))

    def timed(work):
        orbit = work()
        return orbit, 1e-6 * len(orbit.outcome.unknowns)

    monkeypatch.setattr(trades, "timed", timed)
    monkeypatch.setattr(budgets, "timed", timed)


@pytest.fixture(scope="module")
def case():
    return IMPACT(gap=0.2)


def test_every_method_has_its_points(case) -> None:
    seen: list[str] = []
    result = trade(case, seen.append)
    ways = [(p.method, p.order) for p in result.points]
    tried = [(EXACT, None), *trades.ways(case)]
    assert len(seen) == len(tried) == 1 + 2 + 2 + 3 + 3
    assert set(tried) - set(ways) == {("ck-tau", 2)}  # which has no orbit
    for point in result.points[1:]:
        orbit = ns.solve(case, point.method, point.order, functions=point.functions)
        assert point.error == orbit.errors.times
        assert point.estimate == pytest.approx(point.error, rel=0.1)
    assert result.points[0].front  # four unknowns: nothing is faster


def test_the_front_is_what_nothing_faster_matches() -> None:
    points = [(3, 1e-9), (1, 1e-2), (2, 1e-2), (4, 1e-8), (5, 1e-12)]
    assert front(points) == {0, 1, 4}


def test_the_table_and_the_document_have_the_same_points(run, tmp_path: Path) -> None:
    target = tmp_path / "trade.svg"
    status, out, _ = run("tradeoff", "impact", "--gap", 0.2, "--json", "-o", target)
    document = json.loads(out)
    assert (status, document["scene"], document["class"]) == (0, "impact", "C0")
    assert document["parameters"]["gap"] == 0.2
    assert target.read_text("utf-8").startswith("<?xml")
    status, out, _ = run("tradeoff", "impact", "--gap", 0.2)
    compare(read(out, list(COLUMNS)), document["points"], COLUMNS)


def test_the_picture_has_a_line_a_method_through_its_points(case) -> None:
    points = (
        TradePoint(EXACT, None, None, 1e-3, 2e-16, 0.0, front=True),
        TradePoint("hb", 2, None, 2e-3, 1e-1, 1e-1),
        TradePoint("hb", 3, None, 4e-3, 9e-2, 9e-2),  # the next one beats it in both
        TradePoint("hb", 4, None, 3e-3, 5e-2, 5e-2),
        TradePoint("ck-tau", 4, None, 4e-3, 1e-6, 1e-6),
    )
    figure = trade_figure(Trade(case, points))
    assert isinstance(figure, Figure)
    axes = figure.axes[0]
    lines = {line.get_label(): line for line in axes.lines}
    assert list(lines) == ["exact flow", "hb", "c0-tau"]  # a front of one point is no line
    assert list(lines["hb"].get_xdata()) == [2e-3, 3e-3]
    assert list(lines["hb"].get_ydata()) == [1e-1, 5e-2]
    quick = TradePoint("hb", 1, None, 1e-4, 5e-1, 5e-1, front=True)
    front = trade_figure(Trade(case, (*points, quick))).axes[0].lines[0]
    assert (front.get_label(), list(front.get_ydata())) == ("the front", [5e-1, 2e-16])
    assert "error of the times" in axes.get_ylabel()
    assert "time" in axes.get_xlabel()


def test_the_best_within_a_budget(case) -> None:
    with pytest.raises(TooSlow, match=r"the fastest orbit takes 7e-06 s here$"):
        ns.solve(case, budget=6.5e-6)  # ck has seven unknowns at N = 2
    orbit = ns.solve(case, budget=1.0)
    assert (orbit.method, orbit.order) == ("ck-tau", 8)
    assert ns.solve(case, "hb", budget=1.0).order == 6


def test_no_orbit_beyond_the_budget_is_taken(case) -> None:
    within = 1.2e-5
    choice = budgets.choose_within(case, within)
    fits = [t for t in choice.trials if t.seconds is not None and t.seconds <= within]
    assert 0 < len(fits) < len(choice.trials)
    best = min(fits, key=lambda t: max(t.estimate.times, t.estimate.period))
    assert (choice.orbit.method, choice.orbit.order) == (best.method, best.order)
    for name in {t.method for t in choice.trials}:
        slow = [t for t in choice.trials if t.method == name and (t.seconds or 0) > within]
        assert len(slow) <= 1  # it is left at the first that takes too long


def test_a_budget_is_spent_on_the_motion_that_is_asked_for() -> None:
    with pytest.raises(ns.NoOrbit, match="sliding"):
        ns.solve(ns.scene("dry-friction")(frequency=0.4), budget=1.0, motion="sliding")


def test_a_budget_on_the_command_line(run) -> None:
    status, out, _ = run("solve", "impact", "--budget", "1s", "--json")
    document = json.loads(out)
    assert (status, document["method"], document["order"]) == (0, "ck-tau", 8)
    assert {t["method"] for t in document["trials"]} == {"hb", "hb-ck", "ck", "ck-tau"}
    status, out, _ = run("solve", "impact", "--budget", "1s")
    assert "ck-tau, N = 8: the smallest estimated error within 1 s, of hb, hb-ck" in out
    status, _, err = run("solve", "impact", "--budget", "1us")
    assert (status, "the fastest orbit takes" in err) == (1, True)
    status, out, _ = run("solve", "--method", "c1-tau", "--budget", "1s", "--json")
    assert json.loads(out)["order"] == 8


def test_a_scene_of_several_motions(run) -> None:
    case = load("dry-friction")()
    methods = {point.method for point in trade(case).points}
    assert methods == {EXACT, *(method for method, _ in trades.ways(case))}
    orbit = ns.solve(case, budget=1.0)
    assert (orbit.method, orbit.case.scene.motion) == ("ck-tau", "sliding")
    status, out, _ = run("tradeoff", "dry-friction", "--mu-s", 0.4, "--mu-k", 0.4, "--json")
    assert (status, json.loads(out)["scene"]) == (0, "dry-friction")
