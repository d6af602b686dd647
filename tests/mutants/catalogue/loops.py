"""Mistakes in the loops of the generated kernels; each is generated anew."""

from ..mutant import Mutant

REDUCED = ("tests/derivation/test_c1_reduced.py",)
BANDS, BANDED = "codegen/shortcuts/loops/c1_bands.py", ("tests/derivation/test_c1_bands.py",)
KERNELS, SYMMETRIC = (
    ("tests/derivation/test_kernels.py",),
    ("tests/derivation/test_symmetric.py",),
)


def _mutant(what: str, file: str, old: str, new: str, tests: tuple[str, ...]) -> Mutant:
    return Mutant(what, file, old, new, tests, regenerate=True)


MUTANTS = (
    _mutant(
        "too long a slip is accepted in a batch",
        "codegen/shortcuts/loops/c1_reduced.py", " and 0 < s <= 2 * pi * (1 + allowed))", ")", REDUCED,
    ),
    _mutant(
        "any end of stick is accepted in a batch",
        "codegen/shortcuts/loops/c1_reduced.py", "abs(t1 / (2 * alpha) - 1) <= allowed and ", "", REDUCED,
    ),
    _mutant(
        "pivots are looked for in one row less",
        BANDS, "last = min(j + 4, n - 1)", "last = min(j + 3, n - 1)", BANDED,
    ),
    _mutant(
        "the largest pivot is not taken",
        BANDS, "if abs(M[i, j - i + 4]) > abs(M[pivot, j - pivot + 4]):", "if False:", BANDED,
    ),
    _mutant(
        "the step of T with another sign",
        BANDS, "(a11 * b2 - a21 * b1)", "(a21 * b1 - a11 * b2)", BANDED,
    ),
    _mutant(
        "(18) by T is (18) by t1",
        "codegen/shortcuts/loops/c1.py", "J[k, -1] = project(k, rho[2])", "J[k, -1] = project(k, rho[1])",
        KERNELS,
    ),
    _mutant(
        "slip the other way has the same parts",
        "codegen/shortcuts/loops/c1_orbits.py", "p[k] = -p[k]", "p[k] = p[k]", ("tests/families/test_family.py",),
    ),
    _mutant(
        "S_-k like C_-k",
        "codegen/shortcuts/loops/fourier.py", "S[i, -k] = -S[i, k]", "S[i, -k] = S[i, k]", KERNELS,
    ),
    Mutant(
        "(14) by the mean, not halved",
        "codegen/shortcuts/loops/hb_c1.py",
        "J[-3, 0] = 0.5 * h[0, 0]",
        "J[-3, 0] = h[0, 0]",
        KERNELS,
        regenerate=True,
        equivalent="the tail is odd about mid-slip, and so its integral over slip is zero",
    ),
    _mutant(
        "(14) by the harmonics without its symmetry",
        "codegen/shortcuts/loops/hb_c1.py",
        "        J[-3, i] = h[0, i]",
        "        J[-3, i] = -h[0, i]",
        KERNELS,
    ),
    _mutant(
        "the response without its harmonic in (10)",
        "codegen/shortcuts/loops/symmetric.py",
        "R[-1] += response * velocity_weight(T, j)[0] * cosines[j]",
        "R[-1] += response * velocity_weight(T, 1)[0] * cosines[j]", SYMMETRIC,
    ),
    _mutant(
        "Bessel functions by recurrence however small z is",
        "codegen/shortcuts/loops/odd_functions.py", "if z >= l + 2:", "if z >= 0:", SYMMETRIC,
    ),
    _mutant(
        "products of sines with a harmonic of the wrong end",
        "codegen/shortcuts/loops/sines.py", "C[2 * N - k] = C[2 * N + k]", "C[2 * N - k] = -C[2 * N + k]",
        SYMMETRIC,
    ),
)  # fmt: skip
