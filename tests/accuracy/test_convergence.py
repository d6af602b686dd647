"""Measured rates of convergence: known ones are found, and rounding is left out."""

import json

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.cli.problems import Problem
from nonsmooth.cli.values.orders import parse_orders
from nonsmooth.solver.shortcuts.accuracy.convergence import rate
from nonsmooth.solver.shortcuts.accuracy.errors import Errors
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT


def errors(value: float) -> Errors:
    return Errors(value, -value, value, value)


@pytest.mark.parametrize("power", [0.5, 1.0, 3.0])
def test_a_power_of_the_order_is_found(power: float) -> None:
    rows = [(N, errors(float(N) ** -power)) for N in (10, 20, 50, 100, 200, 500)]
    assert rate("hb", rows).period == pytest.approx(power)


def test_a_factor_with_each_order_is_found() -> None:
    found = rate("c1", [(N, errors(10.0**-N)) for N in range(1, 20)])
    assert (found.kind, found.t1) == ("geometric", pytest.approx(1.0))
    assert found.text("t1") == "10^(-1.00 N)"


def test_rounding_is_left_out() -> None:
    rows = [(2**k, errors(8.0**-k)) for k in range(1, 7)] + [(1000, errors(3e-16))]
    assert rate("hb", rows).period == pytest.approx(3.0)


@pytest.mark.parametrize("method", ["hb", "c1"])
def test_fewer_than_six_orders_have_no_rate(method: str) -> None:
    found = rate(method, [(N, errors(1 / N)) for N in range(1, 6)])
    assert (found.period, found.acceleration) == (None, None)
    assert found.text("period") == "too few orders"
    assert rate(method, [(N, errors(1 / N)) for N in range(1, 7)]).period is not None


def test_the_upper_half_is_never_less_than_six_orders() -> None:
    """Of eleven orders from 1 the upper half has six; of ten it would have five."""
    for last, first in ((11, 6), (10, 5)):
        rows = [(N, errors(10.0**-N if first <= N else 0.3)) for N in range(1, last + 1)]
        assert rate("c1", rows).period == pytest.approx(1.0)
        worse = [(N, errors(0.3) if first == N else found) for N, found in rows]
        assert rate("c1", worse).period != pytest.approx(1.0, rel=0.01)


def test_a_short_sweep_prints_no_rate(run) -> None:
    """The errors of hb-c1 at N = 1, 2, 3 would have it diverge."""
    _, out, _ = run("sweep", "--orders", "1-3")
    assert "N^" not in out
    assert out.count("too few orders") == 9
    assert json.loads(run("sweep", "--orders", "1-3", "--json")[1])["rates"]["hb-c1"] == {
        "kind": "power", "period": None, "t1": None, "acceleration": None,
    }  # fmt: skip


def test_the_rates_of_the_paper_s_methods() -> None:
    """mathematics.md, section 3: 1/N and about N**-3; (22) N**-1/2 and N**-3/2."""
    rates = ns.sweep(DEFAULT, "hb", range(50, 250, 10)).rates()
    assert rates["hb"].period == pytest.approx(1, abs=0.01)
    assert rates["hb"].acceleration == pytest.approx(0.5, abs=0.01)
    # These errors are larger or smaller by the order: the rate is that of many together.
    rates = ns.sweep(DEFAULT, "hb-c1", range(50, 150)).rates()
    assert rates["hb-c1"].period == pytest.approx(3, abs=0.3)
    assert rates["hb-c1"].acceleration == pytest.approx(1.5, abs=0.1)


def test_a_sweep_over_decades_leaves_out_what_c1_cannot(run) -> None:
    status, out, _ = run("sweep", "--orders", "40,120,...,9720", "--json")
    document = json.loads(out)
    assert status == 0
    computed = [(row["method"], row["order"]) for row in document["rows"]]
    fourier = [(name, N) for name in ("hb", "hb-c1") for N in (40, 120, 360, 1080, 3240, 9720)]
    assert computed == [*fourier, *(("c1", N) for N in (40, 120, 360))]
    assert document["rates"]["hb"]["period"] == pytest.approx(1, abs=0.01)
    _, out, _ = run("sweep", "--orders", "40,80,...,1280")
    assert "N^-0.99" in out
    assert max(map(len, out.splitlines())) <= 80


@pytest.mark.parametrize(
    "text", ["...", "1,...", "1,2,...", "2,3,...,9", "1,10,...,50", "5,...,9"]
)
def test_dots_that_stand_for_nothing(text: str) -> None:
    with pytest.raises(Problem, match="multiplies on to"):
        parse_orders(text)


def test_dots_stand_for_a_factor() -> None:
    assert parse_orders("1,3,9,...,243") == (3 ** np.arange(6)).tolist()
