"""Each phase solved for by itself: against the whole system, which is generated beside it."""

import numpy as np
import pytest
from galerkin.derived import conditions

from nonsmooth.codegen.emission.condensed import Writer
from nonsmooth.codegen.emission.condensed import condensed as condensed_form
from nonsmooth.codegen.emission.loops import rows_of
from nonsmooth.solver.case import registry
from nonsmooth.solver.case.registry import kernel as kernel_of
from nonsmooth.solver.iteration import bands
from nonsmooth.solver.iteration.attempt import attempt
from nonsmooth.solver.iteration.bands import factorise_band, solve_columns, substitute
from nonsmooth.solver.iteration.linear import least_squares
from nonsmooth.solver.solve import solve_case

#: C1, not forced, with a held phase; C0; C2, two bands; C2 with memory, half a cell.
SCENES = ("stick-slip-damped", "impact", "clearance", "elastic-plastic")

PAD = bands.BELOW + bands.ABOVE


def condensed(scene: str, order: int):
    """Return the functions of a condensed kernel, its case, and unknowns that solve nothing."""
    case = registry.load(scene)()
    kernel = kernel_of(case.scene, "ck-tau", None, compile_it=False)
    functions = kernel.iterate.__globals__
    rng = np.random.default_rng(order)
    z = rng.normal(size=kernel.size(order))
    times = kernel.durations + kernel.forced
    z[-times:] = rng.uniform(0.5, 2.0, times)
    work = functions["workplace"](case.arguments, z)
    y = z[list(functions["kept_places"](z))]
    return kernel, functions, case.arguments, work, y, z


@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("order", [2, 3, 9])
def test_the_rows_of_the_bands_hold_and_the_rest_is_as_in_the_whole(scene, order):
    """What the residual has left are the joints: all other rows vanish."""
    kernel, functions, case, work, y, z = condensed(scene, order)
    R, whole = np.empty(len(y)), np.empty(len(z))
    functions["condensed_residual"](work, y, R)
    kernel.residual(case, z, whole)
    banded = sum(size for _, size, _, _, _ in functions["band_places"](z))
    assert len(z) == banded + len(y)
    scale = np.abs(z).max()
    assert np.abs(whole[:banded]).max() < 1e-13 * scale
    np.testing.assert_allclose(R, whole[banded:], atol=1e-14 * scale)
    assert np.abs(R).max() > 1e-3


@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("order", [2, 9])
def test_the_jacobian_is_what_elimination_leaves_of_the_whole_one(scene, order):
    """The Schur complement of the bands, by LAPACK."""
    kernel, functions, case, work, y, z = condensed(scene, order)
    R, J, whole = np.empty(len(y)), np.empty((len(y), len(y))), np.empty((len(z), len(z)))
    functions["condensed_residual"](work, y, R)
    functions["condensed_jacobian"](work, y, J)
    kernel.jacobian(case, z, whole)
    kept = list(functions["kept_places"](z))
    inner = [i for i in range(len(z)) if i not in kept]
    rows = len(inner)
    through = np.linalg.solve(whole[:rows, inner], whole[:rows, kept])
    expected = whole[rows:, kept] - whole[rows:, inner] @ through
    np.testing.assert_allclose(J, expected, atol=1e-11 * np.abs(expected).max())


@pytest.mark.parametrize("turn", [0.3, 7.0, 50.0, 51.3])
@pytest.mark.parametrize("size", [2, 11, 61])
def test_a_band_is_solved_with_rows_exchanged(turn, size):
    """Phases of up to fifty radians: low on the diagonal it may all but vanish."""
    rng = np.random.default_rng(size)
    diagonals, right = np.zeros((1, PAD + size + 2, PAD + 3)), np.zeros((1, PAD + size + 2))
    slopes = np.zeros((1, PAD + size + 2, bands.KEPT))
    A = np.zeros((size, size))
    for i in range(size):
        for j in range(max(0, i - bands.BELOW), min(size, i + bands.ABOVE + 1)):
            near = 1.0 - (turn / (2 * i + 1)) ** 2 if i == j else turn / (i + j + 1)
            A[i, j] = diagonals[0, PAD + i, PAD + j - i] = near + 1e-3 * rng.normal()
    b, B = rng.normal(size=size), rng.normal(size=(size, bands.KEPT))
    right[0, PAD : PAD + size], slopes[0, PAD : PAD + size] = b, B
    exchanged = np.empty((1, PAD + size + 2), dtype=np.int64)
    factorise_band(diagonals, exchanged, 0, size, right)
    substitute(diagonals, 0, size, right)
    solve_columns(diagonals, exchanged, 0, size, slopes, size)
    allowed = 1e-14 * np.linalg.cond(A)
    for got, known in ((right[0], b), (slopes[0], B)):
        expected = np.linalg.solve(A, known)
        error = np.abs(got[PAD : PAD + size] - expected).max()
        assert error <= allowed * np.abs(expected).max()
    if turn > 7 and size > 2:
        assert (exchanged[0, PAD : PAD + size] != np.arange(PAD, PAD + size)).any()


@pytest.mark.parametrize(("rows", "count"), [(6, 4), (5, 5), (7, 1)])
def test_least_squares(rows, count):
    rng = np.random.default_rng(rows)
    A, b, x = rng.normal(size=(rows, count)), rng.normal(size=rows), np.empty(count)
    least_squares(np.column_stack([A, b]), count, x)
    np.testing.assert_allclose(x, np.linalg.lstsq(A, b)[0], atol=1e-13 * np.linalg.cond(A))


def test_a_column_of_least_squares_that_adds_nothing_gets_zero():
    A = np.array([[1.0, 2.0], [1.0, 2.0], [0.0, 0.0]])
    x = np.empty(2)
    least_squares(np.column_stack([A, [3.0, 3.0, 1.0]]), 2, x)
    np.testing.assert_allclose(x, [3.0, 0.0], atol=1e-14)


@pytest.mark.parametrize("scene", SCENES)
def test_what_is_returned_solves_the_whole_system(scene):
    case = registry.load(scene)()
    kernel = kernel_of(case.scene, "ck-tau", None, compile_it=False)
    orbit_times = kernel.times(solve_case(case, "ck-tau", 20).unknowns)
    found = attempt(kernel, case, 40, orbit_times)
    R = np.empty(len(found.unknowns))
    kernel.residual(case.arguments, found.unknowns, R)
    assert found.converged
    assert np.abs(R).max() == found.outcome.residual_norm < 1e-13


@pytest.mark.parametrize(
    ("name", "kernel", "reach"), [("S1", "ck_tau", [2]), ("S1", "ck", None)]
)
def test_only_bands_that_can_be_eliminated(name, kernel, reach):
    """Tests that are the functions themselves give no diagonal that outweighs the rest."""
    system = conditions(name, kernel)
    found = condensed_form(system, rows_of(system))
    if reach is None:
        assert found is None
    else:
        assert (found.below, found.above) == (2, 2)
        writer = Writer(system, found)
        assert [int(writer._reach(band)) for band in found.bands] == reach
