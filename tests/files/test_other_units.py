"""The same oscillator in grams, millimetres and milliseconds: every number that is shown."""

import json
import re
from typing import Any

import pytest
import units
from units import (
    BELT,
    COEFFICIENTS,
    GRAM_MILLIMETRE_MILLISECOND,
    METHODS,
    POWERS,
    SCALARS,
    Units,
    flags,
    leaves,
)

import nonsmooth as ns

OTHER = pytest.mark.parametrize(
    "other", [POWERS, GRAM_MILLIMETRE_MILLISECOND], ids=["powers", "g, mm, ms"]
)
#: Parts of a document without a unit, whatever the names in them, and what differs anyway.
WITHOUT = {"errors", "estimate", "outcome", "rates", "trials", "transition_mismatch", "units"}
ANYWAY = {"seconds", "sha256"}

#: A number of seconds in a text, such as why a solution is not an orbit.
SECONDS = r"-?\d\S*(?= s\b)"


def unit_of(path: tuple[Any, ...], method: str) -> tuple[str, int]:
    """Return the unit of a number in a document, and its place in its list."""
    number = path[-1] if isinstance(path[-1], int) else 0
    if WITHOUT & set(path):
        return "1", number
    if "coefficients" in path:
        return COEFFICIENTS[method][path[path.index("coefficients") + 1]], number
    name = next(part for part in reversed(path) if isinstance(part, str))
    return SCALARS.get(name, "1"), number


def assert_scaled(here: Any, there: Any, factor: float, other: Units, what: object) -> None:
    """Check one number; that powers of two are changed by does not even round."""
    if isinstance(here, str):
        seconds = [re.findall(SECONDS, text) for text in (here, there)]
        for one, two in zip(*seconds, strict=True):
            assert float(two) == pytest.approx(float(one) * other.s, rel=2e-5), what
        assert re.sub(SECONDS, "", there) == re.sub(SECONDS, "", here), what
    elif not isinstance(here, float):
        assert there == here, what
    elif other is POWERS:
        assert there == here * factor, what
    else:
        assert there == pytest.approx(here * factor, rel=1e-9, abs=1e-13 * factor), what


def assert_documents_scaled(first: Any, second: Any, other: Units, vary: str = "") -> None:
    here, there = leaves(first), leaves(second)
    assert here.keys() == there.keys()
    methods = {path[:-1]: leaf for path, leaf in here.items() if path[-1] == "method"}
    moved = 0
    for path, leaf in here.items():
        if ANYWAY & set(path):
            continue
        method = methods.get((), methods.get(path[:2], ""))
        unit, n = unit_of(path, method)
        if path[-1] == "value":
            unit = units.PARAMETERS[vary]
        assert_scaled(leaf, there[path], other.of(unit, n), other, path)
        moved += unit != "1" and isinstance(leaf, float)
    assert moved > 3


def document(run, *arguments: object) -> Any:
    return json.loads(run(*arguments, "--json")[1])


@OTHER
@pytest.mark.parametrize(("method", "terms"), METHODS)
def test_the_document_of_an_orbit(other: Units, method: str, terms: int, run) -> None:
    arguments = ("solve", "--method", method, "--order", 7, "--c1-terms", terms)
    first, second = (
        document(run, *arguments, *flags(belt)) for belt in (BELT, other.belt(BELT))
    )
    assert first["coefficients"]
    for each in (first, second):  # Newton's corrections at rounding, not results
        del each["outcome"], each["residual_norm"]
    assert_documents_scaled(first, second, other)


@OTHER
def test_the_document_of_a_sweep(other: Units, run) -> None:
    arguments = ("sweep", "--orders", "4-6")
    first, second = (
        document(run, *arguments, *flags(belt)) for belt in (BELT, other.belt(BELT))
    )
    assert_documents_scaled(first, second, other)


@OTHER
def test_the_document_of_all_roots(other: Units, run) -> None:
    first, second = (
        document(run, "roots", "--order", 6, *flags(belt)) for belt in (BELT, other.belt(BELT))
    )
    assert_documents_scaled(first, second, other)


@OTHER
def test_the_precise_digits(other: Units, run) -> None:
    pytest.importorskip("flint")
    arguments = ("solve", "--method", "c1", "--order", 5, "--digits", 15)
    first, second = (
        document(run, *arguments, *flags(belt))["precise"] for belt in (BELT, other.belt(BELT))
    )
    for name in ("t1", "period"):
        expected = float(first[name]) * other.of("s")
        assert float(second[name]) == pytest.approx(expected, rel=1e-12)


def swept(parameter: str, belt: ns.StickSlip, *more: object) -> tuple[object, ...]:
    """Return a sweep from the parameter of an oscillator to 9/8 of it."""
    value = getattr(belt, parameter)
    ends = f"{parameter}={value!r}:{1.125 * value!r}:2"
    return ("sweep", "--vary", ends, *flags(belt, parameter), "--methods", "hb,c1", *more)


@OTHER
@pytest.mark.parametrize("parameter", units.PARAMETERS)
def test_the_document_of_a_family(other: Units, parameter: str, run) -> None:
    first, second = (
        document(run, *swept(parameter, belt, "--orders", 7))
        for belt in (BELT, other.belt(BELT))
    )
    assert len(first["rows"]) == 4
    assert_documents_scaled(first, second, other, vary=parameter)


def rows_of(out: str) -> list[dict[str, str]]:
    """Return the rows of a table by the heads of its columns; not the exact orbit's."""
    lines = [line.replace(" [", "[") for line in out.splitlines()]
    first = next(i for i, line in enumerate(lines) if "T[s]" in line)
    heads = lines[first].split()
    rows = []
    for line in lines[first + 1 :]:
        if line.startswith("   "):  # the rest of a long verdict
            continue
        if not re.match(r"(exact|hb|hb-c1|c1|\d*\.\S*) ", line):
            break
        rows.append(line.split(maxsplit=len(heads) - 1))
    return [dict(zip(heads, row, strict=True)) for row in rows if row[0] != "exact"]


@OTHER
@pytest.mark.parametrize("command", ["solve", "roots", *units.PARAMETERS])
def test_the_tables(command: str, other: Units, run) -> None:
    tables = []
    for belt in (BELT, other.belt(BELT)):
        own = (command, "--order", 6, *flags(belt))
        arguments = swept(command, belt, "--orders", 7) if command in SCALARS else own
        tables.append(rows_of(run(*arguments)[1]))
    assert len(tables[0]) >= 3
    for here, there in zip(*tables, strict=True):
        for head, text in here.items():
            unit = re.search(r"\[(.*)\]", head)
            if unit is not None:
                expected = float(text) * other.of(unit[1])  # of six figures
                assert float(there[head]) == pytest.approx(expected, rel=2e-5), head
            elif head in {"method", "N", "alpha", "stick/T"}:
                assert there[head] == text, head


@OTHER
def test_the_table_of_convergence(other: Units, run) -> None:
    arguments = ("sweep", "--methods", "c1", "--orders", "5-7")
    here, there = (
        rows_of(run(*arguments, *flags(belt))[1]) for belt in (BELT, other.belt(BELT))
    )
    assert [row["N"] for row in there] == ["5", "6", "7"]
    for one, two in zip(here, there, strict=True):
        assert float(two["T[s]"]) == pytest.approx(float(one["T[s]"]) * other.s, rel=1e-8)
