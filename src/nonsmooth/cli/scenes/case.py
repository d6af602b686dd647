"""The case of a scene that flags and a case file describe, and what of it varies."""

from nonsmooth.kim_perkins import as_in_paper
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.loaded import LoadedScene
from nonsmooth.solver.scenes.parameter_error import ParameterError
from nonsmooth.solver.solve import with_order

from ..about import Given
from ..problems import Problem, as_problems
from ..values import Vary, parse_vary
from .options import range_of


def case_from(given: Given[LoadedScene], **settings: float) -> Case:
    """Return the case that the command line describes, of the motion that it names if any.

    Without a case file, what no flag gives has its default; `settings` are given beside them.
    A `Problem` has all mistakes at once.
    """
    scene, flags = given.about, {**given.flags, **settings}
    motion, phases = (flags.pop(name, None) for name in ("motion", "phases"))
    if motion is not None and phases is not None:
        raise Problem(f"--phases: got {phases} beside --motion {motion}, expected one of them")
    cycles = flags.pop("cycles", 1)
    table = given.table()
    missing = [
        f"{q.name}: missing, expected {q.what}{f' in {q.unit}' if q.unit else ''}"
        for q in scene.parameters
        if given.file is not None and q.name not in table and q.name not in flags
    ]
    wrong: list[str] = []
    try:
        own_cycles = 1 if phases is not None else cycles  # those of its order
        case = as_in_paper(Case(scene, table | flags, own_cycles))
    except ParameterError as error:
        wrong = [_as_flag(line) for line in error.errors]
    if wrong or missing:  # a name that is misspelled before that which it should have been
        first, *further = wrong + missing
        raise Problem(given.where + first, below=further)
    with as_problems():
        if phases is not None:
            return with_order(case, str(phases), cycles)
        return case if motion is None else case.of_motion(motion)


def _as_flag(line: str) -> str:
    """Return what is wrong with a case; the cycles, which no table has, by their flag."""
    return f"--{line}" if line.startswith("cycles: got") else line


def vary_from(
    given: Given[LoadedScene], text: str, most: int | None, points: str = "", log: bool = False
) -> Vary[float]:
    """Return what ``--vary`` asks for, of a scene; see `parse_vary`."""
    names = [q.name for q in given.about.parameters]
    example = f"{range_of(given.about.parameters[-1])}{points}"
    return parse_vary(text, log, names, most, example, float)
