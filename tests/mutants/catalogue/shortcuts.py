"""Mistakes in the table of shortcuts, in who is solved by it, and in what stands without it."""

from ..mutant import Mutant

TABLE = ("tests/shortcuts/test_table.py",)
DEFAULT = ("tests/shortcuts/test_default_scene.py",)
LEFT_OUT = (
    "tests/shortcuts/test_left_out.py::test_every_scene_is_solved_from_python",
    "tests/shortcuts/test_left_out.py::test_the_default_scene_is_solved_as_any_other",
)
ROOMS = ("tests/project/test_rooms.py",)
IMPORTS = ("tests/project/test_imports_of_rooms.py",)
DERIVED = ("tests/project/test_nothing_derived.py",)


def row(what: str, old: str, new: str) -> Mutant:
    """Return a mistake in a row of the table."""
    return Mutant(what, "solver/shortcuts/table.py", old, new, TABLE)


def full(what: str, old: str, new: str) -> Mutant:
    """Return a mistake in what shortcuts are held against."""
    return Mutant(what, "solver/shortcuts/full.py", old, new, TABLE)


def by_scene(what: str, old: str, new: str) -> Mutant:
    """Return a mistake in what of the default scene goes the way of any scene."""
    return Mutant(what, "src/nonsmooth/cli/shortcuts/by_scene.py", old, new, DEFAULT)


def way(what: str, old: str, new: str) -> Mutant:
    """Return a mistake in which way Python users are led."""
    return Mutant(what, "src/nonsmooth/oscillators.py", old, new, (*TABLE, *DEFAULT))


MUTANTS: tuple[Mutant, ...] = (
    row("the origin of the series stays at x_s", "z[0] += 2 * belt.slip_centre / units.length", "pass"),
    row("half of the way to the other origin", "z[0] += 2 * belt", "z[0] += belt"),
    row("the period for the duration of slip", "z[-1] -= z[-2]", "pass"),
    row("one C1 function whatever is asked", "terms = functions or 1", "terms = 1"),
    row("period and end of stick exchanged", "t1, T, _ = by_bands", "T, t1, _ = by_bands"),
    row(
        "the series is meant for stick of any length",
        "return SMALLEST_ALPHA <= alpha_of_case(case) <= LARGEST_ALPHA",
        "return True",
    ),
    row("pure slip may pass for the orbit", "LEAST_BY_SCALAR <= alpha_of_case(case)", "0 <= alpha_of_case(case)"),
    row("a shortcut that is slower", "bound=1e-12, factor=10.0, order=100", "bound=1e-12, factor=0.5, order=100"),
    row("a bound that allows anything", "_scalar, parts, _C1, bound=1e-12", "_scalar, parts, _C1, bound=1.0"),
    full("in slip no spring", "np.where(t < t1, 0.0, y)", "np.where(t < t1, 0.0, 0.0)"),
    full("(9) with the other sign", "order, start, 0, alpha) + alpha)", "order, start, 0, alpha) - alpha)"),
    full("stick and slip exchanged", "np.asarray([t1 / T, (T - t1) / T])", "np.asarray([(T - t1) / T, t1 / T])"),
    Mutant(
        "the belt's own parameters are lost on the way to the generic kernels",
        "solver/shortcuts/entrance.py",
        "return load(SCENE)(**asdict(belt))",
        "return load(SCENE)()",
        DEFAULT,
    ),
    Mutant(
        "the paper's method goes by the generic kernels",
        "solver/shortcuts/names.py",
        '"hb-ck": "hb-c1", "ck": "c1"}',
        '"hb-ck": "hb-c1"}',
        (*DEFAULT, *TABLE),
    ),
    by_scene(
        "the shortcuts of the default scene are taken although they are not wanted",
        "if no_shortcuts or functions is not None:",
        "if functions is not None:",
    ),
    by_scene(
        "methods of both kinds in one sweep",
        "if more and len(more) < len(names):",
        "if False:",
    ),
    way("shortcuts that are not wanted", "if functions is not None or not shortcuts:", "if functions is not None:"),
    way("methods of both kinds are one sweep", "if each != of_every_scene[0]:", "if False:"),
    Mutant(
        "the table is asked for although it is left out",
        "solver/shortcut.py",
        "if find_spec(_ROOM) is None:",
        "if False:",
        LEFT_OUT,
    ),
    Mutant(
        "the command line needs the paper's room",
        "src/nonsmooth/room.py",
        'if find_spec(f"{package}.{SHORTCUTS}") is None:',
        "if False:",
        LEFT_OUT,
    ),
    Mutant(
        "a bare command without its own is about no scene",
        "src/nonsmooth/cli/scenes/command.py",
        "if scene is None and (self.own or self.all_without):",
        "if scene is None:",
        LEFT_OUT,
    ),
    Mutant(
        "a generic module takes a number from the paper's room",
        "solver/trade/tolerance.py",
        "from .not_certified import MARGIN",
        "from .shortcuts.choice.tolerance import MARGIN",
        IMPORTS,
    ),
    Mutant(
        "a generic module knows a method of the paper",
        "solver/accuracy/estimate.py",
        "MORE, LEAST, MOST = 4, 20, 60",
        "MORE, LEAST, MOST, OTHER = 4, 20, 60, \"hb-c1\"",
        ROOMS,
    ),
    Mutant(
        "an import closes a cycle",
        "codegen/system.py",
        "from typing import Any\n",
        "from typing import Any\n\nfrom .printing import latex\n",
        IMPORTS,
    ),
    Mutant(
        "slip is integrated at import",
        "codegen/shortcuts/paper/inner_product.py",
        "@dataclass(frozen=True)\nclass Entry:",
        "_EARLY = sp.integrate(t, (t, t1, T))\n\n\n@dataclass(frozen=True)\nclass Entry:",
        DERIVED,
    ),
)  # fmt: skip
