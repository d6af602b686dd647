"""The responses of the poles of a body to impulses and to forces with a break at a switch."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from ...arrays import Complex, Matrix, Vector
from ...rows.breaking import break_series
from ..force_series.integrals import answers, moments
from ..poles import Poles


class Break(NamedTuple):
    """A force with a break, or an impulse.

    Parameters
    ----------
    switch : int
        The phase at whose start it is; the number of phases for the end of the cell.
    n : int
        The index of ``beta_n``, whose derivative of order n - 1 jumps by 1; 0 for an impulse.
    contact : int
    """

    switch: int
    n: int
    contact: int


@dataclass(frozen=True, eq=False)
class Answer:
    """The responses of the poles to breaks, on one phase; times are relative to the cell.

    Parameters
    ----------
    begin, length : float
        Start and duration of the phase.
    E : ndarray of complex, shape (m, B)
    polynomials : ndarray of complex, shape (m, B, R)
        ``z = E e^(kappa w) + sum polynomials P_r*(age)`` at the time w from `begin`; the age
        is the time since the break.
    ages : ndarray, shape (B,)
        The age of each break at `begin`.
    series : ndarray, shape (B, n)
        The Legendre coefficients of the forces on the phase.
    forced : ndarray of complex, shape (m, B)
        ``z' = kappa z + forced force``.
    kappa : ndarray of complex, shape (m,)
        The poles, times the duration of the cell.
    """

    begin: float
    length: float
    E: Complex
    polynomials: Complex
    ages: Vector
    series: Matrix
    forced: Complex
    kappa: Complex

    def at(self, w: Vector) -> Complex:
        """Return z at times from the start of the phase; shape (B, m, len(w))."""
        z = self.E.T[:, :, None] * np.exp(self.kappa[:, None] * w)
        age, degree = self.ages[:, None] + w, self.polynomials.shape[2] - 1
        basis = np.polynomial.legendre.legvander(2 * age - 1, degree)
        return np.asarray(z + self.polynomials.swapaxes(0, 1) @ basis.swapaxes(1, 2))

    @cached_property
    def ends(self) -> tuple[Complex, Complex]:
        """The values of z at the start and the end of the phase; shape (m, B) each."""
        values = self.at(np.array([0.0, self.length]))
        return values[:, :, 0].T, values[:, :, 1].T

    def slopes(self, side: int) -> Complex:
        """Return the derivatives of z at the start (0) or the end (1) of the phase."""
        signs = np.where(side, 1.0, (-1.0) ** np.arange(self.series.shape[1]))
        free: Complex = self.kappa[:, None] * self.ends[side]
        return free + self.forced * (self.series @ signs)

    def by_waves(self, turns: Vector) -> Complex:
        """Return the integrals of the forces times ``e^(-i turns u)``; shape (J, B)."""
        integrals = moments(-1j * self.length * turns.astype(complex), self.series.shape[1])
        wave = self.length * np.exp(-1j * turns * self.begin)
        return np.asarray(wave[:, None] * (integrals.T @ self.series.T))


def answers_to(
    poles: Poles, breaks: tuple[Break, ...], T: float, ends: Vector, sign: int
) -> list[Answer]:
    """Return the responses of the poles to breaks in every cell, on each phase of one cell.

    Parameters
    ----------
    poles : Poles
    breaks : tuple of Break
    T : float
        Duration of the cell.
    ends : ndarray, shape (P + 1,)
        The starts of the phases and the end of the last, relative to T.
    sign : int
        1, or -1 if the next cell is the mirror image.
    """
    kappa, highest = poles.s * T, max((q.n for q in breaks), default=0)
    around = 1 / (1 - sign * np.exp(kappa))
    whole = [(around, np.zeros((len(kappa), 1), dtype=complex))]  # to a unit impulse
    for n, series in enumerate(break_series(highest, 0.0, 1.0, sign)[1:], start=1):
        E, B = answers(kappa, np.outer(series[: n + 1], np.ones_like(kappa)))
        end = E * np.exp(kappa) + B.sum(axis=0)
        whole.append((T * (E + sign * around * end), T * B.T))
    width = max(B.shape[1] for _, B in whole)
    b = poles.b[:, [q.contact for q in breaks]]
    phases = []
    for q in range(len(ends) - 1):
        length = float(ends[q + 1] - ends[q])
        ages, series = np.empty(len(breaks)), np.zeros((len(breaks), highest + 1))
        E = np.empty_like(b)
        polynomials = np.zeros((*b.shape, width), dtype=complex)
        for i, (p, n, _) in enumerate(breaks):
            ages[i], side = (ends[q] - ends[p], 1) if q >= p else (1 + ends[q] - ends[p], sign)
            decaying, coefficients = whole[n]
            E[:, i] = side * b[:, i] * decaying * np.exp(kappa * ages[i])
            polynomials[:, i, : coefficients.shape[1]] = side * b[:, i, None] * coefficients
            if n:
                series[i] = side * break_series(highest, ages[i], length, sign)[n]
        begin = float(ends[q])
        phases.append(Answer(begin, length, E, polynomials, ages, series, T * b, kappa))
    return phases
