"""Method and order by tolerances or by a budget: which of the two, and both not at once."""

from collections.abc import Callable

from ..orbit.methods import METHODS
from ..orbit.oscillator import StickSlip
from .budget import fitting
from .choice import Choice
from .tolerance import within


def choose(
    belt: StickSlip,
    method: str | None,
    order: int | None,
    tol: float | None,
    tol_acceleration: float | None,
    budget: float | None,
    *,
    many: bool = False,
    progress: Callable[[str], None] = lambda now: None,
) -> Choice:
    """Return what the tolerances or the budget lead to; see `within` and `fitting`.

    Raises
    ------
    ValueError
        If an order is given, or tolerances and a budget, or one of them is wrong.
    """
    if order is not None:
        raise ValueError(f"order: got {order!r} beside a tolerance or budget, which chooses it")
    methods = tuple(METHODS) if method is None else (method,)
    if budget is None:
        return within(
            belt, tol, tol_acceleration, methods=methods, many=many, progress=progress
        )
    if tol is not None or tol_acceleration is not None:
        raise ValueError(f"budget: got {budget!r} beside a tolerance, expected one of them")
    return fitting(belt, budget, methods=methods, progress=progress)
