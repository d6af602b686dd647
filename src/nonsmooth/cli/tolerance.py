"""``nonsmooth solve --tol``: method and order by the accuracy that is asked for."""

from typing import TYPE_CHECKING

import click

from .equations import METHODS
from .problems import Problem

if TYPE_CHECKING:
    from nonsmooth.solver.belt import StickSlip
    from nonsmooth.solver.tolerance import Choice


def choose(
    belt: "StickSlip",
    method: str | None,
    order: int | None,
    tol: float | None,
    tol_acceleration: float | None,
) -> "Choice":
    """Return the cheapest orbit within the tolerances.

    Raises
    ------
    Problem
        If a tolerance is no such thing, or comes with an order; with status 1 if float64
        cannot meet it.
    """
    from nonsmooth.solver.belt import ParameterError  # noqa: PLC0415
    from nonsmooth.solver.tolerance import NotCertified, within  # noqa: PLC0415

    if order is not None:
        raise Problem(f"--order: got {order} beside a tolerance, which chooses it")
    methods = METHODS if method is None else (method,)
    try:
        return within(belt, tol, tol_acceleration, methods=methods)
    except ParameterError as error:
        raise Problem(str(error)) from error
    except ValueError as error:
        raise Problem("--" + str(error).replace("_", "-", 1)) from error
    except NotCertified as finding:
        more = "more digits: nonsmooth solve --method c1 --order 40 --digits 30"
        raise Problem(f"{finding}; {more}", status=1) from finding


def why(choice: "Choice") -> str:
    """Return why this orbit was chosen, in a sentence or two."""
    orbit, trials = choice.orbit, choice.trials
    text = (
        f"{orbit.method}, N = {orbit.order}: the cheapest of the candidates whose estimated "
        f"error is within the tolerance, {len(trials)} tried"
    )
    best = {}
    for trial in trials[:-1]:
        if trial.estimate is not None and trial.estimate.period < float("inf"):
            best[trial.method] = f"{trial.method} {trial.order}: {trial.estimate.period:.1e}"
    if best:
        text += f" (before it, period: {', '.join(best.values())})"
    return click.wrap_text(text + ".", width=80)
