"""The report: its page, its files, and what is left where it fails."""

import re
import shlex
from html.parser import HTMLParser
from pathlib import Path

import pytest

pytest.importorskip("matplotlib")
pytest.importorskip("jinja2")

from computed import acceleration_errors, period_errors
from computed import case as shared
from written import value

import nonsmooth as ns
from nonsmooth.cli import folders
from nonsmooth.report import build
from nonsmooth.report.case import Case
from nonsmooth.report.claims import CLAIMS
from nonsmooth.report.claims.quotations import QUOTATIONS
from nonsmooth.report.intervals import Interval, Intervals
from nonsmooth.report.page import page, prose
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT

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
    return shared(DEFAULT)


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
        quoted = QUOTATIONS[claim.name]
        assert f'“{prose(quoted.words)}” <span class="where">{quoted.section}<' in article
        ours = [prose(part.ours) for part in claim.parts if part.ours]
        assert re.findall(r"\(our threshold: (.*?)\)</span>", article) == ours
        kind = {"holds": "holds", "holds in part": "in-part", "does not hold": "not"}[shown[1]]
        assert f'<article class="claim {kind}"' in article
        marks = re.findall(r'class="mark">(.)<', article)
        counted = [
            mark == "✓" for mark, part in zip(marks, claim.parts, strict=True) if part.counts
        ]
        assert (all(counted), any(counted)) == (kind == "holds", kind != "not")


def test_the_table_of_the_page_has_the_errors_of_the_rows(text: str) -> None:
    table, _ = re.findall(r"<table>.*?</table>", text, re.DOTALL)
    assert re.findall(r"N = (\d+)", table) == ["3", "10", "40"]
    assert re.findall(r"<th scope=\"col\">(.*?)</th>", table) == ["err. T", "acc. err (22)"] * 3
    assert "hb 6.43\xa0% instead of 5.86\xa0%." in text.partition("</table>")[2][:500]
    rows = re.findall(r"<tr><th scope=\"row\"><code>(.*?)</code>(.*?)</tr>", table, re.DOTALL)
    assert [name for name, _ in rows] == ["hb", "hb-c1", "c1"]
    for name, cells in rows:
        errors = [
            errors_of(DEFAULT, name) for errors_of in (period_errors, acceleration_errors)
        ]
        expected = [error[N] for N in (3, 10, 40) for error in errors]
        for cell, error in zip(re.findall(r"<td>(.*?)</td>", cells), expected, strict=True):
            if abs(error) < 1e-12 or cell == "rounding":
                assert (cell, abs(error) < 2e-8) == ("rounding", True)
            else:
                assert value(cell.removesuffix("\xa0%").removesuffix(" %")) == pytest.approx(
                    100 * error, rel=5.001e-3
                )


def test_the_page_on_the_paper_counts_the_verdicts() -> None:
    page = (Path(__file__).parents[2] / "docs/method/paper.md").read_text("utf-8")
    part = list(NOT_QUITE.values()).count("holds in part")
    counted = f"{len(CLAIMS) - len(NOT_QUITE)} of {len(CLAIMS)} hold, {part} in part"
    assert counted in page


def test_the_page_says_who_chose_the_normal_force(text: str) -> None:
    assert "= 400 N is assumed:" in text
    assert 'id="ours"><strong>What is ours and what is the paper’s:</strong> The three' in text
    assert "0.671239" in text
    assert ns.__version__ in text


def test_the_commands_on_the_page_run(text: str, run, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(build, "save", lambda figure, target: target.write_bytes(b""))
    monkeypatch.setattr(build, "Case", shared)
    commands = set(re.findall(r"<pre><code>nonsmooth (.*?)</code></pre>", text))
    commands.remove("report -o report")
    for command in commands:
        assert run(*shlex.split(command))[0] == 0
    assert {path.name for path in tmp_path.iterdir()} == {f"fig{n}.pdf" for n in range(1, 7)}


def test_the_same_case_gives_the_same_bytes(
    folder: Path, text: str, found: Intervals, tmp_path: Path, monkeypatch
) -> None:
    again = Case(DEFAULT)
    monkeypatch.setattr(build, "PICTURES", ("fig-3-detail", "claims"))
    build.draw(again, found, tmp_path, lambda done: None)
    for path in tmp_path.iterdir():
        assert path.read_bytes() == (folder / path.name).read_bytes(), path.name
    pictures = {path.stem: path.read_text("utf-8") for path in folder.glob("*.svg")}
    assert page(again, found, pictures) == text


def test_claims_have_names_of_their_own() -> None:
    names = [claim.name for claim in CLAIMS]
    assert len(set(names)) == len(names) >= 25
    assert NOT_QUITE.keys() <= set(names)


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
