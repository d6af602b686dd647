"""Rows of a map: the motion at each point, and whether it is stable."""

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np

from ..arrays import Integers, Matrix, Vector
from ..branch import walk
from ..branch.bodies.course import BODIES
from ..branch.walk import MODULES
from ..kernels import linking
from ..kernels.compiling import rebuilt
from ..kernels.family import Family
from ..stability.stability import ROUNDING, of_monodromy
from . import filling, following
from .plane import Plane

#: Room for orbits at first; how many of a connected set are checked by the solver; if one is
#: refused, all are checked in sets of up to `MANY`.
ROOM, ASKED, MANY = 64, 4, 64

#: The stability of an orbit, the preferred first.
STABLE, NEITHER, UNSTABLE = 0, 1, 2


def linked(branches: Family, equations: Any, make: linking.Make) -> dict[str, Any]:
    """Return the functions of maps, plain or compiled, linked to those of branches."""
    form = branches.plain if make is rebuilt else branches.inner
    under = {name: q for name, q in form(walk.__name__).items() if callable(q)}
    return linking.made((filling, following), under, make)


#: The functions of maps for one mass, and for bodies.
FAMILY = Family(partial(linked, walk.FAMILY), (*MODULES, walk, following), long_calls=True)
OF_BODIES = Family(
    partial(linked, BODIES),
    (*BODIES.modules, walk, following),
    seconds=BODIES.seconds,
    long_calls=True,
)


def by(name: str, plane: Plane, *arguments: Any) -> Any:
    """Call a function of `filling` or `following`, by name, for a plane."""
    family = OF_BODIES if plane.course.family is BODIES else FAMILY
    given = plane.series, plane.table, *arguments
    with np.errstate(all="ignore"):
        return family.call(filling.__name__, name, *given)


def block_of(
    planes: Sequence[Plane], A: Vector, B: Vector, wide: float, seeds: Sequence[Matrix]
) -> Integers:
    """Return the preferred orbit at each point of some rows of a map, as a number.

    Parameters
    ----------
    A, B : ndarray
        The parameters of the columns and of these rows, from -1 to 1 over the map.
    seeds : sequence of ndarray, shape (m, n + 2)
        Known orbits of each plane.

    Returns
    -------
    ndarray of int, shape (rows, columns)
        ``stability * planes + plane``, where stability is `STABLE`, `NEITHER` or `UNSTABLE`:
        the least is preferred.  Without an orbit ``3 * planes``.
    """
    best = np.full(len(A) * len(B), 3 * len(planes))
    for number, (plane, plane_seeds) in enumerate(zip(planes, seeds, strict=True)):
        points, stable = orbits_of(plane, A, B, wide, plane_seeds)
        np.minimum.at(best, points, stable * len(planes) + number)
    return best.reshape(len(B), len(A))


def orbits_of(
    plane: Plane, A: Vector, B: Vector, wide: float, seeds: Matrix
) -> tuple[Integers, Integers]:
    """Return the points of all orbits of an order of phases, and their stability.

    A few of each connected set are checked by the solver, which demands more than is watched.
    If it refuses one, all of the set are checked; a large set is dropped.
    """
    n, size = seeds.shape[1] - 2, plane.perturbed
    nearby = seeds[(seeds[:, -1] > B[0] - wide) & (seeds[:, -1] < B[-1] + wide)]
    orbits = _room(4 * len(nearby) + ROOM, len(A) * len(B), n, size)
    begin, count = 0, by("sown", plane, A, B, wide, nearby, orbits)
    while begin < count:
        if count == len(orbits[0]):
            orbits = _larger(orbits, len(A) * len(B), n, size)
        begin, count = by("fill", plane, A, B, begin, count, orbits)
    Z, at, _, links, _, _, maps = (part[:count] for part in orbits)

    def is_one(k: int) -> bool:
        orbit = plane.orbit(np.append(Z[k], [A[at[k] % len(A)], B[at[k] // len(A)]]))
        return orbit is None or (orbit.outcome.converged and orbit.admissible)

    stable, counts = stability_of(plane, maps), np.ones(count, dtype=bool)
    for group in _linked(links):
        checked = group[np.linspace(0, len(group) - 1, min(len(group), ASKED)).astype(int)]
        if not all(map(is_one, checked)):
            counts[group] = [*map(is_one, group)] if len(group) <= MANY else False
    return at[counts], stable[counts]


def _linked(links: Integers) -> list[Integers]:
    """Return the connected sets of orbits."""
    from scipy.sparse import coo_array  # noqa: PLC0415  (100 ms)
    from scipy.sparse.csgraph import connected_components  # noqa: PLC0415  (see above)

    orbit, side = np.nonzero(links >= 0)
    pairs = orbit, links[orbit, side]
    graph = coo_array((np.ones(len(orbit)), pairs), shape=(len(links), len(links)))
    count, labels = connected_components(graph, directed=False)
    return [np.flatnonzero(labels == label) for label in range(count)]


def _room(count: int, points: int, n: int, size: int) -> tuple[Any, ...]:
    """Return arrays for `count` orbits on a number of points; see `filling.fill`."""
    integer = np.int64
    return (
        np.empty((count, n)), np.empty(count, integer), np.empty(count),
        np.full((count, 4), -1), np.full(points, -1), np.empty(count, integer),
        np.empty((count, 2, size, size)),
    )  # fmt: skip


def _larger(orbits: tuple[Any, ...], points: int, n: int, size: int) -> tuple[Any, ...]:
    """Return arrays of orbits with twice the room."""
    count = len(orbits[0])
    larger = _room(2 * count, points, n, size)
    for i, part in enumerate(orbits):
        larger[i][: len(part)] = part
    return larger


def stability_of(plane: Plane, maps: Any) -> Integers:
    """Return the stability of orbits by the `maps` of their cells, shape (m, 2, n, n).

    See `cell_map`.  Where rounding could matter, `stability.of_monodromy` decides.
    """
    cell = plane.course.cell(plane.case.numbers)
    finite = np.isfinite(maps).all(axis=(1, 2, 3))
    matrices = np.where(finite[:, None, None, None], maps, 0.0)
    values = np.linalg.eigvals(matrices[:, 0])
    moduli = np.abs(values)
    if not cell.forced:  # a shift in time is no perturbation
        moduli[np.arange(len(matrices)), np.abs(values - 1).argmin(axis=1)] = 0.0
    margin, norm = 1 - moduli.max(axis=1), np.linalg.norm(matrices[:, 1], axis=(1, 2))
    verdicts = np.where(margin > 0, STABLE, UNSTABLE)
    verdicts[~finite | (np.abs(margin) <= ROUNDING / 2)] = NEITHER
    doubtful = np.abs(margin) <= np.sqrt(ROUNDING * norm) * (1 + norm)
    for k in np.flatnonzero(doubtful & (verdicts != NEITHER)):
        stable = of_monodromy(cell, *matrices[k]).stable
        verdicts[k] = {True: STABLE, None: NEITHER, False: UNSTABLE}[stable]
    return verdicts
