"""Bounds on eigenvalues from both sides, without the exact solution.

The receptance of all modes is that of the sines and a tail. Gauss quadrature, which is what
forced modes are, gives a tail that is too small; Gauss-Radau quadrature with a node at the
first mode left out gives one that is too large, as long as ``lambda < mu_(N+1)``. So
eigenvalues of Ritz and Ritz with forced modes lie above the exact ones, and those with the
Radau tail below.  Each bound is widened by what rounding may have done.
"""

from dataclasses import replace

import numpy as np
from scipy.linalg import LinAlgError, eigh

from ...arrays import Vector
from ..attached import Attached
from ..expansions.bare import BareModes, ritz
from ..expansions.sums import left_out
from . import secular
from .secular import Roots


def above(roots: Roots) -> Vector:
    """Return upper bounds from Ritz values, which lie above the exact ones."""
    return roots.values + roots.rounding


def below(attached: Attached, N: int, K: int, count: int) -> Vector:
    """Return lower bounds of the lowest eigenvalues, from N sines and K forced modes.

    They are NaN where nothing is proved: beyond ``mu_(N+1)``, and for a compliance without
    forced modes.
    """
    bounds = np.full(count, np.nan)
    bare = _with_radau_tail(attached, N, K)
    if bare is None:
        return bounds
    roots = secular.eigenvalues(bare, attached, count)
    low = roots.values - roots.rounding
    valid = (roots.values < attached.bare(np.array([N + 1]))[0]) & (low > 0)
    bounds[: len(valid)][valid] = low[valid]
    return bounds


def _with_radau_tail(attached: Attached, N: int, K: int) -> BareModes | None:
    """Return modes with a receptance no smaller than the exact one; None if rounding wins."""
    sines = ritz(attached, N)
    compliant = attached.structure.kind == "compliance"
    if compliant and K == 0:
        return None
    free = K - compliant
    next_bare = float(attached.bare(np.array([N + 1]))[0])
    count = 2 * free + 1
    tail = left_out(attached, N, count + compliant)
    moments = tail.sums[int(compliant) :] * next_bare ** np.arange(float(count))
    try:
        nodes, weights = _radau(moments)
    except LinAlgError:
        return None
    if not (np.isfinite(weights).all() and (weights >= 0).all() and (nodes > 0).all()):
        return None
    poles = next_bare / nodes
    felt = attached.felt(np.arange(1, N + 1))
    felt = felt / sines.eigenvalues if compliant else felt
    return replace(
        sines,
        eigenvalues=np.append(sines.eigenvalues, poles),
        felt=np.append(felt, np.sqrt(weights * poles)),
        static_rest=0.0,
        hinge_rest=tail.sums[0] - float(weights @ poles) if compliant else 0.0,
        off=tail.error,
        inexact=np.ones(N + len(poles)),
    )


def _radau(moments: Vector) -> tuple[Vector, Vector]:
    """Return nodes, descending, and weights of Gauss-Radau quadrature on [0, 1], a node at 1.

    `moments`, shape (2 n + 1,) for n free nodes, are the integrals of 1, x, ... by the measure.
    """
    n = (len(moments) - 1) // 2
    if n == 0:
        return np.ones(1), moments[:1].copy()
    reduced = moments[:-1] - moments[1:]  # of the measure times 1 - x
    index = np.arange(n)[:, None] + np.arange(n)[None, :]
    theta, vectors = eigh(reduced[index + 1], reduced[index])
    weights = (reduced[:n] @ vectors) ** 2 / (1 - theta)
    return np.append(1.0, theta[::-1]), np.append(moments[0] - weights.sum(), weights[::-1])
