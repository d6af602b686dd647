"""Follow the solutions of 3.2 from one alpha to another, round their folds.

With fewer than about ``2 T / (T - t1)`` harmonics the solutions of 3.2 fold back in alpha:
at N = 40 there are three between alpha = 29.3 and 59.95, and only one beyond.  Along the
curve t1 only grows, at every order tried.  So t1 is what is stepped here, and alpha what is
found: it stands in (9) alone, and linearly.  The other equations determine the motion with a
stick of that duration, and (9) then says for which alpha it is one.
"""

import math

import numpy as np

from ...arrays import Vector
from .kernels import Kernel

#: Largest and smallest factor between two values of t1: the folds are to be seen.
LONGEST_STRIDE, SHORTEST_STRIDE = 1.1, 1.0001

#: Iterations after which the way is given up, and how far from alpha = 1 they lead, either way.
MOST_ITERATIONS, FARTHEST = 400, 1000.0

#: Corrections, as a part of the unknowns, that are small enough to go on; most of them; and
#: how much each is to be smaller than the one before.
SMALL, MOST_CORRECTIONS, CONTRACTION = 1e-6, 10, 0.5

#: Most that the duration of slip may change in a stride: beyond, it is another curve.
SAME_CURVE = 0.1


def follow(kernel: Kernel, terms: int, z: Vector, alpha: float) -> tuple[Vector, int]:
    """Return a motion near the solution for `alpha`, as a start, and the iterations it took.

    Parameters
    ----------
    kernel : Kernel
        ``"hb-symmetric"``.
    terms : int
        Number of C1 functions.
    z : ndarray, shape (order + terms + 2,)
        A solution for some other alpha.
    alpha : float
        Where to go.

    Returns
    -------
    z : ndarray, shape (order + terms + 2,)
        All equations but (9) hold for it, and (9) nearly; where the way ends before `alpha`,
        the motion at its end.
    iterations : int
    """
    towards = math.copysign(1.0, alpha - alpha_of(kernel, terms, z))
    stride, iterations, passed = LONGEST_STRIDE, 0, False
    while stride > SHORTEST_STRIDE and iterations < MOST_ITERATIONS:
        ahead, spent = with_stick(kernel, terms, z, z[-2] * stride**towards)
        iterations += spent
        beyond = ahead is not None and towards * (alpha_of(kernel, terms, ahead) - alpha) > 0
        passed = passed or beyond
        if ahead is None or beyond:
            stride = math.sqrt(stride)
            continue
        z = ahead
        if not passed:
            stride = min(LONGEST_STRIDE, stride**1.5)
    return z, iterations


def alpha_of(kernel: Kernel, terms: int, z: Vector) -> float:
    """Return the alpha for which `z` fulfils (9)."""
    initial_state = kernel.functions["initial_state"]
    R = np.empty(len(z))
    kernel.residual((0.0, terms), z, R)
    slope = initial_state(1.0)[0] - initial_state(0.0)[0]
    return float(-R[-2] / slope)


def with_stick(
    kernel: Kernel, terms: int, near: Vector, t1: float
) -> tuple[Vector | None, int]:
    """Return the solution of all equations but (9) whose stick lasts `t1`, and iterations.

    Parameters
    ----------
    kernel, terms : Kernel, int
        As for `follow`.
    near : ndarray, shape (order + terms + 2,)
        A solution for another `t1`; slip is taken to last as long.
    t1 : float
        In ``1/omega_n``.

    Returns
    -------
    z : ndarray of the shape of `near`, or None
        None where the corrections do not contract, or slip changes too much.
    iterations : int
    """
    z, n = near.copy(), len(near)
    slip = near[-1] - near[-2]
    z[-2:] = t1, t1 + slip
    R, J, rest = np.empty(n), np.empty((n, n)), np.arange(n) != n - 2
    previous = np.inf
    for iteration in range(1, MOST_CORRECTIONS + 1):
        kernel.residual((0.0, terms), z, R)
        kernel.jacobian((0.0, terms), z, J)
        try:
            step = np.linalg.solve(J[rest][:, rest], -R[rest])
        except np.linalg.LinAlgError:
            return None, iteration
        length = max(abs(step[-1] / z[-1]), np.abs(step[:-1]).max() / np.abs(z[:-2]).max())
        if not length <= CONTRACTION * previous:
            return None, iteration
        z[rest] += step
        if abs((z[-1] - t1) / slip - 1) > SAME_CURVE:
            return None, iteration
        if length <= SMALL:
            return z, iteration
        previous = length
    return None, MOST_CORRECTIONS
