"""The motion of the contacts of a body and its derivatives: exact or by an expansion."""

from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..arrays import Complex, Matrix, Vector
from . import exact
from .force_series import series
from .force_series.integrals import answers
from .force_series.layout import Layout, for_harmonics, layout, setting
from .harmonics import system as harmonics
from .laws import places
from .part import angles_of, generator_of, kept_by_times, parts_of
from .poles import Forms

if TYPE_CHECKING:
    from ..scenes.bodies.cell import BodyCell

#: The places of the first contact's displacement, velocity and acceleration in a form.
VARIABLES = 0, 1, places(1)[3][0]


class Given(NamedTuple):
    """First argument of a kernel's functions.

    Parameters
    ----------
    cell : BodyCell
    order : int
        N; 0 for the exact equations.
    functions : int, optional
        Number of functions added to the harmonics at each switch; None for the force series.
    """

    cell: "BodyCell"
    order: int
    functions: int | None = None


def signals(given: Given, times: Vector, p: int, u: Vector) -> Matrix:
    """Return the variables of forms on phase `p`, at local times in [0, 1].

    Shape (S, len(u)); the forces are by their laws.
    """
    cell, u = given.cell, np.asarray(u, dtype=float)
    if given.order == 0:
        rows = parts_of(cell)[p].lawful.rows
        count = len(rows) - len(cell.memory)
        return exact.seen(cell, times, p, u, rows[:count])
    return _seen(given, times, p, u, _layout(given).phases[p].seen)


def derivative(given: Given, times: Vector, p: int, u: Vector, number: int) -> Vector:
    """Return a derivative of the first contact's displacement by time on phase `p`.

    Beyond the second, derivatives of the forces are by their laws as well.
    """
    cell, u, variable = given.cell, np.asarray(u, dtype=float), VARIABLES[min(number, 2)]
    if given.order:
        layout_ = _layout(given)
        forms = layout_.phases[p].seen.some([variable])
        for _ in range(number - 2):
            forms = layout_.poles.rate(forms, layout_.phases[p].force)
        return np.asarray(_seen(given, times, p, u, forms)[0])
    part = parts_of(cell)[p]
    row = part.lawful.rows[variable]
    for _ in range(number - 2):
        row = row @ generator_of(part, cell.omega)
    return np.asarray(exact.seen(cell, times, p, u, row[None])[0])


def _layout(given: Given) -> Layout:
    cell, order, functions = given
    return layout(cell, order) if functions is None else for_harmonics(cell)


def _seen(given: Given, times: Vector, p: int, u: Vector, forms: Forms) -> Matrix:
    """Return forms of poles, forcing and memory at local times of a phase."""
    cell, order, functions = given
    theta = angles_of(cell, times)[p] + cell.omega * float(times[p]) * u
    fixed = forms.at(theta, memory_of(given, times))
    if functions is None:
        return fixed + _along(cell, order, times, p, u, forms.poles)
    z = harmonics.along(harmonics.evaluated(cell, order, functions, times), p, u)
    return np.asarray(fixed + (forms.poles @ z).real)


def memory_of(given: Given, times: Vector) -> Vector:
    """Return the memories of a cell, by the force series or harmonics."""
    cell, order, functions = given
    if not cell.memory:
        return np.empty(0)
    if functions is None:
        return solved(cell, order, times)[0][layout(cell, order).memory]
    evaluation = harmonics.evaluated(cell, order, functions, times)
    return np.asarray(evaluation.unknowns[evaluation.frame.memory].real)


def _along(
    cell: "BodyCell", order: int, times: Vector, p: int, u: Vector, forms: Complex
) -> Matrix:
    """Return ``Re(forms @ z)`` at local times of a phase; shape (len(forms), len(u))."""
    layout_ = layout(cell, order)
    pieces, s = layout_.phases[p].pieces, float(times[p]) / layout_.phases[p].pieces
    answer = _answers(cell, order, p, times)
    which = np.minimum((u * pieces).astype(int), pieces - 1)
    values = np.empty((len(forms), len(u)))
    for piece in np.unique(which):
        inside, (E, B) = which == piece, answer[piece]
        w = u[inside] * pieces - piece
        basis = _polynomials(w.tobytes(), B.shape[1] - 1)
        free = (forms * E) @ np.exp(layout_.poles.s[:, None] * s * w)
        values[:, inside] = free.real + (forms @ B).real @ basis.T
    return values


@lru_cache(maxsize=32)
def _polynomials(w: bytes, degree: int) -> Matrix:
    """Return Legendre polynomials on [0, 1]; kept, as motions share their points."""
    return np.asarray(np.polynomial.legendre.legvander(2 * np.frombuffer(w) - 1, degree))


@kept_by_times(64)
def _answers(
    cell: "BodyCell", order: int, p: int, times: Vector
) -> tuple[tuple[Complex, Complex], ...]:
    """Return z on each piece of a phase as ``E e^(kappa u) + sum B_m P_m*(u)``."""
    layout_, (unknowns, states) = layout(cell, order), solved(cell, order, times)
    phase, poles = layout_.phases[p], layout_.poles
    s, first = float(times[p]) / phase.pieces, layout_.first_of(p)
    pieces = []
    for e in range(first, first + phase.pieces):
        at, count = layout_.pieces[e, 1], (phase.degree + 1) * poles.b.shape[1]
        l = unknowns[at : at + count].reshape(phase.degree + 1, -1)
        E, B = answers(poles.s * s, l @ poles.b.T)
        pieces.append((states[e] + s * E, s * B.T))
    return tuple(pieces)


@kept_by_times(8)
def solved(cell: "BodyCell", order: int, times: Vector) -> tuple[Vector, Complex]:
    """Return the unknowns of the force series at given times, and z where pieces begin.

    Coefficients of forces by piece, degree and contact, impulses, memory; shape (U,), and
    (E, m).
    """
    _, _, (_, unknowns), _, (_, starts) = series.linear(setting(cell, order), times)
    return unknowns, unknowns @ starts
