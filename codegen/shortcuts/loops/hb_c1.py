"""Loops of Section 3.2: what the one C1 function adds to the Fourier series.

Input to `emit`: the names of the closed forms of `hb_c1.closed_forms`.
"""

ASCENDING_SERIES = '''

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
'''

HB_C1_LOOPS = (
    ASCENDING_SERIES
    + '''

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
    cosines, sines = waves(half_angle(T, 1, s), N)
    for k in range(1, N + 1):
        z = half_angle(T, k, s)
        cos_z, sin_z = cosines[k], sines[k]
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


def harmonics_of_g1(N, t1, T):
    """Return the first N harmonics of G, and their derivatives; the tail is without them.

    Returns
    -------
    gamma : ndarray, shape (3, 2 N + 1)
        In the order a0, a_1..a_N, b_1..b_N; row 0 the value, row 1 the derivative by t1,
        row 2 by T.
    """
    gamma = np.empty((3, 2 * N + 1))
    C1, S1, C3, S3 = slip_moments(N, t1, T)
    s = T - t1
    gamma[0, 0], gamma[1, 0], gamma[2, 0] = mean_of_g1(T, s)
    for j in range(1, N + 1):
        gamma[0, j], gamma[1, j], gamma[2, j] = sine_of_g1(S1, j, T, s)
        i = N + j
        gamma[0, i], gamma[1, i], gamma[2, i] = cosine_of_g1(C1, j, T, s)
    return gamma


def tail_column(N, C, S, D, gamma, t1, T, rows):
    """Return the coefficients of c1 in (5), (6), (7), (14) for the tail of G.

    `rows` is 1 for the values alone, 3 for their derivatives besides.

    With H the column of G and A the matrix of the harmonics, the tail has H - A gamma,
    and by itself H_g - gamma H - gamma (H - A gamma); the Galerkin form is symmetric.

    Returns
    -------
    h : ndarray, shape (3, 2 N + 2)
        Row 0 the value, row 1 the derivative by t1, row 2 by T; right up to `rows`.
    """
    h = g1_column(N, C, S, t1, T)
    whole = h.copy()
    product = np.empty(2 * N + 1)
    no_D = np.zeros(N + 1)
    fourier_product(N, gamma[0], C[0], S[0], D[0], product)
    for i in range(2 * N + 1):
        h[0, i] -= product[i]
    for row in range(1, rows):
        fourier_product(N, gamma[row], C[0], S[0], D[0], product)
        for i in range(2 * N + 1):
            h[row, i] -= product[i]
        fourier_product(N, gamma[0], C[row], S[row], D[1] if row == 2 else no_D, product)
        for i in range(2 * N + 1):
            h[row, i] -= product[i]
    for i in range(2 * N + 1):
        weight = 0.5 if i == 0 else 1.0
        h[0, -1] -= weight * gamma[0, i] * (whole[0, i] + h[0, i])
        for row in range(1, rows):
            h[row, -1] -= weight * gamma[row, i] * (whole[0, i] + h[0, i])
            h[row, -1] -= weight * gamma[0, i] * (whole[row, i] + h[row, i])
    return h


def tail_at_0(N, gamma, T):
    """Return displacement and velocity of the tail at t = 0, and their derivatives.

    Returns
    -------
    displacement, velocity : ndarray, shape (3,)
        The value, the derivative by t1, the derivative by T.
    """
    displacement = np.zeros(3)
    velocity = np.zeros(3)
    velocity[0], velocity[1], velocity[2] = g1_velocity(T)
    for row in range(3):
        displacement[row] = -0.5 * gamma[row, 0]
    for n in range(1, N + 1):
        weight, weight_T = velocity_weight(T, n)
        for row in range(3):
            displacement[row] -= gamma[row, N + n]
            velocity[row] -= weight * gamma[row, n]
        velocity[2] -= weight_T * gamma[0, n]
    return displacement, velocity


def c1_product(N, z, C, S, D, h, R):
    """Fill R[0..2N+1] with the left sides of (5), (6), (7), (14).

    C, S, D, h : one row of `slip_integrals`, `period_terms` and `tail_column`.
    """
    fourier_product(N, z, C, S, D, R)
    c1 = z[2 * N + 1]
    last = h[2 * N + 1] * c1 + 0.5 * h[0] * z[0]
    R[0] += h[0] * c1
    for j in range(1, 2 * N + 1):
        R[j] += h[j] * c1
        last += h[j] * z[j]
    R[2 * N + 1] = last


def gauss_legendre(n):
    """Return nodes and weights of the Gauss rule with n nodes on (-1, 1)."""
    nodes = np.empty(n)
    weights = np.empty(n)
    for i in range((n + 1) // 2):
        x = cos(pi * (i + 0.75) / (n + 0.5))
        for _ in range(10):
            below, value = 0.0, 1.0
            for l in range(n):
                below, value = value, ((2 * l + 1) * x * value - l * below) / (l + 1)
            slope = n * (x * value - below) / (x * x - 1)
            step = value / slope
            x -= step
            if abs(step) <= 1e-15:
                break
        nodes[i] = -x
        nodes[n - 1 - i] = x
        weights[i] = 2 / ((1 - x * x) * slope * slope)
        weights[n - 1 - i] = weights[i]
    return nodes, weights


def residual_and_tail(N, z, gamma, slip, t, u):
    """Return R2 of (13) and the tail of G at time t; u is the part of the phase gone by."""
    t1, T = z[-2], z[-1]
    c1 = z[2 * N + 1]
    if slip:
        tail, tail_acceleration = g1_in_slip(T, T - t1, t, u)
    else:
        tail, tail_acceleration = g1_in_stick(T, t)
    turn = angle(T, t)
    turn_cos, turn_sin = cos(turn), sin(turn)
    cos_n, sin_n = 1.0, 0.0
    displacement, acceleration = 0.5 * z[0], 0.0
    tail -= 0.5 * gamma[0]
    for n in range(1, N + 1):
        cos_n, sin_n = cos_n * turn_cos - sin_n * turn_sin, sin_n * turn_cos + cos_n * turn_sin
        factor = harmonic_acceleration(T, n)
        wave = z[n] * sin_n + z[N + n] * cos_n
        displacement += wave
        acceleration += factor * wave
        wave = gamma[n] * sin_n + gamma[N + n] * cos_n
        tail -= wave
        tail_acceleration -= factor * wave
    displacement += c1 * tail
    acceleration += c1 * tail_acceleration
    if slip:
        return residual_in_slip(acceleration, displacement), tail
    return residual_in_stick(acceleration, displacement), tail


def g1_condition(N, z, gamma):
    """Return the left side of (14), the inner product of R2 and the tail of G.

    Its closed form, the last row of `tail_column` times the unknowns, is a difference of
    numbers of order 1 that are equal up to N**(-3).  R2 and the tail are small each, so
    their product, integrated by Gauss in both phases, keeps its digits.
    """
    t1, T = z[-2], z[-1]
    total = 0.0
    for phase in range(2):
        start, length = (0.0, t1) if phase == 0 else (t1, T - t1)
        waves = N * angle(T, length) / 2
        nodes, weights = gauss_legendre(int(waves + 6 * waves ** (1 / 3)) + 14)
        for i in range(len(nodes)):
            u = 0.5 * (1 + nodes[i])
            R2, tail = residual_and_tail(N, z, gamma, phase == 1, start + length * u, u)
            total += 0.5 * length * weights[i] * R2 * tail
    return total


def size(N):
    """Return the number of unknowns and equations at order N: 2 N + 4."""
    return 2 * N + 4


def residual(alpha, z, R):
    """Fill R with (5), (6) for j = 1..N, (7) for j = 1..N, (14), (9), (10)."""
    N = (len(z) - 4) // 2
    t1, T = z[-2], z[-1]
    C, S = slip_integrals(N, t1, T)
    D = period_terms(N, T)
    gamma = harmonics_of_g1(N, t1, T)
    h = tail_column(N, C, S, D, gamma, t1, T, 1)
    c1_product(N, z, C[0], S[0], D[0], h[0], R)
    R[-2], R[-1] = initial_residual(alpha, N, z, T)
    R[-3] = g1_condition(N, z, gamma[0])
    displacement, velocity = tail_at_0(N, gamma, T)
    R[-2] += z[-3] * displacement[0]
    R[-1] += z[-3] * velocity[0]


def jacobian(alpha, z, J):
    """Fill J with the derivatives of `residual` by a0, a_n, b_n, c1 T s**3, t1, T."""
    N = (len(z) - 4) // 2
    t1, T = z[-2], z[-1]
    C, S = slip_integrals(N, t1, T)
    D = period_terms(N, T)
    gamma = harmonics_of_g1(N, t1, T)
    h = tail_column(N, C, S, D, gamma, t1, T, 3)
    J[:, :] = 0.0
    fourier_matrix(N, C[0], S[0], D[0], J)
    for i in range(2 * N + 2):
        J[i, -3] = h[0, i]
        J[-3, i] = h[0, i]
    J[-3, 0] = 0.5 * h[0, 0]
    c1_product(N, z, C[1], S[1], np.zeros(N + 1), h[1], J[:, -2])
    c1_product(N, z, C[2], S[2], D[1], h[2], J[:, -1])
    initial_rows(N, z, T, J)
    displacement, velocity = tail_at_0(N, gamma, T)
    J[-2, -3] = displacement[0]
    J[-1, -3] = velocity[0]
    for row in range(1, 3):
        J[-2, row - 3] += z[-3] * displacement[row]
        J[-1, row - 3] += z[-3] * velocity[row]
'''
)
