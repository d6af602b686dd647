"""Kernels in ball arithmetic: right by another program, by quadrature, and by each other."""

from types import SimpleNamespace

import mpmath as mp
import numpy as np
import pytest
from galerkin.derived import REFERENCES
from galerkin.solving import jacobian

pytest.importorskip("flint")

from flint import arb, ctx

from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.flow.exact_system import exact_kernel
from nonsmooth.solver.iteration.newton import newton
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.kernels.start import with_coefficients
from nonsmooth.solver.orbit.solution import attempt
from nonsmooth.solver.precision import exact_balls
from nonsmooth.solver.precision import refine as refining
from nonsmooth.solver.precision.balls import (
    quotient,
    residual_in_balls,
    spherical_bessel,
)
from nonsmooth.solver.precision.refine import PrecisionError, refine
from nonsmooth.solver.rows import joints
from nonsmooth.solver.scenes.of_module import cell_of
from nonsmooth.solver.solve import solve_case

#: Of the references: a shipped scene, its motion, and parameters in decimals, in its order.
CASES = {
    "S1": ("impact", None, "1 0.1 1 1 1.8 0.1 0.6"),
    "S2b": ("clearance", None, "1 0.2 1 4 0.5 1 1.3"),
    "S3b": ("dry-friction", "two-stops", "1 0.1 1 1 0.6 0.5 1 0.4"),
    "S4a": ("elastic-plastic", None, "1 0.1 1 0.5 0.2 1 0.8"),
    "S5a": ("stick-slip-damped", None, "1 1 1 3 1 1 0.1 0"),
}
KERNELS = {"ck_tau": ("ck-tau", None), "ck": ("ck", None), "hb": ("hb", None)}
KERNELS |= {"hb_ck_1": ("hb-ck", 1), "hb_ck_2": ("hb-ck", 2)}
ROWS = [
    (name, row)
    for name in CASES
    for row in REFERENCES[name]["solutions"]
    if row["order"] in {"ck": (7,), "ck_tau": (6,)}.get(row["kernel"], (5,))
    if row["kernel"] != "hb_ck_2" or name in ("S1", "S3b")
]


def scene_of(name):
    scene, motion, _ = CASES[name]
    found = registry.load(scene)
    return found.of_motion(motion) if motion else found


def kernel_of(name, kernel):
    return registry.kernel(scene_of(name), *kernel)


def with_exact_numbers(given, scene, parameters):
    """Return what a kernel of any scene takes, with the scene's numbers of exact parameters."""
    numbers, memory, cell = (given[i].astype(object) for i in (1, 3, 4))
    found = zip(
        scene.module.PHASES,
        *(scene.numbers(what, parameters) for what in ("coefficients", "jumps", "events")),
        strict=True,
    )
    free = scene.numbers("coefficients", parameters)
    for p, ((_, held), equation, jump, event) in enumerate(found):
        row = [*equation[:5], *jump, *event[:4], *equation[5:], *event[4:]]
        first = 5 if held else 0
        numbers[p, first:] = row[first:]
        if held:  # its equation is that of a mass alone
            mass = next(
                q[0] for q, (_, h) in zip(free, scene.module.PHASES, strict=True) if not h
            )
            numbers[p, 0], numbers[p, 11 : 11 + len(equation) - 5] = mass, 0
    for i, value in enumerate(scene.numbers("memory", parameters)):
        memory[i] = value[:4]
    if scene.frequency is not None:
        names = [parameter.name for parameter in scene.parameters]
        cell[1] = parameters[names.index(scene.frequency)]
    if given[0][0, joints.OF_X] == joints.AT_BEGIN:
        x, v, constant = scene.numbers("start", parameters)
        numbers[0, joints.E_X : joints.E_0 + 1] = x, v, 0, constant
    return (given[0], numbers, given[2], memory, cell, *given[5:])


@pytest.mark.parametrize(("name", "row"), ROWS, ids=lambda q: q if isinstance(q, str) else "")
def test_solutions_have_the_digits_of_another_program(name, row) -> None:
    """From times of 5 digits; what mpmath found in 30, of the parameters in decimals."""
    kernel = kernel_of(name, KERNELS[row["kernel"]])
    parameters = CASES[name][2].split()
    cycles = (1,) if kernel.forced else ()
    cell = cell_of(scene_of(name), tuple(map(float, parameters)), *cycles)
    given = kernel.given(SimpleNamespace(cell=cell), row["order"])
    rough = np.array([float(f"{float(t):.5g}") for t in row["times"]])
    start = with_coefficients(kernel, given, kernel.size(row["order"]), rough)
    z = newton(kernel.iterate, given, start).unknowns

    def in_decimals(given, z, R):
        exact = with_exact_numbers(given, scene_of(name), tuple(map(arb, parameters)))
        residual_in_balls(kernel.residual)(exact, z, R)

    found = refine(kernel, given, z, 22, in_decimals)
    with ctx.workdps(40):
        for time, expected in zip(found, row["times"], strict=True):
            assert abs(time - arb(expected)) < arb("1e-20") * max(1, abs(float(expected)))


@pytest.mark.parametrize(("scene", "order"), [("impact", 26), ("elastic-plastic", 24)])
def test_the_exact_equations_agree_with_an_expansion_that_has_converged(scene, order) -> None:
    """Two systems that share no line: exponentials of matrices, and orthogonality."""
    orbit = solve_case(registry.load(scene)(), "ck-tau", order)
    kernel = registry.kernel(orbit.case.scene, "ck-tau")
    given = kernel.given(orbit.case, order)
    times = refine(kernel, given, orbit.unknowns, 22)
    exact = exact_orbit(orbit.case)
    cell = exact.case.cell
    judge = refine(exact_kernel(cell), cell, exact.outcome.unknowns, 22, exact_balls.residual)
    turn = 2 * np.pi
    for p, (one, other) in enumerate(zip(times, judge, strict=True)):
        off = float(one - other)
        off = off if p < len(cell.phases) else off - turn * round(off / turn)
        # the kernel's numbers and the cell's are rounded each in its own way
        assert abs(off) < 3e-16


def test_fractions_of_whole_numbers_are_exact() -> None:
    with ctx.workdps(50):
        assert float((quotient(1, 3) * 3 - 1).rad()) < 1e-49
        assert quotient(1.0, 2) == arb("0.5")
        assert float(quotient(arb(1), 3).rad()) < 1e-49


@pytest.mark.parametrize("x", ["0", "1e-9", "0.3", "7.5", "40"])
def test_the_spherical_bessel_functions_against_mpmath(x) -> None:
    with ctx.workdps(40), mp.workdps(40):
        found = np.full(9, None)
        spherical_bessel(arb(x), found)
        for n, value in enumerate(found):
            z = mp.mpf(x)
            expected = mp.sqrt(mp.pi / 2 / z) * mp.besselj(n + 0.5, z) if z else mp.mpf(n == 0)
            off = abs(value - arb(str(expected)))
            assert off < abs(arb(str(expected))) * arb("1e-20") + arb("1e-200")


def test_a_start_that_is_no_solution_is_refused_and_the_setting_restored() -> None:
    before = ctx.dps
    case = registry.load("impact")()
    kernel = registry.kernel(case.scene, "ck-tau")
    z = solve_case(case, "ck-tau", 6).unknowns.copy()
    z[-1] += 1.5
    with pytest.raises(PrecisionError, match="the refinement does not converge"):
        refine(kernel, kernel.given(case, 6), z, 22)
    assert ctx.dps == before


def test_a_wider_start_asks_for_more_digits_of_the_balls() -> None:
    """A thousand digits are not had with those that are carried for twenty."""
    case = registry.load("dry-friction")().of_motion("sliding")
    kernel = registry.kernel(case.scene, "ck-tau")
    orbit = attempt(kernel, case, 4, exact_orbit(case).times)
    given = kernel.given(case, 4)
    few, many = (refine(kernel, given, orbit.unknowns, d) for d in (20, 200))
    with ctx.workdps(230):
        assert abs(few[-1] - many[-1]) < arb("1e-19")
        assert float(many[-1].rad()) < 1e-199


def test_balls_that_are_too_wide_for_the_digits_asked_for_are_not_taken() -> None:
    """With ten digits carried, twenty are not found, however small the midpoints' residual."""
    case = registry.load("impact")()
    kernel = registry.kernel(case.scene, "ck-tau")
    z = solve_case(case, "ck-tau", 6).unknowns
    given = kernel.given(case, 6)
    J = jacobian(kernel, given, z)
    with ctx.workdps(10):
        own = residual_in_balls(kernel.residual)
        found = refining._refined(kernel, own, given, z, np.linalg.inv(J), 22)
    assert found is None
