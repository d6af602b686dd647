"""The data of a cell at given times, before its unknowns: poles, harmonics, breaks."""

from typing import TYPE_CHECKING

import numpy as np

from ....generated import force_harmonics as formula
from ...arrays import Complex, Vector
from ..force_series.integrals import moments
from ..force_series.layout import for_harmonics
from ..poles import Forms
from .breaks import Break, answers_to

if TYPE_CHECKING:
    from ...scenes.bodies.cell import BodyCell


class Frame:
    """The data of a cell of duration T at given times; instants are relative to T.

    Attributes
    ----------
    own : Layout
        Phases and poles.
    functions : int
        The number of functions with a break at each switch.
    ends : ndarray, shape (P + 1,)
        The starts of the phases and the end of the last, from 0 to 1.
    angles : ndarray, shape (P + 1,)
        The angles of the forcing there.
    turns : ndarray, shape (J,)
        ``h w T`` of each harmonic, ascending.
    above : ndarray of complex, shape (J, m)
        The response of each pole to each harmonic, ``1/(i h w - s)``.
    breaks : tuple of Break
        The functions, then the impulses.
    answers : list of Answer
        The responses to them on each phase.
    laws : list of Forms
        The contact forces by the law of each phase.
    waves, size : int
        The number of harmonics among the unknowns, and of all unknowns.  They are the
        harmonics, the factors of `breaks`, the memory.
    memory : slice
        The memory among the unknowns.
    """

    def __init__(
        self, cell: "BodyCell", order: int, functions: int, times: Vector, T: float
    ) -> None:
        self.own, self.functions, self.T = for_harmonics(cell), functions, T
        phases, poles, contacts = self.own.phases, self.own.poles, cell.body.at.shape[1]
        count = len(phases)
        self.ends = np.concatenate([[0.0], np.cumsum(times[: count - 1]) / T, [1.0]])
        first = float(times[-1]) if cell.forced else 0.0
        self.angles: Vector = first + cell.omega * T * self.ends
        self.turns = numbers(cell.sign, order)
        self.breaks = tuple(
            Break(p, first_function(cell, p) + i, c)
            for p in range(count)
            for i in range(functions)
            for c in range(contacts)
        ) + tuple(Break(p + 1, 0, int(c)) for p in range(count) for c in phases[p].hit)
        self.answers = answers_to(poles, self.breaks, T, self.ends, cell.sign)
        self.laws = [phase.force for phase in phases]
        self.above: Complex = formula.answer(self.turns[:, None] / T, poles.s)
        self.waves = len(self.turns) * contacts
        self.size = self.waves + len(self.breaks) + len(cell.memory)
        self.memory = slice(self.size - len(cell.memory), self.size)


def numbers(sign: int, order: int) -> Vector:
    """Return ``h w T`` of the harmonics up to an order; of a half period only the odd ones.

    Examples
    --------
    >>> numbers(-1, 4) / np.pi
    array([-3., -1.,  1.,  3.])
    """
    if sign > 0:
        return 2 * np.pi * np.arange(-order, order + 1.0)
    top = order - (order + 1) % 2
    return np.pi * np.arange(-top, top + 1.0, 2.0)


def first_function(cell: "BodyCell", p: int) -> int:
    """Return the n of the first function at a switch: the force is of class C^(n - 2) there."""
    return max(cell.classes[p], 1)


def compliance(frame: Frame, forms: Forms) -> Complex:
    """Return the responses of forms to each harmonic of the forces; shape (J, k, contacts)."""
    by_wave = np.einsum("jm,km,mc->jkc", frame.above, forms.poles, frame.own.poles.b)
    return of_real(by_wave)


def of_real(by_harmonic: Complex) -> Complex:
    """Return the harmonics of the real part of a function, from its own."""
    return np.asarray((by_harmonic + by_harmonic[::-1].conj()) / 2)


def values(frame: Frame, forms: Forms, q: int, side: int) -> tuple[Complex, Vector]:
    """Return rows over the unknowns and constants of forms, at start (0) or end (1) of `q`."""
    at = q + side
    wave = np.exp(1j * frame.turns * frame.ends[at])[:, None, None]
    harmonics = (compliance(frame, forms) * wave).transpose(1, 0, 2)
    breaks = (forms.poles @ frame.answers[q].ends[side]).real
    rows = np.hstack([harmonics.reshape(len(forms.poles), -1), breaks, forms.memory])
    return rows, (forms.turn * np.exp(1j * frame.angles[at])).real + forms.constant


def integrals(frame: Frame, q: int, angles: Vector) -> Complex:
    """Return ``int e^(i angles u) du`` over a phase."""
    length = frame.ends[q + 1] - frame.ends[q]
    unit = moments(1j * angles * length, 1)[0]
    return np.asarray(np.exp(1j * angles * frame.ends[q]) * length * unit)
