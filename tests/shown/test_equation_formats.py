"""The equations as text, LaTeX, HTML and PDF: complete, within the line, self-contained."""

import re
import shutil
import subprocess
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
import sympy as sp
from reading.expected import RECORDS
from reading.printed import fragment_of, html_of, text_of

from nonsmooth.cli import tex
from nonsmooth.codegen import METHODS, SOLVED
from nonsmooth.codegen.printing.drawing import drawn
from nonsmooth.codegen.printing.html import STYLE
from nonsmooth.codegen.printing.pieces import pieces, signed
from nonsmooth.codegen.shortcuts.document import (
    equations_html,
    latex_document,
    sections,
    text_document,
)

#: Without a number, the equations for any N; the widest are those of the highest order.
ORDERS = (None, pytest.param(5, marks=pytest.mark.long))


def sides() -> list[sp.Expr]:
    """Return every side that is shown, for any N and for N = 2."""
    return [
        side
        for order in (None, 2)
        for section in sections(METHODS, order)
        for equation in section.equations
        for side in equation.sides
    ]


def together(side: sp.Expr, limit: int) -> sp.Expr:
    """Return what the pieces of `side` are when their signs and brackets are read."""
    totals, before = [sp.Integer(0)], []
    for piece in pieces(side, lambda term: drawn(term).width() > limit):
        first = piece.first
        for opening in piece.opens:
            sign, factor = signed(opening, first)
            before.append((-1 if sign == "-" else 1, factor))
            totals.append(sp.Integer(0))
            first = True
        sign, term = signed(piece.term, first)
        totals[-1] += -term if sign == "-" else term
        for bracket in piece.closes:
            sign, factor = before.pop()
            inside = totals.pop()
            assert bracket == ("]" if isinstance(factor, sp.Sum) else ")")
            whole = factor.func(inside, *factor.limits) if bracket == "]" else factor * inside
            totals[-1] += sign * whole
    (total,) = totals
    return total


@pytest.mark.parametrize("limit", [0, 40])
def test_the_pieces_of_a_side_are_the_side(limit: int) -> None:
    cut = 0
    for side in dict.fromkeys(sides()):
        cut += any(piece.opens for piece in pieces(side, lambda q: drawn(q).width() > limit))
        difference = together(side, limit) - side
        assert difference == 0 or sp.expand(difference.doit()) == 0, side
    assert cut > 0


@pytest.mark.parametrize("unicode", [True, False])
@pytest.mark.parametrize("order", ORDERS)
def test_text_fits_a_terminal(order: int | None, unicode: bool) -> None:
    text = (
        text_of(order)
        if unicode
        else text_document((*METHODS, *(SOLVED if order is None else ())), order, unicode=False)
    )
    assert max(map(len, text.splitlines())) <= 80
    assert text.isascii() is not unicode
    assert not re.search(r"[ \t]$", text, flags=re.MULTILINE)


@pytest.mark.parametrize("order", ORDERS)
def test_html_is_well_formed_and_fetches_nothing(order: int | None) -> None:
    text = html_of(order)
    body = text[text.index("<body>") : text.index("</html>")].replace("<wbr>", "")
    ET.fromstring(body.replace("&nbsp;", " "))
    for fetching in ("<script", "<link", "<img", "src=", "@import", "url("):
        assert fetching not in text
    addresses = set(re.findall(r"https?://[^\"]*", text))
    assert addresses == {"http://www.w3.org/1998/Math/MathML"}
    assert "\\" not in text  # a command that the converter does not know would stand there
    assert "<merror" not in text


def test_html_has_an_anchor_for_every_number() -> None:
    anchors = re.findall(r'id="([^"]+)"', html_of(None))
    assert len(anchors) == len(set(anchors))
    assert {f"eq-{number}" for number in range(1, 21)} <= set(anchors)
    assert {f"#{anchor}" for anchor in anchors} == set(
        re.findall(r'href="([^"]+)"', html_of(None))
    )


def test_html_fragment_is_the_body_of_the_page() -> None:
    assert equations_html(RECORDS) in html_of(None)
    assert STYLE in html_of(None)
    one = equations_html(["c1"])
    assert 'id="eq-18"' in one
    assert 'id="eq-14"' not in one


THESIS = r"""\documentclass{report}
\usepackage{amsmath,amssymb}
\begin{document}
\chapter{Equations}
\input{fragment}
\end{document}
"""


def compiled(document: str, folder: Path) -> str:
    """Return the log of pdflatex."""
    compiler = shutil.which("pdflatex")
    if compiler is None:
        pytest.skip("pdflatex is not installed")
    (folder / "document.tex").write_text(document, "utf-8")
    command = [compiler, *tex.COMMAND, "document.tex"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-2000:]
    return done.stdout


def test_latex_compiles_alone_within_the_margins(tmp_path: Path) -> None:
    assert "Overfull" not in compiled(latex_document(METHODS), tmp_path)


@pytest.mark.parametrize("order", ORDERS)
def test_fragment_compiles_within_the_narrow_margins_of_a_thesis(
    order: int | None, tmp_path: Path
) -> None:
    fragment = fragment_of(order)
    assert fragment.startswith("% Needs \\usepackage{amsmath,amssymb}")
    assert "documentclass" not in fragment
    (tmp_path / "fragment.tex").write_text(fragment, "utf-8")
    assert "Overfull" not in compiled(THESIS, tmp_path)


def test_equations_command_takes_the_format_from_the_name(run, tmp_path: Path) -> None:
    begins = {"txt": "Section 3.3", "tex": "\\documentclass", "html": "<!DOCTYPE html>"}
    for suffix, beginning in begins.items():
        target = tmp_path / f"c1.{suffix}"
        status, out, err = run("equations", "--method", "c1", "--expand", 1, "-o", target)
        assert (status, out, err) == (0, "", f"wrote {target}\n")
        assert target.read_text("utf-8").startswith(beginning)


def test_equations_command_prints_plain_ascii_where_asked(run, monkeypatch) -> None:
    monkeypatch.setenv("LC_ALL", "C")
    status, out, _ = run("equations", "--method", "c1")
    assert status == 0
    assert out.isascii()
    assert "Sum" in out


def test_equations_command_makes_a_pdf(run, tmp_path: Path) -> None:
    if shutil.which("pdflatex") is None:
        pytest.skip("pdflatex is not installed")
    target = tmp_path / "c1.pdf"
    assert run("equations", "--method", "c1", "-o", target)[0] == 0
    assert target.read_bytes().startswith(b"%PDF-")
    assert [path.name for path in tmp_path.iterdir()] == ["c1.pdf"]


def test_a_pdf_without_tex_says_what_to_install(run, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    target = tmp_path / "c1.pdf"
    status, out, err = run("equations", "--method", "c1", "--format", "pdf", "-o", target)
    assert (status, out) == (2, "")
    assert "pdf needs pdflatex" in err
    assert "--format latex" in err
    assert not target.exists()


def test_a_pdf_that_fails_shows_the_first_error_and_leaves_the_file(
    run, tmp_path: Path, monkeypatch
) -> None:
    if shutil.which("pdflatex") is None:
        pytest.skip("pdflatex is not installed")
    from nonsmooth.codegen.shortcuts import document

    wrong = "\\documentclass{article}\n\\begin{document}\n\\wrong\n\\end{document}\n"
    monkeypatch.setattr(document, "latex_document", lambda methods, order: wrong)
    target = tmp_path / "c1.pdf"
    target.write_text("before")
    status, _, err = run("equations", "-o", target)
    assert status == 2
    assert "! Undefined control sequence. l.3 \\wrong" in err
    assert target.read_text() == "before"
