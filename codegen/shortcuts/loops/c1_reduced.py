"""Loops of the scalar equation of Section 3.3: Horner sums and Newton in one unknown.

Input to `emit`: the names of the closed forms of `c1_reduced.closed_forms`.
"""

C1_REDUCED_LOOPS = '''
def series_coefficients(N):
    """Return the coefficients, in powers of s**2, of the parts of J_{N+1} and J_{N+2}.

    Returns
    -------
    table : ndarray, shape (N // 2 + 2, 8)
        Columns even_1, odd_1, even_0, odd_0 for the even index, then for the odd one; the
        odd parts have a factor s besides.  Signs are included.
    """
    table = np.zeros((N // 2 + 2, 8))
    for n in range(N + 1, N + 3):
        first = 0 if n % 2 == 0 else 4
        at_1 = 1.0
        at_0 = 1.0
        for j in range(n + 1):
            sign = 1 - 2 * ((j // 2) % 2)
            table[j // 2, first + j % 2] = sign * at_1
            table[j // 2, first + 2 + j % 2] = sign * at_0
            at_1 *= ratio_at_1(j, n)
            at_0 *= ratio_at_0(j, n)
    return table


def rough_slip(alpha):
    """Return a first slip duration: between pi, far out, and 2 pi at alpha = 0."""
    return pi + 2 / (alpha + 2 / pi)


def equation_and_slope(alpha, s, table):
    """Return alpha D + M at s, and its derivative by s."""
    x = s * s
    p0 = p1 = p3 = p4 = p5 = p6 = 0.0
    q0 = q1 = q3 = q4 = q5 = q6 = 0.0
    for k in range(len(table) - 1, -1, -1):
        q0 = q0 * x + p0
        q1 = q1 * x + p1
        q3 = q3 * x + p3
        q4 = q4 * x + p4
        q5 = q5 * x + p5
        q6 = q6 * x + p6
        p0 = p0 * x + table[k, 0]
        p1 = p1 * x + table[k, 1]
        p3 = p3 * x + table[k, 3]
        p4 = p4 * x + table[k, 4]
        p5 = p5 * x + table[k, 5]
        p6 = p6 * x + table[k, 6]
    twice = 2 * s
    # Even parts p(x), odd parts s p(x); in the order of the closed form.
    return scalar_equation(
        alpha,
        p6, p0, p4, s * p3, s * p1, s * p5,
        twice * q6, twice * q0, twice * q4,
        p3 + twice * s * q3, p1 + twice * s * q1, p5 + twice * s * q5,
    )


def stick(alpha, s, table):
    """Return t1 for a slip duration s that solves the equation."""
    x = s * s
    p0 = p1 = p2 = p3 = p4 = p5 = p6 = p7 = 0.0
    for k in range(len(table) - 1, -1, -1):
        p0 = p0 * x + table[k, 0]
        p1 = p1 * x + table[k, 1]
        p2 = p2 * x + table[k, 2]
        p3 = p3 * x + table[k, 3]
        p4 = p4 * x + table[k, 4]
        p5 = p5 * x + table[k, 5]
        p6 = p6 * x + table[k, 6]
        p7 = p7 * x + table[k, 7]
    return stick_duration(alpha, p2, p0, p4, s * p7, s * p1, s * p5)


def orbit_times(alpha, N, table):
    """Return t1, s = T - t1 and a status for one alpha, by Newton in s.

    Status 0: converged and admissible; 1: not converged; 2: converged to a solution that
    is not an orbit.  The orbit ends stick within 1/(2 N) of its travel 2 alpha, and slips for
    no more than a natural period.
    """
    s = rough_slip(alpha)
    status = 1
    for _ in range(12):
        value, slope = equation_and_slope(alpha, s, table)
        if slope == 0:
            break
        step = value / slope
        s -= step
        if abs(step) <= 1e-9 * s:
            status = 0
            break
    if status != 0:
        return alpha, s, status
    t1 = stick(alpha, s, table)
    allowed = 1 / (2 * N)
    if not (abs(t1 / (2 * alpha) - 1) <= allowed and 0 < s <= 2 * pi * (1 + allowed)):
        status = 2
    return t1, s, status


def batch(alphas, N, table, t1, s, status):
    """Fill t1, s, status for every alpha; see `orbit_times`."""
    for i in prange(len(alphas)):
        t1[i], s[i], status[i] = orbit_times(alphas[i], N, table)
'''
