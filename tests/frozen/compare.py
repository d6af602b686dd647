"""Compare documents whose numbers are in hexadecimal."""

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from nonsmooth.solver.accuracy.rates import slope
from nonsmooth.solver.shortcuts.accuracy.convergence import FLOORS

FOLDER = Path(__file__).resolve().parent

#: Where libraries or processor are others than those of the frozen files, what must agree
#: nevertheless, and the part of a number by which it may differ: rounding, and what the
#: condition of the printed forms makes of it.
TIMES = frozenset({"period", "t1", "slip", "value", "alpha"})
ROUNDING = 1e-11

#: Rounding of an error of times, as a part of the period: the times of a sweep over low orders
#: are right to 1e-15, seldom to 1e-14 (``nonsmooth digits``).
OF_AN_ERROR = 1e-14


def pairs(old: Any, new: Any, place: str = "") -> Iterator[tuple[str, Any, Any]]:
    """Yield the values of two documents, side by side, with the place where they stand."""
    if isinstance(old, dict) and isinstance(new, dict):
        for key in sorted(old.keys() | new.keys()):
            yield from pairs(old.get(key), new.get(key), f"{place}.{key}")
    elif isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        for index, (before, after) in enumerate(zip(old, new, strict=True)):
            yield from pairs(before, after, f"{place}[{index}]")
    else:
        yield place, old, new


def _is_time(place: str) -> bool:
    """Whether a place holds a time or what it depends on, and not an error of one."""
    *around, key = place.split(".")
    return key in TIMES and not {"errors", "estimate"} & set(around)


def _number(value: Any) -> float | None:
    try:
        return float.fromhex(value) if isinstance(value, str) else None
    except ValueError:
        return None


def _change(old: Any, new: Any) -> float:
    """Return by which part of itself a number has changed; infinite if it was none."""
    before, after = _number(old), _number(new)
    if before is None or after is None:
        return math.inf
    return abs(after - before) / max(abs(before), 1e-300)


def differences(old: Any, new: Any, *, exactly: bool) -> list[str]:
    """Return the places in which two documents differ: in a bit, or beyond rounding."""
    found = []
    rates = {} if exactly else dict(explained_by_rounding(old))
    for place, before, after in pairs(old, new):
        steps = place.endswith(".iterations")  # of a corner case it may take one more or less
        rounding = (
            not exactly and (_number(before) is not None or steps) and not _is_time(place)
        )
        if before == after or rounding:
            continue
        if abs((_number(before) or 0.0) - (_number(after) or math.inf)) <= rates.get(place, 0):
            continue
        if exactly or place in rates or _change(before, after) > ROUNDING:
            found.append(f"{place}: {before} was frozen, {after} is what it is")
    return found


def explained_by_rounding(document: Any) -> Iterator[tuple[str, float]]:
    """Yield the place of each fitted rate of times, and by how much rounding may change it.

    A rate is fitted to logarithms of errors.  Those of a method that converges fast end near
    rounding, where a last bit of a time is a large part of its error, and so of the rate.
    """
    for index, row in enumerate(document if isinstance(document, list) else ()):
        for method, rates in row.get("rates", {}).items():
            orbits = [q for q in row["rows"] if q["method"] == method and q["errors"]]
            for name in (q for q in TIMES & rates.keys() if rates[q] is not None):
                errors = {q["order"]: float.fromhex(q["errors"][name]) for q in orbits}
                power = rates["kind"] == "power"
                yield f"[{index}].rates.{method}.{name}", _sensitivity(errors, name, power)


def _sensitivity(errors: dict[int, float], name: str, power: bool) -> float:
    """Return by how much a rate changes at most where every error changes by its rounding."""

    def fitted(changed: dict[int, float]) -> float:
        found = {**errors, **changed}.items()
        return slope(found, FLOORS[name], power=power, upper_half=True) or math.inf

    return sum(
        max(abs(fitted({order: error + d}) - fitted({})) for d in (-OF_AN_ERROR, OF_AN_ERROR))
        for order, error in errors.items()
    )


def largest_change(old: Any, new: Any) -> float:
    """Return the largest part by which a time has changed."""
    changes = [
        _change(before, after)
        for place, before, after in pairs(old, new)
        if _is_time(place) and before != after
    ]
    return max(changes, default=0.0)
