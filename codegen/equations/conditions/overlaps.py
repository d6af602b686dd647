"""Integrals of harmonics over single phases, in terms of which those over a cell are printed.

The integral over a cell of ``cos(l omega_0 t)``, with a weight that is constant on each phase,
is split: the weight of one phase over the whole cell, where harmonics are orthogonal, and the
differences of the other weights from it over their phases, ``C_l`` and ``S_l`` as in the paper.
"""

from collections.abc import Iterable, Iterator

import sympy as sp

from ...galerkin.harmonics import POWERS, Harmonics, j, n
from ...galerkin.legendre import l
from ...system import Equation, line
from ..notation import Notation
from ..tidy import SAME
from .functions import omega_0, t


class Overlaps:
    """The integrals of the harmonics of a scene."""

    def __init__(self, notation: Notation, harmonics: Harmonics) -> None:
        self.notation, self.weights = notation, harmonics.weights
        sizes = [
            sum(sp.count_ops(w) + (w != 0) for w in of_phase)
            for of_phase in zip(*self.weights.values(), strict=True)
        ]
        #: The phase whose weights are taken over the whole cell, the one with the simplest.
        self.base = sizes.index(min(sizes))

    def spelled(self, expression: sp.Expr) -> sp.Expr:
        """Return an expression with tables of the cell written in those of phases."""
        tables = {f"{wave}_{name}": (wave, name) for wave in "CS" for name in self.weights}
        values = {
            entry: self._entry(*tables[str(entry.base.label)], entry.indices[0])
            for entry in expression.atoms(sp.Indexed)
            if str(entry.base.label) in tables
        }
        return expression.xreplace(values)

    def _entry(self, wave: str, name: str, index: sp.Expr) -> sp.Expr:
        weights = self.weights[name]
        total = weights[self.base] * self._over_cell(wave, index)
        for p, weight in enumerate(weights):
            table = sp.IndexedBase(f"{wave}_{self.notation.scene.phases[p].name}")
            total += (weight - weights[self.base]) * table[index]
        return omega_0 ** POWERS.get(name, 0) * total

    def _over_cell(self, wave: str, index: sp.Expr) -> sp.Expr:
        """Return the integral of a harmonic over the cell."""
        cell = self.notation.cell
        if self.notation.times.sign == -1 and sp.Poly(index, j, n).eval((1, 1)) % 2:
            return sp.Integer(0) if wave == "C" else 2 / (index * omega_0)
        return cell * _is_zero(index) if wave == "C" else sp.Integer(0)

    def definitions(self, shown: Iterable[sp.Expr]) -> Iterator[Equation]:
        """Yield the definitions of the integrals that occur in some expressions."""
        occurring = {str(q.base.label) for e in shown for q in e.atoms(sp.Indexed)}
        for p, phase in enumerate(self.notation.scene.phases):
            for wave, function in (("C", sp.cos), ("S", sp.sin)):
                name = f"{wave}_{phase.name}"
                if name in occurring:
                    yield from self._definition(sp.IndexedBase(name), function, p)

    def _definition(
        self, table: sp.IndexedBase, f: type[sp.Function], p: int
    ) -> Iterator[Equation]:
        start, end = self.notation.at(p), self.notation.at(p + 1)
        integral = sp.Integral(f(l * omega_0 * t), (t, start, end))
        rising = [self._primitive(f, time) for time in (end, start)]
        title = f"integral of a harmonic over {self.notation.scene.phases[p].name}"
        yield line(title, (table[l], integral, rising[0] - rising[1]), "`l != 0`")
        zero = end - start if f is sp.cos else sp.Integer(0)
        yield line(title, (table[0], zero))

    def _primitive(self, f: type[sp.Function], time: sp.Expr) -> sp.Expr:
        """Return the primitive of a harmonic at a time; at the end of the cell a number."""
        full_angle = sp.pi * l * (2 if self.notation.times.sign == 1 else 1)
        angle = full_angle if time == self.notation.cell else l * omega_0 * time
        wave = sp.sin(angle) if f is sp.cos else -sp.cos(angle)
        return wave / (l * omega_0)


def _is_zero(index: sp.Expr) -> sp.Expr:
    """Return 1 where an index is zero, 0 elsewhere; `j` and `n` are 1 or more."""
    if not index.free_symbols:
        return sp.Integer(int(index == 0))
    slopes = [index.coeff(symbol) for symbol in (j, n)]
    if all(slope >= 0 for slope in slopes) and index.subs({j: 1, n: 1}) > 0:
        return sp.Integer(0)
    if slopes[1] != 0:
        return SAME
    return sp.KroneckerDelta(j, sp.solve(index, j)[0])
