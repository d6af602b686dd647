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

#: A number in a text, such as why a solution is not an orbit: of three figures or more.
NUMBER = r"(-?\d\S*) (s|m/s|m)\b"


def unit_of(path: tuple[Any, ...], method: str) -> tuple[str, int]:
    """Return the unit of a number in a document, and its place in its list."""
    number = path[-1] if isinstance(path[-1], int) else 0
    if WITHOUT & set(path):
        return "1", number
    if "coefficients" in path:
        return COEFFICIENTS[method][path[path.index("coefficients") + 1]], number
    name = next(part for part in reversed(path) if isinstance(part, str))
    return SCALARS.get(name, "1"), number


def assert_scaled(
    here: Any, there: Any, factor: float, other: Units, what: tuple[Any, ...]
) -> None:
    """Check one number; that powers of two are changed by does not even round."""
    if isinstance(here, str):
        numbers = [re.findall(NUMBER, text) for text in (here, there)]
        for (one, unit), (two, _) in zip(*numbers, strict=True):
            assert float(two) == pytest.approx(float(one) * other.of(unit), rel=1e-2), what
        assert re.sub(NUMBER, r"\2", there) == re.sub(NUMBER, r"\2", here), what
    elif not isinstance(here, float):
        assert there == here, what
    elif other is POWERS:
        assert there == here * factor, what
    else:  # (22) has the root of what the times are off by, which is rounding
        least = 1e-9 if what[-1] == "acceleration" else 1e-13 * factor
        assert there == pytest.approx(here * factor, rel=1e-9, abs=least), what


def assert_documents_scaled(first: Any, second: Any, other: Units, vary: str = "") -> None:
    here, there = leaves(first), leaves(second)
    assert here.keys() == there.keys()
    methods = {path[:-1]: leaf for path, leaf in here.items() if path[-1] == "method"}
    moved = 0
    for path, leaf in here.items():
        if ANYWAY & set(path) or (path[-1] == "iterations" and other is not POWERS):
            continue  # a correction at rounding may be one more
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
@pytest.mark.parametrize("method", COEFFICIENTS)
def test_the_document_of_an_orbit(other: Units, method: str, run) -> None:
    arguments = ("solve", "--method", method, "--order", 7)
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


def swept(parameter: str, belt: ns.StickSlip, *more: object) -> tuple[object, ...]:
    """Return a sweep from the parameter of an oscillator to 9/8 of it."""
    value = getattr(belt, parameter)
    ends = f"{parameter}={value!r}:{1.125 * value!r}:2"
    return ("sweep", "--vary", ends, *flags(belt, parameter), "--methods", "c1", *more)


@OTHER
@pytest.mark.parametrize("parameter", units.PARAMETERS)
def test_the_document_of_a_family(other: Units, parameter: str, run) -> None:
    first, second = (
        document(run, *swept(parameter, belt, "--orders", 7))
        for belt in (BELT, other.belt(BELT))
    )
    assert len(first["rows"]) == 2
    assert_documents_scaled(first, second, other, vary=parameter)
