"""Measured rates of the paper's methods, and lists of orders."""

import json

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.cli.problems import Problem
from nonsmooth.cli.values import parse_orders
from nonsmooth.report.case import DEFAULT
from nonsmooth.solver.accuracy.rates import slope


def test_the_upper_half_is_never_less_than_six_orders() -> None:
    """Of eleven orders from 1 the upper half has six; of ten it would have five."""
    for last, first in ((11, 6), (10, 5)):
        rows = [(N, 10.0**-N if first <= N else 0.3) for N in range(1, last + 1)]
        found = slope(rows, 0.0, power=False, upper_half=True)
        assert found == pytest.approx(1.0)
        worse = [(N, 0.3 if first == N else error) for N, error in rows]
        found = slope(worse, 0.0, power=False, upper_half=True)
        assert found != pytest.approx(1.0, rel=0.01)


def test_rounding_is_left_out() -> None:
    rows = [(2**k, 8.0**-k) for k in range(1, 7)] + [(1000, 3e-16)]
    assert slope(rows, 1e-13, power=True) == pytest.approx(3.0)


def test_a_short_sweep_prints_no_rate(run) -> None:
    """The errors of hb-c1 at N = 1, 2, 3 would have it diverge."""
    arguments = ("sweep", "--orders", "1-3", "--methods", "hb,hb-c1,c1")
    _, out, _ = run(*arguments)
    assert "N^" not in out
    assert out.count("too few orders") == 6
    assert json.loads(run(*arguments, "--json")[1])["rates"]["hb-c1"] == {
        "kind": "power", "times": None, "discontinuous": None,
    }  # fmt: skip


def test_the_rates_of_the_paper_s_methods() -> None:
    """1/N and about N**-3; the acceleration N**-1/2 and N**-3/2, with its jumps aligned."""
    rates = ns.sweep(DEFAULT, "hb", range(60, 180, 20)).rates()
    assert rates["hb"].times == pytest.approx(1, abs=0.01)
    assert rates["hb"].discontinuous == pytest.approx(0.5, abs=0.01)
    # These errors are larger or smaller by the order: the rate is that of many together.
    rates = ns.sweep(DEFAULT, "hb-c1", range(30, 90, 2)).rates()
    assert rates["hb-c1"].times == pytest.approx(3, abs=0.3)
    assert rates["hb-c1"].discontinuous == pytest.approx(1.5, abs=0.1)


@pytest.mark.parametrize(
    "text", ["...", "1,...", "1,2,...", "2,3,...,9", "1,10,...,50", "5,...,9"]
)
def test_dots_that_stand_for_nothing(text: str) -> None:
    with pytest.raises(Problem, match="multiplies on to"):
        parse_orders(text)


def test_dots_stand_for_a_factor() -> None:
    assert parse_orders("1,3,9,...,243") == (3 ** np.arange(6)).tolist()


@pytest.mark.parametrize("last", [9, 14, 30])
def test_rounding_above_the_floor_is_not_fitted(last: int) -> None:
    """So it is of an orbit that answers strongly to it, as of a stiff spring."""
    errors = [(N, max(10.0**-N, 1e-8 * (1 + N % 3))) for N in range(1, last)]
    assert slope(errors, 1e-12, power=False) == pytest.approx(1.0, abs=0.05)
    slow = [(N, 10 ** (-0.1 * N)) for N in range(1, 40)]
    assert slope(slow, 1e-12, power=False) == pytest.approx(0.1)
