"""For which forces a statement holds, and the map of the verdicts, read back."""

import math
import re
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from computed import ODD
from drawn import data
from matplotlib.colors import to_hex

import nonsmooth as ns
from nonsmooth import workers
from nonsmooth.report import intervals
from nonsmooth.report.case import DEFAULT, Case, at_alpha
from nonsmooth.report.checks import Finding
from nonsmooth.report.claims import CLAIMS, Claim, Part
from nonsmooth.report.figures import claim_map


def test_ends_of_intervals(monkeypatch) -> None:
    """What stays in the band from N = 4 on, of forces above 342.5 N."""
    (part,) = (c.parts[2] for c in CLAIMS if c.name == "band")
    monkeypatch.setattr(intervals, "grid", lambda: [float(a) for a in np.geomspace(0.5, 5, 7)])
    (*_, (low, high)) = intervals.scan(DEFAULT, [part])[part]
    assert 0.5 < low < high == math.inf
    ends = [low * 1.01, low / 1.01]
    assert [part.of(at_alpha(DEFAULT, alpha)).holds for alpha in ends] == [True, False]
    assert intervals.force(DEFAULT, low) == pytest.approx(342.5, rel=5e-3)


def test_the_ends_of_several_intervals_are_found() -> None:
    def between(case: Case) -> Finding:
        return Finding(not 0.2 < case.belt.alpha < 0.3 and case.belt.alpha < 7, "")

    part, told = Part("", between), []
    first, second = intervals.scan(DEFAULT, [part], told.append)[part]
    assert len(told) == intervals.SCANNED + 1
    assert first == (0, pytest.approx(0.2, rel=5e-3))
    assert second == pytest.approx((0.3, 7), rel=5e-3)


def test_processes_find_the_same_intervals(monkeypatch) -> None:
    poorest = next(claim for claim in CLAIMS if claim.name == "poorest")
    parts = [CLAIMS[0].parts[0], poorest.parts[0]]
    monkeypatch.setattr(intervals, "grid", lambda: [0.3, 0.5, 1.0])
    monkeypatch.setattr("os.cpu_count", lambda: 2)
    alone, told = intervals.scan(DEFAULT, parts), []
    with workers.pool() as processes:
        assert intervals.scan(DEFAULT, parts, told.append, processes.map) == alone
    assert len(alone[parts[1]][0]) == 2
    assert told[:3] == ["alpha = 0.3", "alpha = 0.5", "alpha = 1"]
    assert sorted(told[3:]) == sorted(part.words for part in parts)


def made_up(title: str, *found: list[tuple[float, float]]) -> tuple[Claim, dict]:
    parts = tuple(Part(title, lambda case: Finding(True, "")) for _ in found)
    claim = Claim(title, title, "", "", "", "", parts)
    return claim, dict(zip(parts, found, strict=True))


def test_the_map_of_the_claims_has_the_verdicts_in_the_shades_of_the_page() -> None:
    first, one = made_up("First", [(0.1, math.inf)], [(1.0, 2.0)])
    second, other = made_up("Second", [])
    (axes,) = claim_map(ODD, [first, second], one | other).axes
    assert axes.get_xlabel() == "normal force $F_N$ [N]"
    assert axes.get_xscale() == "log"
    assert [tick.get_text() for tick in axes.get_yticklabels()] == ["First  1", "Second  2"]
    template = Path(ns.__file__).parent / "report" / "page.html.jinja"
    key = re.findall(
        r'class="key" style="background:(#\w+)"></span> ([a-z ]+)', template.read_text("utf-8")
    )
    shades = {to_hex(colour): words for colour, words in key}
    assert list(shades.values()) == ["holds", "holds in part", "does not hold"]
    shown = []
    for bar in axes.patches:
        face = to_hex(bar.get_facecolor()) if bar.get_facecolor()[3] else "#ffffff"
        ends = bar.get_x(), bar.get_x() + bar.get_width()
        shown.append((round(bar.get_y() + bar.get_height() / 2), *ends, shades[face]))
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
