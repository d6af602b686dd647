"""The report: its page, its claims, their intervals, and what can go wrong."""

import re
import shlex
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from scipy.special import sici

pytest.importorskip("matplotlib")
pytest.importorskip("jinja2")

import nonsmooth as ns
from nonsmooth.cli import folders
from nonsmooth.report import build, checks_c1, checks_fourier, intervals
from nonsmooth.report.case import Case, at_alpha
from nonsmooth.report.claim_map import segments
from nonsmooth.report.claims import CLAIMS
from nonsmooth.report.finding import Claim, Finding, Part, verdict
from nonsmooth.report.intervals import Interval, Intervals
from nonsmooth.report.page import page
from nonsmooth.solver.belt import DEFAULT

#: The same alpha in other units, and friction that has other coefficients.
OTHER = ns.StickSlip(
    mass=0.02, stiffness=8.0, belt_speed=0.75, mu_s=0.9, mu_k=0.5, normal_force=0.75
)

#: What is not simply true of the default case.
NOT_QUITE = {
    "mean-of-the-jump": "holds in part",
    "monotone-hb": "holds in part",
    "one-function-gibbs": "holds in part",
    "dependence": "does not hold",
    "overtakes": "holds in part",
    "monotone-c1": "holds in part",
    "stairs": "holds in part",
}


@pytest.fixture(scope="module")
def case() -> Case:
    return Case(DEFAULT)


@pytest.fixture(scope="module")
def found() -> Intervals:
    """Return made-up intervals: what they are is tested apart from the page."""
    return {part: [Interval(None, 0.5), Interval(0.9, None)] for part in build.PARTS}


@pytest.fixture(scope="module")
def folder(tmp_path_factory, case: Case, found: Intervals) -> Path:
    """Return a report but for the scan, which takes half a minute."""
    made = tmp_path_factory.mktemp("report") / "made"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(build, "scan", lambda belt, parts, done: found)
        folders.write_folder(made, _make)
    return made


def _make(target: Path) -> None:
    build.build(DEFAULT, target, lambda done: None)


@pytest.fixture(scope="module")
def text(folder: Path) -> str:
    return (folder / "index.html").read_text("utf-8")


class Elements(HTMLParser):
    """Every element of a page with its attributes, and whether all are closed."""

    VOID = frozenset({"meta", "br", "wbr", "hr", "img"})

    def __init__(self, text: str) -> None:
        super().__init__()
        self.found: list[tuple[str, dict[str, str | None]]] = []
        self.open: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag, attributes) -> None:
        self.found.append((tag, dict(attributes)))
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes) -> None:
        self.found.append((tag, dict(attributes)))

    def handle_endtag(self, tag) -> None:
        assert self.open.pop() == tag


@pytest.fixture(scope="module")
def elements(text: str) -> Elements:
    return Elements(text)


def test_a_report_has_all_its_files_and_no_others(folder: Path) -> None:
    assert {path.name for path in folder.iterdir()} == build.FILES
    assert all((folder / name).stat().st_size > 1000 for name in build.FILES)


def test_the_page_needs_nothing_from_outside(text: str, elements: Elements) -> None:
    assert "http:" not in text
    assert "https:" not in text
    assert "url(http" not in text
    assert {"script", "link", "img", "iframe", "object"}.isdisjoint(
        t for t, _ in elements.found
    )
    assert "@import" not in text
    assert len(text.encode()) < 2_000_000


def test_every_element_is_closed_and_every_link_leads_somewhere(
    elements: Elements, folder: Path
) -> None:
    assert elements.open == []
    names = [a["id"] for _, a in elements.found if "id" in a]
    assert len(names) == len(set(names))
    targets = [a["href"] for _, a in elements.found if a.get("href")]
    assert len(targets) > 30
    for target in targets:
        assert target[1:] in names if target.startswith("#") else (folder / target).is_file()
    used = re.findall(r"url\(#([^)]+)\)", " ".join(str(a) for _, a in elements.found))
    assert used
    assert set(used) <= set(names)


def test_every_picture_says_what_it_shows(elements: Elements) -> None:
    labels = [a.get("aria-label") for tag, a in elements.found if tag == "svg"]
    assert len(labels) == len(build.PICTURES)
    assert len(set(labels)) == len(labels)
    assert all(label and len(label) > 20 for label in labels)


def test_every_equation_of_the_paper_is_on_the_page(elements: Elements) -> None:
    anchors = {a["id"] for _, a in elements.found if str(a.get("id")).startswith("eq-")}
    assert {f"eq-{n}" for n in range(1, 23)} <= anchors
    assert sum(tag == "math" for tag, _ in elements.found) > 100


def test_every_claim_has_a_verdict_and_intervals(text: str) -> None:
    articles = re.findall(r"<article.*?</article>", text, re.DOTALL)
    assert len(articles) == len(CLAIMS)
    for claim, article in zip(CLAIMS, articles, strict=True):
        shown = re.search(r'class="verdict">([^<]+)<', article)
        assert shown
        assert shown[1] == NOT_QUITE.get(claim.name, "holds"), claim.name
        assert article.count("up to 200\xa0N and from 360\xa0N up") == len(claim.parts)
        assert claim.where in article


def test_the_readme_counts_the_verdicts() -> None:
    readme = (Path(__file__).parent.parent / "README.md").read_text("utf-8")
    part = list(NOT_QUITE.values()).count("holds in part")
    counted = f"{len(CLAIMS) - len(NOT_QUITE)} of {len(CLAIMS)} hold, {part} in part"
    assert counted in readme


def test_the_page_says_who_chose_the_normal_force(text: str) -> None:
    assert "is our choice" in text
    assert "0.671239" in text
    assert ns.__version__ in text


def test_the_commands_on_the_page_run(text: str, run, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    commands = set(re.findall(r"<pre><code>nonsmooth (.*?)</code></pre>", text))
    commands.remove("report -o report")
    assert len(commands) == 4  # Figs. 4 and 6 share one
    for command in commands:
        assert run(*shlex.split(command))[0] == 0
    assert len(list(tmp_path.iterdir())) == 4


def test_the_same_case_gives_the_same_bytes(
    folder: Path, text: str, found: Intervals, tmp_path: Path, monkeypatch
) -> None:
    again = Case(DEFAULT)
    monkeypatch.setattr(build, "PICTURES", ("fig-3-detail", "fig-6", "claims"))
    build.draw(again, found, tmp_path, lambda done: None)
    for path in tmp_path.iterdir():
        assert path.read_bytes() == (folder / path.name).read_bytes(), path.name
    pictures = {path.stem: path.read_text("utf-8") for path in folder.glob("*.svg")}
    assert page(again, found, pictures) == text


def test_verdicts_depend_on_alpha_alone(case: Case) -> None:
    assert OTHER.alpha == pytest.approx(1, rel=1e-12)
    other = Case(OTHER)
    for part in build.PARTS:
        assert part.of(other).holds == part.of(case).holds, part.words


def test_friction_against_the_belt_is_found() -> None:
    belt = replace(DEFAULT, mu_k=0.2, normal_force=400 / 1.2)
    part = next(claim for claim in CLAIMS if claim.name == "friction").parts[1]
    assert not part.of(Case(belt)).holds


@pytest.mark.parametrize("alpha", [1e-6, 1.25e-3, 0.25, 50.0, 1e6])
def test_every_claim_is_decided_at_the_extremes(alpha: float) -> None:
    case = at_alpha(DEFAULT, alpha)
    for part in build.PARTS:
        assert part.of(case).numbers


def test_the_ripple_of_many_harmonics_is_that_of_gibbs() -> None:
    constant = sici(np.pi)[0] / np.pi - 0.5
    assert pytest.approx(constant, rel=1e-12) == checks_fourier.GIBBS
    assert Case(DEFAULT).overshoot("hb", 160) == pytest.approx(constant, rel=0.02)


def test_what_the_claims_say_of_the_default_case_is_what_a_sweep_says(case: Case) -> None:
    rows = {(r.method, r.order): r.errors for r in ns.sweep(DEFAULT, orders=range(1, 41)).rows}
    period = {key: abs(e.period) for key, e in rows.items() if e}
    behind = [N for N in range(1, 13) if period["c1", N] > period["hb-c1", N]]
    assert behind == [1, 2, 3, 4]
    assert case.behind("period", "c1", "hb-c1") == behind
    assert max(period["c1", N] for N in range(4, 41)) < 1e-3 < period["c1", 3]
    assert all(period["hb-c1", N] < period["hb", N] for N in range(1, 41))
    acceleration = {key: e.acceleration for key, e in rows.items() if e}
    up = [N for N in range(2, 41) if acceleration["hb", N] > acceleration["hb", N - 1]]
    assert up == checks_fourier.rises(case, "hb") == [5, 15, 22, 25, 32]


@pytest.mark.parametrize(
    ("check", "force"),
    [
        (checks_c1.in_band_with_any_solution, 342.5),
        (checks_c1.in_band_from_three, 1163),
        (checks_c1.beyond_three, None),
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


def test_claims_have_names_of_their_own() -> None:
    names = [claim.name for claim in CLAIMS]
    assert len(set(names)) == len(names) >= 25
    assert NOT_QUITE.keys() <= set(names)


def refused(run, *arguments: object) -> str:
    status, out, err = run("report", *arguments)
    assert (status, out) == (2, "")
    assert err.startswith("nonsmooth: ")
    return err


def test_a_folder_is_needed(run) -> None:
    assert "-o" in refused(run)


def test_a_folder_with_other_files_is_left_alone(run, tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("x")
    assert "has thesis.tex in it" in refused(run, "-o", tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["thesis.tex"]


def test_a_page_that_report_did_not_make_is_left_alone(run, tmp_path: Path) -> None:
    (tmp_path / "index.html").write_text("mine")
    assert "has a page that is not ours" in refused(run, "-o", tmp_path)
    assert (tmp_path / "index.html").read_text() == "mine"


def test_a_file_in_the_place_of_the_folder(run, tmp_path: Path) -> None:
    target = tmp_path / "report"
    target.write_text("x")
    assert "expected a folder" in refused(run, "-o", target)


def test_a_folder_in_no_folder(run, tmp_path: Path) -> None:
    assert "does not exist" in refused(run, "-o", tmp_path / "no" / "report")


@pytest.mark.parametrize("library", ["matplotlib", "jinja2"])
def test_what_a_report_needs_is_said(run, tmp_path: Path, library: str, monkeypatch) -> None:
    monkeypatch.setattr("nonsmooth.cli.output.find_spec", lambda name: name != library or None)
    error = refused(run, "-o", tmp_path / "report")
    assert f"needs {library}: pip install 'nonsmooth[report]'" in error


def test_an_oscillator_that_float64_cannot_hold(run, tmp_path: Path) -> None:
    assert "alpha" in refused(run, "--normal-force", 1e-12, "-o", tmp_path / "report")
    assert list(tmp_path.iterdir()) == []


def test_an_earlier_report_is_replaced(folder: Path, text: str) -> None:
    folders.check_folder(folder, build.FILES)

    def write(target: Path) -> None:
        for path in folder.iterdir():
            (target / path.name).write_bytes(path.read_bytes())

    folders.write_folder(folder, write)
    assert (folder / "index.html").read_text("utf-8") == text
    assert [path.name for path in folder.parent.iterdir()] == [folder.name]


def test_a_report_that_fails_leaves_the_old_one(folder: Path, text: str) -> None:
    def fail(target: Path) -> None:
        (target / "index.html").write_text("half")
        raise RuntimeError

    with pytest.raises(RuntimeError):
        folders.write_folder(folder, fail)
    assert (folder / "index.html").read_text("utf-8") == text
    assert [path.name for path in folder.parent.iterdir()] == [folder.name]
