"""Section 2 as a reader is shown it, against the paper: friction, parameters, exact orbit."""

import pytest
import sympy as sp

from nonsmooth.codegen.shortcuts.paper import section2
from nonsmooth.codegen.shortcuts.paper.oscillator import (
    F_N,
    M,
    T,
    V,
    alpha,
    mu_k,
    mu_s,
    omega_n,
    t,
    t1,
    x_0,
    x_s,
)
from nonsmooth.codegen.shortcuts.paper.section2 import A, F_f, K, V_r, x

SHOWN = section2.equations()
ROWS = {row.title: row.sides for row in SHOWN}

#: An oscillator in exact numbers: 2 kg on 18 N/m, 5 N of normal force, 2/5 m/s.
GIVEN = {M: 2, K: 18, F_N: 5, mu_s: sp.Rational(7, 10), mu_k: sp.Rational(3, 10)}
GIVEN[V] = sp.Rational(2, 5)

#: What follows from it, typed from the paper.
DERIVED = {
    omega_n: sp.Integer(3),
    x_s: sp.Rational(3, 10) * 5 / 18,
    A: sp.Rational(4, 10) * 5 / 18,
    x_0: sp.Rational(3, 10) * 5 / 18 - sp.Rational(4, 10) * 5 / 18,
}
DERIVED[alpha] = 3 * DERIVED[A] / GIVEN[V]
NUMBERS = {**GIVEN, **DERIVED}


@pytest.mark.parametrize("symbol", DERIVED, ids=str)
def test_each_parameter_is_the_one_of_the_paper(symbol: sp.Symbol) -> None:
    (shown,) = (sides[1] for sides in ROWS.values() if sides[0] == symbol)
    assert sp.simplify(shown.subs(NUMBERS) - DERIVED[symbol]) == 0


def test_1_is_newtons_law_with_the_friction_force() -> None:
    left, right = ROWS["equation of motion"]
    newton = M * x(t).diff(t, 2) + K * x(t) - F_f
    assert sp.expand((M * (left - right)).subs(omega_n, sp.sqrt(K / M)) - newton) == 0


def test_2_is_the_spring_force_in_stick_and_opposes_the_motion_in_slip() -> None:
    force, friction = ROWS["friction force, `|K x| <= mu_s F_N` in stick"]
    assert force == F_f
    assert friction.subs(V_r, 0) == K * x(t)
    assert friction.subs(V_r, 3) == -mu_k * F_N
    assert friction.subs(V_r, -3) == mu_k * F_N


def test_the_phases_are_1_with_2_put_in() -> None:
    stick, slip = (row for row in SHOWN if row.number == "1" and row.where)
    assert (stick.where, slip.where) == ("0 <= t < t1", "t1 <= t < T")
    acceleration = x(t).diff(t, 2)
    assert stick.sides == (acceleration, 0)
    put_in = slip.sides[0].subs(x_s, mu_k * F_N / K).subs(K, omega_n**2 * M)
    newton = acceleration + omega_n**2 * x(t) - mu_k * F_N / M
    assert sp.expand(put_in - newton) == 0
    assert slip.sides[1] == 0


def test_the_exact_orbit_sticks_slips_and_comes_back() -> None:
    stick, slip = (ROWS[f"exact orbit, {phase} phase"][1] for phase in ("stick", "slip"))
    times = {t1: ROWS["exact end of stick"][1], T: ROWS["exact period"][1]}
    _, limit, end = ROWS["stick ends at the static limit"]

    def at(motion: sp.Expr, time: sp.Expr, order: int = 0) -> float:
        moment = motion.diff(t, order).subs(t, time)
        return float(moment.subs(times).subs(NUMBERS))

    assert at(stick, 0) == pytest.approx(float(DERIVED[x_0]))
    assert at(limit, 0) == at(end, 0) == pytest.approx(0.7 * 5 / 18)
    for order, reached in enumerate((0.7 * 5 / 18, 0.4)):
        assert at(stick, t1, order) == pytest.approx(reached)
        assert at(slip, t1, order) == pytest.approx(reached)
        assert at(slip, T, order) == pytest.approx(at(stick, 0, order))
    assert sp.expand(slip.diff(t, 2) + omega_n**2 * (slip - x_s)) == 0
    # One time round: in slip the mass moves back, slower than the belt, all the way.
    share = [at(slip, t1 + k * (T - t1) / 50, 1) for k in range(1, 50)]
    assert max(share) < 0.4
