"""``nonsmooth solve --tol`` and ``--budget``: method and order by accuracy or by time."""

from typing import TYPE_CHECKING

import click

from ..problems import Problem
from ..progress import busy

if TYPE_CHECKING:
    from nonsmooth.solver.shortcuts.choice.choice import Choice
    from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip


def choose(
    belt: "StickSlip",
    method: str | None,
    order: int | None,
    tol: float | None,
    tol_acceleration: float | None,
    budget: float | None,
) -> "Choice":
    """Return the cheapest orbit within the tolerances, or the best within the budget.

    Raises
    ------
    Problem
        If a tolerance is not a number between 0 and 1, or comes with an order; with status 1
        if float64 cannot meet it, or nothing is quick enough.
    """
    from nonsmooth.solver.case.parameters import ParameterError  # noqa: PLC0415
    from nonsmooth.solver.shortcuts.choice.choose import choose as find  # noqa: PLC0415
    from nonsmooth.solver.trade.not_certified import NotCertified, TooSlow  # noqa: PLC0415

    try:
        with busy(f"choosing {method or 'a method'}") as say:
            return find(belt, method, order, tol, tol_acceleration, budget, progress=say)
    except ParameterError as error:
        raise Problem(str(error)) from error
    except ValueError as error:
        name, colon, rest = str(error).partition(":")
        raise Problem(f"--{name.replace('_', '-')}{colon}{rest}") from error
    except NotCertified as finding:
        more = "more digits: nonsmooth solve --method c1 --order 40 --digits 30"
        raise Problem(f"{finding}; {more}", status=1) from finding
    except TooSlow as finding:
        raise Problem(str(finding), status=1) from finding


def why(choice: "Choice") -> str:
    """Return why this orbit was chosen, in a sentence or two."""
    orbit, trials = choice.orbit, choice.trials
    chosen = next(t for t in trials if (t.method, t.order) == (orbit.method, orbit.order))
    if chosen.seconds is not None:
        return click.wrap_text(
            f"{orbit.method}, N = {orbit.order}: the smallest estimated error of the period "
            f"among {len(trials)} candidates that were timed; {chosen.seconds:.1e} s an orbit.",
            width=80,
        )
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
