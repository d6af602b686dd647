"""Mode shapes: against the same combination in many digits, at the ends, at the attachment."""

from functools import cache

import mpmath as mp
import numpy as np
import pytest
from known import drawn, expansion, felt, law, place, quadrature

import nonsmooth as ns
from nonsmooth.solver.space.attached import Attached
from nonsmooth.solver.space.mode import Mode
from nonsmooth.solver.space.modes import at_order

#: Seeds that are rare.
LONG = [pytest.param(seed, marks=pytest.mark.long) for seed in range(100, 300)]


@cache
def wave_sum(one: Attached, q: int, x: float, derivative: int = 0) -> mp.mpf:
    """Return a derivative of ``g_q``, by its Fourier series: polylogarithms of unit numbers.

    The shapes of one structure are combinations of the same: kept, in the digits of the first.
    """
    j, a = one.structure.felt, place(one)
    p = 2 * one.structure.m * q - j - derivative
    apart, along = (mp.polylog(p, mp.expjpi(mp.mpf(x) + sign * a)) for sign in (-1, 1))
    turned = mp.mpc(0, 1) ** (derivative - j) * apart - mp.mpc(0, 1) ** (derivative + j) * along
    return mp.re(turned) / mp.pi**p


def combination(one: Attached, N: int, K: int, lam: mp.mpf, x: np.ndarray) -> np.ndarray:
    """Return the shape that N sines and K forced modes have at an eigenvalue, not scaled.

    Beyond the sines, where the attachment loads the structure, their conditions are K
    equations with the sums of what the sines leave out.
    """
    m, j = one.structure.m, one.structure.felt
    compliant = one.structure.kind == "compliance"
    mu = {n: (n * mp.pi) ** (2 * m) for n in range(1, N + 1)}
    r = {n: felt(one, n) for n in mu}

    def left(q: int) -> mp.mpf:
        return wave_sum(one, q, place(one), j) - mp.fsum(r[n] ** 2 / mu[n] ** q for n in mu)

    chosen = range(1 + compliant, K + 1)
    sums = {q: left(q) for q in range(1 + compliant, 2 * K + 1)}
    weights = {}
    if chosen:
        block = mp.matrix(
            [[sums[p + q - 1] - lam * sums[p + q] for q in chosen] for p in chosen]
        )
        load = mp.matrix([lam * sums[p + 1] if compliant else sums[p] for p in chosen])
        weights = dict(zip(chosen, mp.lu_solve(block, load), strict=True))
    if compliant and K:
        weights[1] = mp.mpf(1)
    found = []
    for at in x:
        total = mp.fsum(w * wave_sum(one, q, at) for q, w in weights.items())
        for n, bare in mu.items():
            part = r[n] / (bare - lam) - mp.fsum(w * r[n] / bare**q for q, w in weights.items())
            total += part * mp.sqrt(2) * mp.sin(n * mp.pi * mp.mpf(at))
        found.append(total)
    return np.array([float(value / max(map(abs, found))) for value in found])


def assert_same(values: np.ndarray, wanted: np.ndarray, most: float) -> None:
    """Hold a function against another, but for its sign and size."""
    scaled = values * (values @ wanted) / (values @ values)
    np.testing.assert_allclose(scaled, wanted, rtol=0, atol=most * np.abs(wanted).max())


def assert_sound(one: Attached, mode: Mode) -> None:
    """Check a shape at both ends and on both sides of the attachment."""
    structure, a, beta = one.structure, float(one.a), mode.beta
    size = np.abs(mode.shape(np.linspace(0, 1, 301))).max()
    assert np.abs(mode.shape([0.0, 1.0])).max() < 1e-11 * size
    sides = np.nextafter(a, [0.0, 1.0])
    for derivative in range(structure.broken):
        before, behind = mode.shape(sides, derivative)
        most = np.abs(mode.shape(np.linspace(0, 1, 301), derivative)).max()
        assert abs(behind - before) < 1e-9 * max(most, size * beta**derivative)
    if mode.jump_mismatch is None:
        return
    before, behind = mode.shape(sides, structure.broken)
    jump = law(one, mode.eigenvalue) * mode.shape(a, structure.felt)
    most = np.abs(mode.shape(np.linspace(0, 1, 301), structure.broken)).max()
    assert behind - before == pytest.approx(
        jump * (1 + mode.jump_mismatch),
        rel=1e-9,
        abs=1e-11 * (most + size * beta**structure.broken),
    )


@pytest.mark.parametrize("seed", [*range(30), *LONG])
def test_a_shape_is_that_of_its_expansion(seed: int) -> None:
    one, (method, order, forced) = drawn(seed, negative=seed % 5 == 0), expansion(seed)
    modes = at_order(one, method, order, forced, None)
    found = at_order(one, method, order, forced, max(len(modes), min(25, order)))
    for mode in {found[-1], found[len(found) // 2], found[0]}:
        if method == "ck" and mode.error > 1:
            continue  # 1e5 times too high and more, on a segment beside an end
        assert_sound(one, mode)
        if method == "ck" or mode.node is not None:
            continue
        x = np.random.default_rng(seed).uniform(0, 1, 4)
        with mp.workdps(60):
            wanted = combination(one, order, forced, mp.mpf(mode.eigenvalue), x)
        assert_same(mode.shape(x), wanted, 1e-10)


def work(one: Attached, modes: ns.Modes, derivative: int) -> np.ndarray:
    """Return the integrals of products of a derivative of shapes, by Gauss quadrature."""
    x, weights = quadrature(one, 200)
    values = np.array([mode.normalised(one.length * x, derivative) for mode in modes])
    return one.length * (values * weights) @ values.T


NUMBERS = {"length": 1.7, "mass_per_length": 0.6}
STIFF = {"bending_stiffness": 2.3, "tension": 2.3}


@pytest.mark.parametrize(
    ("name", "attached"),
    [
        ("beam-mass", {"mass": 3.0}),
        ("beam-rotary-inertia", {"inertia": 0.4}),
        ("string-mass", {"mass": 3.0}),
        ("beam-spring", {"stiffness": 40.0}),
        ("beam-rotational-spring", {"stiffness": 4.0}),
        ("string-spring", {"stiffness": 4.0}),
    ],
)
def test_normalised_shapes_are_orthonormal_with_what_is_attached(name, attached) -> None:
    """Mass and stiffness by quadrature: unity, and the squares of the angular frequencies."""
    stiff = "tension" if name.startswith("string") else "bending_stiffness"
    modes = ns.modes(
        name, order=24, forced=2, count=4, position="0.27", **NUMBERS, **attached,
        **{stiff: STIFF[stiff]},
    )  # fmt: skip
    one, m = modes.attached, modes.attached.structure.m
    (strength,) = attached.values()
    place = one.structure.felt
    at = np.array([mode.normalised(float(one.a) * one.length, place) for mode in modes])
    loads = one.structure.kind == "inertia"
    mass = NUMBERS["mass_per_length"] * work(one, modes, 0) + loads * strength * np.outer(
        at, at
    )
    stiffness = STIFF[stiff] * work(one, modes, m) + (not loads) * strength * np.outer(at, at)
    squares = np.array([mode.omega for mode in modes]) ** 2
    assert mass == pytest.approx(np.eye(4), abs=1e-7)
    assert stiffness == pytest.approx(np.diag(squares), abs=1e-6 * squares.max())


def test_frequencies_in_each_unit() -> None:
    mode = ns.modes("beam-mass", method="ritz", length=2.0, bending_stiffness=5.0)[1]
    assert mode.omega == pytest.approx((mode.beta / 2.0) ** 2 * 5.0**0.5, rel=1e-14)
    assert mode.frequency == pytest.approx(mode.omega / (2 * np.pi), rel=1e-15)
    assert mode.frequency / mode.exact_frequency - 1 == pytest.approx(mode.error, rel=1e-9)
