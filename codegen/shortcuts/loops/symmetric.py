"""Loops about mid-stick: condition (14), residual and Jacobian (3.1, 3.2).

Input to `emit`: the names of the closed forms of `hb_symmetric.closed_forms`.
"""

from .fourier import PERIOD_TERMS, WAVES
from .hb_c1 import ASCENDING_SERIES
from .odd_functions import ODD_FUNCTIONS
from .sines import SINE_TABLES

TAIL_CONDITION = '''

#: Gauss rule of one panel; it integrates waves of up to `PANEL` radians, to rounding.
NODES, WEIGHTS = np.polynomial.legendre.leggauss(32)
PANEL = 52.0


def tail_conditions(K, N, z, gamma, out):
    """Fill out[0..K-1] with the left sides of (14), the inner products of R and the tails.

    In closed form they are differences of numbers of order 1 that are equal up to
    N**(-3).  R and the tail are small each, so their product, integrated by Gauss in a
    half of stick and a half of slip, keeps its digits.
    """
    t1, T = z[-2], z[-1]
    size = len(NODES)
    q, a = legendre_parts(K, N, t1, T)[0], accelerations(K, N)
    rate = drift(T, T - t1)[0]
    off_cos, off_sin, turn_cos, turn_sin, cos_n, sin_n, R = np.empty((7, size))
    tail = np.empty((K, size))
    for i in range(K):
        out[i] = 0.0
    for phase in range(2):
        start, length = (0.0, t1 / 2) if phase == 0 else (t1 / 2, (T - t1) / 2)
        panels = int(2 * N * angle(T, length) / PANEL) + 1
        for p in range(size):
            turn = angle(T, 0.5 * length / panels * NODES[p])
            off_cos[p], off_sin[p] = cos(turn), sin(turn)
        for panel in range(panels):
            turn = angle(T, start + length * (panel + 0.5) / panels)
            mid_cos, mid_sin = cos(turn), sin(turn)
            for p in range(size):
                turn_cos[p] = mid_cos * off_cos[p] - mid_sin * off_sin[p]
                turn_sin[p] = mid_sin * off_cos[p] + mid_cos * off_sin[p]
                cos_n[p], sin_n[p] = 1.0, 0.0
                part = (panel + 0.5 * (1 + NODES[p])) / panels
                tau = start + length * part
                # The C1 functions themselves, in slip by their Legendre polynomials.
                total_rate, total = 0.0, 0.0
                if phase == 0:
                    for i in range(K):
                        tail[i, p] = a[i, 0] * rate * tau
                        total += z[N + i] * tail[i, p]
                    R[p] = residual_in_stick(total_rate, total)
                else:
                    v = part - 1
                    for i in range(K):
                        tail[i, p] = 0.0
                    even, odd = 1.0, v
                    for m in range(K + 1):
                        for i in range(K):
                            tail[i, p] += q[i, m] * odd
                            total_rate += z[N + i] * a[i, m] * odd
                        l = 2 * m + 1
                        even = ((2 * l + 1) * v * odd - l * even) / (l + 1)
                        odd = ((2 * l + 3) * v * even - (l + 1) * odd) / (l + 2)
                    for i in range(K):
                        total += z[N + i] * tail[i, p]
                    R[p] = residual_in_slip(total_rate, total)
            # Less their harmonics, and with those of the series.
            for n in range(1, N + 1):
                wave = z[n - 1]
                for i in range(K):
                    wave -= z[N + i] * gamma[i, n - 1]
                acceleration = wave * harmonic_acceleration(T, n)
                if phase == 0:
                    factor = residual_in_stick(acceleration, wave)
                else:
                    factor = residual_in_slip(acceleration, wave)
                for p in range(size):
                    c, s = cos_n[p], sin_n[p]
                    cos_n[p] = c * turn_cos[p] - s * turn_sin[p]
                    sin_n[p] = s * turn_cos[p] + c * turn_sin[p]
                    R[p] += factor * sin_n[p]
                for i in range(K):
                    g = gamma[i, n - 1]
                    row = tail[i]
                    for p in range(size):
                        row[p] -= g * sin_n[p]
            for i in range(K):
                total = 0.0
                for p in range(size):
                    total += WEIGHTS[p] * R[p] * tail[i, p]
                out[i] += length / panels * total
'''

RESIDUAL = '''

def size(N, K):
    """Return the number of unknowns and equations: N + K + 2."""
    return N + K + 2


def rough_motion(K, z):
    """Fill the coefficients of z for given t1, T: g_1 with the velocity 1 in stick.

    It satisfies (10), and (9) if t1 = 2 alpha; in slip it is a cubic.
    """
    N = len(z) - K - 2
    t1, T = z[-2], z[-1]
    scale = 1 / drift(T, T - t1)[0]
    gamma = harmonics(1, N, T, slip_moments(1, N, t1, T))
    for n in range(N):
        z[n] = scale * gamma[0, 0, n]
    for i in range(K):
        z[N + i] = scale if i == 0 else 0.0


def slip_part(K, N, z, C, h, out):
    """Fill out[0..N-1] with the slip part of (6); h: its coefficients of c_l."""
    slip_product(N, z, C, out)
    for i in range(K):
        for j in range(N):
            out[j] += z[N + i] * h[i, j]


def residual(case, z, R):
    """Fill R with (6) for j = 1..N, (14) for each C1 function, (9), (10).

    case : alpha and K, the number of C1 functions.
    """
    alpha, K = case
    N = len(z) - K - 2
    t1, T = z[-2], z[-1]
    cosines, sines = stick_waves(N, t1, T)
    C = slip_cosines(N, t1, T, sines)
    D = period_terms(N, T)
    M = slip_moments(K + 1 if K > 0 else 0, N, t1, T)
    gamma = harmonics(K, N, T, M)
    if K > 0:
        h, _ = tails(K, N, C, D, M, gamma, sines, t1, T, 1)
        tail_conditions(K, N, z, gamma[0], R[N : N + K])
    else:
        h = gamma
    part = np.empty(N)
    slip_part(K, N, z, C, h[0], part)
    displacement, velocity = initial_state(alpha)
    R[-2], R[-1] = displacement, -velocity
    tail, tail_velocity = at_end_of_stick(K, N, gamma, cosines, sines, t1, T)
    for i in range(K):
        R[-2] += z[N + i] * tail[0, i]
        R[-1] += z[N + i] * tail_velocity[0, i]
    for j in range(1, N + 1):
        R[j - 1] = D[0, j] * z[j - 1] + part[j - 1]
        response = -part[j - 1] / D[0, j]
        R[-2] += response * sines[j]
        R[-1] += response * velocity_weight(T, j)[0] * cosines[j]


def jacobian(case, z, J):
    """Fill J with the derivatives of `residual` by b_n, c_l, t1, T."""
    alpha, K = case
    N = len(z) - K - 2
    t1, T = z[-2], z[-1]
    cosines, sines = stick_waves(N, t1, T)
    C = slip_cosines(N, t1, T, sines)
    D = period_terms(N, T)
    M = slip_moments(K + 1 if K > 0 else 0, N, t1, T)
    gamma = harmonics(K, N, T, M)
    h = gamma
    J[N:, :] = 0.0
    sine_matrix(N, C, D[0], J)
    if K > 0:
        h, w = tails(K, N, C, D, M, gamma, sines, t1, T, 3)
        for i in range(K):
            for j in range(N):
                J[j, N + i] = h[0, i, j]
                J[N + i, j] = h[0, i, j]
                for row in range(1, 3):
                    J[N + i, row - 3] += h[row, i, j] * z[j]
            for k in range(K):
                J[N + i, N + k] = w[0, i, k]
                for row in range(1, 3):
                    J[N + i, row - 3] += w[row, i, k] * z[N + k]
    if K > 1:  # one closed form has the digits to descend by, several have not
        unit = np.zeros(N + K + 2)
        unit[-2], unit[-1] = t1, T
        for k in range(K):
            unit[N + k] = 1.0
            tail_conditions(K, N, unit, gamma[0], J[N : N + K, N + k])
            unit[N + k] = 0.0
    # The slip part of (6), of which that of the series changes as its ends say.
    part = np.empty((3, N))
    slip_product(N, z, C, part[0])
    at_end = 0.0
    for j in range(N):
        at_end += z[j] * sines[j + 1]
    for j in range(N):
        part[1, j], part[2, j] = slip_part_by_times(part[0, j], at_end, sines[j + 1], t1, T)
    for row in range(3):
        for i in range(K):
            for j in range(N):
                part[row, j] += z[N + i] * h[row, i, j]
    for j in range(N):
        J[j, -2] = part[1, j]
        J[j, -1] = part[2, j] + D[1, j + 1] * z[j]
    # (9) and (10): weights of the responses -force/D, and how each response changes.
    tail, tail_velocity = at_end_of_stick(K, N, gamma, cosines, sines, t1, T)
    for i in range(K):
        J[-2, N + i] = tail[0, i]
        J[-1, N + i] = tail_velocity[0, i]
        for row in range(1, 3):
            J[-2, row - 3] += z[N + i] * tail[row, i]
            J[-1, row - 3] += z[N + i] * tail_velocity[row, i]
    slope = (pi / T, -half_stick_angle(T, t1) / T)
    weights = np.empty((2, N))
    for j in range(1, N + 1):
        velocity, velocity_T = velocity_weight(T, j)
        weights[0, j - 1] = -sines[j] / D[0, j]
        weights[1, j - 1] = -velocity * cosines[j] / D[0, j]
        response = -part[0, j - 1] / D[0, j]
        for row in range(1, 3):
            J[-2, row - 3] += response * j * cosines[j] * slope[row - 1]
            J[-1, row - 3] -= response * velocity * j * sines[j] * slope[row - 1]
            J[-2, row - 3] += weights[0, j - 1] * part[row, j - 1]
            J[-1, row - 3] += weights[1, j - 1] * part[row, j - 1]
        J[-1, -1] += response * velocity_T * cosines[j]
        J[-2, -1] -= response * D[1, j] / D[0, j] * sines[j]
        J[-1, -1] -= response * D[1, j] / D[0, j] * velocity * cosines[j]
    for row in range(2):
        slip_product(N, weights[row], C, J[row - 2])
        for i in range(K):
            for j in range(N):
                J[row - 2, N + i] += weights[row, j] * h[0, i, j]
'''

SYMMETRIC_LOOPS = (
    WAVES
    + PERIOD_TERMS
    + SINE_TABLES
    + ASCENDING_SERIES
    + ODD_FUNCTIONS
    + TAIL_CONDITION
    + RESIDUAL
)
