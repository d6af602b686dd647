"""Forms along a phase of a body from a state on: values, slopes, and bounds by its poles.

In the eigenbasis of the phase a form is ``sum c_i e^(s_i t) + Re(w e^(i Omega t)) + constant``.
Each pole bounds its own part of every derivative by its modulus, so that fast modes count as
far as they ring.  A pole near the frequency of what drives it has no such parts: there
``z' = s z + drive`` bounds the derivatives.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...arrays import Complex, Matrix, Vector
from .regime import Regime

#: How near to a drive a pole has no parts of its own, as a part of the frequency of the
#: forcing; where nothing forces, of the fastest pole.
REACH, UNFORCED = 0.25, 1e-6

#: What of a pole and of its drive is rounding, as parts of the fastest pole and of a state.
STILL = 1e-12


@dataclass(frozen=True, eq=False)
class Along:
    """Some forms along a phase: `rows`, shape (F, W), from the state `Y` where it begins."""

    regime: Regime
    Y: Vector
    rows: Matrix

    def at(self, t: Vector) -> tuple[Matrix, Matrix]:
        """Return values and slopes at times from the beginning; shape (F, len(t)) each."""
        both = np.vstack([self.rows, self.rows @ self.regime.generator])
        found = seen(self.regime, self.Y, both, t)
        return found[: len(self.rows)], found[len(self.rows) :]

    @cached_property
    def sizes(self) -> Vector:
        """What each form is the sum of, added without sign, where the phase begins."""
        parts = self._parts
        waves = np.hypot(*self.rows[:, self._n : self._n + 2].T)
        modes = np.abs(parts.basis) @ np.abs(parts.start)
        return np.asarray(
            modes + waves + np.abs(self.rows[:, self._n + 2 :]) @ np.abs(self.Y[self._n + 2 :])
        )

    def bounds(self, order: int, t: Vector, h: float) -> Matrix:
        """Return what a derivative never exceeds from times on, for h; shape (F, len(t))."""
        parts, omega = self._parts, self.regime.part.flow.omega
        grow = np.exp(np.minimum(np.maximum(parts.s.real, 0.0) * h, 700.0))[:, None]
        decay = np.exp(np.minimum(np.outer(parts.s.real, t), 700.0))
        power = np.abs(parts.s)[:, None] ** order
        own = np.abs(parts.own)[:, None] * decay * power * grow
        if parts.near.any():
            size, drive = np.abs(parts.start)[:, None], parts.drive[:, None]
            damped = np.maximum(-parts.s.real, 0.0)[:, None]
            for_long = np.minimum(t, 1 / np.maximum(damped, 1e-300)) * np.maximum(decay, 1.0)
            most = (size * decay + drive * (for_long + h)) * grow
            terms = [
                np.abs(parts.s)[:, None] ** (order - 1 - k) * omega**k for k in range(order)
            ]
            own[parts.near] = (power * most + drive * sum(terms))[parts.near]
        waves = np.abs(parts.wave) * omega**order
        return np.asarray(np.abs(parts.basis) @ own + waves[:, None])

    def least(self, t: float) -> Vector:
        """Return what each form is never below from a time on; minus infinity if not known."""
        parts = self._parts
        still = np.abs(parts.s) <= STILL * np.abs(parts.s).max()
        still &= parts.drive <= STILL * np.abs(self.Y).max()
        moving = parts.near & ~still
        if moving.any() or (parts.s.real > 0)[~still].any():
            return np.full(len(self.rows), -np.inf)
        left = np.where(still, 0.0, np.abs(parts.own) * np.exp(parts.s.real * t))
        kept = (parts.basis[:, still] @ parts.start[still]).real
        turning = np.abs(parts.wave) + np.abs(parts.basis) @ left
        return np.asarray(parts.constant + kept - turning)

    def fastest(self, part: float) -> float:
        """Return the rate above which poles make no more than a part of the first form."""
        parts = self._parts
        turns = np.argsort(np.abs(parts.s))[::-1]
        beyond = np.cumsum((np.abs(parts.basis[0]) * np.abs(parts.own))[turns])
        counted = np.abs(parts.s)[turns][beyond > part * self.sizes[0]]
        return float(counted.max(initial=0.0))

    @property
    def _n(self) -> int:
        return self.regime.states

    @cached_property
    def _parts(self) -> "_Parts":
        flow, n, inputs = self.regime.part.flow, self._n, self.Y[self._n :]
        half = flow.upper
        s, basis = half.poles, self.rows[:, :n] @ half.basis
        start = half.inverse @ self.Y[:n]
        drives = half.drives(inputs)
        turns = 1j * np.array([flow.omega, -flow.omega, 0.0])
        apart = turns[:, None] - s
        near = np.abs(apart).min(axis=0) <= (
            REACH * flow.omega or UNFORCED * np.abs(s).max(initial=1.0)
        )
        up, down, one = np.array(drives) / np.where(near, 1.0, apart) * ~near
        wave = basis @ up + (basis @ down).conj()
        wave = wave + (self.rows[:, n] - 1j * self.rows[:, n + 1]) * (
            inputs[0] + 1j * inputs[1]
        )
        constant = (basis @ one).real + self.rows[:, n + 2 :] @ inputs[2:]
        own = np.where(near, 0.0, start - up - down - one)
        drive = np.abs(drives).sum(axis=0) * near
        return _Parts(s, basis, start, own, near, drive, wave, constant)


@dataclass(frozen=True, eq=False)
class _Parts:
    """What forms are made of.

    Parameters
    ----------
    s : ndarray of complex, shape (m,)
        Poles, one of each pair.
    basis : ndarray of complex, shape (F, m)
        By which each is in each form.
    start, own : ndarray of complex, shape (m,)
        Of each pole where the phase begins, and what of it is free; 0 of one near a drive.
    drive : ndarray, shape (m,)
        What drives those that are near.
    """

    s: Complex
    basis: Complex
    start: Complex
    own: Complex
    near: "np.ndarray[tuple[int], np.dtype[np.bool_]]"
    drive: Vector
    wave: Complex
    constant: Vector


def seen(regime: Regime, Y: Vector, rows: Matrix, t: Vector) -> Matrix:
    """Return forms along a phase from a state on; shape (len(rows), len(t))."""
    n, flow = regime.states, regime.part.flow
    turned = (Y[n] + 1j * Y[n + 1]) * np.exp(1j * flow.omega * t)
    found = flow.seen(rows[:, :n], Y[:n], Y[n:], t)
    found = found + rows[:, n : n + 2] @ np.array([turned.real, turned.imag])
    return np.asarray(found + (rows[:, n + 2 :] @ Y[n + 2 :])[:, None])


def state_at(regime: Regime, Y: Vector, t: float) -> Vector:
    """Return y at a time from the state in which a phase begins."""
    n = regime.states
    return seen(regime, Y, np.eye(n, len(Y)), np.array([t]))[:, 0]
