"""Loops of Section 3.3: the system solved by its bands, bordered by the two times.

Input to `emit`: the names of the closed forms of `c1_legendre.closed_forms`, and of the
loops of `loops_c1`.
"""

C1_BAND_LOOPS = '''

def band_tables(N):
    """Return what (18) consists of at order N, made once: it does not depend on s.

    Returns
    -------
    A, B : ndarray, shape (N + 1, 9)
        Integrals of P_n* Q_k and Q_n Q_k over u; row k, column n - k + 4.
    parts, weights : ndarray, shape (N + 1, 3)
        Parts of Q_n in P_{n-2}*, P_n*, P_{n+2}*, and the same times their norms.
    """
    A = np.zeros((N + 1, 9))
    B = np.zeros((N + 1, 9))
    parts = np.zeros((N + 1, 3))
    weights = np.zeros((N + 1, 3))
    column = np.zeros(N + 3)
    for n in range(N + 1):
        sign, l = (1, n - 2) if n >= 2 else (-1, 1 - n)
        parts[n, 0], parts[n, 1], parts[n, 2] = twice_integrated(n)
        parts[n, 0] *= sign
        weights[n, 0] = parts[n, 0] * norm(l)
        weights[n, 1] = parts[n, 1] * norm(n)
        weights[n, 2] = parts[n, 2] * norm(n + 2)
        for k in range(max(0, n - 4), min(N, n + 4) + 1):
            column[:] = 0.0
            column[n] = 1.0
            A[k, n - k + 4] = project(k, column)
            column[:] = 0.0
            add_integral(n, 1.0, column)
            B[k, n - k + 4] = project(k, column)
    return A, B, parts, weights


def band_solve(M, X):
    """Solve M Y = X in place: M is banded, 4 below and 4 above, X has any columns.

    Partial pivoting; M has shape (n, 13), row i holding the columns i - 4 .. i + 8, and is
    overwritten; X is overwritten by Y.  Returns whether M is regular.
    """
    n, right = X.shape
    for j in range(n):
        last = min(j + 4, n - 1)
        pivot = j
        for i in range(j + 1, last + 1):
            if abs(M[i, j - i + 4]) > abs(M[pivot, j - pivot + 4]):
                pivot = i
        head = M[pivot, j - pivot + 4]
        if head == 0:
            return False
        if pivot != j:
            for k in range(j, min(j + 9, n)):
                kept = M[j, k - j + 4]
                M[j, k - j + 4] = M[pivot, k - pivot + 4]
                M[pivot, k - pivot + 4] = kept
            for c in range(right):
                X[j, c], X[pivot, c] = X[pivot, c], X[j, c]
        inverse = 1 / head
        for i in range(j + 1, last + 1):
            factor = M[i, j - i + 4] * inverse
            if factor != 0:
                for k in range(j + 1, min(j + 9, n)):
                    M[i, k - i + 4] -= factor * M[j, k - j + 4]
                for c in range(right):
                    X[i, c] -= factor * X[j, c]
    for i in range(n - 1, -1, -1):
        inverse = 1 / M[i, 4]
        for c in range(right):
            total = X[i, c]
            for k in range(i + 1, min(i + 9, n)):
                total -= M[i, k - i + 4] * X[k, c]
            X[i, c] = total * inverse
    return True


def fill_band(A, B, scale, M):
    """Fill M with A + scale B, and with zeros where pivoting will fill in."""
    for i in range(len(M)):
        for k in range(9):
            M[i, k] = A[i, k] + scale * B[i, k]
        for k in range(9, 13):
            M[i, k] = 0.0


def twice_product(parts, p, twice):
    """Fill twice, shape (N + 3,), with the parts of sum p_n Q_n."""
    for l in range(len(twice)):
        twice[l] = 0.0
    for n in range(len(p)):
        l = n - 2 if n >= 2 else 1 - n
        twice[l] += parts[n, 0] * p[n]
        twice[n] += parts[n, 1] * p[n]
        twice[n + 2] += parts[n, 2] * p[n]


def projections(weights, twice, p, scale, constant, slope, rho, column):
    """Fill column, shape (N + 1,), with the integrals of p + scale twice + line by Q_k.

    The sum is made first, part by part, and then projected: its rounding errors are those of
    a neighbouring residual, the same for every row.
    """
    for l in range(len(twice)):
        rho[l] = scale * twice[l]
    for l in range(len(p)):
        rho[l] += p[l]
    rho[0] += constant
    rho[1] += slope
    for k in range(len(column)):
        l = k - 2 if k >= 2 else 1 - k
        column[k] = weights[k, 0] * rho[l] + weights[k, 1] * rho[k] + weights[k, 2] * rho[k + 2]


def band_newton(alpha, t1, T, A, B, parts, weights, p, M, X, twice, rho):
    """Solve the system from first times t1, T: Newton with the bands, bordered by the times.

    Parameters
    ----------
    A, B, parts, weights : ndarray
        From `band_tables`.
    p : ndarray, shape (N + 1,)
        Overwritten: the Legendre parts of the acceleration.
    M, X, twice, rho : ndarray, shape (N + 1, 13), (N + 1, 3), (N + 3,), (N + 3,)
        Overwritten: room for the linear systems.

    Returns
    -------
    t1, T, status
        Status 0: converged; 1: not converged.
    """
    n = len(p)
    fill_band(A, B, time_scale(T - t1)[0], M)
    for i in range(n):
        p[i] = 0.0
    twice_product(parts, p, twice)
    constant, slope = line_constant(T, alpha, t1)[0], line_slope(T, t1)[0]
    projections(weights, twice, p, 0.0, -constant, -slope, rho, X[:, 0])
    if not band_solve(M, X):
        return t1, T, 1
    for i in range(n):
        p[i] = X[i, 0]
    for _ in range(25):
        s = T - t1
        scale, scale_t1, scale_T = time_scale(s)
        constant, constant_t1, constant_T = line_constant(T, alpha, t1)
        slope, slope_t1, slope_T = line_slope(T, t1)
        fill_band(A, B, scale, M)
        twice_product(parts, p, twice)
        projections(weights, twice, p, scale, constant, slope, rho, X[:, 0])
        projections(weights, twice, p[:0], scale_t1, constant_t1, slope_t1, rho, X[:, 1])
        projections(weights, twice, p[:0], scale_T, constant_T, slope_T, rho, X[:, 2])
        if not band_solve(M, X):
            return t1, T, 1
        gain, gain_t1, gain_T = displacement_gain(T, p[0], p[1], s)
        rate, rate_t1, rate_T = velocity_gain(p[0], s)
        w0, w1 = displacement_weights(s)
        w = velocity_weight(s)
        # The two closures, with the step of p in terms of the steps of the times.
        a11 = gain_t1 - w0 * X[0, 1] - w1 * X[1, 1]
        a12 = gain_T - w0 * X[0, 2] - w1 * X[1, 2]
        b1 = gain - w0 * X[0, 0] - w1 * X[1, 0]
        a21 = rate_t1 - w * X[0, 1]
        a22 = rate_T - w * X[0, 2]
        b2 = rate - w * X[0, 0]
        determinant = a11 * a22 - a12 * a21
        if determinant == 0:
            return t1, T, 1
        step_t1 = (b1 * a22 - b2 * a12) / determinant
        step_T = (a11 * b2 - a21 * b1) / determinant
        damping = 1.0
        fall = max(step_t1 / t1, (step_T - step_t1) / s)
        if fall > 0.5:
            damping = 0.5 / fall
        for i in range(n):
            p[i] -= damping * (X[i, 0] - X[i, 1] * step_t1 - X[i, 2] * step_T)
        t1 -= damping * step_t1
        T -= damping * step_T
        if abs(step_t1) <= 1e-9 * T and abs(step_T - step_t1) <= 1e-9 * s + 1e-15 * T:
            return t1, T, 0
    return t1, T, 1
'''
