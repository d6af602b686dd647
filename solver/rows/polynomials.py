"""Residual and Jacobian of a motion that is a polynomial on each phase, for any phases.

A case is arrays, as in `joints`.  The acceleration on a phase is ``sum d_n P_n*(u)`` in local
time u.
"""

import numpy as np
from numpy.polynomial import legendre

from ...generated.ck import (
    derivative_at_end,
    derivative_at_end_by_s,
    displacement_gained,
    displacement_gained_by_s,
    moment_by_kappa,
    of_moment,
    row_0,
    row_0_by_s,
    row_1,
    row_1_by_s,
    row_l,
    row_l_by_s,
    unseen,
)
from .joints import (
    BESIDE,
    CLASS,
    FREE,
    MEMORY,
    C,
    F,
    G,
    K,
    M,
    add_angle,
    fill_angles,
    joint_rates,
    joints,
)
from .moments import legendre_moments


def row(l, m, c, k, s):
    """Return Legendre coefficient l of the residual: factors of x, v, d_(l-2), ..., d_(l+2)."""
    if l == 0:
        x, v, d0, d1, d2 = row_0(m, c, k, s)
        return x, v, 0.0, 0.0, d0, d1, d2
    if l == 1:
        v, d0, d1, d2, d3 = row_1(m, c, k, s)
        return 0.0, v, 0.0, d0, d1, d2, d3
    below2, below, middle, above, above2 = row_l(l, m, c, k, s)
    return 0.0, 0.0, below2, below, middle, above, above2


def row_by_s(l, m, c, k, s):
    """Return the derivatives of `row` by the duration."""
    if l == 0:
        x, v, d0, d1, d2 = row_0_by_s(m, c, k, s)
        return x, v, 0.0, 0.0, d0, d1, d2
    if l == 1:
        v, d0, d1, d2, d3 = row_1_by_s(m, c, k, s)
        return 0.0, v, 0.0, d0, d1, d2, d3
    below2, below, middle, above, above2 = row_l_by_s(l, m, c, k, s)
    return 0.0, 0.0, below2, below, middle, above, above2


def terms(kinds, p, N):
    """Return the number of coefficients d_n of a phase: N + k, or 0 if it is held."""
    return N + kinds[p, CLASS] if kinds[p, FREE] else 0


def tests(kinds, p, N):
    """Return the number of test functions of a phase."""
    return terms(kinds, p, N) + 1 - max(1, kinds[p, CLASS]) if kinds[p, FREE] else 0


def places(kinds, N):
    """Return the index of the first unknown of each phase, and of the first after all phases.

    Those of a phase are x, v, the d_n, and the coefficients of the polynomials `unseen`.
    """
    at = np.zeros(len(kinds) + 1, dtype=np.int64)
    for p in range(len(kinds)):
        at[p + 1] = at[p] + 2 + terms(kinds, p, N) + kinds[p, BESIDE]
    return at


def size(case, N):
    """Return the number of unknowns: of the phases, memory, durations, phase of the forcing."""
    kinds, _, setting, _, cell = case[:5]
    count = len(setting) + len(kinds) + (1 if cell[2] != 0 else 0)
    for p in range(len(kinds)):
        count += 2 + terms(kinds, p, N) + kinds[p, BESIDE]
    return count


def order_of(case, z):
    """Return the order N from the number of unknowns."""
    none = size(case, 0)
    return (len(z) - none) // (size(case, 1) - none)


def workspace(kinds, N):
    """Return arrays for angles and moments of the forcing, and for `fill_states`."""
    count, most, high = len(kinds), 2, 2
    for p in range(count):
        most = max(most, terms(kinds, p, N) + kinds[p, BESIDE])
        high = max(high, kinds[p, CLASS] + 1)
    states, states_by = np.zeros((2, count, high)), np.zeros((2, count, high, 5 + most))
    return np.empty(count + 1), np.empty((2, most + 1)), states, states_by


def fill_states(case, z, at, N, states, states_by):
    """Fill `states` with `gained` and `begins` of `joints`, `states_by` with derivatives."""
    kinds, setting = case[0], case[2]
    count, high = len(kinds), states.shape[2]
    for p in range(count):
        s, number = z[at[count] + len(setting) + p], terms(kinds, p, N)
        by, by_s = displacement_gained(s), displacement_gained_by_s(s)
        for i in range(1 + min(2, number)):
            states[0, p, 0] += by[i] * z[at[p] + 1 + i]
            states_by[0, p, 0, 0] += by_s[i] * z[at[p] + 1 + i]
            states_by[0, p, 0, 4 + i] += by[i]
        if number > 0:
            states[0, p, 1] = s * z[at[p] + 2]
            states_by[0, p, 1, 0] = z[at[p] + 2]
            states_by[0, p, 1, 5] = s
        for order in range(2, high):
            for n in range(number):
                d = z[at[p] + 2 + n]
                weight = derivative_at_end(n, order - 2, s)
                rate = derivative_at_end_by_s(n, order - 2, s)
                for side in range(2):
                    sign = -1.0 if side == 1 and (n + order) % 2 == 1 else 1.0
                    states[side, p, order] += sign * weight * d
                    states_by[side, p, order, 0] += sign * rate * d
                    states_by[side, p, order, 5 + n] = sign * weight


def residual(case, z, R):
    """Fill R with the residuals of all conditions."""
    kinds, numbers, setting, _, cell = case[:5]
    N = order_of(case, z)
    at = places(kinds, N)
    theta, moments, states, states_by = workspace(kinds, N)
    at_w, at_row = at[len(kinds)], 0
    fill_angles(case, z, at, theta)
    for p in range(len(kinds)):  # Legendre coefficients of the residual, less unseen ones
        m, c, k, f = numbers[p, M], numbers[p, C], numbers[p, K], numbers[p, F]
        number, rows, left = terms(kinds, p, N), tests(kinds, p, N), kinds[p, BESIDE]
        s = z[at_w + len(setting) + p]
        for i in range(len(setting)):
            f = f + numbers[p, MEMORY + i] * z[at_w + i]
        forced = numbers[p, G] != 0 and rows > 0
        if forced:
            legendre_moments(cell[1] * s, theta[p], moments[:, : rows + left + 1])
        for l in range(rows + left):
            factors = row(l, m, c, k, s)
            value = factors[0] * z[at[p]] + factors[1] * z[at[p] + 1]
            for i in range(max(0, 2 - l), min(5, number + 2 - l)):
                value = value + factors[2 + i] * z[at[p] + l + i]
            if l == 0:
                value = value - f
            if forced:
                value = value - of_moment(l, numbers[p, G] * moments[0, l])
            for i in range(max(0, l - rows), left):
                tau = z[at[p] + 2 + number + i]
                value = value - m * unseen(rows + i, l, kinds[p, CLASS]) * tau
            R[at_row] = value
            at_row += 1
    fill_states(case, z, at, N, states, states_by)
    joints(case, z, at, theta, states[0], states[1], R, at_row)


def jacobian(case, z, J):
    """Fill J with the derivatives of `residual` by all unknowns."""
    kinds, numbers, setting, _, cell = case[:5]
    N = order_of(case, z)
    at = places(kinds, N)
    theta, moments, states, states_by = workspace(kinds, N)
    at_w, at_row = at[len(kinds)], 0
    at_s = at_w + len(setting)
    fill_angles(case, z, at, theta)
    J[:, :] = 0.0
    for p in range(len(kinds)):
        m, c, k, g = numbers[p, M], numbers[p, C], numbers[p, K], numbers[p, G]
        number, rows, left = terms(kinds, p, N), tests(kinds, p, N), kinds[p, BESIDE]
        s = z[at_s + p]
        forced = g != 0 and rows > 0
        if forced:
            legendre_moments(cell[1] * s, theta[p], moments[:, : rows + left + 1])
        for l in range(rows + left):
            factors, changes = row(l, m, c, k, s), row_by_s(l, m, c, k, s)
            for i in range(2):
                J[at_row, at[p] + i] += factors[i]
                J[at_row, at_s + p] += changes[i] * z[at[p] + i]
            for i in range(max(0, 2 - l), min(5, number + 2 - l)):
                J[at_row, at[p] + l + i] += factors[2 + i]
                J[at_row, at_s + p] += changes[2 + i] * z[at[p] + l + i]
            for i in range(len(setting) if l == 0 else 0):
                J[at_row, at_w + i] -= numbers[p, MEMORY + i]
            if forced:
                below, middle, above = moment_by_kappa(l)
                change = middle * moments[1, l] + above * moments[1, l + 1]
                change = change + (below * moments[1, l - 1] if l > 0 else 0.0)
                J[at_row, at_s + p] -= of_moment(l, g * cell[1] * change)
                add_angle(J, at_row, -of_moment(l, g * moments[1, l]), cell[1], at_s, p)
            for i in range(max(0, l - rows), left):
                weight = unseen(rows + i, l, kinds[p, CLASS])
                J[at_row, at[p] + 2 + number + i] -= m * weight
            at_row += 1
    fill_states(case, z, at, N, states, states_by)
    joint_rates(case, z, at, theta, states_by[0], states_by[1], J, at_row)


def integrated(d):
    """Return the integral from 0 of a series of shifted Legendre polynomials, as a series."""
    integral, half = np.zeros(len(d) + 1), d / (4 * np.arange(len(d)) + 2)
    integral[1:] += half
    integral[:-2] -= half[1:]
    integral[0] += half[0]
    return integral


def phase_motion(x, v, d, s, u, derivative):
    """Return displacement, velocity or acceleration on a phase.

    Parameters
    ----------
    x, v : float
        The state in which the phase begins.
    d : ndarray
        Coefficients of the acceleration; empty if it is zero.
    s : float
        Duration of the phase.
    u : ndarray
        Local time, from 0 to 1.
    derivative : {0, 1, 2}
    """
    parts = d if len(d) else np.zeros(1)
    w = 2 * np.asarray(u) - 1
    if derivative == 2:
        return legendre.legval(w, parts)
    if derivative == 1:
        return v + s * legendre.legval(w, integrated(parts))
    twice = legendre.legval(w, integrated(integrated(parts)))
    return x + s * v * np.asarray(u) + s * s * twice


def motion(case, z, p, u, derivative):
    """Return a derivative of the displacement on phase p at local times u in [0, 1]."""
    kinds, _, setting, _, _ = case[:5]
    if not 0 <= p < len(kinds):
        raise IndexError("p")
    N = order_of(case, z)
    at = places(kinds, N)
    d = z[at[p] + 2 : at[p] + 2 + terms(kinds, p, N)]
    s = z[at[len(kinds)] + len(setting) + p]
    return phase_motion(z[at[p]], z[at[p] + 1], d, s, u, derivative)
