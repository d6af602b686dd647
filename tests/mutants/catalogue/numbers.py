"""Mistakes in what the numbers claim: the twin, estimates, errors, choices, rates."""

from ..mutant import Mutant

TWIN, SHARP = "src/nonsmooth/shortcuts/twin.py", ("tests/accuracy/test_precise_errors.py",)
ESTIMATE, ESTIMATES = (
    "solver/shortcuts/accuracy/estimate.py",
    ("tests/accuracy/test_estimate.py",),
)
CHOSEN = ("tests/accuracy/test_choice.py",)

MUTANTS = (
    Mutant(
        "high precision without guard digits",
        TWIN, "GUARD = 25", "GUARD = 0", SHARP,
        equivalent="a first guess: the balls ask for more where it does not suffice",
    ),
    Mutant(
        "the estimate without its doubt",
        ESTIMATE, "doubt = np.abs(beyond[1][-2:] - near[1][-2:])", "doubt = np.zeros(2)",
        ESTIMATES,
    ),
    Mutant(
        "an error is shown whatever its ball",
        TWIN, "value.rel_accuracy_bits() > (digits + 1) * math.log2(10)", "digits > 0", SHARP,
    ),
    Mutant(
        "the ball of a time without its last step",
        TWIN, "radius = (length + rounding).upper()", "radius = rounding.upper()", SHARP,
    ),
    Mutant(
        "too wide balls are not refined again",
        TWIN, "if not rounding < goal / 10:", "if False:", SHARP,
    ),
    Mutant(
        "fractions in float64",
        TWIN, "arb(fmpq(p, q))", "arb(int(p) / int(q))", ("tests/accuracy/test_twin.py",),
    ),
    Mutant(
        "the difference of the frictions in float64",
        TWIN, "(arb(belt.mu_s) - arb(belt.mu_k))", "arb(belt.mu_s - belt.mu_k)", SHARP,
    ),
    Mutant(
        "an error relative to the orbit instead of the exact one",
        TWIN, "(twin.T - T) / T", "(twin.T - T) / twin.T", SHARP,
    ),
    Mutant(
        "parameters in few digits",
        TWIN, "precision(2 * digits + 100)", "precision(60)", SHARP,
    ),
    Mutant(
        "the setting of flint stays changed",
        TWIN, "ctx.dps = before", "ctx.dps = digits",
        ("tests/accuracy/test_twin.py::test_the_setting_of_flint_is_restored",),
    ),
    Mutant(
        "a refinement that diverges goes on",
        TWIN, "if not length < 4 * shortest:", "if False:",
        ("tests/accuracy/test_twin.py::test_a_start_that_is_no_orbit_is_refused",),
    ),
    Mutant(
        "waves of the twin turn the wrong way",
        "codegen/shortcuts/precise.py", "[sin(x) for x in turns]", "[-sin(x) for x in turns]",
        ("tests/accuracy/test_twin.py",),
    ),
    Mutant(
        "whole fractions only where they have a name",
        "codegen/shortcuts/precise.py", 'return f"rational({expr.p}, {expr.q})"',
        'return f"{float(expr)}"', ("tests/accuracy/test_twin.py",),
    ),
    Mutant(
        "the estimate without rounding",
        ESTIMATE, " + doubt + rounding", " + doubt", ESTIMATES,
    ),
    Mutant(
        "the estimate without what Newton's method left",
        ESTIMATE, "(ROUNDING + CORRECTIONS * outcome.correction)", "ROUNDING", ESTIMATES,
    ),
    Mutant(
        "the estimate of (22) without its floor",
        ESTIMATE, "acceleration=acceleration + jumps", "acceleration=acceleration", ESTIMATES,
    ),
    Mutant(
        "a spurious solution counts as the better orbit",
        ESTIMATE, "sound = outcome.converged and abs(t1 / (2 * alpha) - 1) <= 1 / (2 * order)",
        "sound = outcome.converged", ESTIMATES,
    ),
    Mutant(
        "a second turn counts as the better orbit",
        ESTIMATE, "if sound and T - t1 <= 2 * math.pi * (1 + 1 / order) else", "if sound else",
        ESTIMATES,
    ),
    Mutant(
        "phases aligned, each weighed by its own time",
        "solver/shortcuts/accuracy/errors.py", "duration = exact_end - exact_start", "duration = end - start",
        ("tests/accuracy/test_errors.py",),
    ),
    Mutant(
        "the error of the period without its sign",
        "solver/shortcuts/accuracy/errors.py", "period=float((T - exact_T) / exact_T)",
        "period=float(abs(T - exact_T) / exact_T)", ("tests/accuracy/test_numbers.py",),
    ),
    Mutant(
        "one of the two jumps of (22) is integrated across",
        "solver/shortcuts/accuracy/quadrature.py", "[found.t1 / found.T, reference.t1 / reference.T]",
        "[found.t1 / found.T]", ("tests/accuracy/test_numbers.py",),
    ),
    Mutant(
        "at the start of slip the acceleration of stick",
        "solver/shortcuts/orbit/exact.py", "np.where(t < t1,", "np.where(t <= t1,", ("tests/solving/test_orbits.py",),
    ),
    Mutant(
        "the exact slip with a minus",
        "solver/shortcuts/orbit/exact.py", "(alpha * cos + sin,", "(alpha * cos - sin,",
        ("tests/solving/test_exact.py",),
    ),
    Mutant(
        "the whole tolerance is used up",
        "solver/trade/not_certified.py", "MARGIN = 0.9", "MARGIN = 1.0", CHOSEN,
    ),
    Mutant(
        "one tolerance of two is enough",
        "solver/shortcuts/choice/tolerance.py", "if all(getattr(estimate", "if any(getattr(estimate",
        ("tests/accuracy/test_tolerance.py",),
    ),
    Mutant(
        "orders that would do are passed over",
        "solver/shortcuts/choice/tolerance.py", "EARLY = 0.7", "EARLY = 1.4", CHOSEN,
    ),
    Mutant(
        "what is hopeless is tried",
        "solver/shortcuts/choice/tolerance.py", "() if hopeless else _candidates(names)", "_candidates(names)",
        CHOSEN,
    ),
    Mutant(
        "a budget is overdrawn",
        "solver/shortcuts/choice/budget.py", "if seconds > budget:", "if seconds > 2 * budget:",
        ("tests/accuracy/test_tolerance.py",),
    ),
    Mutant(
        "the worst within the budget",
        "solver/shortcuts/choice/budget.py", "orbit.estimate.period < best.estimate.period",
        "orbit.estimate.period > best.estimate.period", ("tests/accuracy/test_tolerance.py",),
    ),
    Mutant(
        "rounding has a rate",
        "solver/shortcuts/accuracy/convergence.py", "            floor,\n", "            0.0,\n",
        ("tests/accuracy/test_convergence.py",),
    ),
    Mutant(
        "sums beyond the harmonics begin one late",
        "solver/shortcuts/series/tail_sums.py", "np.exp(1j * (N + 1) * x)", "np.exp(1j * N * x)",
        ("tests/solving/test_tail_sums.py",),
    ),
)  # fmt: skip
