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
from .integrals import answered, moment_rates, moments, responses


def begins_of(case: Any, times: Vector) -> Vector:
    """Return the angle of the forcing where each piece begins, and where the last ends."""
    found = np.empty(len(case.pieces) + 1)
    found[0] = times[len(times) - 1] if case.numbers[2] > 0 else 0.0
    for e in range(len(case.pieces)):
        p = case.pieces[e, 0]
        found[e + 1] = found[e] + case.numbers[0] * times[p] / case.counts[p]
    return found


def integrals(case: Any, times: Vector) -> tuple[Complex, Any, Complex]:
    """Return ``a_n`` and ``Z_mn`` of the poles in each phase, and ``a_n`` of the forcing.

    Of as many degrees as its force has, and one more; ``Z_mn`` where the force is unknown.
    """
    count, size, room = len(case.degrees), len(case.s), case.degrees.max() + 2
    a = np.zeros((count, room, size), np.complex128)
    Z = np.zeros((count, room, room, size), np.complex128)
    turn = np.zeros((count, room), np.complex128)
    for p in range(count):
        s, own = times[p] / case.counts[p], case.degrees[p] + 2
        a[p, :own] = moments(case.s * s, own)
        turn[p, :own] = moments(np.full(1, 1j * case.numbers[0] * s), own)[:, 0]
        if case.degrees[p] > 0:
            Z[p, :own, :own] = responses(case.s * s, own, own)
    return a, Z, turn


def around(
    case: Any, times: Vector, within: Complex, behind: Complex
) -> tuple[Complex, Complex]:
    """Return what is carried by the poles where each piece begins and ends, periodic.

    Parameters
    ----------
    within, behind : ndarray of complex, shape (E, m, columns)
        What each piece adds to z, or to its derivatives, where it ends, and behind that.
    """
    starts, ends = np.empty_like(within), np.empty_like(within)
    state, total, sign = np.zeros_like(within[0]), 0.0, case.numbers[1]
    for turn in range(2):
        for e in range(len(within)):
            p = case.pieces[e, 0]
            s = times[p] / case.counts[p]
            starts[e] = state
            state = np.exp(case.s * s).reshape(-1, 1) * state + within[e]
            ends[e] = state
            state = state + behind[e]
            total += s
        if turn == 0:
            state = sign * state / (1 - sign * np.exp(case.s * total)).reshape(-1, 1)
    return starts, ends


def alternating(values: Complex) -> Complex:
    """Return values by degree, those of the odd ones with the other sign."""
    found = values.copy()
    found[1::2] *= -1
    return found


def states(case: Any, times: Vector, a: Complex) -> tuple[Complex, Complex]:
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
    return around(case, times, within, behind)


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
            weights = law * case.b[c]
            for n in range(count):
                if count > 1:
                    own = (Z[p, n, :count] @ weights).real
                    rows[n, at + c : at + count * contacts : contacts] += s * own
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
    begins, (a, Z, turn) = begins_of(case, times), integrals(case, times)
    starts, ends = states(case, times, a)
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
    return begins, (a, Z, turn), (A, unknowns), (events, constants), (starts, ends)


def residual(case: Any, times: Vector, R: Vector) -> None:
    """Fill R with the events and the length of the cell, at times alone."""
    _, _, (_, unknowns), (events, constants), _ = linear(case, times)
    count = len(constants)
    R[:count] = events @ unknowns + constants
    if case.numbers[2] > 0:
        R[count] = times[:count].sum() - case.numbers[2]


def moved(case: Any, row: int, states: Complex, angle: float, turns: Vector) -> Vector:
    """Return the derivatives of a form by the times, the unknowns held."""
    wave = (1j * case.turns[row] * np.exp(1j * angle)).real
    found: Vector = (case.forms[row] @ states).real + wave * turns
    return found


def jacobian(case: Any, times: Vector, J: Matrix) -> None:
    """Fill J with the derivatives of the residual."""
    begins, (a, Z, turn), (A, unknowns), (events, _), (starts, _) = linear(case, times)
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
        forces = np.zeros((degrees, len(s)), np.complex128)
        for n in range(degrees):
            for k in range(contacts):
                forces[n] += unknowns[at + n * contacts + k] * case.b[k]
        kappa, rates = s * (times[p] * part), moment_rates(a[p, : degrees + 1])
        gain = (alternating(a[p, :degrees] + kappa * rates) * forces).sum(axis=0)
        within[e, :, p] = part * (s * np.exp(kappa) * begun[e] + gain)
        own[e, :degrees] = s * rates * begun[e]
        if degrees > 1:
            known, known_rates = answered(Z[p, : degrees + 1, : degrees + 1], forces)
            own[e, :degrees] += known + kappa * known_rates
    starts_by, ends_by = around(case, times, within, np.zeros_like(within))
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
