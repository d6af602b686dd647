"""Forms along a phase of a body from a state on: values, slopes, and bounds by its poles.

In the eigenbasis of the phase a form is ``sum c_i e^(s_i t) + Re(w e^(i Omega t)) + constant``.
Each pole bounds its own part of every derivative by its modulus, so that fast modes count as
far as they ring.  A pole near the frequency of what drives it has no such parts: there
``z' = s z + drive`` bounds the derivatives.

Functions over `Phases`: plain Python, or compiled by numba.
"""

import math
from typing import NamedTuple

import numpy as np

from ...arrays import Complex, Indices, Integers, Matrix, Vector
from ..steps.locate import NOISE
from .modes import Modes, modes_of, power_of, real_of, rounding_of, size_of, value_of
from .phases import TERMS, Phases

#: Size of a form on its own surface that is rounding, relative to its factors and the state.
ON_IT = 1e-6

#: Value of `Along.leading` for a form that is identically zero.
NEVER = TERMS + 1

#: Weight of the driven part of a pole beside its initial value, in the size of a form.
DRIVEN = 1 / 8

#: An exponent of which the exponential is finite.
LARGE = 700.0

#: Rounding of a pole, relative to the fastest, and of its drive, relative to the state.
STILL = 1e-12


class Along(NamedTuple):
    """Some forms along a phase.

    Parameters
    ----------
    modes : Modes
    by_poles, direct : ndarray of complex, shape (F, 2, m), (F, 2)
        The forms and their slopes, by the poles and by ``e^(i Omega t)``.
    moduli : ndarray, shape (F, m)
        Those of the factors of each form.
    fixed : ndarray, shape (F, 2)
        Their constant parts.
    leading : ndarray of int, shape (F,)
        Order of the first derivative that is not zero at the start; `TERMS` if none is found,
        `NEVER` if the form sees no pole.
    rate : ndarray, shape (F,)
        The modulus of that derivative.
    sizes : ndarray, shape (F,)
        The sum of the moduli of the terms of each form, initial and driven ones: its rounding
        is a part of it.
    near : ndarray of bool, shape (m,)
        Which poles are near the frequency that drives them.
    apart : ndarray, shape (m,)
        The distance of each pole that is near, from that frequency; infinity for the others
        of a forced body: to find where a form vanishes, their steady answers will do.
    free, drive : ndarray, shape (m,)
        The modulus of the free part of each pole that is not near, and of the drive of each
        that is.
    waves, constant : ndarray, shape (F,)
        The steady answers of the poles that are not near, in each form: amplitude and constant.
    window, growth : float
        See `Poles`.
    """

    modes: Modes
    by_poles: Complex
    direct: Complex
    moduli: Matrix
    fixed: Matrix
    leading: Integers
    rate: Vector
    sizes: Vector
    near: Indices
    apart: Vector
    free: Vector
    drive: Vector
    waves: Vector
    constant: Vector
    window: float
    growth: float


def leading(phases: Phases, row: int, Y: Vector, zero: bool) -> int:
    """Return the order of the first derivative that is not zero; `TERMS` if none is.

    `zero`: the state is known to be on the form's surface, whatever the rounding.
    """
    rates, rounding = phases.forms.rates[row], phases.forms.rounding[row]
    n = phases.poles.bases.shape[1]
    for order in range(TERMS):
        value = abs(value_of(rates[order], Y))
        size = rounding_of(rounding[order], Y, n)
        is_zero = zero and order == 0 and value <= ON_IT * _largest(rates[0], Y)
        if value > NOISE * size and not is_zero:
            return order
    return TERMS


def _largest(row: Vector, Y: Vector) -> float:
    """Return the sum of the factors of a form, times the largest entry of a state."""
    factors, entry = 0.0, 0.0
    for i in range(len(row)):
        factors += abs(float(row[i]))
        entry = max(entry, abs(float(Y[i])))
    return factors * entry


def sign_after(phases: Phases, row: int, Y: Vector, zero: bool) -> int:
    """Return the sign of a form just after a state: of its first nonzero derivative."""
    order = leading(phases, row, Y, zero)
    if order == TERMS:
        return 0
    value = value_of(phases.forms.rates[row, order], Y)
    return 1 if value > 0 else (-1 if value < 0 else 0)


def along_of(
    phases: Phases, omega: float, p: int, Y: Vector,
    rows: Integers, signs: Vector, zeros: Indices,
) -> Along:  # fmt: skip
    """Return some forms along a phase, from a state on.

    Parameters
    ----------
    rows : ndarray of int, shape (F,)
        Which forms.
    signs : ndarray, shape (F,)
        1 or -1: the factor of each.
    zeros : ndarray of bool, shape (F,)
        Which vanish at the state, exactly.
    """
    poles, count = phases.poles, len(rows)
    modes = modes_of(poles, omega, p, Y)
    n, m = poles.bases.shape[1], len(modes.poles)
    free, drive = _parts(modes, poles.near[p])
    by_poles = np.zeros((count, 2, m), np.complex128)
    direct, fixed = np.zeros((count, 2), np.complex128), np.zeros((count, 2))
    moduli, orders, rate = np.zeros((count, m)), np.zeros(count, np.int64), np.zeros(count)
    forcing = complex(float(Y[n]), float(Y[n + 1]))
    for f in range(count):
        row, sign = rows[f], float(signs[f])
        rates = phases.forms.rates[row]
        orders[f] = leading(phases, row, Y, zeros[f])
        rate[f] = abs(value_of(rates[min(orders[f], TERMS - 1)], Y))
        for k in range(2):
            up, down = float(rates[k, n]), float(rates[k, n + 1])
            direct[f, k] = sign * complex(up, -down) * forcing
            fixed[f, k] = sign * value_of(rates[k, n + 2 :], Y[n + 2 :])
            for i in range(m):
                by_poles[f, k, i] = sign * complex(phases.forms.by_poles[row, k, i])
        for i in range(m):
            moduli[f, i] = abs(complex(by_poles[f, 0, i]))
        if orders[f] == TERMS and _sees_none(by_poles[f, 0], rates[0, :n]):
            orders[f] = NEVER
    waves, constant, sizes = np.zeros(count), np.zeros(count), np.zeros(count)
    amounts = _amounts(modes, float(poles.window[p]))
    for f in range(count):
        wave, steady = _answer(modes, poles.near[p], by_poles[f, 0])
        waves[f] = abs(complex(direct[f, 0]) + wave)
        constant[f] = float(fixed[f, 0]) + steady
        sizes[f] = abs(complex(direct[f, 0]))
        sizes[f] += size_of(phases.forms.rates[rows[f], 0, n + 2 :], Y[n + 2 :])
        for i in range(m):
            sizes[f] += float(moduli[f, i]) * float(amounts[i])
    apart = np.zeros(m)
    for i in range(m):
        apart[i] = modes.least[i] if poles.near[p, i] or omega == 0 else math.inf
    return Along(
        modes, by_poles, direct, moduli, fixed, orders, rate, sizes, poles.near[p, :m], apart,
        free, drive, waves, constant, float(poles.window[p]), float(poles.growth[p]),
    )  # fmt: skip


def _sees_none(factors: Complex, row: Vector) -> bool:
    """Whether the factors of all poles are rounding, as in a form of what is held."""
    size = float(np.abs(row).sum())
    for factor in factors:  # noqa: SIM110  (numba has no `any`)
        if abs(factor) > STILL * size:
            return False
    return True


def _answer(modes: Modes, near: Indices, factors: Complex) -> tuple[complex, float]:
    """Return a form of the steady answers of the poles that are not near.

    The factor of ``e^(i Omega t)``, and the constant.
    """
    wave, constant = 0j, 0.0
    for i in range(len(factors)):
        if not near[i]:
            factor = complex(factors[i])
            wave += factor * complex(modes.answers[0, i])
            wave += (factor * complex(modes.answers[1, i])).conjugate()
            constant += (factor * complex(modes.answers[2, i])).real
    return wave, constant


def _parts(modes: Modes, near: Indices) -> tuple[Vector, Vector]:
    """Return the moduli of the free part and of the drive of each pole; see `Along.free`."""
    free, drive = np.zeros(len(modes.start)), np.zeros(len(modes.start))
    for i in range(len(free)):
        if near[i]:
            for k in range(3):
                drive[i] += abs(complex(modes.drives[k, i]))
        else:
            transient = complex(modes.start[i])
            for k in range(3):
                transient -= complex(modes.answers[k, i])
            free[i] = abs(transient)
    return free, drive


def _amounts(modes: Modes, window: float) -> Vector:
    """Return the size of each pole: of its initial value, or of its drive over a time."""
    amounts = np.zeros(len(modes.start))
    for i in range(len(amounts)):
        driven = 0.0
        for k in range(3):
            in_time = abs(complex(modes.drives[k, i])) * window
            driven += min(abs(complex(modes.answers[k, i])), in_time)
        amounts[i] = max(abs(complex(modes.start[i])), DRIVEN * driven)
    return amounts


def value_at(along: Along, f: int, z: Complex, wave: complex) -> tuple[float, float]:
    """Return value and slope of a form at a time, by the poles and ``e^(i Omega t)`` there."""
    value = real_of(along.by_poles[f, 0], z) + (complex(along.direct[f, 0]) * wave).real
    slope = real_of(along.by_poles[f, 1], z) + (complex(along.direct[f, 1]) * wave).real
    return value + float(along.fixed[f, 0]), slope + float(along.fixed[f, 1])


def put_bounds(along: Along, order: int, t: float, h: float, limits: Vector) -> None:
    """Fill in a bound of a derivative of each form on the interval from t to t + h.

    Where a body moves freely, one of order 2 or more.
    """
    modes = along.modes
    for f in range(len(limits)):
        limits[f] = float(along.waves[f]) * power_of(modes.omega, order)
    for i in range(len(along.free)):
        s, drive = complex(modes.poles[i]), float(along.drive[i])
        growth = math.exp(min(s.real * h, LARGE)) if s.real > 0 else 1.0
        decay = math.exp(min(s.real * t, LARGE))
        power = power_of(abs(s), order)
        modulus = float(along.free[i]) * decay * power * growth
        if along.near[i]:
            lasting = min(t, 1 / max(-s.real, 1e-300)) * max(decay, 1.0)
            modulus = (abs(complex(modes.start[i])) * decay + drive * (lasting + h)) * growth
            terms = 0.0
            for k in range(order):
                terms += power_of(abs(s), order - 1 - k) * power_of(modes.omega, k)
            modulus = power * modulus + drive * terms
        if along.near[i] and i < modes.free:  # a place, which this velocity moves
            modulus += float(along.drive[modes.free + i]) * power_of(modes.omega, order - 2)
        for f in range(len(limits)):
            limits[f] += float(along.moduli[f, i]) * modulus


def least(along: Along, t: float, size: float) -> Vector:
    """Return a lower bound of each form from a time on; minus infinity if none is known.

    `size` is that of the state.
    """
    modes, speeds, factors = along.modes, np.abs(along.modes.poles), along.by_poles[:, 0]
    still = (speeds <= STILL * speeds.max()) & (along.drive <= STILL * size)
    free = modes.free
    still[:free] &= still[free : 2 * free] & (modes.start[free : 2 * free] == 0)
    moving = along.near & ~still
    if moving.any() or (modes.poles.real > 0)[~still].any():
        return np.full(len(factors), -np.inf)
    transients = np.where(still, 0.0, along.free * np.exp(modes.poles.real * t))
    resting = (factors[:, still] @ modes.start[still]).real
    return np.asarray(along.constant + resting - along.waves - np.abs(factors) @ transients)


def fastest(along: Along, part: float) -> float:
    """Return the rate above which poles make no more than a part of the first form."""
    speeds = np.abs(along.modes.poles)
    order = np.argsort(speeds)[::-1]
    sums = np.cumsum((np.abs(along.by_poles[0, 0]) * along.free)[order])
    relevant = speeds[order][sums > part * along.sizes[0]]
    return float(relevant.max(initial=0.0))
