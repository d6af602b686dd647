"""Evaluate the equations of a record as a reader would: numbers for symbols, sums done."""

from collections.abc import Mapping

import sympy as sp

from nonsmooth.codegen.shortcuts.paper import inner_product, slip_moments
from nonsmooth.codegen.shortcuts.paper.oscillator import T, V, omega_n, t1, x_0, x_s
from nonsmooth.codegen.system import GalerkinSystem

ORDER = 3


def symbols(problem, V_=0.0, x_0_=0.0) -> dict[sp.Symbol, float]:
    """Return the values of the oscillator's symbols and of the times."""
    return {
        T: problem.T,
        t1: problem.t1,
        omega_n: problem.omega_n,
        x_s: problem.x_s,
        V: V_,
        x_0: x_0_,
        inner_product.omega_0: problem.omega_0,
        inner_product.N: ORDER,
        slip_moments.s: problem.T - problem.t1,
    }


def definitions(system: GalerkinSystem) -> dict[str, tuple[sp.Expr, sp.Expr]]:
    """Return the tables and abbreviations that a record defines, by the name of the base."""
    found = {}
    for equation in system.equations:
        left, right = equation.sides[0], equation.sides[-1]
        if isinstance(left, sp.Indexed):
            zero = left.indices[0] == 0
            found[f"{left.base.label}{'0' if zero else ''}"] = (left, right)
        elif isinstance(left, sp.Symbol) and left.name in {"H_0", "H_g"}:
            found[left.name] = (left, right)
    return found


def value(
    expression: sp.Expr, system: GalerkinSystem, numbers: Mapping[sp.Expr, float]
) -> float:
    """Return the number that `expression` is, with the tables of `system`."""
    known = definitions(system)
    exactly = {name: sp.sympify(number) for name, number in numbers.items()}
    expression = sp.sympify(expression).xreplace(exactly).doit()
    replaced = {}
    for atom in expression.atoms(sp.Indexed, sp.Symbol):
        if atom in numbers:
            replaced[atom] = numbers[atom]
            continue
        if isinstance(atom, sp.Symbol):
            if atom.name in {"H_0", "H_g"}:
                replaced[atom] = value(known[atom.name][1], system, numbers)
            continue
        name, index = str(atom.base.label), int(atom.indices[0])
        if name not in known:
            continue
        sign = -1 if name == "S" and index < 0 else 1
        if index == 0 and f"{name}0" in known:
            replaced[atom] = value(known[f"{name}0"][1], system, numbers)
            continue
        left, right = known[name]
        z = {slip_moments.z: slip_moments.TIMES[slip_moments.z]}
        at = right.subs(z).subs(left.indices[0], abs(index))
        replaced[atom] = sign * value(at, system, numbers)
    return float(sp.N(expression.xreplace(replaced)))
