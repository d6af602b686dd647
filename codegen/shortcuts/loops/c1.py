"""Loops of Section 3.3: sums over shifted Legendre polynomials.

Input to `emit`: the names of the closed forms of `c1_legendre.closed_forms`.
"""

C1_LOOPS = '''
def add_integral(n, weight, rho):
    """Add weight Q_n to rho, parts in P_l*; ``P_-1 = -P_0`` and ``P_-2 = -P_1``."""
    below, same, above = twice_integrated(n)
    sign, l = (1, n - 2) if n >= 2 else (-1, 1 - n)
    rho[l] += sign * weight * below
    rho[n] += weight * same
    rho[n + 2] += weight * above


def project(n, rho):
    """Return the integral of Q_n times the polynomial with parts rho, over u."""
    below, same, above = twice_integrated(n)
    sign, l = (1, n - 2) if n >= 2 else (-1, 1 - n)
    total = sign * below * norm(l) * rho[l]
    return total + same * norm(n) * rho[n] + above * norm(n + 2) * rho[n + 2]


def slip_residual(alpha, z):
    """Return the residual (17) in slip, and its derivatives.

    Returns
    -------
    rho : ndarray, shape (3, N + 3)
        Parts in P_l*(u); row 0 the value, row 1 the derivative by t1, row 2 by T.
    """
    N = len(z) - 3
    t1, T = z[-2], z[-1]
    rho = np.zeros((3, N + 3))
    scale, scale_t1, scale_T = time_scale(T - t1)
    for n in range(N + 1):
        add_integral(n, z[n], rho[0])
    for l in range(N + 3):
        twice = rho[0, l]
        rho[0, l] = scale * twice
        rho[1, l] = scale_t1 * twice
        rho[2, l] = scale_T * twice
    for n in range(N + 1):
        rho[0, n] += z[n]
    constant, constant_t1, constant_T = line_constant(T, alpha, t1)
    slope, slope_t1, slope_T = line_slope(T, t1)
    rho[0, 0] += constant
    rho[1, 0] += constant_t1
    rho[2, 0] += constant_T
    rho[0, 1] += slope
    rho[1, 1] += slope_t1
    rho[2, 1] += slope_T
    return rho


def size(N):
    """Return the number of unknowns and equations at order N: N + 3."""
    return N + 3


def residual(alpha, z, R):
    """Fill R with (18) for Q_0..Q_N, (19), (20)."""
    N = len(z) - 3
    T = z[-1]
    s = T - z[-2]
    rho = slip_residual(alpha, z)
    for k in range(N + 1):
        R[k] = project(k, rho[0])
    R[-2] = displacement_gain(T, z[0], z[1], s)[0]
    R[-1] = velocity_gain(z[0], s)[0]


def jacobian(alpha, z, J):
    """Fill J with the derivatives of `residual` by p_n, t1, T; in (18) ``|k - n| <= 4``."""
    N = len(z) - 3
    T = z[-1]
    s = T - z[-2]
    J[:, :] = 0.0
    column = np.zeros(N + 3)
    scale = time_scale(s)[0]
    for n in range(N + 1):
        column[:] = 0.0
        column[n] = 1.0
        add_integral(n, scale, column)
        for k in range(max(0, n - 4), min(N, n + 4) + 1):
            J[k, n] = project(k, column)
    rho = slip_residual(alpha, z)
    for k in range(N + 1):
        J[k, -2] = project(k, rho[1])
        J[k, -1] = project(k, rho[2])
    J[-2, 0], J[-2, 1] = displacement_weights(s)
    J[-1, 0] = velocity_weight(s)
    value, J[-2, -2], J[-2, -1] = displacement_gain(T, z[0], z[1], s)
    value, J[-1, -2], J[-1, -1] = velocity_gain(z[0], s)
'''
