"""The equations of the force series for its times: the events, and the duration of the cell.

At given times `series` solves a linear system for all else.  Newton's method has the durations
and the phase of the forcing as its only unknowns.  Plain Python, or compiled.
"""

from typing import Any

import numpy as np

from ...arrays import Complex, Matrix, Vector
from .integrals import moment_rates, rates_by_moments, response_rates
from .series import linear, signed, solved

#: Replaces `iteration.FAST`: no correction is simplified, as residuals come with a Jacobian.
FAST = 0.0


def times_of(case: Any) -> tuple[int, int]:
    """Return the number of unknown durations, and of unknown phases of the forcing: 1 or 0."""
    return len(case.counts), 1 if case.numbers[2] > 0 else 0


def residual(case: Any, times: Vector, R: Vector) -> None:
    """Fill R with the events and the duration of the cell, at given times.

    The Jacobian costs less than the residual, and is kept in `case.evaluated` for `jacobian`.
    """
    system, count = linear(case, times), len(case.degrees)
    _, _, (_, unknowns), (events, constants), _ = system
    R[:count] = events @ unknowns + constants
    if case.numbers[2] > 0:
        R[count] = times[:count].sum() - case.numbers[2]
    slopes(case, times, system, case.evaluated[1:])
    case.evaluated[0] = times


def jacobian(case: Any, times: Vector, J: Matrix) -> None:
    """Fill J with the Jacobian of the residual, kept from the residual at the same times."""
    if not (case.evaluated[0] == times).all():
        residual(case, times, np.empty(len(times)))
    J[:] = case.evaluated[1:]


def moved(case: Any, row: int, states: Complex, angle: float, turns: Vector) -> Vector:
    """Return the derivatives of a form by the times, at fixed unknowns.

    From those of the poles' `states`, and of the `angle` of the forcing (`turns`).
    """
    wave = (1j * case.turns[row] * np.exp(1j * angle)).real
    derivatives: Vector = (states @ case.forms[row]).real + wave * turns
    return derivatives


def slopes(case: Any, times: Vector, system: Any, J: Matrix) -> None:
    """Fill J with the Jacobian of the residual; `system` is the result of `linear`."""
    begins, (grown, a, Z, turn), (A, unknowns), (events, _), (carry, starts) = system
    count, contacts, width = len(case.degrees), len(case.b), len(times)
    omega, s, first = case.numbers[0], case.s, count * (contacts + 1)
    angles_by = np.zeros((len(begins), width))  # derivatives of the angles by the times
    angles_by[:, count:] = 1.0
    begun = np.empty((len(starts), len(s)), np.complex128)
    starts_by = np.zeros((len(starts), width, len(s)), np.complex128)
    ends_by = np.zeros_like(starts_by)
    for f in range(len(starts)):
        p = case.pieces[f, 0]
        angles_by[f + 1] = angles_by[f]
        angles_by[f + 1, p] += omega / case.counts[p]
        begun[f] = unknowns.astype(np.complex128) @ starts[f]
        ends_by[f, p] = ended(case, times, f, unknowns, a[p]) + s * grown[p] * begun[f]
        ends_by[f, p] /= case.counts[p]
        for e in range(len(starts)):
            starts_by[e, p] += carry[e, f] * ends_by[f, p]
    by, shifted = np.zeros((len(A), width)), np.zeros((count, width))
    for e in range(len(starts)):
        p = case.pieces[e, 0]
        ends_by[e] += grown[p] * starts_by[e]
        if case.pieces[e, 2]:
            row = count * contacts + p
            shifted[p] = moved(case, row, ends_by[e], begins[e + 1], angles_by[e + 1])
    for e in range(len(starts)):
        p, at, last = case.pieces[e]
        share, degrees, wave = 1.0 / case.counts[p], case.degrees[p] + 1, np.exp(1j * begins[e])
        turn_rates = moment_rates(turn[p, : degrees + 1].reshape(-1, 1))[:, 0]
        for k in range(contacts):
            row = p * contacts + k
            law = case.forms[row]
            rows = ((a[p, :degrees] * law) @ starts_by[e].T).real
            waves = 1j * case.turns[row] * wave * turn[p, :degrees]
            rows += waves.real.copy().reshape(-1, 1) * angles_by[e]
            grows = a[p, : degrees + 1] @ (law * s * begun[e])
            rows[:, p] += share * moment_rates(grows.reshape(-1, 1))[:, 0].real
            rows[:, p] += share * (1j * omega * case.turns[row] * wave * turn_rates).real
            for c in range(contacts if degrees > 1 else 0):
                l = unknowns[at + c : at + degrees * contacts : contacts].copy()
                rows[:, p] += share * (Z[p, 0, k, c, :degrees, :degrees].copy() @ l)
                rows[:, p] += share * response_rates(Z[p, 1, k, c], l)
            by[at + k : at + degrees * contacts : contacts] = rows
            by[at + k : at + min(degrees, 2) * contacts : contacts] += (
                case.fixing[p, k] * shifted[p]
            )
        for k in range(contacts if last else 0):
            q = case.hits[p, k]
            for c in range(contacts if q >= 0 else 0):
                velocity = moved(case, first + c, ends_by[e], begins[e + 1], angles_by[e + 1])
                by[q] -= case.impulse[p, k, c] * velocity
    for i in range(len(case.sets)):
        e = case.sets[i]
        by[case.size[1] + i] = -moved(
            case, first + contacts + i, starts_by[e], begins[e], angles_by[e]
        )
    J[:count] = shifted - events @ solved(A, by)
    if case.numbers[2] > 0:
        J[count] = 0.0
        J[count, :count] = 1.0


def ended(case: Any, times: Vector, e: int, unknowns: Vector, a: Complex) -> Complex:
    """Return the derivative, by the duration s of a piece, of the part of z by its forces.

    ``d(s a_n(kappa))/ds = a_n + kappa a_n'`` with kappa = s_k s, times the forces and b.
    """
    p, at, contacts = case.pieces[e, 0], case.pieces[e, 1], len(case.b)
    degrees = case.degrees[p] + 1
    derivative: Complex = np.zeros_like(case.s)
    kappa = case.s * (times[p] / case.counts[p])
    for c in range(contacts):
        l = signed(unknowns[at + c : at + degrees * contacts : contacts])
        rates = rates_by_moments(l).astype(np.complex128) @ a[: degrees + 1]
        derivative += case.b[c] * (l.astype(np.complex128) @ a[:degrees] + kappa * rates)
    return derivative
