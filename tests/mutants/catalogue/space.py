"""Mistakes in the modes of beams and strings: derivation, expansions, bounds, what is shown."""

from ..mutant import Mutant

DERIVED = ("tests/space/test_space_derivation.py",)
MATRICES = ("tests/space/test_space_matrices.py",)
REFERENCES = ("tests/space/test_space_references.py",)
CLAIMS = ("tests/space/test_space_claims.py",)
FILES, RESTORED = ("tests/space/test_space_files.py",), "src/nonsmooth/files/space/restored.py"
COMMANDS = ("tests/space/test_space_commands.py",)
SEVERAL = ("tests/results/test_plots_of_results.py",)


def _derivation(what: str, file: str, old: str, new: str) -> Mutant:
    return Mutant(what, f"codegen/space/{file}.py", old, new, DERIVED)


def _solver(what: str, file: str, old: str, new: str, tests: tuple[str, ...]) -> Mutant:
    return Mutant(what, f"solver/space/{file}.py", old, new, tests)


MUTANTS = (
    _derivation(
        "an inertia pulls the wrong way",
        "data",
        '"inertia": s * lam, "compliance": s}',
        '"inertia": -s * lam, "compliance": s}',
    ),
    _derivation(
        "the class is that of the felt derivative",
        "data",
        "        return 2 * self.m - 1 - self.felt",
        "        return 2 * self.m - 2 - self.felt",
    ),
    _derivation(
        "the hyperbolic part of a beam has the wrong sign",
        "green",
        "    return string(beta) * half, -hyperbolic * half",
        "    return string(beta) * half, hyperbolic * half",
    ),
    _derivation(
        "a forced mode adds half of its jumps to the rate",
        "collapse",
        "+ 4 * structure.m * K",
        "+ 2 * structure.m * K",
    ),
    _derivation(
        "the block of a tail has the next sums",
        "collapse",
        "lambda p, q: s[p + q] - lam * s[p + q + 1])",
        "lambda p, q: s[p + q] - lam * s[p + q])",
    ),
    _derivation(
        "the cosines of r_n^2 add where they subtract",
        "forced_modes",
        "    sign = -1 if structure.felt % 2 == 0 else 1",
        "    sign = 1",
    ),
    _solver(
        "a tail is summed from its second mode on",
        "expansions/sums",
        "np.sum((weights[N:] * (unit / bare[N:]) ** q)",
        "np.sum((weights[N + 1 :] * (unit / bare[N + 1 :]) ** q)",
        MATRICES,
    ),
    _solver(
        "the smooth part of a sum beyond the modes is left out",
        "expansions/beyond",
        " + np.exp(turned) * smooth",
        "",
        MATRICES,
    ),
    _solver(
        "the sums of a compliance begin with the first",
        "expansions/sums",
        "lower = attached.structure.lowest_sum",
        "lower = 1",
        MATRICES,
    ),
    _solver(
        "the right piece of a forced mode is not mirrored",
        "expansions/forced",
        "        right = (-1) ** (structure.felt + derivative) * right",
        "        right = (-1) ** structure.felt * right",
        MATRICES,
    ),
    _solver(
        "the pieces of a C2 series may jump in the second derivative",
        "expansions/pieces",
        "    for derivative in range(k - m + 1):",
        "    for derivative in range(k - m):",
        REFERENCES,
    ),
    _solver(
        "the function that jumps has a slope jump of two",
        "expansions/pieces",
        "        np.array([[-a * b / 2], [a * b / 2]]),",
        "        np.array([[-a * b / 2], [-a * b / 2]]),",
        MATRICES,
    ),
    _solver(
        "an upper bound is not widened by rounding",
        "eigenvalues/bounds",
        "    return roots.values + roots.rounding",
        "    return roots.values",
        REFERENCES,
    ),
    _solver(
        "the fixed node of the Radau quadrature has the weight of all",
        "eigenvalues/bounds",
        "moments[0] - weights.sum()",
        "moments[0]",
        REFERENCES,
    ),
    _solver(
        "bounds from below are given beyond the first sine left out",
        "eigenvalues/bounds",
        "    valid = (roots.values < attached.bare(np.array([N + 1]))[0]) & (low > 0)",
        "    valid = low > 0",
        MATRICES,
    ),
    _solver(
        "sines behind the attachment have the sign of even modes",
        "eigenvalues/exact",
        "_turned(-sign * sine, sign * cosine, self.offset * b)",
        "_turned(-sine, cosine, self.offset * b)",
        REFERENCES,
    ),
    _solver(
        "near zero and near an end the closed form is used in place of the sum",
        "eigenvalues/exact",
        "np.flatnonzero((origin * end < 1) & (origin <= HIGHEST))",
        "np.flatnonzero(origin < 0)",
        REFERENCES,
    ),
    _solver(
        "modes that are not felt are left out",
        "eigenvalues/secular",
        "    kept = index[~felt][:count]",
        "    kept = index[~felt][:0]",
        COMMANDS,
    ),
    _solver(
        "sines of a fraction are not reduced in whole numbers",
        "position",
        "    found = [_exact(int(k) * P % (2 * Q), Q) for k in n.ravel()]",
        "    found = [(np.sin(np.pi * k * P / Q), np.cos(np.pi * k * P / Q)) for k in n.ravel()]",
        REFERENCES,
    ),
    _solver(
        "the law of an inertia is that of a stiffness",
        "expansions/shapes",
        '        "inertia": attached.s * eigenvalue,',
        '        "inertia": attached.s,',
        CLAIMS,
    ),
    _solver(
        "a shape may fall from its first end",
        "expansions/shapes",
        "    if shape.values(np.zeros(1), 1)[0] < 0:",
        "    if shape.values(np.zeros(1), 1)[0] < -1e9:",
        MATRICES,
    ),
    _solver(
        "frequencies are angular",
        "mode",
        "self._attached.frequency_unit / (2 * math.pi)",
        "self._attached.frequency_unit",
        COMMANDS,
    ),
    _solver(
        "a derivative in metres is not divided by the length",
        "mode",
        "        return (found / length**derivative).reshape(places.shape)",
        "        return found.reshape(places.shape)",
        MATRICES,
    ),
    _solver(
        "a tolerance is met where nothing is proved",
        "modes",
        "    return abs(mode.error) if mode.proved_within is None else mode.proved_within",
        "    return 0.0 if mode.proved_within is None else mode.proved_within",
        COMMANDS,
    ),
    Mutant(
        "points of a family are floats, and nodes are missed",
        "src/nonsmooth/cli/space/vary.py",
        "Fraction(i, steps) for i in range(steps + 1)]",
        "Fraction(i * 0.999999 / steps) for i in range(steps + 1)]",
        COMMANDS,
    ),
    Mutant(
        "the picture shows the moment of the exact mode upside down",
        "src/nonsmooth/plots/modes.py",
        "    scale = sign / np.sqrt(np.mean(u**2))",
        "    scale = -sign / np.sqrt(np.mean(u**2))",
        COMMANDS,
    ),
    Mutant(
        "modes of other equations are loaded",
        RESTORED,
        "if found != mathematics(structure):",
        "if False:",
        FILES,
    ),
    Mutant(
        "an edited error of a mode goes unnoticed",
        RESTORED,
        "ERROR, MISMATCH = 1e-11, 1e-6",
        "ERROR, MISMATCH = 1e-8, 1e-6",
        FILES,
    ),
    Mutant(
        "an edited jump goes unnoticed",
        RESTORED,
        "ERROR, MISMATCH = 1e-11, 1e-6",
        "ERROR, MISMATCH = 1e-11, 1.0",
        FILES,
    ),
    Mutant(
        "a bound that is left out of a file goes unnoticed",
        RESTORED,
        "right = value is expected",
        "right = True",
        FILES,
    ),
    Mutant(
        "loaded modes have the bits of this machine",
        RESTORED,
        'eigenvalue=row["eigenvalue"],',
        "",
        FILES,
    ),
    Mutant(
        "loaded modes have the forced modes of the default",
        RESTORED,
        'forced if method == "ritz-ck" else None',
        "None",
        FILES,
    ),
    Mutant(
        "loaded modes are as many as the default",
        RESTORED,
        'document["order"], K, len(document["modes"]))',
        'document["order"], K, None)',
        FILES,
    ),
    Mutant(
        "the jump of a mode is not that of its shape",
        "solver/space/modes.py",
        "found = jump_mismatch(attached, shape, eigenvalue)",
        "found = jump_mismatch(attached, shape, 2 * eigenvalue)",
        ("tests/space/test_space_claims.py",),
    ),
    Mutant(
        "expansions of a netCDF file are not told apart",
        "src/nonsmooth/files/space/content.py",
        'columns["expansion"] += [place] * rows',
        'columns["expansion"] += [1] * rows',
        FILES,
    ),
    Mutant(
        "modes of several structures are one file",
        "src/nonsmooth/files/space/content.py",
        "if any(found.structure != structure for found in several):",
        "if False:",
        FILES,
    ),
    Mutant(
        "what is varied is twice in a table",
        "src/nonsmooth/files/space/documents.py",
        'if name != vary.replace("-", "_")]',
        "]",
        FILES,
    ),
    Mutant(
        "the exact mode is drawn with each expansion",
        "src/nonsmooth/plots/modes.py",
        "    if any(_is_same(line, x, values) for line in before):",
        "    if False:",
        SEVERAL,
    ),
    Mutant(
        "another exact mode is taken for one that is drawn",
        "src/nonsmooth/plots/modes.py",
        "    if any(_is_same(line, x, values) for line in before):",
        "    if before:",
        SEVERAL,
    ),
    Mutant(
        "each exact mode is in the legend",
        "src/nonsmooth/plots/modes.py",
        'label="_exact" if before else "exact"',
        'label="exact"',
        SEVERAL,
    ),
    Mutant(
        "the exact mode covers the expansions",
        "src/nonsmooth/plots/modes.py",
        '"zorder": 1.9',
        '"zorder": 2.1',
        SEVERAL,
    ),
)
