"""What is shown of a scene as text, LaTeX, HTML and PDF: within the line, read back."""

import re
import shutil
import subprocess
import xml.etree.ElementTree as ET
from functools import cache
from pathlib import Path

import pytest
from every_run import tried
from shown_reading import drawn_tokens, functions, page_tokens, typeset_tokens, wrong
from shown_scenes import EVERY_RUN, SCENES

import nonsmooth as ns
from nonsmooth.cli.commands import tex
from nonsmooth.codegen.equations import sections
from nonsmooth.codegen.printing.html import page_of
from nonsmooth.codegen.printing.latex import aligned, document_of, fragment_of
from nonsmooth.codegen.printing.text import text_of
from nonsmooth.codegen.system import Equation, Section

__all__ = ["functions"]

#: Methods of each scene that are printed; all together have every kind of term.
METHODS = {
    "impact": ("ck", "hb-ck"),
    "stick-slip": ("hb", "hb-c1", "ck"),
    "stick-slip-damped": ("ck-tau",),
    "clearance": ("hb",),
    "stops": ("hb-ck",),
    "impact-two-sided": ("ck-tau",),
    "elastic-plastic": ("hb",),
    "impact-inelastic": ("hb",),
}


@cache
def parts(scene: str) -> list[Section]:
    return sections(SCENES[scene], METHODS[scene])


def shown(scene: str) -> list[Equation]:
    return [row for part in parts(scene) for row in part.equations]


@pytest.mark.usefixtures("functions")
@pytest.mark.parametrize("scene", tried(SCENES, every_run=EVERY_RUN))
def test_every_equation_reads_as_its_record(scene: str) -> None:
    found = []
    for row in dict.fromkeys(shown(scene)):
        found.append(wrong(row, drawn_tokens(row, True), spaced=False, raised=True))
        found.append(wrong(row, drawn_tokens(row, False), spaced=False, raised=False))
        found.append(wrong(row, typeset_tokens(row), spaced=True, raised=True))
        found.append(wrong(row, page_tokens(row), spaced=True, raised=True))
    assert not any(found), "\n".join(filter(None, found))


@pytest.mark.parametrize("unicode", [True, False])
@pytest.mark.parametrize("scene", tried(SCENES, every_run=EVERY_RUN))
def test_text_fits_a_terminal(scene: str, unicode: bool) -> None:
    text = text_of(parts(scene), unicode)
    assert [line for line in text.splitlines() if len(line) > 80] == []
    assert text.isascii() is not unicode
    assert "`" not in text
    assert not re.search(r"[ \t]$", text, flags=re.MULTILINE)


@pytest.mark.parametrize("scene", ["impact", "stick-slip"])
def test_a_page_is_well_formed_and_fetches_nothing(scene: str) -> None:
    text = page_of(parts(scene), "a < b")
    body = text[text.index("<body>") : text.index("</html>")].replace("<wbr>", "")
    ET.fromstring(body.replace("&nbsp;", " "))
    assert "\\" not in text
    assert "`" not in text
    assert "<title>a &lt; b</title>" in text
    for fetching in ("<script", "<link", "<img", "src=", "@import", "url(", "<merror"):
        assert fetching not in text
    addresses = set(re.findall(r"https?://[^\"]*", text))
    assert addresses == {"http://www.w3.org/1998/Math/MathML"}
    anchors = re.findall(r'id="([^"]+)"', text)
    assert len(anchors) == len(set(anchors)) == sum(bool(row.number) for row in shown(scene))
    assert [f"#{anchor}" for anchor in anchors] == re.findall(r'href="([^"]+)"', text)


#: What brackets of LaTeX are, by the kind of pair that must stand on one line.
BRACKETS = (r"\(|\\left\b", r"\)|\\right\b")


@pytest.mark.parametrize("scene", tried(SCENES, every_run=EVERY_RUN))
def test_a_line_of_latex_is_broken_only_in_brackets_that_bear_it(scene: str) -> None:
    """They have a fixed size, all others close on their line; short ones are not broken."""
    for row in shown(scene):
        body = aligned(row)
        assert body.count(r"\biggl") == body.count(r"\biggr")
        for line in re.split(r"\\\\\n", re.sub(r"\\bigg[lr].", "", body)):
            assert len({len(re.findall(q, line)) for q in BRACKETS}) == 1, line
        for inside in re.findall(r"\\biggl\((.*?)\\biggr\)", body, re.DOTALL):
            assert len(inside) > 60 or r"\\" not in inside, body


def test_a_long_product_is_broken_between_its_factors() -> None:
    record = ns.equations("ck", scene="clearance")
    row = next(q for q in record.equations if q.title.startswith("polynomial in"))
    assert "bigg" not in aligned(row)
    assert "\\\\\n&\\quad \\cdot (n - l + 1)\n" in aligned(row)
    assert "⋅(n - l + 1)" in row.text()
    assert "*(n - l + 1)" in row.text(unicode=False)


@pytest.mark.parametrize("unicode", [True, False])
def test_a_record_its_equations_and_a_notebook_show_the_same(unicode: bool) -> None:
    record = ns.equations("hb-c1")
    document, shown_there, text = record.latex(), record._repr_latex_(), record.text(unicode)
    for row in record.equations:
        assert aligned(row) in row.latex() == row._repr_latex_()
        assert row.latex() in document
        assert row.latex() in shown_there
        assert row.text(unicode) in text
        assert (rf"\tag{{{row.number}}}" if row.number else r"\notag") in row.latex()


def test_the_command_takes_the_format_from_the_name(run, tmp_path: Path) -> None:
    begins = {"txt": "stick-slip", "tex": "\\documentclass", "html": "<!DOCTYPE html>"}
    begins |= {"pdf": "%PDF-"} if shutil.which("pdflatex") else {}
    for suffix, beginning in begins.items():
        target = tmp_path / f"c1.{suffix}"
        status, out, err = run("equations", "--method", "hb", "-o", target)
        assert (status, out, err) == (0, "", f"wrote {target}\n")
        assert target.read_bytes().startswith(beginning.encode())
    assert len([*tmp_path.iterdir()]) == len(begins)  # and nothing of TeX's own


def test_the_command_prints_plain_ascii_where_asked(run, monkeypatch) -> None:
    monkeypatch.setenv("LC_ALL", "C")
    status, out, _ = run("equations", "--method", "c1")
    assert (status, out.isascii(), "Sum" in out) == (0, True, True)


def test_a_pdf_without_tex_says_what_to_install(run, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    target = tmp_path / "c1.pdf"
    status, out, err = run("equations", "--method", "hb", "--format", "pdf", "-o", target)
    assert (status, out) == (2, "")
    assert "pdf needs pdflatex" in err
    assert "--format latex" in err
    assert not target.exists()


def test_a_pdf_that_fails_shows_the_first_error_and_leaves_the_file(
    run, tmp_path: Path, monkeypatch
) -> None:
    if shutil.which("pdflatex") is None:
        pytest.skip("pdflatex is not installed")
    from nonsmooth.codegen.printing import latex

    wrong = "\\documentclass{article}\n\\begin{document}\n\\wrong\n\\end{document}\n"
    monkeypatch.setattr(latex, "document_of", lambda sections, title: wrong)
    target = tmp_path / "c1.pdf"
    target.write_text("before")
    status, _, err = run("equations", "--method", "hb", "-o", target)
    assert status == 2
    assert "! Undefined control sequence. l.3 \\wrong" in err
    assert target.read_text() == "before"


def test_latex_compiles_within_the_margins(tmp_path: Path) -> None:
    compiler = shutil.which("pdflatex")
    if compiler is None:
        pytest.skip("pdflatex is not installed")
    some = [*parts("stick-slip-damped"), *parts("stops")]
    document = document_of(some, "Any scene & 100 %")
    assert fragment_of(some).endswith(
        document.partition("\\section*")[2].rpartition("\n\\end")[0]
    )
    (tmp_path / "document.tex").write_text(document, "utf-8")
    command = [compiler, *tex.COMMAND, "document.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-2000:]
    assert "Overfull" not in done.stdout
    assert (tmp_path / "document.pdf").is_file()
