"""A body by its poles: ``z' = s z + b force``, ``x = Re sum c z`` and the forced response."""

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from ..arrays import Complex, Matrix, Vector
from .flow import WORST
from .laws import free, places
from .modal import BodyError, Modal

#: How near the two real poles of a mode may be, as a part of them.
APART = 1e-6


@dataclass(frozen=True, eq=False)
class Poles:
    """The poles of a body, of each pair the one above the real axis.

    Parameters
    ----------
    s : ndarray of complex, shape (m,)
    b, c : ndarray of complex, shape (m, contacts)
        ``z' = s z + b force``, and ``x = Re sum c z``.
    response : ndarray of complex, shape (contacts,)
        H of ``x = Re(H e^(i theta))``, the answer to the forcing.
    omega : float
        Its angular frequency.
    """

    s: Complex
    b: Complex
    c: Complex
    response: Complex
    omega: float

    @cached_property
    def seen(self) -> tuple[Complex, Complex]:
        """What forms are of, but for forces, 1 and memory: by the poles, and by the forcing."""
        contacts = self.b.shape[1]
        by_pole = np.zeros((2 + 4 * contacts, len(self.s)), dtype=complex)
        by_turn = np.zeros(len(by_pole), dtype=complex)
        x, v, _, a = places(contacts)
        for j, q in enumerate((x, v, a)):
            by_pole[q] = (self.c * self.s[:, None] ** j).T
            by_turn[q] = self.response * (1j * self.omega) ** j
        by_turn[2] = 1.0
        return by_pole, by_turn

    def forms(self, rows: Matrix) -> "Forms":
        """Return linear forms, their force entries 0, in terms of the poles."""
        by_pole, by_turn = self.seen
        seen, memory = rows[:, : len(by_turn)], rows[:, len(by_turn) :]
        return Forms(seen @ by_pole, seen @ by_turn, rows[:, 3], memory)

    def rate(self, forms: "Forms", law: "Forms") -> "Forms":
        """Return the derivatives of forms by time where the contact forces are by a law."""
        by_force = (forms.poles @ self.b).real
        return Forms(
            forms.poles * self.s + by_force @ law.poles,
            1j * self.omega * forms.turn + by_force @ law.turn,
            by_force @ law.constant,
            by_force @ law.memory,
        )


@dataclass(frozen=True, eq=False)
class Forms:
    """Forms as ``Re sum poles z + Re(turn e^(i theta)) + constant + memory``.

    Parameters
    ----------
    poles : ndarray of complex, shape (k, m)
    turn : ndarray of complex, shape (k,)
    constant : ndarray, shape (k,)
    memory : ndarray, shape (k, M)
    """

    poles: Complex
    turn: Complex
    constant: Vector
    memory: Matrix

    def some(self, which: list[int]) -> "Forms":
        """Return some of them."""
        return Forms(*(q[which] for q in vars(self).values()))

    def at(self, angles: Vector, memory: Vector) -> Matrix:
        """Return their values where z is 0, at angles of the forcing; shape (k, n)."""
        wave = (self.turn[:, None] * np.exp(1j * angles)).real
        return np.asarray(wave + (self.constant + self.memory @ memory)[:, None])


@lru_cache(maxsize=64)
def poles_of(body: Modal, omega: float) -> Poles:
    """Return the poles of a body.

    Raises
    ------
    BodyError
        If two are too near to each other.
    """
    found = _of_modes(body) if body.is_proportional else _of_states(body, omega)
    rows = np.diag(body.squares - omega**2) + 1j * omega * body.damping
    try:
        answer = np.linalg.solve(rows, body.forcing.astype(complex))
    except np.linalg.LinAlgError:
        raise BodyError("an undamped mode is in resonance with the forcing") from None
    return Poles(*found, body.at.T @ answer + body.beyond, omega)


def _of_modes(body: Modal) -> tuple[Complex, Complex, Complex]:
    """Return s, b, c in closed form, where the damping does not couple the modes."""
    half = np.diag(body.damping) / 2
    root = np.sqrt((half**2 - body.squares).astype(complex))
    if (np.abs(root) <= APART * np.maximum(np.sqrt(np.abs(body.squares)), half)).any():
        _too_near()
    pair = root.imag != 0
    s = np.concatenate([-half + root, (-half - root)[~pair]])
    b = np.concatenate([body.at, body.at[~pair]]).astype(complex)
    # an impulse gives (e^(s1 t) - e^(s2 t))/(s1 - s2), of a pair a real part
    residues = np.concatenate([np.where(pair, 1.0, 0.5) / root, -0.5 / root[~pair]])
    return s, b, b * residues[:, None]


def _of_states(body: Modal, omega: float) -> tuple[Complex, Complex, Complex]:
    """Return s, b, c from the eigenvectors of the equations of first order."""
    own = free(body, omega, 0)
    s, basis = np.linalg.eig(own.A)
    if np.linalg.cond(basis) > WORST:
        _too_near()
    b = np.linalg.solve(basis, own.B.astype(complex))
    c = (own.rows[places(body.at.shape[1])[0], : len(own.A)] @ basis).T
    kept = s.imag >= 0
    double = np.where(s.imag > 0, 2.0, 1.0)[kept]
    return (
        s[kept].astype(complex),
        b[kept],
        np.asarray(c[kept] * double[:, None], dtype=complex),
    )


def _too_near() -> None:
    raise BodyError(
        "two of its poles are one (a mode with exactly critical damping): change its damping "
        "a little"
    )
