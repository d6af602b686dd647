"""`family` for any oscillator: the paper's, or a case of any scene."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, overload

import numpy.typing as npt

if TYPE_CHECKING:
    from .solver.case.case import Case
    from .solver.family import SceneFamily
    from .solver.shortcuts.orbit.oscillator import StickSlip
    from .solver.shortcuts.search.family import Family


@overload
def family(
    case: "StickSlip",
    parameter: str,
    values: npt.ArrayLike,
    method: str | None = None,
    order: int | None = None,
    *,
    c1_terms: int = 1,
) -> "Family": ...


@overload
def family(
    case: "Case",
    parameter: str,
    values: npt.ArrayLike,
    method: str | None = None,
    order: int | None = None,
    *,
    functions: int | None = None,
    progress: Callable[[Any], None] = lambda row: None,
) -> "SceneFamily": ...


def family(
    case: Any,
    parameter: str,
    values: npt.ArrayLike,
    method: str | None = None,
    order: int | None = None,
    **more: Any,
) -> "Family | SceneFamily":
    """Return the orbits of an oscillator as one of its parameters takes many values.

    Parameters
    ----------
    case : StickSlip or Case
        The oscillator.
    parameter : str
        Its name.
    values : array_like of float, shape (n,)
        What it becomes, in SI units.  An orbit of a `Case` is looked for from that at the
        value before.
    method : str, optional
        See `solve`; without it ``"c1"`` of a `StickSlip`, ``"ck-tau"`` of a `Case`.
    order : int, optional
        ``N``; without it one at which these have converged to rounding.
    c1_terms : int
        C1 functions of ``"hb-c1"`` of a `StickSlip`.
    functions : int, optional
        Functions of ``"hb-ck"`` at each switch of a `Case`.
    progress : callable, optional
        Called with each row of a `Case` when it is done.

    Raises
    ------
    TypeError
        If `case` is neither.
    ValueError
        If the parameter, the method or the order is not one that there is, or a value
        makes no oscillator (`ParameterError`).

    Examples
    --------
    >>> import nonsmooth as ns
    >>> along = ns.family(ns.scene("impact")(), "gap", [0.0, 0.1, 0.2])
    >>> along["forcing_phase"].round(6)
    array([0.761291, 0.929644, 1.103021])
    >>> belt = ns.StickSlip(mass=10, stiffness=1000, belt_speed=1,
    ...                     mu_s=0.5, mu_k=0.25, normal_force=400)
    >>> orbits = ns.family(belt, "belt_speed", [0.5, 1.0, 2.0])
    >>> orbits["period"].round(6)
    array([0.806889, 0.671239, 0.635589])
    """
    given: Any = {
        name: v for name, v in (("method", method), ("order", order)) if v is not None
    }
    from .solver.case.case import Case  # noqa: PLC0415

    if isinstance(case, Case):
        from .solver.family import family_case  # noqa: PLC0415

        return family_case(case, parameter, _numbers(values), **given, **more)
    from .solver.shortcut import entrance_of  # noqa: PLC0415

    own: Family = entrance_of(case).family(case, parameter, values, **given, **more)
    return own


def _numbers(values: npt.ArrayLike) -> list[float]:
    """Return values as a list of numbers; what is not one is refused."""
    import numpy as np  # noqa: PLC0415

    try:
        numbers: list[float] = np.atleast_1d(np.asarray(values, dtype=float)).ravel().tolist()
    except (TypeError, ValueError):
        raise ValueError(f"values: got {values!r:.80}, expected numbers") from None
    return numbers
