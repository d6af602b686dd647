"""A body in one phase, with the contact forces by their laws.

The state is ``y = (w eta, eta')`` of each mode, scaled so that both parts are velocities; w is
the mode's frequency.  The variables of linear forms, and the contact forces by their laws, are
rows over ``Y = (y, cos, sin, 1, memory)``.
"""

from dataclasses import dataclass
from functools import cache, lru_cache
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Matrix, Vector
from .modal import Modal
from .systems import BodyError

if TYPE_CHECKING:
    from ..scenes.bodies.cell import BodyCell, BodyPhase

#: The rate, without units, at which a held contact returns to its speed: on an orbit it begins
#: at that speed, and the rate only keeps two poles of it apart.
RETURN = 1.0

#: By what a mode that moves freely is scaled where nothing forces, as a part of the fastest.
SLOWEST = 1e-3

#: Relative size of the stiffness or damping of a rigid-body mode that is rounding.
HELD = 1e-12

#: Relative size of the determinant of laws that do not determine the forces.
SINGULAR = 1e-13


@dataclass(frozen=True, eq=False)
class Free:
    """A body without its contact forces.

    Parameters
    ----------
    A : ndarray, shape (2 m, 2 m)
        ``y' = A y + F cos + B force``.
    B : ndarray, shape (2 m, c)
    rows : ndarray, shape (S, 2 m + 3 + M)
        What forms are of, the forces left out.
    by_force : ndarray, shape (S, c)
        What the forces add to that.
    inputs : ndarray, shape (2 m, 3 + M)
        ``F cos``, by cos, sin, 1, memory.
    """

    A: Matrix
    B: Matrix
    rows: Matrix
    by_force: Matrix
    inputs: Matrix


@dataclass(frozen=True, eq=False)
class Lawful:
    """A body in one phase, its contact forces by their laws.

    Parameters
    ----------
    A : ndarray, shape (2 m, 2 m)
        ``y' = A y + inputs (cos, sin, 1, memory)``.
    inputs : ndarray, shape (2 m, 3 + M)
    rows : ndarray, shape (S + M, 2 m + 3 + M)
        What forms are of, the memory included.
    force : ndarray, shape (c, 2 m + 3 + M)
        The contact forces.
    still : ndarray, shape (2 m, p)
        Places at which the body stays: ``A place = 0``, and no law sees them.
    free : ndarray, shape (2 m, 2 f)
        Those of them that nothing brakes, then the velocities that move them:
        ``A velocity = place``.
    """

    A: Matrix
    inputs: Matrix
    rows: Matrix
    force: Matrix
    still: Matrix
    free: Matrix


@cache
def places(contacts: int) -> tuple[list[int], list[int], list[int], list[int]]:
    """Return the positions of x, v, force and a of each contact in a form.

    Examples
    --------
    >>> places(2)
    ([0, 6], [1, 7], [4, 8], [5, 9])
    """
    offsets = [6 + 4 * i for i in range(contacts - 1)]
    return (
        [0, *offsets],
        [1, *(q + 1 for q in offsets)],
        [4, *(q + 2 for q in offsets)],
        [5, *(q + 3 for q in offsets)],
    )


def scales(body: Modal, omega: float) -> Vector:
    """Return the frequency by which each mode is scaled, a smooth function of parameters.

    A body without a forcing and without springs has none of its own: the unit is taken.
    """
    frequencies = np.sqrt(np.abs(body.squares))
    return np.hypot(frequencies, omega or SLOWEST * float(frequencies.max()) or 1.0)


@lru_cache(maxsize=64)
def added(body: Modal) -> Matrix:
    """Return the factors of the contact forces in the variables of forms; shape (S, c)."""
    contacts = body.at.shape[1]
    x, _, f, a = places(contacts)
    factors = np.zeros((2 + 4 * contacts, contacts))
    factors[x], factors[a], factors[f] = body.residual, body.kept_mobility, np.eye(contacts)
    return factors


@lru_cache(maxsize=64)
def free(body: Modal, omega: float, memory: int) -> Free:
    """Return a body without its contact forces; `memory` is the number of memories."""
    count, contacts = body.at.shape
    w, zero = scales(body, omega), np.zeros((count, count))
    A = np.block([[zero, np.diag(w)], [-np.diag(body.squares / w), -body.damping]])
    B = np.vstack([np.zeros((count, contacts)), body.at])
    inputs = np.zeros((2 * count, 3 + memory))
    inputs[count:, 0] = body.forcing
    x, v, _, a = places(contacts)
    size = 2 + 4 * contacts
    rows = np.zeros((size, 2 * count + 3 + memory))
    turn = 2 * count
    rows[2, turn] = rows[3, turn + 2] = 1.0
    rows[x, :count], rows[v, count:turn] = (body.at / w[:, None]).T, body.at.T
    rows[a, :turn], rows[a, turn] = body.at.T @ A[count:], body.at.T @ body.forcing
    for order, places_ in enumerate((x, v, a)):  # Re(h (i Omega)^j e^(i theta))
        h = body.beyond * (1j * omega) ** order
        rows[places_, turn] += h.real
        rows[places_, turn + 1] -= h.imag
    return Free(A, B, rows, added(body), inputs)


def lawful(cell: "BodyCell", p: int) -> Lawful:
    """Return the body in a phase of a cell.

    Raises
    ------
    BodyError
        If the laws of the phase do not fix the contact forces.
    """
    memory, phase = len(cell.memory), cell.carrying(p)
    free_body = free(cell.body, cell.omega, memory)
    laws = law_matrix(phase)
    size = len(free_body.rows)
    by_variables = laws[:, :size] @ free_body.rows
    by_variables[:, by_variables.shape[1] - memory :] += laws[:, size:]
    by_force = laws[:, :size] @ free_body.by_force
    sizes = (np.abs(laws[:, :size]) @ np.abs(free_body.by_force)).max(axis=1)
    if abs(np.linalg.det(by_force)) <= SINGULAR * np.prod(sizes):
        raise BodyError(f"{phase.name}: its law does not fix the contact force")
    force = -np.linalg.solve(by_force, by_variables)
    rows = free_body.rows + free_body.by_force @ force
    rows = np.vstack([rows, np.eye(rows.shape[1])[rows.shape[1] - memory :]])
    states = free_body.A.shape[0]
    A = free_body.A + free_body.B @ force[:, :states]
    inputs = np.asarray(free_body.inputs + free_body.B @ force[:, states:], dtype=float)
    by_law: Matrix = np.asarray(force, dtype=float)
    return Lawful(np.asarray(A, dtype=float), inputs, rows, by_law, *_free_ways(cell, by_law))


def _free_ways(cell: "BodyCell", force: Matrix) -> tuple[Matrix, Matrix]:
    """Return a basis of equilibria without restoring force, and one of rigid-body motions."""
    body, m = cell.body, len(cell.body.squares)
    rigid = np.flatnonzero(body.squares == 0)
    if not len(rigid):
        return np.zeros((2 * m, 0)), np.zeros((2 * m, 0))
    w = scales(body, cell.omega)[rigid]
    sizes = np.abs(force[:, : 2 * m]).max(axis=1, keepdims=True)
    by_law = force[:, : 2 * m] / np.where(sizes == 0, 1.0, sizes)
    damping = body.damping[:, rigid] / (np.abs(body.damping).max() or 1.0)
    by_place, by_velocity = by_law[:, rigid] * w, by_law[:, m + rigid]
    still, free = _unheld(by_place), _unheld(np.vstack([by_place, by_velocity, damping]))
    zeros = np.zeros((2 * m, len(rigid)))
    displacements, velocities = zeros.copy(), zeros
    displacements[rigid], velocities[m + rigid] = np.diag(w), np.eye(len(rigid))
    return displacements @ still, np.hstack([displacements @ free, velocities @ free])


def _unheld(rows: Matrix) -> Matrix:
    """Return an orthonormal basis of the null space, by column."""
    _, values, Vh = np.linalg.svd(rows)
    return np.asarray(Vh[(values > HELD).sum() :].T)


def under(cell: "BodyCell", phase: "BodyPhase", variables: Vector, sign: int) -> Vector:
    """Return the variables of forms behind a switch, by the laws of a phase.

    Parameters
    ----------
    cell : BodyCell
        With numbers for its memory.
    phase : BodyPhase
    variables : ndarray, shape (S,)
        What they are of before it.
    sign : int
        What the motion is multiplied by there.
    """
    body = free(cell.body, cell.omega, 0)
    mirrored = np.where(np.arange(len(variables)) == 3, variables, sign * variables)
    forces = places(cell.body.at.shape[1])[2]
    rest = mirrored - body.by_force @ mirrored[forces]
    laws = law_matrix(phase)
    return np.asarray(rest - body.by_force @ np.linalg.solve(laws @ body.by_force, laws @ rest))


def law_matrix(phase: "BodyPhase") -> Matrix:
    """Return the laws of a phase by row; a held contact decays to its prescribed speed."""
    laws = np.array(phase.laws)
    if phase.held:
        laws[0] /= laws[0, 5]
        laws[0, 1] += RETURN
        laws[0, 3] -= RETURN * phase.speed
    return laws
