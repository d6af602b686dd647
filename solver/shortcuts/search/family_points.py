"""The points of a family, computed: times, amplitude and estimates of many orbits at once.

For the C1 series the times come from the scalar equation of the batch, and Newton's method on
the whole system, by its bands, takes them to their last digits; what it does not reach, and a
Fourier series, is left to `solve`.
"""

from collections.abc import Mapping
from dataclasses import asdict, replace
from types import MappingProxyType
from typing import Any

import numpy as np
import numpy.typing as npt

from ...arrays import Vector
from ...no_orbit import NoOrbit
from ..accuracy.estimate import CONVERGED_ORDER, CORRECTIONS, ROUNDING, STEPS
from ..orbit.methods import Method
from ..orbit.orbit import Orbit
from ..orbit.oscillator import StickSlip, alpha_of, time_unit_of
from ..polynomials.batch import OK, c1_times
from . import kernels
from .solve import solve

#: Largest relative change of the period that the last digits may bring.
SAME_ORBIT = 1e-9

#: Order up to which the bands keep the last digits of t1, and alpha from which they do, up to
#: an order and beyond it.  At alpha = 1e-6 they leave 1e-11 T, at N = 400 6e-12 T.
MOST_BY_BANDS = 104
LEAST_BY_BANDS, FEW_FUNCTIONS, LEAST_BY_WIDE_BANDS = 1e-5, 48, 1e-3

#: What `Family.points` says of a point, and the words for it.
STATUS = ("ok", "no-orbit", "not-converged")

#: The columns of a family, with their units.
COLUMNS: Mapping[str, str] = MappingProxyType(
    {
        "value": "of the parameter",
        "alpha": "1",
        "t1": "s",
        "period": "s",
        "amplitude": "m",
        "stick_fraction": "1",
        "estimate_period": "1",
        "estimate_t1": "1",
    }
)
POINT = np.dtype([("status", "<i8"), *((name, "<f8") for name in COLUMNS)])


def with_value(belt: StickSlip, parameter: str, value: float) -> StickSlip:
    """Return the oscillator with another value of one parameter."""
    changed: dict[str, Any] = {parameter: value}
    return replace(belt, **changed)


def points(
    belt: StickSlip, parameter: str, values: Vector, method: Method, order: int
) -> npt.NDArray[np.void]:
    """Return the points of a family; see `Family`.  The arguments have been checked."""
    given = asdict(belt) | {parameter: values}
    time_unit = time_unit_of(given, np.sqrt)
    found = np.zeros(len(values), dtype=POINT)  # status: ok
    for name in COLUMNS:
        found[name] = np.nan
    found["value"], found["alpha"] = values, alpha_of(given, np.sqrt)
    if method.c1_terms is None:
        found["t1"], found["period"], found["amplitude"] = by_bands(found["alpha"], order)
    correction = np.zeros(len(values))
    for i in np.flatnonzero(np.isnan(found["period"])):
        one = with_value(belt, parameter, float(values[i]))
        correction[i] = _solve(found[i : i + 1], one, method, order)
    _estimate(found, method, order, correction)
    for i in np.flatnonzero(np.isnan(found["estimate_period"]) & (found["status"] == OK)):
        one = with_value(belt, parameter, float(values[i]))
        judged = _orbit(one, method, order).estimate
        found["estimate_period"][i], found["estimate_t1"][i] = judged.period, judged.t1
    found["t1"] *= time_unit
    found["period"] *= time_unit
    found["amplitude"] *= given["belt_speed"] * time_unit
    found["stick_fraction"] = found["t1"] / found["period"]
    return found


def fits_bands(alpha: Vector, order: int) -> npt.NDArray[np.bool_]:
    """Return whether the bands keep the last digits of t1, for each alpha."""
    least = LEAST_BY_BANDS if order <= FEW_FUNCTIONS else LEAST_BY_WIDE_BANDS
    return np.asarray((alpha >= least) & (order <= MOST_BY_BANDS))


def by_bands(alpha: Vector, order: int) -> tuple[Vector, Vector, Vector]:
    """Return t1, T, amplitude of many C1 orbits, dimensionless; NaN where not found."""
    if order > MOST_BY_BANDS:
        nothing = np.full((3, len(alpha)), np.nan)
        return nothing[0], nothing[1], nothing[2]
    first = c1_times(alpha, order)
    t1, T, amplitude = first.t1.copy(), first.T.copy(), np.empty(len(alpha))
    status = np.empty(len(alpha), dtype=np.int64)
    functions = kernels.compiled_functions("c1")
    tables = functions["band_tables"](order)
    functions["orbits"](first.alpha, *tables, t1, T, amplitude, status)
    same = (status == OK) & (np.abs(T - first.T) <= SAME_ORBIT * T)
    same &= fits_bands(alpha, order)
    for column in (t1, T, amplitude):
        column[~same] = np.nan
    return t1, T, amplitude


def _orbit(belt: StickSlip, method: Method, order: int) -> Orbit:
    return solve(belt, method.name, order, c1_terms=method.c1_terms or 1, many=True)


def _solve(point: npt.NDArray[np.void], belt: StickSlip, method: Method, order: int) -> float:
    """Fill one point by `solve`, dimensionless; return the last correction of Newton."""
    try:
        orbit = _orbit(belt, method, order)
    except NoOrbit as finding:
        point["status"] = STATUS.index(finding.status)
        return 0.0
    point["t1"], point["period"] = orbit.unknowns[-2:]
    point["amplitude"] = orbit.amplitude / belt.length_unit
    return orbit.outcome.correction


def _estimate(
    found: npt.NDArray[np.void], method: Method, order: int, correction: Vector
) -> None:
    """Estimate the errors of the times, dimensionless, as `estimate` does."""
    alpha, t1, T = found["alpha"], found["t1"], found["period"]
    if method.c1_terms is None:
        up, down = order + STEPS[0], order + STEPS[-1]
        near_t1, near_T, _ = by_bands(alpha, up if up <= method.highest_order else down)
        doubt_t1 = doubt_T = np.zeros(len(alpha))
    else:
        near_t1, near_T, _ = by_bands(alpha, CONVERGED_ORDER)
        beyond_t1, beyond_T, _ = by_bands(alpha, CONVERGED_ORDER + STEPS[0])
        doubt_t1, doubt_T = np.abs(beyond_t1 - near_t1), np.abs(beyond_T - near_T)
    rounding = (ROUNDING + CORRECTIONS * correction) * near_T
    found["estimate_t1"] = (np.abs(t1 - near_t1) + doubt_t1 + rounding) / near_t1
    found["estimate_period"] = (np.abs(T - near_T) + doubt_T + rounding) / near_T
