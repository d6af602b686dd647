"""What a tolerance leads to: the margin, the first order that does, nothing in vain."""

import pytest

import nonsmooth as ns
from nonsmooth.solver.shortcuts.choice.tolerance import _spread, within
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT
from nonsmooth.solver.trade.not_certified import MARGIN


@pytest.mark.parametrize("order", [7, 9, 11])
def test_an_estimate_that_uses_up_the_tolerance_is_not_taken(order: int) -> None:
    """It is itself off by a few per cent."""
    estimate = ns.solve(DEFAULT, "c1", order).estimate.period
    close, enough = (within(DEFAULT, tol, methods=["c1"]) for tol in (
        estimate / 0.95, estimate / (0.99 * MARGIN)
    ))  # fmt: skip
    assert enough.orbit.order == order
    assert close.orbit.order > order


@pytest.mark.parametrize(("method", "tol"), [("hb", 3e-3), ("hb", 6e-4)])
def test_no_lower_order_of_the_list_would_do(method: str, tol: float) -> None:
    choice = within(DEFAULT, tol, methods=[method])
    lower = [order for order in _spread(method) if order < choice.orbit.order]
    assert lower
    for order in lower:
        assert ns.solve(DEFAULT, method, order).estimate.period > MARGIN * tol


def test_what_no_estimate_can_meet_is_not_tried() -> None:
    with pytest.raises(ns.NotCertified) as caught:
        ns.solve(DEFAULT, tol=1e-15)
    assert caught.value.trials == ()
