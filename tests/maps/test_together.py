"""Phases solved for by themselves, and joined: against the whole system beside them."""

import numpy as np
import pytest
from galerkin.solving import jacobian, residual

from nonsmooth.generated import ck
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.kernels.compiling import rebuilt
from nonsmooth.solver.kernels.linking import phase_maps
from nonsmooth.solver.orbit.solution import attempt
from nonsmooth.solver.solve import solve_case

#: C1, not forced, with a held phase; C0; C2, two phases; C2 with memory, half a cell.
SCENES = ("stick-slip-damped", "impact", "clearance", "elastic-plastic")

METHODS = ("ck-tau", "ck")

MAPS = phase_maps(ck, rebuilt)


def begun(scene, method, order):
    """Return a kernel, where it works, and unknowns that solve nothing."""
    case = registry.load(scene)()
    kernel = registry.kernel(case.scene, method)
    given = kernel.given(case, order)
    at, rooms, marks = rooms_of(given, order)
    rng = np.random.default_rng(order)
    times = kernel.durations + kernel.forced
    y = rng.normal(size=at[-1] + len(given[2]) + times)
    y[-times:] = rng.uniform(0.5, 2.0, times)
    known, used = np.zeros(len(y), dtype=bool), np.zeros(len(y), dtype=bool)
    work = MAPS["workplace"](given, order, rooms, marks)
    place = (given, at, order, work, y.copy(), np.zeros((len(y), len(y))), known, used)
    return kernel, place, y


def rooms_of(given, order):
    """Return where the unknowns of each phase begin, and room for them."""
    kinds, (_, length, columns, _) = given[0], MAPS["extent"](given, order)
    rooms, marks = np.zeros((len(kinds), length, columns)), np.zeros((len(kinds), length), int)
    at = np.zeros(len(kinds) + 1, dtype=np.int64)
    MAPS["fill_places"](kinds, order, at)
    return at, rooms, marks


def joints_of(place, z):
    """Return the rows of the whole residual that join the phases: the last."""
    given, order = place[0], place[2]
    rows = sum(
        MAPS["tests"](given[0], p, order) + given[0][p, MAPS["BESIDE"]]
        for p in range(len(given[0]))
    )
    return np.arange(rows, len(z))


@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("order", [2, 3, 9])
def test_the_rows_of_the_phases_hold_and_the_rest_is_as_in_the_whole(scene, method, order):
    kernel, place, y = begun(scene, method, order)
    given, at, _, work = place[:4]
    R = np.empty(len(y))
    MAPS["together_residual"](place, y, R)
    z = np.empty(kernel.size(order))
    MAPS["unpack"](given, y, at, order, *work[:3], z)
    whole = residual(kernel, given, z)
    joints, scale = joints_of(place, z), np.abs(z).max()
    np.testing.assert_allclose(R, whole[joints], atol=1e-13 * scale)
    assert np.abs(R).max() > 1e-3
    assert np.abs(np.delete(whole, joints)).max() < 1e-13 * scale


@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("order", [2, 9])
def test_the_jacobian_is_what_elimination_leaves_of_the_whole_one(scene, method, order):
    """The Schur complement of the rows of the phases, by LAPACK."""
    kernel, place, y = begun(scene, method, order)
    given, at, _, work = place[:4]
    R, J = np.empty(len(y)), np.empty((len(y), len(y)))
    MAPS["together_residual"](place, y, R)
    MAPS["together_jacobian"](place, y, J)
    z = np.empty(kernel.size(order))
    MAPS["unpack"](given, y, at, order, *work[:3], z)
    whole = jacobian(kernel, given, z)
    joints = joints_of(place, z)
    kept = [int(np.flatnonzero(z == value)[0]) for value in y]
    inner, rows = np.setdiff1d(np.arange(len(z)), kept), np.setdiff1d(np.arange(len(z)), joints)
    through = np.linalg.solve(whole[np.ix_(rows, inner)], whole[np.ix_(rows, kept)])
    expected = whole[np.ix_(joints, kept)] - whole[np.ix_(joints, inner)] @ through
    np.testing.assert_allclose(J, expected, atol=1e-10 * np.abs(expected).max())


@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("method", METHODS)
def test_what_is_returned_solves_the_whole_system(scene, method):
    case = registry.load(scene)()
    kernel = registry.kernel(case.scene, method)
    found = attempt(kernel, case, 40, kernel.times(solve_case(case, method, 20).unknowns))
    R = residual(kernel, kernel.given(case, 40), found.unknowns)
    assert found.converged
    assert np.abs(R).max() == found.residual_norm < 1e-13


@pytest.mark.parametrize(
    ("scene", "known", "first"),
    [
        ("stick-slip", {"v_stick", "x_slip", "v_slip"}, 1),
        ("stick-slip-damped", {"v_stick", "x_slip", "v_slip"}, 1),
        ("impact", {"s_flight"}, -1),
        ("impact-inelastic", {"v_rest", "v_flight"}, -1),
        ("clearance", set(), -1),
    ],
)
def test_what_single_conditions_give_is_known_before(scene, known, first):
    """Slip begins where friction ends sticking, with the speed of the belt: it is alone."""
    kernel, place, y = begun(scene, "ck-tau", 5)
    given, at, whole, marks, used = place[0], place[1], *place[4:5], *place[6:]
    MAPS["given_alone"](given, whole, at, marks, used)
    phases = registry.load(scene).phases
    names = [
        f"{what}_{p}"
        for q, p in enumerate(phases)
        for what in ("x", "v", "d")[: place[1][q + 1] - place[1][q]]
    ]
    names += [name for name, *_ in registry.load(scene).module.MEMORY]
    names += [f"s_{p}" for p in phases] + (["phi"] if kernel.forced else [])
    assert [n for n, q in zip(names, marks, strict=True) if q] == [
        n for n in names if n in known
    ]
    assert marks.sum() == used.sum()
    R = np.empty(len(y))
    theta = np.zeros(len(at))
    MAPS["fill_angles"](given, whole, at, theta)
    MAPS["joints"](given, whole, at, theta, np.zeros((9, 3)), np.zeros((9, 3)), R, 0)
    assert np.abs(R[used]).max(initial=0.0) <= 1e-15 * np.abs(whole).max()
    assert MAPS["known_begin"](given, at, marks) == first


def test_a_start_in_the_place_of_an_event_leaves_no_phase_alone():
    """With (9) the event that ends sticking is not there to say where slip begins."""
    _, place, _ = begun("stick-slip", "ck", 5)
    MAPS["given_alone"](place[0], place[4], place[1], *place[6:])
    assert place[6].tolist()[:4] == [True, True, False, True]  # x and v, v
    assert MAPS["known_begin"](place[0], place[1], place[6]) == -1


def test_phases_of_many_periods_keep_their_digits():
    """Rows are exchanged there; the whole system, by LAPACK, has the same solution."""
    case = registry.load("impact")(frequency=0.11, gap=0.3)
    kernel = registry.kernel(case.scene, "ck-tau")
    order, times = 60, np.array([2 * np.pi / case.cell.omega, 0.7])
    given = kernel.given(case, order)
    at, rooms, marks = rooms_of(given, order)
    work = MAPS["workplace"](given, order, rooms, marks)
    y = np.array([0.3, -0.2, *times])
    MAPS["solve_phases"](given, y, at, order, work)
    assert marks[0, MAPS["WIDE"]]  # exchanged
    z = np.empty(kernel.size(order))
    MAPS["unpack"](given, y, at, order, *work[:3], z)
    R = residual(kernel, given, z)
    rows = MAPS["tests"](given[0], 0, order)
    assert np.abs(R[:rows]).max() <= 1e-13 * np.abs(z).max()
