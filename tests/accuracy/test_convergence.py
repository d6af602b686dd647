"""Measured rates of convergence: known ones are found, and rounding is left out."""

import json

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.cli.orders import parse_orders
from nonsmooth.cli.problems import Problem
from nonsmooth.solver.shortcuts.accuracy.convergence import rate
from nonsmooth.solver.shortcuts.accuracy.errors import Errors
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT


def errors(value: float) -> Errors:
    return Errors(value, -value, value, value)


@pytest.mark.parametrize("power", [0.5, 1.0, 3.0])
def test_a_power_of_the_order_is_found(power: float) -> None:
    rows = [(N, errors(float(N) ** -power)) for N in (10, 20, 50, 100)]
    assert rate("hb", rows).period == pytest.approx(power)


def test_a_factor_with_each_order_is_found() -> None:
    found = rate("c1", [(N, errors(10.0**-N)) for N in range(1, 20)])
    assert (found.kind, found.t1) == ("geometric", pytest.approx(1.0))
    assert found.text("t1") == "10^(-1.00 N)"


def test_rounding_is_left_out_and_one_order_has_no_rate() -> None:
    rows = [(10, errors(1e-3)), (100, errors(1e-6)), (1000, errors(3e-16))]
    assert rate("hb", rows).period == pytest.approx(3.0)
    none = rate("hb", rows[:1])
    assert none.period is None
    assert none.text("period") == ""


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
    status, out, _ = run("sweep", "--orders", "10,100,...,10000", "--json")
    document = json.loads(out)
    assert status == 0
    computed = [(row["method"], row["order"]) for row in document["rows"]]
    fourier = [(name, N) for name in ("hb", "hb-c1") for N in (10, 100, 1000, 10_000)]
    assert computed == [*fourier, ("c1", 10), ("c1", 100)]
    assert document["rates"]["hb"]["period"] == pytest.approx(1, abs=0.01)
    _, out, _ = run("sweep", "--orders", "10,100,...,1000")
    assert "N^-0.999" in out
    assert max(map(len, out.splitlines())) <= 80


@pytest.mark.parametrize(
    "text", ["...", "1,...", "1,2,...", "2,3,...,9", "1,10,...,50", "5,...,9"]
)
def test_dots_that_stand_for_nothing(text: str) -> None:
    with pytest.raises(Problem, match="multiplies on to"):
        parse_orders(text)


def test_dots_stand_for_a_factor() -> None:
    assert parse_orders("1,3,9,...,243") == (3 ** np.arange(6)).tolist()
