"""``nonsmooth sweep SCENE``: how fast its methods converge, or its orbit along a parameter.

And ``nonsmooth tradeoff SCENE``: error against time, measured on this machine.
"""

from functools import cache
from typing import Any

from nonsmooth.files import documents
from nonsmooth.solver.family import MOST_VALUES, family
from nonsmooth.solver.kernels.registry import methods as methods_of
from nonsmooth.solver.results.interrupted import Interrupted
from nonsmooth.solver.results.sweep import SweepRow
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.loaded import LoadedScene
from nonsmooth.solver.scenes.methods import shown
from nonsmooth.solver.sweep import sweep
from nonsmooth.solver.trade import measured

from ..about import Given
from ..aliases import split_methods
from ..output import Destination, drawn_by
from ..problems import PLURAL, Problem, as_problems, tell_none
from ..progress import progress
from ..values import ORDERS, Vary, is_whole, parse_orders, values_of
from . import tables
from .case import case_from, vary_from
from .options import generic_methods


def run(
    given: Given[LoadedScene], to: Destination, vary: str | None, log: bool, **options: Any
) -> int:
    """Sweep along a parameter or over orders; the exit status."""
    if vary is not None:
        along = vary_from(given, vary, MOST_VALUES, ":20", log)
        given.check_varies(along.parameter)
        case = case_from(given, **{along.parameter: along.first})
        return _along(case, to, along, **options)
    if log:
        raise Problem("--log: expected beside --vary")
    return _over_orders(case_from(given), to, **options)


def _over_orders(
    case: Case, to: Destination, methods: str | None, orders: str | None, functions: int | None
) -> int:
    """Sweep over orders, show it, write it; the exit status."""
    numbers = parse_orders(ORDERS if orders is None else orders)
    with as_problems(PLURAL):
        names = generic_methods(case.scene, split_methods(methods)) or None
        total = len(names or methods_of(case.scene)) * len(numbers)
        with progress(total, "sweep") as advance:

            def done(row: SweepRow) -> None:
                advance(f"{shown(case.scene, row.method)}, N = {row.order}")

            result = sweep(case, names, numbers, functions=functions, progress=done)
    text = cache(lambda: documents.text(result.case, result.as_dict(), result.rates()))
    to.show(text, tables.convergence(result))
    tell_none([row.message for row in result.rows])
    to.write(text, drawn_by("sweeps.convergence_figure", result), result)
    return 0 if all(row.status == "ok" for row in result.rows) else 1


def _along(
    case: Case, to: Destination, vary: Vary[float], methods: str | None, orders: str | None,
    functions: int | None,
) -> int:  # fmt: skip
    """Follow the orbit along a parameter, show it, write it; the exit status.

    A `Problem` is raised if an argument is wrong; or after Ctrl-C, once what was computed is
    shown and written.
    """
    if orders is not None and not is_whole(orders):
        raise Problem(f"--orders: got {orders!r} beside --vary, expected one order")
    if methods is not None and "," in methods:
        raise Problem(f"--methods: got {methods!r} beside --vary, expected one method")
    expansion = methods and methods.strip(), None if orders is None else int(orders)
    interrupt = None
    with as_problems(PLURAL, "--vary: "), progress(vary.count, "sweep") as advance:
        try:
            result = family(
                case, vary.parameter, values_of(vary), *expansion, functions=functions,
                progress=lambda row: advance(f"{vary.flag} = {row.value:g}"),
            )  # fmt: skip
        except Interrupted as error:
            interrupt, result = error, error.done
    text = cache(lambda: documents.text(case, result.as_dict(), [result.method]))
    to.show(text, tables.family(result))
    tell_none([row.message for row in result.rows])
    to.write(text, drawn_by("families.family_figure", result, vary.log), result)
    if interrupt:
        raise Problem(f"interrupted: {interrupt}", 130)
    return 0 if all(row.status == "ok" for row in result.rows) else 1


def trade(given: Given[LoadedScene], to: Destination) -> int:
    """Measure, show, write; the exit status."""
    case = case_from(given)
    with as_problems(), progress(1 + len(measured.ways(case)), "tradeoff") as advance:
        result = measured.trade(case, advance)
    methods = dict.fromkeys(method for method, _ in measured.ways(case))
    text = cache(lambda: documents.text(case, result.as_dict(), methods))
    to.show(text, tables.trade(result))
    to.write(text, drawn_by("sweeps.trade_figure", result))
    return 0
