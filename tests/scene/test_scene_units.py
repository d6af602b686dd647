"""Units as powers of kilogram, metre and second, and the balance of expressions."""

from fractions import Fraction

import pytest
import sympy as sp

from nonsmooth.codegen.scene import SceneError
from nonsmooth.codegen.scene.units import balance, dimension_of, spelled

L, T, M, p = sp.symbols("L T M p", positive=True)
UNITS = {L: dimension_of("m"), T: dimension_of("s"), M: dimension_of("kg"), p: dimension_of("")}


@pytest.mark.parametrize(
    ("unit", "powers"),
    [
        ("", (0, 0, 0)),
        ("1", (0, 0, 0)),
        ("rad", (0, 0, 0)),
        ("N", (1, 1, -2)),
        ("rad/s", (0, 0, -1)),
        ("1/s", (0, 0, -1)),
        ("N s/m", (1, 0, -1)),
        ("m/s^2", (0, 1, -2)),
        ("N/m s", (1, 0, -3)),
        ("N/m/s", (1, 0, -3)),
        ("s^2/m^2", (0, -2, 2)),
        ("N/m^(3/2)", (1, Fraction(-1, 2), -2)),
        ("m^(1/2)", (0, Fraction(1, 2), 0)),
    ],
)
def test_a_unit_is_powers_of_kg_m_s(unit, powers):
    assert dimension_of(unit) == powers


@pytest.mark.parametrize(
    "unit", ["Nm", "mm", "N*m", "m^-1", "m^(1/0)", "m^", "kg//s", "/s", "J"]
)
def test_what_is_no_unit_is_refused(unit):
    with pytest.raises(SceneError, match=r"^unit: got "):
        dimension_of(unit)


@pytest.mark.parametrize("unit", ["", "kg", "m/s^2", "N s/m", "N/m^(3/2)", "1/s", "m^(1/2)/s"])
def test_a_spelled_dimension_is_a_unit_again(unit):
    assert dimension_of(spelled(dimension_of(unit))) == dimension_of(unit)


@pytest.mark.parametrize(
    ("expression", "unit"),
    [
        (L / T**2 - 3 * L / T**2, "m/s^2"),
        (sp.sqrt(M * L) / T, "kg^(1/2) m^(1/2)/s"),
        (sp.Abs(L - 2 * L) * sp.exp(p * T / T), "m"),
        (p**p * sp.sin(p) + 1, ""),
        (sp.Integer(7), ""),
    ],
)
def test_the_dimension_of_an_expression(expression, unit):
    assert balance(expression, UNITS) == dimension_of(unit)


@pytest.mark.parametrize(
    ("expression", "words"),
    [
        (L + T, ("units clash", "L is in m", "T in s")),
        (L * T + M * T, ("units clash", "kg s", "m s")),
        (L + 1, ("units clash", "1 is in 1", "L in m")),
        (sp.exp(L), ("exp(L)", "pure number as the argument")),
        (sp.Max(L, 2 * T), ("Max", "pure number")),
        (p**L, ("pure number as the power",)),
        (L**p, ("rational power",)),
        (sp.Symbol("q") * L, ("q is not a parameter of the scene",)),
        (sp.Symbol("L") * T, ("L is not a parameter", "another symbol", "positive=True")),
    ],
)
def test_what_does_not_balance_is_named(expression, words):
    with pytest.raises(SceneError) as caught:
        balance(expression, UNITS)
    assert all(word in str(caught.value) for word in words), str(caught.value)
