"""The derivatives of forms and rows by the switches, at fixed unknowns."""

import numpy as np

from ...arrays import Complex, Matrix
from ..poles import Forms
from .frame import Frame, values


class Moving:
    """Derivatives by the switches and the phase of the forcing, at fixed unknowns.

    Parameters
    ----------
    frame : Frame
    unknowns : ndarray of complex
    """

    def __init__(self, frame: Frame, unknowns: Complex) -> None:
        self.frame, self.unknowns = frame, unknowns
        self.factors = unknowns[frame.waves : frame.memory.start].real
        self.harmonics = unknowns[: frame.waves].reshape(len(frame.turns), -1)
        self.switches = np.arange(1, len(frame.laws))
        self.own = np.array([q.switch for q in frame.breaks]) == self.switches[:, None]

    def of(self, forms: Forms, q: int, side: int) -> Matrix:
        """Return the derivatives of forms at the start (0) or end (1) of phase `q`.

        By column: by the inner switches, then by the phase of the forcing.
        """
        frame, poles = self.frame, self.frame.own.poles
        at, answer = q + side, self.frame.answers[q]
        wave = np.exp(1j * frame.turns * frame.ends[at])[:, None] * self.harmonics
        slope = np.einsum("jm,mc,jc->m", frame.above, poles.b, 1j * frame.turns[:, None] * wave)
        by_break = answer.slopes(side) * self.factors
        slope = slope + by_break.sum(axis=1)
        turned = 1j * forms.turn * np.exp(1j * frame.angles[at])
        drive = frame.angles[-1] - frame.angles[0]
        rates = (forms.poles @ slope + drive * turned).real
        derivatives = -(forms.poles @ (by_break @ self.own.T)).real
        derivatives += np.outer(rates, self.switches == at)
        return np.column_stack([derivatives, turned.real])

    def galerkin(self, A: Complex) -> Complex:
        """Return the derivatives of the rows A of the harmonics, by inner switches."""
        frame = self.frame
        derivatives = np.zeros((frame.waves, len(self.switches)), dtype=complex)
        waves = np.exp(-1j * frame.turns[:, None] * frame.ends)
        by_break = A[: frame.waves, frame.waves : frame.memory.start] * self.factors
        turned = (1j * frame.turns[:, None] * np.ones(self.harmonics.shape[1])).reshape(-1, 1)
        derivatives -= turned * (by_break @ self.own.T)
        for q, law in enumerate(frame.laws):
            for side, sign in ((0, -1), (1, 1)):
                rows, constant = values(frame, law, q, side)
                force = (rows @ self.unknowns).real + constant
                z = frame.answers[q].ends[side] * self.factors
                part = (law.poles @ (z @ self.own.T)).real  # the part by breaks at each switch
                part -= np.outer(force, self.switches == q + side)
                derivatives += sign * np.einsum("j,cr->jcr", waves[:, q + side], part).reshape(
                    derivatives.shape
                )
        return derivatives
