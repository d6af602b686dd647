"""Checks of a scene with a body: its matrices, the laws of its contacts."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import sympy as sp

from ..bodies.body import UNITS, Body, Entries
from ..bodies.law import body_of, form, law_rows, place
from ..data import Phase, SceneData, forcing
from ..error import SceneError, named
from ..linear import without_modulus
from ..units import Dimension, balance, dimension_of, spelled
from .parameters import check_known
from .phases import Units, check_velocity, checked_fields

#: Largest difference between symmetric entries, relative to the largest entry.
ROUNDING = 1e-12

#: Degrees of freedom up to which matrices are factorised as dense arrays.
DENSE = 2000


def units_of_contacts(body: Body) -> dict[sp.Symbol, Dimension]:
    """Return the units of the symbols of the contacts of a body."""
    by_contact = (zip(q.symbols, UNITS, strict=True) for q in body.at.values())
    return {symbol: dimension_of(unit) for pairs in by_contact for symbol, unit in pairs}


def check_body(scene: SceneData, units: Units) -> None:
    """Check the body of a scene, with the defaults of its parameters.

    A `SceneError` names the matrix that is wrong, and how.
    """
    body = scene.body
    if not isinstance(body, Body):
        raise SceneError(f"body: got {body!r:.60}, expected a Body")
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
    asymmetry = np.abs((full - full.T).data).max(initial=0.0)
    if asymmetry > ROUNDING * np.abs(matrix.values).max(initial=0.0):
        raise SceneError(f"body: {name}: it is not symmetric, by {asymmetry:.3g}")


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


def check_contact_phase(phase: Phase, scene: SceneData, units: Units) -> None:
    """Check one phase of a body by itself; a `SceneError` names the field that is wrong."""
    field, memory = f"phase {phase.name}", [q.symbol for q in scene.memory]
    contacts = list(body_of(scene).at.values())
    for name, value in checked_fields(phase, units, scene.frequency is not None, memory):
        with named(f"{field}: {name}"):
            for part in without_modulus(value, _states(scene)):
                row = form(part, scene, f"{field}: {name}")
            if name == "ends" and not any(c != 0 for i, c in enumerate(row) if i != 3):
                raise SceneError(f"{value} depends on no displacement, velocity or force")
    rows = law_rows(phase, scene)
    for symbol, value in phase.ends.jump.items():
        with named(f"{field}: jump"):
            if symbol not in [q.v for q in contacts]:
                raise SceneError(f"got a jump of {symbol}, expected one of {contacts[0].v}")
            check_velocity(value, units)
            row = form(value, scene, f"{field}: jump")
            allowed = {3, place(body_of(scene), symbol)}
            if any(c != 0 for i, c in enumerate(row) if i not in allowed):
                raise SceneError(f"got {value}, expected the velocity {symbol} alone in it")
    if phase.held is not None:
        with named(f"{field}: held"):
            speed = sp.sympify(phase.held)
            if len(contacts) > 1:
                raise SceneError("a body with several contacts cannot be held yet")
            place_of_a = place(body_of(scene), contacts[0].a)
            if any(c != 0 for i, c in enumerate(rows[0]) if i != place_of_a):
                raise SceneError(f"got the equation {phase.equation}, expected {contacts[0].a}")
            check_velocity(speed, units)
    elif any(
        row[place(body_of(scene), q.force)] == 0 for q, row in zip(contacts, rows, strict=True)
    ):
        raise SceneError(
            f"{field}: equation: it has no force: say the speed at which it is held"
        )


def _states(scene: SceneData) -> tuple[sp.Symbol, ...]:
    """Return the symbols in which demands are linear."""
    by_contact = (q.symbols for q in body_of(scene).at.values())
    return (*(symbol for symbols in by_contact for symbol in symbols), forcing)
