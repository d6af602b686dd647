"""The force series: contact forces in Legendre polynomials, the body by its poles.

On a phase, or a piece of it, ``lam = sum l_n P_n*(u)``, and the law is tested with the same
polynomials.  Where the law gives the force, one constant is exact.  At given times forces,
impulses and memory solve one linear system, whose size does not depend on the number of modes;
`events` has the equations for the times.

Linear forms are ``Re sum forms z + Re(turns e^(i theta)) + rest``, the last by 1 and the
memory.  A case is a `layout.Setting`.  Plain Python, or compiled.
"""

from typing import Any

import numpy as np

from ...arrays import Complex, Matrix, Vector
from .integrals import factors, moments, responses, whole


def begins_of(case: Any, times: Vector) -> Vector:
    """Return the angle of the forcing where each piece begins, and where the last ends."""
    angles = np.empty(len(case.pieces) + 1)
    angles[0] = times[len(times) - 1] if case.numbers[2] > 0 else 0.0
    for e in range(len(case.pieces)):
        p = case.pieces[e, 0]
        angles[e + 1] = angles[e] + case.numbers[0] * times[p] / case.counts[p]
    return angles


def integrals(case: Any, times: Vector) -> tuple[Complex, Complex, Any, Complex]:
    """Return the integrals of poles and forcing over one piece of each phase.

    Returns
    -------
    grown : ndarray of complex, shape (P, m)
        ``e^kappa`` of the poles.
    a : ndarray of complex, shape (P, degrees, m)
        ``a_n`` of the poles, up to two degrees above that of the force.
    Z : ndarray, shape (P, 2, c, c, degrees, degrees)
        ``Re sum law b Z_mn`` over the poles, by the contacts of law and force, and
        ``Re sum kappa law b Z_mn``; up to one degree above that of the force.  Zero where the
        law gives the force.
    turn : ndarray of complex, shape (P, degrees)
        ``a_n(i omega s)`` of the forcing, s the duration of a piece.
    """
    count, size, contacts = len(case.degrees), len(case.s), len(case.b)
    most = case.degrees.max() + 2
    grown = np.empty((count, size), np.complex128)
    a = np.zeros((count, most + 1, size), np.complex128)
    Z = np.zeros((count, 2, contacts, contacts, most, most))
    turn = np.zeros((count, most), np.complex128)
    for p in range(count):
        s, n = times[p] / case.counts[p], case.degrees[p] + 2
        kappa = case.s * s
        pole_factors = factors(kappa, n)
        grown[p], a[p, : n + 1] = np.exp(kappa), whole(pole_factors)
        turn[p, :n] = moments(np.full(1, 1j * case.numbers[0] * s), n)[:, 0]
        if case.degrees[p] > 0:
            weighted = responses(pole_factors, seen_by(case, p, kappa))
            Z[p, :, :, :, :n, :n] = weighted.reshape(2, contacts, contacts, n, n)
    return grown, a, Z, turn


def seen_by(case: Any, p: int, kappa: Complex) -> Complex:
    """Return ``law b`` and ``kappa law b`` of the poles in a phase; shape (m, 2 c c)."""
    contacts = len(case.b)
    weights = np.empty((len(kappa), 2 * contacts * contacts), np.complex128)
    for k in range(contacts):
        for c in range(contacts):
            weights[:, k * contacts + c] = case.forms[p * contacts + k] * case.b[c]
            weights[:, (contacts + k) * contacts + c] = weights[:, k * contacts + c] * kappa
    return weights


def carried(case: Any, grown: Complex) -> Any:
    """Return z at the start of piece e for unit impulses (with sign) at each end of piece f.

    Shape (E, E, m); `grown` is ``e^kappa`` of a piece of each phase.
    """
    count, sign = len(case.pieces), case.numbers[1]
    starts = np.empty((count, count, grown.shape[1]), np.complex128)
    for f in range(count):
        factor = np.ones_like(grown[0])
        for j in range(1, count + 1):
            e = (f + j) % count
            if e == 0:
                factor = sign * factor
            starts[e, f] = factor
            factor = factor * grown[case.pieces[e, 0]]
        starts[:, f] /= 1 - factor
    return starts


def signed(values: Any) -> Any:
    """Return ``(-1)^n`` times the values of degree n."""
    alternating = values.copy()
    alternating[1::2] *= -1
    return alternating


def states(case: Any, times: Vector, grown: Complex, a: Complex) -> Any:
    """Return `carried`, and z at the start and the end of each piece, by the unknowns.

    Shapes (E, E, m), and (E, U, m) twice.
    """
    count, contacts = len(case.pieces), len(case.b)
    carry = carried(case, grown)
    starts = np.zeros((count, case.size[0], len(case.s)), np.complex128)
    ends = np.empty_like(starts)
    for f in range(count):
        p, at, last = case.pieces[f]
        gain = times[p] / case.counts[p] * signed(a[p, : case.degrees[p] + 1])
        for e in range(count):
            for k in range(contacts):
                by = carry[e, f] * case.b[k]
                for n in range(len(gain)):
                    starts[e, at + n * contacts + k] = by * gain[n]
                if last and case.hits[p, k] >= 0:
                    starts[e, case.hits[p, k]] = by
    for e in range(count):
        p, at, _ = case.pieces[e]
        gain = times[p] / case.counts[p] * signed(a[p, : case.degrees[p] + 1])
        ends[e] = grown[p] * starts[e]
        for n in range(len(gain)):
            for k in range(contacts):
                ends[e, at + n * contacts + k] += gain[n] * case.b[k]
    return carry, starts, ends


def value(case: Any, row: int, states: Complex, angle: float) -> tuple[Vector, float]:
    """Return a form as factors of the unknowns and a constant."""
    coefficients: Vector = (states @ case.forms[row]).real
    coefficients[case.size[1] :] += case.rest[row, 1:]
    return coefficients, (case.turns[row] * np.exp(1j * angle)).real + case.rest[row, 0]


def solved(A: Matrix, right: Matrix) -> Matrix:
    """Return the solution of a linear system; NaN if it is singular."""
    solution = np.full(right.shape, np.nan)
    try:
        solution[:] = np.linalg.solve(A, right)
    except Exception:  # a LinAlgError: numba knows no kinds
        solution[:] = np.nan
    return solution


def tested(
    case: Any, e: int, a: Complex, Z: Any, turn: Complex, states: Complex, begins: Vector,
    s: float, event: Vector, constant: float, A: Matrix, right: Vector,
) -> None:  # fmt: skip
    """Fill in the laws of piece e, tested with its polynomials.

    `event` and `constant` are the event that ends its phase, which `fixing` adds.
    """
    p, at, contacts = case.pieces[e, 0], case.pieces[e, 1], len(case.b)
    count = case.degrees[p] + 1
    wave = np.exp(1j * begins[e])
    for k in range(contacts):
        row = p * contacts + k
        law = case.forms[row]
        rows = ((a[p, :count] * law) @ states.T).real
        rows[0, case.size[1] :] += case.rest[row, 1:]
        for c in range(contacts):
            if count > 1:
                block = s * Z[p, 0, k, c, :count, :count]
                rows[:, at + c : at + count * contacts : contacts] += block
            for n in range(count):
                rows[n, at + n * contacts + c] += case.direct[p, k, c] / (2 * n + 1)
        A[at + k : at + count * contacts : contacts] = rows
        right[at + k : at + count * contacts : contacts] = -(
            case.turns[row] * wave * turn[p, :count]
        ).real
        right[at + k] -= case.rest[row, 0]
        for q in range(at + k, at + min(count, 2) * contacts, contacts):  # see `layout._fixing`
            A[q] += case.fixing[p, k] * event
            right[q] -= case.fixing[p, k] * constant


def linear(case: Any, times: Vector) -> Any:
    """Set up and solve the linear system at given times.

    Returns the angles where pieces begin; `integrals`; the matrix of the system and its
    solution; the events as factors of the unknowns and constants; the first two of `states`.
    """
    begins, (grown, a, Z, turn) = begins_of(case, times), integrals(case, times)
    carry, starts, ends = states(case, times, grown, a)
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
    return begins, (grown, a, Z, turn), (A, unknowns), (events, constants), (carry, starts)
