"""Loops over the harmonics: the part of a kernel that no closed form holds (3.1, 3.2).

Input to `emit`: the names of the closed forms of `fourier.closed_forms`.
"""

WAVES = '''
def waves(turn, highest):
    """Return cos(k turn) and sin(k turn) for k = 0..highest, by repeated rotation.

    Divided by k, as they are used, the errors stay below one rounding; those of cos(k*turn)
    do not, since k*turn is rounded for each k by itself.
    """
    cos_k = np.empty(highest + 1)
    sin_k = np.empty(highest + 1)
    turn_cos, turn_sin = cos(turn), sin(turn)
    c, s = 1.0, 0.0
    for k in range(highest + 1):
        cos_k[k] = c
        sin_k[k] = s
        c, s = c * turn_cos - s * turn_sin, s * turn_cos + c * turn_sin
    return cos_k, sin_k
'''

PERIOD_TERMS = '''

def period_terms(N, T):
    """Return D_j for j = 0..N, row 0 the value, row 1 the derivative by T; D_0 unused."""
    D = np.zeros((2, N + 1))
    for j in range(1, N + 1):
        D[0, j], D[1, j] = period_term(T, j)
    return D
'''

FOURIER_TABLES = (
    WAVES
    + '''

def slip_integrals(N, t1, T):
    """Return C_k and S_k for k = -2N..2N, and their derivatives.

    Returns
    -------
    C, S : ndarray, shape (3, 4 N + 1)
        Row 0 the value, row 1 the derivative by t1, row 2 by T.  A negative k counts
        from the end, as NumPy's indices do: ``C_-k = C_k``, ``S_-k = -S_k``.
    """
    C = np.empty((3, 4 * N + 1))
    S = np.empty((3, 4 * N + 1))
    C[0, 0], C[1, 0], C[2, 0] = slip_cosine_zero(t1, T)
    S[0, 0], S[1, 0], S[2, 0] = slip_sine_zero(t1, T)
    cos_k, sin_k = waves(angle(T, t1), 2 * N)
    for k in range(1, 2 * N + 1):
        C[0, k], C[1, k], C[2, k] = slip_cosine(cos_k[k], sin_k[k], k, t1, T)
        S[0, k], S[1, k], S[2, k] = slip_sine(cos_k[k], sin_k[k], k, t1, T)
        for i in range(3):
            C[i, -k] = C[i, k]
            S[i, -k] = -S[i, k]
    return C, S
'''
    + PERIOD_TERMS
    + '''

def fourier_product(N, c, C, S, D, R):
    """Fill R[0..2N] with the left sides of (5), (6), (7) for the coefficients c.

    c, R : ndarray, shape (2 N + 1,) or longer; a0, a_1..a_N, b_1..b_N.
    C, S : one row of `slip_integrals`; D : one row of `period_terms`.
    """
    one = c[0] * constant_by_one(C)
    for n in range(1, N + 1):
        one += c[n] * sine_by_one(S, n) + c[N + n] * cosine_by_one(C, n)
    R[0] = one
    for j in range(1, N + 1):
        sine = c[0] * constant_by_sine(S, j) + D[j] * c[j]
        cosine = c[0] * constant_by_cosine(C, j) + D[j] * c[N + j]
        for n in range(1, N + 1):
            sine += c[n] * sine_by_sine(C, j, n) + c[N + n] * cosine_by_sine(S, j, n)
            cosine += c[n] * sine_by_cosine(S, j, n) + c[N + n] * cosine_by_cosine(C, j, n)
        R[j] = sine
        R[N + j] = cosine


def fourier_matrix(N, C, S, D, J):
    """Fill J[0..2N, 0..2N] with the coefficients of (5), (6), (7), which are linear."""
    J[0, 0] = constant_by_one(C)
    for j in range(1, N + 1):
        J[0, j] = sine_by_one(S, j)
        J[0, N + j] = cosine_by_one(C, j)
        J[j, 0] = constant_by_sine(S, j)
        J[N + j, 0] = constant_by_cosine(C, j)
        for n in range(1, N + 1):
            J[j, n] = sine_by_sine(C, j, n)
            J[j, N + n] = cosine_by_sine(S, j, n)
            J[N + j, n] = sine_by_cosine(S, j, n)
            J[N + j, N + n] = cosine_by_cosine(C, j, n)
        J[j, j] += D[j]
        J[N + j, N + j] += D[j]


def initial_residual(alpha, N, c, T):
    """Return the residuals of (9) and (10) for the Fourier series alone."""
    displacement, velocity = initial_state(alpha)
    at_0 = c[0] / 2
    rate = 0.0
    for n in range(1, N + 1):
        at_0 += c[N + n]
        rate += c[n] * velocity_weight(T, n)[0]
    return at_0 - displacement, rate - velocity


def initial_rows(N, c, T, J):
    """Fill the last two rows of J, which are zero: the derivatives of (9) and (10)."""
    J[-2, 0] = 0.5
    for n in range(1, N + 1):
        weight, weight_T = velocity_weight(T, n)
        J[-2, N + n] = 1.0
        J[-1, n] = weight
        J[-1, -1] += c[n] * weight_T
'''
)

HB_LOOPS = '''

def size(N):
    """Return the number of unknowns and equations at order N: 2 N + 3."""
    return 2 * N + 3


def residual(alpha, z, R):
    """Fill R with (5), (6) for j = 1..N, (7) for j = 1..N, (9), (10)."""
    N = (len(z) - 3) // 2
    t1, T = z[-2], z[-1]
    C, S = slip_integrals(N, t1, T)
    fourier_product(N, z, C[0], S[0], period_terms(N, T)[0], R)
    R[-2], R[-1] = initial_residual(alpha, N, z, T)


def jacobian(alpha, z, J):
    """Fill J with the derivatives of `residual` by a0, a_n, b_n, t1, T."""
    N = (len(z) - 3) // 2
    t1, T = z[-2], z[-1]
    C, S = slip_integrals(N, t1, T)
    D = period_terms(N, T)
    J[:, :] = 0.0
    fourier_matrix(N, C[0], S[0], D[0], J)
    fourier_product(N, z, C[1], S[1], np.zeros(N + 1), J[:, -2])
    fourier_product(N, z, C[2], S[2], D[1], J[:, -1])
    initial_rows(N, z, T, J)
'''
