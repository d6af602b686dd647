"""Roots of many functions at once, each in its own bracket (Chandrupatla's method)."""

from collections.abc import Callable

import numpy as np

from ...arrays import Vector

#: Steps: bisection alone takes a thousand to the least float, this some ten.
STEPS = 1200

EPS = float(np.finfo(float).eps)


def bracketed(function: Callable[[Vector], Vector], end: Vector) -> Vector:
    """Return a root between 0 and each `end`, to a rounding error of itself.

    Parameters
    ----------
    function : callable
        Takes a point a root, shape (n,), and returns the values there: of different signs at
        0 and at the end; a value of 0 is a root.
    end : ndarray, shape (n,)
        The root itself where rounding has left the sign there that is at 0.

    Notes
    -----
    T. R. Chandrupatla, Adv. Eng. Software 28 (1997) 145-149: inverse quadratic interpolation
    where three points are fit for it, else bisection.
    """
    a, b = end.copy(), np.zeros_like(end)
    fa, fb = function(a), function(b)
    t = np.full(a.shape, 0.5)
    found, sought = np.where(fb == 0, b, a), np.sign(fa) * np.sign(fb) < 0
    for _ in range(STEPS):
        if not sought.any():
            break
        new = a + t * (b - a)
        f_new = function(new)
        same = np.sign(f_new) == np.sign(fa)
        c, fc = np.where(same, a, b), np.where(same, fa, fb)
        b, fb = np.where(same, b, a), np.where(same, fb, fa)
        a, fa = new, f_new
        best = np.where(np.abs(fa) < np.abs(fb), a, b)
        width = np.abs(b - a)
        found = np.where(sought, best, found)
        sought = sought & (width > 2 * EPS * np.abs(best)) & (fa != 0)
        room = EPS * np.abs(best) / np.where(width > 0, width, 1.0)
        t = _next(a, b, c, fa, fb, fc, np.minimum(room, 0.5))
    return found


def _next(
    a: Vector, b: Vector, c: Vector, fa: Vector, fb: Vector, fc: Vector, room: Vector
) -> Vector:
    """Return where between `a` and `b` the next points are."""
    with np.errstate(all="ignore"):
        xi, phi = (a - b) / (c - b), (fa - fb) / (fc - fb)
        fit = (phi**2 < xi) & ((1 - phi) ** 2 < 1 - xi)
        t = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (
            fc - fb
        )
    t = np.where(fit & np.isfinite(t), t, 0.5)
    return np.clip(t, room, 1 - room)
