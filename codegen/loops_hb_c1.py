"""Loops of Section 3.2: what the one C1 function adds to the Fourier series.

Input to `emit`: the names of the closed forms of `hb_c1.closed_forms`.
"""

HB_C1_LOOPS = '''

def ascending_series(l, z):
    """Return j_l(z) for z < l + 1 by its ascending series, whose terms do not cancel."""
    term = 1.0
    for i in range(1, l + 1):
        term *= z / (2 * i + 1)
    total = term
    for i in range(1, 40):
        term *= -z * z / (2 * i * (2 * l + 2 * i + 1))
        total += term
        if abs(term) <= 1e-17 * abs(total):
            break
    return total


def spherical_bessel(z, cos_z, sin_z):
    """Return j_0(z), j_1(z), j_2(z), j_3(z) for z > 0."""
    j0 = spherical_bessel_0(cos_z, sin_z, z)
    j1 = spherical_bessel_1(cos_z, sin_z, z) if z >= 2 else ascending_series(1, z)
    j2 = spherical_bessel_2(cos_z, sin_z, z) if z >= 3 else ascending_series(2, z)
    j3 = spherical_bessel_3(cos_z, sin_z, z) if z >= 4 else ascending_series(3, z)
    return j0, j1, j2, j3


def slip_moments(N, t1, T):
    """Return C1_k, S1_k, C3_k, S3_k for k = 1..N, and their derivatives.

    Returns
    -------
    C1, S1, C3, S3 : ndarray, shape (3, N + 1)
        Row 0 the value, row 1 the derivative by t1, row 2 by T; column 0 unused.
    """
    C1 = np.zeros((3, N + 1))
    S1 = np.zeros((3, N + 1))
    C3 = np.zeros((3, N + 1))
    S3 = np.zeros((3, N + 1))
    s = T - t1
    for k in range(1, N + 1):
        z = half_angle(T, k, s)
        cos_z = cos(z)
        sin_z = sin(z)
        j0, j1, j2, j3 = spherical_bessel(z, cos_z, sin_z)
        C1[0, k], C1[1, k], C1[2, k] = cosine_moment_1(T, j0, j1, cos_z, k, s, sin_z, t1, z)
        S1[0, k], S1[1, k], S1[2, k] = sine_moment_1(T, j0, j1, cos_z, k, s, sin_z, t1, z)
        C3[0, k], C3[1, k], C3[2, k] = cosine_moment_3(T, j2, j3, cos_z, k, s, sin_z, t1, z)
        S3[0, k], S3[1, k], S3[2, k] = sine_moment_3(T, j2, j3, cos_z, k, s, sin_z, t1, z)
    return C1, S1, C3, S3


def g1_column(N, C, S, t1, T):
    """Return the coefficients of c1 in (5), (6), (7), (14), and their derivatives.

    By the symmetry of the Galerkin form the first 2 N + 1 are those of (14), too.

    Returns
    -------
    h : ndarray, shape (3, 2 N + 2)
        Row 0 the value, row 1 the derivative by t1, row 2 by T.
    """
    h = np.empty((3, 2 * N + 2))
    C1, S1, C3, S3 = slip_moments(N, t1, T)
    s = T - t1
    h[0, 0], h[1, 0], h[2, 0] = g1_by_one(T, s)
    for j in range(1, N + 1):
        h[0, j], h[1, j], h[2, j] = g1_by_sine(S, S1, S3, j, T, s)
        i = N + j
        h[0, i], h[1, i], h[2, i] = g1_by_cosine(C, C1, C3, j, T, s)
    h[0, -1], h[1, -1], h[2, -1] = g1_by_g1(T, s)
    return h


def c1_product(N, z, C, S, D, h, R):
    """Fill R[0..2N+1] with the left sides of (5), (6), (7), (14).

    C, S, D, h : one row of `slip_integrals`, `period_terms` and `g1_column`.
    """
    fourier_product(N, z, C, S, D, R)
    c1 = z[2 * N + 1]
    last = h[2 * N + 1] * c1 + 0.5 * h[0] * z[0]
    R[0] += h[0] * c1
    for j in range(1, 2 * N + 1):
        R[j] += h[j] * c1
        last += h[j] * z[j]
    R[2 * N + 1] = last


def size(N):
    """Return the number of unknowns and equations at order N: 2 N + 4."""
    return 2 * N + 4


def residual(alpha, z, R):
    """Fill R with (5), (6) for j = 1..N, (7) for j = 1..N, (14), (9), (10)."""
    N = (len(z) - 4) // 2
    t1, T = z[-2], z[-1]
    C, S = slip_integrals(N, t1, T)
    h = g1_column(N, C, S, t1, T)
    c1_product(N, z, C[0], S[0], period_terms(N, T)[0], h[0], R)
    R[-2], R[-1] = initial_residual(alpha, N, z, T)
    R[-1] += z[-3] * g1_velocity(T)[0]


def jacobian(alpha, z, J):
    """Fill J with the derivatives of `residual` by a0, a_n, b_n, c1 T s**3, t1, T."""
    N = (len(z) - 4) // 2
    t1, T = z[-2], z[-1]
    C, S = slip_integrals(N, t1, T)
    D = period_terms(N, T)
    h = g1_column(N, C, S, t1, T)
    J[:, :] = 0.0
    fourier_matrix(N, C[0], S[0], D[0], J)
    for i in range(2 * N + 2):
        J[i, -3] = h[0, i]
        J[-3, i] = h[0, i]
    J[-3, 0] = 0.5 * h[0, 0]
    c1_product(N, z, C[1], S[1], np.zeros(N + 1), h[1], J[:, -2])
    c1_product(N, z, C[2], S[2], D[1], h[2], J[:, -1])
    initial_rows(N, z, T, J)
    weight, weight_t1, weight_T = g1_velocity(T)
    J[-1, -3] = weight
    J[-1, -1] += z[-3] * weight_T
'''
