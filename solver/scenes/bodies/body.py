"""The body of a case: its matrices in units, and its modes."""

import io
import math
from collections.abc import Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from ...arrays import Matrix
from ...bodies.modal import Modal, at_frequency, damped, modal
from ...bodies.poles import poles_of
from ...bodies.systems import BodyError
from ..dimensionless import Units
from ..parameter_error import ParameterError

if TYPE_CHECKING:
    from ..loaded import LoadedScene

#: The file of a body's matrices, in the folder of its scene.
MATRICES = "body.npz"

#: Difference of two entries of a symmetric matrix, relative to the largest, that is rounding.
ROUNDING = 1e-12

#: The least k of a scene whose contact forces do not jump.
CONTINUOUS = 2

#: Entries of matrices: the name of the matrix, row, column and value of each; of one matrix
#: without its name.
Entries: TypeAlias = tuple[tuple[Any, ...], ...]


@lru_cache(maxsize=64)
def body_of(
    scene: "LoadedScene", values: tuple[float, ...], units: Units, frequency: float
) -> Modal:
    """Return the body in the units of a case, for parameters in SI units.

    Its modes are computed in units that are powers of two, which change no digit of its
    matrices.
    """
    binary = Units(*(2.0 ** round(math.log2(unit)) for unit in vars(units).values()))
    try:
        ratio, modes, entries = _in_numbers(scene, values)
        if modes is not None and (modes != int(modes) or modes < 1):
            raise BodyError(f"modes: got {modes!r}, expected a whole number from 1")
        matrices = _matrices(scene, entries, binary)
        count = None if modes is None else int(modes)
        body = damped(_modes(scene, entries, binary, count), ratio)
        omega = frequency * binary.time / units.time
        body = at_frequency(body, matrices, omega, count)
        ratios = (
            a / b for a, b in zip(*(vars(q).values() for q in (units, binary)), strict=True)
        )
        body = body.in_units(*ratios)
        poles_of(body, frequency)
        return body
    except BodyError as error:
        raise ParameterError([f"body: {error}"]) from None


def _in_numbers(scene: "LoadedScene", values: tuple[float, ...]) -> tuple[Any, Any, Entries]:
    """Return damping ratio, modes and entries of matrices for parameters in SI units."""
    try:
        ratio, modes = scene.numbers("modal", values)
        entries = tuple((*place, float(q)) for *place, q in scene.numbers("entries", values))
    except (ArithmeticError, ValueError, TypeError) as error:
        raise BodyError(f"an entry is no number with these parameters ({error})") from None
    for name, i, j, value in entries:
        if not math.isfinite(value):
            raise BodyError(f"{name}[{i}, {j}]: got {value}, expected a finite number")
    return ratio, modes, entries


def _check_matrix(name: str, matrix: Matrix) -> None:
    """Check a matrix with parameters in it, of which the scene has checked the defaults."""
    asymmetry = float(np.abs(matrix - matrix.T).max())
    if asymmetry > ROUNDING * np.abs(matrix).max():
        raise BodyError(f"{name}: it is not symmetric with these parameters")
    try:
        if name == "M":
            np.linalg.cholesky(matrix)
    except np.linalg.LinAlgError:
        raise BodyError("M: it is not positive definite with these parameters") from None


@lru_cache(maxsize=16)
def _modes(scene: "LoadedScene", entries: Entries, units: Units, modes: int | None) -> Modal:
    """Return the body in modal coordinates, without forcing frequency and damping ratio.

    A memory, or a force that may jump, excludes a massless compliance at the contact.
    """
    matrices = _matrices(scene, entries, units)
    size = matrices["M"].shape[0]
    if modes is not None and modes > size:
        raise BodyError(f"modes: got {modes:g}, more than the {size} degrees of freedom")
    jumps = scene.module.CLASS < CONTINUOUS  # whatever the order of the phases
    return modal(matrices, modes, 1.0, jumps or bool(scene.module.MEMORY))


@lru_cache(maxsize=8)
def matrices_of(scene: "LoadedScene") -> Mapping[str, Any]:
    """Return the arrays of a body's file: shape of each matrix and, if numeric, its entries."""
    content = None if scene.kept is None else scene.kept[MATRICES]
    with np.load(scene.folder / MATRICES if content is None else io.BytesIO(content)) as file:
        return dict(file)


def _matrices(scene: "LoadedScene", entries: Entries, units: Units) -> dict[str, Any]:
    """Return the matrices of a body as sparse arrays, in given units."""
    names = (q.removesuffix("_shape") for q in matrices_of(scene) if q.endswith("_shape"))
    return {
        name: _matrix(scene, name, tuple(q[1:] for q in entries if q[0] == name), units)
        for name in names
    }


@lru_cache(maxsize=12)
def _matrix(scene: "LoadedScene", name: str, entries: Entries, units: Units) -> Any:
    """Return one of the matrices of a body, with its entries if they have parameters."""
    from scipy import sparse  # noqa: PLC0415  (a scene of one mass needs none)

    sizes = {
        "M": units.mass,
        "C": units.mass / units.time,
        "K": units.mass / units.time**2,
        "forcing": units.mass * units.length / units.time**2,
        "at": 1.0,
    }
    file = matrices_of(scene)
    if entries:
        rows, columns, numbers = map(np.array, zip(*entries, strict=True))
    else:
        rows, columns, numbers = (file[q] for q in (f"{name}_rows", f"{name}_columns", name))
    scaled = np.asarray(numbers, dtype=float) / sizes[name]
    shape = tuple(map(int, file[f"{name}_shape"]))
    matrix = sparse.csc_array((scaled, (rows, columns)), shape=shape)
    if entries and name in ("M", "K"):
        _check_matrix(name, matrix.toarray())
    return matrix
