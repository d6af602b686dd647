"""A body by its poles: ``z' = s z + b force``, ``x = Re sum c z`` and the forced response.

A rigid-body mode has a double pole at 0 and no steady response; an undamped mode may be in
resonance with the forcing.  Such a body is held at its contacts by auxiliary springs and
dampers, and b is for the sum of contact and auxiliary force.  The auxiliary force is a linear
form of the poles, and the laws, which are of the contact force, subtract it.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from ..arrays import Complex, Matrix, Vector
from .flow import ONE, WORST
from .laws import free, places
from .modal import Modal
from .systems import BodyError

#: Least relative distance of the two real poles of a mode.
APART = 1e-6

#: Relative size of a pole, and of its amplitude at the contacts, that is rounding.
STILL = 1e-11

#: Stiffness and damping of the auxiliary spring and damper at a contact, relative to the
#: effective mass there times a frequency squared, and times that frequency.
SPRING, DAMPER = 0.6, 0.8


@dataclass(frozen=True, eq=False)
class Held:
    """Auxiliary springs and dampers at the contacts; they do not act on truncated modes.

    Parameters
    ----------
    springs, dampers : ndarray, shape (contacts,)
    residual : ndarray, shape (contacts, contacts)
        Static compliance of the modes that are left out.
    beyond : ndarray of complex, shape (contacts,)
        What these add to the response to the forcing.
    """

    springs: Vector
    dampers: Vector
    residual: Matrix
    beyond: Complex


@dataclass(frozen=True, eq=False)
class Poles:
    """The poles of a body, of each pair the one in the upper half plane.

    Parameters
    ----------
    s : ndarray of complex, shape (m,)
    b, c : ndarray of complex, shape (m, contacts)
        ``z' = s z + b force``, and ``x = Re sum c z``.
    response : ndarray of complex, shape (contacts,)
        H of ``x = Re(H e^(i theta))``, the answer to the forcing.
    omega : float
        Its angular frequency.
    held : Held, optional
        What holds a body that moves freely.
    """

    s: Complex
    b: Complex
    c: Complex
    response: Complex
    omega: float
    held: Held | None = None

    @cached_property
    def seen(self) -> tuple[Complex, Complex]:
        """The variables of forms by the poles and by the forcing, without forces, 1, memory."""
        contacts = self.b.shape[1]
        by_pole = np.zeros((2 + 4 * contacts, len(self.s)), dtype=complex)
        by_turn = np.zeros(len(by_pole), dtype=complex)
        x, v, force, a = places(contacts)
        for j, q in enumerate((x, v, a)):
            by_pole[q] = (self.c * self.s[:, None] ** j).T
            by_turn[q] = self.response * (1j * self.omega) ** j
        by_turn[2] = 1.0
        if self.held is not None:
            turn, springs, dampers = 1j * self.omega, self.held.springs, self.held.dampers
            for variables, beyond in ((by_pole.T, 0.0), (by_turn, self.held.beyond)):
                place, velocity = variables[..., x] - beyond, variables[..., v] - turn * beyond
                reaction = springs * place + dampers * velocity
                variables[..., force] = -reaction
                variables[..., x] -= reaction @ self.held.residual
        return by_pole, by_turn

    def forms(self, rows: Matrix) -> "Forms":
        """Return linear forms in terms of the poles, without their parts by contact forces."""
        by_pole, by_turn = self.seen
        variables, memory = rows[:, : len(by_turn)], rows[:, len(by_turn) :]
        return Forms(variables @ by_pole, variables @ by_turn, rows[:, 3], memory)

    def rate(self, forms: "Forms", law: "Forms") -> "Forms":
        """Return the time derivatives of forms, with contact forces by a law."""
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

    def some(self, which: list[int] | slice) -> "Forms":
        """Return some of the forms."""
        return Forms(*(q[which] for q in vars(self).values()))

    def at(self, angles: Vector, memory: Vector) -> Matrix:
        """Return their values for z = 0, at angles of the forcing; shape (k, n)."""
        wave = (self.turn[:, None] * np.exp(1j * angles)).real
        return np.asarray(wave + (self.constant + self.memory @ memory)[:, None])


@lru_cache(maxsize=64)
def poles_of(body: Modal, omega: float, hold: bool = False) -> Poles:
    """Return the poles of a body; `hold` adds auxiliary springs and dampers.

    Raises
    ------
    BodyError
        If two poles nearly coincide, or the forcing is in resonance with a mode that no
        contact sees.
    """
    hold = hold or bool((body.squares == 0).any())
    held = held_by(body, omega) if hold else None
    is_closed = held is None and body.is_proportional
    poles = _of_modes(body) if is_closed else _of_states(body, omega, held)
    try:
        answer = _answer(body, omega, held)
    except np.linalg.LinAlgError:
        if not hold:
            return poles_of(body, omega, hold=True)
        raise BodyError("an undamped mode is in resonance with the forcing") from None
    return Poles(*poles, body.at.T @ answer + body.beyond, omega, held)


def _answer(body: Modal, omega: float, held: Held | None) -> Complex:
    """Return the response of the modes to the forcing, held or not.

    Raises
    ------
    numpy.linalg.LinAlgError
        If an undamped mode is in resonance.
    """
    turn, forcing = 1j * omega, body.forcing.astype(complex)
    if held is None and body.is_proportional:
        by_mode = body.squares - omega**2 + turn * np.diag(body.damping)
        if (by_mode == 0).any():
            raise np.linalg.LinAlgError
        return np.asarray(forcing / by_mode)
    rows = np.diag(body.squares - omega**2) + turn * body.damping
    if held is not None:
        rows += body.at * (held.springs + turn * held.dampers) @ body.at.T
    return np.asarray(np.linalg.solve(rows, forcing))


def held_by(body: Modal, omega: float) -> Held:
    """Return auxiliary springs and dampers, at the frequency of the forcing or of the body."""
    rate = omega or float(np.sqrt(np.abs(body.squares).mean())) or 1.0
    mass = 1 / np.diag(body.mobility)
    return Held(SPRING * rate**2 * mass, DAMPER * rate * mass, body.residual, body.beyond)


def _of_modes(body: Modal) -> tuple[Complex, Complex, Complex]:
    """Return s, b, c in closed form, for proportional damping."""
    half = np.diag(body.damping) / 2
    root = np.sqrt((half**2 - body.squares).astype(complex))
    if (np.abs(root) <= APART * np.maximum(np.sqrt(np.abs(body.squares)), half)).any():
        raise BodyError(ONE)
    pair = root.imag != 0
    s = np.concatenate([-half + root, (-half - root)[~pair]])
    b = np.concatenate([body.at, body.at[~pair]]).astype(complex)
    # an impulse gives (e^(s1 t) - e^(s2 t))/(s1 - s2), of a pair a real part
    residues = np.concatenate([np.where(pair, 1.0, 0.5) / root, -0.5 / root[~pair]])
    return s, b, b * residues[:, None]


def _of_states(
    body: Modal, omega: float, held: Held | None = None
) -> tuple[Complex, Complex, Complex]:
    """Return s, b, c from the eigenvectors of the first-order equations."""
    free_body = free(body, omega, 0)
    x, v, *_ = (free_body.rows[q, : len(free_body.A)] for q in places(body.at.shape[1]))
    A = (
        free_body.A
        if held is None
        else free_body.A - free_body.B @ (held.springs[:, None] * x + held.dampers[:, None] * v)
    )
    s, basis = np.linalg.eig(A)
    if np.linalg.cond(basis) > WORST:
        raise BodyError(ONE)
    b = np.linalg.solve(basis, free_body.B.astype(complex))
    c = (x @ basis).T
    sizes = np.abs(c).max(axis=1)  # a place that nothing holds or sees has a pole at 0
    retained = (s.imag >= 0) & (
        (np.abs(s) > STILL * np.abs(s).max()) | (sizes > STILL * sizes.max())
    )
    double = np.where(s.imag > 0, 2.0, 1.0)[retained]
    return (
        s[retained].astype(complex),
        b[retained],
        np.asarray(c[retained] * double[:, None], dtype=complex),
    )
