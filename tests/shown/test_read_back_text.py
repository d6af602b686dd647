"""The equations that a terminal shows, read back from their drawings: they are the record's."""

import pytest
from reading import text
from reading.compare import differences
from reading.expected import notes, rows
from reading.printed import text_of

from nonsmooth.codegen import derive

#: Without a number, the equations for any N; ASCII differs in the characters alone.
CASES = [
    *((order, True) for order in (None, 1, 2, 3)),
    *(pytest.param(order, True, marks=pytest.mark.long) for order in (4, 5)),
    (None, False),
    pytest.param(3, False, marks=pytest.mark.long),
]


def on_a_terminal(words: str, unicode: bool) -> str:
    """Return a title without the marks about its mathematics, in the signs of a terminal."""
    return words.replace("`", "").replace("mu_s", "μₛ" if unicode else "mu_s")


@pytest.mark.parametrize(("order", "unicode"), CASES)
def test_every_equation_of_the_document_reads_as_its_record(
    order: int | None, unicode: bool
) -> None:
    printed = list(text.equations(text_of(order, unicode)))
    meant = [(head, row.number, on_a_terminal(row.words, unicode)) for head, row in rows(order)]
    assert [(row.heading, row.number, row.words) for row in printed] == meant
    wrong = [
        differences(equation, found.tokens, spaced=False)
        for (_, equation), found in zip(rows(order), printed, strict=True)
    ]
    assert not any(wrong), "\n".join(filter(None, wrong))


def test_the_sentence_below_a_heading_names_the_unknowns() -> None:
    shown = " ".join(text_of(2).replace("_", "").split())
    for note in notes(2):
        assert note.replace("[", "").replace("]", "") in shown


@pytest.mark.parametrize("unicode", [True, False])
def test_a_record_and_its_equations_print_themselves(unicode: bool) -> None:
    record = derive("c1")
    printed = list(text.equations(record.text(unicode)))
    assert [row.number for row in printed] == [row.number for row in record.equations]
    for equation, found in zip(record.equations, printed, strict=True):
        (alone,) = text.equations(equation.text(unicode))
        assert alone.words == found.words == equation.words
        assert alone.tokens() == found.tokens()
        assert not differences(equation, found.tokens, spaced=False)
