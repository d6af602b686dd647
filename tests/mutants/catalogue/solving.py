"""Mistakes in the search for an orbit and in what is accepted as one."""

from ..mutant import Mutant

NEWTON, LINEAR = "solver/shortcuts/search/newton.py", "solver/iteration/linear.py"
NEWTONS, LINEARS = ("tests/solving/test_newton.py",), ("tests/solving/test_linear.py",)
ADMISSIBLE, DEMANDS = (
    "solver/shortcuts/orbit/admissible.py",
    ("tests/solving/test_admissible.py",),
)
ROOTS, ALL_ROOTS = "solver/shortcuts/polynomials/c1_roots.py", ("tests/solving/test_roots.py",)
FOLLOW, FOLDS = (
    "solver/shortcuts/search/continuation.py",
    ("tests/solving/test_continuation.py",),
)
FREE, MANY = "solver/shortcuts/series/matrix_free.py", ("tests/solving/test_matrix_free.py",)

SEARCH, SINGULAR = "solver/solve.py", ("tests/scenes/test_singular.py",)

TWO, SCAN = "solver/flow/two_phases.py", ("tests/scenes/test_two_phases.py",)
LISTED = "solver/flow/enclosure.py"

MUTANTS = (
    Mutant(
        "a list of roots leaves out parts in which two functions may meet",
        LISTED, "far = np.abs(np.abs(D) - np.hypot(P, Q)) > change", "far = change > change", SCAN,
    ),
    Mutant(
        "a list of roots is complete though rounding hides some",
        LISTED, "return self.resolved and not len(self.doubtful)", "return self.resolved", SCAN,
    ),
    Mutant(
        "a list of roots is complete though a function is not resolved",
        LISTED, "resolved, fine = bool(fine.all()), np.ones_like(fine)",
        "fine = np.ones_like(fine)", SCAN,
    ),
    Mutant(
        "of the two roots beside a zero one is looked for",
        LISTED, "for sign in (1.0, -1.0):", "for sign in (1.0,):", SCAN,
    ),
    Mutant(
        "a scan takes a load well below the limit for one that touches it",
        TWO, "ROUNDING = 1e-11", "ROUNDING = 1e-9", SCAN,
    ),
    Mutant(
        "at a gap of 0 the forcing is taken from conditions that leave it free",
        TWO, "if nothing.any():", "if False:", SCAN,
    ),
    Mutant(
        "a scan takes the second phase to begin where the first does",
        TWO, "np.exp(1j * omega * begin)", "np.exp(0j * omega * begin)", SCAN,
    ),
    Mutant(
        "a scan forgets that half a period is mirrored",
        TWO, "law = (cell.sign if after == 0 else 1)", "law = 1", SCAN,
    ),
    Mutant(
        "a scan forgets what the memory does to the events",
        TWO, "A[:, row, 4 : 4 + more] += np.array(factors)", "pass", SCAN,
    ),
    Mutant(
        "a scan takes the memory for free of the state",
        TWO, "A[:, 6 + i, 2 * memory.phase], A[:, 6 + i, 2 * memory.phase + 1] = -vx, -vv",
        "pass", SCAN,
    ),
    Mutant(
        "solutions that are orbits do not count",
        "solver/flow/known.py", "return self.complete and not self.orbits",
        "return self.complete", SCAN,
    ),
    Mutant(
        "a list is complete though a root led nowhere",
        "solver/flow/known.py", "            complete = False", "            pass", SCAN,
    ),
    Mutant(
        "a search goes on though no solution can be an orbit",
        SEARCH, "if not known(self.case).none:", "if True:", SCAN,
    ),
    Mutant(
        "the search for the exact orbit goes on though none can be",
        "solver/flow/exact.py", "if not found.none:", "if True:", SCAN,
    ),
    Mutant(
        "an orbit is returned that the exact equations disprove",
        "solver/orbit/orbit.py", "or self._disproof", "", ("tests/scenes/test_never_wrong.py",),
    ),
    Mutant(
        "of two orbits the unstable one is returned",
        "solver/flow/known.py", "key=lambda q: is_stable(q) is not True",
        "key=lambda q: is_stable(q) is True", ("tests/scenes/test_never_wrong.py",),
    ),
    Mutant(
        "functions of class C^1 are taken where the smoother ones are not singular",
        SEARCH, "if found.converged and is_singular(self.kernel, self.case, failed.order, there):",
        "if found.converged:", SINGULAR,
    ),
    Mutant(
        "an undamped orbit is searched from coarse orbits of singular equations",
        SEARCH, "once = is_reversible(self.case.cell) and registry", "once = False and registry",
        SINGULAR,
    ),
    Mutant(
        "whatever is damped is taken to run backwards",
        "solver/iteration/singular.py", "phase.c == 0 and not", "not", SINGULAR,
    ),
    Mutant(
        "an estimate has no better orbit where the equations of the best method are singular",
        "solver/accuracy/estimate.py", "once = registry.class_one(orbit.case.scene, FIRST)",
        "once = None", SINGULAR,
    ),
    Mutant(
        "a Jacobian is taken for singular whose rows differ in size",
        "solver/iteration/singular.py", "np.linalg.svd(equilibrated(J), compute_uv=False)",
        "np.linalg.svd(J, compute_uv=False)**3", SINGULAR,
    ),
    Mutant(
        "the static limit is not checked inside stick",
        ADMISSIBLE, "elif highest > allowed:", "elif False:", DEMANDS,
    ),
    Mutant(
        "the belt's velocity is not checked inside slip",
        ADMISSIBLE, "if overspeed > ROUNDING:", "if False:", DEMANDS,
    ),
    Mutant(
        "the belt's velocity is checked at the start of slip only",
        ADMISSIBLE, "part[1:-1]", "part[:1]", DEMANDS,
    ),
    Mutant(
        "the last step of Newton's method may leave the range",
        NEWTON, "if not 0 < z[-2] + step[-2] < z[-1] + step[-1]:", "if False:", NEWTONS,
    ),
    Mutant(
        "an edit of Newton's method finds old machine code",
        "solver/shortcuts/search/kernels.py", "source.BODY.encode() + _driver_text()", "source.BODY.encode()",
        ("tests/derivation/test_compiled_cache.py",),
    ),
    Mutant(
        "the machine code does not know the linear algebra",
        "solver/shortcuts/search/kernels.py", "for part in (newton, linear))", "for part in (newton,))",
        ("tests/derivation/test_compiled_cache.py",),
    ),
    Mutant(
        "the end of stick is not checked",
        ADMISSIBLE, "if abs(at_end) > allowed:", "if False:", DEMANDS,
    ),
    Mutant(
        "slip may last a second turn",
        ADMISSIBLE, "if T - t1 > NATURAL_PERIOD * (1 + allowed):", "if False:", DEMANDS,
    ),
    Mutant(
        "stick may have any velocity",
        ADMISSIBLE, "STICK_VELOCITY = (0.5, 3.0)", "STICK_VELOCITY = (0.0, 1e9)", DEMANDS,
    ),
    Mutant(
        "times in any order",
        ADMISSIBLE, "if not 0 < t1 < T:", "if not t1 < T:", DEMANDS,
    ),
    Mutant(
        "a step is accepted that makes things worse",
        NEWTON, "step_norm(simplified, z) <= (1 - damping / 4) * length", "damping > 0",
        NEWTONS,
    ),
    Mutant(
        "the times are not kept in their range",
        NEWTON, "min(1.0, 2.0 * damping, longest_step(step, z))", "min(1.0, 2.0 * damping)",
        NEWTONS,
    ),
    Mutant(
        "Newton's method waits for corrections without rounding",
        NEWTON, "correction <= ROUNDOFF or correction > 0.5 * previous", "correction == 0.0",
        NEWTONS,
    ),
    Mutant(
        "the limit of iterations is forgotten",
        NEWTON, "range(1, limit + 1)", "range(1, 1000)", NEWTONS,
    ),
    Mutant(
        "a singular Jacobian is solved",
        LINEAR, "if A[pivot, k] == 0:", "if False:", NEWTONS,
    ),
    Mutant(
        "no pivoting",
        LINEAR, "if abs(A[i, k]) > abs(A[pivot, k]):", "if False:", LINEARS,
    ),
    Mutant(
        "the exchanges of rows are forgotten",
        LINEAR, "b[k], b[pivot] = b[pivot], b[k]", "pass", LINEARS,
    ),
    Mutant(
        "the roots are not isolated where the start fails",
        "solver/shortcuts/search/search.py", "return (_ROUGH, _ROOTS)", "return (_ROUGH,)",
        ("tests/solving/test_orbits.py",),
    ),
    Mutant(
        "no way round the folds",
        "solver/shortcuts/search/search.py", "ways = (*first, _STICK) if reached else first", "ways = first",
        FOLDS,
    ),
    Mutant(
        "any root of the C1 series is started from",
        "solver/shortcuts/search/search.py", "if not violations(METHODS[\"c1\"], order, belt, root)]", "if True]",
        ("tests/solving/test_orbits.py",),
    ),
    Mutant(
        "the rough slip does not tend to 2 pi",
        "solver/shortcuts/search/start.py", "2.0 / (alpha + 2.0 / math.pi)", "2.0 / (alpha + 1.0)",
        ("tests/derivation/test_c1_reduced.py",),
    ),
    Mutant(
        "a batch keeps times of what is not an orbit",
        "solver/shortcuts/polynomials/batch.py", "t1[status != OK] = s[status != OK] = np.nan", "pass",
        ("tests/derivation/test_c1_reduced.py",),
    ),
    Mutant(
        "t1 from (19) with another sign",
        ROOTS, "-weight * square * p1 - 1", "-weight * square * p1 + 1", ALL_ROOTS,
    ),
    Mutant(
        "back substitution forgets a column",
        ROOTS, "for c in filled[i] if c < size)", "for c in filled[i] if c < size - 1)",
        ALL_ROOTS,
    ),
    Mutant(
        "an exchange of rows keeps the sign of the determinant",
        ROOTS, "determinant = -determinant", "pass", ALL_ROOTS,
    ),
    Mutant(
        "roots are isolated by fewer signs",
        "solver/shortcuts/polynomials/real_roots.py", "if roots <= 1:", "if roots <= 2:", ALL_ROOTS,
    ),
    Mutant(
        "continuation jumps to another curve",
        FOLLOW, "> SAME_CURVE:", "> 1e9:", FOLDS,
    ),
    Mutant(
        "continuation takes corrections that grow",
        FOLLOW, "if not length <= CONTRACTION * previous:", "if False:", FOLDS,
    ),
    Mutant(
        "continuation goes the other way",
        FOLLOW, "alpha - alpha_of(kernel, terms, z)", "alpha_of(kernel, terms, z) - alpha",
        FOLDS,
    ),
    Mutant(
        "the responses of (9) and (10) are added",
        FREE, "last[K:] -= self.ends @ through", "last[K:] += self.ends @ through", MANY,
    ),
    Mutant(
        "(14) by half of what is left out",
        "solver/shortcuts/series/left_out.py", "return LeftOut(acceleration + tail_squared(functions, N, t1, T)",
        "return LeftOut(acceleration", MANY,
    ),
)  # fmt: skip
