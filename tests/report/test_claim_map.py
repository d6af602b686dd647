"""The map of the claims, read back: its bars, their shades, and the key on the page."""

import re
from pathlib import Path

import pytest

pytest.importorskip("matplotlib")

from computed import ODD
from drawn import data
from matplotlib.colors import to_hex

import nonsmooth as ns
from nonsmooth.report.claim_map import claim_map
from nonsmooth.report.finding import Claim, Finding, Part
from nonsmooth.report.intervals import Interval


def holds(name: str) -> Part:
    return Part(name, lambda case: Finding(True, ""))


def test_the_map_of_the_claims_has_the_shades_of_the_page() -> None:
    one, two, never = (holds(name) for name in ("one", "two", "never"))
    claims = (Claim("a", "First", "", "", (one, two)), Claim("b", "Second", "", "", (never,)))
    where = {one: [Interval(0.1, None)], two: [Interval(1.0, 2.0)], never: []}
    (axes,) = claim_map(ODD, claims, where).axes
    assert axes.get_xlabel() == "normal force $F_N$ [N]"
    assert axes.get_xscale() == "log"
    assert [tick.get_text() for tick in axes.get_yticklabels()] == ["First  1", "Second  2"]
    template = Path(ns.__file__).parent / "report" / "page.html.jinja"
    key = re.findall(
        r'class="key" style="background:(#\w+)"></span> ([a-z ]+)', template.read_text("utf-8")
    )
    shades = {words: to_hex(colour) for colour, words in key}
    assert list(shades) == ["holds", "holds in part", "does not hold"]
    shown = []
    for bar in axes.patches:
        face = to_hex(bar.get_facecolor()) if bar.get_facecolor()[3] else "#ffffff"
        ends = bar.get_x(), bar.get_x() + bar.get_width()
        (verdict,) = (words for words, shade in shades.items() if shade == face)
        shown.append((round(bar.get_y() + bar.get_height() / 2), *ends, verdict))
    force = 1.0 / (4 / 3)  # N, at alpha = 1
    expected = [
        (0, 0.01, 0.1, "does not hold"),
        (0, 0.1, 1.0, "holds in part"),
        (0, 1.0, 2.0, "holds"),
        (0, 2.0, 10.0, "holds in part"),
        (1, 0.01, 10.0, "does not hold"),
    ]
    for found, (row, low, high, verdict) in zip(shown, expected, strict=True):
        assert found == (row, pytest.approx(low * force), pytest.approx(high * force), verdict)
    (case,) = axes.lines
    assert data(case)[0] == pytest.approx([1.0, 1.0])
    assert axes.get_xlim() == pytest.approx((0.01 * force, 10 * force))
    assert axes.get_ylim()[0] > axes.get_ylim()[1]  # the first claim is at the top
