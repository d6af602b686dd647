"""The force series: contact forces in Legendre polynomials, the body by its poles.

``lam = sum l_n P_n*(u)`` on each phase in which the law leaves the force unknown, the law
tested with the same polynomials; where the force is given, one constant is exact.  At given
times forces, impulses and memory are one linear system, and Newton's method sees the durations
and the phase of the forcing alone.  Neither depends on the number of modes.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Matrix, Vector
from .element import Element, elements_of
from .integrals import response_rates
from .layout import Layout, layout
from .modal import Complex
from .part import angles_of
from .poles import Forms

if TYPE_CHECKING:
    from ..scenes.bodies.cell import BodyCell


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


def _evaluated(cell: "BodyCell", order: int, times: Vector) -> Evaluation:
    own, count = layout(cell, order), len(cell.phases)
    theta = angles_of(cell, times)
    elements, begins = elements_of(own, times, theta, cell.omega)
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


#: What a piece adds to z, or to its derivatives: of its index and z there.
Add = Callable[[int, Complex], None]


def _around(
    own: Layout, elements: list[Element], width: int, sign: int, within: Add, behind: Add
) -> tuple[list[Complex], list[Complex]]:
    """Return what is carried by the poles where each piece begins and ends, periodic.

    Parameters
    ----------
    own : Layout
    elements : list of Element
    width : int
        Columns of what is carried; it has a row a pole.
    sign : int
        What the motion is multiplied by from one cell to the next.
    within, behind : callable
        Add what comes in a piece, and behind it.
    """

    def along(state: Complex) -> tuple[list[Complex], list[Complex], Complex]:
        starts, ends = [], []
        for e, element in enumerate(elements):
            starts.append(state)
            state = element.decay[:, None] * state
            within(e, state)
            ends.append(state)
            state = state.copy()
            behind(e, state)
        return starts, ends, state

    nothing = np.zeros((len(own.poles.s), width), dtype=complex)
    decay = np.exp(own.poles.s * sum(element.duration for element in elements))
    first = sign * along(nothing)[2] / (1 - sign * decay)[:, None]
    return along(first)[:2]


def _states(
    own: Layout, elements: list[Element], sign: int
) -> tuple[list[Complex], list[Complex]]:
    """Return z where each piece begins and ends, by the unknowns: shape (m, U) each."""

    def forces(e: int, state: Complex) -> None:
        state[:, elements[e].columns] += elements[e].gain

    def impulses(e: int, state: Complex) -> None:
        p = own.elements[e][0]
        if own.is_last(e):
            state[:, own.impulses(p)] += own.poles.b[:, own.phases[p].hit]

    return _around(own, elements, own.size, sign, forces, impulses)


def _system(
    cell: "BodyCell", own: Layout, elements: list[Element], begins: Vector,
    states: list[Complex], ends: list[Complex], theta: Vector,
) -> tuple[Matrix, Vector, Matrix, Vector]:  # fmt: skip
    """Return the linear system of the unknowns, and the events by them."""
    A, right = np.zeros((own.size, own.size)), np.zeros(own.size)
    events, constant = np.zeros((len(own.phases), own.size)), np.zeros(len(own.phases))
    memory = own.memory
    for e, element in enumerate(elements):
        p = own.elements[e][0]
        phase, law = element.phase, element.phase.law
        contacts, count = len(law.turn), phase.degree + 1
        rows = np.einsum("ki,in,iu->nku", law.poles, element.a, states[e]).real
        Z = element.Z[:, :-1, :-1]
        own_rows = np.einsum("ki,inm,ic->nkmc", law.poles, Z, own.poles.b).real
        for n in range(count):
            own_rows[n, :, n] += phase.direct / (2 * n + 1) / element.duration
        rows[:, :, element.columns] += element.duration * own_rows.reshape(count, contacts, -1)
        rows[0, :, memory] += law.memory
        A[element.columns] = rows.reshape(count * contacts, -1)
        turned = law.turn[None, :] * (element.turn * np.exp(1j * begins[e]))[:, None]
        turned[0] += law.constant
        right[element.columns] = -turned.real.ravel()
        if not own.is_last(e):
            continue
        events[p], constant[p] = _values(phase.event, ends[e], theta[p + 1], memory, 0)
        for i, q in zip(phase.hit, range(own.size)[own.impulses(p)], strict=True):
            A[q, q] += 1.0
            for c, weight in enumerate(phase.impulse[i, :-1]):
                row, rest = _values(phase.velocity, ends[e], theta[p + 1], memory, c)
                A[q] -= weight * row
                right[q] += weight * rest
            right[q] += phase.impulse[i, -1]
    for i, each in enumerate(cell.memory):
        e = own.first_of(each.phase)
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
        kappa = (own.poles.s * element.duration)[:, None]
        forced = own.poles.b @ l.T
        answered = kappa * response_rates(element.Z, forced)
        answered += (element.Z[:, :-1, :-1] @ forced[:, :, None])[:, :, 0]
        own_rate = (s * element.a_rate * begun[:, None] + answered).T @ law.poles.T
        rows[:, :, p] += part[e] * own_rate.real
        wave = law.turn[None, :] * np.exp(1j * begins[e])
        rows += (1j * wave * element.turn[:, None]).real[:, :, None] * angles[e]
        rows[:, :, p] += part[e] * (1j * cell.omega * wave * element.turn_rate[:, None]).real
        moved[element.columns] = rows.reshape(count * len(law.turn), -1)
        if not own.is_last(e):
            continue
        shifted[p] = _moved(phase.event, ends[e], theta[p + 1], angles[e + 1])[0]
        velocity = _moved(phase.velocity, ends[e], theta[p + 1], angles[e + 1])
        moved[own.impulses(p)] = -(phase.impulse[phase.hit, :-1] @ velocity)
    for i, each in enumerate(cell.memory):
        e = own.first_of(each.phase)
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

    def longer(e: int, state: Complex) -> None:
        element, p = elements[e], own.elements[e][0]
        rate = own.poles.s * element.decay * (states[e] @ unknowns)
        state[:, p] += part[e] * (rate + element.gain_rate @ unknowns[element.columns])

    return _around(own, elements, width, sign, longer, lambda e, state: None)


@lru_cache(maxsize=8)
def _kept(cell: "BodyCell", order: int, times: bytes) -> Evaluation:
    return _evaluated(cell, order, np.frombuffer(times))


def evaluated(cell: "BodyCell", order: int, times: Vector) -> Evaluation:
    """Return residual, Jacobian, unknowns and states of the force series at given times."""
    return _kept(cell, order, np.ascontiguousarray(times, dtype=float).tobytes())
