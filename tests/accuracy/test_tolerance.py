"""A tolerance is honoured, or said to be out of reach."""

import os

import mpmath as mp
import pytest
from computed import belt_of
from hypothesis import given, settings
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth.report.case import DEFAULT
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.orbit.solution import attempt
from nonsmooth.solver.trade.choice import MARGIN

EXAMPLES = int(os.environ.get("EXAMPLES", "800"))


def true_errors(orbit: ns.Orbit) -> float:
    """Return the largest error of a time, as a part of the period, against 40 digits."""
    with mp.workdps(40):
        alpha = mp.mpf(orbit.case.alpha)
        exact = 2 * alpha, mp.pi + 2 * mp.atan(1 / alpha)
        found = [mp.mpf(float(time)) for time in orbit.durations]
        off = [q - e for q, e in zip(found, exact, strict=True)]
        return float(max(*map(abs, off), abs(sum(off))) / sum(exact))


@settings(max_examples=EXAMPLES // 40)
@given(st.floats(-3, 3), st.floats(-13, -2))
def test_the_times_are_within_the_tolerance(exponent: float, digits: float) -> None:
    orbit = ns.solve(belt_of(10**exponent), tol=10**digits)
    assert true_errors(orbit) <= 10**digits


@settings(max_examples=EXAMPLES // 80)
@given(
    st.one_of(
        st.tuples(st.just("hb"), st.floats(-2.5, -1.5)),
        st.tuples(st.just("hb-c1"), st.floats(-4, -2)),
        st.tuples(st.just("c1"), st.floats(-11, -2)),
    ),
    st.floats(-1, 0.7),
)
def test_a_method_is_kept_to(asked: tuple[str, float], exponent: float) -> None:
    method, digits = asked
    orbit = ns.solve(belt_of(10**exponent), method, tol=10**digits)
    assert orbit.method == method.replace("c1", "ck" if method == "c1" else "c1")
    assert true_errors(orbit) <= 10**digits


@pytest.mark.parametrize("order", [7, 9, 11])
def test_an_estimate_that_uses_up_the_tolerance_is_not_taken(order: int) -> None:
    """It is itself off by a few per cent."""
    found = ns.solve(DEFAULT, "c1", order).estimate
    most = max(found.times, found.period, found.switches)
    close, enough = (
        ns.solve(DEFAULT, "c1", tol=tol).order for tol in (most / 0.95, most / (0.99 * MARGIN))
    )
    assert enough == order < close


@pytest.mark.parametrize(("method", "tol"), [("c1", 1e-2), ("c1", 1e-8)])
def test_orders_go_on_to_those_that_resolve_a_short_phase(method: str, tol: float) -> None:
    """At N = 13 there is no orbit yet; from the times of the exact one there is at N = 17."""
    orbit = ns.solve(belt_of(1e-5), method, tol=tol)
    assert 17 <= orbit.order <= 20
    assert true_errors(orbit) <= tol


@pytest.mark.parametrize(
    ("method", "tol", "said"),
    [
        ("hb", 1e-9, "the times of the exact orbit: hb, N = 400"),
        ("hb-c1", 1e-2, "not fall any"),
    ],
)
def test_orders_behind_one_without_an_orbit_start_once(monkeypatch, method, tol, said) -> None:
    """The stick is 640 times as long as the slip, which these methods do not resolve."""
    orders: list[int] = []

    def counted(kernel, case, order, *more):
        orders.append(order)
        return attempt(kernel, case, order, *more)

    monkeypatch.setattr("nonsmooth.solver.search.attempt", counted)
    with pytest.raises((NoOrbit, ns.NotCertified), match=said):
        ns.solve(belt_of(1000), method, tol=tol)
    beyond = [order for order in orders if order > 44]  # the first where hb-c1 has none
    assert len(set(beyond)) == len(beyond) > 3


def test_errors_that_do_not_fall_yet_are_not_extrapolated() -> None:
    """A force just above friction moves the mass little: waves have to be that short first."""
    case = ns.scene("dry-friction")(force=0.3001)
    with pytest.raises(ns.NotCertified) as caught:
        ns.solve(case, "hb", tol=0.1)
    assert caught.value.needed < 1e6


@pytest.mark.parametrize("text", ["", "ms", "-1ms", "0s", "1 m", "nan s", "1e999s", "1h"])
def test_a_time_that_is_none(run, text: str) -> None:
    status, out, err = run("solve", f"--budget={text}")
    assert (status, out, "expected a time like" in err) == (2, "", True)
