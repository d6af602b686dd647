"""The value of an expression that is shown, as it is printed.

Whatever else stands in it is looked up in the other equations shown, and integrated where they
show an integral.  Motions come from the kernel of the same conditions.
"""

import math
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp
from numpy.polynomial import legendre
from scipy.special import spherical_jn

from nonsmooth.codegen.equations.conditions.functions import R, t, u
from nonsmooth.codegen.equations.conditions.one_function import G, q
from nonsmooth.codegen.equations.conditions.polynomial import S
from nonsmooth.codegen.system import Equation

if TYPE_CHECKING:
    from shown_numbers import Numbers

NODES, WEIGHTS = legendre.leggauss(40)

_N = sp.Symbol("n", integer=True, nonnegative=True)


class UnknownError(Exception):
    """What cannot be evaluated: a derivative that the kernel does not give."""


class Evaluation:
    """One evaluation: in a phase, with values for `t`, `u` and indices."""

    def __init__(self, numbers: "Numbers", phase: int, more: dict[str, Any]) -> None:
        self.numbers, self.phase, self.more = numbers, phase, more

    def of(self, e: sp.Expr) -> Any:
        """Return the value of an expression."""
        if e.is_Rational:
            return float(e) if e.q > 1 else int(e)
        if e.is_Add or e.is_Mul:
            parts = [self.of(q) for q in e.args]
            total = parts[0]
            for part in parts[1:]:
                total = total + part if e.is_Add else total * part
            return total
        if e.is_Pow:
            base, exponent = self.of(e.base), self.of(e.exp)
            return np.asarray(base, dtype=float) ** exponent
        return getattr(self, f"_{type(e).__name__}")(e)

    def _within(self, e: sp.Expr, phase: int | None = None, **more: Any) -> Any:
        here = self.phase if phase is None else phase
        return Evaluation(self.numbers, here, self.more | more).of(e)

    def _Symbol(self, e: sp.Symbol) -> Any:
        if e.name in self.more:
            return self.more[e.name]
        return self.numbers.values[e.name.rstrip("+-").rstrip("^") if "^" in e.name else e.name]

    def _Pi(self, e: sp.Expr) -> float:
        return math.pi

    def _sin(self, e: sp.Expr) -> Any:
        return np.sin(self.of(e.args[0]))

    def _cos(self, e: sp.Expr) -> Any:
        return np.cos(self.of(e.args[0]))

    def _factorial(self, e: sp.Expr) -> Any:
        return math.factorial(self.of(e.args[0]))

    def _KroneckerDelta(self, e: sp.Expr) -> Any:
        return int(self.of(e.args[0]) == self.of(e.args[1]))

    def _jn(self, e: sp.Expr) -> Any:
        return spherical_jn(self.of(e.args[0]), self.of(e.args[1]))

    def _legendre(self, e: sp.Expr) -> Any:
        return legendre.legval(self.of(e.args[1]), np.eye(self.of(e.args[0]) + 1)[-1])

    def _bernoulli(self, e: sp.Expr) -> Any:
        polynomial = sp.Poly(e.func(self.of(e.args[0]), u), u)
        return np.polyval([float(q) for q in polynomial.all_coeffs()], self.of(e.args[1]))

    _euler = _bernoulli

    def _a(self, e: sp.Expr) -> Any:
        raise UnknownError(e)  # any function, in the definition of the inner product

    def _x(self, e: sp.Expr) -> Any:
        return self._motion(0, e.args[0])

    def _as_shown(self, e: sp.Expr) -> Any:
        assert e in (R, S, G, q)
        row = self.numbers.shown(lambda row: row.sides[0] == e, self.phase)
        return self.of(row.sides[1])

    _R = _S = _G = _q = _as_shown

    def _Rate(self, e: sp.Expr) -> Any:
        return self._motion(int(e.args[0]), e.args[1])

    def _motion(self, order: int, time: sp.Expr) -> Any:
        numbers = self.numbers
        if order > 2 and numbers.record.section == "3.3":
            raise UnknownError(order)
        case, z = tuple(numbers.case.values()), numbers.z
        motion = numbers.kernel.motion
        if time == t:
            p, ends = self.phase, numbers.ends
            local = (self.more["t"] - ends[p]) / (ends[p + 1] - ends[p])
            return motion(case, z, p, local, order)
        name = str(time)
        value, phases = self.of(time), len(numbers.scene.phases)
        p = int(np.argmin(np.abs(np.array(numbers.ends) - value)))
        left = name.endswith("^-") or (not name.endswith("^+") and p > 0)
        p, at = (p - 1, 1.0) if left else (p, 0.0)
        sign = 1
        if p < 0:  # before the cell: the end of it
            p, sign = phases - 1, numbers.scene.sign
        return sign * motion(case, z, p, np.array([at]), order)[0]

    def _Indexed(self, e: sp.Indexed) -> Any:
        indices = [int(self.of(q)) for q in e.indices]
        label = f"{e.base.label}[{', '.join(map(str, indices))}]"
        values = self.numbers.values
        if label in values:
            return values[label]
        if f"count {e.base.label}" in values:
            return 0.0  # beyond the last
        record = self.numbers.record
        found = {
            tuple(q.sides[0].indices): q
            for q in (*record.equations, *record.jacobian)
            if isinstance(q.sides[0], sp.Indexed) and q.sides[0].base == e.base
        }
        exact = tuple(map(sp.Integer, indices))
        if exact in found:
            return self.of(found[exact].sides[-1])
        fitting = [
            (at, q) for at, q in found.items() if str(at[-1]) == "l" and at[:-1] == exact[:-1]
        ]
        ((_, row),) = fitting
        return self._within(row.sides[-1], l=indices[-1])

    def _Sum(self, e: sp.Sum) -> Any:
        ((index, first, last),) = e.limits
        steps = range(int(self.of(first)), int(self.of(last)) + 1)
        return sum(self._within(e.function, **{index.name: i}) for i in steps)

    def _Integral(self, e: sp.Integral) -> Any:
        ((variable, start, end),) = e.limits
        low, high = self.of(start), self.of(end)
        nodes = low + (high - low) * (NODES + 1) / 2
        inside = self._within(e.function, **{variable.name: nodes}) * np.ones_like(nodes)
        return (high - low) / 2 * float(WEIGHTS @ inside)

    def _Inner(self, e: sp.Expr) -> Any:
        product = sp.Mul(*e.args)
        numbers = self.numbers
        if numbers.record.section == "3.3":
            return self._over(product, self.phase, local=True)
        return sum(self._over(product, p) for p in range(len(numbers.scene.phases)))

    def _over(self, product: sp.Expr, p: int, local: bool = False) -> float:
        low, high = self.numbers.ends[p : p + 2]
        part = (NODES + 1) / 2
        more = {"t": low + (high - low) * part, "u": part}
        inside = self._within(product, p, **more) * np.ones_like(part)
        return (1.0 if local else high - low) / 2 * float(WEIGHTS @ inside)

    def _ShiftedLegendre(self, e: sp.Expr) -> Any:
        degree, at = int(self.of(e.args[0])), self.of(e.args[1])
        if degree < 0:
            return -self._within(e.func(-1 - degree, e.args[1]))
        return legendre.legval(2 * at - 1, np.eye(degree + 1)[-1])

    def _TwiceIntegrated(self, e: sp.Expr) -> Any:
        row = self.numbers.shown(lambda q: q.sides[0].func == e.func)
        return self._within(row.sides[-1], n=int(self.of(e.args[0])), u=self.of(e.args[1]))

    def _Member(self, e: sp.Expr) -> Any:
        name, index, argument = e.args
        number, at = int(self.of(index)), self.of(argument)
        if name.name == "beta" and number == 0:
            return -1.0 if self.numbers.scene.sign == 1 else 0.0

        def defines(row: Equation) -> bool:
            left = row.sides[0]
            same = left.func == e.func and left.args[0] == name
            return same and left.args[1] in (
                sp.Integer(number),
                sp.Symbol("n", **_N.assumptions0),
            )

        row = self.numbers.shown(defines, self.phase)
        variable = str(row.sides[0].args[2])
        return self._within(row.sides[1], **{"n": number, variable: at})
