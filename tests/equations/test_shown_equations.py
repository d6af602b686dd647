"""Every equation shown of a scene, evaluated as it stands: its sides agree."""

import re

import numpy as np
import pytest
import sympy as sp
from every_run import tried
from shown_evaluation import UnknownError
from shown_numbers import Numbers
from shown_scenes import CASES, CASES_OF_EVERY_RUN, numbers

from nonsmooth.codegen.equations.conditions.functions import R
from nonsmooth.codegen.equations.conditions.polynomial import S
from nonsmooth.codegen.equations.registry import conditions
from nonsmooth.codegen.scene import in_order
from nonsmooth.codegen.scenes import dry_friction
from nonsmooth.codegen.system import Equation

#: Rounding of quadrature and of sums of some ten terms; the values are about 1.
CLOSE = {"rel": 1e-9, "abs": 1e-9}


def indices(numbers: Numbers, equation: Equation) -> list[dict[str, int]]:
    """Return the values of the free index of an equation: those of its rows."""
    free = set().union(*(_free(side) for side in equation.sides))
    if not free:
        return [{}]
    (name,) = free
    first = 1 if name == "j" or re.search("l != 0|n = 1", equation.where) else 0
    found = [q for q in numbers.conditions.conditions if q.where and q.where in equation.where]
    if found:
        low = int(sp.sympify(found[0].first).subs("N", numbers.order))
        count = int(
            sp.sympify(found[0].count).subs(
                sp.Symbol("N", integer=True, positive=True), numbers.order
            )
        )
        return [{name: value} for value in range(low, low + count)]
    last = re.fullmatch(r"`l = 0, \.\.\., (.+)`", equation.where)
    beyond = int(sp.sympify(last[1], {"N": numbers.order})) + 1 if last else 4
    return [{name: value} for value in range(first, min(beyond, 4))]


def _free(side: sp.Expr) -> set[str]:
    labels = {q.base.label for q in side.atoms(sp.Indexed)}
    return {
        q.name
        for q in side.free_symbols - labels
        if q.is_Symbol and q.is_integer and q.name in "jln"
    }


def is_condition(equation: Equation) -> bool:
    return equation.sides[-1] == 0 and len(equation.sides) == 3


@pytest.mark.parametrize(("scene", "method"), tried(CASES, every_run=CASES_OF_EVERY_RUN))
def test_the_closed_forms_are_the_rows_of_the_kernel(scene: str, method: str) -> None:
    check_rows(numbers(scene, method))


def test_so_they_are_with_several_functions_a_switch() -> None:
    """A constant force is no part of the equation of motion, differentiated."""
    check_rows(numbers("stick-slip-damped", "hb-ck", 2))


def test_so_they_are_in_an_order_that_is_not_declared() -> None:
    order = in_order(dry_friction.SCENE, "slide,stop,-slide,stop,mirrored")
    check_rows(Numbers(conditions(order, "ck-tau"), 3))


def check_rows(found: Numbers) -> None:
    """Check the closed form of each condition against its row of the kernel."""
    shown = [
        found.at(equation.sides[1], **at)
        for equation in found.record.equations
        if is_condition(equation)
        for at in indices(found, equation)
    ]
    rows = found.rows()
    forced = found.conditions.times.frequency is not None
    assert len(shown) == len(rows) - forced  # the last row, the period, has a form of its own
    assert shown == pytest.approx(list(rows[: len(shown)]), **CLOSE)


@pytest.mark.parametrize(("scene", "method"), tried(CASES, every_run=CASES_OF_EVERY_RUN))
def test_both_sides_of_each_equation_agree(scene: str, method: str) -> None:
    found, seen = numbers(scene, method), 0
    for equation in found.record.equations:
        sides = equation.sides[:-1] if is_condition(equation) else equation.sides
        if equation.title.endswith("orthogonal to its tests"):  # what they do not see is S
            sides = (sides[0], sides[0].subs(R, R - S))
        p = found.phase_of(equation)
        ends = found.ends[p : p + 2]
        u = 0.3
        more = {"t": ends[0] + u * (ends[1] - ends[0]), "u": u}
        if len(sides) == 1 or str(sides[0]) in {"R(t)", "u"}:
            continue
        try:
            for at in indices(found, equation):
                values = [float(np.real(found.at(side, p, **more, **at))) for side in sides]
                assert values[1:] == pytest.approx(values[:-1], **CLOSE), equation.text()
                seen += 1
        except UnknownError:
            continue
    assert seen > len(found.record.equations) // 3


@pytest.mark.parametrize(("scene", "method"), tried(CASES, every_run=CASES_OF_EVERY_RUN))
def test_every_unknown_is_explained(scene: str, method: str) -> None:
    found = numbers(scene, method)
    listed = [part.partition(": ") for part in found.record.unknowns.split("; ")]
    expected = len(found.conditions.blocks) + len(found.conditions.times.unknown)
    assert len(listed) == expected
    assert all(name and len(what) > 4 for name, _, what in listed)
    names = {name.partition("[")[0] for name, _, _ in listed}
    assert len(names) >= expected - 3  # the functions of one switch share a letter
    text = found.record.text(unicode=False)
    assert all(name in text for name in names)


@pytest.mark.parametrize(("scene", "method"), tried(CASES, every_run=CASES_OF_EVERY_RUN))
def test_what_a_condition_looks_up_is_defined(scene: str, method: str) -> None:
    rows = numbers(scene, method).record.equations
    unknown = {str(block.symbol) for block in numbers(scene, method).conditions.blocks}
    defined = {q.sides[0].base for q in rows if isinstance(q.sides[0], sp.Indexed)}
    for row in filter(is_condition, rows):
        for entry in row.sides[1].atoms(sp.Indexed):
            letter = str(entry.base.label)
            own = letter in unknown or letter.startswith(("c_", "tau_"))
            assert own or entry.base in defined, entry


@pytest.mark.parametrize(("scene", "method"), [("impact", "ck-tau"), ("clearance", "hb")])
def test_the_time_derivatives_are_differences(scene: str, method: str) -> None:
    found, step = numbers(scene, method), 1e-5
    rows = [q for q in found.record.jacobian if isinstance(q.sides[0], sp.Derivative)]
    for row in rows:
        entry, time = row.sides[0].expr, str(row.sides[0].variables[0])
        ends = []
        for value in (found.values[time] + step, found.values[time] - step):
            moved = {time: value} | ({"omega_0": 2 * np.pi / value} if time == "T" else {})
            ends.append(found.at(entry, l=2, **moved))
        slope = (ends[0] - ends[1]) / (2 * step)
        # The error of the difference is 1e-10; rounding over the step about as much.
        assert found.at(row.sides[1], l=2) == pytest.approx(slope, rel=1e-7, abs=1e-7), row
    assert len(rows) >= 2
