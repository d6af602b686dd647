"""Conditions on a Fourier series, to be printed: expansion, residual, orthogonality."""

from collections.abc import Iterator
from itertools import pairwise

import sympy as sp

from ...galerkin import Condition, GalerkinConditions
from ...galerkin.condition import N
from ...galerkin.harmonics import Harmonics, a, a0, b, equations, j, n
from ...system import Equation, Inner, line
from ..tidy import by_unknown
from .breaks import Breaks
from .family import Family
from .functions import R, Rate, T, omega_0, t, x
from .one_function import OneFunction
from .overlaps import Overlaps


class Fourier(Family):
    """The equations of a scene by a Fourier series, with or without further functions."""

    def __init__(self, conditions: GalerkinConditions) -> None:
        super().__init__(conditions)
        self.harmonics = Harmonics.of(conditions.scene)
        self.overlaps = Overlaps(self.notation, self.harmonics)
        self.beside: Breaks | OneFunction = (
            OneFunction(self.notation)
            if OneFunction.is_in(conditions)
            else Breaks(conditions, self.notation)
        )
        self.section = "3.1" if self.beside.expansion() == 0 else "3.2"

    @staticmethod
    def fits(conditions: GalerkinConditions) -> bool:
        """Return whether the unknowns are those of a Fourier series."""
        return any(block.symbol == a for block in conditions.blocks)

    def equations(self) -> Iterator[Equation]:
        """Yield the expansion, the residual, the conditions, and the tables they use."""
        number = self.beside.numbers["expansion"]
        yield Equation(number, "expansion", (x(t), self._series() + self.beside.expansion()))
        yield line("frequency", (omega_0, 2 * sp.pi / T))
        yield from self.beside.definitions()
        yield from self._residual()
        yield Equation("8", "inner product", self._inner_product())
        yield from self.rows
        yield from self._impulses()
        yield from self._tables()
        yield from self.beside.integrals()

    def jacobian(self) -> Iterator[Equation]:
        """Yield the derivatives of the tables by the times."""
        for row in self._tables():
            yield from self._rates(row)

    def _tables(self) -> Iterator[Equation]:
        """Yield the definitions of the tables that the conditions use."""
        return self.overlaps.definitions(side for row in self.rows for side in row.sides)

    def _rates(self, row: Equation) -> Iterator[Equation]:
        """Yield the derivatives of one table by the times of the switches."""
        notation = self.notation
        half_turns = 2 if notation.times.sign == 1 else 1
        name, value = row.sides[0], row.sides[-1]
        for p in range(1, len(notation.switches) + 1):
            time = notation.at(p)
            moving = value.subs(omega_0, half_turns * sp.pi / notation.cell)
            rate = sp.expand(notation.in_times(sp.diff(moving, time)))
            if rate == 0:
                continue
            sides = (sp.Derivative(name, time, evaluate=False), rate)
            yield line("time derivative", sides, row.where)

    def _wave(self, f: type[sp.Function], index: sp.Expr) -> sp.Expr:
        return f(self.harmonics.times.harmonic(index) * omega_0 * t)

    def _series(self) -> sp.Expr:
        waves = a[n] * self._wave(sp.sin, n) + b[n] * self._wave(sp.cos, n)
        return sp.Sum(waves, (n, 1, N)) + self._mean()

    def _mean(self) -> sp.Expr:
        return a0 / 2 if self.notation.times.sign == 1 else sp.Integer(0)

    def _residual(self) -> Iterator[Equation]:
        """Yield the residual (4) of each phase."""
        sine, cosine = (self._wave(f, n) for f in (sp.sin, sp.cos))
        rate = self.harmonics.times.harmonic(n) * omega_0
        number = self.beside.numbers["residual"]
        for p, q in enumerate(equations(self.scene)):
            spring, damping = q.k - q.m * rate**2, q.c * rate
            waves = a[n] * (spring * sine + damping * cosine)
            waves += b[n] * (spring * cosine - damping * sine)
            force = q.f + q.g * self.notation.times.forcing(t)
            total = sp.Sum(waves, (n, 1, N)) + q.k * self._mean() - force
            name = self.scene.phases[p].name
            sides = (R, total + self.beside.residual(p))
            yield Equation(number, f"residual in {name}", sides, self.notation.during(p))
            yield from self.beside.residuals(p, q)

    def _inner_product(self) -> tuple[sp.Expr, sp.Expr]:
        first, second = sp.Function("a")(t), sp.Function("b")(t)
        ends = [self.notation.at(p) for p in range(len(self.notation.switches) + 1)]
        parts = (sp.Integral(first * second, (t, *limits)) for limits in pairwise(ends))
        return Inner(first, second), sp.Add(*parts, evaluate=False)

    def closed(self, condition: Condition) -> sp.Expr:
        """Return a condition as a sum of unknowns with their factors."""
        return by_unknown(condition, self.conditions.blocks, self.scene.symbols, self._factor)

    def _factor(self, factor: sp.Expr) -> sp.Expr:
        moved = self.notation.in_times(factor)
        return self.beside.entries(self.overlaps.spelled(moved))

    def title(self, condition: Condition) -> str:
        """Return the title of a condition, with the harmonics of this scene."""
        if condition.number == "5":
            return "residual, orthogonal to the constant"
        if condition.index is None:
            return condition.title
        name = "sin" if condition.name == "by_sine" else "cos"
        number = self.harmonics.times.harmonic(condition.index)
        angle = number if number.is_Symbol else f"({number})"
        return f"residual, orthogonal to `{name}({angle} omega_0 t)`".replace("*", " ")

    def tested(self, condition: Condition) -> tuple[sp.Expr, ...]:
        """Return the inner product of an orthogonality condition, with impulses."""
        tests = self.beside.tests | {
            "by_one": sp.Integer(1),
            "by_sine": self._wave(sp.sin, j),
            "by_cosine": self._wave(sp.cos, j),
        }
        test = tests[condition.name]
        product = Inner(R, test)
        for p, impulse in self._jumps().items():
            mass = self.harmonics.weights["m"][p]
            product -= mass * impulse * test.subs(t, self.notation.at(p))
        return (product,)

    def _jumps(self) -> dict[int, sp.Symbol]:
        """Return the unknown jump of the velocity at each switch that has one."""
        unknown = {str(block.symbol): block.symbol for block in self.conditions.blocks}
        named = {p: f"J_{switch.before}" for p, switch in enumerate(self.notation.switches)}
        return {p: unknown[name] for p, name in named.items() if name in unknown}

    def _impulses(self) -> Iterator[Equation]:
        for p, impulse in self._jumps().items():
            before, after = (Rate(1, self.notation.side(p, sign)) for sign in "-+")
            title = "the velocity jumps; the series has the mean of both sides"
            yield line(title, (impulse, after - before))
