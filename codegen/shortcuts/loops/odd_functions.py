"""Loops about mid-stick: the K odd C1 functions, their harmonics and their tails (3.2)."""

ODD_FUNCTIONS = '''

def spherical_bessel(highest, z, cos_z, sin_z, j):
    """Fill j[0..highest] with the spherical Bessel functions of z > 0."""
    j[0] = spherical_bessel_0(cos_z, sin_z, z)
    j[1] = spherical_bessel_1(cos_z, sin_z, z) if z >= 2 else ascending_series(1, z)
    for l in range(1, highest):
        if z >= l + 2:
            j[l + 1] = spherical_bessel_next(j[l - 1], j[l], l, z)
        else:
            j[l + 1] = ascending_series(l + 1, z)


def slip_moments(degrees, N, t1, T):
    """Return M_lk for the odd l = 1, 3, ... and k = 1..N, and their derivatives.

    Returns
    -------
    M : ndarray, shape (degrees, N, 3)
        M[i, k - 1]: the value, the derivative by t1, by T, for l = 2 i + 1.
    """
    M = np.empty((degrees, N, 3))
    if degrees == 0:
        return M
    bessel = np.empty(2 * degrees)
    s = T - t1
    cosines, sines = waves(half_slip_angle(T, 1, s), N)
    for k in range(1, N + 1):
        z = half_slip_angle(T, k, s)
        spherical_bessel(2 * degrees - 1, z, cosines[k], sines[k], bessel)
        for i in range(degrees):
            l = 2 * i + 1
            sign = (1 - 2 * (k % 2)) * (1 - 2 * (i % 2))
            values = moment(T, bessel[l - 1], bessel[l], k, l, s, sign, t1, z)
            M[i, k - 1, 0], M[i, k - 1, 1], M[i, k - 1, 2] = values
    return M


def accelerations(K, N):
    """Return the accelerations of the C1 functions in P_1*, P_3*, ...

    Function i has ``v (1 - v**2)**i (N + 1)**i`` in slip: the first jumps there, the next
    has a jump one derivative later, and so on.  Their tails beyond N harmonics are of very
    different size, and scaled alike; those of the P_l* themselves are nearly one and the
    same, and what tells them apart would be lost.

    Returns
    -------
    a : ndarray, shape (K, K + 1)
        a[i, m] multiplies P_l*, l = 2 m + 1, in function i.
    """
    a = np.zeros((K, K + 1))
    for i in range(K):
        if i == 0:
            a[0, 0] = 1.0
            continue
        for m in range(i):
            below, here, above = squared(2 * m + 1)
            if m > 0:
                a[i, m - 1] -= below * a[i - 1, m] * (N + 1)
            a[i, m] += (1 - here) * a[i - 1, m] * (N + 1)
            a[i, m + 1] -= above * a[i - 1, m] * (N + 1)
    return a


def combined(a, table):
    """Return rows of `table`, shape (3, degrees, n), combined by `accelerations`."""
    K = len(a)
    result = np.zeros((3, K, table.shape[2]))
    for row in range(3):
        for i in range(K):
            for m in range(min(i + 1, K)):
                for j in range(table.shape[2]):
                    result[row, i, j] += a[i, m] * table[row, m, j]
    return result


def legendre_parts(K, N, t1, T):
    """Return the C1 functions in slip in P_1*, P_3*, ..., and their derivatives.

    Returns
    -------
    q : ndarray, shape (3, K, K + 1)
        q[0, i, m] multiplies P_l*, l = 2 m + 1, in function i; then by t1 and by T.
    """
    q = np.zeros((3, K, K + 1))
    s = T - t1
    for i in range(K):
        values = in_legendre(2 * i + 1, s)
        for part in range(3):
            m = i - 1 + part
            if m >= 0:
                q[0, i, m] = values[part]
                q[1, i, m] = -values[3 + part]
                q[2, i, m] = values[3 + part]
    if K > 0:
        values = drift_in_slip(T, s)
        for row in range(3):
            q[row, 0, 0] += values[row]
    return combined(accelerations(K, N), q)


def harmonics(K, N, T, M):
    """Return the first N sine harmonics of the C1 functions, and their derivatives.

    M : `slip_moments`, for K degrees or more.

    Returns
    -------
    gamma : ndarray, shape (3, K, N)
        Row 0 the value, row 1 the derivative by t1, row 2 by T.
    """
    gamma = np.empty((3, K, N))
    for i in range(K):
        for j in range(N):
            gamma[0, i, j], gamma[1, i, j], gamma[2, i, j] = harmonic(M[i, j], T, j + 1)
    return combined(accelerations(K, N), gamma)


def through_harmonics(K, N, t1, T, M):
    """Return the C1 functions through (1), tested by each harmonic, and derivatives.

    M : `slip_moments`, for K + 1 degrees.

    Returns
    -------
    H : ndarray, shape (3, K, N)
        Row 0 the value, row 1 the derivative by t1, row 2 by T.
    """
    H = np.empty((3, K, N))
    for j in range(N):
        H[0, 0, j], H[1, 0, j], H[2, 0, j] = through_motion_1(M[0, j], M[1, j], T, T - t1)
        for i in range(1, K):
            H[0, i, j], H[1, i, j], H[2, i, j] = through_motion(M[i, j], T, j + 1)
    return combined(accelerations(K, N), H)


def through_each_other(K, N, t1, T):
    """Return the C1 functions through (1), tested by each other, and derivatives.

    Returns
    -------
    W : ndarray, shape (3, K, K)
        Row 0 the value, row 1 the derivative by t1, row 2 by T.
    """
    W = np.zeros((3, K, K))
    q = legendre_parts(K, N, t1, T)
    a = accelerations(K, N)
    for m in range(K + 1):
        norm, slope = legendre_norm(2 * m + 1, T - t1)
        for i in range(K):
            for k in range(K):
                # <g_k'' + g_k, g_i>
                product = (a[k, m] + q[0, k, m]) * q[0, i, m]
                W[0, i, k] += norm * product
                W[1, i, k] -= slope * product
                W[2, i, k] += slope * product
                for row in range(1, 3):
                    rate = q[row, k, m] * q[0, i, m] + (a[k, m] + q[0, k, m]) * q[row, i, m]
                    W[row, i, k] += norm * rate
    return W


def tails(K, N, C, D, M, gamma, sines, t1, T, rows):
    """Return what the tails of the C1 functions add to (6) and (14).

    C, D, M, gamma, sines : the tables of these names; `rows` is 1 for the values alone, 3
    for their derivatives besides.  With H of
    `through_harmonics`, W of `through_each_other` and A the matrix of the harmonics, the
    tails have H - A gamma, and W - gamma H - (H - A gamma) gamma.

    Returns
    -------
    h : ndarray, shape (3, K, N)
        Coefficients of c_l in (6).
    w : ndarray, shape (3, K, K)
        Coefficients of c_l in (14).
    """
    h = through_harmonics(K, N, t1, T, M)
    w = through_each_other(K, N, t1, T)
    H = h.copy()
    part = np.empty(N)
    for i in range(K):
        for row in range(rows):
            slip_product(N, gamma[row, i], C, part)
            for j in range(N):
                h[row, i, j] -= part[j] + D[0, j + 1] * gamma[row, i, j]
            if row == 0 and rows > 1:
                at_end = 0.0
                for j in range(N):
                    at_end += gamma[0, i, j] * sines[j + 1]
                for j in range(N):
                    by_t1, by_T = slip_part_by_times(part[j], at_end, sines[j + 1], t1, T)
                    h[1, i, j] -= by_t1
                    h[2, i, j] -= by_T + D[1, j + 1] * gamma[0, i, j]
    for i in range(K):
        for k in range(K):
            for row in range(rows):
                for j in range(N):
                    w[row, i, k] -= gamma[row, i, j] * H[0, k, j]
                    w[row, i, k] -= gamma[row, k, j] * h[0, i, j]
                    if row > 0:
                        w[row, i, k] -= gamma[0, i, j] * H[row, k, j]
                        w[row, i, k] -= gamma[0, k, j] * h[row, i, j]
    return h, w


def at_end_of_stick(K, N, gamma, cosines, sines, t1, T):
    """Return displacement and velocity of the tails at tau = t1/2, and derivatives.

    Returns
    -------
    displacement, velocity : ndarray, shape (3, K)
        Row 0 the value, row 1 the derivative by t1, row 2 by T.
    """
    displacement = np.zeros((3, K))
    velocity = np.zeros((3, K))
    a = accelerations(K, N)
    rate = drift(T, T - t1)
    for i in range(K):
        for row in range(3):
            velocity[row, i] = a[i, 0] * rate[row]
            displacement[row, i] = a[i, 0] * rate[row] * t1 / 2
        displacement[1, i] += a[i, 0] * rate[0] / 2
    slope = (pi / T, -half_stick_angle(T, t1) / T)
    for n in range(1, N + 1):
        weight, weight_T = velocity_weight(T, n)
        for i in range(K):
            g = gamma[0, i, n - 1]
            for row in range(3):
                displacement[row, i] -= gamma[row, i, n - 1] * sines[n]
                velocity[row, i] -= gamma[row, i, n - 1] * weight * cosines[n]
            for row in range(1, 3):
                displacement[row, i] -= g * n * cosines[n] * slope[row - 1]
                velocity[row, i] += g * weight * n * sines[n] * slope[row - 1]
            velocity[2, i] -= g * weight_T * cosines[n]
    return displacement, velocity
'''
