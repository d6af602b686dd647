"""Digits of bodies that nothing holds but their contacts, or drives; of a mode in resonance.

In balls: a particle against its closed form, half a period, whose closing is regular, against
the whole, whose closing is not, and the force series against the exact equations.
"""

from functools import cache

import numpy as np
import pytest
import sympy as sp
from bodies.test_bodies_that_move_freely import ball_in_a_slot, row, scene
from bodies.test_large_and_free_bodies import FIRST, TWO, case
from bodies.test_self_excited_bodies import elastic, impact

pytest.importorskip("flint")

from flint import arb, ctx
from precision.test_digits_of_bodies import METHODS, assert_kept

import nonsmooth as ns
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.kernels.bodies import exact_kernel
from nonsmooth.solver.orbit.solution import attempt
from nonsmooth.solver.precision.digits import in_balls as equations_in_balls
from nonsmooth.solver.precision.refine import refine


@cache
def particle(half: bool = False):
    """Return a driven mass between two walls."""
    walls = scene("particle", sp.eye(1), [[0]], [1], "walls", forcing=(1,), half=half)
    return walls(gap=0.2, force=0.1)


@cache
def ball(half: bool = False):
    """Return a ball in a slot of a driven mass."""
    return ball_in_a_slot(half)()


@cache
def gears():
    """Return a pair that rattles; bearings couple what no contact sees with what one does."""
    M, C = np.diag([2.0, 2.0]), np.array([[0.35, -0.05], [-0.05, 0.25]])
    pair = scene("gears", M, np.zeros((2, 2)), [1, -1], "walls", half=False, C=C)
    return pair(gap=0.05, force=0.4)


@cache
def resonance():
    """Return two masses, forced at the frequency of their first mode."""
    return case(np.eye(2), TWO, FIRST)


CASES = {
    "particle": particle,
    "ball": ball,
    "gears": gears,
    "row": cache(row),
    "resonance": resonance,
    "self-excited": elastic,
    "self-excited impact": impact,
}


@cache
def exact(given):
    """Return the exact orbit of a case, which several tests begin with."""
    return ns.exact(given)


def in_balls(given, method: str, order: int = 0, functions: int | None = None):
    """Return the times of an orbit by the equations of a method in balls."""
    orbit = exact(given)
    kernel, own = exact_kernel(orbit.case.cell), orbit.case.cell
    times = kernel.times(orbit.outcome.unknowns)
    if order:
        kernel = registry.kernel(given.scene, method, functions)
        own = kernel.given(orbit.case, order)
        times = kernel.times(attempt(kernel, orbit.case, order, times, functions).unknowns)
    found = refine(kernel, own, times, 22, equations_in_balls(given, method))
    assert all(float(q.rad()) < 1e-21 for q in found)
    assert [float(q) for q in found] == pytest.approx(list(times), rel=0, abs=1e-12)
    return found


@pytest.mark.parametrize("half", [True, False])
def test_a_particle_between_walls_has_its_closed_form(half: bool) -> None:
    """See `reach` of the scene; here of its exact binary numbers."""
    given = particle(half)
    *durations, angle = in_balls(given, "exact")
    cell = given.cell
    (rebound, _), event = cell.phases[0].jumps[0], cell.phases[0].event
    with ctx.workdps(50):
        moved = arb(float(cell.body.at[0, 0])) * float(cell.body.forcing[0])
        a = 2 * moved / arb(cell.omega) ** 2
        b = arb.pi() / 2 * a * (1 - arb(rebound)) / (1 + arb(rebound))
        gap, turn = -arb(event[3]) / event[0], arb.atan2(b, a)
        impact = (2 * gap / (a * a + b * b).sqrt()).acos()
        turns = [(angle + turn - impact * side) / (2 * arb.pi()) for side in (1, -1)]
        assert min(float(abs(q - round(float(q)))) for q in turns) < 1e-21
        apart = [float(abs(q - arb.pi() / cell.omega)) for q in durations]
    assert len(apart) == (1 if half else 2)
    assert max(apart) < 1e-21


@pytest.mark.parametrize("method", METHODS)
def test_half_a_period_says_where_a_ball_is_as_a_whole_one_does(method: str) -> None:
    half, whole = (in_balls(ball(q), method, *METHODS[method]) for q in (True, False))
    assert len(whole) == 3
    with ctx.workdps(50):
        expected = [half[0], half[0], half[1]]
        apart = [float(abs(a - b)) for a, b in zip(whole, expected, strict=True)]
    assert max(apart) < 1e-20


@pytest.mark.parametrize("name", CASES)
def test_the_force_series_of_a_held_body_converges_to_the_exact_equations(name: str) -> None:
    """Far beyond the digits of float64, by poles with springs and by exponentials without."""
    expected, found = in_balls(CASES[name](), "exact"), in_balls(CASES[name](), "ck-tau", 32)
    with ctx.workdps(50):
        apart = [float(abs(a - b)) for a, b in zip(found, expected, strict=True)]
    assert max(apart) < 1e-20


@pytest.mark.parametrize("method", ["exact", "ck-tau"])
def test_a_motion_without_loss_begins_where_the_force_is_least(method: str) -> None:
    """It is as fast out as back, so that it is its own mirror image in time."""
    without_loss = ns.scene("chain-impact")(restitution=1, damping=0, frequency=0.9)
    *_, angle = in_balls(without_loss, method, *((24,) if method == "ck-tau" else ()))
    assert float(angle) == pytest.approx(np.pi, rel=0, abs=1e-12)


@pytest.mark.parametrize("name", CASES)
def test_the_times_keep_their_digits(name: str) -> None:
    assert_kept(CASES[name]())


@pytest.mark.parametrize("off", [1e-5, 1e-3])
def test_harmonics_keep_digits_beside_a_resonance(off: float) -> None:
    assert_kept(case(np.eye(2), (1 + off) * TWO, FIRST), ("hb", "hb-ck"))
