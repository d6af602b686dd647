"""Checks of the body of a scene: its matrices, damping and modes."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import sympy as sp

from ..bodies.body import Body, Entries
from ..bodies.law import body_of
from ..data import SceneData
from ..error import SceneError, named
from ..units import Dimension, balance, dimension_of, spelled
from .parameters import check_known
from .phases import Units

#: Largest difference between symmetric entries, relative to the largest entry.
ROUNDING = 1e-12

#: Degrees of freedom up to which matrices are factorised as dense arrays.
DENSE = 2000


def check_body(scene: SceneData, units: Units) -> None:
    """Check the body of a scene, with the defaults of its parameters.

    A `SceneError` names the matrix that is wrong, and how.
    """
    body = body_of(scene)
    defaults = {q.symbol: q.default for q in scene.parameters}
    with named("body"):
        check_known(body.symbols, defaults)
    for name, number in (("ratio", body.ratio), ("modes", body.modes)):
        if isinstance(number, sp.Symbol) and units[number] != dimension_of(""):
            raise SceneError(f"body: {name}: {number} has a unit, expected a pure number")
    if ("forcing" in body.arrays) and scene.frequency is None:
        raise SceneError("body: it has forcing, but the scene has no frequency")
    with named("body"):
        _check_units(body, units)
    arrays = {name: at_defaults(q, defaults) for name, q in body.arrays.items()}
    for name in ("M", "K"):
        _check_symmetric(name, arrays[name])
    _check_positive(arrays["M"])


def at_defaults(matrix: Entries, defaults: Mapping[sp.Symbol, float]) -> Entries:
    """Return a matrix for the default parameters."""
    if matrix.is_numeric:
        return matrix
    values = np.array([float(q.subs(defaults)) for q in matrix.values])
    return Entries(matrix.shape, matrix.rows, matrix.columns, values)


def _check_symmetric(name: str, matrix: Entries) -> None:
    from scipy import sparse  # noqa: PLC0415  (a scene of one mass needs none)

    full = sparse.coo_array((matrix.values, (matrix.rows, matrix.columns)), matrix.shape)
    asymmetry, largest = (np.abs(q).max(initial=0.0) for q in ((full - full.T).data, full.data))
    if asymmetry > ROUNDING * largest:
        by = f"by {asymmetry / largest:.2g} of the largest entry"
        use = f"if this is rounding, use ({name} + {name}.T)/2"
        raise SceneError(f"body: {name}: it is not symmetric, {by}; {use}")


def _check_positive(matrix: Entries) -> None:
    """Check that the mass matrix is positive definite, by its factors."""
    if matrix.shape[0] <= DENSE:
        try:
            np.linalg.cholesky(matrix.dense())
        except np.linalg.LinAlgError:
            raise SceneError("body: M: it is not positive definite") from None
        return
    from scipy.sparse import csc_array, linalg  # noqa: PLC0415

    full = csc_array((matrix.values, (matrix.rows, matrix.columns)), shape=matrix.shape)
    options: dict[str, Any] = {"diag_pivot_thresh": 0.0, "options": {"SymmetricMode": True}}
    try:
        factors = linalg.splu(full, permc_spec="MMD_AT_PLUS_A", **options)
    except RuntimeError:
        raise SceneError("body: M: it is singular, expected a positive definite one") from None
    if not (factors.U.diagonal() > 0).all():
        raise SceneError("body: M: it is not positive definite")


def _check_units(body: Body, units: Units) -> None:
    """Check that units of entries of M, C, K with parameters differ by powers of time."""
    dimensions: dict[tuple[int, int], Dimension] = {}
    for power, name in enumerate(("M", "C", "K")):
        matrix = body.arrays.get(name)
        if matrix is None or matrix.is_numeric:
            continue
        for i, j, value in zip(matrix.rows, matrix.columns, matrix.values, strict=True):
            if not value.free_symbols:
                continue
            with named(f"{name}[{i}, {j}]"):
                mass, length, time = balance(sp.expand(value), units)
            unit = mass, length, time + power
            expected = dimensions.setdefault((int(i), int(j)), unit)
            if expected != unit:
                raise SceneError(
                    f"{name}[{i}, {j}] is in {spelled((mass, length, time))}, which is not "
                    "that of M, N s/m for kg in C and N/m in K"
                )
