"""A cell of a body as the arrays of its equations; see `equations`."""

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np

from ...arrays import Complex, Indices, Matrix, Vector
from ...bodies.part import Part, generator_of, parts_of
from ...bodies.systems import BodyError
from ...scenes.bodies.cell import BodyCell
from ...scenes.cell import Form


def in_order(cell: BodyCell, rows: Matrix) -> Matrix:
    """Return forms of ``(y, cos, sin, 1, memory)`` as those of ``(y, memory, cos, sin, 1)``."""
    end = rows.shape[-1] - len(cell.memory)
    parts = rows[..., : end - 3], rows[..., end:], rows[..., end - 3 : end]
    return np.concatenate(parts, axis=-1)


def arrays(cell: BodyCell, forms: Sequence[Form]) -> list[Matrix]:
    """Return the arrays of a cell as `equations.case_at` has them, without the first."""
    parts, count = parts_of(cell), len(cell.phases)
    states = parts[0].switch.state.shape[0]
    width = states + 3
    switches = np.array([np.eye(width)] * count)
    for p, part in enumerate(parts):
        switches[p, :states] = np.hstack([part.switch.state, part.switch.inputs])
    generators = [generator_of(part, cell.omega) for part in parts]
    return [
        np.array([in_order(cell, in_order(cell, generator.T).T) for generator in generators]),
        switches,
        in_order(cell, np.array([part.switch.event for part in parts])),
        in_order(cell, np.array([part.lawful.rows[:2] for part in parts])),
        np.array([cell.sign, cell.omega, cell.duration if cell.forced else 0.0]),
        np.array(forms, dtype=float).reshape(-1, width),
    ]


#: Relative difference of rates that do not depend on the parameter.
SAME = 1e-13


class Known(NamedTuple):
    """What does not depend on the parameter, of the arrays of a cell.

    Parameters
    ----------
    poles : ndarray of complex, shape (P, m)
        Of each phase, one of each pair; NaN where the poles depend on the parameter, or the
        body moves freely.  No rows if none is known.
    basis, inverse : ndarray, shape (P, n, 2 m), (P, 2 m, n)
        The eigenvectors of displacements and velocities (not scaled), real parts and minus the
        imaginary parts; the rows of the inverse basis, real and imaginary parts.
    constant : ndarray
        All entries; of those that vary, the first coefficient.
    varying : ndarray of int
        The entries that vary: only these have a series.
    """

    poles: Complex
    basis: Matrix
    inverse: Matrix
    constant: Vector
    varying: Indices


#: The eigenbases of a cell without any known.
UNKNOWN = np.empty((0, 0), dtype=complex), np.empty((0, 0, 0)), np.empty((0, 0, 0))


def known_of(
    cell: BodyCell, other_cells: Iterable[BodyCell], series: Matrix
) -> tuple[Matrix, Known]:
    """Return the series of the entries that vary, and what does not.

    Parameters
    ----------
    cell : BodyCell
        At one value of the parameter, or of two parameters.
    other_cells : iterable of BodyCell
        At other values.
    series : ndarray, shape (entries, ...)
        Of all entries, in one parameter or two.
    """
    rows, parts = series.reshape(len(series), -1), parts_of(cell)
    varying = np.flatnonzero(rows[:, 1:].any(axis=1))
    matrices = [_of_places(part) for part in parts]
    sizes = [np.abs(matrix).max(axis=1, keepdims=True) for matrix in matrices]
    are_fixed = np.ones(len(parts), dtype=bool)
    for other in other_cells:
        pairs = zip(matrices, map(_of_places, parts_of(other)), strict=True)
        change = [np.abs(matrix - other_matrix) for matrix, other_matrix in pairs]
        are_fixed &= [(a <= SAME * b).all() for a, b in zip(change, sizes, strict=True)]
    held = [
        _held(part) if fixed else None for part, fixed in zip(parts, are_fixed, strict=True)
    ]
    return np.ascontiguousarray(series[varying]), _known(held, rows[:, 0].copy(), varying)


def _of_places(part: Part) -> Matrix:
    """Return the matrix of the rates of displacements and velocities, not scaled."""
    rates, n = part.lawful.A.copy(), len(part.lawful.A) // 2
    rates[n:, :n] *= np.diag(rates[:n, n:])
    rates[:n, n:] = np.eye(n)
    return rates


def _held(part: Part) -> tuple[Complex, Complex, Complex] | None:
    """Return poles and eigenbasis, one of each pair; None for a body that moves freely."""
    n = len(part.lawful.A) // 2
    scales = np.append(np.diag(part.lawful.A[:n, n:]), np.ones(n))
    try:
        if part.flow.free:
            return None
    except BodyError:
        return None
    flow = part.flow.upper
    return flow.poles, flow.basis / scales[:, None], flow.inverse * scales


def _known(
    held: Sequence[tuple[Complex, Complex, Complex] | None], constant: Vector, varying: Indices
) -> Known:
    """Return the eigenbases of phases as arrays."""
    eigenbases = [eigenbasis for eigenbasis in held if eigenbasis]
    if not eigenbases:
        return Known(*UNKNOWN, constant, varying)
    n, m = len(eigenbases[0][1]), max(len(poles) for poles, _, _ in eigenbases)
    all_poles = np.full((len(held), m), np.nan, dtype=complex)
    bases, inverses = np.zeros((len(held), n, 2 * m)), np.zeros((len(held), 2 * m, n))
    for p, eigenbasis in enumerate(held):
        if eigenbasis:
            poles, basis, inverse = eigenbasis
            k = len(poles)
            all_poles[p] = np.append(poles, np.zeros(m - k))
            bases[p, :, :k], bases[p, :, m : m + k] = basis.real, -basis.imag
            inverses[p, :k], inverses[p, m : m + k] = inverse.real, inverse.imag
    return Known(all_poles, bases, inverses, constant, varying)


def case_of(cell: BodyCell, forms: Sequence[Form]) -> Any:
    """Return the arrays of a cell as `equations.case_at` does."""
    return np.zeros(len(cell.phases), dtype=np.int64), *arrays(cell, forms), UNKNOWN
