"""The equations of the force series for a cell: its phases, and where the unknowns are."""

from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ...arrays import Complex, Integers, Matrix, Vector
from ..laws import added, law_matrix, lawful, places
from ..part import shifts
from ..poles import Poles, poles_of
from ..switch import impulses, switch
from ..systems import BodyError

if TYPE_CHECKING:
    from ...scenes.bodies.cell import BodyCell

#: Most polynomials of a piece: a phase of more is cut into equal pieces.
MOST = 32

#: Change of a mode over a cell of a forcing below which springs hold the body.  They add what
#: polynomials have to follow in free phases, and nothing to harmonics, which lose digits more.
RESONANT, OF_HARMONICS = 1e-7, 1e-2


class Phase:
    """What the equations of an order know of phase `p` of a cell.

    Attributes
    ----------
    law, event, force, seen : Forms
        The laws; by these the event at its end, the contact forces, and what forms are of.
    direct : ndarray, shape (c, c)
        What the forces add to the laws.
    hit : ndarray of int
        The contacts that an impulse meets at its end.
    impulse : ndarray, shape (c, c + 1)
        Impulses by the velocities, and the constant.
    fixing : ndarray, shape (c,)
        What the event at its end adds to the laws: 0 on an orbit; see `_fixing`.
    degree : int
        Of the series of a piece.
    pieces : int
    """

    def __init__(self, cell: "BodyCell", poles: Poles, p: int, order: int) -> None:
        own, memory, phase = added(cell.body), len(cell.memory), cell.phases[p]
        width, contacts = own.shape
        rows = law_matrix(phase)
        by_force = np.vstack([own, np.zeros((memory, contacts))])
        self.direct = rows @ by_force
        closure: Matrix = np.asarray(np.linalg.solve(self.direct, rows), dtype=float)
        by_law = np.eye(width + memory) - by_force @ closure
        self.law, self.force = poles.forms(rows), poles.forms(-closure)
        self.event = poles.forms(np.array([phase.event]) @ by_law)
        self.seen = poles.forms(by_law[:width])
        by_velocity, constant = impulses(cell, p)
        self.hit = np.flatnonzero(np.abs(by_velocity).sum(axis=1) + np.abs(constant))
        self.impulse = np.column_stack([by_velocity, constant])
        self.fixing: Vector = _fixing(cell, poles, p) * np.diag(self.direct)
        given = not (self.law.poles.any() or self.law.turn.any())
        self.degree, self.pieces = (0, 1) if given else _pieces(order)


class Layout:
    """A cell in the force series of an order: phases, poles, and where unknowns are.

    Attributes
    ----------
    phases : tuple of Phase
    poles : Poles
    velocity, setting : Forms
        Of each contact; what each memory is set to.
    pieces, hits : ndarray of int
        See `Setting`.
    first_impulse, first_memory, size : int
        Where these begin among the unknowns, and how many unknowns there are.
    """

    def __init__(self, cell: "BodyCell", poles: Poles, order: int) -> None:
        self.poles, contacts = poles, cell.body.at.shape[1]
        self.phases = tuple(Phase(cell, poles, p, order) for p in range(len(cell.phases)))
        pieces, at = [], 0
        for p, phase in enumerate(self.phases):
            for piece in range(1, 1 + phase.pieces):
                pieces.append((p, at, piece == phase.pieces))
                at += (phase.degree + 1) * contacts
        self.pieces: Integers = np.array(pieces)
        self.hits, self.first_impulse = np.full((len(self.phases), contacts), -1), at
        for own, phase in zip(self.hits, self.phases, strict=True):
            own[phase.hit] = range(at, at + len(phase.hit))
            at += len(phase.hit)
        width, count = 2 + 4 * contacts, len(cell.memory)
        self.first_memory, self.size = at, at + count
        rows = np.array([each.value[:width] for each in cell.memory]).reshape(count, width)
        self.setting = poles.forms(np.hstack([rows, np.zeros((count, count))]))
        self.velocity = poles.forms(np.eye(width, width + count)[places(contacts)[1]])

    @property
    def memory(self) -> slice:
        """Where the memory is among the unknowns."""
        return slice(self.first_memory, self.size)

    def first_of(self, p: int) -> int:
        """Return the first piece of a phase."""
        return int(np.searchsorted(self.pieces[:, 0], p))


@lru_cache(maxsize=64)
def layout(cell: "BodyCell", order: int, least: float = RESONANT) -> Layout:
    """Return the equations of a cell at an order N, N + 1 coefficients an unknown force.

    Parameters
    ----------
    cell : BodyCell
    order : int
    least : float, optional
        The least change of a mode over the cell for which the body is not held.

    Raises
    ------
    BodyError
        If a mode repeats itself with the forcing that no contact sees: what is made of it is
        unbounded.
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
    """Return phases and poles of a cell for harmonics, whose unknowns are others."""
    return layout(cell, 1, OF_HARMONICS)


def _change(cell: "BodyCell", poles: Poles) -> float:
    """Return the least change of a mode over a cell of a forcing, as a part of it."""
    if not cell.forced:
        return np.inf
    changes = np.abs(1 - cell.sign * np.exp(poles.s * cell.duration))
    return float(changes.min(initial=np.inf))


class Setting(NamedTuple):
    """The same as arrays, which the functions of `series` take.

    Parameters
    ----------
    s : ndarray of complex, shape (m,)
    b : ndarray of complex, shape (c, m)
    forms, turns, rest : ndarray
        Forms by row: by the poles, (R, m); by the forcing, (R,); by 1 and the memory,
        (R, 1 + M).  The laws of each phase, the events, the velocities of the contacts, and
        what each memory is set to.
    direct, impulse, fixing : ndarray
        See `Phase`; of each phase.
    hits : ndarray of int, shape (P, c)
        Which unknown is the impulse of each contact at the end of each phase, or -1.
    pieces : ndarray of int, shape (E, 3)
        Of each piece its phase, where its coefficients begin, and whether it is the last.
    degrees, counts : ndarray of int, shape (P,)
        The degree of a piece of each phase, and how many there are.
    sets : ndarray of int, shape (M,)
        The piece at whose beginning each memory is set.
    size : ndarray of int, shape (2,)
        How many unknowns there are, and the first that is a memory.
    numbers : ndarray, shape (3,)
        Omega, sign, and duration of the cell, 0 where nothing forces.
    kept : ndarray, shape (1 + W, W)
        Room for W times, and the derivatives there; a copy for each use.
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
    kept: Matrix


@lru_cache(maxsize=64)
def setting(cell: "BodyCell", order: int) -> Setting:
    """Return the equations of a cell at an order as arrays."""
    own = layout(cell, order)
    rows = [
        *(phase.law for phase in own.phases),
        *(phase.event for phase in own.phases),
        own.velocity,
        own.setting,
    ]
    constants = np.concatenate([q.constant for q in rows])
    memories = np.concatenate([q.memory for q in rows])
    width = len(own.phases) + cell.forced
    return Setting(
        own.poles.s,
        np.ascontiguousarray(own.poles.b.T),
        np.concatenate([q.poles for q in rows]),
        np.concatenate([q.turn for q in rows]).astype(complex),
        np.column_stack([constants, memories]).astype(float),
        np.array([phase.direct for phase in own.phases], dtype=float),
        np.array([phase.impulse for phase in own.phases], dtype=float),
        np.array([phase.fixing for phase in own.phases], dtype=float),
        own.hits,
        own.pieces,
        np.array([phase.degree for phase in own.phases]),
        np.array([phase.pieces for phase in own.phases]),
        np.array([own.first_of(each.phase) for each in cell.memory], dtype=int),
        np.array([own.size, own.first_memory]),
        np.array([cell.omega, cell.sign, cell.duration if cell.forced else 0.0]),
        np.full((1 + width, width), np.nan),
    )


def _fixing(cell: "BodyCell", poles: Poles, p: int) -> Vector:
    """Return contact forces by the event at the end of a phase, which fix places as springs do.

    On an orbit they are 0; see `Switch.fixing`.  They are constant, and of the series linear
    as well: against a motion that is as fast out as back a constant does no work.
    """
    found, ways = np.zeros(poles.b.shape[1]), shifts(cell)[0]
    if ways.size and poles.held is not None:
        rows = lawful(cell, p).rows
        event = switch(cell, p, rows).gradient @ ways
        places_ = rows[places(len(found))[0], : 2 * len(cell.body.squares)]
        moved = places_ @ ways[: places_.shape[1]] @ np.linalg.pinv(event[None])
        found = poles.held.springs * moved[:, 0]
    return found


def _pieces(order: int) -> tuple[int, int]:
    """Return the degree of each piece of a phase, and how many there are.

    Examples
    --------
    >>> _pieces(10), _pieces(40)
    ((10, 1), (20, 2))
    """
    pieces = -(-order // MOST)
    return -(-order // pieces), pieces
