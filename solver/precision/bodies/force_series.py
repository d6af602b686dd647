"""The force series of a body in balls: Galerkin projection of the laws onto polynomials."""

from typing import Any

import numpy as np
from flint import acb, arb

from ...bodies.force_series.layout import layout
from ...kernels.bodies import Given
from .body import Balls, Body, Forms, at_end, balls, laws, real, solved, statements
from .pieces import Piece, around, moments


def residual(given: Given, times: Any, R: Any) -> None:
    """Fill R with the residuals of events and of the cell's duration, as the kernel has them.

    Raises
    ------
    PrecisionError
        If poles cannot be distinguished.
    """
    cell, own = given.cell, layout(given.cell, given.order)
    count, contacts = len(cell.phases), cell.body.at.shape[1]
    body = Body(cell, own.poles.held)
    elements = own.pieces.tolist()
    lengths = [times[p] / own.phases[p].pieces for p, *_ in elements]
    forces, hits = [], []
    for p, at, last in elements:
        places_ = range((own.phases[p].degree + 1) * contacts)
        forces.append({at + i: (i % contacts, {i // contacts: arb(1)}) for i in places_})
        hits.append([(q, k) for k, q in enumerate(own.hits[p].tolist()) if last and q >= 0])
    pieces = around(body.poles, lengths, forces, hits, own.size, cell.sign)
    angles = [times[count] if cell.forced else arb(0)]
    for t in lengths:
        angles.append(angles[-1] + body.omega * t)

    def values(forms: Forms, p: int, side: int) -> tuple[Balls, Balls]:
        """Return rows over the unknowns, and known parts, of forms at an end of a phase."""
        e = own.first_of(p) + (own.phases[p].pieces - 1 if side else 0)
        states = pieces[e].end if side else pieces[e].start
        rows, known = at_end(forms, states, angles[e + side])
        rows[:, own.memory] = rows[:, own.memory] + forms.memory
        return rows, known

    A, right = balls(np.zeros((own.size, own.size))), balls(np.zeros(own.size))
    forms = [body.forms(laws(phase)) for phase in cell.phases]
    ends = [values(body.event(phase), p, 1) for p, phase in enumerate(cell.phases)]
    for e, (p, at, _) in enumerate(elements):
        rows = slice(at, at + (own.phases[p].degree + 1) * contacts)
        drive = (acb(0, 1) * angles[e]).exp() * moments(
            acb(0, 1) * body.omega * lengths[e], own.phases[p].degree + 1
        )
        A[rows], right[rows] = _tested(forms[p], pieces[e], drive, own, at)
        # a multiple of the event, 0 on an orbit, makes the system regular
        (event,), (at_event,) = ends[p]
        fixing = balls(own.phases[p].fixing / np.diag(own.phases[p].direct))
        factors = [*(fixing * np.diag(forms[p].direct))] * min(own.phases[p].degree + 1, 2)
        for k, factor in enumerate(factors, at):
            A[k], right[k] = A[k] + factor * event, right[k] - factor * at_event
    for place, (row, known) in enumerate(statements(cell, body, values), own.first_impulse):
        A[place], right[place] = -row, known
        A[place, place] = A[place, place] + 1
    unknowns = solved(A, right[:, None])[:, 0]
    for p, ((row,), (known,)) in enumerate(ends):
        R[p] = row @ unknowns + known
    if cell.forced:
        R[count] = sum(times[:count], arb(0)) - body.duration


def _tested(law: Forms, piece: Piece, drive: Balls, own: Any, at: int) -> tuple[Balls, Balls]:
    """Return rows and right sides of the laws on a piece, tested with polynomials."""
    contacts, rows, right = len(law.poles), [], []
    for n, states in enumerate(piece.tested(len(drive))):
        row, known = real(law.poles @ states), real(law.turn * drive[n])
        here = slice(at + n * contacts, at + (n + 1) * contacts)
        row[:, here] = row[:, here] + law.direct / (2 * n + 1)
        if n == 0:
            row[:, own.memory] = row[:, own.memory] + law.memory
            known = known + law.constant
        rows.append(row)
        right.append(-known)
    return np.concatenate(rows), np.concatenate(right)
