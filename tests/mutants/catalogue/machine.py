"""Mistakes in the symbolic machine: scenes, conditions, expansions, the text of kernels."""

from ..mutant import Mutant

UNITS = ("tests/scene/test_scene_units.py",)
CHECKS = ("tests/scene/test_scene_checks.py",)
CLASSES = ("tests/scene/test_smoothness.py",)
NUMBERS = ("tests/scene/test_scene_numbers.py",)
SERIES = ("tests/galerkin/test_phase_series.py",)
RUNTIME = ("tests/galerkin/test_runtime.py",)
TEXT = ("tests/galerkin/test_kernel_text.py",)
ROWS = (
    "tests/galerkin/test_rows.py::test_the_residual_is_the_quadrature_of_the_equation_of_motion"
)
RATES = "tests/galerkin/test_rows.py::test_the_jacobian_is_the_derivative_of_the_residual"


def _row(pair: str) -> tuple[str, ...]:
    return (f"{ROWS}[{pair}]",)


def _scene(what: str, file: str, old: str, new: str, tests: tuple[str, ...]) -> Mutant:
    return Mutant(what, f"codegen/scene/{file}.py", old, new, tests)


def _conditions(what: str, file: str, old: str, new: str, tests: tuple[str, ...]) -> Mutant:
    return Mutant(what, f"codegen/galerkin/{file}.py", old, new, tests)


def _expansion(what: str, file: str, old: str, new: str, tests: tuple[str, ...]) -> Mutant:
    return Mutant(what, f"codegen/expansions/{file}.py", old, new, tests)


def _emission(what: str, file: str, old: str, new: str, tests: tuple[str, ...]) -> Mutant:
    return Mutant(what, f"codegen/emission/{file}.py", old, new, tests)


ONCE = ("tests/galerkin/test_class_one.py",)

MUTANTS = (
    _conditions(
        "for class C^1 the second highest coefficient vanishes, not the highest",
        "polynomials",
        "q.count - 1 - (found[p].k - order)",
        "q.count - 1 - order + 1",
        ONCE,
    ),
    _conditions(
        "functions of class C^1 are made of tests that belong to another class",
        "polynomials",
        "if not (smoother and same)",
        "if not smoother",
        ONCE,
    ),
    _emission(
        "the rows for class C^1 are counted without those of the tests",
        "class_one",
        "row += condition.count",
        "row += 1",
        ONCE,
    ),
    _emission(
        "the Jacobian for class C^1 keeps the row of the continuity that it drops",
        "class_one",
        '"    J[row, :] = 0.0", ',
        "",
        ONCE,
    ),
    _scene(
        "what stands below the slash of a unit stands above it",
        "units",
        "*((-1, each) for each in below)",
        "*((1, each) for each in below)",
        UNITS,
    ),
    _scene(
        "terms of different units may be added",
        "units",
        "        if found != expected:",
        "        if not found:",
        UNITS,
    ),
    _scene(
        "the modulus bounds one side alone",
        "linear",
        "        for sign in (1, -1)",
        "        for sign in (1, 1)",
        CHECKS,
    ),
    _scene(
        "a modulus above a bound is taken for one below",
        "linear",
        "or not weight.is_nonpositive:",
        "or weight.is_zero:",
        CHECKS,
    ),
    _scene(
        "an event of parameters alone is let pass",
        "phases",
        "if row.x == row.v == row.cos == 0:",
        "if row.x == row.v == row.cos == 1:",
        CHECKS,
    ),
    _scene(
        "a phase that leads into a held one has the other sign over half a period",
        "phases",
        "sign * sp.sympify(after.held)",
        "sp.sympify(after.held)",
        CHECKS,
    ),
    _scene(
        "the time may stand in an equation",
        "error",
        "if times:",
        "if False:",
        CHECKS,
    ),
    _scene(
        "a parameter may be called like an unknown",
        "names",
        " or any(re.fullmatch(q, name) for q in patterns)",
        "",
        CHECKS,
    ),
    _scene(
        "the class forgets that a mirrored force is mirrored",
        "smoothness",
        "sign * q.f / q.m",
        "q.f / q.m",
        CLASSES,
    ),
    _scene(
        "the class forgets the velocity of a held mass",
        "smoothness",
        "    if left.held is not None:",
        "    if left.held == 0:",
        CLASSES,
    ),
    _scene(
        "the class forgets the event",
        "smoothness",
        "sign * event.v, event.constant, sign * event.cos",
        "sign * event.v, event.constant, event.cos",
        CLASSES,
    ),
    _scene(
        "the unit of length is a velocity",
        "scales",
        "sp.Abs(phase.g) * time**2 / mass",
        "sp.Abs(phase.g) * time / mass",
        NUMBERS,
    ),
    _emission(
        "the law of an impact with constant and factor exchanged",
        "scene_functions",
        "return row.v, row.constant",
        "return row.constant, row.v",
        NUMBERS,
    ),
    _emission(
        "a demand without the displacement",
        "scene_functions",
        "return [state_row(part, what, memory).coefficients for",
        "return [(0, *state_row(part, what, memory).coefficients[1:]) for",
        NUMBERS,
    ),
    _conditions(
        "half a period taken for a period",
        "times",
        "self.cell if self.sign == 1 else 2 * self.cell",
        "self.cell",
        _row("S6-hb"),
    ),
    _conditions(
        "derivatives of the moments without their neighbours above",
        "tables",
        "near = (degree + 1) * other[(degree + 1, *rest)]",
        "near = degree * other[(degree + 1, *rest)]",
        (f"{RATES}[S1-ck_tau]",),
    ),
    _conditions(
        "derivatives of the moments of the turned wave with the other sign",
        "tables",
        "rate_of(odd, 1), rate_of(even, -1)",
        "rate_of(odd, 1), rate_of(even, 1)",
        SERIES,
    ),
    _conditions(
        "derivatives by a time without the tables of another",
        "tables",
        "total += weight * looked_up[entry.base].rate(entry.indices, time)",
        "total += looked_up[entry.base].rate(entry.indices, time)",
        TEXT,
    ),
    _conditions(
        "displacement continuous without the sign of half a period",
        "closure",
        "start(p, 0) - sign * end(left, 0)",
        "start(p, 0) - end(left, 0)",
        _row("S6-ck_tau"),
    ),
    _conditions(
        "one derivative less is continuous",
        "closure",
        "range(2, switch.k + 1 if not held else 2)",
        "range(2, switch.k if not held else 2)",
        _row("S4a-ck"),
    ),
    _conditions(
        "half a period as long as one of the forcing",
        "times",
        "turns = sp.pi if self.sign == -1 else 2 * sp.pi",
        "turns = 2 * sp.pi",
        _row("S3b-ck_tau"),
    ),
    _conditions(
        "the integral of the constant begins with the other sign",
        "legendre",
        "below = -series(sp.Integer(0)) if l == 0",
        "below = series(sp.Integer(0)) if l == 0",
        SERIES,
    ),
    _conditions(
        "derivatives where a phase begins have the sign of those where it ends",
        "legendre",
        "(-1) ** (n + q)",
        "(-1) ** n",
        SERIES,
    ),
    _conditions(
        "the test functions of a phase are not normalised",
        "polynomials",
        "/ (2 * degree + 1)\n",
        "\n",
        _row("S1-ck"),
    ),
    _conditions(
        "harmonics that are even over half a period",
        "harmonics",
        "return 2 * index - 1 if self.odd else index",
        "return 2 * index if self.odd else index",
        _row("S6-hb"),
    ),
    _conditions(
        "damping integrated without the frequency",
        "harmonics",
        '"c": 1,',
        '"c": 0,',
        _row("S5a-hb"),
    ),
    _conditions(
        "a break that jumps down",
        "breaks",
        "return -sp.bernoulli(n, u)",
        "return sp.bernoulli(n, u)",
        _row("S2b-hb_ck_1"),
    ),
    _conditions(
        "only the last part counts of what multiplies an unknown",
        "weights",
        "found.setdefault(symbol, []).append(weight)",
        "found[symbol] = [weight]",
        TEXT,
    ),
    _expansion(
        "an impulse with the other sign",
        "hb",
        "expression -= mass * jump(found, p) * at",
        "expression += mass * jump(found, p) * at",
        _row("S1-hb"),
    ),
    _expansion(
        "the jump of a derivative with the force, not with its derivative",
        "hb_ck",
        "phase.f if order == 2 else sp.Integer(0)",
        "phase.f",
        _row("S5a-hb_ck_2"),
    ),
    _expansion(
        "the forcing differentiated once too often",
        "hb_ck",
        "(order - 2) * sp.pi / 2",
        "(order - 1) * sp.pi / 2",
        _row("S3b-hb_ck_1"),
    ),
    _emission(
        "rows that are sums alone begin with what was there",
        "loops",
        'else ["R[row] = 0.0"]',
        'else ["R[row] += 0.0"]',
        _row("S3b-hb"),
    ),
    _emission(
        "the order of half a period is rounded down",
        "kernel",
        '"N = (order + 1)//2"',
        '"N = order//2"',
        TEXT,
    ),
    _emission(
        "what an assignment needs is left out",
        "used",
        'words.update(re.findall(r"\\w+", line.partition(" = ")[2]))',
        "words.update(())",
        TEXT,
    ),
    _emission(
        "the ratios of Bessel functions begin too low",
        "runtime/moments",
        "while left > 1e-18:",
        "while left > 1e-2:",
        RUNTIME,
    ),
    _emission(
        "integrals of harmonics: the length of the period is forgotten",
        "runtime/harmonics",
        "found[wave, row, k] -= power / cell * found[wave, 0, k]",
        "found[wave, row, k] -= 0.0",
        RUNTIME,
    ),
    _emission(
        "a series has the velocity after the impact before it",
        "runtime/harmonics",
        "- ends / 2 * (u == 1)",
        "+ ends / 2 * (u == 1)",
        RUNTIME,
    ),
    _emission(
        "integrals of breaks: a phase does not grow with its own duration",
        "runtime/breaks",
        "own = rho[0, l] * even[l] if r == q else 0.0",
        "own = 0.0",
        RUNTIME,
    ),
    _emission(
        "a break keeps its sign over half a period",
        "runtime/breaks",
        "(1.0 if after else sign)",
        "1.0",
        RUNTIME,
    ),
    _emission(
        "the displacement of a phase integrated over twice the time",
        "runtime/phases",
        "integrated(integrated(parts))",
        "2 * integrated(integrated(parts))",
        RUNTIME,
    ),
)
