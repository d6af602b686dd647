"""A cell of a body as the arrays of its equations; see `equations`."""

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np

from ...arrays import Complex, Indices, Matrix, Vector
from ...bodies.part import Part, generator_of, parts_of
from ...bodies.systems import BodyError
from ...scenes.bodies.cell import BodyCell
from ...scenes.cell import Form
from ...scenes.mirror import same
from ..along import earlier


def in_order(cell: BodyCell, rows: Matrix) -> Matrix:
    """Return forms of ``(y, cos, sin, 1, memory)`` as those of ``(y, memory, cos, sin, 1)``."""
    end = rows.shape[-1] - len(cell.memory)
    parts = rows[..., : end - 3], rows[..., end:], rows[..., end - 3 : end]
    return np.concatenate(parts, axis=-1)


def arrays(cell: BodyCell, forms: Sequence[Form]) -> list[Matrix]:
    """Return the arrays of a cell as `equations.case_at` has them, behind its first."""
    parts, count = parts_of(cell), len(cell.phases)
    states = parts[0].switch.state.shape[0]
    width = states + 3
    switches = np.array([np.eye(width)] * count)
    for p, part in enumerate(parts):
        switches[p, :states] = np.hstack([part.switch.state, part.switch.inputs])
    generators = [generator_of(part, cell.omega) for part in parts]
    return [
        np.array([in_order(cell, in_order(cell, own.T).T) for own in generators]),
        switches,
        in_order(cell, np.array([part.switch.event for part in parts])),
        in_order(cell, np.array([part.lawful.rows[:2] for part in parts])),
        np.array([cell.sign, cell.omega, cell.duration if cell.forced else 0.0]),
        np.array(forms, dtype=float).reshape(-1, width),
    ]


#: What is nothing of a form, as a part of its largest entry.
FLAT = 1e-11


def begins_slowly(cell: BodyCell, p: int) -> int:
    """Return how often the event of a phase is zero where it begins, with its rates: up to 3.

    All follow from what is so where the phase before ends: by its event and, if it is held,
    by its speed, and where it is held, if it began there and has none.
    """
    generators, switches, events, seen, *_ = arrays(cell, [])
    before, mirrored = cell.phases[p - 1], np.ones(len(events[0]))
    if p == 0:
        mirrored[:-1] = cell.sign
    known = [events[p - 1]]
    if before.held:
        known.append(seen[p - 1, 1] - before.speed * np.eye(len(mirrored))[-1])
    through = mirrored[:, None] * switches[p - 1]
    rates = [events[p]]
    for _ in range(2):
        rates.append(rates[-1] @ generators[p])
    asked, sizes = np.array(rates) @ through, np.abs(rates).max(axis=1, keepdims=True)
    there = same(earlier(cell, p, 2).event, cell.phases[p].event)
    if before.held and before.speed == 0 and there and not any(cell.phases[p].event[1:3]):
        known.append(asked[0])
    left = asked - asked @ np.linalg.pinv(np.array(known)) @ np.array(known)
    zero = (np.abs(left) <= FLAT * sizes).all(axis=1)
    return int(np.cumprod(zero).sum())


#: What rates may differ by, as a part of the largest of a row, that do not vary.
SAME = 1e-13


class Known(NamedTuple):
    """What is known of the arrays of a cell along a parameter.

    Parameters
    ----------
    poles : ndarray of complex, shape (P, m)
        Of each phase, one of each pair; not numbers where a pole depends on the parameter, or
        nothing holds the body.  No rows where none is known.
    basis, inverse : ndarray, shape (P, n, 2 m), (P, 2 m, n)
        Of places and velocities, without their scales: the real parts of the vectors of the
        poles, and less the imaginary ones; the real parts of the forms that are the parts
        along them, and the imaginary ones.
    constant : ndarray
        All entries, where the parameter has no part in them.
    varying : ndarray of int
        Those which it has a part in: their series stand alone.
    """

    poles: Complex
    basis: Matrix
    inverse: Matrix
    constant: Vector
    varying: Indices


#: Eigenbases of a cell of which none is known.
UNKNOWN = np.empty((0, 0), dtype=complex), np.empty((0, 0, 0)), np.empty((0, 0, 0))


def known_of(
    cell: BodyCell, others: Iterable[BodyCell], series: Matrix
) -> tuple[Matrix, Known]:
    """Return the series of the entries that vary, and what is known of a cell.

    Parameters
    ----------
    cell : BodyCell
        At one value of the parameter, or of both.
    others : iterable of BodyCell
        At others.
    series : ndarray, shape (entries, ...)
        Of all entries, by one parameter or two.
    """
    rows, parts = series.reshape(len(series), -1), parts_of(cell)
    varying = np.flatnonzero(rows[:, 1:].any(axis=1))
    found = [_of_places(part) for part in parts]
    sizes = [np.abs(own).max(axis=1, keepdims=True) for own in found]
    same = np.ones(len(parts), dtype=bool)
    for other in others:
        pairs = zip(found, map(_of_places, parts_of(other)), strict=True)
        change = [np.abs(own - there) for own, there in pairs]
        same &= [(a <= SAME * b).all() for a, b in zip(change, sizes, strict=True)]
    own = [_held(part) if fixed else None for part, fixed in zip(parts, same, strict=True)]
    return np.ascontiguousarray(series[varying]), _known(own, rows[:, 0].copy(), varying)


def _of_places(part: Part) -> Matrix:
    """Return the rates of a body by its places and velocities, without their scales."""
    found, n = part.lawful.A.copy(), len(part.lawful.A) // 2
    found[n:, :n] *= np.diag(found[:n, n:])
    found[:n, n:] = np.eye(n)
    return found


def _held(part: Part) -> tuple[Complex, Complex, Complex] | None:
    """Return poles and eigenbasis of a phase, one of each pair, if something holds the body."""
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
    own: Sequence[tuple[Complex, Complex, Complex] | None], constant: Vector, varying: Indices
) -> Known:
    """Return what is known of phases as one array of each."""
    found = [each for each in own if each]
    if not found:
        return Known(*UNKNOWN, constant, varying)
    n, m = len(found[0][1]), max(len(poles) for poles, _, _ in found)
    all_poles = np.full((len(own), m), np.nan, dtype=complex)
    bases, inverses = np.zeros((len(own), n, 2 * m)), np.zeros((len(own), 2 * m, n))
    for p, each in enumerate(own):
        if each:
            poles, basis, inverse = each
            k = len(poles)
            all_poles[p] = np.append(poles, np.zeros(m - k))
            bases[p, :, :k], bases[p, :, m : m + k] = basis.real, -basis.imag
            inverses[p, :k], inverses[p, m : m + k] = inverse.real, inverse.imag
    return Known(all_poles, bases, inverses, constant, varying)


def case_of(cell: BodyCell, forms: Sequence[Form]) -> Any:
    """Return the arrays of a cell as `equations.case_at` does."""
    return np.zeros(len(cell.phases), dtype=np.int64), *arrays(cell, forms), UNKNOWN
