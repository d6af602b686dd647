"""The equations that a reader is shown, dimensional, against the paper by quadrature.

The left side of each condition is typed from the paper in `paper`; the right side is the
closed form of the record, evaluated as it stands.
"""

import numpy as np
import pytest
import sympy as sp
from evaluate import ORDER, symbols, value
from paper import Problem, cosine, one, sine

from nonsmooth.codegen import derive
from nonsmooth.codegen.shortcuts.paper import c1 as c1_codegen
from nonsmooth.codegen.shortcuts.paper import fourier, hb_c1

PROBLEM = Problem(t1=1.7, T=5.3, omega_n=1.4, x_s=0.6)
V, X_0 = 0.8, -0.3

rng = np.random.default_rng(20030213)
A0, C1 = 0.37, 0.021
A, B, D = (rng.normal(size=size) for size in (ORDER, ORDER, ORDER + 1))

numbers: dict[sp.Expr, float] = symbols(PROBLEM, V, X_0) | {fourier.a0: A0, hb_c1.c1: C1}
for i in range(ORDER):
    numbers |= {fourier.a[i + 1]: A[i], fourier.b[i + 1]: B[i]}
for i in range(ORDER + 1):
    numbers |= {c1_codegen.d[i]: D[i]}

SERIES, SERIES_ACCELERATION = PROBLEM.series(A0, A, B)


def with_g1(t):
    return SERIES(t) + C1 * PROBLEM.g1(t)


def with_g1_acceleration(t):
    return SERIES_ACCELERATION(t) + C1 * PROBLEM.g1_acceleration(t)


MOTIONS = {
    "hb": (SERIES, SERIES_ACCELERATION),
    "hb-c1": (with_g1, with_g1_acceleration),
    "c1": PROBLEM.polynomial(D, V, X_0),
}

TESTS = {"5": lambda j: one, "6": lambda j: sine(j * PROBLEM.omega_0)}
TESTS |= {"7": lambda j: cosine(j * PROBLEM.omega_0), "14": lambda j: PROBLEM.g1}
TESTS |= {
    "18": lambda k: lambda t: (t > PROBLEM.t1) * (t - PROBLEM.t1) ** (k + 2) / (k + 1) / (k + 2)
}


@pytest.mark.parametrize(
    ("method", "number", "index"),
    [
        *((m, "5", 0) for m in ("hb", "hb-c1")),
        *((m, n, j) for m in ("hb", "hb-c1") for n in ("6", "7") for j in (1, 2, 3)),
        ("hb-c1", "14", 0),
        *(("c1", "18", k) for k in range(ORDER + 1)),
    ],
)
def test_orthogonality_condition_is_the_inner_product_of_the_paper(
    method: str, number: str, index: int
) -> None:
    system = derive(method)
    _, closed, zero = system.equation(number).sides
    at = {symbol: index for symbol in closed.free_symbols if symbol.name in {"j", "k"}}
    expected = PROBLEM.inner(*PROBLEM.residual(*MOTIONS[method]), TESTS[number](index))
    assert value(closed.subs(at), system, numbers) == pytest.approx(expected, rel=1e-11)
    assert zero == 0


@pytest.mark.parametrize("method", ["hb", "hb-c1"])
def test_9_and_10_are_displacement_and_velocity_at_0(method: str) -> None:
    system = derive(method)
    x, _ = MOTIONS[method]
    h = 1e-5
    start = np.array([0.0, h, -h])
    if method == "hb-c1":  # stick continued to t < 0
        g1 = (PROBLEM.t1 - PROBLEM.T) ** 3 * start
        displacement, ahead, behind = SERIES(start) + C1 * g1
    else:
        displacement, ahead, behind = x(start)
    _, at_0, x_0 = system.equation("9").sides
    _, rate, velocity = system.equation("10").sides
    assert value(at_0, system, numbers) == pytest.approx(displacement, rel=1e-12)
    # central difference: error h**2 x'''/6
    assert value(rate, system, numbers) == pytest.approx((ahead - behind) / (2 * h), rel=1e-8)
    assert value(x_0, system, numbers) == X_0
    assert value(velocity, system, numbers) == V


def test_19_and_20_are_what_one_period_adds_to_16() -> None:
    system = derive("c1")
    x, acceleration = MOTIONS["c1"]
    start, end = x(np.array([0.0, PROBLEM.T]))
    _, gain, zero = system.equation("19").sides
    assert value(gain, system, numbers) == pytest.approx(end - start, rel=1e-11)
    _, rate, also_zero = system.equation("20").sides
    assert value(rate, system, numbers) == pytest.approx(PROBLEM.slip(acceleration), rel=1e-11)
    assert zero == also_zero == 0


@pytest.mark.parametrize(
    ("method", "number"),
    [("hb", "4"), ("hb-c1", "12"), ("c1", "15"), ("c1", "16"), ("c1", "17")],
)
def test_functions_of_time_are_those_of_the_paper(method: str, number: str) -> None:
    system = derive(method)
    x, acceleration = MOTIONS[method]
    stick, slip = PROBLEM.residual(x, acceleration)
    by_phase = {
        "4": (stick, slip),
        "12": (PROBLEM.g1, PROBLEM.g1),
        "15": (acceleration, acceleration),
        "16": (x, x),
        "17": (stick, slip),
    }[number]
    shown = [equation for equation in system.equations if equation.number == number]
    e0_e1 = {c1_codegen.e0: V, c1_codegen.e1: X_0, hb_c1.u: (3.1 - 1.7) / 3.6}
    # One equation for both phases, or one for each.
    for t, function, equation in zip((0.9, 3.1), by_phase, (shown * 2)[:2], strict=True):
        time = {symbol: t for symbol in equation.sides[1].free_symbols if symbol.name == "t"}
        for side in equation.sides[1:]:
            got = value(side.subs(e0_e1).subs(time), system, numbers)
            assert got == pytest.approx(float(function(np.array(t))), rel=1e-10, abs=1e-12)


def test_the_residual_of_g1_is_tested_over_slip() -> None:
    system = derive("hb-c1")
    shown = [e for e in system.equations if e.title.startswith("residual of g1")]
    assert len(shown) == 4
    for equation in shown:
        name, integral, closed = equation.sides
        at = {symbol: 2 for symbol in closed.free_symbols if symbol.name == "j"}
        put_in = integral.subs(hb_c1.g1, hb_c1.smooth.G1_SLIP).doit().subs(at)
        expected = value(put_in, system, numbers)
        assert value(closed.subs(at), system, numbers) == pytest.approx(expected, rel=1e-11), (
            name
        )


@pytest.mark.parametrize(("name", "wave"), [("gamma^s", sine), ("gamma^c", cosine)])
def test_harmonics_of_the_tail_are_those_of_12(name: str, wave) -> None:
    system = derive("hb-c1")
    shown = {str(e.sides[0]): e.sides[1] for e in system.equations if not e.number}
    scale = 2 / PROBLEM.T / (PROBLEM.T * (PROBLEM.T - PROBLEM.t1) ** 3)
    for j in (1, 3):
        closed = shown[f"{name}[j]"]
        at = {symbol: j for symbol in closed.free_symbols if symbol.name == "j"}
        test = wave(j * PROBLEM.omega_0)
        expected = scale * PROBLEM.inner(PROBLEM.g1, PROBLEM.g1, test)
        assert value(closed.subs(at), system, numbers) == pytest.approx(expected, rel=1e-11)
    mean = scale * PROBLEM.inner(PROBLEM.g1, PROBLEM.g1, one)
    assert value(shown["gamma_0"], system, numbers) == pytest.approx(mean, rel=1e-11)


def test_13_adds_g1_through_the_equation_of_motion_in_slip_alone() -> None:
    stick, slip = (e for e in derive("hb-c1").equations if e.number == "13")
    assert stick.sides[1] == sp.Function("R1")(*stick.sides[0].args)
    added = slip.sides[1] - stick.sides[1]
    assert sp.simplify(added - hb_c1.c1 * hb_c1.through_g1) == 0


@pytest.mark.parametrize(
    ("method", "numbers_"),
    [
        ("hb", ["3", "4", "4", "5", "6", "7", "8", "9", "10"]),
        ("hb-c1", ["11", "12", "12", "13", "13", "5", "6", "7", "14", "9", "10"]),
        ("c1", ["15", "16", "17", "17", "18", "19", "20"]),
    ],
)
def test_every_equation_of_the_section_is_there(method: str, numbers_: list[str]) -> None:
    assert [e.number for e in derive(method).equations if e.number] == numbers_


def test_an_unknown_number_is_named() -> None:
    with pytest.raises(KeyError, match=r"hb has no equation \(19\)"):
        derive("hb").equation("19")
