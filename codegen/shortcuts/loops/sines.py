"""Loops about mid-stick: tables of waves, and sines multiplied over slip (3.1, 3.2)."""

SINE_TABLES = '''

def stick_waves(N, t1, T):
    """Return cos(k phi) and sin(k phi), k = 0..2N, at the end of stick, phi = omega_0 t1/2."""
    return waves(half_stick_angle(T, t1), 2 * N)


def slip_cosines(N, t1, T, sines):
    """Return C_k for k = -2N..2N, in this order; C_0 is entry 2 N.

    sines : second of `stick_waves`.
    """
    C = np.empty(4 * N + 1)
    C[2 * N] = slip_cosine_zero(t1, T)
    for k in range(1, 2 * N + 1):
        C[2 * N + k] = slip_cosine(sines[k], k, T)
        C[2 * N - k] = C[2 * N + k]
    return C


def slip_product(N, b, C, out):
    """Fill out[0..N-1] with the slip part of (6) for the coefficients b[0..N-1].

    C : `slip_cosines`.
    """
    for j in range(N):
        out[j] = 0.0
    for n in range(1, N + 1):
        minus, plus = C[2 * N + 1 - n :], C[2 * N + 1 + n :]
        for j in range(N):
            out[j] += b[n - 1] * sine_by_sine(minus[j], plus[j])


def sine_matrix(N, C, D, J):
    """Fill J[0..N-1, 0..N-1] with the coefficients of (6), which are linear in b."""
    for n in range(1, N + 1):
        minus, plus = C[2 * N + 1 - n :], C[2 * N + 1 + n :]
        row = J[n - 1]
        for j in range(N):
            row[j] = sine_by_sine(minus[j], plus[j])
        row[n - 1] += D[n]
'''
