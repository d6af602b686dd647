"""The force series: contact forces in Legendre polynomials, the body by its poles.

``lam = sum l_n P_n*(u)`` on each phase in which the law leaves the force unknown, the law
tested with the same polynomials; where the force is given, one constant is exact.  At given
times forces, impulses and memory are one linear system, and Newton's method sees the durations
and the phase of the forcing alone.  Neither depends on the number of modes.
"""

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Indices, Matrix, Vector
from .exact import angles_of
from .integrals import moment_rates, moments, response_rates, responses
from .laws import free, law_matrix, places
from .modal import Complex
from .poles import Forms, Poles, poles_of
from .switch import impulses

if TYPE_CHECKING:
    from ..scenes.body_cell import BodyCell

#: Most polynomials of a piece: a phase of more is cut into equal pieces.
MOST = 32


@dataclass(frozen=True, eq=False)
class Phase:
    """What the equations know of a phase.

    Parameters
    ----------
    law, event, seen : Forms
        The laws; the event at its end and what forms are of, both by the law of the force.
    direct : ndarray, shape (c, c)
        What the forces add to the laws.
    velocity : Forms
        Of each contact.
    hit : ndarray of int
        The contacts that an impulse meets at its end.
    impulse : ndarray, shape (c, c + 1)
        Impulses by the velocities, and the constant.
    degree : int
        Of the series of a piece.
    pieces : int
    """

    law: Forms
    event: Forms
    seen: Forms
    direct: Matrix
    velocity: Forms
    hit: Indices
    impulse: Matrix
    degree: int
    pieces: int


@dataclass(frozen=True, eq=False)
class Layout:
    """A cell in the force series of an order: phases, poles, and where unknowns are.

    Parameters
    ----------
    phases : tuple of Phase
    poles : Poles
    setting : Forms
        What each memory is set to.
    elements : tuple of (int, int)
        Of each piece its phase, and where its coefficients begin.
    first_impulse, first_memory, size : int
        Where these begin among the unknowns, and how many unknowns there are.
    """

    phases: tuple[Phase, ...]
    poles: Poles
    setting: Forms
    elements: tuple[tuple[int, int], ...]
    first_impulse: int
    first_memory: int
    size: int


@lru_cache(maxsize=64)
def layout(cell: "BodyCell", order: int) -> Layout:
    """Return the equations of a cell at an order N, N + 1 coefficients an unknown force."""
    poles = poles_of(cell.body, cell.omega)
    phases = tuple(_phase(cell, poles, p, order) for p in range(len(cell.phases)))
    contacts, elements, at = cell.body.at.shape[1], [], 0
    for p, phase in enumerate(phases):
        for _ in range(phase.pieces):
            elements.append((p, at))
            at += (phase.degree + 1) * contacts
    memory = at + sum(len(phase.hit) for phase in phases)
    width, count = 2 + 4 * contacts, len(cell.memory)
    values = [each.value[:width] for each in cell.memory]
    rows = np.array(values).reshape(count, width)
    setting = poles.forms(np.hstack([rows, np.zeros((count, count))]))
    return Layout(
        phases, poles, setting, tuple(elements), at, memory, memory + len(cell.memory)
    )


def _phase(cell: "BodyCell", poles: Poles, p: int, order: int) -> Phase:
    own, memory = free(cell.body, cell.omega, len(cell.memory)), len(cell.memory)
    contacts, width = cell.body.at.shape[1], len(own.by_force)
    rows = law_matrix(cell, cell.phases[p])
    by_force = np.vstack([own.by_force, np.zeros((memory, contacts))])
    direct = rows @ by_force
    closure = np.linalg.solve(direct, rows)  # the forces are less this of the rest
    x, v, f, a = places(contacts)
    unforced = np.eye(width + memory)
    unforced[f] = 0.0
    law = rows @ unforced
    event = np.array([cell.phases[p].event])
    seen = (np.eye(width + memory) - by_force @ closure) @ unforced
    by_velocity, constant = impulses(cell, p)
    hit = np.flatnonzero(np.abs(by_velocity).sum(axis=1) + np.abs(constant))
    given = not (law[:, [*x, *v, *a]].any() or law[:, 2].any())
    degree, pieces = (0, 1) if given else _pieces(order)
    return Phase(
        poles.forms(law), poles.forms(event @ seen), poles.forms(seen[:width]), direct,
        poles.forms(np.eye(width + memory)[v]), hit, np.column_stack([by_velocity, constant]),
        degree, pieces,
    )  # fmt: skip


def _pieces(order: int) -> tuple[int, int]:
    """Return the degree of each piece of a phase, and how many there are.

    Examples
    --------
    >>> _pieces(10), _pieces(40)
    ((10, 1), (20, 2))
    """
    pieces = -(-order // MOST)
    return -(-order // pieces), pieces


@dataclass(frozen=True, eq=False)
class Evaluation:
    """What the times of a cell say: see `exact.Evaluation`.

    Parameters
    ----------
    residual, jacobian : ndarray
    unknowns : ndarray
        Coefficients of forces by piece, degree and contact; impulses; memory.
    states : ndarray of complex, shape (E, m)
        z where each piece begins.
    """

    residual: Vector
    jacobian: Matrix
    unknowns: Vector
    states: Complex


@dataclass(frozen=True, eq=False)
class Element:
    """One piece of a phase and its integrals.

    Parameters
    ----------
    phase : Phase
    duration : float
    columns : slice
        Its coefficients among the unknowns.
    a, a_rate : ndarray of complex, shape (m, N + 1)
        ``a_n`` of each pole, and its derivative by kappa.
    Z, Z_rate : ndarray of complex, shape (m, N + 1, N + 1)
    turn, turn_rate : ndarray of complex, shape (N + 1,)
        ``a_n`` of the forcing.
    decay : ndarray of complex, shape (m,)
        ``e^kappa``.
    gain, gain_rate : ndarray of complex, shape (m, columns)
        What coefficients add to z, and its derivative by the duration.
    """

    phase: Phase
    duration: float
    columns: slice
    a: Complex
    a_rate: Complex
    Z: Complex
    Z_rate: Complex
    turn: Complex
    turn_rate: Complex
    decay: Complex
    gain: Complex
    gain_rate: Complex


def _element(phase: Phase, poles: Poles, s: float) -> Element:
    """Return a piece of a phase that lasts `s`; its columns are those of the first."""
    count = phase.degree + 1
    kappa = poles.s * s
    a, Z = moments(kappa, count + 1), responses(kappa, count + 1)
    turn = moments(1j * poles.omega * s, count + 1)
    signs = (-1.0) ** np.arange(count)
    a_rate = moment_rates(a)
    slope = a[:, :count] + kappa[:, None] * a_rate
    return Element(
        phase, s, slice(0), a[:, :count], a_rate, Z[:, :count, :count], response_rates(Z),
        turn[:count], moment_rates(turn), np.exp(kappa),
        _spread(s * signs * a[:, :count], poles.b), _spread(signs * slope, poles.b),
    )  # fmt: skip


def _spread(by_degree: Complex, b: Complex) -> Complex:
    """Return columns of coefficients, by degree and contact, from those of each."""
    return np.asarray(by_degree[:, :, None] * b[:, None, :]).reshape(len(b), -1)


def _evaluated(cell: "BodyCell", order: int, times: Vector) -> Evaluation:
    own, count = layout(cell, order), len(cell.phases)
    theta = angles_of(cell, times)
    elements, begins = _elements(own, times, theta, cell.omega)
    states, ends = _states(own, elements, cell.sign)
    A, right, events, constant = _system(cell, own, elements, begins, states, ends, theta)
    unknowns = np.asarray(np.linalg.solve(A, right), dtype=float)
    residual: Vector = events @ unknowns + constant
    moved, shifted = _rates(cell, own, elements, begins, states, unknowns, theta, len(times))
    jacobian: Matrix = shifted - events @ np.linalg.solve(A, moved)
    if cell.forced:
        residual = np.append(residual, times[:count].sum() - cell.duration)
        jacobian = np.vstack([jacobian, np.append(np.ones(count), 0.0)])
    started = np.array([state @ unknowns for state in states])
    return Evaluation(residual, jacobian, unknowns, started)


def _elements(
    own: Layout, times: Vector, theta: Vector, omega: float
) -> tuple[list[Element], Vector]:
    """Return the pieces, and the angle of the forcing where each begins."""
    made: dict[int, Element] = {}
    found: list[Element] = []
    begins, contacts = [], own.poles.b.shape[1]
    for p, at in own.elements:
        phase = own.phases[p]
        s = float(times[p]) / phase.pieces
        piece = sum(q == p for q, _ in own.elements[: len(found)])
        if p not in made:
            made[p] = _element(phase, own.poles, s)
        columns = slice(at, at + (phase.degree + 1) * contacts)
        found.append(replace(made[p], columns=columns))
        begins.append(theta[p] + omega * s * piece)
    return found, np.array(begins)


def _is_last(own: Layout, e: int) -> bool:
    """Whether a piece is the last of its phase."""
    return e + 1 == len(own.elements) or own.elements[e + 1][0] != own.elements[e][0]


def _impulses(own: Layout, p: int) -> slice:
    """Return where the impulses at the end of a phase are among the unknowns."""
    first = own.first_impulse + sum(len(phase.hit) for phase in own.phases[:p])
    return slice(first, first + len(own.phases[p].hit))


def _states(
    own: Layout, elements: list[Element], sign: int
) -> tuple[list[Complex], list[Complex]]:
    """Return z where each piece begins and ends, by the unknowns: shape (m, U) each."""

    def along(state: Complex) -> tuple[list[Complex], list[Complex], Complex]:
        starts, ends = [], []
        for e, element in enumerate(elements):
            p = own.elements[e][0]
            starts.append(state)
            state = element.decay[:, None] * state
            state[:, element.columns] += element.gain
            ends.append(state)
            if _is_last(own, e) and len(own.phases[p].hit):
                state = state.copy()
                state[:, _impulses(own, p)] += own.poles.b[:, own.phases[p].hit]
        return starts, ends, state

    nothing = np.zeros((len(own.poles.s), own.size), dtype=complex)
    around = np.exp(own.poles.s * sum(element.duration for element in elements))
    first = sign * along(nothing)[2] / (1 - sign * around)[:, None]
    starts, ends, _ = along(first)
    return starts, ends


def _system(
    cell: "BodyCell", own: Layout, elements: list[Element], begins: Vector,
    states: list[Complex], ends: list[Complex], theta: Vector,
) -> tuple[Matrix, Vector, Matrix, Vector]:  # fmt: skip
    """Return the linear system of the unknowns, and the events by them."""
    A, right = np.zeros((own.size, own.size)), np.zeros(own.size)
    events, constant = np.zeros((len(own.phases), own.size)), np.zeros(len(own.phases))
    memory = slice(own.first_memory, own.size)
    for e, element in enumerate(elements):
        p = own.elements[e][0]
        phase, law = element.phase, element.phase.law
        contacts, count = len(law.turn), phase.degree + 1
        rows = np.einsum("ki,in,iu->nku", law.poles, element.a, states[e]).real
        own_rows = np.einsum("ki,inm,ic->nkmc", law.poles, element.Z, own.poles.b).real
        for n in range(count):
            own_rows[n, :, n] += phase.direct / (2 * n + 1) / element.duration
        rows[:, :, element.columns] += element.duration * own_rows.reshape(count, contacts, -1)
        rows[0, :, memory] += law.memory
        A[element.columns] = rows.reshape(count * contacts, -1)
        turned = law.turn[None, :] * (element.turn * np.exp(1j * begins[e]))[:, None]
        turned[0] += law.constant
        right[element.columns] = -turned.real.ravel()
        if not _is_last(own, e):
            continue
        events[p], constant[p] = _values(phase.event, ends[e], theta[p + 1], memory, 0)
        for i, q in zip(phase.hit, range(own.size)[_impulses(own, p)], strict=True):
            A[q, q] += 1.0
            for c, weight in enumerate(phase.impulse[i, :-1]):
                row, rest = _values(phase.velocity, ends[e], theta[p + 1], memory, c)
                A[q] -= weight * row
                right[q] += weight * rest
            right[q] += phase.impulse[i, -1]
    for i, each in enumerate(cell.memory):
        e = next(e for e, (p, _) in enumerate(own.elements) if p == each.phase)
        row, rest = _values(own.setting, states[e], begins[e], memory, i)
        A[own.first_memory + i] = -row
        A[own.first_memory + i, own.first_memory + i] += 1.0
        right[own.first_memory + i] = rest
    return A, right, events, constant


def _values(
    forms: Forms, states: Complex, angle: float, memory: slice, k: int
) -> tuple[Vector, float]:
    """Return one of several forms by the unknowns: factors and constant."""
    row = (forms.poles[k] @ states).real
    row[memory] += forms.memory[k]
    return row, float((forms.turn[k] * np.exp(1j * angle)).real + forms.constant[k])


def _rates(
    cell: "BodyCell", own: Layout, elements: list[Element], begins: Vector,
    states: list[Complex], unknowns: Vector, theta: Vector, width: int,
) -> tuple[Matrix, Matrix]:  # fmt: skip
    """Return the derivatives of system and events by the times, at fixed unknowns."""
    s, part = own.poles.s[:, None], [1.0 / own.phases[p].pieces for p, _ in own.elements]
    angles = np.zeros((len(elements) + 1, width))  # of where each piece begins
    angles[:, len(own.phases) :] = 1.0
    for e, (p, _) in enumerate(own.elements):
        angles[e + 1] = angles[e]
        angles[e + 1, p] += cell.omega * part[e]
    starts, ends = _moving(own, elements, states, unknowns, part, width, cell.sign)
    moved, shifted = np.zeros((own.size, width)), np.zeros((len(own.phases), width))
    for e, element in enumerate(elements):
        p = own.elements[e][0]
        phase, law = element.phase, element.phase.law
        count, l = phase.degree + 1, unknowns[element.columns].reshape(phase.degree + 1, -1)
        rows = np.einsum("ki,in,iw->nkw", law.poles, element.a, starts[e]).real
        begun = states[e] @ unknowns
        kappa = (own.poles.s * element.duration)[:, None, None]
        forced = (own.poles.b @ l.T) @ (element.Z + kappa * element.Z_rate).transpose(0, 2, 1)
        answered = forced[np.arange(len(s)), np.arange(len(s))]  # each pole with its own force
        own_rate = (s * element.a_rate * begun[:, None] + answered).T @ law.poles.T
        rows[:, :, p] += part[e] * own_rate.real
        wave = law.turn[None, :] * np.exp(1j * begins[e])
        rows += (1j * wave * element.turn[:, None]).real[:, :, None] * angles[e]
        rows[:, :, p] += part[e] * (1j * cell.omega * wave * element.turn_rate[:, None]).real
        moved[element.columns] = rows.reshape(count * len(law.turn), -1)
        if not _is_last(own, e):
            continue
        shifted[p] = _moved(phase.event, ends[e], theta[p + 1], angles[e + 1])[0]
        velocity = _moved(phase.velocity, ends[e], theta[p + 1], angles[e + 1])
        moved[_impulses(own, p)] = -(phase.impulse[phase.hit, :-1] @ velocity)
    for i, each in enumerate(cell.memory):
        e = next(e for e, (p, _) in enumerate(own.elements) if p == each.phase)
        moved[own.first_memory + i] = -_moved(own.setting, starts[e], begins[e], angles[e])[i]
    return moved, shifted


def _moved(forms: Forms, states: Complex, angle: float, turns: Vector) -> Matrix:
    """Return the derivatives of forms by the times, the unknowns held."""
    wave = (1j * forms.turn * np.exp(1j * angle)).real
    return np.asarray((forms.poles @ states).real + wave[:, None] * turns)


def _moving(
    own: Layout, elements: list[Element], states: list[Complex], unknowns: Vector,
    part: list[float], width: int, sign: int,
) -> tuple[list[Complex], list[Complex]]:  # fmt: skip
    """Return the derivatives of z by the times where each piece begins and ends."""

    def along(state: Complex) -> tuple[list[Complex], list[Complex], Complex]:
        starts, ends = [], []
        for e, element in enumerate(elements):
            starts.append(state)
            state = element.decay[:, None] * state
            begun = states[e] @ unknowns
            rate = own.poles.s * element.decay * begun
            state[:, own.elements[e][0]] += part[e] * (
                rate + element.gain_rate @ unknowns[element.columns]
            )
            ends.append(state)
        return starts, ends, state

    nothing = np.zeros((len(own.poles.s), width), dtype=complex)
    around = np.exp(own.poles.s * sum(element.duration for element in elements))
    first = sign * along(nothing)[2] / (1 - sign * around)[:, None]
    starts, ends, _ = along(first)
    return starts, ends


@lru_cache(maxsize=8)
def _kept(cell: "BodyCell", order: int, times: bytes) -> Evaluation:
    return _evaluated(cell, order, np.frombuffer(times))


def evaluated(cell: "BodyCell", order: int, times: Vector) -> Evaluation:
    """Return residual, Jacobian, unknowns and states of the force series at given times."""
    return _kept(cell, order, np.ascontiguousarray(times, dtype=float).tobytes())


def signals(cell: "BodyCell", order: int, times: Vector, p: int, u: Vector) -> Matrix:
    """Return what forms are of on phase `p`, the force by its law; shape (S, len(u))."""
    own, found = layout(cell, order), evaluated(cell, order, times)
    phase, poles = own.phases[p], own.poles
    u = np.asarray(u, dtype=float)
    piece = np.minimum((u * phase.pieces).astype(int), phase.pieces - 1)
    first = next(e for e, (q, _) in enumerate(own.elements) if q == p)
    s = float(times[p]) / phase.pieces
    z = np.empty((len(poles.s), len(u)), dtype=complex)
    for e in np.unique(piece):
        here = piece == e
        columns = own.elements[first + e][1]
        count = (phase.degree + 1) * poles.b.shape[1]
        l = found.unknowns[columns : columns + count].reshape(phase.degree + 1, -1)
        z[:, here] = _along(poles, found.states[first + e], l, s, u[here] * phase.pieces - e)
    theta = angles_of(cell, times)[p] + cell.omega * float(times[p]) * u
    return phase.seen.at(z, theta, found.unknowns[own.first_memory :])


def _along(poles: Poles, start: Complex, l: Matrix, s: float, u: Vector) -> Complex:
    """Return z at local times of a piece: its force on [0, u], as a series of its own."""
    count = len(l)
    nodes, weights = np.polynomial.legendre.leggauss(count)
    basis = np.polynomial.legendre.legvander(nodes, count - 1)
    inner = np.polynomial.legendre.legvander(u[:, None] * (nodes + 1) - 1, count - 1)
    values = inner @ l  # of the force, by time, node, contact
    factors = (2 * np.arange(count) + 1) / 2 * (-1.0) ** np.arange(count)
    series = np.einsum("g,gn,tgc->tnc", weights, basis * factors, values)
    kappa = poles.s[:, None] * (s * u)
    gained = np.einsum("itn,tnc,ic->it", moments(kappa, count), series, poles.b)
    return np.asarray(start[:, None] * np.exp(kappa) + s * u * gained)
