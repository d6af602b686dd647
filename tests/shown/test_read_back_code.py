"""The closed forms as their text computes them, against those of SymPy, at random points."""

import random
from collections.abc import Iterator
from math import cos, pi, sin

import pytest
import sympy as sp

from nonsmooth.codegen import METHODS, SOLVED, derive, side_by_side
from nonsmooth.codegen.shortcuts import emit
from nonsmooth.codegen.system import ClosedForm

RECORDS = (*METHODS, *SOLVED)


class Table:
    """A column that has a number of its own at each index."""

    def __init__(self, seed: str) -> None:
        self.seed = seed

    def __getitem__(self, index: object) -> float:
        return random.Random(f"{self.seed}{index}").uniform(0.5, 2.0)


def arguments(form: ClosedForm, seed: int) -> dict[sp.Symbol | sp.IndexedBase, object]:
    """Return a value for each argument: whole numbers for indices, no two the same."""
    drawn = random.Random(seed)
    whole = drawn.sample(range(2, 40), len(form.arguments))
    values: dict[sp.Symbol | sp.IndexedBase, object] = {}
    for argument, number in zip(form.arguments, whole, strict=True):
        if isinstance(argument, sp.IndexedBase):
            values[argument] = Table(f"{argument}{seed}")
        else:
            values[argument] = number if argument.is_integer else drawn.uniform(0.3, 2.5)
    return values


def meant(form: ClosedForm, values: dict[sp.Symbol | sp.IndexedBase, object]) -> list[float]:
    """Return the values of a closed form, by SymPy's numbers."""
    names = {symbol.name: sp.Float(v, 30) if isinstance(v, float) else sp.Integer(v)
             for symbol, v in values.items() if isinstance(symbol, sp.Symbol)}  # fmt: skip
    tables = {str(base): table for base, table in values.items() if isinstance(table, Table)}
    found = []
    for value in form.values:
        at = {
            symbol: names[symbol.name] for symbol in value.free_symbols if symbol.name in names
        }
        entries = {}
        for entry in value.atoms(sp.Indexed):
            index = tuple(int(part.subs(at)) for part in entry.indices)
            table = tables[str(entry.base)]
            entries[entry] = sp.Float(table[index if len(index) > 1 else index[0]], 30)
        found.append(float(sp.N(value.xreplace(entries).subs(at), 30)))
    return found


def printed(method: str) -> Iterator[tuple[str, str]]:
    """Yield the name of each function that is shown beside an equation, and its text."""
    for row in side_by_side(method):
        for text in f"\n{row.source}".split("\ndef ")[1:]:
            yield text.partition("(")[0], f"def {text}"


@pytest.mark.parametrize("method", RECORDS)
def test_the_code_beside_an_equation_computes_its_closed_forms(method: str) -> None:
    shown = dict(printed(method))
    for form in derive(method).forms:
        namespace = {"sin": sin, "cos": cos, "pi": pi}
        exec(shown[form.name], namespace)
        assert emit.function_source(form).strip() == shown[form.name].strip()
        values = arguments(form, seed=1)
        got = namespace[form.name](*values.values())
        found = list(got if isinstance(got, tuple) else (got,))
        # Sums of up to some ten terms between 1e-3 and 1e3, in doubles.
        assert found == pytest.approx(meant(form, values), rel=1e-9, abs=1e-9), form.name
