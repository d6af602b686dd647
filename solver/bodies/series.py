"""The force series: contact forces in Legendre polynomials, the body by its poles.

``lam = sum l_n P_n*(u)`` on each phase in which the law leaves the force unknown, the law
tested with the same polynomials; where the force is given, one constant is exact.  At given
times forces, impulses and memory are one linear system, and Newton's method sees the durations
and the phase of the forcing alone.  Neither depends on the number of modes.

Linear forms of what is seen are ``Re sum forms z + Re(turns e^(i theta)) + rest``, rest by 1
and the memory; the rows of a case are those of `layout.Setting`.  Plain Python, or compiled.
"""

from typing import Any

import numpy as np

from ..arrays import Complex, Matrix, Vector
from .integrals import answered, moment_rates, moments, respond

#: No correction is taken with the derivatives of the one before: they come with the residual.
FAST = 0.0


def times_of(case: Any) -> tuple[int, int]:
    """Return how many durations are unknown, and 1 if the phase of the forcing is, else 0."""
    return len(case.counts), 1 if case.numbers[2] > 0 else 0


def begins_of(case: Any, times: Vector) -> Vector:
    """Return the angle of the forcing where each piece begins, and where the last ends."""
    found = np.empty(len(case.pieces) + 1)
    found[0] = times[len(times) - 1] if case.numbers[2] > 0 else 0.0
    for e in range(len(case.pieces)):
        p = case.pieces[e, 0]
        found[e + 1] = found[e] + case.numbers[0] * times[p] / case.counts[p]
    return found


def integrals(case: Any, times: Vector) -> tuple[Complex, Complex, Any, Complex]:
    """Return ``e^kappa``, ``a_n`` and ``Z_mn`` of the poles, and ``a_n`` of the forcing.

    Of each phase, of as many degrees as its force has, and one more; ``Z_mn`` where the force
    is unknown.  Shapes (P, m), (P, degrees, m), (P, m, degrees, degrees) and (P, degrees).
    """
    count, size, room = len(case.degrees), len(case.s), case.degrees.max() + 2
    a = np.zeros((count, room, size), np.complex128)
    Z = np.empty((count, size, room, room), np.complex128)
    turn, grown = np.zeros((count, room), np.complex128), np.empty_like(a[:, 0])
    for p in range(count):
        s, own = times[p] / case.counts[p], case.degrees[p] + 2
        grown[p] = np.exp(case.s * s)
        a[p, :own] = moments(case.s * s, own)
        turn[p, :own] = moments(np.full(1, 1j * case.numbers[0] * s), own)[:, 0]
        if case.degrees[p] > 0:
            respond(case.s * s, Z[p])
    return grown, a, Z, turn


def around(
    case: Any, grown: Complex, within: Complex, behind: Complex
) -> tuple[Complex, Complex]:
    """Return what is carried by the poles where each piece begins and ends, periodic.

    Parameters
    ----------
    grown : ndarray of complex, shape (P, m)
        ``e^kappa`` of a piece of each phase.
    within, behind : ndarray of complex, shape (E, m, columns)
        What each piece adds to z, or to its derivatives, where it ends, and behind that.
    """
    starts, ends = np.empty_like(within), np.empty_like(within)
    state, whole, sign = np.zeros_like(within[0]), np.ones_like(grown[0]), case.numbers[1]
    for turn in range(2):
        for e in range(len(within)):
            p = case.pieces[e, 0]
            starts[e] = state
            state = grown[p].copy().reshape(-1, 1) * state + within[e]
            ends[e] = state
            state = state + behind[e]
            whole *= grown[p]
        if turn == 0:
            state = (sign / (1 - sign * whole)).reshape(-1, 1) * state
    return starts, ends


def alternating(values: Complex) -> Complex:
    """Return values by degree, those of the odd ones with the other sign."""
    found = values.copy()
    found[1::2] *= -1
    return found


def states(case: Any, times: Vector, grown: Complex, a: Complex) -> tuple[Complex, Complex]:
    """Return z where each piece begins and ends, by the unknowns: shape (E, m, U) each."""
    within = np.zeros((len(case.pieces), len(case.s), case.size[0]), np.complex128)
    behind, contacts = np.zeros_like(within), len(case.b)
    for e in range(len(within)):
        p, at, last = case.pieces[e]
        gain = times[p] / case.counts[p] * alternating(a[p, : case.degrees[p] + 1])
        for n in range(len(gain)):
            for k in range(contacts):
                within[e, :, at + n * contacts + k] = gain[n] * case.b[k]
        for k in range(contacts if last else 0):
            if case.hits[p, k] >= 0:
                behind[e, :, case.hits[p, k]] = case.b[k]
    return around(case, grown, within, behind)


def value(case: Any, row: int, states: Complex, angle: float) -> tuple[Vector, float]:
    """Return a form by the unknowns: factors and constant."""
    found: Vector = (case.forms[row] @ states).real
    found[case.size[1] :] += case.rest[row, 1:]
    return found, (case.turns[row] * np.exp(1j * angle)).real + case.rest[row, 0]


def solved(A: Matrix, right: Matrix) -> Matrix:
    """Return the solution of a linear system; not numbers where there is none."""
    found = np.full(right.shape, np.nan)
    try:
        found[:] = np.linalg.solve(A, right)
    except Exception:  # a LinAlgError: numba knows no kinds
        found[:] = np.nan
    return found


def tested(
    case: Any, e: int, a: Complex, Z: Any, turn: Complex, states: Complex, begins: Vector,
    s: float, event: Vector, constant: float, A: Matrix, right: Vector,
) -> None:  # fmt: skip
    """Fill in the laws of a piece, tested with the polynomials; the event ends its phase."""
    p, at, contacts = case.pieces[e, 0], case.pieces[e, 1], len(case.b)
    count = case.degrees[p] + 1
    wave = np.exp(1j * begins[e])
    for k in range(contacts):
        row = p * contacts + k
        law = case.forms[row]
        rows = ((a[p, :count] * law) @ states).real
        rows[0, case.size[1] :] += case.rest[row, 1:]
        for c in range(contacts):
            if count > 1:
                own = (law * case.b[c]) @ Z[p].reshape(len(law), -1)
                own_rows = own.real.copy().reshape(Z.shape[2], -1)[:count, :count]
                rows[:, at + c : at + count * contacts : contacts] += s * own_rows
            for n in range(count):
                rows[n, at + n * contacts + c] += case.direct[p, k, c] / (2 * n + 1)
        A[at + k : at + count * contacts : contacts] = rows
        right[at + k : at + count * contacts : contacts] = -(
            case.turns[row] * wave * turn[p, :count]
        ).real
        right[at + k] -= case.rest[row, 0]
        A[at + k] += case.fixing[p, k] * event
        right[at + k] -= case.fixing[p, k] * constant


def linear(case: Any, times: Vector) -> Any:
    """Return all that holds at given times.

    The angles where pieces begin; the integrals; the system, and its solution; the events by
    the unknowns, factors and constants; z where pieces begin and end, by the unknowns.
    """
    begins, (grown, a, Z, turn) = begins_of(case, times), integrals(case, times)
    starts, ends = states(case, times, grown, a)
    count, contacts, (size, memory) = len(case.degrees), len(case.b), case.size
    A, right = np.zeros((size, size)), np.zeros(size)
    events, constants = np.zeros((count, size)), np.zeros(count)
    first = count * (contacts + 1)  # of the rows of velocities
    for e in range(len(case.pieces)):
        p = case.pieces[e, 0]
        if case.pieces[e, 2]:
            row = count * contacts + p
            events[p], constants[p] = value(case, row, ends[e], begins[e + 1])
    for e in range(len(case.pieces)):
        p = case.pieces[e, 0]
        s = times[p] / case.counts[p]
        tested(case, e, a, Z, turn, starts[e], begins, s, events[p], constants[p], A, right)
        if case.pieces[e, 2] == 0:
            continue
        for k in range(contacts):
            q = case.hits[p, k]
            if q < 0:
                continue
            A[q, q] += 1.0
            right[q] += case.impulse[p, k, contacts]
            for c in range(contacts):
                factors, constant = value(case, first + c, ends[e], begins[e + 1])
                A[q] -= case.impulse[p, k, c] * factors
                right[q] += case.impulse[p, k, c] * constant
    for i in range(len(case.sets)):
        e, q = case.sets[i], memory + i
        factors, constant = value(case, first + contacts + i, starts[e], begins[e])
        A[q] = -factors
        A[q, q] += 1.0
        right[q] = constant
    unknowns = solved(A, right)
    return begins, (grown, a, Z, turn), (A, unknowns), (events, constants), (starts, ends)


def residual(case: Any, times: Vector, R: Vector) -> None:
    """Fill R with the events and the length of the cell, at times alone.

    Derivatives take less than that: `jacobian` finds them where they are kept.
    """
    found, count = linear(case, times), len(case.degrees)
    _, _, (_, unknowns), (events, constants), _ = found
    R[:count] = events @ unknowns + constants
    if case.numbers[2] > 0:
        R[count] = times[:count].sum() - case.numbers[2]
    slopes(case, times, found, case.kept[1:])
    case.kept[0] = times


def jacobian(case: Any, times: Vector, J: Matrix) -> None:
    """Fill J with the derivatives of the residual."""
    if not (case.kept[0] == times).all():
        residual(case, times, np.empty(len(times)))
    J[:] = case.kept[1:]


def moved(case: Any, row: int, states: Complex, angle: float, turns: Vector) -> Vector:
    """Return the derivatives of a form by the times, the unknowns held."""
    wave = (1j * case.turns[row] * np.exp(1j * angle)).real
    found: Vector = (case.forms[row] @ states).real + wave * turns
    return found


def slopes(case: Any, times: Vector, found: Any, J: Matrix) -> None:
    """Fill J with the derivatives of the residual, by what `linear` found."""
    begins, (grown, a, Z, turn), (A, unknowns), (events, _), (starts, _) = found
    count, contacts, width = len(case.degrees), len(case.b), len(times)
    omega, s, first = case.numbers[0], case.s, count * (contacts + 1)
    turns = np.zeros((len(begins), width))  # of the angles by the times
    turns[:, count:] = 1.0
    within = np.zeros((len(starts), len(s), width), np.complex128)
    begun = np.zeros((len(starts), len(s)), np.complex128)
    own = np.zeros((len(starts), case.degrees.max() + 1, len(s)), np.complex128)
    for e in range(len(starts)):
        p, at, _ = case.pieces[e]
        part, degrees = 1.0 / case.counts[p], case.degrees[p] + 1
        turns[e + 1] = turns[e]
        turns[e + 1, p] += omega * part
        begun[e] = starts[e] @ unknowns.astype(np.complex128)
        l = unknowns[at : at + degrees * contacts].reshape(degrees, contacts) + 0j
        kappa, rates = s * (times[p] * part), moment_rates(a[p, : degrees + 1])
        forces = l @ case.b
        gain = (alternating(a[p, :degrees] + kappa * rates) * forces).sum(axis=0)
        within[e, :, p] = part * (s * grown[p] * begun[e] + gain)
        own[e, :degrees] = s * rates * begun[e]
        if degrees > 1:
            known, known_rates = answered(Z[p], l, case.b)
            own[e, :degrees] += known.T + kappa * known_rates.T
    starts_by, ends_by = around(case, grown, within, np.zeros_like(within))
    by, shifted = np.zeros((len(A), width)), np.zeros((count, width))
    for e in range(len(starts)):
        p = case.pieces[e, 0]
        if case.pieces[e, 2]:
            row = count * contacts + p
            shifted[p] = moved(case, row, ends_by[e], begins[e + 1], turns[e + 1])
    for e in range(len(starts)):
        p, at, last = case.pieces[e]
        part, degrees, wave = 1.0 / case.counts[p], case.degrees[p] + 1, np.exp(1j * begins[e])
        turn_rates = moment_rates(turn[p, : degrees + 1].reshape(-1, 1))[:, 0]
        for k in range(contacts):
            row = p * contacts + k
            law = case.forms[row]
            rows = ((a[p, :degrees] * law) @ starts_by[e]).real
            waves = 1j * case.turns[row] * wave * turn[p, :degrees]
            rows += waves.real.copy().reshape(-1, 1) * turns[e]
            rows[:, p] += part * (own[e, :degrees] @ law).real
            rows[:, p] += part * (1j * omega * case.turns[row] * wave * turn_rates).real
            by[at + k : at + degrees * contacts : contacts] = rows
            by[at + k] += case.fixing[p, k] * shifted[p]
        for k in range(contacts if last else 0):
            q = case.hits[p, k]
            for c in range(contacts if q >= 0 else 0):
                velocity = moved(case, first + c, ends_by[e], begins[e + 1], turns[e + 1])
                by[q] -= case.impulse[p, k, c] * velocity
    for i in range(len(case.sets)):
        e = case.sets[i]
        by[case.size[1] + i] = -moved(
            case, first + contacts + i, starts_by[e], begins[e], turns[e]
        )
    J[:count] = shifted - events @ solved(A, by)
    if case.numbers[2] > 0:
        J[count] = 0.0
        J[count, :count] = 1.0
