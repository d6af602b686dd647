"""The equations written out at one order, against the kernels and a solved orbit."""

from dataclasses import astuple

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from numpy.polynomial import Polynomial
from numpy.polynomial.legendre import poly2leg

import nonsmooth as ns
from nonsmooth.codegen import derive
from nonsmooth.codegen.shortcuts import written_out as expansion
from nonsmooth.codegen.shortcuts.paper.oscillator import (
    F_N,
    M,
    V,
    mu_k,
    mu_s,
    omega_n,
    x_0,
    x_s,
)
from nonsmooth.solver.shortcuts.orbit.methods import METHODS
from nonsmooth.solver.shortcuts.search import kernels

BELT = ns.StickSlip(
    mass=3.0, stiffness=20.0, belt_speed=0.7, mu_s=0.6, mu_k=0.2, normal_force=13.0
)

#: The parameters, in the order in which `StickSlip` has them.
PARAMETERS = (M, expansion.K, V, mu_s, mu_k, F_N)

CASES = [(method, N) for method in METHODS for N in (1, 2, 3)]


def numbers(method: str, N: int, coefficients: dict, t1: float, T: float) -> dict:
    """Return the value of every symbol of the expanded equations, in SI units."""
    flat = np.hstack([np.ravel(value) for value in coefficients.values()])
    unknowns = derive(method).unknown_symbols(N)
    belt = dict(zip(PARAMETERS, astuple(BELT), strict=True))
    return belt | dict(zip(unknowns, (*map(float, flat), t1, T), strict=True))


def values(expressions: list[sp.Expr], at: dict) -> list[float]:
    """Return the values in 30 digits, rounded: the numbers are exact as they stand."""
    with mp.workdps(30):
        function = sp.lambdify(list(at), expressions, "mpmath")
        return [float(value) for value in function(*map(mp.mpf, at.values()))]


def from_kernel(method: str, N: int, z: np.ndarray) -> np.ndarray:
    """Return the paper's residuals, dimensionless, from those of the kernel."""
    kernel = kernels.plain(method)
    R = np.empty(len(z))
    kernel.residual(BELT.alpha, z, R)
    t1, T = z[-2:]
    s = T - t1
    if method == "hb-c1":  # the kernel tests with the tail: the harmonics taken away come back
        gamma = kernel.functions["harmonics_of_g1"](N, t1, T)[0]
        weights = np.hstack([0.5, np.ones(2 * N)])
        R[2 * N + 1] = T * s**3 * (R[2 * N + 1] + weights * gamma @ R[: 2 * N + 1])
    if method == "c1":  # the kernel tests with Q_l: u**k in the P_l*, integrated twice
        rows = [poly2leg((Polynomial([0.5, 0.5]) ** k).coef) @ R[: k + 1] for k in range(N + 1)]
        R[: N + 1] = s ** (np.arange(N + 1) + 3) * rows
    return R


def units(method: str, N: int) -> np.ndarray:
    """Return the unit of each residual: time is in 1/omega_n, length in V/omega_n."""
    time, length = BELT.time_unit, BELT.length_unit
    closure = [length, BELT.belt_speed]
    if method == "c1":
        return np.array([length * time ** (k + 1) for k in range(N + 1)] + closure)
    g1 = [length * time**3] if method == "hb-c1" else []
    return np.array([BELT.belt_speed] * (2 * N + 1) + g1 + closure)


@pytest.mark.parametrize(("method", "N"), CASES)
def test_expanded_residual_is_that_of_the_kernel(method: str, N: int) -> None:
    rng = np.random.default_rng(N)
    z = rng.normal(size=kernels.plain(method).size(N))
    z[-2:] = 1.3, 4.1
    coefficients = METHODS[method].coefficients(z, N, BELT)
    at = numbers(method, N, coefficients, *(BELT.time_unit * z[-2:]))
    written_out = ns.equations(method).expanded(N)
    residuals = values([equation.lhs - equation.rhs for equation in written_out], at)
    expected = from_kernel(method, N, z)
    # Terms of the kernel's residual: (N omega_0)**2 T/2 of order 20, (14) times T s**3.
    scale = {"hb": 1e2, "hb-c1": 1e4, "c1": 1e2}[method]
    np.testing.assert_allclose(residuals / units(method, N), expected, atol=1e-14 * scale)
    assert np.abs(expected).max() > 0.1


@pytest.mark.parametrize("method", METHODS)
def test_orbit_is_a_root_of_the_expanded_equations(method: str) -> None:
    orbit = ns.solve(BELT, method=method, order=3)
    at = numbers(method, 3, orbit.coefficients, orbit.t1, orbit.period)
    for equation in ns.equations(method).expanded(3):
        terms = sp.Add.make_args(sp.expand(equation.lhs - equation.rhs))
        parts = np.array(values(list(terms), at))
        # Twelve digits of the orbit are promised, and the terms cancel.
        assert abs(parts.sum()) < 1e-11 * np.abs(parts).sum()


@pytest.mark.parametrize(("method", "N"), CASES)
def test_there_are_as_many_equations_as_unknowns_and_nothing_else_is_unknown(
    method: str, N: int
) -> None:
    system = ns.equations(method)
    unknowns, written_out = system.unknown_symbols(N), system.expanded(N)
    assert len(written_out) == len(unknowns) == len(set(unknowns))
    atoms = set().union(*(e.atoms(sp.Symbol, sp.Indexed) for e in written_out))
    labels = {q.base.label for q in atoms if isinstance(q, sp.Indexed)}
    assert atoms - labels - set(unknowns) <= set(PARAMETERS)
    assert not any(e.has(sp.Sum, sp.Integral, sp.jn) for e in written_out)


@pytest.mark.parametrize("method", METHODS)
def test_what_is_shown_defines_every_abbreviation_once(method: str) -> None:
    system = derive(method)
    rows = expansion.conditions(system, 2)
    defined = [row.sides[0] for row in expansion.abbreviations(system, 2, rows)]
    assert len(defined) == len(set(defined))
    used = {q for row in rows for side in row.sides for q in side.atoms(sp.Symbol, sp.Indexed)}
    labels = {q.base.label for q in used if isinstance(q, sp.Indexed)}
    known = {*defined, *system.unknown_symbols(2), V, omega_n, x_s, x_0}
    assert used - labels <= known


@pytest.mark.parametrize("order", [0, 6, -1, 2.0, True, "2"])
def test_an_order_out_of_range_is_refused_with_the_reason(order) -> None:
    with pytest.raises(ValueError, match=r"order: got .*, expected a whole number from 1 to 5"):
        ns.equations("hb").expanded(order)
    with pytest.raises(ValueError, match="square of N"):
        ns.equations("hb").unknown_symbols(order)
