"""Roots of many functions at once, each in its own bracket (Chandrupatla's method)."""

from collections.abc import Callable

import numpy as np

from ...arrays import Vector

#: Most steps; about ten are usual, bisection to the least float takes a thousand.
STEPS = 1200

EPS = float(np.finfo(float).eps)


def bracketed(function: Callable[[Vector], Vector], end: Vector) -> Vector:
    """Return a root between 0 and each `end`, to a relative rounding error.

    Parameters
    ----------
    function : callable
        Takes a point for each root, shape (n,), and returns the values there, which differ in
        sign at 0 and at the end.
    end : ndarray, shape (n,)
        Other ends of the brackets; returned themselves if rounding has left no change of sign.

    Notes
    -----
    T. R. Chandrupatla, Adv. Eng. Software 28 (1997) 145-149: inverse quadratic interpolation
    if three points allow it, else bisection.
    """
    a, b = end.copy(), np.zeros_like(end)
    fa, fb = function(a), function(b)
    t = np.full(a.shape, 0.5)
    roots, active = np.where(fb == 0, b, a), np.sign(fa) * np.sign(fb) < 0
    for _ in range(STEPS):
        if not active.any():
            break
        new = a + t * (b - a)
        f_new = function(new)
        same = np.sign(f_new) == np.sign(fa)
        c, fc = np.where(same, a, b), np.where(same, fa, fb)
        b, fb = np.where(same, b, a), np.where(same, fb, fa)
        a, fa = new, f_new
        best = np.where(np.abs(fa) < np.abs(fb), a, b)
        width = np.abs(b - a)
        roots = np.where(active, best, roots)
        active = active & (width > 2 * EPS * np.abs(best)) & (fa != 0)
        room = EPS * np.abs(best) / np.where(width > 0, width, 1.0)
        t = _next(a, b, c, fa, fb, fc, np.minimum(room, 0.5))
    return roots


def _next(
    a: Vector, b: Vector, c: Vector, fa: Vector, fb: Vector, fc: Vector, room: Vector
) -> Vector:
    """Return the parameter t of the next points ``a + t (b - a)``."""
    with np.errstate(all="ignore"):
        xi, phi = (a - b) / (c - b), (fa - fb) / (fc - fb)
        fit = (phi**2 < xi) & ((1 - phi) ** 2 < 1 - xi)
        t = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (
            fc - fb
        )
    t = np.where(fit & np.isfinite(t), t, 0.5)
    return np.clip(t, room, 1 - room)
