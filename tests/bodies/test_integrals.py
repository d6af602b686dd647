"""The integrals of the force series against quadrature in many digits, for all kappa."""

from functools import cache

import mpmath as mp
import numpy as np
import pytest

from nonsmooth.codegen.galerkin import force_series
from nonsmooth.generated import force_series as emitted
from nonsmooth.solver.bodies.force_series import integrals, one_by_one
from nonsmooth.solver.bodies.force_series.integrals import (
    answers,
    factors,
    moment_rates,
    moments,
    rates_by_moments,
    response_rates,
    responses,
    summed,
)
from nonsmooth.solver.kernels import linking
from nonsmooth.solver.kernels.compiling import rebuilt

#: Decaying, oscillating, neither, on both sides of the limits of the recurrences.
KAPPAS = [
    *(0, 1e-20, 1e-9, 1e-3, 1e-3j, -0.5 + 1j, 2j * np.pi, -12j, 3 + 2j, -15 + 2j, -24),
    *(-20 + 30j, -5 + 36j, -70, -300 + 5j, -0.01 + 120j),
]

#: Rounding of sums of numbers of size 1.
TOLERANCE = 4e-15


def legendre(n: int, u: mp.mpf) -> mp.mpf:
    """Return a Legendre polynomial on [0, 1]; its recurrence is far quicker than mpmath."""
    before, found, x = mp.mpf(0), mp.mpf(1), 2 * u - 1
    for k in range(n):
        before, found = found, ((2 * k + 1) * x * found - k * before) / (k + 1)
    return found


def panels(kappa: complex) -> list[mp.mpf]:
    return mp.linspace(0, 1, 2 + int(abs(kappa) / 6))


@pytest.mark.parametrize("kappa", KAPPAS, ids=str)
def test_moments(kappa: complex) -> None:
    found, k = moments(np.array([kappa], dtype=complex), 12)[:, 0], mp.mpc(kappa)
    with mp.workdps(30):
        for m in (0, 1, 2, 5, 11):
            exact = mp.quadgl(lambda u, m=m: legendre(m, u) * mp.exp(k * u), panels(kappa))
            scale = max(1.0, float(np.exp(np.real(kappa))))
            assert abs(complex(exact) - found[m]) <= TOLERANCE * scale


@cache
def gauss() -> tuple[list[mp.mpf], list[mp.mpf]]:
    """Return nodes and weights on [0, 1], exact to degree 21."""
    series = mp.taylor(lambda x: mp.legendre(11, x), 0, 11)[::-1]
    roots = mp.polyroots(series, maxsteps=200, extraprec=200)
    slopes = [mp.diff(lambda q: mp.legendre(11, q), x) for x in roots]
    weights = [1 / ((1 - x * x) * q**2) for x, q in zip(roots, slopes, strict=True)]
    return [(x + 1) / 2 for x in roots], weights


def of_pole(kappa: complex, count: int) -> np.ndarray:
    """Return ``Z_mn`` of one pole."""
    real, imaginary = responses(factors(np.array([kappa]) + 0j, count), np.array([[1, -1j]]))
    return real + 1j * imaginary


@pytest.mark.parametrize("kappa", [q for q in KAPPAS if abs(q) < 80], ids=str)
def test_responses(kappa: complex) -> None:
    """By the lag ``w = u - y``: the inner integral is of a polynomial, exact by Gauss."""
    found, k = of_pole(kappa, 10), mp.mpc(kappa)
    with mp.workdps(25):
        nodes, weights = gauss()
        for m, n in ((0, 0), (3, 4), (2, 9)):

            def inner(w: mp.mpf, m: int = m, n: int = n) -> mp.mpf:
                rest = 1 - w
                return rest * mp.fsum(
                    q * legendre(m, w + rest * x) * legendre(n, rest * x)
                    for x, q in zip(nodes, weights, strict=True)
                )

            exact = mp.quadgl(lambda w: mp.exp(k * w) * inner(w), panels(kappa))
            scale = max(1.0, float(np.exp(np.real(kappa))))
            assert abs(complex(exact) - found[m, n]) <= TOLERANCE * scale


def test_responses_of_many_poles_are_those_of_each() -> None:
    kappas, w = np.array(KAPPAS, dtype=complex), np.exp(0.3j * np.arange(len(KAPPAS)))
    each = sum((q * of_pole(kappa, 10)).real for q, kappa in zip(w, KAPPAS, strict=True))
    found = responses(factors(kappas, 10), w[:, None])[0]
    assert found == pytest.approx(each, abs=TOLERANCE, rel=TOLERANCE)


def test_poles_are_computed_one_after_the_other_or_together() -> None:
    """Compiled they are, by other functions; here these are plain Python."""
    own = linking.made((emitted, integrals, one_by_one), {}, rebuilt)
    kappas = np.array(KAPPAS, dtype=complex)
    near = {"abs": TOLERANCE, "rel": TOLERANCE}
    assert own["moments"](kappas, 12) == pytest.approx(moments(kappas, 12), **near)
    for count in (1, 4, 10):
        assert own["factors"](kappas, count) == pytest.approx(factors(kappas, count), **near)


SERIES = np.array([0.5, -1.0, 0.3 + 1j, 2.0, 0.0, 1.0, -0.7, 0.4j])[:, None]


@pytest.mark.parametrize("kappa", [-3 + 2j, -40 + 20j, 0.2j], ids=str)
def test_rates_against_differences(kappa: complex) -> None:
    h, l = 1e-5, SERIES[:, 0].real
    here, ahead, behind = (moments(np.array([kappa + q]), 9)[:, 0] for q in (0, h, -h))
    slopes = (ahead - behind) / (2 * h)
    assert moment_rates(here[:, None])[:, 0] == pytest.approx(slopes[:8], abs=1e-10)
    assert rates_by_moments(l) @ here == pytest.approx(l @ slopes[:8], abs=1e-9)
    here, ahead, behind = (of_pole(kappa + q, 9) for q in (0, h, -h))
    slope = (ahead - behind)[:8, :8] @ l / (2 * h)
    assert response_rates(here.real, l) == pytest.approx(slope.real, abs=1e-9)
    assert response_rates(here.imag, l) == pytest.approx(slope.imag, abs=1e-9)


@pytest.mark.parametrize("kappa", KAPPAS, ids=str)
def test_sums_are_those_of_the_responses(kappa: complex) -> None:
    sums = summed(factors(np.array([kappa]) + 0j, 12), SERIES)[:, 0]
    expected = of_pole(kappa, 12)[:, :8] @ SERIES[:, 0]
    assert sums == pytest.approx(expected, abs=TOLERANCE, rel=TOLERANCE)


@pytest.mark.parametrize("kappa", KAPPAS, ids=str)
def test_answers_obey_their_equation(kappa: complex) -> None:
    """``z' = kappa z + f`` from 0, at nodes; the derivative is that of the series."""
    E, B = answers(np.array([kappa], dtype=complex), SERIES)
    x = np.linspace(-1, 1, 7)
    wave = E[0] * np.exp(kappa * (x + 1) / 2)
    z = wave + np.polynomial.legendre.legval(x, B[:, 0])
    slope = np.polynomial.legendre.legder(B[:, 0])
    rate = kappa * wave + 2 * np.polynomial.legendre.legval(x, slope)
    f = np.polynomial.legendre.legval(x, SERIES[:, 0])
    scale = (1 + abs(kappa)) * max(1.0, np.exp(np.real(kappa)))
    assert rate - kappa * z == pytest.approx(f, abs=1e-12 * scale)
    assert abs(z[0]) <= 1e-13 * scale


def test_every_recurrence_is_emitted() -> None:
    names = {formula.name for formula in force_series.formulas()}
    assert names <= vars(emitted).keys()
