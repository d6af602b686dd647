"""What is solved in place of the paper's systems, as a reader is shown it, at a solution.

Each equation of `hb-symmetric` and `c1-reduced` is evaluated as it stands, with integrals by
quadrature, at what Newton's method has found: a wrong one would not hold there.
"""

from collections.abc import Callable
from functools import cache

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import quad
from scipy.special import spherical_jn

from nonsmooth.codegen import SOLVED, derive
from nonsmooth.codegen.shortcuts.paper.inner_product import C, N, j, k, omega_0
from nonsmooth.codegen.shortcuts.paper.oscillator import T, alpha, t1
from nonsmooth.codegen.shortcuts.paper.slip_moments import s
from nonsmooth.codegen.shortcuts.reduced import c1_reduced
from nonsmooth.codegen.shortcuts.reduced.c1_reduced_equations import L, c
from nonsmooth.codegen.shortcuts.symmetric import symmetric_equations as shown
from nonsmooth.codegen.shortcuts.symmetric.odd_functions import l, v
from nonsmooth.codegen.shortcuts.symmetric.symmetry import tau
from nonsmooth.codegen.system import GalerkinSystem
from nonsmooth.solver.shortcuts.search import kernels
from nonsmooth.solver.shortcuts.search.newton import newton
from nonsmooth.solver.shortcuts.search.start import cubic_slip, rough_times

ORDER, TERMS, ALPHA = 5, 3, 0.8
KERNEL = kernels.plain("hb-symmetric")


def symmetric() -> GalerkinSystem:
    """Return the record of Sections 3.1 and 3.2 about mid-stick, derived once."""
    return derive("hb-symmetric")


def sides(title: str, system: GalerkinSystem | None = None) -> tuple[sp.Expr, ...]:
    """Return the sides of the equation whose title starts so."""
    (found,) = (e for e in (system or symmetric()).equations if e.title.startswith(title))
    return found.sides


def solution() -> np.ndarray:
    start = cubic_slip(KERNEL, TERMS, ORDER, *rough_times(ALPHA))
    outcome = newton(KERNEL.iterate, (ALPHA, TERMS), start)
    assert outcome.converged
    return outcome.unknowns


UNKNOWNS = solution()
STICK, PERIOD = UNKNOWNS[-2:]
SLIP = PERIOD - STICK
NUMBERS = {t1: STICK, T: PERIOD, s: SLIP, omega_0: 2 * np.pi / PERIOD, alpha: ALPHA}
NUMBERS |= {shown.b[n + 1]: UNKNOWNS[n] for n in range(ORDER)}
NUMBERS |= {shown.c[i + 1]: UNKNOWNS[ORDER + i] for i in range(TERMS)}
PARTS = KERNEL.functions["accelerations"](TERMS, ORDER)
NUMBERS |= {shown.a[i + 1, m]: PARTS[i, m] for i in range(TERMS) for m in range(i + 1)}


def evaluated(side: sp.Expr, **at: int) -> sp.Expr:
    """Return a side with its sums carried out and all that is known put in."""
    names = {"i": shown.i, "j": j, "k": k, "l": l, "m": shown.m}
    side = side.subs({names[name]: value for name, value in at.items()})
    known = {name: sp.sympify(number) for name, number in NUMBERS.items()}
    return side.subs({N: ORDER, shown.K: TERMS}).doit(integrals=False).xreplace(known)


def learn(name: sp.IndexedBase, title: str, *indices: dict[str, int]) -> None:
    """Put the last side of a definition into what is known, at these indices."""
    left, *_, right = sides(title)
    for at in indices:
        assert evaluated(left, **at).base == name
        NUMBERS[evaluated(left, **at)] = float(evaluated(right, **at))


def over_slip(function) -> float:
    return quad(function, STICK / 2, PERIOD - STICK / 2, epsabs=1e-13, limit=200)[0]


def over_half_stick(function) -> float:
    return quad(function, 0, STICK / 2, epsabs=1e-13)[0]


def legendre(degree: int, time: float) -> float:
    return float(np.polynomial.legendre.Legendre.basis(degree)((2 * time - PERIOD) / SLIP))


def integrated(degree: int, at: sp.Expr | float) -> sp.Expr:
    """Return Q_l as shown, at `at`."""
    if degree == 1:
        (_, right) = sides("the paper's")
        return right.subs(NUMBERS).subs(v, at)
    (_, right) = sides("P_l integrated twice")
    right = right.subs(l, degree)
    return right.subs({p: sp.legendre(p.indices[0], at) for p in right.atoms(sp.Indexed)}).subs(
        NUMBERS
    )


Q_SLIP: dict[int, Callable[[float], float]] = {}
HARMONICS = [{"i": i, "j": n} for i in range(1, TERMS + 1) for n in range(1, ORDER + 1)]


@cache
def in_stick(i: int) -> Callable[[float], float]:
    """Return C1 function `i` in stick as shown."""
    return sp.lambdify(tau, evaluated(sides("it in stick")[1], i=i))


def function(i: int, time: float) -> float:
    """Return C1 function `i` by the equations shown, at 0 <= time <= T - t1/2."""
    if time < STICK / 2:
        return float(in_stick(i)(time))
    return sum(PARTS[i - 1, m] * Q_SLIP[2 * m + 1](time) for m in range(i))


def tail(i: int, time: float) -> float:
    waves = np.sin(np.arange(1, ORDER + 1) * 2 * np.pi / PERIOD * time)
    harmonics = [NUMBERS[shown.gamma[i, n]] for n in range(1, ORDER + 1)]
    return function(i, time) - float(waves @ harmonics)


def sine(n: int, time: float) -> float:
    return float(np.sin(n * 2 * np.pi / PERIOD * time))


@pytest.fixture(scope="module", autouse=True)
def known() -> None:
    """Put what the equations define into the numbers, by the definitions that are shown."""
    for m in range(TERMS):
        at = (2 * tau - PERIOD) / SLIP
        Q_SLIP[2 * m + 1] = sp.lambdify(tau, integrated(2 * m + 1, at))
    for m in range(TERMS):
        for n in range(1, ORDER + 1):
            wave = over_slip(
                lambda time, m=m, n=n: (
                    legendre(2 * m + 1, time) * np.sin(n * 2 * np.pi / PERIOD * time)
                )
            )
            NUMBERS[shown.M[2 * m + 1, n]] = wave
    learn(shown.gamma, "harmonics of C1 function", *HARMONICS)
    for where in HARMONICS:
        by_tail = over_slip(lambda time, at=where: tail(at["i"], time) * sine(at["j"], time))
        NUMBERS[shown.h[where["i"], where["j"]]] = by_tail
    learn(shown.phi, "its tail at t1", *({"i": i} for i in range(1, TERMS + 1)))
    learn(shown.psi, "the velocity of its tail", *({"i": i} for i in range(1, TERMS + 1)))
    learn(
        C,
        "slip integral C_k, k",
        *({"k": q} for q in (*range(-ORDER, 0), *range(1, 2 * ORDER + 1))),
    )
    NUMBERS[C[0]] = float(evaluated(sides("slip integral C_k, the diagonal")[1]))


@pytest.mark.parametrize("i", range(1, TERMS + 1))
def test_a_c1_function_has_the_acceleration_shown(i: int) -> None:
    _, shape, by_legendre = (evaluated(side, i=i) for side in sides("acceleration of C1"))
    polynomials = {p: sp.legendre(p.indices[0], v) for p in by_legendre.atoms(sp.Indexed)}
    difference = sp.expand(by_legendre.subs(polynomials) - shape)
    assert all(abs(q) < 1e-9 for q in sp.Poly(difference, v).all_coeffs())
    in_slip = sum(PARTS[i - 1, m] * integrated(2 * m + 1, v) for m in range(i))
    difference = sp.expand(in_slip.diff(v, 2) * 4 / SLIP**2 - shape)
    assert all(abs(q) < 1e-9 for q in sp.Poly(difference, v).all_coeffs())


@pytest.mark.parametrize("i", range(1, TERMS + 1))
def test_it_is_c1_and_periodic(i: int) -> None:
    end, h = STICK / 2, 1e-6
    assert function(i, end - 1e-12) == pytest.approx(function(i, end + 1e-12), abs=1e-10)
    before = (function(i, end - h) - function(i, end - 2 * h)) / h
    after = (function(i, end + 2 * h) - function(i, end + h)) / h
    assert before == pytest.approx(after, abs=1e-4)
    assert function(i, PERIOD / 2) == pytest.approx(0, abs=1e-12)  # odd about mid-slip


@pytest.mark.parametrize("m", range(TERMS))
@pytest.mark.parametrize("n", [1, 4])
def test_moments(m: int, n: int) -> None:
    _, _, closed = sides("moments")
    z = float(evaluated(sides("half angle")[1], k=n))
    bessel = spherical_jn(2 * m + 1, z)
    (name,) = closed.atoms(sp.Function)
    assert float(evaluated(closed.subs(name, bessel), k=n, m=m)) == pytest.approx(
        NUMBERS[shown.M[2 * m + 1, n]], rel=1e-10
    )


@pytest.mark.parametrize("at", HARMONICS[::4])
def test_harmonics(at: dict[str, int]) -> None:
    def product(time: float) -> float:
        return function(at["i"], time) * sine(at["j"], time)

    expected = 2 / PERIOD * (2 * over_half_stick(product) + over_slip(product))
    assert NUMBERS[shown.gamma[at["i"], at["j"]]] == pytest.approx(expected, abs=1e-11)


def test_slip_integrals() -> None:
    for q in (1, 7):
        wave = over_slip(lambda time, q=q: np.cos(q * 2 * np.pi / PERIOD * time))
        assert NUMBERS[C[q]] == pytest.approx(wave, abs=1e-12)
    assert NUMBERS[C[0]] == pytest.approx(SLIP, rel=1e-15)


def test_the_tail_at_t1() -> None:
    for i in range(1, TERMS + 1):
        end, h = STICK / 2, 1e-6
        assert NUMBERS[shown.phi[i]] == pytest.approx(tail(i, end), abs=1e-11)
        rate = (tail(i, end - h) - tail(i, end - 3 * h)) / (2 * h)
        assert NUMBERS[shown.psi[i]] == pytest.approx(rate, abs=1e-4)


def test_6_9_10_and_the_response_hold_at_the_solution() -> None:
    for n in range(1, ORDER + 1):
        *_, closed, zero = symmetric().equation("6").sides
        assert float(evaluated(closed, j=n)) == pytest.approx(float(zero), abs=1e-11)
        left, right = (evaluated(side, j=n) for side in sides("(6) solved"))
        assert float(left) == pytest.approx(float(right), abs=1e-11)
    for number in ("9", "10"):
        *_, closed, value = (evaluated(side) for side in symmetric().equation(number).sides[1:])
        assert float(closed) == pytest.approx(float(value), abs=1e-11)


@pytest.mark.parametrize("i", range(1, TERMS + 1))
def test_6_and_14_are_inner_products_with_the_residual(i: int) -> None:
    w = 2 * np.pi / PERIOD

    def motion(time: float) -> float:
        series = sum(UNKNOWNS[n - 1] * sine(n, time) for n in range(1, ORDER + 1))
        return series + sum(
            UNKNOWNS[ORDER + q - 1] * tail(q, time) for q in range(1, TERMS + 1)
        )

    def acceleration(time: float) -> float:
        waves = [-((n * w) ** 2) * sine(n, time) for n in range(1, ORDER + 1)]
        of_tails = [
            sum(-NUMBERS[shown.gamma[q, n]] * waves[n - 1] for n in range(1, ORDER + 1))
            + (
                PARTS[q - 1, :q] @ [legendre(2 * m + 1, time) for m in range(q)]
                if time > STICK / 2
                else 0
            )
            for q in range(1, TERMS + 1)
        ]
        return float(UNKNOWNS[:ORDER] @ waves + UNKNOWNS[ORDER:-2] @ of_tails)

    def residual(time: float) -> float:
        return acceleration(time) + (motion(time) if time > STICK / 2 else 0)

    for test in (lambda time: tail(i, time), lambda time: sine(i, time)):
        product = lambda time, test=test: residual(time) * test(time)  # noqa: E731
        inner = 2 * over_half_stick(product) + over_slip(product)
        assert inner == pytest.approx(0, abs=1e-10)


@pytest.mark.parametrize("order", [2, 3])
def test_the_scalar_equation_is_made_of_the_parts_shown(order: int) -> None:
    system = derive("c1-reduced")
    expected = c1_reduced.series(order)
    letter = "e" if order % 2 == 0 else "o"
    for end, title in ((1, "at u = 1"), (0, "at u = 0")):
        ratio = sides(title, system)[1]
        n, index = sorted(ratio.free_symbols, key=str, reverse=True)
        coefficients = {c[0]: sp.Integer(1)}
        for q in range(2 * order + 2):
            step = ratio.subs({n: order, index: q}) if q < order else 0
            coefficients[c[q + 1]] = coefficients[c[q]] * step
        J = c1_reduced.jacobi(order)
        for q in range(order + 1):
            sign = 1 if end == 1 else (-1) ** q
            over = J.diff(c1_reduced.u, order - q).subs(c1_reduced.u, end) / J.diff(
                c1_reduced.u, order
            )
            assert coefficients[c[q]] == sign * over
        for name in ("even", "odd"):
            _, part = sides(f"{name} part of J_n and its derivatives at u = {end}", system)
            value = part.subs(n, order).doit().subs(coefficients)
            assert (
                sp.expand(value - expected[sp.Symbol(f"{name}_{end}_{letter}", real=True)]) == 0
            )


def test_the_polynomial_shown_solves_18() -> None:
    system = derive("c1-reduced")
    order, u = 4, c1_reduced.u
    left, load = system.equation("18").sides
    jacobi = {q: c1_reduced.jacobi(q.indices[0]) for q in load.subs(N, order).atoms(sp.Indexed)}
    load = load.subs(N, order).subs(jacobi)
    y, solution = sides("the polynomial that solves it", system)
    solution = solution.subs(N, order).doit()
    derivatives = {q: load.diff(u, q.indices[0]) for q in solution.atoms(sp.Indexed)}
    assert {q.base for q in derivatives} == {L}
    solution = solution.subs(derivatives)
    assert sp.expand(left.subs(y, solution).doit() - load) == 0


@pytest.mark.parametrize("method", SOLVED)
def test_the_command_shows_them(run, method: str) -> None:
    status, out, _ = run("equations", "--method", method)
    assert status == 0
    assert f"({method})" in out
    assert max(map(len, out.splitlines())) <= 80
    assert "Jacobian" not in out
    status, out, err = run("equations", "--method", method, "--expand", 2)
    assert (status, out) == (2, "")
    assert err.startswith(f"nonsmooth: --method: got '{method}', expected hb, hb-c1 or c1")
