"""Newton's method, linked to the functions of a kernel: plain, or compiled with them."""

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from ..arrays import Matrix, Vector
from ..compiling import rebuilt
from ..iteration import bands, condensed, iteration, linear, single
from ..iteration.iteration import Iteration

#: Functions that are compiled with a kernel, callers after what they call.
DRIVER: tuple[Any, ...] = (
    iteration.greatest,
    iteration.step_size,
    iteration.longest_damping,
    iteration.scale_rows,
    linear.factorise,
    linear.solve_factorised,
    iteration.correct,
    iteration.add,
    iteration.iterate_scene,
)

#: Functions that are compiled with a kernel whose bands are solved for by themselves.
CONDENSED: tuple[Any, ...] = (
    bands.eliminate_row,
    bands.factorise_band,
    bands.substitute,
    bands.solve_columns,
    linear.least_squares,
    condensed.condensed_residual,
    condensed.complete,
    condensed.condensed_jacobian,
    condensed.workplace,
    condensed.fitted,
)

#: Functions that are compiled where a single unknown is left.
SINGLE: tuple[Any, ...] = (single.size_of, single.limited, single.iterate_single)

#: Where they stand.
DRIVER_FILES = (iteration, linear, bands, condensed, single)

#: Functions that stay calls when compiled: large, and called from several places.
CALLS = frozenset(("residual", "jacobian", "iterate_scene", "iterate_condensed"))

#: So do these, where more than a single unknown is left.
CALLS_OF_SEVERAL = CALLS | {"condensed_residual", "condensed_jacobian"}

#: Makes a function over a namespace, plain or compiled.
Make = Callable[[Any, dict[str, Any]], Any]


def linked(
    residual: Callable[[Any, Vector, Vector], None],
    jacobian: Callable[[Any, Vector, Matrix], None],
    durations: int,
    forced: bool,
) -> Iteration:
    """Return `iteration.iterate_scene` for a residual and Jacobian, as plain Python."""
    namespace = {
        "residual": residual,
        "jacobian": jacobian,
        "DURATIONS": durations,
        "FORCED": forced,
    }
    return iteration_of(namespace, rebuilt)


def _several(kernel: dict[str, Any], make: Make) -> Iteration:
    """Return Newton's method for a residual and a Jacobian of several unknowns."""
    namespace = {**vars(iteration), **kernel}
    for function in DRIVER:
        namespace[function.__name__] = make(function, namespace)
    iterate: Iteration = namespace["iterate_scene"]
    return iterate


def _single(kernel: dict[str, Any], make: Make) -> Iteration:
    """Return it for one unknown."""
    namespace = {**vars(single), **kernel}
    for function in SINGLE:
        namespace[function.__name__] = make(function, namespace)
    iterate: Iteration = namespace["iterate_single"]
    return iterate


def iteration_of(kernel: dict[str, Any], make: Make) -> Iteration:
    """Return the iteration for the functions of a kernel, itself and all it calls by `make`."""
    if "bands" not in kernel:
        return _several(kernel, make)
    namespace = {**vars(linear), **vars(condensed), **kernel}
    for function in CONDENSED:
        namespace[function.__name__] = make(function, namespace)
    remaining = {
        "residual": namespace["condensed_residual"],
        "jacobian": namespace["condensed_jacobian"],
        "DURATIONS": kernel["KEPT_DURATIONS"],
        "FORCED": kernel["KEPT_FORCED"],
    }
    if kernel["KEPT"] == 1:
        namespace["iterate_scene"] = _single(remaining, make)
    else:
        namespace["iterate_scene"] = _several({**remaining, "FAST": condensed.FAST}, make)
    whole: Iteration = make(condensed.iterate_condensed, namespace)
    return whole


@cache
def driver_text() -> bytes:
    """Return the text of what is compiled with every kernel."""
    return b"".join(Path(str(part.__file__)).read_bytes() for part in DRIVER_FILES)
