"""``nonsmooth digits SCENE``: digits that float64 keeps of orbits at a scene's extremes."""

from dataclasses import asdict

import click

from nonsmooth.files import documents
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.precision import digits
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.loaded import LoadedScene
from nonsmooth.solver.scenes.methods import shown
from nonsmooth.solver.search import HIGHEST_ORDER

from ..about import Given
from ..aliases import generic_methods
from ..output import Destination, drawn_by
from ..problems import PLURAL, Problem, as_problems, wrong_values
from ..progress import progress
from ..values import parse_orders
from .case import case_from
from .shown import digits_table

#: The command as earlier versions called it, and what is said where it is called so.
OLD_NAME = "stability"
RENAMED = "it is now `nonsmooth digits`; whether an orbit is stable is said by `solve`"


def run(
    given: Given[LoadedScene], to: Destination, methods: str | None, orders: str | None,
    quick: bool,
) -> int:  # fmt: skip
    """Measure, show, write; the exit status."""
    if (click.get_current_context().info_name or "").startswith(OLD_NAME):
        click.echo(f"nonsmooth: {OLD_NAME}: {RENAMED}", err=True)
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
            names = generic_methods(case.scene, methods)
    with wrong_values(f"an extreme of {case.scene.name}: "):
        cases = digits.extremes(case)
    if len(cases) == 1:
        hint = "its field `extremes` names none, so that only these parameters are measured"
        click.echo(f"nonsmooth: {case.scene.name}: {hint}", err=True)
    total = len(cases) * (1 + len(names) * len(numbers))
    with progress(total, "digits") as advance, wrong_values():

        def done(kept: digits.Kept) -> None:
            order = "" if kept.order is None else f", N = {kept.order}"
            advance(f"{kept.extreme or 'given'}: {shown(case.scene, kept.method)}{order}")

        found = digits.measure(case, numbers, names, done)
    text = documents.text(case, _document(case, found), names)
    to.show(text, digits_table.pieces(case, found))
    to.write(text, drawn_by("digits.digits_figure", case, found))
    return 1 if any(kept.lost for kept in found) else 0


def _document(case: Case, found: list[digits.Kept]) -> dict[str, object]:
    rows = [
        asdict(kept) | {"digits": kept.digits, "met": kept.met, "conditioned": kept.conditioned}
        for kept in found
    ]
    head = {"scene": case.scene.name, "parameters": dict(case.values)}
    return head | {"lost": any(kept.lost for kept in found), "rows": rows}
