"""Several C1 functions where stick is so short that rounding hides what they add."""

from dataclasses import replace

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.solver.shortcuts.orbit.methods import METHODS, with_terms
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT, StickSlip
from nonsmooth.solver.shortcuts.search import kernels
from nonsmooth.solver.shortcuts.search.newton import ROUNDOFF, Outcome
from nonsmooth.solver.shortcuts.search.rounding import (
    first_within_rounding,
    least_norm_step,
    padded,
    residual_within_rounding,
    solve_by_least_norm,
)
from nonsmooth.solver.shortcuts.search.search import Search, _from_fewer_functions
from nonsmooth.solver.shortcuts.search.start import rough_times


def with_alpha(alpha: float) -> StickSlip:
    return StickSlip(**vars(DEFAULT) | {"normal_force": 400 * alpha})


@pytest.mark.parametrize(
    ("alpha", "order", "terms"),
    [
        *((1.3348776e-5, 13, K) for K in (5, 6)),
        (3.7583564e-5, 3, 6),
        (6.1960683e-6, 64, 6),  # from where Newton's method left off
        *((10.0**-e, N, K) for e in (4, 5, 6) for N in (4, 9) for K in (4, 6)),
        # By steps of least norm: with fewer functions the equations do not hold.
        *((1e-4, 50, K) for K in (5, 6)),
        (1e-5, 49, 6),
        (6.556638222367456e-4, 21, 6),
        (1.11901504e-4, 50, 3),
    ],
)
def test_an_orbit_is_found_and_as_good_as_with_three(
    alpha: float, order: int, terms: int
) -> None:
    belt = with_alpha(alpha)
    orbit = ns.solve(belt, "hb-c1", order, c1_terms=terms)
    three = ns.solve(belt, "hb-c1", order, c1_terms=min(3, terms - 1))
    assert orbit.converged
    assert orbit.admissible
    assert orbit.c1_terms == terms
    # Twelve digits of the period are promised of hb-c1 at these alphas.
    assert abs(orbit.errors.period) <= abs(three.errors.period) + 1e-12
    aligned = three.errors.acceleration_aligned
    assert orbit.errors.acceleration_aligned <= 1.01 * aligned + 1e-12


def test_what_is_off_by_more_than_rounding_is_not_taken() -> None:
    alpha, order, case = 0.3, 3, (0.3, 1)
    kernel = kernels.plain("hb-symmetric")
    search = Search(with_alpha(alpha), METHODS["hb-c1"], order, kernels.plain)
    z = search.about_mid_stick(kernel, alpha, 1, order, rough_times(alpha)).unknowns
    size = kernel.size(order, 1)
    good = Outcome(z, False, 1, ROUNDOFF, 1.0, "")
    assert first_within_rounding(kernel, case, size, [good]).converged
    unsettled = Outcome(z, False, 1, 2 * ROUNDOFF, 1.0, "")
    assert first_within_rounding(kernel, case, size, [unsettled]) is None
    for index in (0, -2, -1):  # a coefficient, t1, T
        wrong = z.copy()
        wrong[index] += 1600 * np.finfo(float).eps * z[-1]
        assert not residual_within_rounding(kernel, case, wrong)[1]
        bad = Outcome(wrong, False, 1, 0.0, 1.0, "")
        assert first_within_rounding(kernel, case, size, [bad]) is None
        assert first_within_rounding(kernel, case, size, [bad, good]).unknowns[0] == z[0]


def test_what_has_fewer_functions_is_padded_before_the_times() -> None:
    assert padded(np.array([1.0, 2.0, 0.1, 6.0]), 6).tolist() == [1.0, 2.0, 0.0, 0.0, 0.1, 6.0]


#: Orbits that only steps of least norm reach, with ``t1`` and ``T`` from the same equations in
#: 60 digits: Newton's method by mpmath over the text of the generated kernel, from what float64
#: returns, down to a step of 1e-40.
IN_60_DIGITS = [
    (1e-4, 50, 5, 0.00020000000000000000991, 6.2831853071802531436),
    (1e-4, 50, 6, 0.00020000000000000000964, 6.2831853071802531436),
    (0.0006556638222367456, 21, 6, 0.0013113276444734912155, 6.2831853073674975153),
    (1.650883521796629e-05, 32, 6, 0.000033017670435932579308, 6.2831853071795894765),
]


@pytest.mark.parametrize(("alpha", "order", "terms", "t1", "T"), IN_60_DIGITS)
def test_orbits_by_steps_of_least_norm_are_those_of_many_digits(
    alpha: float, order: int, terms: int, t1: float, T: float
) -> None:
    orbit = ns.solve(with_alpha(alpha), "hb-c1", order, c1_terms=terms)
    # Rounding of equations whose condition is 1e12 and more; 3.6e-15 at most was measured.
    assert orbit.unknowns[-2:] == pytest.approx([t1, T], rel=0, abs=1e-14 * T)
    assert abs(orbit.errors.period) <= orbit.estimate.period
    assert orbit.errors.acceleration <= orbit.estimate.acceleration


@pytest.mark.long
@pytest.mark.parametrize(
    ("lowest", "highest", "terms", "orders", "cases"),
    [(-6.0, -3.0, 1, 60, 20_000), (-3.0, 3.0, 2, 64, 10_000)],
)
def test_every_random_case_has_its_orbit(
    lowest: float, highest: float, terms: int, orders: int, cases: int
) -> None:
    random = np.random.default_rng(2)
    for _ in range(cases):
        belt = with_alpha(float(10 ** random.uniform(lowest, highest)))
        order, number = int(random.integers(1, orders + 1)), int(random.integers(terms, 7))
        ns.solve(belt, "hb-c1", order, c1_terms=number, many=True)


def test_a_step_of_least_norm_solves_what_is_regular_and_leaves_what_rounding_hides() -> None:
    regular = np.array([[2.0, 1.0], [1e-9, 3e-9]])  # rows of different size
    step = least_norm_step(-regular @ [1.0, -2.0], regular)
    assert step == pytest.approx([1.0, -2.0], rel=1e-14)
    # The second unknown is felt by less than rounding: the whole step is the first's.
    hidden = np.array([[1.0, 1.0, 0.0], [1.0, 1.0 + 1e-15, 0.0], [0.0, 0.0, 1e6]])
    step = least_norm_step(-hidden @ [1.0, 1.0, 5.0] - [0.0, 2e-15, 0.0], hidden)
    assert step == pytest.approx([1.0, 1.0, 5.0], rel=1e-13)


def made(residual, jacobian) -> kernels.Kernel:
    """Return a kernel of two coefficients and two times."""

    def fill_residual(case: object, z: np.ndarray, R: np.ndarray) -> None:
        R[:] = residual(z)

    def fill_jacobian(case: object, z: np.ndarray, J: np.ndarray) -> None:
        J[:] = jacobian(z)

    return replace(
        kernels.plain("hb-symmetric"), residual=fill_residual, jacobian=fill_jacobian
    )


@pytest.mark.parametrize(("alpha", "order"), [(1.3348776e-5, 13), (6.1960683e-6, 64)])
def test_added_one_by_one_what_rounding_hides_stays_zero(alpha: float, order: int) -> None:
    method = with_terms(METHODS["hb-c1"], 6)
    search = Search(with_alpha(alpha), method, order, kernels.compiled)
    found = _from_fewer_functions(search)
    assert found.converged
    assert (found.unknowns[-8:-2] == 0).tolist() == [False] * 4 + [True] * 2


START = np.array([1.0, 1.0, 1.0, 3.0])


@pytest.mark.parametrize(
    ("residual", "jacobian", "reason"),
    [
        (lambda z: z - [2, 2, 1.5, 3.5], lambda z: np.eye(4), "converged"),
        (lambda z: z - START, lambda z: np.eye(4), "converged"),
        (lambda z: z - [2, 2, -1, 3], lambda z: np.eye(4), "t1 ran out of (0, T)"),
        (lambda z: z - [2, 2, 4, 3], lambda z: np.eye(4), "t1 ran out of (0, T)"),
        (lambda z: z * np.nan, lambda z: np.eye(4), "the equations overflow"),
        (lambda z: z, lambda z: np.eye(4) * np.inf, "the equations overflow"),
        (lambda z: z, lambda z: np.diag([1.0, 0.0, 1.0, 1.0]), "the Jacobian is singular"),
        # x**2 + 1 has no zero, and the times are at rest at once.
        (
            lambda z: [z[0] ** 2 + 1, z[1], z[2] - 1, z[3] - 3],
            lambda z: np.diag([2 * z[0] + 1e-3, 1, 1, 1]),
            "no convergence within the limit of iterations",
        ),
    ],
)
def test_steps_of_least_norm_say_how_they_ended(residual, jacobian, reason: str) -> None:
    found = solve_by_least_norm(made(residual, jacobian), None, START)
    assert (found.reason, found.converged) == (reason, reason == "converged")
    assert not found.converged or found.correction <= ROUNDOFF
    assert 0 < found.unknowns[-2] < found.unknowns[-1]
    assert START.tolist() == [1.0, 1.0, 1.0, 3.0]
