"""Mistakes in what is derived: scenes, conditions, expansions, and the text of kernels."""

from ..mutant import Mutant

ROWS = (
    "tests/galerkin/test_rows.py::test_the_residual_is_the_quadrature_of_the_equation_of_motion"
)
RATES = "tests/galerkin/test_rows.py::test_the_jacobian_is_the_derivative_of_the_residual"
CLASSES = ("tests/scene/test_smoothness.py",)
NUMBERS = ("tests/scene/test_scene_numbers.py",)
SALTATION = ("tests/scene/test_saltation.py",)
SERIES = ("tests/galerkin/test_phase_series.py",)
RUNTIME = "tests/kernels/test_tables.py"
SHOWN = "tests/equations/test_shown_equations.py"
CLOSED = f"{SHOWN}::test_the_closed_forms_are_the_rows_of_the_kernel"
SIDES = f"{SHOWN}::test_both_sides_of_each_equation_agree"

MUTANTS = (
    Mutant(
        "the friction force with the other sign",
        "codegen/scenes/dry_friction.py",
        "- mu_k * F_N - F * forcing",
        "+ mu_k * F_N - F * forcing",
        (
            "tests/scenes/test_shipped_scenes.py::test_amplitude_of_sliding_is_that_of_den_hartog",
        ),
        regenerate=True,
    ),
    Mutant(
        "the law of an impact with constant and factor exchanged",
        "codegen/emission/scene_functions.py",
        "[after[place(scene, velocity)], after[3]]",
        "[after[3], after[place(scene, velocity)]]",
        NUMBERS,
    ),
    Mutant(
        "the class forgets that a mirrored force is mirrored",
        "codegen/scene/smoothness.py",
        "sign * q.f / q.m",
        "q.f / q.m",
        CLASSES,
    ),
    Mutant(
        "the memory of the cell before without its sign",
        "codegen/scene/data.py",
        "= self.sign * memory.symbol",
        "= memory.symbol",
        ("tests/scene/test_scene_motions.py",),
    ),
    Mutant(
        "the delay of a perturbed event with the other sign",
        "codegen/scene/saltation.py",
        "behind = law.jacobian(state) * moved - rates_after * delay",
        "behind = law.jacobian(state) * moved + rates_after * delay",
        SALTATION,
    ),
    Mutant(
        "half a period as long as one of the forcing",
        "codegen/galerkin/condition.py",
        "turn = sp.pi if self.sign == -1 else 2 * sp.pi",
        "turn = 2 * sp.pi",
        (f"{SIDES}[elastic-plastic-ck-tau]",),
    ),
    Mutant(
        "the forcing is the first harmonic whatever the cycles",
        "codegen/galerkin/harmonics.py",
        "turned = cycles * angle",
        "turned = angle",
        (f"{ROWS}[S1n2-hb]",),
        regenerate=True,
    ),
    Mutant(
        "closure: displacement continuous without the sign of half a period",
        "codegen/galerkin/closure.py",
        "start(p, 0) - sign * end(left, 0)",
        "start(p, 0) - end(left, 0)",
        (f"{CLOSED}[elastic-plastic-ck-tau]",),
    ),
    Mutant(
        "closure: one derivative less is continuous",
        "codegen/galerkin/closure.py",
        "range(2, switch.k + 1 if not held else 2)",
        "range(2, switch.k if not held else 2)",
        (f"{CLOSED}[elastic-plastic-ck-tau]",),
    ),
    Mutant(
        "a break that jumps down",
        "codegen/galerkin/harmonics.py",
        "return -sp.bernoulli(n, u)",
        "return sp.bernoulli(n, u)",
        (f"{ROWS}[S2b-hb_ck_1]",),
        regenerate=True,
    ),
    Mutant(
        "the test functions of a phase are not normalised",
        "codegen/galerkin/polynomials.py",
        " / (2 * degree + 1)\n",
        "\n",
        (f"{CLOSED}[impact-ck]",),
    ),
    Mutant(
        "the integral of the constant begins with the other sign",
        "codegen/galerkin/legendre.py",
        "below = -series(sp.Integer(0)) if l == 0",
        "below = series(sp.Integer(0)) if l == 0",
        SERIES,
    ),
    Mutant(
        "derivatives of the moments without their neighbours above",
        "codegen/galerkin/legendre.py",
        "neighbours = (l + 1) * turned[l + 1]",
        "neighbours = l * turned[l + 1]",
        (f"{RATES}[S1-ck_tau]",),
        regenerate=True,
    ),
    Mutant(
        "an impulse with the other sign",
        "codegen/expansions/hb.py",
        "expression -= mass * jump(cell_switches, p) * at",
        "expression += mass * jump(cell_switches, p) * at",
        (f"{CLOSED}[impact-hb]",),
    ),
    Mutant(
        "the jump of a derivative with the force, not with its derivative",
        "codegen/galerkin/closure.py",
        "phase.f if order == 2 else sp.Integer(0)",
        "phase.f",
        (f"{SHOWN}::test_so_they_are_with_several_functions_a_switch",),
    ),
    Mutant(
        "the ratios of Bessel functions begin too low",
        "solver/rows/moments.py",
        "while left > 1e-18:",
        "while left > 1e-2:",
        (f"{RUNTIME}::test_few_and_many_spherical_bessel_functions",),
    ),
    Mutant(
        "the velocity after an impact is the gain with the other sign",
        "solver/rows/joints.py",
        "- sign * rho * gained[p, 1]",
        "+ sign * rho * gained[p, 1]",
        (f"{ROWS}[S1-ck_tau]",),
    ),
)
