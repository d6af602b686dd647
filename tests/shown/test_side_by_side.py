"""Each equation and the generated functions that compute it."""

import pytest

from nonsmooth.codegen import derive, side_by_side
from nonsmooth.codegen.generate import FOLDER

#: What the kernels solve: the paper's orthogonality conditions and its closure.
SOLVED = {
    "hb": {"5", "6", "7", "9", "10"},
    "hb-c1": {"5", "6", "7", "14", "9", "10"},
    "c1": {"18", "19", "20"},
    "hb-symmetric": {"6", "14", "9", "10"},
    "c1-reduced": {"19"},
}


@pytest.mark.parametrize("method", SOLVED)
def test_every_condition_stands_beside_its_code(method: str) -> None:
    shown = side_by_side(method)
    assert SOLVED[method] <= {row.equation.number for row in shown}
    module = (FOLDER / "shortcuts" / f"{method.replace('-', '_')}.py").read_text("utf-8")
    for equation, latex, source in shown:
        assert latex == equation.latex()
        functions = [f"def {part}" for part in f"\n{source}".split("\ndef ")[1:]]
        assert len(functions) == len(equation.functions)
        for name, text in zip(equation.functions, functions, strict=True):
            assert text.startswith(f"def {name}(")
            assert text.strip() in module


@pytest.mark.parametrize("method", SOLVED)
def test_every_derived_function_stands_beside_an_equation(method: str) -> None:
    system = derive(method)
    beside = {name for equation in system.equations for name in equation.functions}
    assert {form.name for form in system.forms} <= beside


@pytest.mark.parametrize("method", SOLVED)
def test_a_function_that_names_an_equation_stands_beside_it(method: str) -> None:
    system = derive(method)
    for form in system.forms:
        for number in SOLVED[method] & set(form.summary.replace("(", ")").split(")")):
            assert form.name in system.equation(number).functions
