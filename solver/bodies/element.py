"""The pieces of a cell in the force series, with the integrals of each."""

from dataclasses import dataclass, replace

import numpy as np

from ..arrays import Vector
from .integrals import moment_rates, moments, responses
from .layout import Layout, Phase
from .modal import Complex
from .poles import Poles


@dataclass(frozen=True, eq=False)
class Element:
    """One piece of a phase and its integrals.

    Parameters
    ----------
    phase : Phase
    duration : float
    columns : slice
        Its coefficients among the unknowns.
    a, a_rate : ndarray of complex, shape (m, N + 1)
        ``a_n`` of each pole, and its derivative by kappa.
    Z : ndarray of complex, shape (m, N + 2, N + 2)
        One row and one column more than the equations take: rates are by these.
    turn, turn_rate : ndarray of complex, shape (N + 1,)
        ``a_n`` of the forcing.
    decay : ndarray of complex, shape (m,)
        ``e^kappa``.
    gain, gain_rate : ndarray of complex, shape (m, columns)
        What coefficients add to z, and its derivative by the duration.
    """

    phase: Phase
    duration: float
    columns: slice
    a: Complex
    a_rate: Complex
    Z: Complex
    turn: Complex
    turn_rate: Complex
    decay: Complex
    gain: Complex
    gain_rate: Complex


def _element(phase: Phase, poles: Poles, s: float) -> Element:
    """Return a piece of a phase that lasts `s`; its columns are those of the first."""
    count = phase.degree + 1
    kappa = poles.s * s
    found = moments(np.append(kappa, 1j * poles.omega * s), count + 1)
    a, turn, Z = found[:-1], found[-1], responses(kappa, count + 1)
    signs = (-1.0) ** np.arange(count)
    a_rate = moment_rates(a)
    slope = a[:, :count] + kappa[:, None] * a_rate
    return Element(
        phase, s, slice(0), a[:, :count], a_rate, Z, turn[:count], moment_rates(turn),
        np.exp(kappa), _spread(s * signs * a[:, :count], poles.b),
        _spread(signs * slope, poles.b),
    )  # fmt: skip


def _spread(by_degree: Complex, b: Complex) -> Complex:
    """Return columns of coefficients, by degree and contact, from those of each."""
    return np.asarray(by_degree[:, :, None] * b[:, None, :]).reshape(len(b), -1)


def elements_of(
    own: Layout, times: Vector, theta: Vector, omega: float
) -> tuple[list[Element], Vector]:
    """Return the pieces, and the angle of the forcing where each begins."""
    made: dict[int, Element] = {}
    found: list[Element] = []
    begins, contacts = [], own.poles.b.shape[1]
    for p, at in own.elements:
        phase = own.phases[p]
        s = float(times[p]) / phase.pieces
        piece = sum(q == p for q, _ in own.elements[: len(found)])
        if p not in made:
            made[p] = _element(phase, own.poles, s)
        columns = slice(at, at + (phase.degree + 1) * contacts)
        found.append(replace(made[p], columns=columns))
        begins.append(theta[p] + omega * s * piece)
    return found, np.array(begins)
