"""Several C1 functions where stick is so short that rounding hides what they add."""

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.solver.shortcuts.orbit.methods import METHODS
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT, StickSlip
from nonsmooth.solver.shortcuts.search import kernels
from nonsmooth.solver.shortcuts.search.newton import ROUNDOFF, Outcome
from nonsmooth.solver.shortcuts.search.rounding import (
    first_within_rounding,
    padded,
    residual_within_rounding,
)
from nonsmooth.solver.shortcuts.search.search import Search
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
    ],
)
def test_an_orbit_is_found_and_as_good_as_with_three(
    alpha: float, order: int, terms: int
) -> None:
    belt = with_alpha(alpha)
    orbit = ns.solve(belt, "hb-c1", order, c1_terms=terms)
    three = ns.solve(belt, "hb-c1", order, c1_terms=3)
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
