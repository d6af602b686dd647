"""A phase in shifted Legendre polynomials, against polynomials of SciPy."""

import numpy as np
import pytest
import sympy as sp
from galerkin.by_quadrature import shifted
from numpy.polynomial import Polynomial

from nonsmooth.codegen.galerkin.legendre import Moments, PhaseSeries, l, repeated_integral
from nonsmooth.codegen.scene import LinearPhase
from nonsmooth.solver.rows.moments import legendre_moments

COEFFICIENTS = (0.3, -1.1, 0.7, 0.25)
SERIES = PhaseSeries(*sp.symbols("s x v", real=True), sp.IndexedBase("d"), sp.Integer(4))
NUMBERS = {SERIES.duration: 1.7, SERIES.displacement: 0.4, SERIES.velocity: -0.9}


def value(expression):
    """Return a number for an expression in the unknowns of the phase."""
    written = sp.sympify(expression).doit()
    zero = {q: 0.0 for q in written.atoms(sp.Indexed) if not 0 <= q.indices[0] < 4}
    known = {SERIES.acceleration[l]: c for l, c in enumerate(COEFFICIENTS)}
    return float(written.subs(zero | known).subs(NUMBERS))


def polynomial(order):
    """Return a derivative of the displacement by time, in local time."""
    s = NUMBERS[SERIES.duration]
    acceleration = sum((c * shifted(l) for l, c in enumerate(COEFFICIENTS)), Polynomial([0]))
    velocity = NUMBERS[SERIES.velocity] + s * acceleration.integ()
    motion = NUMBERS[SERIES.displacement] + s * velocity.integ()
    return motion.deriv(order) / s**order


@pytest.mark.parametrize("order", range(6))
def test_derivatives_at_both_ends(order):
    exact = polynomial(order)
    assert value(SERIES.at_start(order)) == pytest.approx(exact(0.0), abs=1e-12)
    assert value(SERIES.at_end(order)) == pytest.approx(exact(1.0), abs=1e-12)


def test_a_held_phase_has_no_acceleration():
    held = PhaseSeries(SERIES.duration, SERIES.displacement, SERIES.velocity, None, sp.S.Zero)
    assert held.at_end(0) == SERIES.displacement + SERIES.duration * SERIES.velocity
    assert held.at_end(1) == SERIES.velocity
    assert held.at_start(2) == held.at_end(3) == 0


@pytest.mark.parametrize("l", range(7))
def test_coefficients_of_the_residual(l):
    phase, forcing = LinearPhase(*map(sp.Float, (1.3, 0.2, 5.0, 0.6, 0.8))), 0.37
    x, v, a = (_coefficient(polynomial(order), l) for order in range(3))
    expected = 1.3 * a + 0.2 * v + 5.0 * x - 0.6 * (l == 0) - 0.8 * (2 * l + 1) * forcing
    got = value(SERIES.residual(phase, sp.Integer(l), sp.Float(forcing)))
    assert got == pytest.approx(expected, abs=1e-9)  # of the powers in `polynomial`


def _coefficient(function, l):
    return (2 * l + 1) * ((function * shifted(l)).integ()(1.0))


@pytest.mark.parametrize("times", [1, 2, 3, 4])
def test_repeated_integrals_with_a_number_and_with_a_symbol(times):
    l = sp.Symbol("l", integer=True, positive=True)
    general = repeated_integral(l, times)
    for degree in range(8):
        parts = repeated_integral(sp.Integer(degree), times)
        made = sum((float(c) * shifted(int(q)) for q, c in parts.items()), Polynomial([0]))
        exact, u = shifted(degree).integ(times), np.linspace(0, 1, 9)
        np.testing.assert_allclose(made(u), exact(u), rtol=0, atol=1e-12)
        if degree >= times:
            written = {q.subs(l, degree): c.subs(l, degree) for q, c in general.items()}
            assert written == parts


@pytest.mark.parametrize("degree", [0, 1, 5])
@pytest.mark.parametrize("turn", [0, 1])
def test_derivatives_of_moments_stay_in_the_family(degree, turn):
    """By differences: of the moments, and of those a quarter turn on."""
    s, phi = sp.symbols("s phi")
    symbols = sp.symbols("mu nu", cls=sp.IndexedBase)
    found = Moments(*symbols, 3 * s, 2 * s + phi + turn * sp.pi / 2)

    def numbers(s, phi):
        moments = np.empty((2, 9))
        legendre_moments(3 * s, 2 * s + phi + turn * np.pi / 2, moments)
        return moments

    entries = {
        base[q]: value
        for base, values in zip(symbols, numbers(0.7, 0.4), strict=True)
        for q, value in enumerate(values)
    }
    for time, step in ((s, (1e-5, 0.0)), (phi, (0.0, 1e-5))):
        above, below = (
            numbers(0.7 + sign * step[0], 0.4 + sign * step[1])[0][degree] for sign in (1, -1)
        )
        got = float(found.rate(time).subs(l, degree).subs(entries))
        assert got == pytest.approx((above - below) / 2e-5, abs=1e-8)
