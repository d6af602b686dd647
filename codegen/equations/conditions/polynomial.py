"""Conditions on a motion that is a polynomial on each phase, to be printed."""

import re
from collections.abc import Iterator, Mapping
from importlib import import_module

import sympy as sp

from ...galerkin import Condition, GalerkinConditions, polynomials
from ...galerkin.legendre import Moments, l, n, repeated_integral
from ...galerkin.polynomials import Rest, Test, moments, series, trial_switches
from ...scene import linear_phase
from ...system import Equation, Inner, ShiftedLegendre, TwiceIntegrated, line
from ..tidy import by_entries, by_unknown
from .family import Family
from .functions import R, Rate, member, t, u, x

#: Equation numbers of the paper; those but (18) are for functions of class C^1.
NUMBERS = {"acceleration": "15", "expansion": "16", "residual": "17", "tests": "18"}

#: Equation numbers of the conditions of periodicity, at the begin of the first phase.
REPEATS = {"displacement": "19", "velocity": "20"}

TIMES = {1: "once", 2: "twice"}

#: The part of the residual that is orthogonal to all tests.
S = sp.Function("S")(t)


class Polynomial(Family):
    """The equations of a scene whose motion is a polynomial on each phase."""

    section = "3.3"

    def __init__(self, conditions: GalerkinConditions) -> None:
        super().__init__(conditions)
        self.switches = trial_switches(conditions.scene)
        self.trial = series(conditions.scene, self.notation.times, self.switches)
        self.moments = tuple(moments(conditions.scene, self.notation.times))
        name = conditions.method.replace("-", "_")
        expansion = import_module(f"...expansions.{name}", __package__)
        self.test: Test = expansion.test
        self.rest: Rest | None = getattr(expansion, "rest", None)

    @staticmethod
    def fits(conditions: GalerkinConditions) -> bool:
        """Return whether the state at the begin of each phase is unknown."""
        names = {block.name for block in conditions.blocks}
        return all(f"x_{phase.name}" in names for phase in conditions.scene.phases)

    def equations(self) -> Iterator[Equation]:
        """Yield the expansion, the residual, the conditions, and the moments they use."""
        yield from self._expansion()
        yield from self._basis()
        yield from self._residual()
        yield from self._tests()
        yield from self.rows
        yield from map(_moment, self.moments)

    def jacobian(self) -> Iterator[Equation]:
        """Yield the derivatives of the moments by the times."""
        yield from (_moment(q, turned=True) for q in self.moments)
        for q in self.moments:
            for time in self.notation.times.unknown:
                rate = q.rate(time)
                if rate != 0:
                    sides = (sp.Derivative(q.symbol[l], time, evaluate=False), by_entries(rate))
                    yield line("time derivative", sides)

    def _number(self, name: str, p: int) -> str:
        """Return the equation number of the paper, if phase `p` is of class C^1 as there."""
        return NUMBERS[name] if self.switches[p].k == 1 else ""

    def _expansion(self) -> Iterator[Equation]:
        for p, q in enumerate(self.trial):
            name, when, s = self.scene.phases[p].name, self.notation.during(p), q.duration
            if q.acceleration is not None:
                sums = [self._sum(p, function) for function in self._functions()]
                velocity = q.velocity + s * sums[1]
                place = q.displacement + s * u * q.velocity + s**2 * sums[0]
                number, sides = self._number("acceleration", p), (Rate(2, t), sums[2])
                yield Equation(number, f"acceleration in {name}", sides, when)
            else:
                velocity, place = q.velocity, q.displacement + s * u * q.velocity
            yield line(f"velocity in {name}", (Rate(1, t), velocity), when)
            number = self._number("expansion", p)
            yield Equation(number, f"expansion in {name}", (x(t), place), when)
            local = (u, (t - self.notation.at(p)) / s)
            yield line(f"local time in {name}, from 0 to 1", local)

    def _sum(self, p: int, function: sp.Expr) -> sp.Expr:
        q = self.trial[p]
        return sp.Sum(q.a(n) * function, (n, 0, q.count - 1))

    def _functions(self) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
        """Return ``Q_n`` and its first and second derivative, ``P_n*``."""
        return TwiceIntegrated(n, u), member("Q'", n, u), ShiftedLegendre(n, u)

    def _basis(self) -> Iterator[Equation]:
        twice, once, legendre = self._functions()
        sides = (legendre, sp.legendre(n, 2 * u - 1))
        yield line("shifted Legendre polynomial", sides)
        for times, function in ((1, once), (2, twice)):
            words = f"integrated {TIMES[times]} from 0"
            sides = (function, _combined(repeated_integral(n, times)))
            yield line(words, sides)
        below = ShiftedLegendre(-n - 1, u), -legendre
        yield line("what stands for a degree below zero", below)

    def _residual(self) -> Iterator[Equation]:
        scene = self.scene
        for p, q in enumerate(self.trial):
            if q.acceleration is None:
                continue
            phase, s = linear_phase(scene.cell[p]), q.duration
            twice, once, legendre = self._functions()
            factor = phase.m * legendre + phase.c * s * once + phase.k * s**2 * twice
            total = self._sum(p, factor) + (phase.c + phase.k * s * u) * q.velocity
            total += phase.k * q.displacement - phase.f
            total -= phase.g * self.notation.times.forcing(t)
            name, when = scene.phases[p].name, self.notation.during(p)
            number = self._number("residual", p)
            yield Equation(number, f"residual in {name}", (R, total), when)
        first, second = sp.Function("a")(t), sp.Function("b")(t)
        integral = sp.Integral(first * second, (u, 0, 1))
        yield line("inner product on a phase", (Inner(first, second), integral))

    def _tests(self) -> Iterator[Equation]:
        for p, switch in enumerate(self.switches):
            weights = self.test(n, switch.k)
            if self.trial[p].acceleration is not None and len(weights) > 1:
                name = self.scene.phases[p].name
                times = TIMES.get(switch.k + 1, f"{switch.k + 1} times")
                words = f"test function in {name}, `P_n` integrated {times} from the switch"
                sides = (member(f"W_{name}", n, u), _combined(weights))
                yield line(words, sides)
            if self.trial[p].acceleration is not None and self.rest is not None:
                yield from self._left(p, self.rest)

    def _left(self, p: int, rest: Rest) -> Iterator[Equation]:
        """Yield orthogonality to all tests of a phase, and the residual that it allows."""
        phase, switch = self.scene.phases[p], self.switches[p]
        name, rows = phase.name, polynomials.rows_of(self.trial[p], switch)
        tested = (Inner(R, member(f"W_{name}", l, u)), sp.Integer(0))
        where = f"`l = 0, ..., {rows - 1}`"
        words = f"residual of {name}, orthogonal to its tests"
        yield Equation(NUMBERS["tests"], words, tested, where)
        polynomial = sp.Sum(rest(n, l, switch.k) * ShiftedLegendre(l, u), (l, 0, n))
        words = (
            f"polynomial in {name} that is orthogonal to the tests of index below its degree"
        )
        yield line(words, (member(f"J_{name}", n, u), polynomial))
        mass, tau = linear_phase(phase).m, sp.IndexedBase(f"tau_{name}", real=True)
        count = len(polynomials.rest_of(phase, switch, self.test))
        parts = (tau[i] * member(f"J_{name}", rows + i, u) for i in range(count))
        words = f"what no test in {name} sees, of degree up to `{rows + switch.k}`"
        yield line(words, (S, mass * sp.Add(*parts)), self.notation.during(p))

    def closed(self, condition: Condition) -> sp.Expr:
        """Return a condition as a sum of unknowns with their factors."""
        blocks, symbols = self.conditions.blocks, self.scene.symbols
        return by_unknown(condition, blocks, symbols, lambda factor: factor)

    @property
    def numbers(self) -> Mapping[str, str]:
        """Equation numbers of the scene, and of periodicity.

        The latter apply only if the cell is a whole period and begins with class C^1.
        """
        numbers = dict(self.notation.numbers)
        first_switch = self.switches[0]
        if first_switch.k == 1 and self.notation.times.sign == 1:
            numbers |= {f"{name}_{first_switch.before}": n for name, n in REPEATS.items()}
        return numbers

    def title(self, condition: Condition) -> str:
        """Return the title of a condition, with its degree marked."""
        head, _, index = condition.title.rpartition(" ")
        return f"{head} `{index}`" if condition.index is not None else condition.title

    def tested(self, condition: Condition) -> tuple[sp.Expr, ...]:
        """Return the inner product of an orthogonality condition."""
        name, kind, index = re.findall(r"(.+)_(by|rest)_(\w+)", condition.name)[0]
        p = [phase.name for phase in self.scene.phases].index(name)
        degree = sp.Integer(index) if condition.index is None else condition.index
        if kind == "rest":
            degree += polynomials.rows_of(self.trial[p], self.switches[p])
        if self.rest is not None:
            return ((2 * degree + 1) * Inner(R - S, ShiftedLegendre(degree, u)),)
        return (Inner(R, _combined(self.test(degree, self.switches[p].k))),)


def _moment(phase_moments: Moments, turned: bool = False) -> Equation:
    """Return the definition of the moments of the forcing, or of those with theta + pi/2."""
    kappa, theta = phase_moments.kappa, phase_moments.theta + (sp.pi / 2 if turned else 0)
    wave = sp.cos(kappa * u + theta)
    sign = -1 if wave.could_extract_minus_sign() else 1
    integral = sign * sp.Integral(ShiftedLegendre(l, u) * sign * wave, (u, 0, 1))
    closed = sp.cos(theta + kappa / 2 + l * sp.pi / 2) * sp.jn(l, kappa / 2)
    title = "moment of the forcing; `j_l` is the spherical Bessel function"
    symbol = phase_moments.turned if turned else phase_moments.symbol
    return line(title, (symbol[l], integral, closed))


def _combined(weights: Mapping[sp.Expr, sp.Expr]) -> sp.Expr:
    """Return a combination of shifted Legendre polynomials."""
    return sp.Add(*(weight * ShiftedLegendre(degree, u) for degree, weight in weights.items()))
