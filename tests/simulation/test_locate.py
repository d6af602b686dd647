"""The first event of a phase: none is stepped over, and each is found to the last digit."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from nonsmooth.solver.flow import flow
from nonsmooth.solver.simulation.steps.bounds import (
    TERMS,
    Equation,
    bound,
    length,
    local,
    taylor,
    window,
)
from nonsmooth.solver.simulation.steps.locate import CUT, EVENT, first_event, sign_after
from nonsmooth.solver.simulation.steps.zeros import first_zero


def phase(m=1.0, c=0.1, k=1.0, f=0.0, g=1.0, held=False, speed=0.0, omega=0.0):
    return Equation(m, c, k, f, g, held, speed, omega)


def first_of(followed, start, angle, forms, most):
    """Return where the first of some forms vanishes, none of which is known to be zero."""
    x, v = start
    return first_event(followed, x, v, angle, False, forms, [False] * len(forms), most)


#: m, c, k, f, g, omega: every sign of damping and stiffness.
PHASES = {
    "damped": (1.0, 0.1, 1.0, 0.3, 1.0, 1.8),
    "overdamped": (1.0, 5.0, 1.0, 0.3, 1.0, 1.8),
    "resonance": (1.0, 0.0, 1.0, 0.0, 1.0, 1.0),
    "no stiffness": (2.0, 0.1, 0.0, 0.3, 1.0, 0.7),
    "falling": (1.0, 0.0, 0.0, -1.0, 0.0, 0.0),
    "fed by friction": (1.0, -0.4, 1.0, 1.6, 0.0, 0.0),
    "unstable": (1.0, 0.1, -0.5, 0.3, 1.0, 1.8),
    "stiff": (1.0, 0.2, 1e6, 2.0, 1.0, 1.3),
}


@given(
    name=st.sampled_from(sorted(PHASES)),
    x=st.floats(-3, 3), v=st.floats(-3, 3), angle=st.floats(0, 6.3),
    form=st.tuples(*[st.floats(-2, 2)] * 4), part=st.floats(0.01, 1),
)  # fmt: skip
@settings(max_examples=120)
def test_a_form_stays_within_its_bound(name, x, v, angle, form, part) -> None:
    *numbers, omega = PHASES[name]
    followed = phase(*numbers, omega=omega)
    at = local(followed, x, v, angle, False)
    longest = min(window(followed, omega), 4.0) * part
    rest = bound(at, form, longest)
    s = np.linspace(0, longest, 23)
    ex, ev, ec, constant = form
    states = [flow.motion(followed, np.array([x, v]), angle, omega, s, j) for j in (0, 1)]
    exact = ex * states[0] + ev * states[1] + ec * np.cos(omega * s + angle) + constant
    values, sizes = taylor(at, form)
    powers = [value * s**j / math.factorial(j) for j, value in enumerate(values)]
    off = np.abs(exact - np.sum(powers, axis=0))
    rounding = 1e-13 * sum(size * s**j for j, size in enumerate(sizes))
    assert (off <= rest * s**TERMS / math.factorial(TERMS) + rounding + 1e-12).all()


@given(st.lists(st.floats(-1, 1), min_size=1, max_size=6), st.floats(1e-3, 1))
@settings(max_examples=200)
def test_the_first_zero_of_a_polynomial(rest, first) -> None:
    powers = np.array([first, *rest, *[0.0] * (6 - len(rest))])
    found = first_zero(tuple(powers.tolist()))
    samples = np.linspace(0, 1, 2001)
    values = np.polynomial.Polynomial(powers)(samples)
    below = np.nonzero(values < -1e-12)[0]
    if found == math.inf:
        assert not len(below)
        return
    assert (values[samples < found] > -1e-12).all()
    assert np.polynomial.Polynomial(powers)(found) == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("depth", [1e-3, 1e-6, 1e-9, 1e-12])
def test_a_contact_that_an_integrator_steps_over(depth) -> None:
    """Steady motion whose crests pass the limit by a part of 1e-3 to 1e-12."""
    omega = 1.8
    amplitude = 1 / (omega**2 - 1)  # without damping x = -amplitude cos(omega t)
    limit = amplitude * (1 - depth)
    event = (-1.0, 0.0, 0.0, limit)
    start = (-amplitude, 0.0)
    found = first_of(phase(c=0.0, omega=omega), start, 0.0, [event], 100.0)
    expected = (math.pi - math.acos(1 - depth)) / omega  # of the first crest
    assert (found.how, found.form) == (EVENT, 0)
    # the crest is flat: what rounding of the limit makes of the time
    assert found.s == pytest.approx(expected, abs=3e-16 / math.sqrt(depth) + 1e-15)
    if depth > 1e-6:
        return

    def zero(t, y):
        return limit - y[0]

    zero.terminal = True
    solved = solve_ivp(
        lambda t, y: [y[1], math.cos(omega * t) - y[0]], (0, 7.0), start, events=zero, rtol=1e-8
    )
    assert solved.status == 0  # it found nothing, over two crests that pass the limit


@pytest.mark.parametrize("gap", [1e-9, 1e-13])
def test_what_only_comes_near_is_no_event(gap) -> None:
    omega = 1.8
    amplitude = 1 / (omega**2 - 1)
    event = (-1.0, 0.0, 0.0, amplitude * (1 + gap))
    found = first_of(phase(c=0.0, omega=omega), (-amplitude, 0.0), 0.0, [event], 1000.0)
    assert found.how == CUT
    assert found.s == 1000.0


def test_of_two_events_the_first_is_taken() -> None:
    # falls from rest: x = -t**2/2, v = -t
    falling = phase(c=0.0, k=0.0, f=-1.0, g=0.0)
    forms = [(1.0, 0.0, 0.0, 2.0), (0.0, 1.0, 0.0, 1.5)]
    found = first_of(falling, (0.0, 0.0), 0.0, forms, 10.0)
    assert (found.form, found.s) == (1, pytest.approx(1.5, rel=1e-15))
    assert (found.x, found.v) == (pytest.approx(-1.125), pytest.approx(-1.5))
    later = first_of(falling, (0.0, 0.0), 0.0, forms[:1], 10.0)
    assert (later.form, later.s) == (0, pytest.approx(2.0, rel=1e-15))
    assert first_of(falling, (0.0, 0.0), 0.0, forms[:1], 1.0).how == CUT


def test_a_form_that_begins_at_zero_is_not_its_own_event() -> None:
    # thrown up from the limit: back at it after 2 v
    falling = phase(c=0.0, k=0.0, f=-1.0, g=0.0)
    for speed in (1.0, 1e-6, 1e-12):
        found = first_of(falling, (0.3, speed), 0.0, [(1.0, 0.0, 0.0, -0.3)], 10.0)
        # x - 0.3 is known to 4e-17, which is what a speed of 1e-6 travels in 4e-11
        assert found.s == pytest.approx(2 * speed, rel=1e-3)
    # a form that begins with two zeros: at rest, and without acceleration
    slow = phase(c=0.0, k=0.0, f=0.0, g=1.0, omega=1.0)
    angle = -math.pi / 2  # a = sin(s), so v = 1 - cos(s)
    found = first_of(slow, (0.0, 0.0), angle, [(0.0, 1.0, 0.0, 0.0)], 10.0)
    assert found.s == pytest.approx(2 * math.pi, abs=1e-6)  # it touches zero there


@pytest.mark.parametrize("factor", [1.0, 0.3, 0.4, 1e-9, 7.7])
def test_a_form_that_only_touches_zero_goes_on(factor) -> None:
    still, start, crests = phase(held=True, omega=1.0), (0.0, 0.0), 200
    form = (0.0, 0.0, factor, factor)  # 1 + cos s is zero at pi, and a turn on
    found = first_of(still, start, 0.0, [form], 2 * math.pi * crests)
    assert found.how == CUT
    for depth in (1e-13, 1e-10):  # that is more than rounding
        lower = (0.0, 0.0, factor, factor * (1 - depth))
        found = first_of(still, start, 0.0, [lower], 10.0)
        expected = math.pi - math.acos(1 - depth)
        assert found.how == EVENT
        assert found.s == pytest.approx(expected, abs=3e-16 / math.sqrt(depth) + 1e-9)


def test_the_sign_just_after_a_state() -> None:
    at = local(phase(c=0.0, k=0.0, f=-1.0, g=0.0), 0.0, 0.0, 0.0, False)
    assert sign_after(at, (1.0, 0.0, 0.0, 0.0), False) == -1  # by the second derivative
    assert sign_after(at, (-1.0, 0.0, 0.0, 0.0), False) == 1
    assert sign_after(at, (0.0, 1.0, 0.0, 1e-3), False) == 1
    assert sign_after(at, (0.0, -1.0, 0.0, -1e-3), True) == 1  # it rises from what is zero
    still = local(phase(held=True, speed=2.0), 0.0, 2.0, 0.0, False)
    assert sign_after(still, (0.0, -1.0, 0.0, 2.0), False) == 0  # and so it stays


@pytest.mark.parametrize("sides", [(3.0, 4.0), (0.0, -2.0), (1e-200, 1e-200), (3e300, -4e300)])
def test_the_root_of_a_sum_of_squares(sides) -> None:
    assert length(*sides) == pytest.approx(math.hypot(*sides), rel=1e-15)
    assert length(math.inf, 1.0) == math.inf
