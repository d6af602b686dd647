"""Sweeps over a parameter that are taken up again: plan, blocks, check sums, locks, chunks."""

from ..mutant import Mutant

STORE = "src/nonsmooth/cli/shortcuts/families/family_store.py"
JOB = "src/nonsmooth/cli/shortcuts/families/family_job.py"
FAMILY = "src/nonsmooth/cli/shortcuts/families/family.py"

ON_DISK = ("tests/families/test_store.py", "tests/families/test_resume.py")
RESUMED = ("tests/families/test_resume.py",)
PROCESSES = ("tests/families/test_long_sweeps.py",)

MUTANTS: tuple[Mutant, ...] = (
    Mutant(
        "only the first block of the store is looked at",
        STORE,
        "for start in range(0, len(self), BLOCK):",
        "for start in range(0, min(len(self), BLOCK), BLOCK):",
        ON_DISK,
    ),
    Mutant(
        "the number of a damaged point is that in its block",
        STORE,
        "return start + int(wrong[0])",
        "return int(wrong[0])",
        ON_DISK,
    ),
    Mutant(
        "the last part block of the store is not looked at",
        STORE,
        "for start in range(0, len(self), BLOCK):",
        "for start in range(0, len(self) // BLOCK * BLOCK, BLOCK):",
        ON_DISK,
    ),
    Mutant(
        "the check sums of a block count from zero",
        STORE,
        'check_sums(start, found["point"])',
        'check_sums(0, found["point"])',
        ON_DISK,
    ),
    Mutant(
        "a check sum does not depend on the number of its point",
        STORE,
        "words @ FACTORS[1:] + numbers * FACTORS[0]",
        "words @ FACTORS[1:] + FACTORS[0]",
        ON_DISK,
    ),
    Mutant(
        "check sums with even factors: a change of the last bit goes unnoticed",
        STORE,
        "(2 * np.arange(POINT.itemsize // 8 + 1) + 1)",
        "(2 * np.arange(POINT.itemsize // 8 + 1) + 2)",
        ON_DISK,
    ),
    Mutant(
        "no check sum is compared",
        STORE,
        'np.flatnonzero(found["check"] != check_sums(start, found["point"]))',
        "np.flatnonzero(np.zeros(len(found)))",
        ON_DISK,
    ),
    Mutant(
        "a plan without its version",
        JOB,
        'asdict(self) | {"version": __version__, "generated": generated}',
        'asdict(self) | {"generated": generated}',
        RESUMED,
    ),
    Mutant(
        "a plan without the generated equations",
        JOB,
        'asdict(self) | {"version": __version__, "generated": generated}',
        'asdict(self) | {"version": __version__}',
        RESUMED,
    ),
    Mutant(
        "a plan with the equations of one method",
        JOB,
        "for name in kernels.MODULES]",
        'for name in ("c1",)]',
        RESUMED,
    ),
    Mutant(
        "a plan without the oscillator and the order",
        JOB,
        'asdict(self) | {"version"',
        'asdict(self.vary) | {"version"',
        RESUMED,
    ),
    Mutant(
        "a plan without the parameter",
        JOB,
        'return asdict(self) | {"version"',
        'return asdict(self) | {"vary": 0, "version"',
        RESUMED,
    ),
    Mutant(
        "the points of another sweep are taken",
        STORE,
        "if not line.startswith(begun):",
        "if not line.startswith(begun[:1]):",
        ON_DISK,
    ),
    Mutant(
        "a first line that was cut is left as it is",
        STORE,
        "        if begun != line:\n",
        "        if not begun:\n",
        ON_DISK,
    ),
    Mutant(
        "the offset of the points is one line, however long the plan",
        STORE,
        "yield Store(file, len(line),",
        "yield Store(file, LINE,",
        ON_DISK,
    ),
    Mutant(
        "points are written a record too far",
        STORE,
        "_put(self.file, self.offset + start * RECORD.itemsize,",
        "_put(self.file, self.offset + (start + 1) * RECORD.itemsize,",
        ON_DISK,
    ),
    Mutant(
        "points are written after what a killed run left of a point",
        STORE,
        "_put(self.file, self.offset + start * RECORD.itemsize,",
        "_put(self.file, os.fstat(self.file.fileno()).st_size,",
        ON_DISK,
    ),
    Mutant(
        "a write that ended early is taken for a whole one",
        STORE,
        "    while rest:\n",
        "    if rest:\n",
        ON_DISK,
    ),
    Mutant(
        "points are not synchronised",
        STORE,
        "            os.fsync(self.file.fileno())\n",
        "",
        ON_DISK,
    ),
    Mutant(
        "no lock",
        STORE,
        "        _lock(file, path)\n",
        "",
        ON_DISK,
    ),
    Mutant(
        "a lock that two can hold",
        STORE,
        "fcntl.LOCK_EX | fcntl.LOCK_NB",
        "fcntl.LOCK_SH | fcntl.LOCK_NB",
        ON_DISK,
    ),
    Mutant(
        "a lock that comes after the plan is compared",
        STORE,
        "        _lock(file, path)\n        begun = file.readline()\n"
        "        if not line.startswith(begun):\n",
        "        begun = file.readline()\n"
        "        if line.startswith(begun):\n            _lock(file, path)\n"
        "        else:\n",
        ON_DISK,
    ),
    Mutant(
        "a chunk that was begun counts as done",
        JOB,
        "if chunk.place + len(chunk) > done",
        "if chunk.place >= done",
        RESUMED,
    ),
    Mutant(
        "a chunk that is done is computed again",
        JOB,
        "if chunk.place + len(chunk) > done",
        "if chunk.place + len(chunk) >= done",
        RESUMED,
    ),
    Mutant(
        "damaged points count as done",
        JOB,
        "done = min(store.sound(), len(job))",
        "done = min(len(store), len(job))",
        RESUMED,
    ),
    Mutant(
        "the points of the second method replace those of the first",
        JOB,
        "before = self.methods.index(method) * self.vary.count",
        "before = 0",
        RESUMED,
    ),
    Mutant(
        "the values of a chunk count from its start",
        JOB,
        "job.vary.values(self.start, self.stop)",
        "job.vary.values(0, self.stop - self.start)",
        RESUMED,
    ),
    Mutant(
        "the last part chunk is not computed",
        JOB,
        "for start in range(0, self.vary.count, size):",
        "for start in range(0, self.vary.count // size * size or self.vary.count, size):",
        RESUMED,
    ),
    Mutant(
        "what is kept is deleted when the file cannot be written",
        FAMILY,
        "        if output is not None and written:\n",
        "        if output is not None:\n",
        RESUMED,
    ),
    Mutant(
        "what is kept is never deleted",
        FAMILY,
        "        if output is not None and written:\n",
        "        if output is not None and not written:\n",
        RESUMED,
    ),
    Mutant(
        "an interrupted sweep ends as if it were done",
        JOB,
        "err=True)\n            raise\n",
        "err=True)\n",
        RESUMED,
    ),
    Mutant(
        "the largest error is that of the last block",
        "src/nonsmooth/cli/shortcuts/families/family_shown.py",
        "        if errors[i] > worst:\n",
        "        if True:\n",
        RESUMED,
    ),
    Mutant(
        "what is there is not taken off the room that is needed",
        STORE,
        "count * each - there",
        "count * each",
        ON_DISK,
    ),
    Mutant(
        "workers outlive a sweep that is killed",
        "src/nonsmooth/cli/workers.py",
        "        while os.getppid() == parent:\n",
        "        while True:\n",
        PROCESSES,
    ),
    Mutant(
        "results of workers in another order",
        "src/nonsmooth/cli/workers.py",
        "        while ahead:\n            first, result = ahead.popleft()",
        "        while ahead:\n            first, result = ahead.pop()",
        PROCESSES,
    ),
)
