"""Products of sines with the slip phase, by fast sine transforms.

``sum_n b_n (C_{j-n} - C_{j+n})/2`` is a convolution: the series, times what is 1 in slip
and 0 in stick, expanded again.  On a grid of more than ``4 N`` points a period it is a sine
transform, a product point by point and a sine transform back, with no error but rounding.
"""

import numpy as np
import scipy  # its parts are loaded where they are used

from ...arrays import Vector


def grid_size(N: int) -> int:
    """Return the points in half of a period, ends not counted: enough, and quick."""
    return int(scipy.fft.next_fast_len(2 * N, real=True)) - 1


def symbol(C: Vector, points: int) -> Vector:
    """Return the transform of ``C_0..C_2N``: slip, as ``2 N`` harmonics see it, on the grid."""
    padded = np.zeros(points + 2)
    padded[: len(C)] = C
    return np.asarray(scipy.fft.dct(padded, type=1)[1:-1])


def on_grid(b: Vector, points: int) -> Vector:
    """Return twice ``sum b_n sin(n pi m/(points + 1))`` for ``m = 1..points``."""
    return np.asarray(scipy.fft.dst(b, type=1, n=points))


def from_grid(values: Vector, N: int) -> Vector:
    """Return half of the first `N` coefficients of a function given by `on_grid`."""
    return np.asarray(scipy.fft.idst(values, type=1)[:N] / 2)
