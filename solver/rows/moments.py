"""The integral of all expansions: moments of shifted Legendre polynomials with a cosine."""

from math import cos, sin


def spherical_bessel(x, j):
    """Fill j with the spherical Bessel functions ``j_0(x), j_1(x), ...`` of any real x.

    Upward recurrence as far as it is stable, to ``n = |x|``; beyond, ratios of neighbours by
    downward recurrence.  Each value is exact to rounding.
    """
    count = len(j)
    if x == 0.0:
        j[:] = 0.0
        j[0] = 1.0
        return
    turn = int(abs(x)) if abs(x) < count - 1 else count - 1
    j[0] = sin(x) / x
    if turn >= 1:
        j[1] = (j[0] - cos(x)) / x
    for n in range(2, turn + 1):
        j[n] = (2 * n - 1) / x * j[n - 1] - j[n - 2]
    if turn == count - 1:
        return
    top, left = count, 1.0
    while left > 1e-18:  # the part of an error of the ratio at `top` that is left at `count`
        top += 1
        q = 2 * top + 1
        left *= (x * q / (q * q - 2 * x * x)) ** 2
    ratio = 0.0
    for n in range(top, turn, -1):
        ratio = x / ((2 * n + 1) - x * ratio)
        if n < count:
            j[n] = ratio
    for n in range(turn + 1, count):
        j[n] *= j[n - 1]


def legendre_moments(kappa, theta, moments):
    """Fill `moments` with those of cosines with shifted Legendre polynomials.

    moments : ndarray, shape (2, count)
        ``int_0^1 P_l*(u) cos(kappa u + theta) du`` for ``l < count``, and the same with
        ``theta + pi/2``.
    """
    spherical_bessel(kappa / 2, moments[0])
    middle = kappa / 2 + theta
    c, s = cos(middle), sin(middle)
    for l in range(moments.shape[1]):
        turn = l % 4
        value = c if turn == 0 else -s if turn == 1 else -c if turn == 2 else s
        ahead = -s if turn == 0 else -c if turn == 1 else s if turn == 2 else c
        bessel = moments[0, l]
        moments[0, l], moments[1, l] = bessel * value, bessel * ahead
