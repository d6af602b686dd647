"""The equations of the force series for a cell: its phases, and the order of the unknowns."""

from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ...arrays import Complex, Integers, Matrix, Vector
from ..laws import added, law_matrix, lawful, places
from ..part import shifts
from ..poles import Forms, Poles, held_by, poles_of
from ..switch import impulses, switch
from ..systems import BodyError

if TYPE_CHECKING:
    from ...scenes.bodies.cell import BodyCell

#: Highest degree of a piece: a phase of a higher order is cut into equal pieces.
MOST = 32

#: Relative change of a mode over a forced cell below which auxiliary springs hold the body, in
#: the force series and with harmonics.  In free phases the series has to resolve the springs'
#: forces; harmonics need no more terms for them, and lose more digits without.
RESONANT, OF_HARMONICS = 1e-7, 1e-2


class Phase:
    """Phase `p` of a cell in the equations of an order.

    Attributes
    ----------
    laws, event_row : ndarray, shape (c, S + M), (S + M,)
        The laws of the contacts, and the event at its end with the forces by the laws.
    event, force, seen : Forms
        That event, the contact forces, the variables of forms; with the forces by the laws.
    direct : ndarray, shape (c, c)
        The factors of the contact forces in the laws.
    hit : ndarray of int
        The contacts with an impulse at its end.
    impulse : ndarray, shape (c, c + 1)
        Impulses by the velocities, and the constant.
    fixing : ndarray, shape (c,)
        The factors of the event at its end that are added to the laws; see `_fixing`.
    degree, pieces : int
        The degree of the series of a piece, and the number of pieces: 0 and 1, or by `Layout`
        where the laws do not give the forces.
    """

    degree, pieces = 0, 1

    def __init__(self, cell: "BodyCell", poles: Poles, p: int) -> None:
        by_contact, memory, phase = added(cell.body), len(cell.memory), cell.phases[p]
        self._poles, (self._width, contacts) = poles, by_contact.shape
        self.laws = law_matrix(phase)
        by_force = np.vstack([by_contact, np.zeros((memory, contacts))])
        self.direct = self.laws @ by_force
        closure = np.linalg.solve(self.direct, self.laws)
        self._closure: Matrix = np.asarray(closure, dtype=float)
        self._by_law: Matrix = np.eye(len(by_force)) - by_force @ self._closure
        self.event_row: Vector = phase.event @ self._by_law
        by_velocity, constant = impulses(cell, p)
        self.hit = np.flatnonzero(np.abs(by_velocity).sum(axis=1) + np.abs(constant))
        self.impulse = np.column_stack([by_velocity, constant])
        self.fixing: Vector = _fixing(cell, poles, p) * np.diag(self.direct)

    @cached_property
    def event(self) -> Forms:
        """The event at its end."""
        return self._poles.forms(self.event_row[None])

    @cached_property
    def force(self) -> Forms:
        """The contact forces."""
        return self._poles.forms(-self._closure)

    @cached_property
    def seen(self) -> Forms:
        """The variables of forms."""
        return self._poles.forms(self._by_law[: self._width])


class Layout:
    """A cell in the force series of an order: phases, poles, and the order of the unknowns.

    Attributes
    ----------
    phases : tuple of Phase
    poles : Poles
    forms : Forms
        The laws of each phase, without their parts by the contact forces; the event of each;
        then `velocity` and `setting`.
    velocity, setting : Forms
        The velocity of each contact; the value that each memory is set to.
    pieces, hits : ndarray of int
        See `Setting`.
    first_impulse, first_memory, size : int
        The index of the first impulse and of the first memory among the unknowns, and their
        number.
    """

    def __init__(self, cell: "BodyCell", poles: Poles, order: int) -> None:
        self.poles, contacts = poles, cell.body.at.shape[1]
        self.phases = tuple(Phase(cell, poles, p) for p in range(len(cell.phases)))
        self.forms = poles.forms(self._rows(cell))
        varies = self.forms.poles.any(axis=1) | (self.forms.turn != 0)
        pieces, at = [], 0
        for p, phase in enumerate(self.phases):
            if varies[p * contacts : (p + 1) * contacts].any():
                phase.degree, phase.pieces = _pieces(order)
            elif p < len(self.phases) - 1:  # the others suffice
                phase.fixing = np.zeros(contacts)
            elif phase.fixing.any():  # a constant force all the time would move nothing
                phase.degree = 1
            for piece in range(1, 1 + phase.pieces):
                pieces.append((p, at, piece == phase.pieces))
                at += (phase.degree + 1) * contacts
        self.pieces: Integers = np.array(pieces)
        self.hits, self.first_impulse = np.full((len(self.phases), contacts), -1), at
        for indices, phase in zip(self.hits, self.phases, strict=True):
            indices[phase.hit] = range(at, at + len(phase.hit))
            at += len(phase.hit)
        self.first_memory, self.size = at, at + len(cell.memory)

    def _rows(self, cell: "BodyCell") -> Matrix:
        """Return the rows of `forms`."""
        contacts, memories = cell.body.at.shape[1], len(cell.memory)
        width = 2 + 4 * contacts
        further = np.zeros((contacts + memories, width + memories))
        further[range(contacts), places(contacts)[1]] = 1.0
        for row, memory in zip(further[contacts:], cell.memory, strict=True):
            row[:width] = memory.value[:width]
        laws = [phase.laws for phase in self.phases]
        return np.vstack([*laws, *(phase.event_row for phase in self.phases), further])

    @property
    def velocity(self) -> Forms:
        """The velocity of each contact."""
        first = sum(len(phase.laws) + 1 for phase in self.phases)
        return self.forms.some(slice(first, first + self.hits.shape[1]))

    @property
    def setting(self) -> Forms:
        """The value that each memory is set to."""
        first = len(self.forms.turn) - self.size + self.first_memory
        return self.forms.some(slice(first, None))

    @property
    def memory(self) -> slice:
        """Where the memory is among the unknowns."""
        return slice(self.first_memory, self.size)

    def first_of(self, p: int) -> int:
        """Return the first piece of a phase."""
        return int(np.searchsorted(self.pieces[:, 0], p))


@lru_cache(maxsize=64)
def layout(cell: "BodyCell", order: int, least: float = RESONANT) -> Layout:
    """Return the equations of a cell at an order N, with N + 1 coefficients of a force.

    Parameters
    ----------
    cell : BodyCell
    order : int
    least : float, optional
        The relative change of a mode over the cell up to which auxiliary springs hold the body.

    Raises
    ------
    BodyError
        If an undamped mode that no contact sees is in resonance with the forcing.
    """
    poles = poles_of(cell.body, cell.omega)
    if _change(cell, poles) <= least or shifts(cell)[0].size:
        poles = poles_of(cell.body, cell.omega, hold=True)
        if _change(cell, poles) <= RESONANT:
            raise BodyError(
                "frequency: an undamped mode of the body repeats itself with the forcing, and "
                "no contact sees it: damp it a little, or leave it out"
            )
    return Layout(cell, poles, order)


def for_harmonics(cell: "BodyCell") -> Layout:
    """Return phases and poles of a cell for `harmonics`, which has other unknowns."""
    return layout(cell, 1, OF_HARMONICS)


def _change(cell: "BodyCell", poles: Poles) -> float:
    """Return ``min |1 - sigma e^(s T)|`` over the poles; infinity without a forcing."""
    if not cell.forced:
        return np.inf
    changes = np.abs(1 - cell.sign * np.exp(poles.s * cell.duration))
    return float(changes.min(initial=np.inf))


class Setting(NamedTuple):
    """A `Layout` as arrays, the `case` of `series` and `events`.

    Parameters
    ----------
    s : ndarray of complex, shape (m,)
    b : ndarray of complex, shape (c, m)
    forms, turns, rest : ndarray
        The factors of forms: of the poles, (R, m); of the forcing, (R,); of 1 and the memory,
        (R, 1 + M).  The rows are the laws of each phase, the events, the velocities of the
        contacts, and the values of the memories.
    direct, impulse, fixing : ndarray
        See `Phase`; of each phase.
    hits : ndarray of int, shape (P, c)
        The unknown that is the impulse of each contact at the end of each phase, or -1.
    pieces : ndarray of int, shape (E, 3)
        For each piece its phase, the first of its unknowns, and 1 for the last of its phase.
    degrees, counts : ndarray of int, shape (P,)
        The degree of a piece of each phase, and the number of pieces.
    sets : ndarray of int, shape (M,)
        The piece at whose start each memory is set.
    size : ndarray of int, shape (2,)
        The number of unknowns, and the index of the first memory.
    numbers : ndarray, shape (3,)
        Omega, sign, and duration of the cell; the last is 0 without a forcing.
    evaluated : ndarray, shape (1 + W, W)
        The W times of the last residual and its Jacobian there; each solve has its own copy.
    """

    s: Complex
    b: Complex
    forms: Complex
    turns: Complex
    rest: Matrix
    direct: Matrix
    impulse: Matrix
    fixing: Matrix
    hits: Integers
    pieces: Integers
    degrees: Integers
    counts: Integers
    sets: Integers
    size: Integers
    numbers: Vector
    evaluated: Matrix


@lru_cache(maxsize=64)
def setting(cell: "BodyCell", order: int) -> Setting:
    """Return the equations of a cell at an order as arrays."""
    equations = layout(cell, order)
    forms = equations.forms
    width = len(equations.phases) + cell.forced
    return Setting(
        equations.poles.s,
        np.ascontiguousarray(equations.poles.b.T),
        forms.poles,
        forms.turn.astype(complex),
        np.column_stack([forms.constant, forms.memory]).astype(float),
        np.array([phase.direct for phase in equations.phases], dtype=float),
        np.array([phase.impulse for phase in equations.phases], dtype=float),
        np.array([phase.fixing for phase in equations.phases], dtype=float),
        equations.hits,
        equations.pieces,
        np.array([phase.degree for phase in equations.phases]),
        np.array([phase.pieces for phase in equations.phases]),
        np.array([equations.first_of(each.phase) for each in cell.memory], dtype=int),
        np.array([equations.size, equations.first_memory]),
        np.array([cell.omega, cell.sign, cell.duration if cell.forced else 0.0]),
        np.full((1 + width, width), np.nan),
    )


def _fixing(cell: "BodyCell", poles: Poles, p: int) -> Vector:
    """Return spring forces at the contacts, per unit of the event at the end of a phase.

    They determine displacements that nothing else does; without a forcing also by how much a
    motion is shifted in time, and how fast it is.  They are 0 on an orbit; see `parts_of`.
    They are added to the constant and the linear terms of the laws: a constant alone does no
    work on a motion with the same velocities out and back.
    """
    directions, moved = shifts(cell)[0], np.zeros(poles.b.shape[1])
    is_unheld = directions.size > 0 and poles.held is not None
    if cell.forced and not is_unheld:
        return moved
    rows = lawful(cell, p).rows
    event = switch(cell, p, rows).gradient
    springs = held_by(cell.body, cell.omega).springs
    places_ = rows[places(len(springs))[0], : 2 * len(cell.body.squares)]
    if is_unheld:
        by_event = places_ @ directions[: places_.shape[1]]
        moved += (by_event @ np.linalg.pinv((event @ directions)[None]))[:, 0]
    if not cell.forced:
        moved += np.linalg.norm(places_, axis=1) / np.linalg.norm(event)
    return springs * moved


def _pieces(order: int) -> tuple[int, int]:
    """Return the degree of each piece of a phase, and the number of pieces.

    Examples
    --------
    >>> _pieces(10), _pieces(40)
    ((10, 1), (20, 2))
    """
    pieces = -(-order // MOST)
    return -(-order // pieces), pieces
