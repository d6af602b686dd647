"""The force series of a body in balls: the laws tested with Legendre polynomials."""

from typing import Any

import numpy as np
from flint import acb, arb

from ...bodies.laws import places
from ...bodies.layout import layout
from ...kernels.bodies import Given
from .body import Balls, Body, Forms, balls, closed, impulses, laws, solved, value
from .pieces import Piece, around, moments


def residual(given: Given, times: Any, R: Any) -> None:
    """Fill R with the events and the length of the cell, as ``solver.bodies.series`` has them.

    Raises
    ------
    PrecisionError
        If poles are not told apart.
    """
    cell, own = given.cell, layout(given.cell, given.order)
    count, contacts = len(cell.phases), cell.body.at.shape[1]
    body = Body.of(cell, own.poles.held)
    lengths = [times[p] / own.phases[p].pieces for p, _ in own.elements]
    forces, hits = [], []
    for e, (p, at) in enumerate(own.elements):
        places_ = range((own.phases[p].degree + 1) * contacts)
        forces.append({at + i: (i % contacts, {i // contacts: arb(1)}) for i in places_})
        columns = range(own.size)[own.impulses(p)] if own.is_last(e) else ()
        hits.append(list(zip(columns, map(int, own.phases[p].hit), strict=False)))
    pieces = around(body.poles, lengths, forces, hits, own.size, cell.sign)
    angles = [times[count] if cell.forced else arb(0)]
    for t in lengths:
        angles.append(angles[-1] + body.omega * t)
    A, right = balls(np.zeros((own.size, own.size))), balls(np.zeros(own.size))
    events, at_events = balls(np.zeros((count, own.size))), balls(np.zeros(count))
    forms = [body.forms(laws(phase)) for phase in cell.phases]
    for e, (p, at) in enumerate(own.elements):
        law = forms[p]
        rows = slice(at, at + (own.phases[p].degree + 1) * contacts)
        drive = (acb(0, 1) * angles[e]).exp() * moments(
            acb(0, 1) * body.omega * lengths[e], own.phases[p].degree + 1
        )
        A[rows], right[rows] = _tested(law, pieces[e], drive, own, at)
        if own.is_last(e):
            event = closed(body.forms(balls([cell.phases[p].event])), law)
            events[p], at_events[p] = seen(event, 0, pieces[e].end, angles[e + 1])
            place = own.impulses(p)
            A[place, place], *rest = impulses(cell, p)[1:]
            velocity = body.forms(balls(np.eye(2 + 4 * contacts + len(cell.memory))))
            for q, c, factor, constant in zip(
                range(own.size)[place], own.phases[p].hit, *rest, strict=True
            ):
                v, known = seen(velocity, places(contacts)[1][c], pieces[e].end, angles[e + 1])
                A[q], right[q] = A[q] - factor * v, factor * known + constant
    for p, at in own.elements:  # what is 0 on an orbit, and says where it is
        fixing = balls(own.phases[p].fixing / np.diag(own.phases[p].direct))
        for k, factor in enumerate(fixing * np.diag(forms[p].direct)):
            A[at + k] = A[at + k] + factor * events[p]
            right[at + k] = right[at + k] - factor * at_events[p]
    for i, each in enumerate(cell.memory):
        e, q = own.first_of(each.phase), own.first_memory + i
        form = balls([[*each.value[: 2 + 4 * contacts], *([0.0] * len(cell.memory))]])
        factors, right[q] = seen(body.forms(form), 0, pieces[e].start, angles[e])
        A[q] = -factors
        A[q, q] = A[q, q] + 1
    unknowns = solved(A, right[:, None])[:, 0]
    R[:count] = events @ unknowns + at_events
    if cell.forced:
        R[count] = sum(times[:count], arb(0)) - body.duration(cell)


def seen(forms: Forms, k: int, states: Balls, angle: Any) -> tuple[Balls, Any]:
    """Return one of some forms, without its forces, by the unknowns: factors and constant."""
    factors, known = value((forms.poles[k], forms.turn[k], forms.constant[k]), states, angle)
    count = forms.memory.shape[1]
    factors[len(factors) - count :] = factors[len(factors) - count :] + forms.memory[k]
    return factors, known


def _tested(law: Forms, piece: Piece, drive: Balls, own: Any, at: int) -> tuple[Balls, Balls]:
    """Return the rows of the laws on a piece, tested, and what they are equal to."""
    contacts, rows, right = len(law.poles), [], []
    for n, states in enumerate(piece.tested(len(drive))):
        for k in range(contacts):
            row = np.array([acb(q).real for q in law.poles[k] @ states], dtype=object)
            here = slice(at + n * contacts, at + (n + 1) * contacts)
            row[here] = row[here] + law.direct[k] / (2 * n + 1)
            known = (acb(law.turn[k]) * drive[n]).real
            if n == 0:
                row[own.first_memory :] = row[own.first_memory :] + law.memory[k]
                known = known + law.constant[k]
            rows.append(row)
            right.append(-known)
    return np.array(rows, dtype=object), np.array(right, dtype=object)
