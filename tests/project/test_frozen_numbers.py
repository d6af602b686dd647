"""What the program says today is what it said when its numbers were frozen.

Whoever changes a number on purpose writes the files anew, `python -m frozen` in `tests/`, and
says in the commit by how much and why.
"""

import json
import random

import pytest
from frozen import equations, grid, machine
from frozen.compare import FOLDER, OF_AN_ERROR, differences

from nonsmooth.solver.accuracy.rates import slope

FROZEN = json.loads((FOLDER / "machine.json").read_text("utf-8"))

#: Last bits depend on libraries and processor; elsewhere the times agree to rounding.
SAME_MACHINE = machine.described() == FROZEN

#: How formulas are written in HTML is the library's.
SAME_MATHML = machine.described()["latex2mathml"] == FROZEN["latex2mathml"]


@pytest.mark.parametrize("name", grid.GRIDS)
def test_numbers_are_the_frozen_ones(name: str) -> None:
    frozen = json.loads((FOLDER / f"{name}.json").read_text("utf-8"))
    found = differences(frozen, json.loads(grid.text(name)), exactly=SAME_MACHINE)
    assert not found, f"{len(found)} differences\n" + "\n".join(found[:10])


def test_equations_in_every_format_are_the_frozen_ones() -> None:
    shown = dict(equations.shown())
    folder = FOLDER / "equations"
    assert sorted(path.name for path in folder.iterdir()) == sorted(shown)
    for name, text in shown.items():
        if name.endswith(".html") and not SAME_MATHML:
            continue
        assert text == (folder / name).read_text("utf-8"), name


def test_a_last_bit_is_a_difference_and_rounding_is_none_elsewhere() -> None:
    old = [{"period": (1.5).hex(), "residual_norm": (1e-17).hex(), "status": "ok"}]
    new = [{"period": (1.5 + 2**-52).hex(), "residual_norm": (2e-17).hex(), "status": "ok"}]
    assert len(differences(old, new, exactly=True)) == 2
    assert differences(old, new, exactly=False) == []
    assert differences(old, [{**new[0], "status": "no-orbit"}], exactly=False)
    assert differences(old, [{**new[0], "period": (1.5001).hex()}], exactly=False)
    assert differences(old, [], exactly=False)


def sweep_of(errors: dict[int, float]) -> list[dict]:
    """Return the document of a sweep whose errors of the period are these, with its rate."""
    rows = [
        {"method": "c1", "order": order, "errors": {"period": error.hex()}}
        for order, error in errors.items()
    ]
    rate = slope(errors.items(), 1e-12, power=False, upper_half=True)
    return [{"rates": {"c1": {"kind": "geometric", "period": rate.hex()}}, "rows": rows}]


@pytest.mark.parametrize("last", [1e-3, 1e-6, 1e-9, 2e-12])
def test_a_rate_differs_by_what_the_rounding_of_its_errors_explains(last: float) -> None:
    draw = random.Random(7)
    errors = {N: last ** (N / 12) for N in range(1, 13)}
    old = sweep_of(errors)
    rate = float.fromhex(old[0]["rates"]["c1"]["period"])
    for _ in range(20):
        rounded = {N: e + draw.uniform(-1, 1) * OF_AN_ERROR for N, e in errors.items()}
        assert differences(old, sweep_of(rounded), exactly=False) == []
        beyond = errors | {12: last * draw.choice((0.9, 1.1))}
        assert differences(old, sweep_of(beyond), exactly=False)
    explained = 10 * OF_AN_ERROR / last  # as a part of the rate, at most, and a little more
    for other in (rate * (1 + explained), rate * (1 - explained), 2 * rate, -rate):
        old[0]["rates"]["c1"]["period"] = other.hex()
        assert differences(old, sweep_of(errors), exactly=False)
    assert differences(
        old, [{**old[0], "rates": {"c1": {"kind": "geometric", "period": None}}}], exactly=False
    )
