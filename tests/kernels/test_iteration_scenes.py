"""Newton's method on coefficients and times, and the first iterates that it gets."""

import math
import types
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import pytest
from made_scenes import made

from nonsmooth.solver.arrays import Vector
from nonsmooth.solver.bodies.force_series import events
from nonsmooth.solver.iteration import by_rows
from nonsmooth.solver.iteration.iteration import ROUNDOFF
from nonsmooth.solver.iteration.newton import newton
from nonsmooth.solver.kernels import bodies, family, linking, polynomials, registry, series
from nonsmooth.solver.kernels.compiling import rebuilt
from nonsmooth.solver.kernels.linking import newton_with
from nonsmooth.solver.kernels.start import rough_times, with_coefficients
from nonsmooth.solver.orbit.solution import attempt
from nonsmooth.solver.scenes.methods import module_of

IMPACT = registry.load("impact")
DAMPED = registry.load("stick-slip-damped")

MODULES = ("nonsmooth.generated.ck", "nonsmooth.generated.hb")


def solve(
    residual, jacobian, start, durations=1, forced=False, seen=None, filled=None, **options
):
    """Solve small systems of a coefficient, durations and maybe the phase of a forcing."""

    def fill_residual(case, z, R):
        if seen is not None:
            seen.append(z.copy())
        R[:] = residual(z)

    def fill_jacobian(case, z, J):
        if filled is not None:
            filled.append(z.copy())
        J[:] = jacobian(z)

    system = fill_residual, fill_jacobian, lambda case: (durations, int(forced))
    iteration = newton_with(*system, rebuilt)["iterate_scene"]
    return newton(iteration, None, np.array(start, dtype=float), **options)


def quadratic(z):
    return [z[0] - 1, z[1] ** 2 - 4]


def quadratic_jacobian(z):
    return [[1, 0], [0, 2 * z[1]]]


def test_converges_quadratically_to_the_last_digit() -> None:
    outcome = solve(quadratic, quadratic_jacobian, [0.5, 3])
    assert outcome.converged
    assert outcome.unknowns.tolist() == [1, 2]
    assert outcome.iterations <= 6
    assert outcome.correction <= ROUNDOFF
    assert type(outcome.correction) is type(outcome.residual_norm) is float
    assert outcome.residual_norm == 0


def test_a_jacobian_is_used_while_corrections_shrink_fast() -> None:
    """One from 1 % off; with a new one at every step it would be four."""
    seen, filled = [], []
    near = solve(quadratic, quadratic_jacobian, [0.9, 2.02], seen=seen, filled=filled)
    assert near.converged
    assert near.unknowns.tolist() == [1, 2]
    assert (near.iterations, len(filled)) == (1, 1)
    assert len(seen) > 5


def test_a_jacobian_from_far_off_shows_no_convergence() -> None:
    """It finds the same, and the one there confirms it."""
    far = solve(quadratic, quadratic_jacobian, [0.5, 2.02])
    assert far.converged
    assert far.unknowns.tolist() == [1, 2]
    assert far.iterations == 2


def test_a_jacobian_is_not_used_where_corrections_shrink_slowly() -> None:
    """From far off the corrections halve at first: then nothing is gained by an old one."""
    filled = []
    far = solve(quadratic, quadratic_jacobian, [0.5, 3.4], filled=filled)
    assert far.converged
    assert far.unknowns.tolist() == [1, 2]
    assert len(filled) == far.iterations > 1
    assert abs(filled[1][1] - 2) < abs(filled[0][1] - 2) / 2


def test_coefficients_converge_where_the_times_have_long_done_so() -> None:
    """A slope 1 % off: each correction of the coefficient leaves a hundredth of it."""
    outcome = solve(lambda z: [z[0] - 1, z[1] - 2], lambda z: np.diag([0.99, 1]), [0.5, 2])
    assert outcome.converged
    assert outcome.unknowns == pytest.approx([1, 2], rel=1e-10)


def test_the_start_is_not_overwritten() -> None:
    start = np.array([0.5, 3.0])
    solve(quadratic, quadratic_jacobian, start)
    assert start.tolist() == [0.5, 3]


@pytest.mark.parametrize(
    ("residual", "jacobian", "reason"),
    [
        (
            lambda z: [z[0] ** 2 + 1, z[1] - 2],
            lambda z: np.diag([2 * z[0], 1]),
            "no damped step",
        ),
        (quadratic, lambda z: np.zeros((2, 2)), "the Jacobian is singular"),
        (lambda z: [math.inf, 0], quadratic_jacobian, "the equations overflow"),
        (lambda z: [z[0] - 1, z[1] ** 2], quadratic_jacobian, "within the limit"),
    ],
)
def test_failure_is_reported_not_returned(residual, jacobian, reason) -> None:
    outcome = solve(residual, jacobian, [0.5, 3], limit=20)
    assert not outcome.converged
    assert reason in outcome.reason


def test_steps_of_the_times_are_limited() -> None:
    goal = np.array([1.0, 0.01, 8.0, 5.0])
    seen = []
    outcome = solve(
        lambda z: z - goal, lambda z: np.eye(4), [1, 1, 1, 0], 2, forced=True, seen=seen
    )
    assert outcome.converged
    np.testing.assert_allclose(outcome.unknowns, goal, rtol=1e-14)
    for before, after in pairwise(seen):
        assert np.all(np.abs(after[1:3] - before[1:3]) <= 0.4 * before[1:3] * (1 + 1e-12))
        assert abs(after[3] - before[3]) <= 0.8 * (1 + 1e-12)


def test_the_scale_of_an_equation_changes_nothing_but_rounding() -> None:
    rows = np.array([1e-12, 1e12])
    plain = solve(quadratic, quadratic_jacobian, [0.5, 3])
    scaled = solve(
        lambda z: rows * quadratic(z),
        lambda z: rows[:, None] * np.array(quadratic_jacobian(z)),
        [0.5, 3],
    )
    assert scaled.iterations == plain.iterations
    np.testing.assert_allclose(scaled.unknowns, plain.unknowns, rtol=1e-15)


def test_what_no_longer_falls_has_converged_and_says_how_far() -> None:
    generator = np.random.default_rng(0)

    def noisy(z):
        return [z[0] - 1, z[1] - 2 + 1e-12 * generator.normal()]

    outcome = solve(noisy, lambda z: np.eye(2), [0.5, 3])
    assert outcome.converged
    assert 1e-15 < outcome.correction < 1e-11


def test_compiled_and_plain_kernels_give_the_same_bits() -> None:
    case = IMPACT()
    times = np.array([6.2, 1.0])
    plain, compiled = (
        attempt(registry.kernel(IMPACT, "ck-tau", compile_it=flag), case, 8, times)
        for flag in (False, True)
    )
    assert plain.outcome.converged
    assert plain.unknowns.tolist() == compiled.unknowns.tolist()
    assert plain.outcome.iterations == compiled.outcome.iterations


@pytest.mark.parametrize(
    ("method", "functions"), [("ck-tau", None), ("hb", None), ("hb-ck", 2)]
)
def test_what_numba_does_not_count_hands_over_no_array(method, functions) -> None:
    """Such a function would give away, or never free, what nobody counts."""
    uncounted = set()

    def make(function, namespace, counted):
        own = rebuilt(function, namespace)

        def called(*given):
            found = own(*given)
            if not counted:
                uncounted.add(function.__name__)
                parts = found if isinstance(found, tuple) else (found,)
                assert not any(isinstance(part, np.ndarray) for part in parts), function
            return found

        return called

    kernel, case = registry.kernel(IMPACT, method, functions), IMPACT()
    of = polynomials.FAMILY if kernel.condensed else series.FAMILY
    made = of.link(module_of(method), make)
    solved = attempt(replace(kernel, iterate=made["iterate"]), case, 8, np.array([6.2, 1.0]))
    assert solved.outcome.converged
    assert len(uncounted) > 15


def makes(n):
    return np.zeros(n)


def takes(n):
    return makes(n)[0]


def gives(n):
    return takes(n), math.sqrt(n)


def adds(n):
    return n + 1


class Pair(NamedTuple):
    """An array beside a number."""

    values: Vector
    weight: float


class Pairs(NamedTuple):
    """A tuple in a tuple."""

    first: Pair


def reads(pairs: Pairs) -> float:
    return pairs.first.values[0] * pairs.first.weight


def pairs_up(values: Vector) -> tuple[Pair, int]:
    return Pair(values, 1.0), 1


def copies(pair: Pair) -> float:
    return pair.values.copy()[0]


def appends(numbers: list[float]) -> None:
    numbers[0] = 1.0


def test_what_reads_fields_is_not_counted() -> None:
    """What returns arrays in a tuple is, and what takes a list."""
    functions = {one.__name__: one for one in (reads, pairs_up, copies, appends)}
    assert linking.with_arrays(functions, set()) == {"pairs_up", "copies", "appends"}


def test_what_calls_for_an_array_is_counted_too() -> None:
    functions = {one.__name__: one for one in (gives, adds, takes, makes)}
    assert linking.with_arrays(functions, set()) == {"makes", "takes", "gives"}
    alone = {"gives": gives, "adds": adds}
    assert linking.with_arrays(alone, set()) == set()
    assert linking.with_arrays(alone, {"takes"}) == {"takes", "gives"}


def test_the_key_of_compiled_code_covers_all_of_it(monkeypatch) -> None:
    """The module by its name, its text, and that of all that is compiled with it."""
    seen = []
    monkeypatch.setattr(family, "text_of", lambda *modules: seen.extend(modules) or b"text")
    keys = {
        f.fingerprint(name) for f in (polynomials.FAMILY, series.FAMILY) for name in MODULES
    }
    assert len(keys) == len(MODULES)
    assert {module.__name__.rpartition(".")[2] for module in seen} >= {
        *("ck", "hb", "band", "linear", "together", "iteration", "single"),
    }


def test_the_key_of_the_force_series_covers_what_solves_it_too(monkeypatch) -> None:
    """What is called is in the namespace of what calls it."""
    seen = []
    monkeypatch.setattr(family, "text_of", lambda *modules: seen.extend(modules) or b"text")
    bodies.FAMILY.fingerprint(events.__name__)
    iterate = bodies.FAMILY.plain(events.__name__)["iterate"]
    called = [q for q in iterate.__globals__.values() if isinstance(q, types.FunctionType)]
    linked = [iterate, *called, *iterate.__globals__["residual"].__globals__.values()]
    own = {q.__module__ for q in linked if isinstance(q, types.FunctionType)}
    assert len(own) > 4
    never_compiled = {by_rows.__name__}
    assert own - never_compiled <= {module.__name__ for module in seen}


def test_coefficients_at_exact_times_solve_all_conditions() -> None:
    kernel, case = registry.kernel(IMPACT, "ck-tau"), IMPACT()
    solved = attempt(kernel, case, 8, np.array([6.28, 1.0])).unknowns
    given = kernel.given(case, 8)
    z = with_coefficients(kernel, given, len(solved), kernel.times(solved))
    np.testing.assert_allclose(z, solved, rtol=0, atol=1e-12)


def test_rough_times_of_a_forced_cell_go_all_around_and_fill_it() -> None:
    starts = list(rough_times(IMPACT().cell))
    assert len(starts) == 12
    assert all(sum(start.durations) == pytest.approx(2 * math.pi) for start in starts)
    angles = [start.angle for start in starts]
    np.testing.assert_allclose(np.diff(angles), math.pi / 6)


def test_rough_times_without_forcing_begin_with_half_periods() -> None:
    starts = list(rough_times(DAMPED().cell))
    assert starts[0].durations == (math.pi, math.pi)
    assert len({start.durations for start in starts}) == len(starts) == 5


@pytest.mark.parametrize(("count", "starts"), [(12, 12 * 25), (13, 12)])
def test_of_many_phases_none_is_tried_longer_than_the_others(count: int, starts: int) -> None:
    scene = made([(1, 0.1, 1, 0, 1)] * count, [(1, 0, 0, 0)] * count, omega=2.0)
    assert len(list(rough_times(scene().cell))) == starts


def test_the_guess_of_a_scene_comes_first() -> None:
    equation = (1, 0.1, 1, 0, 1)
    scene = made([equation] * 2, [(1, 0, 0, 0)] * 2, omega=2.0, guess=(3.0, 1.0))
    first = next(rough_times(scene().cell))
    assert first.durations == pytest.approx((0.75 * math.pi, 0.25 * math.pi))
    assert "guess" in first.words


def test_the_first_coefficients_do_not_depend_on_the_scale_of_an_equation() -> None:
    kernel, case = registry.kernel(IMPACT, "ck-tau"), IMPACT()
    size = kernel.size(5)
    rows = 10.0 ** np.random.default_rng(0).uniform(-6, 6, size)

    def residual(case, z, R):
        kernel.residual(case, z, R)
        R *= rows

    def jacobian(case, z, J):
        kernel.jacobian(case, z, J)
        J *= rows[:, None]

    times = np.array([6.0, 1.5])  # that no coefficients satisfy
    scaled = replace(kernel, residual=residual, jacobian=jacobian)
    given = kernel.given(case, 5)
    one, two = (with_coefficients(k, given, size, times) for k in (kernel, scaled))
    np.testing.assert_allclose(one, two, rtol=0, atol=1e-12)
