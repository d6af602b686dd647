"""The exact equations of a body in balls, by the matrix exponential of each phase.

The state is ``Y = (eta, eta', cos, sin, 1, memory)`` of its modes, and a phase is ``Y' = A Y``.
"""

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from flint import acb, arb, arb_mat

from ...arrays import Matrix
from ...bodies.laws import places, scales
from ...bodies.part import onto_event, parts_of, shifts
from ...bodies.switch import UNSEEN
from .body import Balls, Body, balls, impulses, laws, solved

if TYPE_CHECKING:
    from ...scenes.bodies.cell import BodyCell


class Free(NamedTuple):
    """A body without its contact forces, and their effect: see `solver.bodies.laws.Free`."""

    A: Balls
    B: Balls
    rows: Balls
    by_force: Balls


def residual(cell: "BodyCell", times: Any, R: Any) -> None:
    """Fill R with residuals of events and of the cell's duration; see ``bodies.exact``."""
    count, body = len(cell.phases), Body(cell)
    free, clock = _free(cell, body), 2 * len(cell.body.squares)
    angle = times[count] if cell.forced else arb(0)
    flows, events, switches = [], [], []
    for p in range(count):
        law = laws(cell.carrying(p))
        forces = -solved(law @ free.by_force, law @ free.rows)
        A, variables = free.A + free.B @ forces, free.rows + free.by_force @ forces
        flows.append(np.array(arb_mat((A * times[p]).tolist()).exp().tolist(), dtype=object))
        events.append(balls(cell.carrying(p).event) @ variables)
        switches.append(_switch(cell, p, free, variables[places(cell.body.at.shape[1])[1]]))
    units = np.append(1 / scales(cell.body, cell.omega), np.ones(clock // 2))  # of places first
    before, behind = (q[:clock] * units[:, None] for q in shifts(cell))
    _fix(switches, events, before, cell.sign * behind)
    for p in range(0 if cell.forced else count):  # see `parts_of`
        event, shift = onto_event(parts_of(cell)[p].switch)
        shift[:clock] *= units[:, None]
        shift *= (cell.sign if p == count - 1 else 1) / (event[:, 0] @ event[:, 0])
        switches[p] -= balls(np.insert(shift, [clock] * 3, 0.0, axis=0)) * events[p]
    whole = balls(np.eye(len(flows[0])))
    for flow, switch in zip(flows, switches, strict=True):
        whole = switch @ (flow @ whole)
    unknown = [*range(clock), *range(clock + 3, len(whole))]
    Y = balls(np.zeros(len(whole)))
    Y[clock : clock + 3] = angle.cos(), angle.sin(), arb(1)
    closing = balls(np.eye(len(unknown))) - whole[np.ix_(unknown, unknown)]
    Y[unknown] = solved(closing, (whole[unknown] @ Y)[:, None])[:, 0]
    for p in range(count):
        Y = flows[p] @ Y
        R[p] = events[p] @ Y
        Y = switches[p] @ Y
    if cell.forced:
        R[count] = sum(times[:count], arb(0)) - body.duration


def _free(cell: "BodyCell", body: Body) -> Free:
    """Return the matrices of a body with free contacts, over the state Y."""
    modal, memory, contacts = body.modal, len(cell.memory), body.modal.at.shape[1]
    count, at = len(modal.squares), balls(modal.at)
    displacement, velocity, clock = slice(count), slice(count, 2 * count), 2 * count
    A = balls(np.zeros((clock + 3 + memory,) * 2))
    A[displacement, velocity] = balls(np.eye(count))
    A[velocity, displacement], A[velocity, velocity] = (
        balls(-np.diag(modal.squares)),
        -balls(modal.damping),
    )
    A[velocity, clock] = balls(modal.forcing)
    A[clock, clock + 1], A[clock + 1, clock] = -body.omega, body.omega
    B = balls(np.zeros((len(A), contacts)))
    B[velocity] = at
    x, v, force, a = places(contacts)
    size = 2 + 4 * contacts
    rows = balls(np.zeros((size + memory, len(A))))
    rows[x, displacement], rows[v, velocity], rows[a] = at.T, at.T, at.T @ A[velocity]
    rows[2, clock] = rows[3, clock + 2] = arb(1)
    rows[size:, clock + 3 :] = balls(np.eye(memory))
    for order, which in enumerate((x, v, a)):  # Re(h (i Omega)^order e^(i theta))
        turned = balls(modal.beyond) * (acb(0, 1) * body.omega) ** order
        for row, h in zip(which, turned, strict=True):
            rows[row, clock] += h.real
            rows[row, clock + 1] -= h.imag
    by_force = balls(np.zeros((size + memory, contacts)))
    by_force[x], by_force[force] = balls(modal.residual), balls(np.eye(contacts))
    by_force[a] = at.T @ at
    return Free(A, B, rows, by_force)


def _fix(switches: list[Balls], events: list[Balls], before: Matrix, after: Matrix) -> None:
    """Add to each switch a shift of the state onto its event, which is 0 on an orbit.

    Phases do not depend on these shifts, so periodicity alone leaves them undetermined.  Those
    that no event depends on either are projected out.
    """
    if not before.size:
        return
    start, moved = (balls(np.zeros((len(events[0]), before.shape[1]))) for _ in range(2))
    start[: len(before)], moved[: len(after)] = balls(before), balls(after)
    by_event = np.array(events) @ start
    for p, by_shift in enumerate(by_event):
        if any(q != 0 for q in by_shift):
            shift = moved @ by_shift / (by_shift @ by_shift)
            switches[p] -= shift[:, None] * events[p]
    _, sizes, Vh = np.linalg.svd(by_event.astype(float))
    unseen = moved @ balls(Vh[(sizes > UNSEEN * np.abs(before).max()).sum() :].T)
    if unseen.size:
        factors = solved(unseen.T @ unseen, unseen.T @ switches[-1])
        switches[-1] -= unseen @ factors


def _switch(cell: "BodyCell", p: int, free: Free, velocities: Balls) -> Balls:
    """Return the matrix of the switch at the end of a phase."""
    count, after = len(cell.body.squares), (p + 1) % len(cell.phases)
    size, clock, matrix = 2 + 4 * cell.body.at.shape[1], 2 * count, balls(np.eye(len(free.A)))
    hit, mobility, factors, constants = impulses(cell, p)
    if hit:
        right = factors[:, None] * velocities[hit]
        right[:, clock + 2] += constants
        matrix = matrix + free.B[:, hit] @ solved(mobility, right)
    sign = cell.sign if after == 0 else 1
    for i, remembered in enumerate(cell.memory):
        if remembered.phase == after:  # of the mirrored state
            form = balls(np.array(remembered.value[:size], dtype=float))
            form[3] = sign * form[3]
            matrix[clock + 3 + i] = form @ (free.rows[:size] @ matrix)
    mirrored = [*range(clock + 2), *range(clock + 3, len(matrix))]
    matrix[mirrored] = sign * matrix[mirrored]
    return matrix
