"""The digits that float64 keeps, a row for each extreme and method, a column for each order."""

from collections.abc import Iterator

from nonsmooth.solver.precision.digits import ABSENT, CONDITIONED, LOST, TARGET, Kept
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.methods import EXACT, shown

from ...columns import Piece, filled, table_of
from .captions import caption

LEGEND = f"""digits: of 16, on which the times (durations{{and_phase}}) in float64
agree with the same equations in 22 digits, as a part of the period; each starts from the exact
orbit's times. orbit: condition number of the times as functions of the parameters, whatever
computes them; cond: the largest of the scaled Jacobians. {CONDITIONED}: fewer than 13, less
what the orbit itself loses, but no fewer than the condition of the method's equations explains;
{LOST}: fewer than that; {ABSENT}: no way to an orbit at this order, which may not resolve a
phase."""


def pieces(case: Case, found: list[Kept]) -> Iterator[Piece]:
    """Show the digits, and what the columns mean."""
    yield caption(case)
    orders = sorted({kept.order for kept in found if kept.order is not None})
    heads = [f"N = {orders[0]}", *map(str, orders[1:])] if orders else []
    columns = table_of("", "orbit", "exact", *heads, "cond")
    for extreme in dict.fromkeys(kept.extreme for kept in found):
        here = [kept for kept in found if kept.extreme == extreme]
        exact = next(kept for kept in here if kept.method == EXACT)
        sensitive = exact.orbit_condition
        orbit = exact.status if sensitive is None else f"{sensitive:.0e}"
        columns.add_row(extreme or "as given", orbit, exact.words)
        for method in dict.fromkeys(q.method for q in here if q.method != EXACT):
            rows = {kept.order: kept for kept in here if kept.method == method}
            largest = max((q.condition for q in rows.values() if q.condition), default=None)
            columns.add_row(
                f"  {shown(case.scene, method)}",
                "",
                "",
                *(rows[order].words for order in orders),
                "" if largest is None else f"{largest:.0e}",
            )
    yield columns
    measured = [kept for kept in found if kept.error is not None]
    counts = (sum(bool(kept.met) for kept in measured), sum(kept.lost for kept in measured))
    yield (
        f"\n{counts[0]} of {len(measured)} within {TARGET:g} times the orbit's condition; "
        f"{counts[1]} lost without a reason\n"
    )
    also = " and the phase of the forcing" if case.scene.frequency else ""
    yield filled(LEGEND.format(and_phase=also))
