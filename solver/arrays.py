"""Types of the arrays that cross module borders, and arrays of what users give."""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

#: One-dimensional array of float64.
Vector: TypeAlias = npt.NDArray[np.float64]

#: Indices of entries, or which of them are meant.
Indices: TypeAlias = npt.NDArray[np.intp] | npt.NDArray[np.bool_]

#: Array of int64, of any shape.
Integers: TypeAlias = npt.NDArray[np.int64]

#: Two-dimensional array of float64.
Matrix: TypeAlias = npt.NDArray[np.float64]

#: Array of complex numbers, of any shape.
Complex: TypeAlias = npt.NDArray[np.complex128]


def real_numbers(values: npt.ArrayLike) -> npt.NDArray[np.float64]:
    """Return values as an array of floats; if they are no real numbers, a single NaN.

    Examples
    --------
    >>> real_numbers([0, 1.5]), real_numbers("a")
    (array([0. , 1.5]), array(nan))
    """
    try:
        return np.asarray(values if np.isrealobj(values) else np.nan, dtype=float)
    except (TypeError, ValueError):
        return np.array(np.nan)
