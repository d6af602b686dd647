"""A motion as a Fourier series: inner products of harmonics, phase by phase, in closed form.

For each coefficient w of the equation of motion, constant on each phase, the integrals
``int w(t) cos(k omega_0 t) dt`` over the cell are a table.  Products of harmonics are sums of
harmonics, so every inner product is a combination of two entries.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp
from sympy.simplify.fu import TR8

from ..scene import LinearPhase, Scene, linear_phase
from .condition import Times, cycles, phi

n, j = sp.symbols("n j", integer=True, positive=True)
angle = sp.Symbol("angle", real=True)
a, b = sp.IndexedBase("a", real=True), sp.IndexedBase("b", real=True)
a0 = sp.Symbol("a0", real=True)

#: The coefficients of an equation of motion, after which the tables are named, and the order of
#: the derivative that each multiplies: the power of ``omega_0`` in its table.
POWERS = {"m": 2, "c": 1, "k": 0, "f": 0, "g": 0}


def equations(scene: Scene, memory: tuple[sp.Symbol, ...] = ()) -> tuple[LinearPhase, ...]:
    """Return the equation of motion of each phase.

    The residual of a held phase is ``m x''``, in the unit of the others.  Memories that are not
    given are part of the constant force.
    """
    free = [linear_phase(phase, memory) for phase in scene.cell if phase.held is None]
    zero = sp.Integer(0)
    held = LinearPhase(free[0].m, zero, zero, zero, zero, (zero,) * len(memory))
    return tuple(
        held if phase.held is not None else linear_phase(phase, memory) for phase in scene.cell
    )


def beta(n: sp.Expr, u: sp.Expr, sign: int) -> sp.Expr:
    """Return ``beta_n(u)`` of `codegen.expansions.hb_ck` for ``u`` from 0 to 1.

    For a symbolic n, other than 0, the polynomial is not evaluated.
    """
    if sign == 1:
        return -sp.bernoulli(n, u) / sp.factorial(n) if n else sp.Integer(-1)
    return sp.euler(n - 1, u) / (2 * sp.factorial(n - 1)) if n else sp.Integer(0)


@dataclass(frozen=True)
class Harmonics:
    """The harmonics of a motion, and their integrals in terms of tables.

    Parameters
    ----------
    times : Times
    weights : mapping of str to tuple of Expr
        The coefficients of the equation of motion on each phase, by name: those of `POWERS`,
        then that of each memory.
    memory : tuple of Symbol
    """

    times: Times
    weights: Mapping[str, tuple[sp.Expr, ...]]
    memory: tuple[sp.Symbol, ...] = ()

    @classmethod
    def of(cls, scene: Scene) -> "Harmonics":
        """Return the harmonics of a scene."""
        memory = tuple(q.symbol for q in scene.memory)
        phases = equations(scene, memory)
        weights = {name: tuple(getattr(q, name) for q in phases) for name in POWERS}
        for i, symbol in enumerate(memory):
            weights[f"w_{symbol}"] = tuple(q.memory[i] for q in phases)
        return cls(Times.of(scene), weights, memory)

    @property
    def omega_0(self) -> sp.Expr:
        """The fundamental frequency, from the unknown durations."""
        return 2 * sp.pi / self.times.period

    @property
    def odd(self) -> bool:
        """Whether only odd harmonics occur."""
        return self.times.sign == -1

    def over_cell(self, name: str, product: sp.Expr) -> sp.Expr:
        """Return the integral over the cell of a weight times a product of harmonics.

        It is in entries of the tables of the weight; those of m and c include their power of
        ``omega_0``.  `product` is in ``sin(number * angle)`` and ``cos(number * angle)``.
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

        The forcing is harmonic number `cycles`.
        """
        total = self.over_cell("f", test)
        for symbol in self.memory:
            total += symbol * self.over_cell(f"w_{symbol}", test)
        if self.times.frequency is None:
            return total
        turned = cycles * angle
        total += sp.cos(phi) * self.over_cell("g", sp.cos(turned) * test)
        return total - sp.sin(phi) * self.over_cell("g", sp.sin(turned) * test)
