"""The equations in LaTeX, read back: document, fragment and notebook show the record's."""

import re

import pytest
from reading import latex
from reading.compare import differences
from reading.expected import RECORDS, notes, rows
from reading.printed import fragment_of
from reading.prose import bare, mathematics_in

from nonsmooth.codegen import derive
from nonsmooth.codegen.shortcuts.document import latex_document, latex_fragment


@pytest.mark.parametrize("order", [None, 1, 2, pytest.param(4, marks=pytest.mark.long)])
def test_every_equation_of_the_fragment_reads_as_its_record(order: int | None) -> None:
    printed = list(latex.equations(fragment_of(order)))
    meant = [(bare(head), row.number, bare(row.words)) for head, row in rows(order)]
    assert [(bare(row.heading), row.number, bare(row.words)) for row in printed] == meant
    wrong = [
        differences(equation, found.tokens, spaced=True)
        for (_, equation), found in zip(rows(order), printed, strict=True)
    ]
    assert not any(wrong), "\n".join(filter(None, wrong))


def test_a_document_has_the_body_of_the_fragment() -> None:
    document, fragment = latex_document(["c1"]), latex_fragment(["c1"])
    body = re.sub(r"(?m)\A(?:%.*\n)*", "", fragment)
    assert re.match(r"\\documentclass\[a4paper\]{article}\n", document)
    assert document.endswith(f"{body}\n\\end{{document}}\n")
    assert "\\begin{document}" in document.removesuffix(f"{body}\n\\end{{document}}\n")


def test_the_sentence_below_a_heading_names_the_unknowns() -> None:
    shown = bare(fragment_of(2))
    for note in notes(2):
        assert bare(note) in shown


@pytest.mark.parametrize("method", RECORDS)
def test_what_stands_between_the_words_is_set_as_mathematics(method: str) -> None:
    for printed in latex.equations(latex_fragment([method])):
        words = re.sub(r"\$[^$]*\$", "", printed.words)
        assert not mathematics_in(words), printed.words


def test_a_record_its_equations_and_a_notebook_show_the_same() -> None:
    record = derive("hb-symmetric")
    alone = [row.latex() for row in record.equations]
    fragment = list(latex.equations(record.latex()))
    notebook = list(latex.equations(record._repr_latex_()))
    for equation, display, *others in zip(
        record.equations, alone, fragment, notebook, strict=True
    ):
        assert equation._repr_latex_() == display
        for found in others:
            assert f"\n{found.body}\n" in display
            assert (bare(found.words), found.number) == (bare(equation.words), equation.number)
            assert not differences(equation, found.tokens, spaced=True)
