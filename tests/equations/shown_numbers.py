"""Numbers for everything that is shown: each side of an equation evaluated as it is printed.

Random values for parameters, times and coefficients; `shown_evaluation` does the rest.
"""

import math
import re
from collections.abc import Callable
from typing import Any

import numpy as np
import sympy as sp
from galerkin.derived import of_conditions
from shown_evaluation import Evaluation

from nonsmooth.codegen.equations import method_equations
from nonsmooth.codegen.equations.conditions.family import shown
from nonsmooth.codegen.galerkin import GalerkinConditions
from nonsmooth.codegen.galerkin.harmonics import a, b
from nonsmooth.codegen.system import Equation

N = sp.Symbol("N", integer=True, positive=True)


class Numbers:
    """Values for what is shown of some conditions.

    Parameters
    ----------
    conditions : GalerkinConditions
    order : int
        ``N``.
    """

    def __init__(self, conditions: GalerkinConditions, order: int) -> None:
        self.conditions, self.scene = conditions, conditions.scene
        self.record = method_equations(conditions)
        self.order = order
        drawn = np.random.default_rng(7)
        symbols = self.scene.symbols
        values = drawn.uniform(0.5, 1.5, len(symbols))
        self.case: dict[str, float] = dict(zip(map(str, symbols), values, strict=True))
        if self.scene.frequency is not None:  # for a reader, one cycle of the forcing
            self.case["cycles"] = 1
        self.values: dict[str, float] = self.case | {"N": order, "pi": math.pi}
        self._times(drawn)
        self._coefficients(drawn)
        self.kernel = of_conditions(conditions)

    def _times(self, drawn: np.random.Generator) -> None:
        times = self.conditions.times
        durations = drawn.uniform(0.5, 1.5, len(times.durations))
        if times.frequency is not None:  # the cell is as long as the forcing makes it
            turns = math.pi * (1 if times.sign == -1 else 2)
            durations *= turns / self.case[str(times.frequency)] / durations.sum()
            self.values["phi"] = drawn.uniform(0, 2)
        self.ends = [0.0, *np.cumsum(durations)]
        self.values |= {str(s): d for s, d in zip(times.durations, durations, strict=True)}
        self.values |= {f"t{p}": end for p, end in enumerate(self.ends)}
        self.values["0"] = 0.0
        self.values["T"] = self.ends[-1] * (2 if times.sign == -1 else 1)
        self.values["omega_0"] = 2 * math.pi / self.values["T"]

    def _coefficients(self, drawn: np.random.Generator) -> None:
        parts = []
        for block in self.conditions.blocks:
            count = int(sp.sympify(block.count).subs(N, self.order))
            found = drawn.uniform(-1, 1, count)
            if isinstance(block.symbol, sp.IndexedBase):
                first = int(block.symbol in (a, b))  # harmonics are counted from 1
                for i, value in enumerate(found, start=first):
                    self.values[f"{block.name}[{i}]"] = value
                self.values.setdefault(f"count {block.name}", first + count)
            else:
                self.values[block.name] = self.values[str(shown(block))] = found[0]
            parts.append(found)
        names = map(str, self.conditions.times.unknown)
        self.z = np.concatenate([*parts, [self.values[name] for name in names]])

    def rows(self) -> np.ndarray:
        """Return the residual of the kernel."""
        found = np.zeros(len(self.z))
        self.kernel.residual(tuple(self.case.values()), self.z, found)
        return found

    def at(self, expression: sp.Expr, phase: int = 0, **more: Any) -> Any:
        """Return the value of an expression; `t`, `u` or an index in `more`."""
        return Evaluation(self, phase, more).of(sp.sympify(expression))

    def phase_of(self, equation: Equation) -> int:
        """Return the phase that an equation is about."""
        when = re.search(r"`(\w+) <= t", equation.where)
        if when:
            return 0 if when[1] == "0" else int(when[1].removeprefix("t"))
        names = [phase.name for phase in self.scene.phases]
        found = [p for p, name in enumerate(names) if re.search(rf"\b{name}\b", equation.title)]
        return found[0] if found else 0

    def shown(self, wanted: Callable[[Equation], bool], phase: int | None = None) -> Equation:
        """Return the equation shown that defines something, in a phase."""
        rows = (*self.record.equations, *self.record.jacobian)
        found = [q for q in rows if wanted(q)]
        here = [q for q in found if phase is None or self.phase_of(q) == phase]
        return (here or found)[0]
