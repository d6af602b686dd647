"""Types of the arrays that cross module borders."""

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
