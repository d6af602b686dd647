"""The same oscillator in other units: every number of the documents of commands.

Of powers of two, by which no number even rounds.  That files have what documents have, and in
which units, is tested in `test_files` and `test_units`; units that do round in `test_scaling`.
"""

import json
import re
from collections.abc import Callable
from typing import Any

import pytest
import units
from units import BELT, COEFFICIENTS, POWERS, SCALARS, flags, leaves

import nonsmooth as ns

#: What differs between two runs anyway.
ANYWAY = {"seconds", "sha256"}

#: Parts of a document without a unit, whatever the names in them.
WITHOUT = {"errors", "estimate", "outcome", "rates", "trials", "transition_mismatch", "units"}

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


def assert_scaled(here: Any, there: Any, factor: float, what: tuple[Any, ...]) -> None:
    """Check one number, or those in a text."""
    if isinstance(here, str):
        numbers = [re.findall(NUMBER, text) for text in (here, there)]
        for (one, unit), (two, _) in zip(*numbers, strict=True):
            assert float(two) == pytest.approx(float(one) * POWERS.of(unit), rel=1e-2), what
        assert re.sub(NUMBER, r"\2", there) == re.sub(NUMBER, r"\2", here), what
    else:
        assert there == (here * factor if isinstance(here, float) else here), what


def printed_and_scaled(
    run, arguments: Callable[[ns.StickSlip], tuple[Any, ...]], vary: str = ""
) -> dict[str, Any]:
    """Return what a command prints of an oscillator, checked against it in other units."""
    first, second = (
        json.loads(run(*arguments(belt), "--json")[1]) for belt in (BELT, POWERS.belt(BELT))
    )
    for each in (first, second):  # Newton's corrections at rounding, not results
        each.pop("outcome", None)
        each.pop("residual_norm", None)
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
        assert_scaled(leaf, there[path], POWERS.of(unit, n), path)
        moved += unit != "1" and isinstance(leaf, float)
    assert moved > 3
    return first


COMMANDS = [
    *(("solve", "--method", method, "--order", 7) for method in COEFFICIENTS),
    ("sweep", "--orders", "4-6"),
    ("roots", "--order", 6),
]


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: " ".join(map(str, command)))
def test_the_document_of_a_command(command: tuple[Any, ...], run) -> None:
    first = printed_and_scaled(run, lambda belt: (*command, *flags(belt)))
    assert command[0] != "solve" or first["coefficients"]


@pytest.mark.parametrize("parameter", units.PARAMETERS)
def test_the_document_of_a_family(parameter: str, run) -> None:
    def swept(belt: ns.StickSlip) -> tuple[object, ...]:
        value = getattr(belt, parameter)
        ends = f"{parameter}={value!r}:{1.125 * value!r}:2"
        flags_left = flags(belt, parameter)
        return ("sweep", "--vary", ends, *flags_left, "--methods", "c1", "--orders", 7)

    assert len(printed_and_scaled(run, swept, vary=parameter)["rows"]) == 2
