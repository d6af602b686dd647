"""The force series of a body in balls: Galerkin projection of the laws onto polynomials."""

from typing import Any

import numpy as np
from flint import acb, arb

from ...bodies.force_series.layout import layout
from ...bodies.motion import Given
from .body import Balls, Body, Forms, at_end, balls, laws, real, solved, statements
from .pieces import Piece, around, moments


def residual(given: Given, times: Any, R: Any) -> None:
    """Fill R with the residuals of events and of the cell's duration, as the kernel has them.

    Raises
    ------
    PrecisionError
        If poles cannot be distinguished.
    """
    cell, plan = given.cell, layout(given.cell, given.order)
    count, contacts = len(cell.phases), cell.body.at.shape[1]
    body = Body(cell, plan.poles.held)
    elements = plan.pieces.tolist()
    lengths = [times[p] / plan.phases[p].pieces for p, *_ in elements]
    forces, hits = [], []
    for p, at, last in elements:
        places_ = range((plan.phases[p].degree + 1) * contacts)
        forces.append({at + i: (i % contacts, {i // contacts: arb(1)}) for i in places_})
        hits.append([(q, k) for k, q in enumerate(plan.hits[p].tolist()) if last and q >= 0])
    pieces = around(body.poles, lengths, forces, hits, plan.size, cell.sign)
    angles = [times[count] if cell.forced else arb(0)]
    for t in lengths:
        angles.append(angles[-1] + body.omega * t)

    def values(forms: Forms, p: int, side: int) -> tuple[Balls, Balls]:
        """Return rows over the unknowns, and known parts, of forms at an end of a phase."""
        e = plan.first_of(p) + (plan.phases[p].pieces - 1 if side else 0)
        states = pieces[e].end if side else pieces[e].start
        rows, offset = at_end(forms, states, angles[e + side])
        rows[:, plan.memory] += forms.memory
        return rows, offset

    A, right = balls(np.zeros((plan.size, plan.size))), balls(np.zeros(plan.size))
    forms = [body.forms(laws(phase)) for phase in cell.phases]
    ends = [values(body.event(phase), p, 1) for p, phase in enumerate(cell.phases)]
    for e, (p, at, _) in enumerate(elements):
        rows = slice(at, at + (plan.phases[p].degree + 1) * contacts)
        drive = (acb(0, 1) * angles[e]).exp() * moments(
            acb(0, 1) * body.omega * lengths[e], plan.phases[p].degree + 1
        )
        A[rows], right[rows] = _tested(forms[p], pieces[e], drive, plan, at)
        # a multiple of the event, 0 on an orbit, makes the system regular
        (event,), (at_event,) = ends[p]
        fixing = balls(plan.phases[p].fixing / np.diag(plan.phases[p].direct))
        factors = [*(fixing * np.diag(forms[p].direct))] * min(plan.phases[p].degree + 1, 2)
        for k, factor in enumerate(factors, at):
            A[k], right[k] = A[k] + factor * event, right[k] - factor * at_event
    for index, (row, offset) in enumerate(statements(cell, body, values), plan.first_impulse):
        A[index], right[index] = -row, offset
        A[index, index] += 1
    unknowns = solved(A, right[:, None])[:, 0]
    for p, ((row,), (offset,)) in enumerate(ends):
        R[p] = row @ unknowns + offset
    if cell.forced:
        R[count] = sum(times[:count], arb(0)) - body.duration


def _tested(law: Forms, piece: Piece, drive: Balls, plan: Any, at: int) -> tuple[Balls, Balls]:
    """Return rows and right sides of the laws on a piece, tested with polynomials."""
    contacts, rows, right = len(law.poles), [], []
    for n, states in enumerate(piece.tested(len(drive))):
        row, offset = real(law.poles @ states), real(law.turn * drive[n])
        columns = slice(at + n * contacts, at + (n + 1) * contacts)
        row[:, columns] += law.direct / (2 * n + 1)
        if n == 0:
            row[:, plan.memory] += law.memory
            offset = offset + law.constant
        rows.append(row)
        right.append(-offset)
    return np.concatenate(rows), np.concatenate(right)
