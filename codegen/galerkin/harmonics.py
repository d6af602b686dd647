"""A motion as a Fourier series: inner products of harmonics, phase by phase, in closed form.

Over a cell whose phases have different coefficients, ``int w(t) cos(k omega_0 t) dt`` with the
weight w constant on each phase is one table for each coefficient of the equation of motion.
Products of harmonics are sums of harmonics, so every entry is a combination of two of its values.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import sympy as sp
from sympy.simplify.fu import TR8

from ..scene import LinearPhase, Scene, linear_phase
from .condition import N
from .tables import Table
from .times import Times, phi

n, j = sp.symbols("n j", integer=True, positive=True)
angle = sp.Symbol("angle", real=True)
a, b = sp.IndexedBase("a", real=True), sp.IndexedBase("b", real=True)
a0 = sp.Symbol("a0", real=True)

#: The coefficients of an equation of motion, by which the tables are named, and the power of
#: ``omega_0`` that goes with the derivative that each multiplies.
POWERS = {"m": 2, "c": 1, "k": 0, "f": 0, "g": 0}


def equations(scene: Scene) -> tuple[LinearPhase, ...]:
    """Return the equation of motion of each phase; that of a held one times the mass.

    A constraint holds its velocity, so its residual is ``m x''``, comparable with the others.
    """
    free = [linear_phase(phase) for phase in scene.phases if phase.held is None]
    none = sp.Integer(0)
    rest = LinearPhase(free[0].m, none, none, none, none)
    return tuple(
        rest if phase.held is not None else linear_phase(phase) for phase in scene.phases
    )


@dataclass(frozen=True)
class Harmonics:
    """The harmonics of a scene and what integrals of them are tabulated.

    Parameters
    ----------
    scene : Scene
    times : Times
    """

    scene: Scene
    times: Times

    @property
    def omega_0(self) -> sp.Expr:
        """The fundamental frequency, from the unknown durations."""
        return 2 * sp.pi / self.times.period

    def number(self, index: sp.Expr) -> sp.Expr:
        """Return the harmonic of an index: all, or the odd ones where ``x(t + T/2) = -x(t)``."""
        return index if self.times.sign == 1 else 2 * index - 1

    def weights(self, name: str) -> tuple[sp.Expr, ...]:
        """Return a coefficient of the equation of motion on each phase."""
        return tuple(getattr(q, name) for q in equations(self.scene))

    def tables(self, printed: Callable[[sp.Expr], str]) -> Iterator[Table]:
        """Yield the tables that the conditions look up, with their derivatives."""
        highest = printed(sp.expand(2 * self.number(N) + 1))
        starts = (self.times.start(p) for p in range(1, len(self.scene.phases) + 1))
        ends = ", ".join(("0.0", *map(printed, starts)))
        for name in POWERS:
            values = self.weights(name)
            if not any(values):
                continue
            phases = ", ".join(f"1.0*({printed(value)})" for value in values)
            prepare = (
                f"over_{name} = harmonic_integrals(({phases},), {POWERS[name]}, ({ends}), "
                f"{printed(self.times.period)}, {highest})"
            )
            for row, letter in enumerate("CS"):
                yield from self._with_rates(f"{letter}_{name}", f"over_{name}[{row}]", prepare)

    def _with_rates(self, name: str, source: str, prepare: str) -> Iterator[Table]:
        durations = self.times.durations
        bases = [sp.IndexedBase(f"{name}_by_{time}") for time in durations]

        def rate(indices: tuple[sp.Expr, ...], time: sp.Symbol) -> sp.Expr:
            return bases[durations.index(time)][indices] if time in durations else sp.Integer(0)

        yield Table(sp.IndexedBase(name), rate, f"{source}[0]", prepare)
        for q, base in enumerate(bases):
            yield Table(base, lambda indices, time: sp.Integer(0), f"{source}[{1 + q}]", prepare)

    def over_cell(self, name: str, product: sp.Expr) -> sp.Expr:
        """Return the integral of a weight times a product of harmonics, from its tables.

        Those of m and c have the power of ``omega_0`` in them.

        `product` is in ``sin(number * angle)`` and ``cos(number * angle)``.
        """
        if not any(self.weights(name)):
            return sp.Integer(0)
        C, S = sp.IndexedBase(f"C_{name}"), sp.IndexedBase(f"S_{name}")
        total = sp.Integer(0)
        for term in sp.Add.make_args(sp.expand(TR8(sp.expand(product)))):
            waves = term.atoms(sp.sin, sp.cos)
            if not waves:
                total += term * C[0]
                continue
            (wave,) = waves
            index = sp.expand(wave.args[0] / angle)
            total += term / wave * (C if wave.func is sp.cos else S)[index]
        return total

    def residual_by(self, trial: sp.Expr, test: sp.Expr) -> sp.Expr:
        """Return the inner product of the residual of a harmonic with a test function."""
        rates = [sp.diff(trial, angle, order) for order in range(3)]
        pairs = zip(("k", "c", "m"), rates, strict=True)
        return sp.Add(*(self.over_cell(name, rate * test) for name, rate in pairs))

    def force_by(self, test: sp.Expr) -> sp.Expr:
        """Return the inner product of constant force and forcing with a test function."""
        total = self.over_cell("f", test)
        if self.times.frequency is None:
            return total
        turning = sp.cos(phi) * sp.cos(angle) - sp.sin(phi) * sp.sin(angle)
        for part in sp.Add.make_args(turning):
            size = sp.Mul(*(q for q in sp.Mul.make_args(part) if not q.has(angle)))
            total += size * self.over_cell("g", part / size * test)
        return total
