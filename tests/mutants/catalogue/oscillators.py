"""Mistakes in what the oscillators need: memory, motions, cycles, demands at switches."""

from ..mutant import Mutant

CHECKS = ("tests/scene/test_scene_motions.py",)
SHIPPED = ("tests/scenes/test_shipped_scenes.py",)
CROSSED = ("tests/scenes/test_crossings.py",)
WRONG = ("tests/scenes/test_never_wrong.py",)
INPUT = ("tests/scenes/test_bad_scene_input.py",)
ROWS = (
    "tests/galerkin/test_rows.py::test_the_residual_is_the_quadrature_of_the_equation_of_motion"
)

MUTANTS = (
    Mutant(
        "the memory of the cell before without its sign",
        "codegen/scene/data.py", "= self.sign * memory.symbol", "= memory.symbol", CHECKS,
    ),
    Mutant(
        "the class does not know what a switch sets",
        "codegen/scene/smoothness.py", "if q.at == right.name:", "if q.at == '':", CHECKS,
    ),
    Mutant(
        "a memory may be a force",
        "codegen/scene/memory.py", "if mass != 0 or length != 1", "if length != 1", CHECKS,
    ),
    Mutant(
        "motions of any mass go together",
        "codegen/scene/check.py", "if sp.simplify(expected - size) != 0:", "if False:", CHECKS,
    ),
    Mutant(
        "the memory is set by its opposite",
        "codegen/galerkin/closure.py", "one_sum(q.symbol - value)", "one_sum(q.symbol + value)",
        (f"{ROWS}[S4a-ck_tau]",),
    ),
    Mutant(
        "harmonics without the memory",
        "codegen/galerkin/harmonics.py", "total += memory.symbol * self", "total += 0 * self",
        (f"{ROWS}[S4a-hb]",),
    ),
    Mutant(
        "the forcing is the first harmonic whatever the cycles",
        "codegen/galerkin/harmonics.py", "turned = cycles * angle", "turned = angle",
        (f"{ROWS}[S1n2-hb]",),
    ),
    Mutant(
        "the cell is one cycle whatever the cycles",
        "codegen/galerkin/times.py", "return turns * cycles / self", "return turns / self",
        (f"{ROWS}[S1n2-ck_tau]",),
    ),
    Mutant(
        "the exact event does not move with the memory",
        "solver/flow/exact_system.py", "enumerate(cell.phases[p].event[4:])", "enumerate(())",
        WRONG,
    ),
    Mutant(
        "the memory in a demand is forgotten",
        "solver/case/cell.py", "constant + sum(map(mul, factors, values))", "constant", SHIPPED,
    ),
    Mutant(
        "what is demanded at a switch is not looked at",
        "solver/orbit/admissible.py",
        "if value >= -ROUNDING * scale or value >= -allowed(p, form) * scale:", "if True:", WRONG,
    ),
    Mutant(
        "an event may be met before the end",
        "solver/orbit/admissible.py", "    if u is None:\n", "    if True:\n", CROSSED,
    ),
    Mutant(
        "a phase ends wherever its event vanishes",
        "solver/orbit/crossings.py", "if (rate if near else value) < 0:", "if False:",
        CROSSED,
    ),
    Mutant(
        "a phase may begin though it leaves its demand at once",
        "solver/orbit/crossings.py", "if (rate if near else value) < 0:",
        "if value < 0 and not near:", CROSSED,
    ),
    Mutant(
        "the mirror image of a cell begins where the cell does",
        "solver/orbit/crossings.py", "(cell.sign if last else 1)", "1", CROSSED,
    ),
    Mutant(
        "rounding is a crossing",
        "solver/orbit/crossings.py", "np.abs(values) > allowed * scale", "np.abs(values) > 0", CROSSED,
    ),
    Mutant(
        "a jump does not end a phase",
        "solver/orbit/crossings.py", "(phase.rho, phase.d) != (1, 0)", "phase.d != 0", CROSSED,
    ),
    Mutant(
        "an orbit of one cycle is taken for one of two",
        "solver/orbit/admissible.py", "if apart <= SAME:", "if apart < 0:", WRONG,
    ),
    Mutant(
        "an even number of cycles in half a period",
        "solver/case/case.py", "and cycles % 2 == 0:", "and cycles % 2 == 2:", INPUT,
    ),
    Mutant(
        "the class of a case without the mirrored forces",
        "solver/case/smoothness.py", "sign * phase.f, phase.g, 0.0]", "phase.f, phase.g, 0.0]",
        SHIPPED,
    ),
    Mutant(
        "the first motion alone is tried",
        "solver/motions.py", "    for each in case.each_motion:", "    for each in case.each_motion[:1]:",
        SHIPPED,
    ),
)  # fmt: skip
