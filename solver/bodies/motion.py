"""The motion of a body's contacts, and its derivatives, exact or by the force series."""

from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Matrix, Vector
from . import exact
from .exact import angles_of
from .integrals import answers
from .laws import places
from .layout import layout
from .modal import Complex
from .series import evaluated

if TYPE_CHECKING:
    from ..scenes.bodies.cell import BodyCell

#: The place of the acceleration of the first contact in a form.
ACCELERATION = places(1)[3][0]


def signals(cell: "BodyCell", order: int, times: Vector, p: int, u: Vector) -> Matrix:
    """Return what forms are of on phase `p`, at local times in [0, 1]; shape (S, len(u)).

    The forces by their laws; `order` 0 is the exact motion.
    """
    u = np.asarray(u, dtype=float)
    if order == 0:
        rows = exact.parts_of(cell)[p].lawful.rows
        kept = len(rows) - len(cell.memory)
        return exact.seen(cell, times, p, u, rows[:kept])
    own, found = layout(cell, order), evaluated(cell, order, times)
    theta = angles_of(cell, times)[p] + cell.omega * float(times[p]) * u
    forms = own.phases[p].seen
    fixed = forms.at(theta, found.unknowns[own.memory])
    return fixed + _along(cell, order, times, p, u, forms.poles)


def derivative(
    cell: "BodyCell", order: int, times: Vector, p: int, u: Vector, number: int
) -> Vector:
    """Return a derivative of the first contact's displacement by time on phase `p`."""
    u = np.asarray(u, dtype=float)
    if number <= 2:
        return np.asarray(signals(cell, order, times, p, u)[(0, 1, ACCELERATION)[number]])
    if order:
        return _derivative(cell, order, times, p, u, number)
    part = exact.parts_of(cell)[p]
    generator = exact.generator_of(part, cell.omega)
    row = part.lawful.rows[ACCELERATION]
    for _ in range(number - 2):
        row = row @ generator
    return np.asarray(exact.seen(cell, times, p, u, row[None])[0])


def _derivative(
    cell: "BodyCell", order: int, times: Vector, p: int, u: Vector, number: int
) -> Vector:
    """Return a derivative by the poles; those of the forces from the laws, differentiated.

    ``x^(j) = Re sum c s^j z + forced + sum_(i < j) (Re sum c s^(j-1-i) b) lam^(i)``.
    """
    own = layout(cell, order)
    phase, poles, s = own.phases[p], own.poles, own.poles.s[:, None]
    theta = angles_of(cell, times)[p] + cell.omega * float(times[p]) * u
    turn = 1j * cell.omega
    waves = np.exp(1j * theta)
    powers = [(poles.c * s**q).T for q in range(number + 1)]
    homogeneous = np.split(_along(cell, order, times, p, u, np.vstack(powers)), number + 1)
    jumps = [(q @ poles.b).real for q in powers]
    jumps[0][:] = 0.0

    def free(j: int, known: list[Matrix]) -> Matrix:
        """Return x^(j) by the forces' derivatives that are known."""
        forced = (poles.response[:, None] * turn**j * waves).real
        by_forces = sum(jumps[j - 1 - i] @ q for i, q in enumerate(known[:j]))
        return np.asarray(homogeneous[j] + forced + by_forces)

    x, v, _, a = places(poles.b.shape[1])
    forces: list[Matrix] = []
    for q in range(number - 1):
        rest = phase.rows[:, 2:3] * (turn**q * waves).real
        for place, shift in ((x, 0), (v, 1), (a, 2)):
            rest = rest + phase.rows[:, place] @ free(q + shift, forces)
        if q == 0:
            memory = evaluated(cell, order, times).unknowns[own.memory]
            rest = rest + (phase.law.constant + phase.law.memory @ memory)[:, None]
        forces.append(np.asarray(-np.linalg.solve(phase.direct, rest)))
    return np.asarray(free(number, forces)[0])


def _along(
    cell: "BodyCell", order: int, times: Vector, p: int, u: Vector, forms: Complex
) -> Matrix:
    """Return ``Re(forms @ z)`` at local times of a phase; shape (len(forms), len(u))."""
    own = layout(cell, order)
    pieces, s = own.phases[p].pieces, float(times[p]) / own.phases[p].pieces
    found = _answers(cell, order, np.ascontiguousarray(times, dtype=float).tobytes(), p)
    which = np.minimum((u * pieces).astype(int), pieces - 1)
    values = np.empty((len(forms), len(u)))
    for piece in np.unique(which):
        here, (E, B) = which == piece, found[piece]
        w = u[here] * pieces - piece
        basis = np.polynomial.legendre.legvander(2 * w - 1, B.shape[1] - 1)
        free = (forms * E) @ np.exp(own.poles.s[:, None] * s * w)
        values[:, here] = free.real + (forms @ B).real @ basis.T
    return values


@lru_cache(maxsize=64)
def _answers(
    cell: "BodyCell", order: int, times: bytes, p: int
) -> tuple[tuple[Complex, Complex], ...]:
    """Return z on each piece of a phase as ``E e^(kappa u) + sum B_m P_m*(u)``."""
    own, all_times = layout(cell, order), np.frombuffer(times)
    found, phase, poles = evaluated(cell, order, all_times), own.phases[p], own.poles
    s, first = float(all_times[p]) / phase.pieces, own.first_of(p)
    pieces = []
    for e in range(first, first + phase.pieces):
        at, count = own.elements[e][1], (phase.degree + 1) * poles.b.shape[1]
        l = found.unknowns[at : at + count].reshape(phase.degree + 1, -1)
        E, B = answers(poles.s * s, poles.b @ l.T)
        pieces.append((found.states[e] + s * E, s * B))
    return tuple(pieces)
