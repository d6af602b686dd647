"""Mistakes where each phase is solved for by itself: bands, what they leave, and its start."""

from ..mutant import Mutant

TESTS = ("tests/galerkin/test_condensed.py",)


def _solver(what: str, file: str, old: str, new: str) -> Mutant:
    return Mutant(what, f"solver/iteration/{file}.py", old, new, TESTS)


def _order(what: str, old: str, new: str) -> Mutant:
    return Mutant(what, "codegen/emission/condensed/order.py", old, new, TESTS)


def _single(what: str, old: str, new: str) -> Mutant:
    tests = ("tests/scenes/test_single_unknown.py",)
    return Mutant(what, "solver/iteration/single.py", old, new, tests)


MUTANTS = (
    _solver("rows of a band are never exchanged", "bands", "entry > largest:", "entry < 0:"),
    _solver(
        "right sides are not exchanged with the rows",
        "bands",
        "b[p, i], b[p, pivot] = b[p, pivot], b[p, i]",
        "b[p, i], b[p, pivot] = b[p, i], b[p, pivot]",
    ),
    _solver(
        "columns are not exchanged with the rows",
        "bands",
        "B[p, i, c], B[p, pivot, c] = B[p, pivot, c], B[p, i, c]",
        "B[p, i, c], B[p, pivot, c] = B[p, i, c], B[p, pivot, c]",
    ),
    _solver(
        "the last coefficients of a phase are left out of its rows",
        "condensed",
        "right[p, pad + i] -= diagonals[p, pad + i, pad + j - i] * z[at + j]",
        "right[p, pad + i] -= 0.0 * z[at + j]",
    ),
    _solver(
        "and out of their derivatives",
        "condensed",
        "slopes[p, pad + i, place + j - size] -= diagonals[p, pad + i, pad + j - i]",
        "slopes[p, pad + i, place + j - size] -= 0.0",
    ),
    _solver(
        "the norm of the whole residual is not formed",
        "condensed",
        "            norm = abs(value)",
        "            norm = 0.0",
    ),
    _solver(
        "a column that adds nothing is divided by",
        "linear",
        "if square <= NOTHING * NOTHING:",
        "if square < 0:",
    ),
    Mutant(
        "a band is condensed whatever its diagonal",
        "codegen/emission/condensed/bands.py",
        "return main != 0 and all(",
        "return True or all(",
        ("tests/galerkin/test_condensed.py::test_only_bands_that_can_be_eliminated",),
    ),
    Mutant(
        "the joints see one unknown of a band less than they do",
        "codegen/emission/condensed/writer.py",
        "q.index - band.block.first + 1 for q in terms",
        "q.index - band.block.first for q in terms",
        ("tests/galerkin/test_condensed.py::test_only_bands_that_can_be_eliminated",),
    ),
    _order(
        "what a band depends on is overlooked",
        "return found\n\n\ndef _first",
        "return set()\n\n\ndef _first",
    ),
    _order(
        "an unknown that others see is left for the end",
        "if len(seeing) == 1 and unknown",
        "if seeing and unknown",
    ),
    _order(
        "nothing is given before",
        "return found\n    return None\n\n\ndef _last",
        "return None\n    return None\n\n\ndef _last",
    ),
    _order(
        "what is not linear is solved as if it were",
        "if by_time(slope, unknown, system.tables) != 0:",
        "if False:",
    ),
    _order(
        "the sign of what is given is lost", "factored(-rest / slope)", "factored(rest / slope)"
    ),
    _solver(
        "the rest of a band is not filled in",
        "condensed",
        "        for i in range(reach, size):\n            z[at + i]",
        "        for i in range(size, size):\n            z[at + i]",
    ),
    _solver(
        "rows that were exchanged are not followed down",
        "bands",
        "0 if wide else ABOVE",
        "ABOVE",
    ),
    _single("the slope at the first point is left out", "1.0 / J[0, 0]", "0.0"),
    _single(
        "the first point counts once",
        "points[1] = value, value",
        "points[1] = value, 2 * value",
    ),
    _single(
        "factors of the product keep their sign", "product *= -points", "product *= points"
    ),
    _single("corrections may grow", "FAST = 0.25", "FAST = 25.0"),
    _single("a duration may take any step", "    if DURATIONS:\n", "    if False:\n"),
    _single(
        "a phase may take any step",
        "    if FORCED:\n        return min",
        "    if False:\n        return min",
    ),
    _single("it ends a correction too early", "if ahead <= ROUNDOFF:", "if ahead <= 1e-9:"),
    _single(
        "the last correction is not added",
        "                y[0] += following\n                residual",
        "                residual",
    ),
    _single(
        "nothing is evaluated after the last correction",
        "y[0] += following\n                residual(work, y, R)\n",
        "y[0] += following\n",
    ),
    _order(
        "a parameter that may vanish is divided by",
        "and not slope.is_nonzero:",
        "and slope.is_zero:",
    ),
    _order(
        "what cancels is formed",
        "tuple(unknowns), _put_in(after))",
        "tuple(unknowns), tuple(after))",
    ),
    _single(
        "points are kept of a step that was cut",
        "        if damping < 1:\n",
        "        if False:\n",
    ),
    _single(
        "a step that reduces nothing is taken",
        "abs(R[0]) <= (1 - damping / 4) * abs(value) or",
        "True or",
    ),
    _single("a slope of zero is divided by", "if J[0, 0] == 0:", "if False:"),
)
