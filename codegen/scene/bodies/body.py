"""A body: a linear structure of several degrees of freedom, and the contacts on it, as data."""

import hashlib
import math
import numbers
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt
import sympy as sp

from ..data import a, v, x
from ..error import SceneError, named

#: The force that a contact exerts on the body along its displacement, in N.
force = sp.Symbol("force", real=True)

#: Units of the symbols of a contact, in the order of `Contact.symbols`.
UNITS = ("m", "m/s", "N", "m/s^2")


@dataclass(frozen=True)
class Contact:
    """The symbols of one contact of a body, for laws, events and demands.

    Parameters
    ----------
    name : str
    x, v, a : Symbol
        The displacement ``w^T q``, its velocity and acceleration.
    force : Symbol
        The force on the body along ``w``: ``M q'' + C q' + K q = f cos + w force``.
    """

    name: str
    x: sp.Symbol
    v: sp.Symbol
    a: sp.Symbol
    force: sp.Symbol

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """All of them, in the order of linear forms."""
        return self.x, self.v, self.force, self.a


@dataclass(frozen=True, eq=False)
class Entries:
    """The nonzero entries of a matrix.

    Parameters
    ----------
    shape : (int, int)
    rows, columns : ndarray of int
    values : ndarray of float, or tuple of Expr
        Numbers, or expressions in the parameters.
    """

    shape: tuple[int, int]
    rows: npt.NDArray[np.int64]
    columns: npt.NDArray[np.int64]
    values: Any

    @property
    def is_numeric(self) -> bool:
        """Whether its entries are numbers, without parameters."""
        return isinstance(self.values, np.ndarray)

    @property
    def digest(self) -> str:
        """A hash of shape and entries."""
        numbers = self.values.tobytes() if self.is_numeric else sp.srepr(self.values).encode()
        parts = repr(self.shape).encode(), self.rows.tobytes(), self.columns.tobytes(), numbers
        return hashlib.sha256(b"\0".join(parts)).hexdigest()

    def dense(self) -> npt.NDArray[Any]:
        """Return the matrix as a dense array of numbers or of expressions."""
        matrix = np.zeros(self.shape, dtype=float if self.is_numeric else object)
        matrix[self.rows, self.columns] = self.values
        return matrix


@dataclass(frozen=True, eq=False)
class Body:
    """A linear body: ``M q'' + C q' + K q = forcing * cos(Omega t + phi) + w force``.

    Parameters
    ----------
    M, K : array_like, sparse array or Matrix, shape (n, n)
        Mass in kg and stiffness in N/m, symmetric; M positive definite.  Numbers, or a
        `sympy.Matrix` with the parameters of the scene.
    at : mapping of str to array_like, shape (n,)
        The vector ``w`` of each contact, whose displacement is ``w^T q``.  ``body.at["tip"]``
        has the symbols ``x``, ``v``, ``a`` and ``force`` for laws, events and demands.
    forcing : array_like, shape (n,), optional
        Amplitudes of the force on each degree of freedom in N, all in phase.
    C : array_like, shape (n, n), optional
        Damping in N s/m, of any form; or
    ratio : float or Symbol, optional
        the damping ratio of every mode.  Without both the body is undamped.
    modes : int or Symbol, optional
        Number of modes that are kept, the lowest ones; all by default.

    Raises
    ------
    SceneError
        Naming the argument that is wrong, what was found and what was expected.

    Examples
    --------
    >>> chain = Body(M=[[1, 0], [0, 1]], K=[[2, -1], [-1, 1]], ratio=0.02, at={"end": [0, 1]})
    >>> chain.at["end"].x, chain.size
    (x, 2)
    """

    M: Any
    K: Any
    at: Mapping[str, Any] = field(kw_only=True)
    forcing: Any = field(default=None, kw_only=True)
    C: Any = field(default=None, kw_only=True)
    ratio: Any = field(default=None, kw_only=True)
    modes: Any = field(default=None, kw_only=True)

    #: M, K, C and forcing, if given, and ``at`` with a column for each contact.
    arrays: Mapping[str, Entries] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        arrays: dict[str, Entries] = {}
        size = _size(self.M)
        for name in ("M", "C", "K"):
            if name == "K" or getattr(self, name) is not None:
                arrays[name] = entries(f"body: {name}", getattr(self, name), (size, size))
        if self.C is not None and self.ratio is not None:
            raise SceneError("body: got C and ratio, expected one of them")
        if self.forcing is not None:
            arrays["forcing"] = entries("body: forcing", self.forcing, (size, 1))
            if not len(arrays["forcing"].rows):
                raise SceneError("body: forcing: got only zeros, on no degree of freedom")
        if not isinstance(self.at, Mapping) or not self.at:
            raise SceneError('body: at: expected a mapping {"name": vector}, one at least')
        columns = [entries(f"body: at {name!r}", w, (size, 1)) for name, w in self.at.items()]
        for name, column in zip(self.at, columns, strict=True):
            if not len(column.rows) or not column.is_numeric:
                raise SceneError(f"body: at {name!r}: expected numbers, not all zero")
        arrays["at"] = _beside_each_other(columns)
        contacts = {name: _contact(i, name) for i, name in enumerate(self.at)}
        object.__setattr__(self, "at", contacts)
        object.__setattr__(self, "arrays", arrays)
        object.__setattr__(self, "ratio", _number("ratio", self.ratio, float, 0.0, math.inf))
        object.__setattr__(self, "modes", _number("modes", self.modes, int, 1, size))

    @property
    def size(self) -> int:
        """Degrees of freedom."""
        return self.arrays["M"].shape[0]

    @cached_property
    def symbols(self) -> set[sp.Symbol]:
        """The symbols in its matrices, damping ratio and number of modes."""
        symbols: set[sp.Symbol] = set()
        for values in (q.values for q in self.arrays.values() if not q.is_numeric):
            symbols |= set().union(*(value.free_symbols for value in values))
        return symbols | {q for q in (self.ratio, self.modes) if isinstance(q, sp.Symbol)}


def _size(mass: Any) -> int:
    """Return the number of degrees of freedom of a mass matrix."""
    shape = np.shape(mass if hasattr(mass, "shape") else _array("body: M", mass))
    if len(shape) != 2 or shape[0] != shape[1] or not shape[0]:
        raise SceneError(f"body: M: got {_found(mass, shape)}, expected a square matrix")
    return int(shape[0])


def _found(value: Any, shape: tuple[int, ...]) -> str:
    """Return in words what was given in place of a matrix: its size, or its type."""
    if np.shape(value):
        return f"{' x '.join(map(str, shape))} entries"
    return f"{value!r:.40} of type {type(value).__name__}"


def _array(field_: str, value: Any) -> npt.NDArray[Any]:
    """Return a value as an array; a `SceneError` if its rows differ in length."""
    try:
        return np.asarray(value)
    except ValueError:
        raise SceneError(f"{field_}: expected rows of one length") from None


def entries(field_: str, value: Any, shape: tuple[int, int]) -> Entries:
    """Return the nonzero entries of a matrix or of a vector.

    Raises
    ------
    SceneError
        If the shape is another one, or an entry is neither a finite number nor an expression.
    """
    if hasattr(value, "tocoo"):
        sparse = value.tocoo()
        sparse = sparse.reshape(-1, 1) if len(sparse.shape) < 2 else sparse
        (rows, columns), values, extent = sparse.coords, sparse.data, sparse.shape
    else:
        full = _array(field_, value.tolist() if isinstance(value, sp.MatrixBase) else value)
        full = full.reshape(-1, 1) if full.ndim < 2 else full
        extent = full.shape
        flat = full.reshape(len(full), -1)
        rows, columns = np.nonzero(flat != 0 if flat.dtype == object else flat)
        values = flat[rows, columns]
    if tuple(extent) != shape:
        expected = f"{shape[0]} x {shape[1]}"
        raise SceneError(f"{field_}: got {_found(value, extent)}, expected {expected}")
    places = np.asarray(rows, dtype=np.int64), np.asarray(columns, dtype=np.int64)
    return Entries(shape, *places, _values(field_, np.asarray(values)))


def _values(field_: str, values: npt.NDArray[Any]) -> Any:
    """Return the values of entries as floats, or as expressions if one has a symbol."""
    with named(field_):
        if values.dtype == object:
            expressions = tuple(sp.sympify(value) for value in values)
            if not all(isinstance(value, sp.Expr) for value in expressions):
                raise SceneError("expected numbers or expressions")
            if any(value.free_symbols for value in expressions):
                if any(value.has(sp.I, sp.nan, sp.oo, sp.zoo) for value in expressions):
                    raise SceneError("expected real and finite entries")
                return expressions
            values = np.array([complex(value) for value in expressions])
        if np.iscomplexobj(values) and not values.imag.any():
            values = values.real
        real = np.isrealobj(values) and np.issubdtype(values.dtype, np.number)
        if not real or not np.isfinite(values).all():
            raise SceneError("expected real and finite numbers")
    return np.asarray(values, dtype=float)


def _beside_each_other(columns: list[Entries]) -> Entries:
    """Return columns as one matrix."""
    rows = np.concatenate([q.rows for q in columns])
    places = np.concatenate([np.full(len(q.rows), i) for i, q in enumerate(columns)])
    values = np.concatenate([q.values for q in columns])
    return Entries((columns[0].shape[0], len(columns)), rows, places, values)


def _contact(index: int, name: str) -> Contact:
    """Return the symbols of a contact; the first has those of a scene of one mass."""
    if not (isinstance(name, str) and name.isidentifier()):
        raise SceneError(f"body: at: got {name!r}, expected the name of a contact")
    if index == 0:
        return Contact(name, x, v, a, force)
    return Contact(name, *(sp.Symbol(f"{q}_{name}", real=True) for q in (x, v, a, force)))


def _number(name: str, value: Any, kind: type, least: float, most: float) -> Any:
    """Return the number of modes, or the damping ratio, as a number of a kind; or a symbol."""
    if value is None or isinstance(value, sp.Symbol):
        return value
    if isinstance(value, numbers.Real) and not isinstance(value, bool):
        number: float = kind(value) if math.isfinite(value) else math.nan
        if least <= number <= most and (kind is float or number == value):
            return number
    what = "a number not below 0" if name == "ratio" else f"a whole number, 1 to {most}"
    raise SceneError(f"body: {name}: got {value!r:.40}, expected {what}, or a parameter")
