"""``nonsmooth digits SCENE``: digits that float64 keeps of orbits at a scene's extremes."""

from collections.abc import Iterator
from dataclasses import asdict
from functools import cache

import click

from nonsmooth.files import documents
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.precision import digits
from nonsmooth.solver.precision.digits import ABSENT, CONDITIONED, LOST, TARGET, Kept
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.loaded import LoadedScene
from nonsmooth.solver.scenes.methods import EXACT, shown
from nonsmooth.solver.search import HIGHEST_ORDER

from ..about import Given
from ..aliases import split_methods
from ..columns import Piece, filled, table_of
from ..output import Destination, drawn_by
from ..problems import PLURAL, Problem, as_problems, say
from ..progress import progress
from ..values import parse_orders
from .captions import caption
from .case import case_from
from .options import generic_methods

#: The command as earlier versions called it, and what is said where it is called so.
OLD_NAME = "stability"
RENAMED = "it is now `nonsmooth digits`; whether an orbit is stable is said by `solve`"

LEGEND = f"""digits: of 16, on which the times (durations{{and_phase}}) in float64
agree with the same equations in 22 digits, as a part of the period; each starts from the exact
orbit's times. orbit: condition number of the times as functions of the parameters, whatever
computes them; cond: the largest of the scaled Jacobians. {CONDITIONED}: fewer than 13, less
what the orbit itself loses, but no fewer than the condition of the method's equations explains;
{LOST}: fewer than that; {ABSENT}: no way to an orbit at this order, which may not resolve a
phase."""


def run(
    given: Given[LoadedScene], to: Destination, methods: str | None, orders: str | None,
    quick: bool,
) -> int:  # fmt: skip
    """Measure, show, write; the exit status."""
    if (click.get_current_context().info_name or "").startswith(OLD_NAME):
        say(f"{OLD_NAME}: {RENAMED}")
    case = case_from(given)
    if quick and orders is not None:
        raise Problem(f"--quick: got --orders {orders} beside it, expected one of them")
    numbers = digits.QUICK_ORDERS if quick else digits.ORDERS
    if orders is not None:
        numbers = tuple(parse_orders(orders))
    if max(numbers) > HIGHEST_ORDER:
        raise Problem(f"--orders: got {max(numbers)}, expected at most {HIGHEST_ORDER}")
    names = list(registry.methods(case.scene))
    if methods is not None:
        with as_problems(PLURAL):
            names = generic_methods(case.scene, split_methods(methods))
    with as_problems(of=f"an extreme of {case.scene.name}: "):
        cases = digits.extremes(case)
    if len(cases) == 1:
        hint = "its field `extremes` names none, so that only these parameters are measured"
        say(f"{case.scene.name}: {hint}")
    total = len(cases) * (1 + len(names) * len(numbers))
    with progress(total, "digits") as advance, as_problems(of=""):

        def done(kept: Kept) -> None:
            order = "" if kept.order is None else f", N = {kept.order}"
            advance(f"{kept.extreme or 'given'}: {shown(case.scene, kept.method)}{order}")

        measured = digits.measure(case, numbers, names, done)
    text = cache(lambda: documents.text(case, _document(case, measured), names))
    to.show(text, _pieces(case, measured))
    to.write(text, drawn_by("digits.digits_figure", case, measured))
    return 1 if any(kept.lost for kept in measured) else 0


def _document(case: Case, measured: list[Kept]) -> dict[str, object]:
    rows = [
        asdict(kept) | {"digits": kept.digits, "met": kept.met, "conditioned": kept.conditioned}
        for kept in measured
    ]
    head = {"scene": case.scene.name, "parameters": dict(case.values)}
    return head | {"lost": any(kept.lost for kept in measured), "rows": rows}


def _pieces(case: Case, measured: list[Kept]) -> Iterator[Piece]:
    """Show the digits, and what the columns mean."""
    yield caption(case)
    orders = sorted({kept.order for kept in measured if kept.order is not None})
    heads = [f"N = {orders[0]}", *map(str, orders[1:])] if orders else []
    columns = table_of("", "orbit", "exact", *heads, "cond")
    for extreme in dict.fromkeys(kept.extreme for kept in measured):
        of_extreme = [kept for kept in measured if kept.extreme == extreme]
        exact = next(kept for kept in of_extreme if kept.method == EXACT)
        sensitive = exact.orbit_condition
        orbit = exact.status if sensitive is None else f"{sensitive:.0e}"
        columns.add_row(extreme or "as given", orbit, exact.words)
        for method in dict.fromkeys(q.method for q in of_extreme if q.method != EXACT):
            rows = {kept.order: kept for kept in of_extreme if kept.method == method}
            largest = max((q.condition for q in rows.values() if q.condition), default=None)
            columns.add_row(
                f"  {shown(case.scene, method)}",
                "",
                "",
                *(rows[order].words for order in orders),
                "" if largest is None else f"{largest:.0e}",
            )
    yield columns
    with_error = [kept for kept in measured if kept.error is not None]
    counts = (sum(bool(kept.met) for kept in with_error), sum(kept.lost for kept in with_error))
    yield (
        f"\n{counts[0]} of {len(with_error)} within {TARGET:g} times the orbit's condition; "
        f"{counts[1]} lost without a reason\n"
    )
    also = " and the phase of the forcing" if case.scene.frequency else ""
    yield filled(LEGEND.format(and_phase=also))
