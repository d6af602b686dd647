"""The paper's claims: how each is decided, and for which forces."""

import numpy as np
import pytest
from computed import acceleration_errors, case, period_errors
from paper import METHODS
from scipy.special import sici

from nonsmooth.report import build, intervals
from nonsmooth.report.case import Case, at_alpha
from nonsmooth.report.checks import c1, fourier
from nonsmooth.report.claim_map import segments
from nonsmooth.report.finding import Claim, Finding, Part, verdict
from nonsmooth.report.intervals import Interval
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT


@pytest.mark.parametrize("alpha", [1e-6, 1.25e-3, 50.0, 1e6])
def test_every_claim_is_decided_at_the_extremes(alpha: float) -> None:
    case = at_alpha(DEFAULT, alpha)
    for part in build.PARTS:
        assert part.of(case).numbers


def test_the_ripple_of_many_harmonics_is_that_of_gibbs() -> None:
    constant = sici(np.pi)[0] / np.pi - 0.5
    assert pytest.approx(constant, rel=1e-12) == fourier.GIBBS
    assert Case(DEFAULT).overshoot("hb", 160) == pytest.approx(constant, rel=0.02)


def test_what_the_claims_say_of_the_default_case_is_what_a_sweep_says() -> None:
    period = {m: period_errors(DEFAULT, m) for m in METHODS}
    size = {m: {N: abs(e) for N, e in period[m].items()} for m in METHODS}
    behind = [N for N in range(1, 13) if size["c1"][N] > size["hb-c1"][N]]
    assert behind == [1, 2, 3, 4]
    assert case().behind("period", "c1", "hb-c1") == behind
    assert max(size["c1"][N] for N in range(4, 41)) < 1e-3 < size["c1"][3]
    assert all(size["hb-c1"][N] < size["hb"][N] for N in range(1, 41))
    for method, expected in (("hb", [5, 15, 22, 25, 32]), ("c1", [2, 6, 8, 10, 12, 14])):
        errors = acceleration_errors(DEFAULT, method)
        up = [N for N in range(2, 41) if errors[N] > errors[N - 1] and errors[N] > 1e-6]
        assert up == fourier.rises(case(), method) == expected


@pytest.mark.parametrize(
    ("check", "force"),
    [
        (c1.in_band_with_any_solution, 342.5),
        (c1.in_band_from_three, 1163),
        (c1.beyond_three, None),
    ],
)
def test_ends_of_intervals(check, force: float | None, monkeypatch) -> None:
    part = Part("", check)
    monkeypatch.setattr(intervals, "grid", lambda: [float(a) for a in np.geomspace(0.5, 5, 25)])
    (*_, last) = intervals.scan(DEFAULT, [part])[part]
    assert last.high is None
    assert last.low is not None
    ends = [last.low * 1.01, last.low / 1.01]
    assert [part.of(at_alpha(DEFAULT, alpha)).holds for alpha in ends] == [True, False]
    if force is not None:
        assert intervals.force(DEFAULT, last.low) == pytest.approx(force, rel=5e-3)


def test_the_ends_of_several_intervals_are_found() -> None:
    def between(case: Case) -> Finding:
        return Finding(not 0.2 < case.alpha < 0.3 and case.alpha < 7, "")

    part = Part("", between)
    first, second = intervals.scan(DEFAULT, [part])[part]
    assert (first.low, first.high) == (None, pytest.approx(0.2, rel=5e-3))
    assert (second.low, second.high) == pytest.approx((0.3, 7), rel=5e-3)


def test_a_verdict_is_made_of_the_parts_that_count() -> None:
    def claim(*counts: bool) -> Claim:
        parts = tuple(Part("", lambda case: Finding(True, ""), count) for count in counts)
        return Claim("", "", "", "", parts)

    yes, no = Finding(True, ""), Finding(False, "")
    assert verdict(claim(True, True), (yes, yes)) == "holds"
    assert verdict(claim(True, True), (yes, no)) == "holds in part"
    assert verdict(claim(True, True), (no, no)) == "does not hold"
    assert verdict(claim(True, False), (yes, no)) == "holds"
    assert verdict(claim(True, False), (no, yes)) == "does not hold"


def test_the_map_has_the_verdict_for_every_force() -> None:
    one, two = (Part(name, lambda case: Finding(True, "")) for name in "ab")
    claim = Claim("", "", "", "", (one, two))
    where = {one: [Interval(0.1, None)], two: [Interval(1.0, 2.0)]}
    assert segments(claim, where) == [
        (intervals.FIRST, 0.1, "does not hold"),
        (0.1, 1.0, "holds in part"),
        (1.0, 2.0, "holds"),
        (2.0, intervals.LAST, "holds in part"),
    ]
