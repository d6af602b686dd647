"""States of poles under forces that are polynomials on each piece of a cell, in balls."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from flint import acb, arb

from .body import Balls, balls

#: For each column (unknown) the contact at which its force acts, and the Legendre coefficients
#: of the force on the piece, by degree.
Forces = Mapping[int, tuple[int, Mapping[int, Any]]]


def moments(kappa: Any, count: int) -> Balls:
    """Return ``int_0^1 e^(kappa u) P_n*(u) du`` for n below `count`.

    ``e^(kappa/2) i_n(kappa/2)``, with i_n by its series 0F1 (DLMF 10.47.7, 10.39.9), or for
    large kappa by upward recurrence, which is stable there.
    """
    kappa = acb(kappa)
    if abs(kappa) > 2 * count:
        grown = kappa.exp()
        integrals = [(grown - 1) / kappa, (grown + 1) / kappa - 2 * (grown - 1) / kappa**2]
        for n in range(1, count - 1):
            integrals.append(integrals[n - 1] - 2 * (2 * n + 1) / kappa * integrals[n])
        return np.array(integrals[:count], dtype=object)
    half = kappa / 2
    integrals, factor = [], half.exp()
    for n in range(count):
        if n:
            factor = factor * half / (2 * n + 1)
        integrals.append(factor * (half * half / 4).hypgeom_0f1(acb(2 * n + 3) / 2))
    return np.array(integrals, dtype=object)


def answers(kappa: Any, count: int) -> Balls:
    """Return the Legendre coefficients of the polynomials p with ``p' - kappa p = P_n*``.

    Shape ``(count, count)``, by n; ``P_j*' = sum 2 (2 i + 1) P_i*`` over i = j - 1, j - 3, ...
    """
    coefficients = np.full((count, count), acb(0), dtype=object)
    for n in range(count):
        above = [acb(0), acb(0)]  # sums of the coefficients of odd and of even degree
        for i in range(n, -1, -1):
            slope = 2 * (2 * i + 1) * above[(i + 1) % 2]
            coefficients[n, i] = (slope - (1 if i == n else 0)) / kappa
            above[i % 2] += coefficients[n, i]
    return coefficients


@dataclass(frozen=True, eq=False)
class Piece:
    """The states of the poles on a piece: ``decaying e^(kappa u) + sum rest P_n*(u)``.

    Parameters
    ----------
    kappa : ndarray of acb, shape (m,)
    start : ndarray of acb, shape (m, U)
        At the begin of the piece, by column.
    rest : ndarray of acb, shape (m, U, D)
    """

    kappa: Balls
    start: Balls
    rest: Balls

    @cached_property
    def decaying(self) -> Balls:
        """The factors of ``e^(kappa u)``."""
        signs = np.array([arb((-1) ** n) for n in range(self.rest.shape[2])], dtype=object)
        return self.start - self.rest @ signs

    @cached_property
    def end(self) -> Balls:
        """The states at the end."""
        return self.decaying * np.exp(self.kappa)[:, None] + self.rest.sum(axis=2)

    def tested(self, count: int) -> Balls:
        """Return the integrals of the states times ``P_n*`` for n < count; (count, m, U)."""
        by_pole = np.array([moments(q, count) for q in self.kappa], dtype=object)
        integrals = [by_pole[:, n, None] * self.decaying for n in range(count)]
        for n in range(min(count, self.rest.shape[2])):
            integrals[n] += self.rest[:, :, n] / (2 * n + 1)
        return np.array(integrals, dtype=object)

    def by_wave(self, turn: Any) -> Balls:
        """Return the integral of the states times ``e^(-i turn u)``; shape (m, U)."""
        against = acb(0, -1) * turn
        decayed = [moments(q + against, 1)[0] for q in self.kappa]
        undecayed = moments(against, self.rest.shape[2])
        return np.array(decayed, dtype=object)[:, None] * self.decaying + self.rest @ undecayed


def around(
    poles: tuple[Balls, Balls, Balls],
    lengths: Sequence[Any],
    forces: Sequence[Forces],
    hits: Sequence[Iterable[tuple[int, int]]],
    columns: int,
    sign: int,
) -> list[Piece]:
    """Return the pieces of a cell of a periodic motion.

    Parameters
    ----------
    poles : tuple
        `Body.poles`.
    lengths : sequence of arb
        Durations of the pieces.
    forces : sequence of Forces
        On each piece.
    hits : sequence of (column, contact)
        Unit impulses at the end of each piece.
    columns : int
        Number of unknowns.
    sign : int
        The next cell is this times the cell.
    """
    s, b, _ = poles
    rests = [_rest(s * t, b * t, f, columns) for t, f in zip(lengths, forces, strict=True)]
    start = balls(np.zeros((len(s), columns)))
    pieces: list[Piece] = []
    for turn in range(2):
        pieces, state = [], start
        for t, rest, hit in zip(lengths, rests, hits, strict=True):
            pieces.append(Piece(s * t, state, rest))
            state = pieces[-1].end.copy()
            for column, contact in hit:
                state[:, column] += b[:, contact]
        if turn == 0:
            grown = np.exp(s * sum(lengths, arb(0)))
            start = sign * state / (1 - sign * grown)[:, None]
    return pieces


def _rest(kappa: Balls, b: Balls, forces: Forces, columns: int) -> Balls:
    """Return the polynomial part of the states on a piece; see `Piece`."""
    count = 1 + max((n for _, series in forces.values() for n in series), default=0)
    rest = np.full((len(kappa), columns, count), acb(0), dtype=object)
    by_degree = np.array([answers(q, count) for q in kappa], dtype=object)
    for column, (contact, series) in forces.items():
        for n, factor in series.items():
            rest[:, column] += by_degree[:, n] * (b[:, contact] * factor)[:, None]
    return rest
