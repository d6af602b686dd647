"""The scalar equation against the full matrices, in many digits and from other integrals."""

import mpmath as mp
import numpy as np
import pytest
from known import NAMES, attached, felt, law, place, quadrature

from nonsmooth.solver.space.eigenvalues import secular
from nonsmooth.solver.space.eigenvalues.bracketing import EPS
from nonsmooth.solver.space.eigenvalues.exact import exact_modes
from nonsmooth.solver.space.expansions.bare import Sines
from nonsmooth.solver.space.expansions.beyond import ROUNDINGS, beyond
from nonsmooth.solver.space.expansions.forced import ForcedModes, ritz_forced
from nonsmooth.solver.space.expansions.pieces import piecewise
from nonsmooth.solver.space.modes import at_order, modes


def _sums(one, q: int) -> mp.mpf:
    """Return the sum of r_n^2/mu_n^q, from the Fourier series of Bernoulli polynomials."""
    j, m = one.structure.felt, one.structure.m
    p = m * q - j
    unit = (-1) ** (p + 1) * mp.mpf(2) ** (2 * p) / (2 * mp.factorial(2 * p))
    return unit * (mp.bernpoly(2 * p, 0) - (-1) ** j * mp.bernpoly(2 * p, place(one)))


def matrix_eigenvalues(one, N: int, K: int) -> list[mp.mpf]:
    """Return the eigenvalues of N sines and K forced modes, assembled as one would write them.

    The attachment stands in the matrices; no tails, no scalar equation.
    """
    kind, size, s = one.structure.kind, N + K, mp.mpf(one.s)
    mu = [(n * mp.pi) ** (2 * one.structure.m) for n in range(1, N + 1)]
    r = [felt(one, n) for n in range(1, N + 1)]
    stiff, mass, load = mp.zeros(size), mp.zeros(size), mp.zeros(size, 1)
    for n in range(N):
        stiff[n, n], mass[n, n], load[n] = mu[n], 1, r[n]
        for q in range(1, K + 1):
            hinge = kind == "compliance" and q == 1
            stiff[n, N + q - 1] = stiff[N + q - 1, n] = 0 if hinge else r[n] / mu[n] ** (q - 1)
            mass[n, N + q - 1] = mass[N + q - 1, n] = r[n] / mu[n] ** q
    for q in range(1, K + 1):
        if not (kind == "compliance" and q == 1):
            load[N + q - 1] = _sums(one, q)
        for p in range(1, K + 1):
            straight = kind == "compliance" and 1 in (p, q)  # has no curvature
            value = mp.mpf(0) if straight else _sums(one, p + q - 1)
            stiff[N + q - 1, N + p - 1] = value
            mass[N + q - 1, N + p - 1] = _sums(one, p + q)
    if kind == "stiffness":
        stiff += s * load * load.T
    elif kind == "inertia":
        mass += s * load * load.T
    else:
        stiff[N, N] += 1 / s
    lower = mp.cholesky(mass)
    inverse = mp.inverse(lower)
    return sorted(mp.eigsy(inverse * stiff * inverse.T, eigvals_only=True))


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("K", [1, 2, pytest.param(3, marks=pytest.mark.long)])
def test_the_scalar_equation_is_the_eigenproblem_of_the_matrices(name: str, K: int) -> None:
    one = attached(name, "2/7", 40.0)
    with mp.workdps(60):
        wanted = np.array([float(q) for q in matrix_eigenvalues(one, 3, K)])
    bare = ritz_forced(one, 3, tuple(range(1, K + 1)))
    found = secular.eigenvalues(bare, one, len(wanted)).values
    # the highest one is that of the last forced mode, whose sums have ten digits
    np.testing.assert_allclose(found[:3], wanted[:3], rtol=1e-13)
    np.testing.assert_allclose(found, wanted, rtol=1e-9)
    assert bare.count == 3 + K


def test_the_reference_that_is_left_out() -> None:
    one = attached("beam-spring", "1/2", 1e6)
    with mp.workdps(60):
        wanted = [float(q) for q in matrix_eigenvalues(one, 4, 2)]
    found = secular.eigenvalues(ritz_forced(one, 4, (1, 2)), one, 6).values
    np.testing.assert_allclose(found, wanted, rtol=1e-12)
    assert found[3] == pytest.approx(39846.409929222582, rel=1e-13)


@pytest.mark.parametrize("name", NAMES)
def test_integrals_of_forced_modes_are_one_term_each(name: str) -> None:
    one = attached(name)
    m, compliant = one.structure.m, one.structure.kind == "compliance"
    x, weights = quadrature(one, 60)
    n, forced = np.arange(1, 7), ForcedModes(one)
    r, mu = one.felt(n), one.bare(n)
    sums = {q: float(_sums(one, q)) for q in range(1 + compliant, 7)}
    g = {q: forced.values(q, x, 0) for q in (1, 2, 3)}
    energy = {q: forced.values(q, x, m) for q in (1, 2, 3)}
    for q in (1, 2, 3):
        np.testing.assert_allclose(
            Sines(6).values(x, 0) @ (weights * g[q]), r / mu**q, rtol=1e-10, atol=1e-15
        )
        for p in (1, 2, 3):
            product = weights @ (g[p] * g[q])
            assert product == pytest.approx(sums[p + q], rel=1e-12)
            hinge = compliant and 1 in (p, q)
            wanted = 0.0 if hinge else sums[p + q - 1]
            assert weights @ (energy[p] * energy[q]) == pytest.approx(wanted, rel=1e-12)


@pytest.mark.parametrize("name", NAMES)
def test_a_forced_mode_has_one_jump_and_answers_the_one_before(name: str) -> None:
    one = attached(name)
    m, a = one.structure.m, float(one.a)
    forced, beside = ForcedModes(one), np.array([a * (1 - 1e-15), a * (1 + 1e-15)])
    for q in (1, 2, 3):
        highest = 2 * m * q - 1 - one.structure.felt
        jumps = [np.diff(forced.values(q, beside, d))[0] for d in range(highest + 1)]
        np.testing.assert_allclose(jumps[:-1], 0, atol=1e-12)
        wanted = (-1) ** (m * (q - 1)) * one.structure.jump
        assert jumps[-1] == pytest.approx(wanted, rel=1e-9)
        ends = np.array([0.0, 1.0])
        for d in range(0, 2 * m, 2):
            np.testing.assert_allclose(forced.values(q, ends, d), 0, atol=1e-15)
        if q > 1:
            x = np.array([0.1, 0.25, 0.5, 0.9])
            answer = (-1) ** m * forced.values(q, x, 2 * m)
            np.testing.assert_allclose(answer, forced.values(q - 1, x, 0), atol=1e-13)


@pytest.mark.parametrize("name", NAMES)
def test_pieces_satisfy_what_they_must(name: str) -> None:
    one = attached(name)
    bare = piecewise(one, 6)
    shapes, a = bare.shapes, float(one.a)
    ends, beside = np.array([0.0, 1.0]), np.array([a * (1 - 1e-15), a * (1 + 1e-15)])
    np.testing.assert_allclose(shapes.values(ends, 0), 0, atol=1e-12)
    for derivative in range(max(one.structure.k, one.structure.m - 1) + 1):
        low = shapes.values(beside, derivative)[:6]
        np.testing.assert_allclose(low[:, 0], low[:, 1], rtol=1e-9, atol=1e-9)
    x, weights = quadrature(one, 60)
    low = shapes.values(x, 0)[:6]
    np.testing.assert_allclose((low * weights) @ low.T, np.eye(6), atol=1e-12)
    curved = shapes.values(x, one.structure.m)[:6]
    wanted = np.diag(bare.eigenvalues[:6])
    np.testing.assert_allclose(
        (curved * weights) @ curved.T / wanted[5, 5], wanted / wanted[5, 5], atol=1e-11
    )
    if one.structure.kind == "compliance":
        hinge = shapes.hinge(x, 0)
        assert np.diff(shapes.hinge(beside, 1))[0] == pytest.approx(one.structure.jump)
        np.testing.assert_allclose(shapes.hinge(ends, 0), 0, atol=1e-15)
        np.testing.assert_allclose(low @ (weights * hinge), bare.felt[:6], atol=1e-14)
        left = hinge - bare.felt @ shapes.values(x, 0)
        assert weights @ left**2 == pytest.approx(bare.hinge_rest, rel=1e-3)


@pytest.mark.parametrize("name", NAMES)
def test_exact_shapes_satisfy_equation_and_matching_conditions(name: str) -> None:
    one = attached(name)
    structure, a = one.structure, float(one.a)
    exact = exact_modes(one, 4)
    beside = np.array([a * (1 - 1e-15), a * (1 + 1e-15)])
    for number in range(1, 5):
        lam, size = exact.eigenvalues[number - 1], exact.beta[number - 1]
        moved = exact.shape(number, np.array([a]), structure.felt)[0]
        scale = np.abs(exact.shape(number, np.linspace(0, 1, 50), 0)).max()
        for derivative in range(2 * structure.m):
            sides = exact.shape(number, beside, derivative)
            wanted = law(one, lam) * moved if derivative == structure.broken else 0.0
            assert np.diff(sides)[0] == pytest.approx(
                wanted, abs=1e-10 * scale * size**derivative
            )
        for derivative in range(0, 2 * structure.m, 2):
            ends = exact.shape(number, np.array([0.0, 1.0]), derivative)
            np.testing.assert_allclose(ends, 0, atol=1e-12 * scale * size**derivative)


def test_a_mode_is_normalised_and_rises_from_its_first_end() -> None:
    for name in NAMES:
        for method in ("ritz", "ritz-ck", "ck"):
            one = attached(name)
            x, weights = quadrature(one, 60)
            for mode in at_order(one, method, 8, int(method == "ritz-ck"), 3):
                assert weights @ mode.shape(x) ** 2 == pytest.approx(1, rel=1e-11)
                assert mode.shape(0.0, 1) > 0


def test_nothing_is_proved_from_below_beyond_the_first_sine_left_out() -> None:
    one = attached("beam-spring", "2/7")
    found = at_order(one, "ritz-ck", 2, 1, 3)
    first_left_out = one.bare(np.array([3]))[0]
    assert [mode.eigenvalue < first_left_out for mode in found] == [True, True, False]
    assert [mode.bounds[0] is None for mode in found] == [False, False, True]
    assert found[2].proved_within is None


def test_no_digit_is_lost_for_a_weak_attachment() -> None:
    """The shift from the bare eigenvalue, 1e-8 of it, keeps its digits."""
    one = attached("beam-spring", "3/10", 1e-6)
    roots = secular.eigenvalues(ritz_forced(one, 16, (1,)), one, 1)
    exact = exact_modes(one, 1)
    assert roots.shift[0] == pytest.approx(exact.shifts[0], rel=3e-14)
    first = 2 * np.sin(0.3 * np.pi) ** 2 * one.s
    assert exact.shifts[0] == pytest.approx(first, rel=1e-6)


def test_a_place_in_metres_and_internal_forces_in_si_units() -> None:
    found = modes("beam-rotational-spring", "ck", 10, length=2.0, bending_stiffness=3.0)
    mode = found[0]
    x = np.array([0.2, 0.9, 1.7])
    np.testing.assert_allclose(mode.moment(x), 3.0 * mode.shape(x, 2))
    np.testing.assert_allclose(mode.shear_force(x), 3.0 * mode.shape(x, 3))
    np.testing.assert_allclose(mode.discontinuous(x), mode.moment(x))
    step = 1e-5
    slope = (mode.shape(x + step) - mode.shape(x - step)) / (2 * step)
    np.testing.assert_allclose(mode.shape(x, 1), slope, rtol=1e-8)
    with pytest.raises(ValueError, match=r"x: got 2\.1"):
        mode.shape(2.1)
    with pytest.raises(ValueError, match="a string has none"):
        modes("string-mass")[0].moment(0.5)


@pytest.mark.parametrize("p", [2, 3, 4, 7, 12])
@pytest.mark.parametrize("N", [0, 3, 15, 64, 700])
def test_sums_over_the_modes_beyond_the_first(p: int, N: int) -> None:
    """At angles down to nothing, and on both sides of where another form is taken."""
    angles = np.array([0.0, 1e-9, -3e-4, 4.9 / (N + 1), 5.1 / (N + 1), -1.3, 3.14, 5.9])
    found = beyond(p, N, angles)
    with mp.workdps(60):
        for angle, value in zip(angles, found, strict=True):
            z = mp.expj(mp.mpf(angle))
            wanted = mp.polylog(p, z) - mp.fsum(z**n / mp.mpf(n) ** p for n in range(1, N + 1))
            assert abs(value - complex(wanted)) < ROUNDINGS * EPS * (N + 1.0) ** (1 - p)
