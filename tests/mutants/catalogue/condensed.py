"""Mistakes where each phase is solved for by itself: bands, what they leave, and its start."""

from ..mutant import Mutant

TESTS = ("tests/galerkin/test_condensed.py",)


def _solver(what: str, file: str, old: str, new: str) -> Mutant:
    return Mutant(what, f"solver/iteration/{file}.py", old, new, TESTS)


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
)
