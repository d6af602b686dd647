"""Where the search for an accurate Fourier series begins: early enough, and not in vain."""

import itertools
import math

import pytest

import nonsmooth as ns
from nonsmooth.solver.shortcuts.choice.first_orders import ERRORS, LONG_STICK, first_order
from nonsmooth.solver.shortcuts.choice.tolerance import EARLY, within
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT, StickSlip
from nonsmooth.solver.shortcuts.search.start import rough_times


def with_alpha(alpha: float) -> StickSlip:
    return StickSlip(**vars(DEFAULT) | {"normal_force": 400 * alpha})


@pytest.mark.parametrize("method", ["hb", "hb-c1"])
@pytest.mark.parametrize(("alpha", "harmonics"), [(LONG_STICK, 60), (30.0, 60), (100.0, 100)])
def test_the_errors_are_foretold(method: str, alpha: float, harmonics: int) -> None:
    """Not so high that the search would begin beyond the order, and not half as low."""
    t1, T = rough_times(alpha)
    order = round(harmonics * T / (T - t1))
    found = ns.solve(with_alpha(alpha), method, order).estimate
    for error in ("period", "acceleration"):
        needed = ERRORS[method].harmonics(alpha, {error: getattr(found, error)})
        assert 0.5 < needed / harmonics < 1 / EARLY


@pytest.mark.parametrize(
    ("method", "alpha", "tol"),
    [("hb", 5.0, 1e-2), ("hb", 30.0, 4e-2), ("hb-c1", 5.0, 1e-4), ("hb-c1", 100.0, 1e-3)],
)
def test_it_begins_before_the_order_that_is_found(
    method: str, alpha: float, tol: float
) -> None:
    choice = within(with_alpha(alpha), tol, methods=[method])
    assert first_order(method, alpha, {"period": tol}, EARLY) < choice.orbit.order
    assert len(choice.trials) <= 8  # from where slip is resolved it takes ten
    before = [trial.estimate for trial in choice.trials[:-1]]
    assert all(found is None or found.period > 0.9 * tol for found in before)


@pytest.mark.parametrize("method", ["hb", "hb-c1"])
def test_what_no_order_can_meet_is_refused_before_anything_is_tried(
    monkeypatch, method: str
) -> None:
    """It took more than nine minutes, and 1.5 GB."""
    monkeypatch.setattr("nonsmooth.solver.shortcuts.choice.tolerance.attempt", pytest.fail)
    with pytest.raises(ns.NotCertified, match=f"{method} would need N of about ") as caught:
        within(with_alpha(14_149.195), 1e-5, methods=[method])
    assert caught.value.trials == ()
    assert caught.value.foretold[method] > 1e6


def test_after_an_order_without_an_orbit_comes_its_double(monkeypatch) -> None:
    tried: list[int] = []

    def none(belt: object, method: str, order: int, many: bool) -> None:
        tried.append(order)

    monkeypatch.setattr("nonsmooth.solver.shortcuts.choice.tolerance.attempt", none)
    said: list[str] = []
    with pytest.raises(ns.NotCertified):
        within(with_alpha(100.0), 0.04, methods=["hb-c1"], progress=said.append)
    t1, T = rough_times(100.0)
    assert tried[0] >= T / (T - t1)
    assert all(2 * a <= b <= 2.3 * a for a, b in itertools.pairwise(tried))
    assert len(tried) < math.log2(1e6)
    assert said == [f"hb-c1, N = {order}" for order in tried]
