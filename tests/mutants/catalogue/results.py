"""Mistakes in pictures, tables and lines of results, in changed files, in when to compile."""

from ..mutant import Mutant

PLOTS = ("tests/results/test_plots_of_results.py",)
TABLES = ("tests/results/test_tables_of_results.py",)
LINES = ("tests/results/test_lines_of_results.py",)
CHANGED = ("tests/files/test_changed_files.py",)
SCENES = ("tests/files/test_files_of_scenes.py",)
COMPILE = ("tests/solving/test_when_to_compile.py",)
COMPILING, CACHE = "solver/compiling.py", "solver/numba_cache.py"
FAILING = ("tests/solving/test_cache_that_fails.py",)
COPIED = ("tests/results/test_copied_errors.py",)

MUTANTS: tuple[Mutant, ...] = (
    Mutant(
        "an error of zero is drawn as zero",
        "src/nonsmooth/plots/axes.py",
        "max(abs(error), LEAST)",
        "abs(error)",
        PLOTS,
    ),
    Mutant(
        "a motion is drawn from inside its phases",
        "solver/results/instants.py",
        "INSIDE = 1e-9",
        "INSIDE = 1e-3",
        PLOTS,
    ),
    Mutant(
        "given axes are left empty",
        "src/nonsmooth/plots/axes.py",
        "    if ax is not None:\n        return ax\n",
        "",
        PLOTS,
    ),
    Mutant(
        "the phase of a motion begins a step late",
        "solver/results/motion.py",
        'np.searchsorted(switches, t, side="right")',
        'np.searchsorted(switches, t, side="right") // 2',
        TABLES,
    ),
    Mutant(
        "least and largest swapped in a table",
        "solver/results/table.py",
        'zip(("least", "largest"), part, strict=True)',
        'zip(("largest", "least"), part, strict=True)',
        TABLES,
    ),
    Mutant(
        "a place without a row is filled with 0",
        "solver/results/frames.py",
        "                grid[...] = np.nan\n",
        "                grid[...] = 0\n",
        (*TABLES, *SCENES),
    ),
    Mutant(
        "orbits of any order are equal",
        "solver/orbit/orbit.py",
        "self.case, self.method, self.order, self.functions, self.unknowns.tobytes()",
        "self.case, self.method",
        LINES,
    ),
    Mutant(
        "a pickle holds what was computed",
        "solver/results/motion.py",
        "{field.name: getattr(self, field.name) for field in fields(self)}",
        "dict(vars(self))",
        LINES,
    ),
    Mutant(
        "the digest tells 1 from 1.0",
        "src/nonsmooth/files/json_text.py",
        "        return value + 0.0  # of -0.0 as well\n",
        "        return value\n",
        CHANGED,
    ),
    Mutant(
        "the digest is not of the rows",
        "src/nonsmooth/files/json_text.py",
        "        self._hash.update(_canonical(row))\n",
        "        _canonical(row)\n",
        CHANGED,
    ),
    Mutant(
        "the equations of a loaded orbit are not checked",
        "src/nonsmooth/files/shortcuts/documents.py",
        "    checks.residual(R, z)\n",
        "",
        CHANGED,
    ),
    Mutant(
        "the equations of a loaded orbit of a scene are not checked",
        "src/nonsmooth/files/scenes/restored.py",
        "    checks.residual(R, z)\n",
        "",
        SCENES,
    ),
    Mutant(
        "durations of a file need not be its period",
        "src/nonsmooth/files/checks.py",
        '    same("period", row["period"], math.fsum(parts), "its durations")\n',
        "",
        SCENES,
    ),
    Mutant(
        "arrays of netCDF may say anything",
        "src/nonsmooth/files/api.py",
        "        netcdf.check_same(file, _content(found).tables())\n",
        "",
        CHANGED,
    ),
    Mutant(
        "a kernel that is not cached is compiled as if it were",
        "solver/compiling.py",
        "return self.seconds >= COMPILE",
        "return self.seconds >= LOAD",
        COMPILE,
    ),
    Mutant(
        "what failed has cost nothing",
        "solver/compiling.py",
        "        try:\n            yield\n        finally:\n            spent",
        "        yield\n        if True:\n            spent",
        COMPILE,
    ),
    Mutant(
        "scenes stay in plain Python",
        "solver/case/kernel.py",
        "    return compiled(module) if wanted else plain(module)",
        "    return plain(module)",
        COMPILE,
    ),
    Mutant(
        "a cache that cannot be written ends the command",
        CACHE,
        "cached.save_overload = guarded(cached.save_overload)",
        "pass",
        FAILING,
    ),
    Mutant(
        "a cache that cannot be read ends the command",
        CACHE,
        "cached.load_overload = guarded(cached.load_overload)",
        "pass",
        FAILING,
    ),
    Mutant(
        "a cache that fails is not said",
        CACHE,
        "say(cached.cache_path, error.strerror or str(error))",
        "pass",
        FAILING,
    ),
    Mutant(
        "that no folder can be written is not said",
        COMPILING,
        '_warn_once(str(folder), "not writable, and no other folder is")',
        "pass",
        FAILING,
    ),
    Mutant(
        "a cache that fails is said again and again",
        COMPILING,
        "if not _SAID:",
        "if True:",
        FAILING,
    ),
    Mutant(
        "an index without its code counts as cached",
        COMPILING,
        'f"*.{self._name}-*.nbc"',
        'f"*.{self._name}-*.nbi"',
        COMPILE,
    ),
    Mutant(
        "warnings are printed with where they were raised",
        "src/nonsmooth/cli/problems.py",
        "    warnings.showwarning = show\n",
        "",
        FAILING,
    ),
    Mutant(
        "a pickled error of a file has its words twice",
        "src/nonsmooth/files/errors.py",
        "return type(self), (self.path, self.problem), vars(self)",
        "return type(self), (self.path, str(self)), vars(self)",
        COPIED,
    ),
    Mutant(
        "a pickled error of parameters is split into letters",
        "solver/case/parameters.py",
        "return type(self), (list(self.errors),), vars(self)",
        "return type(self), self.args, vars(self)",
        COPIED,
    ),
    Mutant(
        "orders that no method has are left out in silence",
        "solver/sweep.py",
        "numbers = [check_order(least, order) for order in numbers]",
        "numbers = [int(order) for order in numbers]",
        ("tests/cli/test_bad_arguments.py",),
    ),
    Mutant(
        "an orbit without parameters has the defaults",
        "src/nonsmooth/files/scenes/restored.py",
        "if q.name not in given]",
        "if q.name not in given and False]",
        ("tests/files/test_files_of_scenes.py",),
    ),
)
