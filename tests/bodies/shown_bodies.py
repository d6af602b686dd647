"""The value of what is shown of a body: tables are looked up, integrals are by quadrature."""

from typing import Any

import numpy as np
import sympy as sp
from numpy.polynomial import legendre

from nonsmooth.codegen.equations.registry import conditions
from nonsmooth.codegen.galerkin.bodies.contacts import RATE
from nonsmooth.codegen.galerkin.condition import BodyConditions, N
from nonsmooth.codegen.scene import Scene
from nonsmooth.solver.bodies.force_series.layout import for_harmonics, layout
from nonsmooth.solver.bodies.harmonics import system as harmonics
from nonsmooth.solver.bodies.motion import solved
from nonsmooth.solver.bodies.poles import poles_of
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.scenes.case import Case

NODES, WEIGHTS = legendre.leggauss(120)


class Shown:
    """A record with numbers: of a case, at given times, with the kernel's coefficients.

    Parameters
    ----------
    scene, case : Scene, Case
        The same, as a record and as it is loaded.
    method, order, functions
    times : ndarray
        Durations, and the phase of the forcing.
    """

    def __init__(
        self, scene: Scene, case: Case, method: str, order: int, functions: int, times: Any
    ) -> None:
        count = functions if method == "hb-ck" else None
        self.record = conditions(scene, method, count)
        assert isinstance(self.record, BodyConditions)
        self.kept: dict[Any, complex] = {}
        cell = case.cell
        self.values: dict[str, complex] = {
            str(q.symbol): value
            for q, value in zip(scene.parameters, case.numbers, strict=True)
        }
        for symbol, value in zip(self.record.times.unknown, times, strict=True):
            self.values[str(symbol)] = float(value)
        length = cell.duration if cell.forced else float(sum(times[: len(cell.phases)]))
        T = length * cell.cells
        poles, names = poles_of(cell.body, cell.omega), [q.name for q in scene.body.at.values()]
        own = {"T": T, "omega_0": 2 * np.pi / T, "cycles": cell.cycles, "L": len(poles.s)}
        own |= {str(RATE): cell.omega or 1.0}
        self.families = {"lambda": poles.s}
        one = len(names) == 1
        for c, name in enumerate(names):
            self.families["psi" if one else f"psi_{name}"] = poles.c[:, c]
            self.families["chi" if one else f"chi_{name}"] = poles.b[:, c]
            own["X" if one else f"X_{name}"] = poles.response[c]
            for d, other in enumerate(names):
                for letter, matrix in (
                    ("Y", cell.body.kept_mobility),
                    ("D", cell.body.residual),
                    ("W", cell.body.mobility),
                ):
                    own[letter if one else f"{letter}_{name}_{other}"] = matrix[c, d]
        self.values |= own
        self.forced, self.sign, self.contacts = cell.forced, cell.sign, names
        self.phases = (
            layout(cell, order) if method == "ck-tau" else for_harmonics(cell)
        ).phases
        if method == "ck-tau":
            unknowns, _ = solved(cell, order, times)
            self._of_series(unknowns, layout(cell, order))
        else:
            beside = functions if method == "hb-ck" else 0
            found = harmonics.evaluated(cell, order, beside, times)
            unknowns = found.unknowns
            self._of_harmonics(unknowns, found.frame.waves // len(names), cell.sign)
        kernel = registry.kernel(case.scene, method, functions if method == "hb-ck" else None)
        self.residual, self.size = np.empty(len(times)), max(1.0, np.abs(unknowns).max())
        kernel.residual(kernel.given(case, order), times, self.residual)
        if method == "hb-ck":  # jumps of derivatives have powers of the poles
            self.size *= max(1.0, float(np.abs(poles.s).max()) * length) ** functions

    def _of_series(self, unknowns: Any, own: Any) -> None:
        self.values["N"] = max(phase.degree for phase in own.phases)
        at, contacts = 0, own.poles.b.shape[1]
        blocks = iter(self.record.blocks)
        for phase in own.phases:
            for c in range(contacts):
                name = str(next(blocks).symbol)
                last = at + (phase.degree + 1) * contacts
                self.families[name] = unknowns[at + c : last : contacts]
            at = last
        for value, block in zip(unknowns[at:], blocks, strict=True):
            self.values[str(block.symbol)] = float(value)

    def _of_harmonics(self, unknowns: Any, count: int, sign: int) -> None:
        self.values["N"] = (count - 1) // 2 if sign > 0 else count // 2
        names = [
            str(q.symbol) for q in self.record.blocks if isinstance(q.symbol, sp.IndexedBase)
        ]
        for c, name in enumerate(names):
            self.families[name] = unknowns[c : count * len(names) : len(names)]
            self.values[f"first {name}"] = -self.values["N"] + (sign < 0)
        rest = self.record.blocks[len(names) :]
        for value, block in zip(unknowns[count * len(names) :], rest, strict=True):
            self.values[str(block.symbol)] = float(value.real)

    def rows(self) -> tuple[list[complex], list[complex]]:
        """Return the values of the events, and of all other conditions, row by row.

        With what the solver adds: to a force without a forcing multiples of the events.
        """
        rows = []
        for q in self.record.conditions:
            bounds = (sp.sympify(b).subs(N, int(self.values["N"])) for b in (q.first, q.count))
            first, count = map(int, bounds)
            for i in range(first, first + count):
                value = self.of(q.expression, {} if q.index is None else {q.index: i})
                rows.append((q.name, i, value))
        events = [value for name, _, value in rows if name.startswith("event")]
        others = [
            value + self._added(name, i) @ events
            for name, i, value in rows
            if not name.startswith("event")
        ]
        return events, others

    def _added(self, name: str, i: int) -> np.ndarray:
        """Return the factors of the events in a row of the solver; see `layout._fixing`."""
        count = len(self.phases)
        if self.forced or not name.startswith(("law", "harmonic")):
            return np.zeros(count)
        c = self.contacts.index(name.split("_")[1])
        if name.startswith("law"):
            own = [name.endswith(f"_{p}") and i < 2 for p in range(count)]
            return np.array([phase.fixing[c] for phase in self.phases]) * own
        by_law = [phase.fixing[c] / phase.direct[c, c] for phase in self.phases]
        turn = i * (np.pi if self.sign < 0 else 2 * np.pi)
        return by_law * np.exp(-1j * turn * np.arange(count) / count) / count * (abs(i) == 1)

    def of(self, e: sp.Expr, at: dict[sp.Expr, Any]) -> complex:
        """Return the value of an expression at values of its indices."""
        if e in at:
            return at[e]
        if e.is_Number:
            return complex(e) if e.q > 1 else int(e)
        return getattr(self, f"_{type(e).__name__}")(e, at)

    def _Add(self, e: sp.Add, at: Any) -> complex:
        return sum(self.of(q, at) for q in e.args)

    def _Mul(self, e: sp.Mul, at: Any) -> complex:
        found: complex = 1
        for q in e.args:
            found = found * self.of(q, at)
            if not np.any(found):
                return 0  # what is beside is not looked up
        return found

    def _Pow(self, e: sp.Pow, at: Any) -> complex:
        return self.of(e.base, at) ** self.of(e.exp, at)

    def _Symbol(self, e: sp.Symbol, at: Any) -> complex:
        if str(e) in self.values:
            return self.values[str(e)]
        return self._looked_up(e, at)

    def _Pi(self, e: sp.Expr, at: Any) -> float:
        return np.pi

    def _ImaginaryUnit(self, e: sp.Expr, at: Any) -> complex:
        return 1j

    def _exp(self, e: sp.Expr, at: Any) -> complex:
        return np.exp(self.of(e.args[0], at))

    def _cos(self, e: sp.Expr, at: Any) -> complex:
        return np.cos(self.of(e.args[0], at))

    def _sin(self, e: sp.Expr, at: Any) -> complex:
        return np.sin(self.of(e.args[0], at))

    def _re(self, e: sp.Expr, at: Any) -> float:
        return np.real(self.of(e.args[0], at))

    def _im(self, e: sp.Expr, at: Any) -> float:
        return np.imag(self.of(e.args[0], at))

    def _conjugate(self, e: sp.Expr, at: Any) -> complex:
        return np.conj(self.of(e.args[0], at))

    def _factorial(self, e: sp.Expr, at: Any) -> float:
        return float(sp.factorial(self.of(e.args[0], at)))

    def _bernoulli(self, e: sp.Expr, at: Any) -> Any:
        u = sp.Symbol("u")
        found = sp.Poly(e.func(self.of(e.args[0], at), u), u)
        return np.polyval([float(q) for q in found.all_coeffs()], self.of(e.args[1], at))

    _euler = _bernoulli

    def _KroneckerDelta(self, e: sp.Expr, at: Any) -> int:
        return int(self.of(e.args[0], at) == self.of(e.args[1], at))

    def _ShiftedLegendre(self, e: sp.Expr, at: Any) -> Any:
        series_ = np.eye(int(self.of(e.args[0], at)) + 1)[-1]
        return legendre.legval(2 * self.of(e.args[1], at) - 1, series_)

    def _Sum(self, e: sp.Sum, at: Any) -> complex:
        ((index, first, last),) = e.limits
        span = range(int(self.of(first, at)), int(self.of(last, at)) + 1)
        return sum(self.of(e.function, at | {index: i}) for i in span)

    def _Integral(self, e: sp.Integral, at: Any) -> complex:
        ((variable, first, last),) = e.limits
        low, high = self.of(first, at), self.of(last, at)
        points = low + (high - low) * (NODES + 1) / 2
        if e.function.has(sp.Integral, sp.Function("beta")):
            values = [self.of(e.function, at | {variable: point}) for point in points]
        else:
            values = self.of(e.function, at | {variable: points})
        return (high - low) / 2 * np.dot(WEIGHTS, values)

    def _Indexed(self, e: sp.Indexed, at: Any) -> complex:
        name, where = str(e.base.label), [int(self.of(q, at)) for q in e.indices]
        if name in self.families:
            of_pole = name == "lambda" or name.startswith(("psi", "chi"))
            first = self.values.get(f"first {name}", int(of_pole))
            return self.families[name][where[0] - int(first)]
        return self._looked_up(e.base[tuple(map(sp.Integer, where))], at)

    def _a(self, e: sp.Expr, at: Any) -> complex:
        return self._looked_up(e, at)

    _Z = _beta = _rho = _a

    def _looked_up(self, e: sp.Expr, at: Any) -> complex:
        """Return what a table has for an entry; that with the fewest free indices."""
        head, slots = _split(e)
        given = [self.of(q, at) for q in slots]
        key = (head, *map(complex, given))
        if key not in self.kept:
            self.kept[key] = self._from_tables(head, given)
        return self.kept[key]

    def _from_tables(self, head: Any, given: list[Any]) -> complex:
        fits = []
        for table in self.record.tables:
            own, slots = _split(table.sides[0])
            pairs = list(zip(slots, given, strict=True)) if own == head else []
            if own == head and all(slot.is_Symbol or slot == value for slot, value in pairs):
                fits.append((sum(slot.is_Symbol for slot in slots), table, pairs))
        if not fits:
            raise KeyError(f"{head} at {given} is in no table")
        _, table, pairs = min(fits, key=lambda q: q[0])
        if "!= 0" in table.where and given[-1] == 0:
            return 0
        values = [
            self.of(side, {a: b for a, b in pairs if a.is_Symbol}) for side in table.sides[1:]
        ]
        assert np.allclose(values, values[0], rtol=1e-9, atol=1e-9), table.title
        return values[0]


def _split(e: sp.Expr) -> tuple[Any, tuple[sp.Expr, ...]]:
    """Return what a table is called, and the indices or arguments of an entry."""
    if isinstance(e, sp.Indexed):
        return e.base, e.indices
    return (e.func, e.args) if e.args else (e, ())
