"""``nonsmooth sweep STRUCTURE``: how fast the expansions of one mode converge."""

from functools import cache

from nonsmooth.files import documents
from nonsmooth.solver.space.convergence import Line, convergence
from nonsmooth.solver.space.expansions.methods import METHODS, check_forced, generic_method
from nonsmooth.solver.space.structure import Structure

from ..about import Given
from ..aliases import split_methods
from ..output import Destination, drawn_by
from ..problems import PLURAL, Problem, as_problems
from ..progress import progress
from ..values import ORDERS, parse_orders
from . import mode_tables
from .modes import attached_from


def run(
    given: Given[Structure], to: Destination, methods: str | None, orders: str | None,
    forced: str | None, mode: int | None,
) -> int:  # fmt: skip
    """Sweep, show it, write it; the exit status."""
    attached = attached_from(given)
    lines = _lines(given.about, methods, forced)
    numbers = parse_orders(ORDERS if orders is None else orders)
    number = 1 if mode is None else mode
    with as_problems(PLURAL), progress(len(lines) * len(numbers), "sweep") as done:
        study = convergence(attached, lines, numbers, number, done)
    text = cache(lambda: documents.text_of_modes(attached.structure, study.as_dict()))
    to.show(text, mode_tables.convergence(study))
    figure = drawn_by("modes.convergence_figure", study)
    to.write(text, figure, rows=lambda: study.as_dict()["rows"])
    if all(row.beta is None for row in study.rows):
        raise Problem(f"--mode: got {number}, no order has so many modes", 1)
    return 0


def _lines(structure: Structure, methods: str | None, forced: str | None) -> list[Line]:
    """Return the expansions that ``--methods`` and ``--forced`` name.

    A `Problem` is raised if one of them is unknown.
    """
    requested = METHODS if methods is None else split_methods(methods)
    with as_problems(PLURAL):
        names = list(dict.fromkeys(generic_method(structure, name) for name in requested))
        if forced is not None and "ritz-ck" not in names:
            raise ValueError(f"forced: got {forced!r}, {', '.join(names)} has no forced modes")
        parts = ["1"] if forced is None else [part.strip() for part in forced.split(",")]
        numbers = [int(part) if part.isdecimal() else part for part in parts]
        lines = []
        for name in names:
            if name == "ritz-ck":
                checked = [check_forced(structure, name, K) for K in numbers]  # type: ignore[arg-type]
                lines += [Line(name, K) for K in dict.fromkeys(checked)]
            else:
                lines.append(Line(name))
    return lines
