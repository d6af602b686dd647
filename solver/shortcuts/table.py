"""The table of shortcuts: for each, what it is for, what it is solved in place of, and why.

Of the paper's three methods only the first has the rows of the generic kernel.  Those of
Section 3.2 test with the C1 functions where the generic kernel has the conditions at the
switches (its jump rows); those of Section 3.3 fix the state at both ends of slip, where the
generic kernel has the events.  At the same order these are other systems with other orbits, and
only in the limit the same: what is equal there is held against the paper's own kernels.
"""

from collections.abc import Sequence

import numpy as np

from ..arrays import Vector
from ..case.case import Case
from ..shortcut import Shortcut
from .entrance import alpha_of_case, belt_of
from .full import WITH_SEVERAL, of_every_scene, of_the_paper, parts, parts_of_cell
from .names import SCENE
from .orbit.methods import (
    LARGEST_ALPHA,
    METHODS,
    MOST_HARMONICS_BESIDE,
    MOST_TERMS,
    SMALLEST_ALPHA,
)
from .polynomials.batch import c1_times
from .search.family_points import by_bands, fits_bands
from .search.search import MOST_DENSE, admissible_root
from .search.solve import solve


def _is_in_range(case: Case) -> bool:
    return SMALLEST_ALPHA <= alpha_of_case(case) <= LARGEST_ALPHA


def _series(cases: Sequence[Case], order: int, functions: int | None) -> list[Vector]:
    """Return the unknowns of the generic kernel: the origin is at rest, not at ``x_s``."""
    found = []
    for case in cases:
        belt, units = belt_of(case), case.units
        z = solve(belt, "hb", order, many=True).unknowns.copy()
        z[:-2] *= belt.length_unit / units.length
        z[0] += 2 * belt.slip_centre / units.length
        z[-2:] *= belt.time_unit / units.time
        z[-1] -= z[-2]
        found.append(z)
    return found


def _with_functions(cases: Sequence[Case], order: int, functions: int | None) -> list[Vector]:
    terms = functions or 1
    belts = map(belt_of, cases)
    return [solve(belt, "hb-c1", order, c1_terms=terms, many=True).unknowns for belt in belts]


def _scalar(cases: Sequence[Case], order: int, functions: int | None) -> list[Vector]:
    found = c1_times([alpha_of_case(case) for case in cases], order)
    return list(np.column_stack((found.t1, found.T)))


def _bands(cases: Sequence[Case], order: int, functions: int | None) -> list[Vector]:
    t1, T, _ = by_bands(np.array([alpha_of_case(case) for case in cases]), order)
    return list(np.column_stack((t1, T)))


def _roots(cases: Sequence[Case], order: int, functions: int | None) -> list[Vector]:
    return [admissible_root(belt_of(case), order) for case in cases]


#: Below, the scalar equation does not tell the orbit from pure slip, ``2 alpha`` away.
LEAST_BY_SCALAR = 1e-5


def _fits_scalar(case: Case, order: int) -> bool:
    return (
        LEAST_BY_SCALAR <= alpha_of_case(case) <= LARGEST_ALPHA
        and order <= METHODS["c1"].highest_order
    )


def _fits_bands(case: Case, order: int) -> bool:
    return _is_in_range(case) and bool(fits_bands(np.array([alpha_of_case(case)]), order)[0])


def _fits_roots(case: Case, order: int) -> bool:
    return _is_in_range(case) and order <= METHODS["c1"].highest_order


_HB, _HB_C1, _C1 = of_every_scene("hb"), of_the_paper("hb-c1"), of_the_paper("c1")
_SEVERAL = tuple(range(2, MOST_TERMS + 1))
_ODD = "About x_s and mid-stick the orbit is odd: sines of the time since then are enough, and "

TABLE: tuple[Shortcut, ...] = (
    Shortcut(
        "odd series", SCENE, "hb", (),
        lambda case, order: _is_in_range(case) and order <= MOST_DENSE,
        _series, parts_of_cell, _HB, bound=1e-12, factor=10.0, order=100,
        why=_ODD + "(6) and one of (9), (10) each; the other rows hold by symmetry.",
    ),
    Shortcut(
        "odd series, matrix-free", SCENE, "hb", (),
        lambda case, order: (
            _is_in_range(case) and MOST_DENSE < order <= METHODS["hb"].highest_order
        ),
        _series, parts_of_cell, _HB, bound=1e-11, factor=20.0, order=400,
        why="The same; products of sines are convolutions, done by fast transforms.",
    ),
    Shortcut(
        "odd series with a C1 function", SCENE, "hb-ck", (1,),
        lambda case, order: _is_in_range(case) and order <= METHODS["hb-c1"].highest_order,
        _with_functions, parts, _HB_C1, bound=1e-12, factor=3.0, order=60,
        why=_ODD + "g1 is odd but for a constant. The rows are those of (11)-(14).",
    ),
    Shortcut(
        "odd series with C1 functions", SCENE, "hb-ck", _SEVERAL,
        lambda case, order: _is_in_range(case) and order <= MOST_HARMONICS_BESIDE,
        _with_functions, parts, WITH_SEVERAL, bound=1e-11, factor=None, order=20,
        why="As with one, tested with each; nothing else solves these rows.",
    ),
    Shortcut(
        "scalar equation", SCENE, "ck", (),
        _fits_scalar,
        _scalar, parts, _C1, bound=1e-12, factor=10.0, order=20,
        why="By (18) the residual is a sum of two Jacobi polynomials: three conditions are "
        "left for their factors and the duration of slip.",
    ),
    Shortcut(
        "bands", SCENE, "ck", (),
        _fits_bands,
        _bands, parts, _C1, bound=1e-12, factor=3.0, order=20,
        why="In Legendre polynomials (18) has nine diagonals, bordered by the times.",
    ),
    Shortcut(
        "all real solutions", SCENE, "ck", (),
        _fits_roots,
        _roots, parts, _C1, bound=1e-9, factor=None, order=7,
        why="Every real solution is a root of one polynomial, isolated in exact arithmetic: "
        "it proves that there is no orbit where none of them is one. `solve` refines them.",
    ),
)  # fmt: skip
