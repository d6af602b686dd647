"""Mistakes in what saves work: closed integrals, tables of both waves, Jacobians used again, and
in what is timed."""

from ..mutant import Mutant

RUNTIME = ("tests/galerkin/test_runtime.py",)
TEXT = ("tests/galerkin/test_kernel_text.py",)
ITERATION = ("tests/scenes/test_iteration_scenes.py",)
ADMISSIBLE = ("tests/scenes/test_admissible_scenes.py",)
ROWS = (
    "tests/galerkin/test_rows.py::test_the_residual_is_the_quadrature_of_the_equation_of_motion"
)


def _row(pair: str) -> tuple[str, ...]:
    return (f"{ROWS}[{pair}]",)


def _runtime(what: str, file: str, old: str, new: str) -> Mutant:
    return Mutant(what, f"codegen/emission/runtime/{file}.py", old, new, RUNTIME)


def _emission(what: str, file: str, old: str, new: str, tests: tuple[str, ...]) -> Mutant:
    return Mutant(what, f"codegen/emission/{file}.py", old, new, tests)


def _solver(what: str, file: str, old: str, new: str, tests: tuple[str, ...]) -> Mutant:
    return Mutant(what, f"solver/{file}.py", old, new, tests)


def _benchmark(what: str, file: str, old: str, new: str) -> Mutant:
    return Mutant(what, f"benchmarks/{file}.py", old, new, ("tests/speed/test_benchmarks.py",))


MUTANTS = (
    _runtime(
        "derivatives of functions with a break are formed for a residual",
        "breaks",
        "found = np.zeros((phases, 1 + phases if rates else 1, size, size))",
        "found = np.zeros((phases, 1 + phases, size, size))",
    ),
    _runtime(
        "integrals of breaks do not move with their angle",
        "breaks",
        "for l in range(n + 1 if rows > 1 else 0):",
        "for l in range(n + 1 if rows > 9 else 0):",
    ),
    _emission(
        "closed forms of breaks have their derivatives where none are wanted",
        "kernel",
        '"if rates:",',
        '"if not rates:",',
        RUNTIME,
    ),
    _benchmark(
        "kernels of forced scenes are timed without the cycles",
        "scenes",
        "numbers = case.arguments if own",
        "numbers = case.numbers if own",
    ),
    _benchmark(
        "harmonic balance by hand is damped the wrong way",
        "every_scene/aft",
        "c * n * Omega, -c * n * Omega",
        "-c * n * Omega, c * n * Omega",
    ),
    _benchmark(
        "Newton's method on the return map steps the angle the wrong way",
        "every_scene/return_map",
        "(c * R1 - a * R2) / (a * d - b * c)",
        "(a * R2 - c * R1) / (a * d - b * c)",
    ),
    _benchmark(
        "a simulated half period is not mirrored",
        "every_scene/simulated",
        "seen, state = settled, cell.sign * state",
        "seen, state = settled, 1 * state",
    ),
    _runtime(
        "a multiple of an angle turned back by its rest",
        "harmonics",
        "s * near_c + c * near_s",
        "s * near_c - c * near_s",
    ),
    _runtime(
        "integrals of harmonics: a phase moves with its own duration",
        "harmonics",
        "(1.0 if p > q else 0.0)",
        "(1.0 if p >= q else 0.0)",
    ),
    _runtime(
        "integrals of sines are even in the harmonic",
        "harmonics",
        "value if wave == 0 else -value",
        "value",
    ),
    _runtime(
        "the moments of the turned wave turned the other way",
        "moments",
        "ahead = -s if turn == 0",
        "ahead = s if turn == 0",
    ),
    _runtime(
        "the integral of a Legendre series does not begin at zero",
        "phases",
        "found[0] += half[0]",
        "found[0] -= half[0]",
    ),
    Mutant(
        "odd harmonics taken for orthogonal over half a period",
        "codegen/galerkin/harmonics.py",
        "if self.odd and any(",
        "if not self.odd and any(",
        ("tests/galerkin/test_references.py",),
    ),
    Mutant(
        "a harmonic meets its mirror image in place of itself",
        "codegen/galerkin/harmonics.py",
        "            if root.is_positive:",
        "            if root.is_negative:",
        _row("S1-hb"),
    ),
    _emission(
        "the term of a harmonic with itself is lost",
        "orthogonal",
        "single = equal.xreplace({running: index}) if deltas else sp.Integer(0)",
        "single = sp.Integer(0)",
        _row("S1-hb"),
    ),
    _emission(
        "an unknown beyond the last is read",
        "loops",
        'return "" if room.is_nonnegative else below',
        'return ""',
        _row("S1-ck_tau"),
    ),
    _emission(
        "the residual forms derivatives that it does not use",
        "kernel",
        '"rates = False"',
        '"rates = True"',
        TEXT,
    ),
    _solver(
        "a Jacobian for every step",
        "iteration/iteration",
        "FAST = 0.125",
        "FAST = 0.0",
        ITERATION,
    ),
    _solver(
        "a Jacobian is used again where corrections no longer shrink",
        "iteration/iteration",
        "FAST = 0.125",
        "FAST = 0.95",
        ITERATION,
    ),
    _solver(
        "the last correction is not taken",
        "iteration/iteration",
        "add(z, 1.0, following, z)",
        "add(z, 0.0 if converged else 1.0, following, z)",
        ITERATION,
    ),
    _solver(
        "the sizes of displacement and velocity are exchanged",
        "orbit/motion",
        "rows = (self.part(p, LOOK, 0), self.part(p, LOOK, 1), cosine)",
        "rows = (self.part(p, LOOK, 1), self.part(p, LOOK, 0), cosine)",
        ADMISSIBLE,
    ),
    _solver(
        "small coefficients of an interpolant are taken for rounding",
        "orbit/chebyshev",
        "ROUNDING = 1e-14",
        "ROUNDING = 1e-2",
        ADMISSIBLE,
    ),
)
