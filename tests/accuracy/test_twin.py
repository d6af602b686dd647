"""The high-precision twin: right by itself, and the judge of float64."""

import mpmath as mp
import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.codegen.shortcuts.reduced.elimination import condition
from nonsmooth.codegen.shortcuts.reduced.elimination import s as slip
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT

flint = pytest.importorskip("flint")

from nonsmooth.shortcuts import twin  # noqa: E402


def unknowns(method: str, order: int, digits: int) -> list:
    """Return the refined unknowns at alpha = 1 as mpmath numbers."""
    orbit = ns.solve(DEFAULT, method, order)
    refined = twin.refine(method, 1.0, orbit.unknowns, digits)
    return [mp.mpf(value.str(digits + 10, radius=False)) for value in refined.unknowns]


@pytest.mark.parametrize("order", [3, 4, 7])
def test_twin_of_c1_is_the_root_of_the_rational_function(order: int) -> None:
    """The rational function has no coefficients, no Newton, no float64."""
    with mp.workdps(60):
        z = unknowns("c1", order, 45)
        duration = z[-1] - z[-2]
        expected = sp.nsolve(condition(order) - 1, slip, float(duration), prec=60)
        assert abs(duration - mp.mpf(str(expected))) < mp.mpf(10) ** -42


def legendre(n: int, x: mp.mpf) -> tuple[mp.mpf, mp.mpf]:
    """Return P_n and its derivative."""
    before, here = mp.mpf(1), x
    for k in range(1, n):
        before, here = here, ((2 * k + 1) * x * here - k * before) / (k + 1)
    return here, n * (before - x * here) / (1 - x**2)


def gauss(n: int) -> tuple[list, list]:
    """Return nodes and weights of the Gauss rule on (0, 1), to all digits in force."""
    nodes, weights = [], []
    for start in np.polynomial.legendre.leggauss(n)[0]:
        x = mp.mpf(float(start))
        for _ in range(3):  # each step doubles the digits
            value, slope = legendre(n, x)
            x -= value / slope
        nodes.append((1 + x) / 2)
        weights.append(1 / ((1 - x**2) * legendre(n, x)[1] ** 2))
    return nodes, weights


@pytest.mark.parametrize("method", ["hb", "hb-c1"])
def test_twin_of_a_fourier_series_satisfies_the_printed_conditions(method: str) -> None:
    """Integrals of (4), (13) as printed, with g1 of (12), to 30 digits."""
    N = 2
    with mp.workdps(40):
        z = unknowns(method, N, 35)
        t1, T = z[-2:]
        w = 2 * mp.pi / T
        shape = T * (T - t1) ** 3
        c1 = z[-3] / shape if method == "hb-c1" else mp.mpf(0)
        nodes, weights = gauss(40)
        stick = [t1 * u for u in nodes]
        slip_ = [t1 + (T - t1) * u for u in nodes]
        lengths = [t1 * v for v in weights] + [(T - t1) * v for v in weights]

        def inner(f: list, g: list) -> mp.mpf:
            """Return (8) of values at the nodes of stick, then of slip."""
            return mp.fsum(a * b * v for a, b, v in zip(f, g, lengths, strict=True))

        def g1(t):
            if t < t1:
                return (t1 - T) ** 3 * t
            cubic = -2 * T * t**3 + 3 * T * (t1 + T) * t**2
            return cubic + (2 * t1**3 - (t1 + T) ** 3) * t - t1**2 * T * (t1 - 3 * T)

        def g1_acceleration(t):
            return mp.mpf(0) if t < t1 else -12 * T * t + 6 * T * (t1 + T)

        waves = [lambda t: mp.mpf(1)]
        waves += [lambda t, n=n: mp.sin(n * w * t) for n in range(1, N + 1)]
        waves += [lambda t, n=n: mp.cos(n * w * t) for n in range(1, N + 1)]
        tables = [[wave(t) for t in stick + slip_] for wave in waves]
        g1_table = [g1(t) for t in stick + slip_]
        # The kernel's coefficients stand beside the tail of g1: take its harmonics away.
        c = list(z[: 2 * N + 1])
        if c1:
            c = [
                value - c1 * 2 / T * inner(g1_table, table)
                for value, table in zip(c, tables, strict=True)
            ]
        c[0] /= 2
        order = [0, *range(1, N + 1), *range(1, N + 1)]

        def x(t):
            return sum(a * f(t) for a, f in zip(c, waves, strict=True)) + c1 * g1(t)

        def acceleration(t):
            series = sum(
                -a * (n * w) ** 2 * f(t) for a, n, f in zip(c, order, waves, strict=True)
            )
            return series + c1 * g1_acceleration(t)

        residual = [acceleration(t) for t in stick]
        residual += [acceleration(t) + x(t) for t in slip_]
        for test in [*tables, g1_table] if c1 else tables:
            assert abs(inner(residual, test)) < mp.mpf(10) ** -30
        assert abs(x(mp.mpf(0)) + 1) < mp.mpf(10) ** -30


@pytest.mark.parametrize(("method", "order"), [("hb", 6), ("hb-c1", 6), ("c1", 9)])
def test_more_digits_begin_with_the_same_digits(method: str, order: int) -> None:
    orbit = ns.solve(DEFAULT, method, order)
    few, many = (twin.precise(orbit, digits) for digits in (30, 120))
    for name in ("period", "t1"):
        short, long = getattr(few, name), getattr(many, name)
        assert len(long) > 100
        # The last digit shown is rounded.
        assert long.startswith(short[:-2])
    assert float(few.period) == pytest.approx(orbit.period, rel=1e-14)
    assert float(few.error_period) == pytest.approx(orbit.errors.period, rel=1e-6, abs=1e-15)


def test_error_at_order_13_has_the_digits_that_float64_lacks() -> None:
    precise = twin.precise(ns.solve(DEFAULT, "c1", 13), 40)
    assert precise.error_period.startswith("2.84740883052956")


def test_the_setting_of_flint_is_restored() -> None:
    before = flint.ctx.dps
    twin.precise(ns.solve(DEFAULT, "c1", 5), 60)
    assert flint.ctx.dps == before


@pytest.mark.parametrize(
    ("longer", "reason"),
    [(1, "the refinement does not converge"), (40, "no convergence within the limit of steps")],
)
def test_a_start_that_is_no_orbit_is_refused(longer: float, reason: str) -> None:
    """Where the steps get longer at once, and where they go astray."""
    orbit = ns.solve(DEFAULT, "c1", 4)
    wrong = orbit.unknowns.copy()
    wrong[-1] += longer
    with pytest.raises(twin.PrecisionError, match=reason):
        twin.refine("c1", 0.25, wrong, 30)  # at this alpha there is no orbit of order 4


@pytest.mark.parametrize("digits", [0, -1, 1001])
def test_a_wrong_number_of_digits_is_named(digits: int) -> None:
    with pytest.raises(ValueError, match="digits: got"):
        twin.precise(ns.solve(DEFAULT, "c1", 5), digits)
