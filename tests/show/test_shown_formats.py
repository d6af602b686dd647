"""What is shown of a scene as text, LaTeX, HTML and PDF: within the line, read back."""

import re
import shutil
import subprocess
import xml.etree.ElementTree as ET
from functools import cache
from pathlib import Path

import pytest
from every_run import tried
from shown_reading import drawn_tokens, functions, typeset_tokens, wrong
from shown_scenes import EVERY_RUN, SCENES

from nonsmooth.cli import tex
from nonsmooth.codegen.printing.html import page_of
from nonsmooth.codegen.printing.latex import document_of, fragment_of
from nonsmooth.codegen.printing.sections import Section
from nonsmooth.codegen.printing.text import text_of
from nonsmooth.codegen.show import sections
from nonsmooth.codegen.system import Equation

__all__ = ["functions"]

#: Methods of each scene that are printed; all together have every kind of term.
METHODS = {
    "impact": ("ck", "hb-ck"),
    "stick-slip": ("hb-c1",),
    "stick-slip-damped": ("ck-tau",),
    "contact": ("hb",),
    "stops": ("hb-ck",),
    "two-sided": ("ck-tau",),
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
    assert not any(found), "\n".join(filter(None, found))


@pytest.mark.parametrize("unicode", [True, False])
@pytest.mark.parametrize("scene", tried(SCENES, every_run=EVERY_RUN))
def test_text_fits_a_terminal(scene: str, unicode: bool) -> None:
    text = text_of(parts(scene), unicode)
    assert [line for line in text.splitlines() if len(line) > 80] == []
    assert text.isascii() is not unicode
    assert "`" not in text
    assert not re.search(r"[ \t]$", text, flags=re.MULTILINE)


@pytest.mark.parametrize("scene", ["impact"])
def test_a_page_is_well_formed_and_knows_every_command(scene: str) -> None:
    text = page_of(parts(scene), "a < b")
    body = text[text.index("<body>") : text.index("</html>")].replace("<wbr>", "")
    ET.fromstring(body.replace("&nbsp;", " "))
    assert "\\" not in text
    assert "`" not in text
    assert "<title>a &lt; b</title>" in text


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
