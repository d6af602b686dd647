"""The conditions of all methods by quadrature, from equations of motion in numbers.

Written from the equations of the oscillators, without `codegen`: trial and test functions,
their derivatives, breaks, and every row in the sequence of the kernels.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from math import pi

import numpy as np
from numpy.polynomial import Legendre, Polynomial
from numpy.polynomial.legendre import leggauss
from scipy.special import eval_sh_legendre, sh_legendre

#: On three panels: NumPy's weights for as many nodes on one are right to 1e-14 only.
NODES, WEIGHTS = leggauss(24)
NODES = np.concatenate([(panel + (NODES + 1) / 2) / 3 for panel in range(3)])
WEIGHTS = np.tile(WEIGHTS / 6, 3)

#: ``motion(p, u, order)``: a derivative by time on phase p, at local times from 0 to 1.
Motion = Callable[[int, np.ndarray, int], np.ndarray]


@dataclass(frozen=True)
class Oscillator:
    """An oscillator in numbers.

    Parameters
    ----------
    phases : tuple of (m, c, k, f, g)
        ``m x'' + c x' + k x = f + g cos(Omega t + phi)``; where the mass is held, ``m x''``.
    events : tuple of (x, v, cos, constant)
        What vanishes at the end of each phase.
    classes : tuple of int
        Of the switches that begin the phases.
    held : tuple of bool
    rho : float
        Velocity after an impact over that before.
    Omega : float or None
    sign : int
        -1 where the cell is half a period.
    cycles : int
        Periods of the forcing in the period.
    start : float or None
        Displacement in which the first phase begins, of functions that begin at switches, in
        place of its event.
    memory : tuple of (float, float)
        What the displacement in which the first phase begins, kept, is multiplied by: in the
        force on each phase, and in the event at its end.
    """

    phases: tuple[tuple[float, ...], ...]
    events: tuple[tuple[float, ...], ...]
    classes: tuple[int, ...]
    held: tuple[bool, ...]
    rho: float = 1.0
    Omega: float | None = None
    sign: int = 1
    cycles: int = 1
    memory: tuple[tuple[float, float], ...] = ()
    start: float | None = None


OSCILLATORS = {
    "S0": Oscillator(
        ((1, 0, 0, 0, 0), (1, 0, 1, 0, 0)),
        ((-1, 0, 0, 1), (0, 1, 0, -1)),
        *((1, 1), (True, False)),
        start=-1.0,
    ),
    "S1n2": Oscillator(
        ((1, 0.1, 1, 0, 1),), ((1, 0, 0, -0.1),), (0,), (False,), -0.6, 3.6, cycles=2
    ),
    "S4a": Oscillator(
        ((1, 0.1, 1.2, -0.5, 1), (1, 0.1, 0.2, 0.5, 1)),
        ((1, 0, 0, 1.0), (0, 1, 0, 0)),
        *((3, 2), (False, False)),
        Omega=0.8,
        sign=-1,
        memory=((1.0, -1.0), (0.0, 0.0)),
    ),
    "S1": Oscillator(((1, 0.1, 1, 0, 1),), ((1, 0, 0, -0.1),), (0,), (False,), -0.6, 1.8),
    "S2b": Oscillator(
        ((1, 0.2, 5, 2, 1), (1, 0.2, 1, 0, 1)),
        ((1, 0, 0, -0.5), (1, 0, 0, -0.5)),
        *((2, 2), (False, False)),
        Omega=1.3,
    ),
    "S3b": Oscillator(
        ((1, 0.1, 1, 0.5, 1), (1, 0, 0, 0, 0)),
        ((0, 1, 0, 0), (1, 0, -1, 0.6)),
        *((1, 1), (False, True)),
        Omega=0.4,
        sign=-1,
    ),
    "S5a": Oscillator(
        ((1, 0, 0, 0, 0), (1, 0.1, 1, 1, 0)),
        ((-1, 0, 0, 2.9), (0, 1, 0, -1)),
        *((1, 1), (True, False)),
    ),
    "S6": Oscillator(
        ((1, 0.1, 1, 0, 1),), ((1, 0, 0, 0.8),), (0,), (False,), -0.6, 1.2, sign=-1
    ),
    "S7": Oscillator(
        ((1, 0.1, 1, 0, 1), (1, 0, 0, 0, 0)),
        ((1, 0, 0, -0.1), (0, 0, 1, -0.1)),
        *((2, 0), (False, True)),
        rho=0.0,
        Omega=1.2,
    ),
}


class Cell:
    """A motion of an oscillator over one cell, and what its conditions ask of it."""

    def __init__(self, o: Oscillator, z: np.ndarray, motion: Motion) -> None:
        first = len(z) - len(o.phases) - (o.Omega is not None)
        self.o, self.motion, self.phi = o, motion, z[-1]
        self.s = z[first : first + len(o.phases)]
        self.w = z[first - 1] if o.memory else 0.0
        self.t = np.concatenate([[0.0], np.cumsum(self.s)])
        self.period = self.t[-1] if o.sign == 1 else 2 * self.t[-1]

    def forcing(self, time, order=0):
        """Return ``cos(Omega t + phi)`` or a derivative of it."""
        if self.o.Omega is None:
            return 0.0 * time
        return self.o.Omega**order * np.cos(self.o.Omega * time + self.phi + order * pi / 2)

    def residual(self, p):
        """Return the residual of phase p at the nodes."""
        m, c, k, f, g = self.o.phases[p]
        x, v, a = (self.motion(p, NODES, order) for order in range(3))
        f = f + self.kept(p)
        return m * a + c * v + k * x - f - g * self.forcing(self.t[p] + self.s[p] * NODES)

    def kept(self, p, column=0):
        """Return what the memory adds to the force on a phase, or to its event."""
        return self.o.memory[p][column] * self.w if self.o.memory else 0.0

    def on_phase(self, p, test):
        """Return the integral of residual times test over the local time of a phase."""
        return np.sum(WEIGHTS * self.residual(p) * test(NODES))

    def over_cell(self, test):
        """Return the integral of residual times test, in time, over the cell."""
        times = (self.t[p] + self.s[p] * NODES for p in range(len(self.s)))
        parts = (
            s * np.sum(WEIGHTS * self.residual(p) * test(t))
            for p, (s, t) in enumerate(zip(self.s, times, strict=True))
        )
        return sum(parts)

    def start(self, p, order):
        return float(self.motion(p, np.array([0.0]), order)[0])

    def end(self, p, order):
        """Return a derivative at the end of a phase, before an impact."""
        return float(self.motion(p, np.array([1.0]), order)[0])

    def left(self, p):
        """Return the phase before a switch, and the sign between both."""
        return (p - 1, 1) if p else (len(self.s) - 1, self.o.sign)

    def joints(self):
        """Yield continuity of displacement, the law of the velocity, smoothness."""
        for p, k in enumerate(self.o.classes):
            left, sign = self.left(p)
            yield self.start(p, 0) - sign * self.end(left, 0)
            rho = self.o.rho if k == 0 else 1.0
            yield self.start(p, 1) - sign * rho * self.end(left, 1)
            for order in range(2, k + 1 if not self.o.held[p] else 2):
                yield self.start(p, order) - sign * self.end(left, order)

    def jumps(self, functions):
        """Yield what the equation of motion, differentiated, says of the derivatives."""
        for p, k in enumerate(self.o.classes):
            left, sign = self.left(p)
            for order in range(k + 1, k + 1 + functions):
                if order == 1:
                    yield self.start(p, 1) - sign * self.o.rho * self.end(left, 1)
                else:
                    right = self._differentiated(p, order, self.start, self.t[p])
                    before = self._differentiated(left, order, self.end, self.t[left + 1])
                    yield right - sign * before

    def _differentiated(self, p, order, at, time):
        m, c, k, f, g = self.o.phases[p]
        terms = m * at(p, order) + c * at(p, order - 1) + k * at(p, order - 2)
        f = f + self.kept(p)
        return terms - (f if order == 2 else 0.0) - g * self.forcing(time, order - 2)

    def impacts(self):
        """Yield the law of the velocity at impacts alone."""
        for p, k in enumerate(self.o.classes):
            if k == 0:
                left, sign = self.left(p)
                yield self.start(p, 1) - sign * self.o.rho * self.end(left, 1)

    def events(self, after=False):
        """Yield the events, or what they say where the next phase begins."""
        for p, (x, v, cos, constant) in enumerate(self.o.events):
            q = (p + 1) % len(self.o.phases)
            sign = self.o.sign if q == 0 else 1
            place = sign * self.start(q, 0) if after else self.end(p, 0)
            smooth = after and self.o.classes[q] > 0
            velocity = sign * self.start(q, 1) if smooth else self.end(p, 1)
            terms = x * place + v * velocity + constant + self.kept(p, 1)
            yield terms + cos * self.forcing(self.t[p + 1])
        if self.o.memory:
            yield self.w - self.start(0, 0)
        if self.o.Omega is not None:
            turns = self.o.cycles * (1 if self.o.sign == -1 else 2)
            yield self.t[-1] - turns * pi / self.o.Omega

    def harmonics(self, N, impulses):
        """Yield the orthogonality to harmonics; impulses are those at the switches."""
        w = 2 * pi / self.period
        tests = [] if self.o.sign == -1 else [np.ones_like]
        tests += [lambda t, n=n: np.sin(n * w * t) for n in self.numbers(N)]
        tests += [lambda t, n=n: np.cos(n * w * t) for n in self.numbers(N)]
        for test in tests:
            delta = (
                self.o.phases[p][0] * J * float(test(np.array(self.t[p])))
                for p, J in enumerate(impulses)
            )
            yield self.over_cell(test) - sum(delta)

    def numbers(self, N):
        return range(1, N + 1) if self.o.sign == 1 else range(1, 2 * N, 2)


def polynomial_rows(o, z, N, tested):
    """Return the rows of `ck`, or of `ck-tau`.

    The residual of `ck` is `tested` with functions that leave of it the polynomials of Jacobi
    that belong to their weight: its parts are zero, less those of what is left.
    """
    times = z[len(z) - len(o.phases) - (o.Omega is not None) :]
    at, shapes, left = 0, [], []
    for p, k in enumerate(o.classes):
        count = 0 if o.held[p] else N + k
        x, v, d = z[at], z[at + 1], z[at + 2 : at + 2 + count]
        acceleration = Legendre(times[p] ** 2 * np.append(d, 0.0), domain=[0, 1])
        shapes.append(acceleration.integ(2, k=[times[p] * v, x], lbnd=0))
        at += 2 + count
        left.append(z[at : at + k + 1] if tested and not o.held[p] else z[:0])
        at += len(left[p])

    def motion(p, u, order):
        return shapes[p].deriv(order)(u) / times[p] ** order

    cell = Cell(o, z, motion)
    rows = []
    for p, k in enumerate(o.classes):
        count = N + k + 1 - max(1, k)
        unseen = sum(
            o.phases[p][0] * tau * jacobi(count + i, k + 1, NODES)
            for i, tau in enumerate(left[p])
        )
        for l in range(0 if o.held[p] else count + len(left[p])):
            test = (2 * l + 1) * eval_sh_legendre(l, NODES)
            rows.append(np.sum(WEIGHTS * (cell.residual(p) - unseen) * test))
    events = [*cell.events(after=o.Omega is None)]
    if tested and o.start is not None:
        events[0] = cell.start(0, 0) - o.start
    return np.array([*rows, *cell.joints(), *events])


def jacobi(m, b, u):
    """Return ``P_m^(0, b)(2 u - 1)`` by its recurrence: SciPy's loses four digits."""
    x, before, found = 2 * u - 1, 0.0 * u, np.ones_like(u)
    for n in range(1, m + 1):
        q = 2 * n + b
        ahead = (q - 1) * (q * (q - 2) * x - b**2) * found
        ahead = ahead - 2 * (n - 1) * (n + b - 1) * q * before
        before, found = found, ahead / (2 * n * (n + b) * (q - 2))
    return found


def shifted(n):
    return Polynomial(sh_legendre(n).coef[::-1])


def fourier_rows(o, z, N):
    """Return the rows of `hb`."""
    series, at = _series(o, z, N)
    impulses = [
        z[at + sum(k == 0 for k in o.classes[:p])] * (o.classes[p] == 0)
        for p in range(len(o.phases))
    ]
    times = z[len(z) - len(o.phases) - (o.Omega is not None) :]
    t = np.concatenate([[0.0], np.cumsum(times[: len(o.phases)])])

    def motion(p, u, order):
        found = series(t[p] + times[p] * u, order)
        if order == 1:  # half the jump at each end
            after = (p + 1) % len(o.phases)
            sign = o.sign if after == 0 else 1
            found = found + impulses[p] / 2 * (u == 0) - sign * impulses[after] / 2 * (u == 1)
        return found

    cell = Cell(o, z, motion)
    rows = cell.harmonics(N, impulses)
    return np.array([*rows, *cell.impacts(), *cell.events()])


def _series(o, z, N):
    """Return the Fourier series as a function of time, and where its coefficients end."""
    first = 1 if o.sign == 1 else 0
    mean = z[0] / 2 if first else 0.0
    a, b = z[first : first + N], z[first + N : first + 2 * N]
    s = z[len(z) - len(o.phases) - (o.Omega is not None) :][: len(o.phases)]
    w = 2 * pi / (np.sum(s) * (1 if o.sign == 1 else 2))
    numbers = range(1, N + 1) if o.sign == 1 else range(1, 2 * N, 2)

    def series(t, order):
        total = mean * (order == 0) + 0.0 * t
        for n, p, q in zip(numbers, a, b, strict=True):
            turned = n * w * t + order * pi / 2
            total = total + (n * w) ** order * (p * np.sin(turned) + q * np.cos(turned))
        return total

    return series, first + 2 * N


@cache
def broken(n, sign):
    """Return the function of u from 0 to 1 whose derivative of order n - 1 alone has a break.

    The first is a ramp or a step down that jumps by 1 where the cell begins again; each is the
    integral of the one before it, with no mean, or with opposite values at both ends.
    """
    if n == 1:
        return Polynomial([0.5, -1.0]) if sign == 1 else Polynomial([0.5])
    raw = broken(n - 1, sign).integ()
    return raw - (raw.integ()(1.0) if sign == 1 else raw(1.0) / 2)


def broken_rows(o, z, N, functions):
    """Return the rows of `hb-ck` with a number of functions a switch."""
    series, at = _series(o, z, N)
    s = z[len(z) - len(o.phases) - (o.Omega is not None) :][: len(o.phases)]
    t, cell_length = np.concatenate([[0.0], np.cumsum(s)]), np.sum(s)
    orders = [range(k + 2, k + 2 + functions) for k in o.classes]

    def motion(q, u, order):
        found = series(t[q] + s[q] * u, order)
        place = at
        for p, ns in enumerate(orders):
            shift = (t[q] - t[p]) / cell_length + (0 if q >= p else 1)
            for n in ns:
                value = broken(n, o.sign).deriv(order)(shift + s[q] / cell_length * u)
                found = (
                    found + z[place] * value * (1 if q >= p else o.sign) / cell_length**order
                )
                place += 1
        return found

    cell = Cell(o, z, motion)
    rows = cell.harmonics(N, [0.0] * len(s))
    return np.array([*rows, *cell.jumps(functions), *cell.events()])


def one_function_rows(o, z, N):
    """Return the rows of `hb-c1`: beside the series a cubic in the free phase, less a ramp."""
    series, at = _series(o, z, N)
    s = z[-2:]
    ramp, step = Polynomial([0, -1 / np.sum(s)]), Polynomial([0, 0, 3, -2])

    def beside(p, u, order):
        ramped = ramp.deriv(order)(p * s[0] + s[p] * u)
        return ramped + (step.deriv(order)(u) / s[p] ** order if p else 0.0)

    def motion(p, u, order):
        t = p * s[0] + s[p] * u
        return series(t, order) + z[at] * beside(p, u, order)

    def test(t):
        return beside(int(t[0] > s[0]), (t - s[0] * (t[0] > s[0])) / s[int(t[0] > s[0])], 0)

    cell = Cell(o, z, motion)
    by_itself = cell.over_cell(test)
    return np.array([*cell.harmonics(N, [0.0, 0.0]), by_itself, *cell.events()])


def rows(name, kernel, z, N):
    """Return what the residual of a kernel is to be, at N terms."""
    o = OSCILLATORS[name]
    if kernel.startswith("ck"):
        return polynomial_rows(o, z, N, tested=kernel == "ck")
    if kernel == "hb_c1":
        return one_function_rows(o, z, N)
    if kernel == "hb":
        return fourier_rows(o, z, N)
    return broken_rows(o, z, N, int(kernel[-1]))
