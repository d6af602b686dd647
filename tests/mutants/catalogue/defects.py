"""Mistakes that were made once: in searches, files, progress, rates, names of options."""

from ..mutant import Mutant

CHOICE, SEARCH = "solver/shortcuts/choice", "solver/shortcuts/search"
FIRST, FIRSTS = f"{CHOICE}/first_orders.py", ("tests/accuracy/test_first_orders.py",)
MANY, MANIES = f"{SEARCH}/rounding.py", ("tests/solving/test_many_c1_functions.py",)
CLI = "src/nonsmooth/cli"
PROGRESS, SHOWN = f"{CLI}/progress.py", ("tests/families/test_progress.py",)
STORE, STORED = f"{CLI}/shortcuts/families/family_store.py", ("tests/families/test_store.py",)
CSV, READ = "src/nonsmooth/files/shortcuts/consistent.py", ("tests/files/test_files.py",)
ALIASES, NAMES = f"{CLI}/aliases.py", ("tests/cli/test_aliases.py",)

MUTANTS = (
    Mutant(
        "the search for a tolerance begins where slip is resolved only",
        FIRST, "early * ERRORS[method].harmonics(alpha, small)", "0.0", FIRSTS,
    ),
    Mutant(
        "the errors of 3.2 are said to be ten times as large",
        FIRST, "Errors(0.012,", "Errors(0.12,", FIRSTS,
    ),
    Mutant(
        "after an order without an orbit comes the next",
        f"{CHOICE}/tolerance.py", "else 2 * order", "else order", FIRSTS,
    ),
    Mutant(
        "an orbit with fewer C1 functions is not looked at",
        f"{SEARCH}/search.py", "tried = (fewer[-1], found, *fewer[-2::-1])", "tried = (found,)",
        MANIES,
    ),
    Mutant(
        "where Newton's method left off is not looked at",
        f"{SEARCH}/search.py", "tried = (fewer[-1], found, *fewer[-2::-1])",
        "tried = (fewer[-1], *fewer[-2::-1])", MANIES,
    ),
    Mutant(
        "times that still change are taken",
        MANY, "if each.correction <= ROUNDOFF:", "if True:", MANIES,
    ),
    Mutant(
        "equations that are missed by a thousand roundings hold",
        MANY, "ROUNDINGS = 16.0", "ROUNDINGS = 16.0e3", (*MANIES,),
    ),
    Mutant(
        "no steps of least norm where rounding hides functions",
        f"{SEARCH}/search.py", "return (*ways, _LEAST) if", "return ways if", MANIES,
    ),
    Mutant(
        "steps of least norm go in directions that rounding made",
        MANY, "kept = sizes > ROUNDINGS * np.finfo(float).eps * len(R) * sizes[0]",
        "kept = sizes > 0", MANIES,
    ),
    Mutant(
        "steps of least norm leave out what can be told",
        MANY, "eps * len(R) * sizes[0]", "eps**0.5 * len(R) * sizes[0]", MANIES,
    ),
    Mutant(
        "rows are not scaled before the singular values are compared",
        MANY, "rows = np.abs(J).max(axis=1)\n", "rows = np.ones(len(J))\n", MANIES,
    ),
    Mutant(
        "columns are not scaled back",
        MANY, "sizes[kept]) / columns", "sizes[kept])", MANIES,
    ),
    Mutant(
        "steps of least norm end before the equations hold",
        MANY, "if correction <= ROUNDOFF and _within_rounding(R, J, z):", "if correction <= ROUNDOFF:",
        MANIES,
    ),
    Mutant(
        "steps of least norm end before the times are at rest",
        MANY, "if correction <= ROUNDOFF and _within_rounding(R, J, z):",
        "if _within_rounding(R, J, z):", MANIES,
    ),
    Mutant(
        "a file that is replaced gets the mode of a new one",
        "src/nonsmooth/files/whole.py", "return stat.S_IMODE(path.stat().st_mode)",
        "raise FileNotFoundError", ("tests/files/test_file_modes.py",),
    ),
    Mutant(
        "the points of a sweep are written through a link",
        STORE, "if path.is_symlink():", "if False:", STORED,
    ),
    Mutant(
        "a pipe is taken for the file of the points",
        STORE, "if not stat.S_ISREG(os.fstat(found).st_mode):", "if False:", STORED,
    ),
    Mutant(
        "a full disk does not say which file",
        STORE, "        with _named(self.name):\n", "        if True:\n", STORED,
    ),
    Mutant(
        "an edited period of a family goes unnoticed",
        CSV, "if not _agree(t1, part * T, t1):", "if False:", READ,
    ),
    Mutant(
        "an edited parameter of a family goes unnoticed",
        CSV, "if not _agree(alpha, right, alpha):", "if False:", READ,
    ),
    Mutant(
        "the end of stick of a sweep is not checked",
        CSV, 'for name in ("t1", "period"):', 'for name in ("period",):', READ,
    ),
    Mutant(
        "the upper half of few orders is fitted",
        "solver/accuracy/rates.py", "(x[0] + x[-1]) / 2)), len(x) - FEWEST)",
        "(x[0] + x[-1]) / 2)), len(x) - 2)", ("tests/accuracy/test_convergence.py",),
    ),
    Mutant(
        "lines from the first second on",
        PROGRESS, "        if now - begin < QUIET:\n            return\n", "", SHOWN,
    ),
    Mutant(
        "a bar at once",
        PROGRESS, "threading.Timer(SOON,", "threading.Timer(0.0,", SHOWN,
    ),
    Mutant(
        "what goes on for long says so once",
        PROGRESS, "while not over.wait(pause):", "if not over.wait(pause):", SHOWN,
    ),
    Mutant(
        "the other name of an option is shown",
        ALIASES, "            self.opts = shown\n", "            pass\n", NAMES,
    ),
    Mutant(
        "of several orders the first is solved",
        ALIASES, "if len(orders) > 1:", "if not orders:", NAMES,
    ),
)  # fmt: skip
