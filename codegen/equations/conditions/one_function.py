"""One function of class C^1 added to a Fourier series, (11) to (13), to be printed."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

import sympy as sp

from ...expansions import hb_c1
from ...galerkin import GalerkinConditions
from ...galerkin.legendre import l
from ...scene import LinearPhase
from ...system import Equation, Inner, line
from ..notation import Notation
from .functions import T, omega_0, t, u

#: The function, and its residual.
G, q = sp.Function("G")(t), sp.Function("q")(t)


@dataclass(frozen=True)
class OneFunction:
    """The function of `hb_c1`, with the interface of `Breaks`."""

    notation: Notation
    numbers: ClassVar = {"expansion": "11", "residual": "13"}
    tests: ClassVar = {"by_function": G}

    @staticmethod
    def is_in(conditions: GalerkinConditions) -> bool:
        """Return whether the coefficient of the function is an unknown of some conditions."""
        return any(block.symbol == hb_c1.c1 for block in conditions.blocks)

    def expansion(self) -> sp.Expr:
        """Return the term of the function in the displacement."""
        return hb_c1.c1 * G

    def definitions(self) -> Iterator[Equation]:
        """Yield (12), over ``T (T - t_1)**3``, in both phases."""
        t1 = self.notation.at(1)
        name = self.notation.switches[1].before
        yield line(f"local time of {name}", (u, (t - t1) / (T - t1)))
        for p, value in enumerate(self._values()):
            title = f"function in {self.notation.switches[p].before}"
            yield Equation("12", title, (G, value), self.notation.during(p))

    def _values(self) -> tuple[sp.Expr, sp.Expr]:
        return -t / T, u**2 * (3 - 2 * u) - t / T

    def residual(self, p: int) -> sp.Expr:
        """Return the term of the function in the residual in phase `p`."""
        return hb_c1.c1 * q if p else sp.Integer(0)

    def residuals(self, p: int, phase: LinearPhase) -> Iterator[Equation]:
        """Yield the residual of the function in phase `p`; in the held one it is zero."""
        curvature = sp.diff(self._values()[p], u, 2) / (T - self.notation.at(1)) ** 2
        value = phase.m * curvature + phase.k * G if p else sp.Integer(0)
        yield line("residual of the function", (q, value), self.notation.during(p))

    def entries(self, expression: sp.Expr) -> sp.Expr:
        """Return an expression unchanged: its integrals are printed by their symbols."""
        return expression

    def integrals(self) -> Iterator[Equation]:
        """Yield the definitions of the integrals with harmonics."""
        for base, f in ((hb_c1.BY_COSINE, sp.cos), (hb_c1.BY_SINE, sp.sin)):
            sides = (base[l], Inner(q, f(l * omega_0 * t)))
            yield line("integral of the residual with a harmonic", sides)
