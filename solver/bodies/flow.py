"""The flow of a body in one phase, in the eigenbasis of that phase."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..arrays import Complex, Matrix, Vector
from .laws import Lawful
from .systems import BodyError

#: Condition of an eigenbasis beyond which it keeps too few digits.
WORST = 1e7

#: What is wrong then.
ONE = (
    "two of its poles are one, as those of a mode that is damped critically (change a damping "
    "by a millionth of it), or of one that hardly anything holds"
)

#: Largest correction of an eigenvector; where it is larger, two poles are taken as one.
TURN = 1e-6

#: Least ``|i omega - s| t`` for which the steady answer of a pole s keeps its digits.
CLEAR = 0.1

#: Exponent below which a mode is taken as decayed: denormal numbers are slow.
GONE = -300.0

#: Modulus up to which ``(e^z - 1 - z)/z^2`` is summed as a series, and its terms.
NEAR, TERMS = 0.1, 10


@dataclass(frozen=True, eq=False)
class Flow:
    """``y' = A y + inputs (cos, sin, 1, memory)`` in the eigenbasis of A.

    A rigid-body mode has a double pole 0 with a Jordan block: ``z_i' = z_(i + free) + inputs``
    for i below `free`.

    Parameters
    ----------
    poles : ndarray of complex, shape (n,)
    basis, inverse : ndarray of complex, shape (n, n)
    inputs : ndarray of complex, shape (n, 3 + M)
        In the basis.
    omega : float
        Angular frequency of cos and sin.
    free : int
        The number of rigid-body modes.
    """

    poles: Complex
    basis: Complex
    inverse: Complex
    inputs: Complex
    omega: float
    free: int = 0

    @np.errstate(over="ignore", invalid="ignore")  # a trial may grow beyond float64
    def matrix(self, t: float | Vector) -> Matrix:
        """Return ``exp(A t)``; of several times a stack."""
        half = self.upper
        t, free = np.asarray(t), self.free
        alive = (half.poles.real * t[..., None] > GONE).reshape(-1, len(half.poles)).any(axis=0)
        inverse = half.inverse[alive]
        grown = half.basis[:, alive] * np.exp(half.poles[alive] * t[..., None])[..., None, :]
        exponential = grown.real @ inverse.real - grown.imag @ inverse.imag
        if free:
            moved = half.basis[:, :free] @ half.inverse[free : 2 * free]
            exponential = exponential + t[..., None, None] * moved.real
        return np.asarray(exponential)

    def driven(self, t: float | Vector) -> Matrix:
        """Return the responses of the state at rest to each input; shape (..., n, 3 + M).

        The first two are to the cosine and the sine of the phase that the forcing has at the
        start.
        """
        half = self.upper
        return np.asarray((half.basis @ half.answered(half.drives, np.asarray(t))).real)

    @np.errstate(over="ignore", invalid="ignore")
    def answered(self, drives: Complex, t: Vector) -> Complex:
        """Return the responses of z at rest to `drives`; shape (..., n, k) for (3, n, k)."""
        waves = np.array([self.omega, -self.omega, 0.0])
        by_pole = steady(self.poles, waves[:, None], t[..., None, None])
        answers = np.einsum("wnk,...wn->...nk", drives, by_pole)
        if self.free:
            moving, rigid = drives[:, self.free : 2 * self.free], answers[..., : self.free, :]
            rigid += np.einsum("wnk,w...->...nk", moving, [twice(w, t) for w in waves])
        return np.asarray(answers)

    def moved(self, start: Complex, drives: Complex, t: Vector) -> Complex:
        """Return z at times, from its initial value and drives (3, n); shape (n, len(t))."""
        states = start[:, None] * np.exp(self.poles[:, None] * t)
        states[: self.free] += start[self.free : 2 * self.free, None] * t
        return np.asarray(states + self.answered(drives[..., None], t)[..., 0].T)

    def seen(self, rows: Matrix, y: Vector, inputs: Vector, t: Vector) -> Matrix:
        """Return linear forms of the state at times, from its initial value.

        Shape (len(rows), len(t)); `inputs` are cosine and sine at the start, 1, the memory.
        """
        half = self.upper
        basis, start = rows @ half.basis, half.inverse @ y
        if self.is_clear(float(np.abs(t).max(initial=0.0))):
            return half._clear(basis, start, inputs, t)
        return np.asarray((basis @ half.moved(start, half.drives @ inputs, t)).real)

    @cached_property
    def upper(self) -> "Flow":
        """The poles with one of each pair, its vector doubled: the real part is the state."""
        upper = self.poles.imag >= 0
        double = np.where(self.poles[upper].imag > 0, 2.0, 1.0)
        basis = self.basis[:, upper] * double
        return Flow(
            self.poles[upper], basis, self.inverse[upper], self.inputs[upper], self.omega,
            self.free,
        )  # fmt: skip

    @cached_property
    def condition(self) -> float:
        """The condition number of the basis in the Frobenius norm, over n; at least 1."""
        norms = np.linalg.norm(self.basis) * np.linalg.norm(self.inverse)
        return float(norms) / max(len(self.poles), 1)

    @cached_property
    def drives(self) -> Complex:
        """The drive of each pole by each input, shape (3, n, 3 + M).

        As factors of ``e^(i omega t)``, ``e^(-i omega t)`` and 1.
        """
        (cos, sin), drive = self.inputs[:, :2].T / 2, np.zeros((3, *self.inputs.shape), complex)
        drive[0, :, 0], drive[0, :, 1] = cos - 1j * sin, sin + 1j * cos
        drive[1, :, 0], drive[1, :, 1] = cos + 1j * sin, sin - 1j * cos
        drive[2, :, 2:] = self.inputs[:, 2:]
        return drive

    def is_clear(self, longest: float) -> bool:
        """Whether no pole is near 0 or +-i omega, so that steady answers keep their digits."""
        driven = np.array([0.0, self.omega, -self.omega])
        return bool(np.abs(1j * driven - self.poles[:, None]).min() * longest >= CLEAR)

    def _clear(self, basis: Complex, start: Complex, inputs: Vector, t: Vector) -> Matrix:
        """Return forms of the state by steady answers and a decaying part."""
        harmonic_drive, conjugate, steady_drive = self.drives @ inputs
        up, down = (
            harmonic_drive / (1j * self.omega - self.poles),
            conjugate / (-1j * self.omega - self.poles),
        )
        constant = -steady_drive / self.poles
        decaying = (start - up - down - constant)[:, None] * np.exp(self.poles[:, None] * t)
        waves = np.exp(1j * self.omega * t)
        steady_ = np.outer(basis @ up, waves) + np.outer(basis @ down, waves.conj())
        forms = basis @ decaying + steady_ + (basis @ constant)[:, None]
        return np.asarray(forms.real)


@np.errstate(over="ignore", invalid="ignore")  # then there is no eigenbasis
def flow_of(lawful: Lawful, omega: float) -> Flow:
    """Return the flow of a phase.

    Raises
    ------
    BodyError
        If two eigenvectors are nearly parallel.
    """
    free, complement = lawful.free, np.eye(len(lawful.A))
    if free.shape[1]:
        complement = np.linalg.qr(free, mode="complete")[0][:, free.shape[1] :]
    reduced = complement.T @ lawful.A @ complement
    poles, turned = graded(reduced, *np.linalg.eig(reduced))
    vectors = complement @ turned
    if free.shape[1]:  # the complement drives them: what is free is added to each vector
        count, inner = free.shape[1] // 2, np.linalg.pinv(free)
        drive = inner @ (lawful.A @ vectors - vectors * poles)
        moving = drive[count:] / poles
        vectors = vectors + free @ np.vstack([(drive[:count] + moving) / poles, moving])
        poles = np.concatenate([np.zeros(2 * count), poles])
    basis = np.hstack([free, vectors]).astype(complex)
    try:
        inverse = _inverse(poles, basis)
        condition = float(np.linalg.norm(basis) * np.linalg.norm(inverse))
    except np.linalg.LinAlgError:
        condition = np.inf
    if not condition <= WORST:
        raise BodyError(ONE)
    inputs = inverse @ lawful.inputs.astype(complex)
    return Flow(poles.astype(complex), basis, inverse, inputs, omega, free.shape[1] // 2)


def _inverse(poles: Complex, basis: Complex) -> Complex:
    """Return the inverse of an eigenbasis, computed with real and imaginary parts of pairs."""
    above, below = np.flatnonzero(poles.imag > 0), np.flatnonzero(poles.imag < 0)
    real = basis.real.copy()
    real[:, below] = basis[:, above].imag
    inverse = np.linalg.inv(real).astype(complex)
    inverse[above] = (inverse[above] - 1j * inverse[below]) / 2
    inverse[below] = inverse[above].conj()
    return inverse


def graded(A: Matrix, poles: Complex, vectors: Complex) -> tuple[Complex, Complex]:
    """Return eigenvalues and vectors with small relative errors, whatever their sizes.

    `eig` errs by the rounding of the largest eigenvalue or, where parts are coupled by rounding
    only, by its square root.  One step of correction by the residual ``A v - s v`` mends that,
    where the residual is more than rounding.
    """
    try:
        inverse = np.linalg.inv(vectors)
    except np.linalg.LinAlgError:
        return poles, vectors
    residual, sizes = inverse @ (A @ vectors - vectors * poles), np.abs(vectors)
    rounding = np.abs(inverse) @ (np.abs(A) @ sizes + sizes * np.abs(poles))
    residual[np.abs(residual) <= np.finfo(float).eps * rounding] = 0.0
    gaps = poles - poles[:, None] + np.eye(len(poles))
    rotations = residual / np.where(gaps == 0, 1.0, gaps) - np.diag(np.diag(residual))
    counts = np.abs(rotations).max(axis=0, initial=0.0) < TURN
    corrections = np.where(counts, np.vstack([np.diag(residual), vectors @ rotations]), 0.0)
    eigenpairs = np.vstack([poles, vectors]) + corrections.astype(complex)
    eigenpairs.imag[:, poles.imag == 0] = 0.0
    eigenpairs[:, poles.imag < 0] = eigenpairs[:, poles.imag > 0].conj()  # pairs stay pairs
    return eigenpairs[0], eigenpairs[1:]


def steady(poles: Complex, omega: float | Vector, t: float | Vector) -> Complex:
    """Return ``int_0^t e^(s (t - r)) e^(i omega r) dr``, accurate also near a resonance."""
    detuning = 1j * omega - poles
    turned, decayed = detuning * t, np.exp(poles * t)
    small = np.abs(turned) < 1.0
    far = (np.exp(1j * omega * t) - decayed) / np.where(detuning == 0, 1.0, detuning)
    if not small.any():
        return np.asarray(far)
    near = decayed * t * _phi(np.where(small, turned, 1.0))
    return np.asarray(np.where(small, near, far))


def twice(omega: float, t: Vector) -> Complex:
    """Return ``int_0^t (t - r) e^(i omega r) dr``, the response of a rigid-body mode."""
    if omega == 0:
        return np.asarray(t * t / 2, dtype=complex)
    z = 1j * omega * t
    small = np.abs(z) < NEAR
    far = np.where(small, 1.0, z)
    factors = (np.expm1(far) - far) / far**2
    if small.any():
        near, term = np.zeros_like(z), np.full_like(z, 0.5)
        for n in range(3, 3 + TERMS):
            near, term = near + term, term * z / n
        factors = np.where(small, near, factors)
    return np.asarray(t * t * factors)


def _phi(z: Complex) -> Complex:
    """Return ``(e^z - 1)/z`` for moderate z."""
    safe = np.where(z == 0, 1.0, z)
    return np.where(z == 0, 1.0, np.expm1(safe) / safe)
