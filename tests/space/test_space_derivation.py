"""What SymPy derives of a structure, against equations and integrals written by hand."""

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from known import NAMES, attached, receptance

from nonsmooth.codegen.space import STRUCTURES, forced_modes, green, matching, series
from nonsmooth.codegen.space.data import a, b, beta, s, x
from nonsmooth.codegen.space.equations import sections
from nonsmooth.codegen.system import DerivationError
from nonsmooth.solver.space.structure import load

CLASSES = {
    "beam-rotational-spring": 1,
    "beam-rotary-inertia": 1,
    "beam-spring": 2,
    "beam-mass": 2,
    "beam-crack": 0,
    "string-mass": 0,
    "string-spring": 0,
}

PLACE, WAVE, STRENGTH = "3/10", mp.mpf("4.7"), 7.0


def by_hand(name: str) -> mp.mpf:
    """Return the left side of the characteristic equation, as it stands in textbooks."""
    one = attached(name, PLACE, STRENGTH)
    m, G = one.structure.m, receptance(one, WAVE)
    cleared = mp.sin(WAVE) * (2 * mp.sinh(WAVE) if m == 2 else 1)
    if one.structure.kind == "stiffness":
        return cleared * WAVE ** (2 * m - 1 - 2 * one.structure.felt) * (1 + STRENGTH * G)
    return cleared * (1 - STRENGTH * WAVE ** (2 * m) * G)


def at_the_point(expression: sp.Expr | sp.Matrix) -> mp.mpf:
    at = mp.mpf(3) / 10
    values = {a: at, b: 1 - at, beta: WAVE, s: STRENGTH}
    return sp.lambdify(list(values), expression, "mpmath")(*values.values())


def test_the_class_is_deduced() -> None:
    assert {name: structure.k for name, structure in STRUCTURES.items()} == CLASSES
    assert {name: load(name).k for name in NAMES} == CLASSES


@pytest.mark.parametrize("name", NAMES)
def test_the_characteristic_equation_is_that_of_the_textbooks(name: str) -> None:
    with mp.workdps(30):
        found = at_the_point(green.characteristic(STRUCTURES[name]))
        assert abs(found / by_hand(name) - 1) < mp.mpf(10) ** -25


@pytest.mark.parametrize("name", NAMES)
def test_it_is_the_determinant_of_the_matching_conditions(name: str) -> None:
    with mp.workdps(30):
        factor = at_the_point(matching.check_determinant(STRUCTURES[name]))
        found = mp.det(at_the_point(matching.matrix(STRUCTURES[name])))
        assert abs(found / (factor * by_hand(name)) - 1) < mp.mpf(10) ** -25


def test_a_wrong_law_is_refuted(monkeypatch: pytest.MonkeyPatch) -> None:
    structure = STRUCTURES["string-spring"]
    wrong = green.characteristic(structure) + s * sp.sin(beta)
    monkeypatch.setattr(matching, "characteristic", lambda _: wrong)
    with pytest.raises(DerivationError, match="string-spring: the determinant"):
        matching.check_determinant.__wrapped__(structure)


def integral(first: forced_modes.Pieces, second: forced_modes.Pieces) -> sp.Expr:
    """Return the integral of a product over the length, piece by piece."""
    sides = zip(first, second, ((x, 0, a), (x, a, 1)), strict=True)
    return sp.factor(sum(sp.integrate(sp.expand(f * g), where) for f, g, where in sides))


@pytest.mark.parametrize(
    "name", ["string-mass", pytest.param("beam-crack", marks=pytest.mark.long)]
)
def test_inner_products_in_closed_form(name: str) -> None:
    structure, n = STRUCTURES[name], sp.Symbol("n", integer=True, positive=True)
    one = attached(name)
    for q in (1, 2):
        sine = sp.sqrt(2) * sp.sin(n * sp.pi * x)
        found = integral((sine, sine), forced_modes.forced_mode(structure, q))
        numbers = np.arange(1, 5)
        wanted = one.felt(numbers) / one.bare(numbers) ** q
        values = [float(found.subs({a: sp.Rational(3, 10), n: int(k)})) for k in numbers]
        np.testing.assert_allclose(values, wanted, rtol=1e-13)
    mode = forced_modes.forced_mode(structure, 1)
    product = integral(mode, mode)
    assert sp.expand(product - forced_modes.static_sum(structure, 2)) == 0


def test_a_sum_that_diverges_is_refused() -> None:
    with pytest.raises(ValueError, match="S_1 diverges"):
        forced_modes.static_sum(STRUCTURES["beam-crack"], 1)


def test_the_first_sums() -> None:
    wanted = {
        "string-mass": (a * b, a**2 * b**2 / 3),
        "beam-spring": (
            a**2 * b**2 / 3,
            a**2 * b**2 * (3 * a**4 - 6 * a**3 - a**2 + 4 * a + 2) / 945,
        ),
        "beam-rotational-spring": (
            (3 * a**2 - 3 * a + 1) / 3,
            (42 * a**6 - 126 * a**5 + 105 * a**4 - 21 * a**2 + 2) / 945,
        ),
    }
    for name, sums in wanted.items():
        for q, value in enumerate(sums, 1):
            found = forced_modes.static_sum(STRUCTURES[name], q)
            assert sp.expand(found - value.subs(b, 1 - a)) == 0


def test_tails_have_the_moments_of_what_is_left_out() -> None:
    """A measure with K points is its own Gauss quadrature: the tail is exact."""
    lam = sp.Symbol("lambda", positive=True)
    nodes, weights = [sp.Rational(1, 5), sp.Rational(1, 11), sp.Rational(1, 29)], [3, 7, 2]
    for K in (1, 2, 3):
        pairs = list(zip(nodes[:K], weights, strict=False))
        moments = [sum(w * x**power for x, w in pairs) for power in range(1, 2 * K + 1)]
        values = dict(zip(forced_modes.sums(2 * K), moments, strict=True))
        exact = sum(w * x / (1 - lam * x) for x, w in pairs)
        found = forced_modes.tail(K).subs(values)
        assert sp.simplify(found.subs(lam, 2) - exact.subs(lam, 2)) == 0


def test_rates_by_class_and_forced_modes() -> None:
    rates = {name: [forced_modes.rate(STRUCTURES[name], K) for K in range(4)] for name in NAMES}
    assert rates["beam-rotational-spring"] == [1, 9, 17, 25]
    assert rates["beam-mass"] == [3, 11, 19, 27]
    assert rates["beam-crack"][1:] == [7, 15, 23]
    assert rates["string-mass"] == [1, 5, 9, 13]


def test_integration_of_legendre_polynomials() -> None:
    v = np.linspace(0, 1, 7)
    for degree in (1, 4, 7):
        whole = np.polynomial.legendre.Legendre.basis(degree, domain=[0, 1]).integ(lbnd=0)
        factor = float(series.integral_factor().subs({series.l: degree, series.h: 1}))
        above = np.polynomial.legendre.Legendre.basis(degree + 1, domain=[0, 1])
        below = np.polynomial.legendre.Legendre.basis(degree - 1, domain=[0, 1])
        np.testing.assert_allclose(factor * (above(v) - below(v)), whole(v), atol=1e-15)


def test_the_equations_of_every_structure_are_shown(run) -> None:
    for name in ("string-spring", "beam-crack"):
        found = sections(name)
        assert [len(part.equations) > 2 for part in found[:2]] == [True, True]
        assert found[0].heading.startswith(f"{name} (`C^{CLASSES[name]}`)")
    status, out, _ = run("equations", "string-spring", "--method", "ritz-c0")
    assert status == 0
    assert "forced mode 2" in out
    assert "Legendre" not in out
    for format_ in ("latex", "html"):
        status, out, _ = run(
            "equations", "string-spring", "--method", "ck", "--format", format_
        )
        assert status == 0
        assert "string" in out
