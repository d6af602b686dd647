"""Each phase solved for by itself: against the whole system, which is generated beside it."""

import numpy as np
import pytest
import sympy as sp
from galerkin.derived import conditions

from nonsmooth.codegen.emission.condensed import Writer
from nonsmooth.codegen.emission.condensed.bands import bands_of
from nonsmooth.codegen.emission.condensed.order import _solved, remaining
from nonsmooth.codegen.emission.condensed.order import order as order_of
from nonsmooth.codegen.emission.loops import Row, rows_of
from nonsmooth.codegen.galerkin.condition import Condition, N
from nonsmooth.solver.iteration import bands
from nonsmooth.solver.iteration.bands import factorise_band, solve_columns, substitute
from nonsmooth.solver.iteration.linear import least_squares
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.kernels.registry import kernel as kernel_of
from nonsmooth.solver.orbit.attempt import attempt
from nonsmooth.solver.solve import solve_case

#: C1, not forced, with a held phase; C0; C2, two bands; C2 with memory, half a cell.
SCENES = {
    "S5a": "stick-slip-damped",
    "S1": "impact",
    "S2b": "clearance",
    "S4a": "elastic-plastic",
}

TIME, PHASE = sp.Symbol("s_flight", positive=True), sp.Symbol("phi", real=True)

PAD = bands.BELOW + bands.ABOVE


def condensed(scene: str, order: int):
    """Return the functions of a condensed kernel, its case, and unknowns that solve nothing.

    What single conditions give before is filled in.
    """
    case = registry.load(scene)()
    kernel = kernel_of(case.scene, "ck-tau", None, compile_it=False)
    functions = kernel.iterate.__globals__
    rng = np.random.default_rng(order)
    z = rng.normal(size=kernel.size(order))
    times = kernel.durations + kernel.forced
    z[-times:] = rng.uniform(0.5, 2.0, times)
    functions["before"](case.arguments, z)
    work = functions["workplace"](case.arguments, z)
    y = z[list(functions["kept_places"](z))]
    return kernel, functions, case.arguments, work, y, z


def joined(name: str):
    """Return the bands of a scene of the references, and the order of its joints."""
    system = conditions(name, "ck_tau")
    found = bands_of(system, rows_of(system))
    return found, order_of(system, found.bands, found.joints)


def rows_together(name: str, order: int) -> list[int]:
    """Return the rows of the whole residual that are solved together."""
    found, solved = joined(name)
    first = sum(int(band.size.subs(N, order)) for band in found.bands)
    return [first + found.joints.index(row) for row in solved.rows]


@pytest.mark.parametrize(("name", "scene"), SCENES.items())
@pytest.mark.parametrize("order", [2, 3, 9])
def test_the_rows_of_the_bands_hold_and_the_rest_is_as_in_the_whole(name, scene, order):
    """What the residual has left are rows of the whole; those of bands and before vanish."""
    kernel, functions, case, work, y, z = condensed(scene, order)
    R, whole = np.empty(len(y)), np.empty(len(z))
    functions["condensed_residual"](work, y, R)
    functions["complete"](work)
    functions["after"](case, z)
    kernel.residual(case, z, whole)
    together = rows_together(name, order)
    scale = np.abs(z).max()
    np.testing.assert_allclose(R, whole[together], atol=1e-14 * scale)
    assert np.abs(R).max() > 1e-3
    others = np.delete(whole, together)
    assert np.abs(others).max() < 1e-13 * scale
    assert len(others) == len(z) - len(y)


@pytest.mark.parametrize(("name", "scene"), SCENES.items())
@pytest.mark.parametrize("order", [2, 9])
def test_the_jacobian_is_what_elimination_leaves_of_the_whole_one(name, scene, order):
    """The Schur complement of the bands, by LAPACK."""
    kernel, functions, case, work, y, z = condensed(scene, order)
    R, J, whole = np.empty(len(y)), np.empty((len(y), len(y))), np.empty((len(z), len(z)))
    functions["condensed_residual"](work, y, R)
    functions["condensed_jacobian"](work, y, J)
    kernel.jacobian(case, z, whole)
    inner = [
        i for at, size, _, _, _ in functions["band_places"](z) for i in range(at, at + size)
    ]
    kept, rows = list(functions["kept_places"](z)), len(inner)
    together = rows_together(name, order)
    through = np.linalg.solve(whole[:rows, inner], whole[:rows, kept])
    expected = whole[together][:, kept] - whole[together][:, inner] @ through
    np.testing.assert_allclose(J, expected, atol=1e-11 * np.abs(expected).max())


def test_what_is_assigned_before_and_after():
    """A stick-slip motion is one equation for the duration of slip, as one would by hand."""
    _, solved = joined("S5a")
    before = {str(each.unknown): each.value for each in solved.before}
    named = {str(q): q for value in before.values() for q in value.free_symbols}
    static = (named["F_N"] * named["mu_s"] - named["V"] * named["c"]) / named["K"]
    assert sp.simplify(before["x_slip"] - static) == 0
    assert str(before["v_stick"]) == "V"
    assert str(before["v_slip"]) == "v_stick"
    assert [str(q) for q in solved.unknowns] == ["s_slip"]
    assert [row.condition.name for row in solved.rows] == ["velocity_stick"]
    assert [str(each.unknown) for each in solved.after] == ["x_stick", "s_stick"]
    x_stick, s_stick = (each.value for each in solved.after)
    q = {str(symbol): symbol for symbol in x_stick.free_symbols}
    assert sp.simplify((q["x_slip"] - x_stick) / solved.before[1].unknown - s_stick) == 0
    assert not s_stick.has(q["x_slip"])  # it would cancel


def test_a_forced_cell_of_one_phase_has_its_duration_before():
    _, solved = joined("S1")
    assert [str(each.unknown) for each in solved.before] == ["s_flight"]
    assert [str(q) for q in solved.unknowns] == ["x_flight", "v_flight", "phi"]
    assert not solved.after


@pytest.mark.parametrize("name", SCENES)
def test_every_unknown_that_no_band_has_is_given_once(name):
    found, solved = joined(name)
    assigned = [each.unknown for each in (*solved.before, *solved.after)]
    system = conditions(name, "ck_tau")
    everything = {*assigned, *solved.unknowns}
    assert everything == set(remaining(system, found.bands))
    assert len(everything) == len(assigned) + len(solved.unknowns)
    rows = [each.row for each in (*solved.before, *solved.after)]
    assert len(solved.rows) == len(solved.unknowns) >= 1
    assert sorted(map(id, (*rows, *solved.rows))) == sorted(map(id, found.joints))


def said_of_the_phase(expression):
    """Return what a condition that is zero says of the phase of the forcing."""
    system = conditions("S1", "ck_tau")
    row = Row(Condition("event", "an event", expression), ())
    return _solved(system, row, system.times.unknown[-1])


@pytest.mark.parametrize(
    ("power", "value"), [(1, (2 * TIME + 3) / 5), (2, None), (sp.Rational(1, 2), None)]
)
def test_only_what_is_linear_is_solved_for(power, value):
    found = said_of_the_phase(5 * PHASE**power - 2 * TIME - 3)
    assert found is None if value is None else sp.expand(found.value - value) == 0


def test_nothing_is_divided_by_a_parameter_that_may_vanish():
    """The damping of an impact oscillator may, its mass may not."""
    m, c = (next(q for q in conditions("S1", "ck_tau").parameters if q.name == n) for n in "mc")
    assert said_of_the_phase(c * PHASE - 1) is None
    assert said_of_the_phase(m * PHASE - 1).value == 1 / m
    assert said_of_the_phase((m + c) * PHASE - 1).value == 1 / (m + c)


@pytest.mark.parametrize("turn", [0.3, 7.0, 50.0, 51.3])
@pytest.mark.parametrize("size", [2, 11, 61])
def test_a_band_is_solved_with_rows_exchanged(turn, size):
    """Phases of up to fifty radians: low on the diagonal it may all but vanish."""
    rng = np.random.default_rng(size)
    diagonals, right = np.zeros((1, PAD + size + 2, PAD + 3)), np.zeros((1, PAD + size + 2))
    found = np.zeros_like(right)
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
    for first, last in ((0, 1), (1, size)):  # as far as joints see, and the rest
        substitute(diagonals, 0, first, last, right, found)
    solve_columns(diagonals, exchanged, 0, size, slopes, size)
    allowed = 1e-14 * np.linalg.cond(A)
    for got, known in ((found[0], b), (slopes[0], B)):
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


@pytest.mark.parametrize("scene", SCENES.values())
def test_what_is_returned_solves_the_whole_system(scene):
    case = registry.load(scene)()
    kernel = kernel_of(case.scene, "ck-tau", None, compile_it=False)
    orbit_times = kernel.times(solve_case(case, "ck-tau", 20).unknowns)
    found = attempt(kernel, case, 40, orbit_times)
    R = np.empty(len(found.unknowns))
    kernel.residual(case.arguments, found.unknowns, R)
    assert found.converged
    assert np.abs(R).max() == found.outcome.residual_norm < 1e-13


def test_only_bands_that_can_be_eliminated():
    """Harmonics see each other all: no row of theirs is banded."""
    system = conditions("S1", "hb")
    assert bands_of(system, rows_of(system)) is None


@pytest.mark.parametrize(("name", "kernel"), [("S1", "ck_tau"), ("S1", "ck")])
def test_bands_of_one_phase(name, kernel):
    system = conditions(name, kernel)
    found = bands_of(system, rows_of(system))
    assert (found.below, found.above) == (2, 2)
    solved = order_of(system, found.bands, found.joints)
    writer = Writer(system, found, solved)
    reach = 2 if kernel == "ck_tau" else N  # what no test sees is in the highest degrees
    assert [writer._reach(band) for band in found.bands] == [reach]
