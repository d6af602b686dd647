"""The page on the paper: what is on it, and that it stands by itself."""

import math
import re
from pathlib import Path

import pytest

pytest.importorskip("matplotlib")
pytest.importorskip("jinja2")

from computed import acceleration_errors, period_errors
from computed import case as shared
from written import Elements, value

import nonsmooth as ns
from nonsmooth.cli import output
from nonsmooth.report import build
from nonsmooth.report.case import DEFAULT
from nonsmooth.report.claims import CLAIMS, PARTS
from nonsmooth.report.html import prose
from nonsmooth.report.intervals import Intervals


@pytest.fixture(scope="module")
def found() -> Intervals:
    """Return made-up intervals: what they are is tested apart from the page."""
    return {part: [(0, 0.5), (0.9, math.inf)] for part in PARTS}


@pytest.fixture(scope="module")
def folder(tmp_path_factory, found: Intervals) -> Path:
    """Return a report but for the scan, which takes half a minute."""
    made = tmp_path_factory.mktemp("report") / "made"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(build, "scan", lambda belt, parts, done, run: found)
        patch.setattr(build, "Case", shared)
        output.write_folder(made, lambda target: build.build(DEFAULT, target, print))
    return made


@pytest.fixture(scope="module")
def text(folder: Path) -> str:
    return (folder / "index.html").read_text("utf-8")


@pytest.fixture(scope="module")
def elements(text: str) -> Elements:
    return Elements(text)


def test_a_report_has_all_its_files_and_no_others(folder: Path) -> None:
    assert {path.name for path in folder.iterdir()} == build.FILES
    assert all((folder / name).stat().st_size > 1000 for name in build.FILES)


def test_the_page_needs_nothing_from_outside(text: str, elements: Elements) -> None:
    assert not re.search(r"https?:|url\(http|@import", text)
    tags = {tag for tag, _ in elements.found}
    assert {"script", "link", "img", "iframe", "object"}.isdisjoint(tags)
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
    assert len(labels) == len(set(labels)) == len(build.PICTURES)
    assert all(label and len(label) > 20 for label in labels)


def test_every_equation_of_the_paper_is_on_the_page(elements: Elements) -> None:
    """None is left out: (21) and (22) are of the page itself, the others are derived.

    Which stands at which row is tested with what is shown; (9) is in Section 3.3 alone.
    """
    anchors = {a["id"] for _, a in elements.found if str(a.get("id")).startswith("eq-")}
    assert {f"eq-{n}" for n in range(1, 23)} <= anchors
    assert sum(tag == "math" for tag, _ in elements.found) > 100


def test_every_claim_has_a_verdict_and_intervals(text: str) -> None:
    articles = re.findall(r"<article.*?</article>", text, re.DOTALL)
    for claim, article in zip(CLAIMS, articles, strict=True):
        findings = [part.of(shared()) for part in claim.parts]
        verdict = claim.verdict([finding.holds for finding in findings])
        kind = {"holds": "holds", "holds in part": "in-part", "does not hold": "not"}[verdict]
        assert f'<article class="claim {kind}"' in article
        assert f'class="verdict">{verdict}<' in article
        assert f'{prose(claim.words)} <span class="where">{claim.where}<' in article
        assert f'“{prose(claim.quoted)}” <span class="where">{claim.source}<' in article
        marks = re.findall(r'class="mark">(.)<', article)
        assert marks == ["✓" if finding.holds else "✗" for finding in findings]
        shown = re.findall(r"<dd>(.*?)</dd>", article)
        assert shown[::2] == [prose(finding.numbers) for finding in findings]
        assert set(shown[1::2]) == {"up to 200\xa0N and from 360\xa0N up"}
        ours = [prose(part.ours) for part in claim.parts if part.ours]
        assert re.findall(r"\(our threshold: (.*?)\)</span>", article) == ours
        readings = sum(not part.counts for part in claim.parts)
        assert article.count("Otherwise read:") == readings
        assert f'class="note">{prose(claim.note)}<' in article or not claim.note


def test_the_table_of_the_page_has_the_errors_of_the_rows(text: str) -> None:
    (table,) = re.findall(r"<table>.*?</table>", text, re.DOTALL)
    assert re.findall(r"N = (\d+)", table) == ["3", "10", "40"]
    assert re.findall(r"<th scope=\"col\">(.*?)</th>", table) == ["err. T", "acc. err (22)"] * 3
    assert "hb 6.43\xa0% instead of 5.86\xa0%." in text.partition("</table>")[2][:500]
    rows = re.findall(r"<tr><th scope=\"row\"><code>(.*?)</code>(.*?)</tr>", table, re.DOTALL)
    assert [name for name, _ in rows] == ["hb", "hb-c1", "c1"]
    for name, cells in rows:
        errors = [of(DEFAULT, name) for of in (period_errors, acceleration_errors)]
        expected = [error[N] for N in (3, 10, 40) for error in errors]
        for cell, error in zip(re.findall(r"<td>(.*?)</td>", cells), expected, strict=True):
            if abs(error) < 1e-12 or cell == "rounding":
                assert (cell, abs(error) < 2e-8) == ("rounding", True)
            else:
                shown = value(cell.removesuffix("%").strip())
                assert shown == pytest.approx(100 * error, rel=5.001e-3)


def test_the_verdicts_are_counted(text: str) -> None:
    tally = re.findall(r"<b>(\d+)</b> of 25\nclaims ([a-z ]+)", text)
    assert [words for _, words in tally] == ["hold", "hold in part", "does not hold"]
    hold, part, _ = (count for count, _ in tally)
    docs = (Path(__file__).parents[2] / "docs/method/paper.md").read_text("utf-8")
    assert f"{hold} of 25 hold, {part} in part" in docs


def test_the_page_says_whose_oscillator_and_what_is_ours(text: str) -> None:
    assert "= 400 N is assumed:" in text
    assert "M\xa0=\xa010\xa0kg, K\xa0=\xa01000\xa0N/m, V\xa0=\xa01\xa0m/s" in text
    told = "is ours, and not in the paper: c1-tau. At N\xa0=\xa08 the period is"
    assert told in text.replace("\n", " ")
    assert "0.671239" in text
    assert ns.__version__ in text


def test_an_earlier_report_is_replaced_whole_or_not_at_all(folder: Path, text: str) -> None:
    output.check_folder(folder, build.FILES)
    kept = {path.name: path.read_bytes() for path in folder.iterdir()}

    def write(target: Path) -> None:
        for name, content in kept.items():
            (target / name).write_bytes(content)

    def fail(target: Path) -> None:
        (target / "index.html").write_text("half")
        raise RuntimeError

    output.write_folder(folder, write)
    assert (folder / "index.html").read_text("utf-8") == text
    with pytest.raises(RuntimeError):
        output.write_folder(folder, fail)
    assert (folder / "index.html").read_text("utf-8") == text
    assert [path.name for path in folder.parent.iterdir()] == [folder.name]
