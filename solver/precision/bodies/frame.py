"""A cell of a body at given times in balls: poles, harmonics, functions with breaks."""

from itertools import accumulate, pairwise
from math import factorial
from typing import TYPE_CHECKING, Any

import numpy as np
from flint import acb, arb, arb_poly, fmpq, fmpq_poly

from ...bodies.force_series.layout import for_harmonics
from ...bodies.motion import Given
from .body import Balls, Body, Forms, at_end, balls, closed, conjugate, impulses, laws
from .pieces import Piece, around, moments

if TYPE_CHECKING:
    from ...scenes.bodies.cell import BodyPhase


def function(n: int, sign: int) -> fmpq_poly:
    """Return the polynomial ``beta_n`` of the age, from 0 to 1 between breaks.

    Its derivative of order n - 1 jumps by 1 at each break; ``beta_n' = beta_(n-1)``, and in the
    next cell it is `sign` times that of the cell.

    Examples
    --------
    >>> function(1, 1)
    (-1)*x + 1/2
    """
    beta = fmpq_poly([fmpq(1, 2)] if sign < 0 else [fmpq(1, 2), -1])
    for _ in range(n - 1):
        beta = beta.integral()
        beta -= beta.integral()(1) if sign > 0 else beta(1) / 2
    return beta


def legendre(p: fmpq_poly, age: Any, length: Any) -> dict[int, Any]:
    """Return the coefficients of ``p(age + length u)`` in the polynomials ``P_j*(u)``, by j."""
    coefficients: dict[int, Any] = {}
    for k, factor in enumerate(arb_poly(p)(arb_poly([age, length])).coeffs()):
        for j in range(k + 1):  # u^k
            part = fmpq(
                (2 * j + 1) * factorial(k) ** 2, factorial(k - j) * factorial(k + j + 1)
            )
            coefficients[j] = coefficients.get(j, arb(0)) + factor * part
    return coefficients


class Frame:
    """A cell at given times; see ``solver.bodies.harmonics.frame``.

    Parameters
    ----------
    given : Given
    times : ndarray of arb
    """

    def __init__(self, given: Given, times: Balls) -> None:
        cell = given.cell
        self.given, self.cell, self.count = given, cell, len(cell.phases)
        self.body = Body(cell, for_harmonics(cell).poles.held)
        durations = times[: self.count]
        self.T = self.body.duration if cell.forced else sum(durations, arb(0))
        # times of the switches and of the end, over that of the cell
        self.ends = [arb(0), *accumulate(t / self.T for t in durations[:-1]), arb(1)]
        self.lengths = [b - a for a, b in pairwise(self.ends)]
        self.drive = self.body.omega * self.T  # forcing angle of the cell
        first = times[self.count] if cell.forced else arb(0)
        self.angles = [first + self.drive * end for end in self.ends]
        self.turns = _turns(given.order, cell.sign)
        self.breaks = _breaks(given)
        # the unknowns are harmonics, factors of `breaks`, and memories
        self.waves = len(self.turns) * cell.body.at.shape[1]
        self.memory = self.waves + len(self.breaks)
        self.size = self.memory + len(cell.memory)
        self.pieces, self.laws = self._pieces(), list(map(self._law, cell.phases))

    def _pieces(self) -> list[Piece]:
        """Return the derivatives of the poles' states by the factors of `breaks`, by phase."""
        forces: list[dict[int, Any]] = [{} for _ in range(self.count)]
        hits: list[list[tuple[int, int]]] = [[] for _ in range(self.count)]
        for i, (p, n, c) in enumerate(self.breaks):
            if n == 0:
                hits[p - 1].append((i, c))
                continue
            beta = function(n, self.cell.sign)
            for q in range(self.count):
                side, age = 1 if q >= p else self.cell.sign, arb(0)
                if q != p:
                    age = self.ends[q] - self.ends[p] + (0 if q > p else 1)
                series = legendre(beta, age, self.lengths[q])
                forces[q][i] = (c, {j: side * factor for j, factor in series.items()})
        lengths = [length * self.T for length in self.lengths]
        return around(self.body.poles, lengths, forces, hits, len(self.breaks), self.cell.sign)

    def _law(self, phase: "BodyPhase") -> Forms:
        """Return the contact forces as forms, by the law of a phase."""
        law = self.body.forms(laws(phase))
        poles, turn, constant, memory = (0 * q for q in law[:4])
        force = Forms(poles, turn, constant, memory, balls(np.eye(len(law.direct))))
        return closed(force, law)

    def integral(self, q: int, turn: Any) -> Any:
        """Return the integral over phase `q` of ``e^(i turn u)``, with u the time over T."""
        wave = (acb(0, 1) * turn * self.ends[q]).exp()
        return wave * self.lengths[q] * moments(acb(0, 1) * turn * self.lengths[q], 1)[0]

    def compliance(self, forms: Forms) -> Balls:
        """Return the values of forms by each harmonic of the forces; shape (J, k, contacts)."""
        s, b, _ = self.body.poles
        values = [(forms.poles / (acb(0, 1) * turn / self.T - s)) @ b for turn in self.turns]
        return of_real(np.array(values, dtype=object))

    def values(self, forms: Forms, q: int, side: int) -> tuple[Balls, Balls]:
        """Return rows over the unknowns, and known parts, of forms at an end of phase `q`."""
        wave = [(acb(0, 1) * turn * self.ends[q + side]).exp() for turn in self.turns]
        harmonics = self.compliance(forms) * np.array(wave, dtype=object)[:, None, None]
        states = self.pieces[q].end if side else self.pieces[q].start
        rows = np.full((len(forms.poles), self.size), acb(0), dtype=object)
        rows[:, : self.waves] = harmonics.transpose(1, 0, 2).reshape(len(rows), -1)
        rows[:, self.waves : self.memory], offset = at_end(forms, states, self.angles[q + side])
        rows[:, self.memory :] = forms.memory
        return rows, offset


def _turns(order: int, sign: int) -> list[Any]:
    """Return ``h omega_0 T`` of the harmonics, ascending; for half a period the odd ones."""
    if sign > 0:
        return [2 * h * arb.pi() for h in range(-order, order + 1)]
    top = order - (order + 1) % 2
    return [h * arb.pi() for h in range(-top, top + 1, 2)]


def _breaks(given: Given) -> list[tuple[int, int, int]]:
    """Return (switch, n, contact) of each function, then (switch, 0, contact) of impulses."""
    cell, functions = given.cell, range(given.functions or 0)
    count, contacts = len(cell.phases), range(cell.body.at.shape[1])
    classes = [max(k, 1) for k in cell.classes]
    smooth = [(p, classes[p] + i, c) for p in range(count) for i in functions for c in contacts]
    return smooth + [(p + 1, 0, c) for p in range(count) for c in impulses(cell, p)[0]]


def of_real(by_harmonic: Balls) -> Balls:
    """Return the harmonics of the real part of a function with these harmonics."""
    return (by_harmonic + conjugate(by_harmonic[::-1])) / 2
