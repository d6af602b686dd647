"""The motion on a phase whose acceleration is a series of shifted Legendre polynomials."""

import numpy as np
from numpy.polynomial import legendre


def rising(x, k):
    """Return ``x (x + 1) ... (x + k - 1)``."""
    found = 1.0
    for i in range(k):
        found = found * (x + i)
    return found


def integrated(d):
    """Return the series of shifted Legendre polynomials that is the integral of one from 0."""
    found, half = np.zeros(len(d) + 1), d / (4 * np.arange(len(d)) + 2)
    found[1:] += half
    found[:-2] -= half[1:]
    found[0] += half[0]
    return found


def phase_motion(x, v, d, s, u, derivative):
    """Return displacement, velocity or acceleration on a phase.

    Parameters
    ----------
    x, v : float
        The state in which the phase begins.
    d : ndarray
        Coefficients of the acceleration; empty where there is none.
    s : float
        Duration of the phase.
    u : ndarray
        Local time, from 0 to 1.
    derivative : {0, 1, 2}
    """
    parts = d if len(d) else np.zeros(1)
    w = 2 * np.asarray(u) - 1
    if derivative == 2:
        return legendre.legval(w, parts)
    if derivative == 1:
        return v + s * legendre.legval(w, integrated(parts))
    twice = legendre.legval(w, integrated(integrated(parts)))
    return x + s * v * np.asarray(u) + s * s * twice
