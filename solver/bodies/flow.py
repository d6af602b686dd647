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

#: Most that a vector is turned by what rounding left of it: where it is more, poles are one.
TURN = 1e-6

#: Least turn or decay, over a phase, of a pole against what drives it.
CLEAR = 0.1

#: Exponent at which a mode has decayed to nothing; less would be slow, denormal numbers.
GONE = -300.0

#: Where ``(e^z - 1 - z)/z^2`` is a series, and of how many terms.
NEAR, TERMS = 0.1, 10


@dataclass(frozen=True, eq=False)
class Flow:
    """``y' = A y + inputs (cos, sin, 1, memory)`` in the eigenbasis of A.

    Where nothing holds the body, its velocity moves a place: ``z_i' = z_(i + free) + inputs``
    for i below `free`, and the poles of both are 0.

    Parameters
    ----------
    poles : ndarray of complex, shape (n,)
    basis, inverse : ndarray of complex, shape (n, n)
    inputs : ndarray of complex, shape (n, 3 + M)
        In the basis.
    omega : float
        Angular frequency of cos and sin.
    free : int
        In how many ways nothing holds the body.
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
        found = grown.real @ inverse.real - grown.imag @ inverse.imag
        if free:
            moved = half.basis[:, :free] @ half.inverse[free : 2 * free]
            found = found + t[..., None, None] * moved.real
        return np.asarray(found)

    def driven(self, t: float | Vector) -> Matrix:
        """Return what the inputs make of rest in a time; shape (..., n, 3 + M), by input.

        The first two columns are by the cosine and the sine of the angle that the forcing has
        at the beginning: their sum with these as factors is the answer to the forcing.
        """
        half = self.upper
        return np.asarray((half.basis @ half.answered(half.drives, np.asarray(t))).real)

    @np.errstate(over="ignore", invalid="ignore")
    def answered(self, drives: Complex, t: Vector) -> Complex:
        """Return what drives, as `drives` are, make of rest; shape (..., n, k) by (3, n, k)."""
        waves = np.array([self.omega, -self.omega, 0.0])
        along = steady(self.poles, waves[:, None], t[..., None, None])
        found = np.einsum("wnk,...wn->...nk", drives, along)
        if self.free:
            moving, places = drives[:, self.free : 2 * self.free], found[..., : self.free, :]
            places += np.einsum("wnk,w...->...nk", moving, [twice(w, t) for w in waves])
        return np.asarray(found)

    def moved(self, start: Complex, drives: Complex, t: Vector) -> Complex:
        """Return z at times, by its start and what drives it, (3, n); shape (n, len(t))."""
        found = start[:, None] * np.exp(self.poles[:, None] * t)
        found[: self.free] += start[self.free : 2 * self.free, None] * t
        return np.asarray(found + self.answered(drives[..., None], t)[..., 0].T)

    def seen(self, rows: Matrix, y: Vector, inputs: Vector, t: Vector) -> Matrix:
        """Return linear forms of the state at times from its start; shape (len(rows), len(t)).

        `inputs` are the cosine and the sine at the start, 1 and the memory.
        """
        half = self.upper
        basis, start = rows @ half.basis, half.inverse @ y
        if self.is_clear(float(np.abs(t).max(initial=0.0))):
            return half._clear(basis, start, inputs, t)
        return np.asarray((basis @ half.moved(start, half.drives @ inputs, t)).real)

    @cached_property
    def upper(self) -> "Flow":
        """The poles of which real parts are taken: one of each pair, twice."""
        kept = self.poles.imag >= 0
        double = np.where(self.poles[kept].imag > 0, 2.0, 1.0)
        basis = self.basis[:, kept] * double
        return Flow(
            self.poles[kept], basis, self.inverse[kept], self.inputs[kept], self.omega,
            self.free,
        )  # fmt: skip

    @cached_property
    def condition(self) -> float:
        """How many times the digits of its vectors are those of a state: 1 at least."""
        norms = np.linalg.norm(self.basis) * np.linalg.norm(self.inverse)
        return float(norms) / max(len(self.poles), 1)

    @cached_property
    def drives(self) -> Complex:
        """What each input drives each pole by, shape (3, n, 3 + M).

        As factors of ``e^(i omega t)``, ``e^(-i omega t)`` and 1.
        """
        (cos, sin), found = self.inputs[:, :2].T / 2, np.zeros((3, *self.inputs.shape), complex)
        found[0, :, 0], found[0, :, 1] = cos - 1j * sin, sin + 1j * cos
        found[1, :, 0], found[1, :, 1] = cos + 1j * sin, sin - 1j * cos
        found[2, :, 2:] = self.inputs[:, 2:]
        return found

    def is_clear(self, longest: float) -> bool:
        """Whether no pole is near what drives it: then steady answers keep their digits."""
        driven = np.array([0.0, self.omega, -self.omega])
        return bool(np.abs(1j * driven - self.poles[:, None]).min() * longest >= CLEAR)

    def _clear(self, basis: Complex, start: Complex, inputs: Vector, t: Vector) -> Matrix:
        """Return forms of the state by steady answers and what of the start decays."""
        half, other, one = self.drives @ inputs
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
    free, rest = lawful.free, np.eye(len(lawful.A))
    if free.shape[1]:
        rest = np.linalg.qr(free, mode="complete")[0][:, free.shape[1] :]
    own = rest.T @ lawful.A @ rest
    poles, turned = graded(own, *np.linalg.eig(own))
    vectors = rest @ turned
    if free.shape[1]:  # the rest drives them: what is free is added to each vector
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
    """Return the inverse of an eigenbasis: its pairs stay pairs, with the digits of both."""
    above, below = np.flatnonzero(poles.imag > 0), np.flatnonzero(poles.imag < 0)
    real = basis.real.copy()
    real[:, below] = basis[:, above].imag
    found = np.linalg.inv(real).astype(complex)
    found[above] = (found[above] - 1j * found[below]) / 2
    found[below] = found[above].conj()
    return found


def graded(A: Matrix, poles: Complex, vectors: Complex) -> tuple[Complex, Complex]:
    """Return eigenvalues and vectors with the digits that their own sizes allow.

    Those of a matrix of many sizes come with the rounding of the largest, or where parts are
    coupled by rounding alone, with its square root.  What is left of ``A v - s v``, where the
    slow ones have hardly a part in the quick rows, corrects them as far as it is no rounding.
    """
    try:
        inverse = np.linalg.inv(vectors)
    except np.linalg.LinAlgError:
        return poles, vectors
    left, sizes = inverse @ (A @ vectors - vectors * poles), np.abs(vectors)
    rounding = np.abs(inverse) @ (np.abs(A) @ sizes + sizes * np.abs(poles))
    left[np.abs(left) <= np.finfo(float).eps * rounding] = 0.0
    apart = poles - poles[:, None] + np.eye(len(poles))
    turns = left / np.where(apart == 0, 1.0, apart) - np.diag(np.diag(left))
    counts = np.abs(turns).max(axis=0, initial=0.0) < TURN
    more = np.where(counts, np.vstack([np.diag(left), vectors @ turns]), 0.0)
    found = np.vstack([poles, vectors]) + more.astype(complex)
    found.imag[:, poles.imag == 0] = 0.0
    found[:, poles.imag < 0] = found[:, poles.imag > 0].conj()  # pairs stay pairs
    return found[0], found[1:]


def steady(poles: Complex, omega: float | Vector, t: float | Vector) -> Complex:
    """Return ``int_0^t e^(s (t - r)) e^(i omega r) dr``, at a resonance as well."""
    apart = 1j * omega - poles
    turned, decayed = apart * t, np.exp(poles * t)
    small = np.abs(turned) < 1.0
    far = (np.exp(1j * omega * t) - decayed) / np.where(apart == 0, 1.0, apart)
    if not small.any():
        return np.asarray(far)
    near = decayed * t * _phi(np.where(small, turned, 1.0))
    return np.asarray(np.where(small, near, far))


def twice(omega: float, t: Vector) -> Complex:
    """Return ``int_0^t (t - r) e^(i omega r) dr``: places that velocities are given to."""
    if omega == 0:
        return np.asarray(t * t / 2, dtype=complex)
    z = 1j * omega * t
    small = np.abs(z) < NEAR
    far = np.where(small, 1.0, z)
    found = (np.expm1(far) - far) / far**2
    if small.any():
        near, term = np.zeros_like(z), np.full_like(z, 0.5)
        for n in range(3, 3 + TERMS):
            near, term = near + term, term * z / n
        found = np.where(small, near, found)
    return np.asarray(t * t * found)


def _phi(z: Complex) -> Complex:
    """Return ``(e^z - 1)/z`` for moderate z."""
    safe = np.where(z == 0, 1.0, z)
    return np.where(z == 0, 1.0, np.expm1(safe) / safe)
