"""The exact orbit against an integration of (1), (2) with events."""

import math
import os
from typing import Any

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

import nonsmooth as ns
from nonsmooth.codegen.shortcuts.paper import oscillator

positive = st.floats(0.05, 20)


@st.composite
def belts(draw: st.DrawFn) -> ns.StickSlip:
    mu_s = draw(st.floats(0.2, 1))
    # Not mu_s/2: there stick would start at x = 0 and a sign error in x_0 would not show.
    part = draw(st.one_of(st.just(0.0), st.floats(0.1, 0.4), st.floats(0.6, 0.95)))
    names = ("mass", "stiffness", "belt_speed", "normal_force")
    return ns.StickSlip(mu_s=mu_s, mu_k=part * mu_s, **{name: draw(positive) for name in names})


#: An integration at small alpha takes seconds: few in each run, many where asked for.
EXAMPLES = min(int(os.environ.get("EXAMPLES", "8")), 100)


@settings(max_examples=EXAMPLES)
@given(belts())
def test_exact_orbit_is_what_an_integrator_finds(belt: ns.StickSlip) -> None:
    M, K, V = belt.mass, belt.stiffness, belt.belt_speed
    static, kinetic = belt.mu_s * belt.normal_force, belt.mu_k * belt.normal_force
    stick = (static - float(ns.exact(belt).displacement(0)) * K) / (K * V)

    def slip(t, state):
        return [state[1], (kinetic - K * state[0]) / M]

    def back(t, state):
        return state[1] - V

    back.terminal, back.direction = True, 1
    period = 2 * math.pi * math.sqrt(M / K)
    # Just after the start of slip the velocity is V: step over it by a series in time.
    h = 1e-6 * period
    a = (kinetic - static) / M
    start = [static / K + V * h + a * h**2 / 2 - K / M * V * h**3 / 6]
    start.append(V + a * h - K / M * V * h**2 / 2)
    # At small alpha the velocity is above V for a moment only: steps must not skip it.
    accuracy: dict[str, Any] = {"rtol": 1e-11, "atol": 1e-13, "method": "DOP853"}
    accuracy["max_step"] = period * min(1 / 300, belt.alpha / 20)
    run = solve_ivp(slip, (0, 1.1 * period), start, events=back, **accuracy)
    orbit = ns.exact(belt)
    assert orbit.t1 == pytest.approx(stick, rel=1e-12)
    duration = run.t_events[0][0] + h
    assert orbit.period - orbit.t1 == pytest.approx(duration, rel=1e-6)
    # Slip ends where stick began: the orbit closes.
    size = abs(static / K) + V * math.sqrt(M / K)
    assert run.y_events[0][0][0] == pytest.approx(float(orbit.displacement(0)), abs=1e-6 * size)


@given(belts(), st.floats(0.01, 0.99))
def test_exact_orbit_satisfies_1_in_both_phases(belt: ns.StickSlip, part: float) -> None:
    orbit = ns.exact(belt)
    stick = part * orbit.t1
    slip = orbit.t1 + part * (orbit.period - orbit.t1)
    assert orbit.velocity(stick) == pytest.approx(belt.belt_speed)
    force = belt.stiffness * float(orbit.displacement(stick))
    assert abs(force) <= belt.mu_s * belt.normal_force * (1 + 1e-12)
    assert float(orbit.velocity(slip)) <= belt.belt_speed * (1 + 1e-9)
    x, acceleration = float(orbit.displacement(slip)), float(orbit.acceleration(slip))
    left = belt.mass * acceleration + belt.stiffness * x
    size = belt.mass * abs(acceleration) + belt.stiffness * abs(x) + belt.normal_force
    assert left == pytest.approx(belt.mu_k * belt.normal_force, abs=1e-12 * size)


def test_sympy_agrees_that_the_closed_form_is_an_orbit() -> None:
    orbit = oscillator.exact_orbit()
    stick, slip = oscillator.STICK, oscillator.SLIP
    t, t1 = oscillator.t, oscillator.t1
    assert stick.residual(orbit.stick) == 0
    assert sp.simplify(slip.residual(orbit.slip)) == 0
    for order in (0, 1):
        begin, end = (
            orbit.stick.diff(t, order).subs(t, 0),
            orbit.slip.diff(t, order).subs(t, oscillator.T),
        )
        join = (orbit.stick - orbit.slip).diff(t, order).subs(t, t1).subs(t1, orbit.t1)
        assert sp.simplify(join) == 0
        closed = (end - begin).subs(t1, orbit.t1).subs(oscillator.T, orbit.T)
        numbers = {
            oscillator.omega_n: 3,
            oscillator.V: sp.Rational(1, 2),
            oscillator.x_s: sp.Rational(7, 10),
            oscillator.x_0: sp.Rational(-2, 10),
        }
        assert abs(sp.N(closed.subs(numbers), 30)) < 1e-25
    limit = orbit.stick.subs(t, orbit.t1) - oscillator.TRANSITION
    assert sp.simplify(limit.subs(dict(oscillator.PARAMETERS))) == 0
