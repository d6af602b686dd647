"""What is known of a cell at given times before its unknowns are: poles, harmonics, breaks."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ....generated import force_harmonics as formula
from ...arrays import Complex, Vector
from ..force_series.integrals import moments
from ..force_series.layout import Layout, for_harmonics
from ..poles import Forms
from .breaks import Answer, Break, answers_to

if TYPE_CHECKING:
    from ...scenes.bodies.cell import BodyCell


@dataclass(frozen=True, eq=False)
class Frame:
    """What is known of a cell at given times; places in it are parts of its duration.

    Parameters
    ----------
    own : Layout
        Phases and poles.
    functions : int
        Beside the harmonics, at each switch.
    T : float
        Duration of the cell.
    ends : ndarray, shape (P + 1,)
        Where phases begin, and the last ends: from 0 to 1.
    angles : ndarray, shape (P + 1,)
        Of the forcing there.
    turns : ndarray, shape (J,)
        ``h w T`` of each harmonic, ascending.
    above : ndarray of complex, shape (J, m)
        What each pole answers to each harmonic, ``1/(i h w - s)``.
    breaks : tuple of Break
        The functions, then the impulses.
    answers : list of Answer
        To them on each phase.
    laws : tuple of Forms
        The contact forces by the law of each phase.
    """

    own: Layout
    functions: int
    T: float
    ends: Vector
    angles: Vector
    turns: Vector
    above: Complex
    breaks: tuple[Break, ...]
    answers: list[Answer]
    laws: tuple[Forms, ...]

    @property
    def waves(self) -> int:
        """How many unknowns are harmonics; those of `breaks` follow, then the memory."""
        return int(len(self.turns) * self.own.poles.b.shape[1])

    @property
    def size(self) -> int:
        """How many unknowns there are."""
        return self.waves + len(self.breaks) + self.own.size - self.own.first_memory

    @property
    def memory(self) -> slice:
        """Where the memory is among the unknowns."""
        return slice(self.waves + len(self.breaks), self.size)


def numbers(sign: int, order: int) -> Vector:
    """Return ``h w T`` of the harmonics up to an order: of half a period the odd ones.

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


def frame_of(cell: "BodyCell", order: int, functions: int, times: Vector, T: float) -> Frame:
    """Return what is known of a cell of duration T at given times."""
    own, count = for_harmonics(cell), len(cell.phases)
    poles, contacts = own.poles, range(own.poles.b.shape[1])
    ends = np.concatenate([[0.0], np.cumsum(times[: count - 1]) / T, [1.0]])
    angles = (float(times[-1]) if cell.forced else 0.0) + cell.omega * T * ends
    turns = numbers(cell.sign, order)
    breaks = tuple(
        Break(p, first_function(cell, p) + i, c)
        for p in range(count)
        for i in range(functions)
        for c in contacts
    ) + tuple(Break(p + 1, 0, int(c)) for p in range(count) for c in own.phases[p].hit)
    answers = answers_to(poles, breaks, T, ends, cell.sign)
    laws = tuple(phase.force for phase in own.phases)
    above = formula.answer(turns[:, None] / T, poles.s)
    return Frame(own, functions, T, ends, angles, turns, above, breaks, answers, laws)


def compliance(frame: Frame, forms: Forms) -> Complex:
    """Return what forms are of each harmonic of the forces; shape (J, k, contacts)."""
    found = np.einsum("jm,km,mc->jkc", frame.above, forms.poles, frame.own.poles.b)
    return of_real(found)


def of_real(by_harmonic: Complex) -> Complex:
    """Return the harmonics of the real part of what has these."""
    return np.asarray((by_harmonic + by_harmonic[::-1].conj()) / 2)


def values(frame: Frame, forms: Forms, q: int, side: int) -> tuple[Complex, Vector]:
    """Return forms at an end of phase `q`: rows over the unknowns, and what is known."""
    at = q + side
    wave = np.exp(1j * frame.turns * frame.ends[at])[:, None, None]
    harmonics = (compliance(frame, forms) * wave).transpose(1, 0, 2)
    breaks = (forms.poles @ frame.answers[q].ends[side]).real
    rows = np.hstack([harmonics.reshape(len(forms.poles), -1), breaks, forms.memory])
    return rows, (forms.turn * np.exp(1j * frame.angles[at])).real + forms.constant


def integrals(frame: Frame, q: int, angles: Vector) -> Complex:
    """Return ``int e^(i angles u) du`` over a phase."""
    length = frame.ends[q + 1] - frame.ends[q]
    own = moments(1j * angles * length, 1)[0]
    return np.asarray(np.exp(1j * angles * frame.ends[q]) * length * own)
