"""Mistakes where users reach a scene: its commands, its files, its cache, Python."""

from ..mutant import Mutant

COMMANDS = ("tests/cli_scenes/test_scene_commands.py",)
USERS = ("tests/cli_scenes/test_user_scenes.py",)
BROKEN = ("tests/cli_scenes/test_broken_scene_files.py",)
PYTHON = ("tests/cli_scenes/test_scene_python.py",)
IMPORTS = ("tests/cli_scenes/test_scene_imports.py",)


def command(what: str, file: str, old: str, new: str) -> Mutant:
    """Return a mistake in a command of a scene."""
    return Mutant(what, f"src/nonsmooth/cli/scenes/{file}", old, new, COMMANDS)


def user(what: str, file: str, old: str, new: str, tests: tuple[str, ...] = USERS) -> Mutant:
    """Return a mistake in what becomes of a user's scene."""
    return Mutant(what, f"src/nonsmooth/scene_files/{file}", old, new, tests)


def python(what: str, file: str, old: str, new: str) -> Mutant:
    """Return a mistake in what Python users call."""
    return Mutant(what, file, old, new, PYTHON)


MUTANTS: tuple[Mutant, ...] = (
    command(
        "the errors of a table swapped",
        "shown/tables.py",
        "_errors(errors.times, errors.discontinuous)),\n            f\"{orbit.",
        "_errors(errors.discontinuous, errors.times)),\n            f\"{orbit.",
    ),
    command(
        "the estimate of the period for that of the times",
        "shown/tables.py",
        'f"{orbit.estimate.times:.1e}"',
        'f"{orbit.estimate.period:.1e}"',
    ),
    command(
        "durations of a period where a phase of the forcing stands",
        "shown/tables.py",
        '*([] if turn is None else [f"{turn:.7g}"]),',
        '*([] if turn is None else [f"{motion.durations[0]:.7g}"]),',
    ),
    command(
        "no orbit ends with status 0",
        "solve.py",
        "return 0 if len(orbits) == len(found) else 1",
        "return 0",
    ),
    command(
        "a case file's scene is not looked at",
        "command.py",
        "scene = arguments[0] if named else _of_case_file(arguments)",
        "scene = arguments[0] if named else None",
    ),
    command(
        "a case file may leave out parameters",
        "options.py",
        "if file is not None and q.name not in table and q.name not in given",
        "if False and q.name not in table and q.name not in given",
    ),
    command(
        "flags do not override the file",
        "options.py",
        "case = scene(**(table | given), cycles",
        "case = scene(**(given | table), cycles",
    ),
    command(
        "the jump is shown with the wrong sign",
        "shown/formulas.py",
        "f\"{'-' if minus else ''}{term}\"",
        "term",
    ),
    Mutant(
        "the displacement for the velocity in a file of the motion",
        "src/nonsmooth/files/scenes/tables.py",
        "orbit.displacement(t), orbit.velocity(t), orbit.acceleration(t)",
        "orbit.velocity(t), orbit.displacement(t), orbit.acceleration(t)",
        COMMANDS,
    ),
    command(
        "generate --check writes",
        "generate.py",
        "if not check:",
        "if True:",
    ),
    user(
        "the hash leaves out the program",
        "content.py",
        "digest = hashlib.sha256(_generator())",
        "digest = hashlib.sha256()",
    ),
    user(
        "the hash leaves out assumptions of symbols",
        "content.py",
        "return str(srepr(value))",
        "return str(value)",
    ),
    user(
        "only part of the symbolic stage is in the hash",
        "content.py",
        'found = folder.rglob("*.py")',
        'found = folder.glob("*.py")',
    ),
    user(
        "half a folder stays where the disk is full",
        "store.py",
        "        shutil.rmtree(temporary, ignore_errors=True)\n",
        "        pass\n",
    ),
    user(
        "a second process fails on what the first has put there",
        "store.py",
        "        if _is_whole(target):\n            return\n",
        "",
    ),
    user(
        "what goes with the process is derived at each use",
        "store.py",
        "    _FOR_NOW[key] = temporary / key\n",
        "",
    ),
    user(
        "a scene may take the name of a shipped one",
        "derive.py",
        'if name.replace("_", "-") in names():',
        "if False:",
    ),
    user(
        "what a scene file prints is among the results",
        "read.py",
        "with redirect_stdout(sys.stderr):",
        "with redirect_stdout(sys.stdout):",
        BROKEN,
    ),
    user(
        "a scene file that leaves takes the command along",
        "read.py",
        "except (Exception, SystemExit) as error:",
        "except Exception as error:",
        BROKEN,
    ),
    user(
        "the first line of a traceback for the last",
        "read.py",
        "{lines[-1]}",
        "{lines[0]}",
        BROKEN,
    ),
    Mutant(
        "a list of scenes loads NumPy",
        "solver/case/numbers.py",
        "if TYPE_CHECKING:\n    from .case import Case",
        "from .case import Case",
        IMPORTS,
    ),
    python(
        "a tolerance is held by the times alone",
        "solver/trade/choice.py",
        "return max(errors.times, abs(errors.period))",
        "return min(errors.times, abs(errors.period))",
    ),
    python(
        "the first order that is found for the lowest",
        "solver/trade/tolerance.py",
        "orbit = search.lowest(last, order, orbit)\n",
        "pass\n",
    ),
    python(
        "rates from five orders",
        "solver/accuracy/rates.py",
        "FEWEST = 6",
        "FEWEST = 5",
    ),
    python(
        "rates are those of rounding",
        "solver/accuracy/rates.py",
        "if floor < error < math.inf",
        "if 0 < error < math.inf",
    ),
)  # fmt: skip
