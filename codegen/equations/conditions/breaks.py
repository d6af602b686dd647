"""Functions with a break added to a Fourier series, to be printed.

In the record their coefficients are ``c2_flight``; their values at ends of phases and their
integrals with harmonics are entries of tables.  Printed are ``beta_n(u)``, Bernoulli or Euler
polynomials, and the residual ``r_n(t)`` of each.
"""

from collections.abc import Iterator
from typing import ClassVar

import sympy as sp

from ...expansions import hb_ck
from ...galerkin import GalerkinConditions
from ...galerkin.harmonics import beta
from ...galerkin.legendre import l
from ...scene import LinearPhase
from ...system import Equation, Inner, line
from ..notation import Notation
from .functions import member, omega_0, t, u

_n = sp.Symbol("n", integer=True, nonnegative=True)


class Breaks:
    """The functions with a break whose coefficients are unknowns of conditions, if any."""

    #: Further test functions of the residual: none.
    tests: ClassVar[dict[str, sp.Expr]] = {}

    def __init__(self, conditions: GalerkinConditions, notation: Notation) -> None:
        symbols = {block.symbol for block in conditions.blocks}
        possible = hb_ck.Expansion(conditions.scene, len(symbols))
        self.notation = notation
        #: The switch and the n of each function.
        self.orders = tuple((p, n) for p, n, c in possible.all() if c in symbols)
        #: Equation numbers of the paper, which has the series without functions.
        expansion, residual = ("", "") if self.orders else ("3", "4")
        self.numbers = {"expansion": expansion, "residual": residual}

    def _word(self, p: int) -> str:
        """Return the name of the phase that begins at switch `p`."""
        return self.notation.switches[p].before

    def unknown(self, p: int, n: int) -> sp.Expr:
        """Return the symbol of the coefficient of a function."""
        return sp.IndexedBase(f"c_{self._word(p)}", real=True)[n]

    def expansion(self) -> sp.Expr:
        """Return the sum of the functions in the displacement."""
        return sp.Add(*(self.unknown(p, n) * self._function(p, n) for p, n in self.orders))

    def _function(self, p: int, n: int) -> sp.Expr:
        return member(f"beta_{self._word(p)}", n, t)

    def argument(self, p: int, q: int, time: sp.Expr) -> tuple[int, sp.Expr]:
        """Return the sign of a function of switch `p` on phase `q`, and its `u` at a time."""
        part = sp.expand((time - self.notation.at(p)) / self.notation.cell)
        return (1, part) if q >= p else (self.notation.times.sign, part + 1)

    def definitions(self) -> Iterator[Equation]:
        """Yield the functions: on each phase, and as polynomials."""
        for p in dict.fromkeys(p for p, _ in self.orders):
            for q in range(len(self.notation.switches)):
                sign, part = self.argument(p, q, t)
                name = self._word(p)
                sides = (member(f"beta_{name}", _n, t), sign * member("beta", _n, part))
                title = f"function with its break where {name} begins"
                yield line(title, sides, self.notation.during(q))
        if not self.orders:
            return
        sign = self.notation.times.sign
        kind, where = ("Bernoulli", "") if sign == 1 else ("Euler", "`n = 1, 2, ...`")
        sides = (member("beta", _n, u), beta(_n, u, sign))
        yield line(f"by the polynomials of {kind}", sides, where)
        for n in sorted({n - r for _, n in self.orders for r in range(3)}):
            sides = (member("beta", n, u), beta(n, u, sign))
            yield line(f"function of order {n}", sides)

    def residual(self, q: int) -> sp.Expr:
        """Return the sum of the functions' terms in the residual in phase `q`."""
        return sp.Add(*(self.unknown(p, n) * self._part(p, n) for p, n in self.orders))

    def _part(self, p: int, n: int) -> sp.Expr:
        return member(f"r_{self._word(p)}", n, t)

    def residuals(self, q: int, phase: LinearPhase) -> Iterator[Equation]:
        """Yield the residual of each function in phase `q`."""
        cell = self.notation.cell
        for p, n in self.orders:
            sign, part = self.argument(p, q, t)
            terms = zip((phase.k, phase.c, phase.m), range(3), strict=True)
            total = sum(w * self._value(n - r, part) / cell**r for w, r in terms)
            title = f"residual of the function of order {n}"
            sides = (self._part(p, n), sp.expand_mul(sign * total))
            yield line(title, sides, self.notation.during(q))

    def _value(self, n: int, part: sp.Expr) -> sp.Expr:
        """Return ``beta_n``, as a number if it is constant or at the ends of the cell."""
        constant = part.is_number or n == 0
        value = beta(n, part, self.notation.times.sign) if constant else 0
        return value if constant else member("beta", n, part)

    def entries(self, expression: sp.Expr) -> sp.Expr:
        """Return an expression with entries of tables as they are printed."""
        values = {}
        for p, _ in self.orders:
            word = self._word(p)
            for entry in expression.atoms(sp.Indexed):
                label, indices = str(entry.base.label), entry.indices
                if label == f"beta_{word}":
                    n, q, left = map(int, indices)
                    sign, part = self.argument(p, q, self.notation.at(q + left))
                    values[entry] = sign * self._value(n, part)
        for p, n in self.orders:
            for wave, name in (("cos", "G"), ("sin", "H")):
                table = f"G{n}_{self._word(p)}_{wave}"
                for entry in expression.atoms(sp.Indexed):
                    if str(entry.base.label) == table:
                        values[entry] = self._integral(
                            name, p, n, self.notation.times.harmonic(entry.indices[0])
                        )
        return expression.xreplace(values)

    def _integral(self, name: str, p: int, n: int, index: sp.Expr) -> sp.Expr:
        return sp.IndexedBase(f"{name}_{self._word(p)}")[n, index]

    def integrals(self) -> Iterator[Equation]:
        """Yield the definitions of the integrals with harmonics."""
        for p, n in self.orders:
            for name, f in (("G", sp.cos), ("H", sp.sin)):
                inner = Inner(self._part(p, n), f(l * omega_0 * t))
                sides = (self._integral(name, p, n, l), inner)
                yield line("integral of a residual with a harmonic", sides)
