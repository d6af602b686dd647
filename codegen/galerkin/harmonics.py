"""A motion as a Fourier series: inner products of harmonics, phase by phase, in closed form.

Over a cell whose phases have different coefficients, ``int w(t) cos(k omega_0 t) dt`` with the
weight w constant on each phase is one table for each coefficient of the equation of motion.
Products of harmonics are sums of harmonics, so every entry is a combination of two values.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, partial

import sympy as sp
from sympy.simplify.fu import TR8

from ..python_text import floating, python
from ..scene import LinearPhase, Scene, linear_phase
from .condition import N
from .tables import Table, tables_with_rates
from .times import Times, cycles, phi

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
    A memory, which is unknown, is part of the constant force.
    """
    return _equations(scene, ())


def _equations(scene: Scene, memory: tuple[sp.Symbol, ...]) -> tuple[LinearPhase, ...]:
    free = [linear_phase(phase, memory) for phase in scene.cell if phase.held is None]
    none = sp.Integer(0)
    rest = LinearPhase(free[0].m, none, none, none, none, (none,) * len(memory))
    return tuple(
        rest if phase.held is not None else linear_phase(phase, memory) for phase in scene.cell
    )


def _roots(index: sp.Expr) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """Yield where the number of a product of harmonics is zero, `j` and `n` from 1 on."""
    for symbol in (j, n):
        if index.has(symbol):
            slope = index.coeff(symbol)
            root = sp.expand(symbol - index / slope)
            if root.is_positive:
                yield symbol, root
            return
    if index == 0:
        yield sp.Integer(0), sp.Integer(0)


def ends_of_phases(times: Times) -> str:
    """Return where the phases begin, and where the last one ends, in Python."""
    starts = (times.start(p) for p in range(1, len(times.durations) + 1))
    return f"({', '.join(('0.0', *map(python, starts)))})"


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

    @property
    def odd(self) -> bool:
        """Whether only odd harmonics are there."""
        return self.times.sign == -1

    def number(self, index: sp.Expr) -> sp.Expr:
        """Return the harmonic of an index: any, or odd where ``x(t + T/2) = -x(t)``."""
        return 2 * index - 1 if self.odd else index

    @cached_property
    def weights(self) -> Mapping[str, tuple[sp.Expr, ...]]:
        """The coefficients of the equation of motion on each phase, by their names."""
        memory = tuple(q.symbol for q in self.scene.memory)
        phases = _equations(self.scene, memory)
        found = {name: tuple(getattr(q, name) for q in phases) for name in POWERS}
        for i, symbol in enumerate(memory):
            found[f"w_{symbol}"] = tuple(q.memory[i] for q in phases)
        return found

    def tables(self) -> Iterator[Table]:
        """Yield the tables that the conditions look up, with their derivatives."""
        highest, ends = self._highest(), ends_of_phases(self.times)
        period = python(self.times.period)
        over = f"over_phases = harmonic_integrals({ends}, {period}, {highest}, rates)"
        for name, values in self.weights.items():
            if not any(values):
                continue
            power = POWERS.get(name, 0)
            phases = ", ".join(map(floating, values)) + "," * (len(values) == 1)
            prepare = (
                f"{over}\nover_{name} = weighted_integrals(over_phases, ({phases}), {power}, "
                f"{ends}, {period})"
            )
            whole = values[0] * self.omega_0**power * self.times.cell
            uniform = all(value == values[0] for value in values) and name != "g"
            for row, letter in enumerate("CS"):
                yield from tables_with_rates(
                    f"{letter}_{name}",
                    self.times.durations,
                    f"over_{name}[{row}]",
                    prepare,
                    partial(self._over_whole_cell, whole if letter == "C" else sp.Integer(0))
                    if uniform
                    else None,
                )

    def _highest(self) -> str:
        """Return the highest harmonic that is integrated: of products, or of the forcing."""
        last = self.number(N)
        products = python(sp.expand(2 * last))
        if self.times.frequency is None:
            return products
        return f"max({products}, {python(sp.expand(last + cycles))})"

    def _over_whole_cell(self, whole: sp.Expr, index: sp.Expr) -> sp.Expr | None:
        """Return an integral with a uniform weight, `whole` for the constant.

        All harmonics of a period are orthogonal over it, the even ones over half of it as well.
        """
        if self.odd and any(q % 2 for q in sp.Poly(index, j, n).coeffs()):
            return None
        return whole * sp.Add(*(sp.KroneckerDelta(q, at) for q, at in _roots(index)))

    def over_cell(self, name: str, product: sp.Expr) -> sp.Expr:
        """Return the integral of a weight times a product of harmonics, from its tables.

        Those of m and c have the power of ``omega_0`` in them.

        `product` is in ``sin(number * angle)`` and ``cos(number * angle)``.
        """
        if not any(self.weights[name]):
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
        """Return the inner product of constant force and forcing with a test function.

        The forcing is the harmonic of as many periods as there are in the period.
        """
        total = self.over_cell("f", test)
        for memory in self.scene.memory:
            total += memory.symbol * self.over_cell(f"w_{memory.symbol}", test)
        if self.times.frequency is None:
            return total
        turned = cycles * angle
        turning = sp.cos(phi) * sp.cos(turned) - sp.sin(phi) * sp.sin(turned)
        for part in sp.Add.make_args(turning):
            size = sp.Mul(*(q for q in sp.Mul.make_args(part) if not q.has(angle)))
            total += size * self.over_cell("g", part / size * test)
        return total
