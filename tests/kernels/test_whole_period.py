"""The kernels over the whole period: derivatives, digits, functions with a break, compiled."""

from types import SimpleNamespace

import numpy as np
import one_mass
import pytest
import sympy as sp
from flint import arb, ctx
from galerkin.solving import differences, jacobian, residual
from numpy.polynomial import legendre

from nonsmooth.codegen.emission.whole_period import LAST
from nonsmooth.codegen.galerkin.harmonics import beta
from nonsmooth.solver.kernels import registry, series
from nonsmooth.solver.precision.balls import as_balls, residual_in_balls
from nonsmooth.solver.scenes.arrays import Arrays, arrays_of

NAME = "nonsmooth.generated.hb"
hb = SimpleNamespace(**series.FAMILY.plain(NAME))

MOTIONS = {one.label: one for name in one_mass.NAMES for one in registry.load(name).each_motion}

#: Phases, sign of the next cell, forced, memories, classes, functions at each switch.
CELLS = {
    "one phase": (1, 1, True, 0, (0,), 0),
    "one phase, mirrored": (1, -1, True, 0, (0,), 2),
    "one phase, nothing forces": (1, 1, False, 0, (1,), 3),
    "two phases": (2, 1, False, 1, (2, 0), 0),
    "two phases, mirrored": (2, -1, True, 1, (3, 1), 3),
    "three phases": (3, 1, True, 2, (1, 0, 2), 1),
    "three phases, mirrored": (3, -1, False, 0, (0, 1, 0), 0),
    "four phases": (4, 1, True, 1, (0, 2, 1, 1), 2),
    "the highest class": (2, 1, True, 0, (7, 6), 3),
}


def made(phases, sign, forced, memories, classes, functions):
    """Return the arrays of a cell with numbers of its own everywhere."""
    drawn = np.random.default_rng(phases)
    kinds = np.array([(1, k, functions, hb.AT_END, hb.AT_END) for k in classes])
    numbers = drawn.uniform(-1, 1, (phases, hb.MEMORY + 2 * memories))
    numbers[:, hb.M] += 2
    memory = drawn.uniform(-1, 1, (memories, 4))
    if not forced:
        numbers[:, [hb.G, hb.E_COS]] = memory[:, 2] = 0.0
    setting = drawn.integers(0, phases, memories)
    length = 0 if not forced else 3 if sign == -1 else 4
    return Arrays(kinds, numbers, setting, memory, np.array([sign, 1.3, length]))


def unknowns(module, arrays, order, seed=0):
    """Return unknowns of which each is of moderate size."""
    drawn = np.random.default_rng(seed)
    harmonics = (order + 1) // 2 if module.odd(arrays.cell[0]) else order
    z = drawn.normal(size=module.unknowns_beside(arrays) + 2 * harmonics)
    times = len(arrays.kinds) + int(arrays.cell[2] != 0)
    z[-times:] = drawn.uniform(0.5, 1.5, times)
    return z


@pytest.mark.parametrize("cell", CELLS)
def test_a_jacobian_is_that_of_its_residual(cell):
    """Of cells of all kinds; those of scenes, and with one function, are in `test_rows`."""
    arrays = made(*CELLS[cell])
    z = unknowns(hb, arrays, 3)
    J = jacobian(hb, arrays, z)
    expected = np.transpose(differences(lambda z: residual(hb, arrays, z), z, step=2.0**-7))
    size = np.abs(J).max(axis=1, keepdims=True)
    np.testing.assert_allclose(J / size, expected / size, atol=1e-8)


def arrays_for(scene, functions=0):
    """Return the arrays of a scene of one motion, with its defaults."""
    classes = [k for k, _ in scene.module.SWITCHES]
    return arrays_of(scene().cell, classes, [functions] * len(classes))


@pytest.mark.parametrize("functions", range(4))
@pytest.mark.parametrize("motion", MOTIONS)
def test_residuals_keep_their_digits(motion, functions):
    """Also those of high derivatives, in which the series itself has no part."""
    arrays = arrays_for(MOTIONS[motion], functions)
    z = unknowns(hb, arrays, 10)
    with ctx.workdps(40):
        exact = np.full(len(z), arb(0), dtype=object)
        balls = np.array([arb(value) for value in z], dtype=object)
        residual_in_balls(hb.residual)(as_balls(arrays), balls, exact)
        expected = np.array([float(value.mid()) for value in exact])
    got = residual(hb, arrays, z)
    np.testing.assert_allclose(got, expected, rtol=0, atol=2e-14 * np.abs(expected).max())


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("n", range(LAST + 1))
def test_functions_with_a_break(n, sign):
    """Themselves, and their series on parts of a cell."""
    u, w = sp.Symbol("u"), np.linspace(0, 1, 7)
    exact = sp.Poly(sp.Integer(0) * u + beta(n, u, sign), u)
    size = max(abs(float(exact.eval(sp.Rational(i, 8)))) for i in range(9)) or 1.0
    for begin, length in ((0.0, 1.0), (0.25, 0.5), (0.75, 0.25), (0.5, 2.0**-20)):
        places = [sp.Rational(float(value)) for value in begin + length * w]
        expected = [float(exact.eval(place)) for place in places]
        series = hb.break_series(n, begin, length, sign)[n]
        got = legendre.legval(2 * w - 1, series)
        np.testing.assert_allclose(got, expected, rtol=0, atol=2e-13 * size)
        values = [hb.break_value(n, value, sign) for value in begin + length * w]
        np.testing.assert_allclose(values, expected, rtol=0, atol=1e-14 * size)


@pytest.mark.parametrize("cell", CELLS)
def test_motions_meet_where_phases_do(cell):
    """Displacements do, and velocities but for their jumps."""
    arrays = made(*CELLS[cell])
    kinds, sign = arrays.kinds, arrays.cell[0]
    z = unknowns(hb, arrays, 4)
    at = hb.places(arrays, 4 if sign > 0 else 2)
    for q in range(len(kinds)):
        p, turned = (q - 1, 1.0) if q > 0 else (len(kinds) - 1, sign)
        smooth = kinds[q, hb.CLASS] > 0 or hb.jumps(kinds, q)
        for order in range(2 if smooth else 1):
            after = hb.motion(arrays, z, q, np.zeros(1), order)[0]
            before = turned * hb.motion(arrays, z, p, np.ones(1), order)[0]
            jump = z[at[q]] if order == 1 and hb.jumps(kinds, q) else 0.0
            assert after - before == pytest.approx(jump, abs=1e-11)


@pytest.mark.long  # as long as all kernels of the series take to compile
@pytest.mark.parametrize(
    ("family", "name"), [(series.FAMILY, NAME), (series.ONE_FUNCTION, f"{NAME}_c1")]
)
def test_compiled_kernels_give_the_same_bits(family, name):
    plain = SimpleNamespace(**family.plain(name))
    compiled = SimpleNamespace(
        **{q: family.compiled(name)[q] for q in ("residual", "jacobian")}
    )
    cells = map(made, *zip(*CELLS.values(), strict=True)) if name == NAME else ()
    scenes = MOTIONS if name == NAME else ("stick-slip",)
    for arrays in (*cells, *(arrays_for(MOTIONS[each]) for each in scenes)):
        z = unknowns(plain, arrays, 18)
        np.testing.assert_array_equal(residual(compiled, arrays, z), residual(plain, arrays, z))
        np.testing.assert_array_equal(jacobian(compiled, arrays, z), jacobian(plain, arrays, z))
