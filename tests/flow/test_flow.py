"""The flow of a linear phase against matrix exponentials of 60 digits."""

import math

import mpmath as mp
import numpy as np
import pytest

from nonsmooth.solver.flow import exact_system, flow, responses
from nonsmooth.solver.flow.divided import expm1, of_three, of_three_at, of_two, of_two_at
from nonsmooth.solver.flow.responses import by_change
from nonsmooth.solver.scenes.cell import Cell, Phase

START, ANGLE = (0.7, -0.4), 0.9

#: m, c, k, f, g, Omega, duration.
PHASES = {
    "underdamped": (1.0, 0.1, 1.0, 0.3, 1.0, 1.8, 3.5),
    "overdamped": (1.0, 5.0, 1.0, 0.3, 1.0, 1.8, 3.5),
    "very overdamped": (1.0, 1e6, 1.0, 0.3, 1.0, 1.8, 3.5),
    "critically damped": (1.0, 2.0, 1.0, 0.3, 1.0, 1.8, 3.5),
    "nearly critical": (1.0, 2.0 + 1e-9, 1.0, 0.3, 1.0, 1.8, 3.5),
    "no stiffness": (2.0, 0.1, 0.0, 0.3, 1.0, 1.8, 3.5),
    "free": (1.0, 0.0, 0.0, 0.3, 1.0, 1.8, 3.5),
    "nearly free": (1.0, 1e-9, 1e-12, 0.3, 1.0, 1.8, 3.5),
    "weakening": (1.0, -0.4, 1.0, 1.6, 0.0, 0.0, 5.0),
    "unstable": (1.0, 0.1, -0.5, 0.3, 1.0, 1.8, 3.5),
    "resonance": (1.0, 0.0, 1.0, 0.3, 1.0, 1.0, 6.5),
    "near resonance": (1.0, 1e-9, 1.0, 0.3, 1.0, 1.0 + 1e-7, 6.5),
    "stiff": (1.0, 0.2, 1e6, 2.0, 1.0, 1.3, math.pi / 1e3),
    "slow forcing": (1.0, 0.2, 1.0, 0.0, 1.0, 1e-6, 3.0),
    "short": (1.0, 0.2, 1.0, 0.4, 1.0, 1.3, 1e-9),
}


def phase_of(m, c, k, f, g):
    event = (1.0, 0.0, 0.0, 0.0)
    return Phase("p", m, c, k, f, g, False, 0.0, event, 1.0, 0.0, ())


def reference(numbers, start, angle, duration):
    """Return displacement and velocity with 60 digits, from exp of the 5 x 5 matrix."""
    m, c, k, f, g, omega, _ = map(mp.mpf, numbers)
    A = mp.matrix(5)
    A[0, 1] = 1
    A[1, 0], A[1, 1], A[1, 2], A[1, 3] = -k / m, -c / m, f / m, g / m
    A[3, 4], A[4, 3] = -omega, omega
    y = mp.matrix([*start, 1, mp.cos(angle), mp.sin(angle)])
    return mp.expm(A * duration) * y


def ended(phase, omega, s):
    """Return what the exact equations have of the end of a phase: what it gains, derivatives.

    By the duration, by the angle of the forcing, by the force, by the start.
    """
    cell = Cell((phase,), omega or None, 1, 1, ())
    case, z = exact_system.arrays(cell), np.array([*START, s, ANGLE][: 4 if omega else 3])
    theta = exact_system.angles(case, z, exact_system.places(case))
    gained, by = exact_system.ends(case, z, theta)
    return gained[0], by[0, :, 0], by[0, :, 1], by[0, :, 3:] + np.eye(2)


@pytest.mark.parametrize("name", PHASES)
def test_motion_and_derivatives(name) -> None:
    numbers = PHASES[name]
    phase, omega, s = phase_of(*numbers[:5]), numbers[5], numbers[6]
    with mp.workdps(60):
        x, v, *_ = reference(numbers, START, ANGLE, mp.mpf(s))
        small = mp.mpf(10) ** -25
        after = reference(numbers, START, ANGLE, s + small)
        turned = reference(numbers, START, ANGLE + small, mp.mpf(s))
        columns = [
            reference(numbers, (START[0] + small * i, START[1] + small * j), ANGLE, mp.mpf(s))
            for i, j in ((1, 0), (0, 1))
        ]
        state = np.array([float(x), float(v)])
        by_duration = np.array([float((after[i] - (x, v)[i]) / small) for i in (0, 1)])
        by_angle = np.array([float((turned[i] - (x, v)[i]) / small) for i in (0, 1)])
        by_start = np.array(
            [[float((y[i] - (x, v)[i]) / small) for y in columns] for i in (0, 1)]
        )
    gained, *derivatives = ended(phase, omega, s)
    found = responses.state_at(phase, *START, ANGLE, omega, s)
    # velocities are of the size of the fastest rate, which multiplies their rounding errors
    rate = max(1.0, math.sqrt(abs(numbers[2] / numbers[0])))
    size = np.abs(state).max()
    np.testing.assert_allclose(found[0], state[0], rtol=0, atol=1e-14 * size)
    np.testing.assert_allclose(found[1], state[1], rtol=0, atol=1e-14 * rate * size)
    np.testing.assert_allclose(gained, state - START, rtol=0, atol=1e-14 * rate * max(size, 1))
    for ours, theirs in zip(derivatives, (by_duration, by_angle, by_start), strict=True):
        size = max(np.abs(theirs).max(), 1.0)
        np.testing.assert_allclose(ours, theirs, rtol=0, atol=2e-14 * rate * size)


@pytest.mark.parametrize("name", PHASES)
def test_motion_satisfies_its_equation_in_between(name) -> None:
    m, c, k, f, g, omega, s = PHASES[name]
    phase = phase_of(m, c, k, f, g)
    t = np.linspace(0.0, s, 7)
    x, v, a = (flow.motion(phase, np.array(START), ANGLE, omega, t, j) for j in (0, 1, 2))
    assert (x[0], v[0]) == START
    residual = m * a + c * v + k * x - f - g * np.cos(omega * t + ANGLE)
    size = max(m * np.abs(a).max(), abs(c) * np.abs(v).max(), abs(k) * np.abs(x).max(), 1)
    np.testing.assert_allclose(residual, 0, atol=1e-14 * size)
    end = responses.state_at(phase, *START, ANGLE, omega, s)
    np.testing.assert_allclose([x[-1], v[-1]], end, rtol=1e-14)


def test_a_held_phase_keeps_its_speed() -> None:
    phase = Phase("p", 1, 0, 0, 0, 0, True, 1.5, (1, 0, 0, 0), 1, 0, ())
    assert responses.state_at(phase, 0.5, 99.0, 0.0, 0.0, 2.0) == (3.5, 1.5)
    t = np.array([0.0, 2.0])
    assert flow.motion(phase, np.array([0.5, 9.0]), 0, 0, t, 0).tolist() == [0.5, 3.5]
    assert flow.motion(phase, np.array([0.5, 9.0]), 0, 0, t, 2).tolist() == [0, 0]


@pytest.mark.parametrize("gap", [0.0, 1e-12, 1e-6, 1e-3, 0.3, 0.99, 1.01, 3.0, 30.0])
def test_divided_differences_of_near_and_far_nodes(gap) -> None:
    t = np.array([1.0])
    a, b, c = -0.3 + 1j, -0.3 + 1j + gap * 1j, -0.3 + 1j - 0.7 * gap
    with mp.workdps(80):
        nodes = [mp.mpc(z) + j * mp.mpf(10) ** -25 for j, z in enumerate((a, b, c))]
        values = [mp.exp(z) for z in nodes]
        ab, bc = ((values[i] - values[i + 1]) / (nodes[i] - nodes[i + 1]) for i in (0, 1))
        two, three = complex(ab), complex((ab - bc) / (nodes[0] - nodes[2]))
    for found in (of_two(a, b, 1.0), of_two_at(a, b, t)[0]):
        assert found == pytest.approx(two, rel=4e-15)
    for nodes in ((a, b, c), (c, a, b)):
        for found in (of_three(*nodes, 1.0), of_three_at(*nodes, t)[0]):
            assert found == pytest.approx(three, rel=2e-14)


@pytest.mark.parametrize("s", [1e-9, -1e-3, 0.05, 0.7, 4.0])
def test_what_the_change_of_a_force_moves_keeps_its_digits(s: float) -> None:
    """Where it is as small as the third power of the time."""
    m, c, k, omega, angle = 1.3, 0.4, 0.9, 1.1, 0.8
    found = by_change(m, c, k, omega, angle, s)
    with mp.workdps(30):
        one, two = mp.polyroots([m, c, k])

        def pushed(t):
            answer = (mp.exp(one * (s - t)) - mp.exp(two * (s - t))) / (one - two) / m
            return answer * (mp.cos(omega * t + angle) - mp.cos(angle))

        expected = float(mp.re(mp.quad(pushed, [0, s])))
    assert found == pytest.approx(expected, rel=1e-14, abs=0)


def test_what_is_beyond_float64_is_infinite_or_no_number() -> None:
    """A trial of Newton's method may have any duration."""
    phase = Phase("p", 1, -1.0, 1, 0.5, 0.2, False, 0, (1, 0, 0, 0), 1, 0, ())
    for duration in (1e4, 1e5, 1e300):
        assert not np.isfinite(responses.state_at(phase, 0.5, 9.0, 0.3, 1.7, duration)).all()
        assert not np.isfinite(ended(phase, 1.7, duration)[0]).all()
    assert expm1(complex(1e-9, 1e-9)) == pytest.approx(complex(1e-9, 1e-9), rel=1e-8)
    assert expm1(complex(0.0, 3e-8)).real == pytest.approx(-4.5e-16, rel=1e-12)
