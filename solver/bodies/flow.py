"""The flow of a body in one phase, in the eigenbasis of that phase."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..arrays import Complex, Matrix, Vector
from .laws import Lawful
from .modal import BodyError

#: Condition of an eigenbasis beyond which it keeps too few digits.
WORST = 1e9

#: Least turn or decay, over a phase, of a pole against what drives it.
CLEAR = 0.1


@dataclass(frozen=True, eq=False)
class Flow:
    """``y' = A y + inputs (cos, sin, 1, memory)`` in the eigenbasis of A.

    Parameters
    ----------
    poles : ndarray of complex, shape (n,)
    basis, inverse : ndarray of complex, shape (n, n)
    inputs : ndarray of complex, shape (n, 3 + M)
        In the basis.
    omega : float
        Angular frequency of cos and sin.
    """

    poles: Complex
    basis: Complex
    inverse: Complex
    inputs: Complex
    omega: float

    def matrix(self, t: float | Vector) -> Matrix:
        """Return ``exp(A t)``; of several times a stack."""
        half = self.upper
        grown = half.basis * np.exp(half.poles * np.asarray(t)[..., None])[..., None, :]
        return np.asarray(grown.real @ half.inverse.real - grown.imag @ half.inverse.imag)

    def driven(self, t: float | Vector) -> Matrix:
        """Return what the inputs make of rest in a time; shape (..., n, 3 + M), by input.

        The first two columns are by the cosine and the sine of the angle that the forcing has
        at the beginning: their sum with these as factors is the answer to the forcing.
        """
        return np.asarray((self.basis @ self._driven(t)).real)

    def _driven(self, t: float | Vector) -> Complex:
        t = np.asarray(t)[..., None]
        found = self.inputs * steady(self.poles, 0.0, t)[..., None]
        up, down = (steady(self.poles, sign * self.omega, t) for sign in (1.0, -1.0))
        half, other = (up + down) / 2, (up - down) / 2j  # answers to cos and sin of Omega t
        cos, sin = self.inputs[:, 0], self.inputs[:, 1]
        found[..., 0], found[..., 1] = cos * half + sin * other, sin * half - cos * other
        return np.asarray(found)

    def seen(self, rows: Matrix, y: Vector, inputs: Vector, t: Vector) -> Matrix:
        """Return linear forms of the state at times from its start; shape (len(rows), len(t)).

        `inputs` are the cosine and the sine at the start, 1 and the memory.
        """
        half = self.upper
        basis, start = rows @ half.basis, (half.inverse @ y)[:, None]
        if self.is_clear(float(np.abs(t).max(initial=0.0))):
            return half._clear(basis, start[:, 0], inputs, t)
        return half._near(basis, start, inputs, t)

    @cached_property
    def upper(self) -> "Flow":
        """The poles of which real parts are taken: one of each pair, twice."""
        kept = self.poles.imag >= 0
        twice = np.where(self.poles[kept].imag > 0, 2.0, 1.0)
        basis = self.basis[:, kept] * twice
        return Flow(self.poles[kept], basis, self.inverse[kept], self.inputs[kept], self.omega)

    def _near(self, basis: Complex, start: Complex, inputs: Vector, t: Vector) -> Matrix:
        """Return forms of the state where a pole is near what drives it."""
        turns = [steady(self.poles[:, None], q * self.omega, t[None, :]) for q in (1, -1, 0)]
        half, other = (turns[0] + turns[1]) / 2, (turns[0] - turns[1]) / 2j
        cos, sin = self.inputs[:, 0], self.inputs[:, 1]
        by_cos, by_sin = cos * inputs[0] + sin * inputs[1], sin * inputs[0] - cos * inputs[1]
        constant = self.inputs[:, 2:] @ inputs[2:]
        moved = start * np.exp(self.poles[:, None] * t[None, :])
        moved += by_cos[:, None] * half + by_sin[:, None] * other + constant[:, None] * turns[2]
        return np.asarray((basis @ moved).real)

    def drives(self, inputs: Vector) -> tuple[Complex, Complex, Complex]:
        """Return what drives each pole: factors of ``e^(i omega t), e^(-i omega t), 1``."""
        cos, sin = self.inputs[:, 0], self.inputs[:, 1]
        turn = (inputs[0] + 1j * inputs[1]) / 2
        up, down = (cos - 1j * sin) * turn, (cos + 1j * sin) * turn.conjugate()
        return up, down, self.inputs[:, 2:] @ inputs[2:]

    def is_clear(self, longest: float) -> bool:
        """Whether no pole is near what drives it: then steady answers keep their digits."""
        driven = np.array([0.0, self.omega, -self.omega])
        return bool(np.abs(1j * driven - self.poles[:, None]).min() * longest >= CLEAR)

    def _clear(self, basis: Complex, start: Complex, inputs: Vector, t: Vector) -> Matrix:
        """Return forms of the state by steady answers and what of the start decays."""
        half, other, one = self.drives(inputs)
        up, down = (
            half / (1j * self.omega - self.poles),
            other / (-1j * self.omega - self.poles),
        )
        constant = -one / self.poles
        decaying = (start - up - down - constant)[:, None] * np.exp(self.poles[:, None] * t)
        waves = np.exp(1j * self.omega * t)
        steady_ = np.outer(basis @ up, waves) + np.outer(basis @ down, waves.conj())
        found = basis @ decaying + steady_ + (basis @ constant)[:, None]
        return np.asarray(found.real)


def flow_of(lawful: Lawful, omega: float) -> Flow:
    """Return the flow of a phase.

    Raises
    ------
    BodyError
        If its eigenvectors are too near to each other.
    """
    poles, basis = np.linalg.eig(lawful.A)
    poles, basis = poles.astype(complex), basis.astype(complex)
    try:
        inverse = np.linalg.inv(basis)
        condition = float(np.linalg.norm(basis) * np.linalg.norm(inverse))
    except np.linalg.LinAlgError:
        condition = np.inf
    if condition > WORST:
        raise BodyError(
            "two poles of the body are one (a mode with exactly critical damping): change its "
            "damping a little"
        )
    return Flow(poles, basis, inverse, inverse @ lawful.inputs.astype(complex), omega)


def steady(poles: Complex, omega: float, t: float | Vector) -> Complex:
    """Return ``int_0^t e^(s (t - r)) e^(i omega r) dr``, at a resonance as well."""
    apart = 1j * omega - poles
    turned = apart * t
    small = np.abs(turned) < 1.0
    with np.errstate(all="ignore"):
        far = (np.exp(1j * omega * t) - np.exp(poles * t)) / apart
        near = np.exp(poles * t) * t * _phi(np.where(small, turned, 1.0))
    return np.asarray(np.where(small, near, far))


def _phi(z: Complex) -> Complex:
    """Return ``(e^z - 1)/z`` for moderate z."""
    safe = np.where(z == 0, 1.0, z)
    return np.where(z == 0, 1.0, np.expm1(safe) / safe)
