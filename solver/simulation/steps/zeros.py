"""The first zero of a polynomial on [0, 1], by its Bernstein coefficients.

Where all of them are positive there is no zero: the polynomial lies in their convex hull.
Otherwise the interval is bisected, the left half first.  Nothing is sampled, so no zero is
missed.
"""

from math import inf

#: A polynomial of degree 6: coefficients of its powers, or Bernstein coefficients.
Polynomial = tuple[float, float, float, float, float, float, float]

#: Width at which the bisection of an interval that may hold the first zero ends.
NARROW = 2.0**-24

#: Newton corrections after the bisection.
STEPS = 4


def first_zero(powers: Polynomial) -> float:
    """Return the first zero on (0, 1] of a polynomial that is positive at 0; inf if none.

    `powers` are its coefficients, constant first.  The value is not above the first zero, and
    as near to it as Newton's method comes.

    Examples
    --------
    >>> round(first_zero((1.0, -4.0, 3.0, 0.0, 0.0, 0.0, 0.0)), 12)
    0.333333333333
    >>> first_zero((1.0, -2.0, 1.001, 0.0, 0.0, 0.0, 0.0))
    inf
    """
    row, start, width = bernstein(powers), 0.0, 1.0
    waiting: list[tuple[Polynomial, float, float]] = []
    while True:
        if min(row) > 0:
            if len(waiting) == 0:
                return inf
            row, start, width = waiting.pop()
        elif width <= NARROW:
            return _polished(powers, start, width)
        else:
            row, right = halves(row)
            width = width / 2
            waiting.append((right, start + width, width))


def bernstein(powers: Polynomial) -> Polynomial:
    """Return the Bernstein coefficients of a polynomial on [0, 1]."""
    a, b, c, d, e, f, g = powers  # over binomials; `halves` forms their sums
    (a, b, c, d, e, f, g), _ = halves((a, b / 6, c / 15, d / 20, e / 15, f / 6, g))
    return a, 2 * b, 4 * c, 8 * d, 16 * e, 32 * f, 64 * g


def halves(row: Polynomial) -> tuple[Polynomial, Polynomial]:
    """Return the Bernstein coefficients on both halves of an interval, after de Casteljau."""
    a0, a1, a2, a3, a4, a5, a6 = row
    b0, b1, b2 = (a0 + a1) / 2, (a1 + a2) / 2, (a2 + a3) / 2
    b3, b4, b5 = (a3 + a4) / 2, (a4 + a5) / 2, (a5 + a6) / 2
    c0, c1, c2 = (b0 + b1) / 2, (b1 + b2) / 2, (b2 + b3) / 2
    c3, c4 = (b3 + b4) / 2, (b4 + b5) / 2
    d0, d1, d2, d3 = (c0 + c1) / 2, (c1 + c2) / 2, (c2 + c3) / 2, (c3 + c4) / 2
    e0, e1, e2 = (d0 + d1) / 2, (d1 + d2) / 2, (d2 + d3) / 2
    f0, f1 = (e0 + e1) / 2, (e1 + e2) / 2
    middle = (f0 + f1) / 2
    return (a0, b0, c0, d0, e0, f0, middle), (middle, f1, e2, d3, c4, b5, a6)


def _polished(powers: Polynomial, start: float, width: float) -> float:
    """Return the zero in a short interval, or its start where the polynomial only touches."""
    u = start
    for _ in range(STEPS):
        value, rate = _value(powers, u), _slope(powers, u)
        if not rate < 0 < value:
            break
        moved = u + value / -rate
        if moved > start + 2 * width:
            break
        below = _value(powers, moved)
        if below < 0:  # too far, the arc is concave: its chord is below it
            moved = u + (moved - u) * value / (value - below)
        u = moved
    return u


def _value(powers: Polynomial, u: float) -> float:
    a, b, c, d, e, f, g = powers
    return a + u * (b + u * (c + u * (d + u * (e + u * (f + u * g)))))


def _slope(powers: Polynomial, u: float) -> float:
    _, b, c, d, e, f, g = powers
    return _value((b, 2 * c, 3 * d, 4 * e, 5 * f, 6 * g, 0.0), u)
