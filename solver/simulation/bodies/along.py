"""Forms along a phase of a body from a state on: values, slopes, and bounds by its poles.

In the eigenbasis of the phase a form is ``sum c_i e^(s_i t) + Re(w e^(i Omega t)) + constant``.
Each pole bounds its own part of every derivative by its modulus, so that fast modes count as
far as they ring.  A pole near the frequency of what drives it has no such parts: there
``z' = s z + drive`` bounds the derivatives.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ...arrays import Complex, Indices, Matrix, Vector
from ...bodies.flow import CLEAR, Flow
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

    @np.errstate(over="ignore", invalid="ignore")  # a motion may grow beyond float64
    def at(self, t: Vector, form: int | None = None) -> tuple[Matrix, Matrix]:
        """Return values and slopes at times from the beginning; shape (F, len(t)) each.

        Of one form alone, if one is given.
        """
        parts, count = self._parts, len(self.rows)
        which = slice(None) if form is None else slice(form, None, count)
        clear = parts.apart * np.abs(t).max() >= CLEAR
        free = self._all_free if clear.all() else parts.free(clear)
        basis, waves = parts.basis[which], free.waves[which, None]
        z = free.own[:, None] * np.exp(parts.s[:, None] * t)
        if not clear.all():
            z[~clear] = parts.driven(~clear, t)
        found = (basis @ z).real + (waves * np.exp(1j * self._omega * t)).real
        found += free.constant[which, None]
        return found[: len(found) // 2], found[len(found) // 2 :]

    @cached_property
    def sizes(self) -> Vector:
        """What each form is the sum of, added without sign, where the phase begins."""
        n, modes = self._n, np.abs(self._basis) @ np.abs(self._parts.start)
        waves = np.hypot(*self.rows[:, n : n + 2].T)
        rest = np.abs(self.rows[:, n + 2 :]) @ np.abs(self.Y[n + 2 :])
        return np.asarray(modes + waves + rest)

    @np.errstate(over="ignore")  # infinite is a bound, too
    def bounds(self, order: int, t: Vector, h: float) -> Matrix:
        """Return what a derivative never exceeds from times on, for h; shape (F, len(t))."""
        parts, omega = self._parts, self._omega
        grow = np.exp(np.minimum(np.maximum(parts.s.real, 0.0) * h, 700.0))[:, None]
        decay = np.exp(np.minimum(np.outer(parts.s.real, t), 700.0))
        power = np.abs(parts.s)[:, None] ** order
        own = np.abs(self._far.own)[:, None] * decay * power * grow
        if parts.near.any():
            size, drive = np.abs(parts.start)[:, None], self._drive[:, None]
            damped = np.maximum(-parts.s.real, 0.0)[:, None]
            for_long = np.minimum(t, 1 / np.maximum(damped, 1e-300)) * np.maximum(decay, 1.0)
            most = (size * decay + drive * (for_long + h)) * grow
            terms = [
                np.abs(parts.s)[:, None] ** (order - 1 - k) * omega**k for k in range(order)
            ]
            own[parts.near] = (power * most + drive * sum(terms))[parts.near]
            free = self._parts.flow.free  # places, which these velocities move
            own[:free] += drive[free : 2 * free] * omega ** (order - 2)
        waves = np.abs(self._far.waves[: len(self.rows)]) * omega**order
        return np.asarray(np.abs(self._basis) @ own + waves[:, None])

    def least(self, t: float) -> Vector:
        """Return what each form is never below from a time on; minus infinity if not known."""
        parts, far, count = self._parts, self._far, len(self.rows)
        still = np.abs(parts.s) <= STILL * np.abs(parts.s).max()
        still &= self._drive <= STILL * np.abs(self.Y).max()
        free = parts.flow.free
        still[:free] &= still[free : 2 * free] & (parts.start[free : 2 * free] == 0)
        moving = parts.near & ~still
        if moving.any() or (parts.s.real > 0)[~still].any():
            return np.full(count, -np.inf)
        left = np.where(still, 0.0, np.abs(far.own) * np.exp(parts.s.real * t))
        kept = (self._basis[:, still] @ parts.start[still]).real
        turning = np.abs(far.waves[:count]) + np.abs(self._basis) @ left
        return np.asarray(far.constant[:count] + kept - turning)

    def fastest(self, part: float) -> float:
        """Return the rate above which poles make no more than a part of the first form."""
        parts = self._parts
        turns = np.argsort(np.abs(parts.s))[::-1]
        beyond = np.cumsum((np.abs(self._basis[0]) * np.abs(self._far.own))[turns])
        counted = np.abs(parts.s)[turns][beyond > part * self.sizes[0]]
        return float(counted.max(initial=0.0))

    @property
    def _n(self) -> int:
        return self.regime.states

    @property
    def _omega(self) -> float:
        return self.regime.part.flow.omega

    @property
    def _basis(self) -> Complex:
        """By which each pole is in each form."""
        return self._parts.basis[: len(self.rows)]

    @cached_property
    def _drive(self) -> Vector:
        """What drives the poles that are near to it."""
        return np.asarray(np.abs(self._parts.drives).sum(axis=0) * self._parts.near)

    @cached_property
    def _all_free(self) -> "_Free":
        return self._parts.free(np.ones(len(self._parts.s), dtype=bool))

    @cached_property
    def _far(self) -> "_Free":
        return self._parts.free(~self._parts.near)

    @cached_property
    def _parts(self) -> "_Parts":
        flow, n, inputs = self.regime.part.flow, self._n, self.Y[self._n :]
        both = np.vstack([self.rows, self.rows @ self.regime.generator])
        half, turns = flow.upper, 1j * np.array([flow.omega, -flow.omega, 0.0])
        apart = turns[:, None] - half.poles
        least = np.abs(apart).min(axis=0)
        reach = REACH * flow.omega or UNFORCED * np.abs(half.poles).max(initial=1.0)
        drives = np.array(half.drives(inputs))
        direct = (both[:, n] - 1j * both[:, n + 1]) * (inputs[0] + 1j * inputs[1])
        return _Parts(
            half, both[:, :n] @ half.basis, half.inverse @ self.Y[:n], drives,
            drives / np.where(apart == 0, 1.0, apart), least, least <= reach, direct,
            both[:, n + 2 :] @ inputs[2:],
        )  # fmt: skip


@dataclass(frozen=True, eq=False)
class _Free:
    """What poles that are not near to their drives make of forms.

    Parameters
    ----------
    own : ndarray of complex, shape (m,)
        What of each pole is free where the phase begins; 0 of one that is near.
    waves : ndarray of complex, shape (2 F,)
        Factors of ``e^(i Omega t)``.
    constant : ndarray, shape (2 F,)
    """

    own: Complex
    waves: Complex
    constant: Vector


@dataclass(frozen=True, eq=False)
class _Parts:
    """What forms and their slopes are made of.

    Parameters
    ----------
    flow : Flow
        By poles, one of each pair.
    basis : ndarray of complex, shape (2 F, m)
        By which each is in each form, and in each slope.
    start : ndarray of complex, shape (m,)
        Of each pole where the phase begins.
    drives, answers : ndarray of complex, shape (3, m)
        What drives each, by ``e^(i Omega t), e^(-i Omega t), 1``, and its steady answers.
    apart : ndarray, shape (m,)
        How far each pole is from what drives it.
    near : ndarray of bool, shape (m,)
        Which have no steady answer.
    direct : ndarray of complex, shape (2 F,)
    fixed : ndarray, shape (2 F,)
        What forms have without poles: factors of ``e^(i Omega t)``, and constants.
    """

    flow: Flow
    basis: Complex
    start: Complex
    drives: Complex
    answers: Complex
    apart: Vector
    near: Indices
    direct: Complex
    fixed: Vector

    @property
    def s(self) -> Complex:
        """The poles."""
        return self.flow.poles

    def free(self, clear: Indices) -> _Free:
        """Return what some of the poles make of forms, by their steady answers."""
        up, down, one = np.where(clear, self.answers, 0.0)
        waves = self.basis @ up + (self.basis @ down).conj() + self.direct
        constant = (self.basis @ one).real + self.fixed
        return _Free(np.where(clear, self.start, 0.0) - up - down - one, waves, constant)

    def driven(self, which: Indices, t: Vector) -> Complex:
        """Return some of the poles at times, also where they are near to their drives."""
        flow = self.flow
        some = replace(flow, poles=flow.poles[which], inputs=flow.inputs[which])
        return some.moved(self.start[which], list(self.drives[:, which]), t)


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
