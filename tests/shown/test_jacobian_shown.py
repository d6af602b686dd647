"""The Jacobian that a reader is shown, against differences of the conditions it derives."""

import pytest
import sympy as sp
from evaluate import symbols, value
from paper import Problem
from test_equations_shown import PROBLEM, X_0, V, numbers

from nonsmooth.codegen import derive
from nonsmooth.codegen.shortcuts.paper.oscillator import T, t1
from nonsmooth.codegen.system import Equation, GalerkinSystem

#: Central differences of smooth functions of order one: h**2 against eps/h.
H = 1e-5
CLOSE = {"rel": 1e-7, "abs": 1e-8}

INDICES = {"j": 2, "n": 1, "k": 2, "m": 1}


def at(expression: sp.Expr) -> sp.Expr:
    """Return `expression` with its free indices set."""
    names = {s: INDICES[s.name] for s in expression.free_symbols if s.name in INDICES}
    return expression.subs(names)


def moved(time: sp.Symbol, by: float) -> dict[sp.Expr, float]:
    """Return the numbers with ``t1`` or ``T``, and what hangs on them, moved."""
    times = {t1: PROBLEM.t1, T: PROBLEM.T}
    times[time] += by
    problem = Problem(times[t1], times[T], PROBLEM.omega_n, PROBLEM.x_s)
    return numbers | symbols(problem, V, X_0)


def derivative_value(equation: Equation, system: GalerkinSystem) -> float:
    """Return the right side of a row of the Jacobian, derivatives of tables included."""
    right = at(equation.sides[-1])
    inner = {}
    for atom in right.atoms(sp.Derivative):
        table, time = atom.expr, atom.variables[0]
        row = next(
            e
            for e in system.jacobian
            if isinstance(e.sides[0].expr, sp.Indexed)
            and e.sides[0].expr.base == table.base
            and e.sides[0].variables[0] == time
        )
        k = row.sides[0].expr.indices[0]
        inner[atom] = value(at_z(row.sides[-1].subs(k, table.indices[0])), system, numbers)
    return value(at_z(right.xreplace(inner)), system, numbers)


def at_z(expression: sp.Expr) -> sp.Expr:
    """Set the half angle z of the harmonic k = 2 that `INDICES` picks."""
    z = {s: 2 * PROBLEM.omega_0 * (PROBLEM.T - PROBLEM.t1) / 2 for s in expression.free_symbols
         if s.name == "z"}  # fmt: skip
    return expression.subs(z)


@pytest.mark.parametrize("method", ["hb", "hb-c1", "c1"])
def test_every_row_is_the_derivative_it_says(method: str) -> None:
    rows = derive(method).jacobian
    assert len(rows) > 4
    for equation in rows:
        is_the_derivative_it_says(method, equation)


def is_the_derivative_it_says(method: str, equation: Equation) -> None:
    system = derive(method)
    of, unknown = equation.sides[0].expr, equation.sides[0].variables[0]
    if isinstance(of, sp.Symbol) and of.name.startswith("R_"):
        expression = at(system.equation(of.name[2:]).sides[1])
    else:
        expression = at(of)
    unknown = at(unknown) if isinstance(unknown, sp.Indexed) else unknown

    def shifted(by: float) -> float:
        if unknown in (t1, T):
            return value(expression, system, moved(unknown, by))
        return value(expression, system, numbers | {unknown: numbers[unknown] + by})

    expected = (shifted(H) - shifted(-H)) / (2 * H)
    assert derivative_value(equation, system) == pytest.approx(expected, **CLOSE)
