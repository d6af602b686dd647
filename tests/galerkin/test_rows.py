"""Every row of every kernel against quadrature of the equations of motion."""

import numpy as np
import pytest
import sympy as sp
from every_run import tried
from galerkin import by_quadrature
from galerkin.by_quadrature import OSCILLATORS, jacobi
from galerkin.derived import module, pairs
from galerkin.oscillators import case_of
from galerkin.solving import differences, jacobian, residual, times_of
from numpy.polynomial import Legendre

from nonsmooth.codegen.expansions import ck

#: Scenes on which each kernel is tried in every run; the others have phases of the same kinds.
TRIED = {
    "ck": ("S0", "S1n2", "S1", "S4a"),
    "ck_tau": ("S1n2", "S1", "S2b", "S3b", "S4a", "S5a", "S6", "S7"),
    "hb": ("S1n2", "S1", "S2b", "S3b", "S4a", "S5a", "S6", "S7"),
    "hb_ck_1": ("S1n2", "S1", "S2b", "S3b", "S4a"),
    "hb_ck_2": ("S1", "S5a"),
}

PAIRS = tried(
    pairs(OSCILLATORS),
    every_run=[
        (name, kernel)
        for name, kernel in pairs(OSCILLATORS)
        if name in TRIED.get(kernel, OSCILLATORS)
    ],
)


def random_unknowns(name, kernel, order):
    """Return random coefficients, and durations that fill the cell that the forcing makes.

    The series have the forcing in their own frequency, which is that of the forcing there.
    """
    made, o = module(name, kernel), OSCILLATORS[name]
    random = np.random.default_rng([order, *name.encode(), *kernel.encode()])
    z = random.uniform(-1, 1, made.size(order))
    durations = times_of(made, z)[: len(o.phases)]
    durations[:] = random.uniform(0.5, 1.5, len(o.phases))
    if o.Omega is not None:
        cell = o.cycles * (1 if o.sign == -1 else 2) * np.pi / o.Omega
        durations *= cell / durations.sum()
    return z


@pytest.mark.parametrize(("name", "kernel"), PAIRS)
def test_the_residual_is_the_quadrature_of_the_equation_of_motion(name, kernel):
    for order in (module(name, kernel).LOWEST, 5):
        z = random_unknowns(name, kernel, order)
        harmonics = OSCILLATORS[name].sign == -1 and kernel.startswith("hb")
        terms = (order + 1) // 2 if harmonics else order
        expected = by_quadrature.rows(name, kernel, z, terms)
        got = residual(module(name, kernel), case_of(name), z)
        assert len(got) == len(expected)
        np.testing.assert_allclose(got, expected, rtol=0, atol=2e-13 * np.abs(expected).max())


@pytest.mark.parametrize("k", range(4))
def test_what_no_test_sees_is_what_the_tests_of_ck_leave(k):
    """Jacobi's polynomials are orthogonal to (18) of any class, up to their degree."""
    u = np.linspace(0, 1, 7)
    for m in range(8):
        weights = [float(ck.rest(sp.Integer(m), sp.Integer(l), k)) for l in range(m + 1)]
        left = Legendre(weights, domain=[0, 1])
        np.testing.assert_allclose(left(u), jacobi(m, k + 1, u), atol=1e-12)
        for l in range(m):
            test = Legendre.basis(l, domain=[0, 1]).integ(k + 1, lbnd=0)
            assert abs((left * test).integ(lbnd=0)(1.0)) <= 1e-14


@pytest.mark.parametrize(("name", "kernel"), PAIRS)
def test_the_jacobian_is_the_derivative_of_the_residual(name, kernel):
    """By differences of order 8, whose error is below 1e-10 of the largest entry."""
    made, case = module(name, kernel), case_of(name)
    z = random_unknowns(name, kernel, 5)
    z[len(z) - made.DURATIONS - made.FORCED :] *= 1.03  # nothing is special about the cell
    J = jacobian(made, case, z)
    expected = differences(lambda z: residual(made, case, z), z, step=0.005)
    bound = 1e-10 * max(1.0, np.abs(J).max())
    np.testing.assert_allclose(J.T, expected, rtol=0, atol=bound)
