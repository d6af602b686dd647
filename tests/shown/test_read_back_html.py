"""The equations of a page, read back from their MathML: they are the record's."""

import re
from collections import Counter

import pytest
from reading import mathml
from reading.compare import differences
from reading.expected import notes, rows
from reading.printed import html_of
from reading.prose import bare


@pytest.mark.parametrize("order", [None, 1, pytest.param(3, marks=pytest.mark.long)])
def test_every_equation_of_the_page_reads_as_its_record(order: int | None) -> None:
    printed = list(mathml.equations(html_of(order)))
    meant = [(bare(head), row.number, bare(row.words)) for head, row in rows(order)]
    assert [(bare(row.heading), row.number, bare(row.words)) for row in printed] == meant
    wrong = [
        differences(equation, found.tokens, spaced=True)
        for (_, equation), found in zip(rows(order), printed, strict=True)
    ]
    assert not any(wrong), "\n".join(filter(None, wrong))


def test_the_anchor_of_an_equation_counts_those_of_its_number() -> None:
    seen: Counter[str] = Counter()
    for printed in mathml.equations(html_of(None)):
        seen[printed.number] += 1
        again = f"-{seen[printed.number]}" if seen[printed.number] > 1 else ""
        assert printed.anchor == (f"eq-{printed.number}{again}" if printed.number else "")


def test_the_sentence_below_a_heading_names_the_unknowns() -> None:
    shown = bare(mathml.words(html_of(2)))
    for note in notes(2):
        assert bare(note) in shown


def test_what_the_paper_does_not_number_and_a_kernel_computes_is_folded() -> None:
    page = html_of(None)
    folded = re.findall(r"<details>(.*?)</details>", page, flags=re.DOTALL)
    assert folded
    for part in folded:
        assert part.count("<figure") >= 2
        assert 'class="number"' not in part
    assert "integral" in folded[0]
    assert "exact orbit" not in "".join(folded)
