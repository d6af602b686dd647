"""Results in one line, in a notebook, and after they were pickled."""

import pickle
from xml.etree import ElementTree

import pytest
from results_things import MAKERS, thing

import nonsmooth as ns
from nonsmooth.solver.presentation import notebook

#: What each kind says of itself in one line.
LINES = {
    "orbit": "<dry-friction, two-stops by c1-tau, N = 6: T = 15.70796327 s, slide {0:.10g} s, "
    "stop {1:.10g} s, phi = {phi:.10g} rad, stable, estimate {estimate:.1e}>",
    "exact": "<exact orbit of impact: T = 3.490658504 s, phi = 0.929643986 rad, stable>",
    "sweep": "<sweep of impact by hb, c0-tau: 6 rows, 6 orbits>",
    "family": "<impact along gap = 0.1 to 50 by c0-tau, N = 6: 3 values, 2 orbits>",
    "simulation": "<impact simulated for 6.98132 s: 3 phases>",
    "exact-belt": "<exact orbit of stick-slip: T = 0.671238898 s, t1 = 0.2 s, stable>",
    "sweep-belt": "<sweep of stick-slip by hb, c1: 6 rows, 6 orbits>",
    "family-belt": "<stick-slip along belt_speed = 0.001 to 1 by hb, N = 5: 3 values, "
    "2 orbits>",
}


@pytest.mark.parametrize("kind", LINES)
def test_a_line_says_what_matters(kind: str) -> None:
    found = thing(kind)
    values = {}
    if kind == "orbit":
        values = {"phi": found.forcing_phase, "estimate": found.estimate.times}
    durations = getattr(found, "durations", ())
    assert repr(found) == LINES[kind].format(*durations, **values)


def test_one_is_not_several() -> None:
    case = ns.scene("impact")(gap=0.2)
    sweep, family = ns.sweep(case, "ck", orders=[6]), ns.family(case, "gap", [0.2], "ck", 6)
    assert repr(sweep) == "<sweep of impact by c0: 1 row, 1 orbit>"
    assert repr(family).endswith("N = 6: 1 value, 1 orbit>")
    assert repr(ns.diagram(case, "gap", [0.2], 4, 1)).endswith(": 1 value>")


def test_the_events_of_a_branch_are_a_line_each() -> None:
    case = ns.scene("impact")(gap=0.5, damping=0.02)
    head, fold, grazing, last = str(ns.branch(case, "frequency", 1.7, 2.6)).splitlines()
    assert head.split() == ["event", "frequency", "motion"]
    assert [fold.split()[0], *fold.split()[2:]] == ["fold"]
    assert [grazing.split()[0], *grazing.split()[2:]] == ["grazing", "in", "flight"]
    assert last.startswith("from frequency = 1.7")
    assert "event" not in str(ns.branch(ns.scene("impact")(), "gap", 0.1, 0.12))


def test_a_line_of_the_paper_s_orbit_and_of_modes() -> None:
    belt, modes = thing("belt"), thing("modes")
    times = f"T = {belt.period:.10g} s, t1 = {belt.t1:.10g} s"
    assert repr(belt) == (
        f"<stick-slip by c1, N = 6: {times}, stable, estimate {belt.estimate.times:.1e}>"
    )
    assert repr(modes) == (
        f"<3 modes of beam-mass by ritz-c2, N = 8: {modes[0].frequency:.10g} to "
        f"{modes[2].frequency:.10g} Hz>"
    )


NOTEBOOK = [kind for kind in MAKERS if kind != "study"]


@pytest.mark.parametrize("kind", NOTEBOOK)
def test_a_notebook_shows_a_table_and_a_picture(kind: str) -> None:
    pytest.importorskip("matplotlib")
    html = thing(kind)._repr_html_()
    start, svg = html.index("<svg"), html[html.index("<svg") :]
    ElementTree.fromstring(f"<div>{html[:start]}</div>")
    root = ElementTree.fromstring(svg)
    assert len(root.findall(".//{http://www.w3.org/2000/svg}path")) > 5
    if "table" in html[:start]:
        rows = ElementTree.fromstring(html[:start]).findall("tr")
        words = {row[0].text: row[1].text for row in rows}
        assert f"{thing(kind).period:.10g} s" == words["period"]


def test_without_matplotlib_a_notebook_has_the_table_alone(monkeypatch) -> None:
    monkeypatch.setattr(notebook, "find_spec", lambda name: None)
    html = thing("orbit")._repr_html_()
    assert "svg" not in html
    assert "<th>estimated error of the times</th>" in html


def test_a_long_result_is_shortened() -> None:
    text = "head\n" + "\n".join(map(str, range(1000)))
    html = notebook.of_rows("a < b", text, lambda ax: None)
    assert "a &lt; b" in html
    assert "... 952 more" in html
    assert html.count("\n") > 40
    assert "\n23\n" in html
    assert "\n24\n" not in html
    assert "\n976\n" in html


@pytest.mark.parametrize("kind", NOTEBOOK)
def test_what_was_pickled_is_equal(kind: str) -> None:
    found = thing(kind)
    again = pickle.loads(pickle.dumps(found))
    assert again == found
    assert hash(again) == hash(found)
    assert again is not found


def test_orbits_of_other_orders_or_cases_are_not_equal() -> None:
    import nonsmooth as ns

    case = ns.scene("impact")()
    one = ns.solve(case, order=5)
    assert one == ns.solve(case, order=5)
    assert one != ns.solve(case, order=6)
    assert one != ns.solve(ns.scene("impact")(gap=0.11), order=5)
    assert one != ns.exact(case)
    assert thing("belt") != thing("exact-belt")
