"""Loops of Section 3.3: many orbits at once, each with the ends of its motion.

Input to `emit`: the names of the closed forms of `c1_legendre.closed_forms`, and of the
loops of `loops_c1` and `loops_c1_bands`.
"""

C1_ORBIT_LOOPS = '''

def slip_velocity(p, s, u):
    """Return velocity and acceleration at u = (t - t1)/s: the series integrated, and itself.

    P_n* integrates to (P_{n+1}* - P_{n-1}*)/(4 n + 2), and P_0* to u.
    """
    x = 2 * u - 1
    before, legendre = 1.0, x
    rate, acceleration = p[0] * u, p[0]
    for n in range(1, len(p)):
        after = ((2 * n + 1) * x * legendre - n * before) / (n + 1)
        rate += p[n] * (after - before) / (4 * n + 2)
        acceleration += p[n] * legendre
        before, legendre = legendre, after
    return 1 + s * rate, acceleration


def turning_point(p, s, u):
    """Return u, in the first half of slip, where the velocity is zero; from a first u.

    Newton's method; where it leaves the bracket, halves.
    """
    low, high = 0.0, 0.5
    for _ in range(60):
        velocity, acceleration = slip_velocity(p, s, u)
        if velocity > 0:
            low = u
        else:
            high = u
        ahead = u - velocity / (s * acceleration) if acceleration != 0 else low
        if not low < ahead < high:
            ahead = (low + high) / 2
        step = abs(ahead - u)
        u = ahead
        if step <= 1e-9:
            break
    return u


def overshoot(alpha, p, parts, s, twice):
    """Return how far the mass goes on from the start of slip until it turns.

    Slip backwards in time from its end is the same motion with other p, see `orbits`.
    """
    u = turning_point(p, s, 1 / (s * (alpha + 0.6)))
    twice_product(parts, p, twice)
    x = 2 * u - 1
    before, legendre = 1.0, x
    total = twice[0]
    for l in range(1, len(twice)):
        total += twice[l] * legendre
        before, legendre = legendre, ((2 * l + 1) * x * legendre - l * before) / (l + 1)
    return s * u + s * s * total


def orbits(alphas, A, B, parts, weights, t1, T, amplitude, status):
    """Solve for every alpha from first times t1, T, which are overwritten.

    Parameters
    ----------
    A, B, parts, weights : ndarray
        From `band_tables`.
    amplitude : ndarray, shape (len(alphas),)
        Filled: half of the way between the two ends of the motion.
    status : ndarray of int, shape (len(alphas),)
        Filled: 0 converged, 1 not.
    """
    n = len(parts)
    for i in prange(len(alphas)):
        alpha = alphas[i]
        p, twice, rho = np.empty(n), np.empty(n + 2), np.empty(n + 2)
        M, X = np.empty((n, 13)), np.empty((n, 3))
        t1[i], T[i], status[i] = band_newton(
            alpha, t1[i], T[i], A, B, parts, weights, p, M, X, twice, rho
        )
        s = T[i] - t1[i]
        if status[i] != 0 or not slip_velocity(p, s, 0.5)[0] < 0:
            status[i] = 1
            continue
        above = overshoot(alpha, p, parts, s, twice)
        for k in range(0, n, 2):
            p[k] = -p[k]
        below = overshoot(alpha, p, parts, s, twice)
        amplitude[i] = (t1[i] + above + below) / 2
'''
