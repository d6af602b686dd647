"""Harmonics of contact forces: their rates, compliances, answers to breaks, derivatives."""

import mpmath as mp
import numpy as np
import pytest
from bodies.reference_bodies import Reference, body, case, of
from bodies.test_reference_bodies import error, start
from galerkin.solving import OF_TWO, differences

from nonsmooth.solver.bodies import motion
from nonsmooth.solver.bodies.force_series.layout import layout
from nonsmooth.solver.bodies.harmonics import system
from nonsmooth.solver.bodies.harmonics.breaks import Break, answers_to
from nonsmooth.solver.bodies.harmonics.frame import Frame, compliance
from nonsmooth.solver.bodies.laws import places
from nonsmooth.solver.bodies.poles import Poles
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.orbit.solution import attempt

#: Errors of times at the orders of `ORDERS`, by method and K: those that were measured, with a
#: margin of a half; the first of the harmonics alone fall as N^-3, beside functions faster.
ORDERS = (5, 9, 17, 33)
MEASURED = {
    ("clearance-2", 0): (9e-3, 6e-4, 1e-4, 1.5e-5),
    ("clearance-2", 1): (3e-3, 5e-5, 3e-6, 1.2e-7),
    ("clearance-2", 3): (1e-3, 4e-6, 6e-8, 1.1e-9),
    ("beam-10-spring", 0): (3e-3, 1.1e-3, 1.6e-4, 5e-5),
    ("beam-10-spring", 1): (1.2e-4, 1.8e-4, 3e-6, 1.6e-7),
    ("jenkins-absorber", 1): (3e-5, 6e-6, 3e-7, 1.4e-8),
    ("absorber-stick", 1): (3e-4, 1.6e-4, 3e-5, 8e-7),
    ("belt-2", 2): (3e-4, 3e-5, 6e-6, 9e-7),
    ("two-stops-four-phases", 1): (1.5e-2, 1.6e-3, 1.5e-5, 1.6e-6),
}


def error_of(r: Reference, order: int, functions: int) -> float:
    """Return the error of the times of an orbit by harmonics, near a reference."""
    own, name = case(r.name), "hb-ck" if functions else "hb"
    kernel = registry.kernel(own.scene, name, functions or None)
    found = attempt(kernel, own, order, start(r), functions or None)
    assert found.converged
    return error(r, found)


@pytest.mark.parametrize(("name", "functions"), MEASURED, ids=str)
def test_errors_fall_as_they_were_measured(name: str, functions: int) -> None:
    for order, most in zip(ORDERS, MEASURED[name, functions], strict=True):
        assert error_of(of(name), order, functions) <= most


def test_rate_of_harmonics_alone() -> None:
    errors = [error_of(of("clearance-2"), order, 0) for order in (16, 64)]
    assert np.log(errors[0] / errors[1]) / np.log(4) == pytest.approx(3, abs=0.5)


#: Where forces are given, or constant between their breaks, there is nothing to expand.
GIVEN = (
    *(("impact-2", 0), ("impact-3-two-impacts", 0), ("impact-3-not-proportional", 2)),
    *(("absorber-slip", 1), ("beam-10-impact", 0)),
)


@pytest.mark.parametrize(("name", "functions"), GIVEN, ids=str)
def test_impulses_and_given_forces_are_exact_at_any_order(name: str, functions: int) -> None:
    for order in (1, 4):
        assert error_of(of(name), order, functions) <= 1e-13


#: Of each kind of law; with a period that is unknown, with several contacts.
KINDS = (
    *("clearance-2", "jenkins-absorber", "belt-2", "impact-3-two-impacts", "absorber-stick"),
    *("two-stops-six-phases", "impact-3-not-proportional"),
)


@pytest.mark.parametrize("functions", [0, 1, 2])
@pytest.mark.parametrize("name", KINDS)
def test_jacobian_against_differences(name: str, functions: int) -> None:
    cell, times = case(name).cell, start(of(name), 1e-2)
    rows = differences(
        lambda z: system.evaluated(cell, 6, functions, z).residual, times, 1e-5, OF_TWO
    )
    found = system.evaluated(cell, 6, functions, times).jacobian
    assert found == pytest.approx(np.array(rows).T, abs=1e-6 * np.abs(found).max())


@pytest.mark.parametrize("name", ["clearance-2", "impact-3-not-proportional", "beam-4-spring"])
def test_compliance_is_that_of_the_matrices(name: str) -> None:
    own, matrices = case(name), body(of(name)).arrays
    cell, times = own.cell, start(of(name), 0.0)
    frame = Frame(cell, 5, 0, times, cell.duration)
    x = places(1)[0]
    seen = layout(cell, 1).poles.forms(np.eye(6)[x])
    found = compliance(frame, seen)[:, 0, 0] * own.units.time**2 / own.units.mass
    M, C, K, w = (matrices[q].dense() for q in ("M", "C", "K", "at"))
    for value, turn in zip(found, frame.turns, strict=True):
        omega = turn / (cell.duration * own.units.time)
        exact = (w.T @ np.linalg.solve(K - omega**2 * M + 1j * omega * C, w))[0, 0]
        assert value == pytest.approx(exact, rel=1e-9)


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("kappa", [-0.02 + 0.1j, -0.3 + 5j, -40 + 3j], ids=str)
def test_answers_to_breaks_by_their_harmonics(kappa: complex, sign: int) -> None:
    """``beta_n`` has the harmonics ``(i turn)^-n``, and a pole answers each by itself."""
    one = np.ones((1, 1), dtype=complex)
    poles = Poles(np.array([kappa / 2]), one, one, np.zeros(1, dtype=complex), 1.0)
    ends, place = np.array([0.0, 0.4, 1.0]), 1
    breaks = tuple(Break(place, n, 0) for n in (2, 4))
    found = answers_to(poles, breaks, 2.0, ends, sign)
    with mp.workdps(20):
        for q, answer in enumerate(found):
            for i, (_, n, _) in enumerate(breaks):
                u = 0.7 * answer.length
                exact = mp.nsum(
                    lambda h, n=n, t=u + ends[q] - ends[place]: sum(
                        mp.exp(1j * turn * t) / ((1j * turn) ** n * (1j * turn - mp.mpc(kappa)))
                        for turn in _pair(h, sign)
                    ),
                    [1 if sign > 0 else 0, mp.inf],
                )
                here = answer.at(np.array([u]))[i, 0, 0]
                assert here == pytest.approx(complex(2 * exact), abs=1e-10)
                begin = answer.at(np.array([0.0, 1e-4]))[i, 0]
                assert answer.slopes(0)[0, i] == pytest.approx(
                    complex(begin[1] - begin[0]) / 1e-4, abs=0.02
                )


def _pair(h: mp.mpf, sign: int) -> tuple[mp.mpf, mp.mpf]:
    """Return the turns of a harmonic and of that below 0."""
    turn = 2 * mp.pi * h if sign > 0 else mp.pi * (2 * h + 1)
    return turn, -turn


@pytest.mark.parametrize("name", ["clearance-2", "absorber-stick", "belt-2"])
def test_derivatives_come_near_the_exact_ones(name: str) -> None:
    """Displacement, velocity, acceleration and what follows them by the law of the force."""
    cell, times = case(name).cell, start(of(name), 0.0)
    u = np.linspace(0.1, 0.9, 5)
    for p in range(len(cell.phases)):
        for number, off in enumerate((2e-6, 2e-5, 2e-4, 5e-3)):
            exact = motion.derivative(motion.Given(cell, 0), times, p, u, number)
            found = motion.derivative(motion.Given(cell, 81, 1), times, p, u, number)
            assert found == pytest.approx(exact, abs=off * max(1.0, np.abs(exact).max()))
