"""The harmonics of the contact forces of a scene: symbols, tables, and forms of these."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import sympy as sp

from ...scene import Scene, switches
from ..condition import N
from . import joints
from .contacts import OfForces, j, pole

#: Index of a harmonic: of a test, of a force, of a product.
m, n, l = sp.symbols("m n l", integer=True)

t, u, T, omega_0 = sp.symbols("t u T omega_0", positive=True)

#: ``beta(n, age)``, the age being the time since the break over the cell; the response of pole
#: j to it.
beta, rho = sp.Function("beta"), sp.Function("rho")


class Function(NamedTuple):
    """A function ``beta_n`` in a contact force, with its break where a phase begins."""

    phase: int
    n: int
    contact: int


class Terms(OfForces):
    """The harmonics of one scene: symbols of its unknowns and tables, and forms of them.

    Parameters
    ----------
    scene : Scene
    functions : int
        Number of functions added to the harmonics at each switch.
    """

    def __init__(self, scene: Scene, functions: int) -> None:
        super().__init__(scene)
        lowest = [max(switch.k, 1) for switch in switches(scene)]
        self.functions = [
            Function(p, lowest[p] + i, c)
            for p in self.phases
            for i in range(functions)
            for c in range(self.count)
        ]
        self.impulses = [(p, c) for p in self.phases for c, _ in self.contacts.impulses(p)]

    @property
    def cell(self) -> sp.Expr:
        """The duration of a cell."""
        return T if self.times.sign == 1 else T / 2

    @property
    def has_breaks(self) -> bool:
        """Whether there are functions with breaks, or impulses."""
        return bool(self.functions or self.impulses)

    @property
    def limits(self) -> tuple[sp.Expr, sp.Expr]:
        """The first and the last index of a harmonic."""
        return (-N if self.times.sign == 1 else 1 - N), N

    def mirrored(self, index: sp.Expr) -> sp.Expr:
        """Return the index of the harmonic with the opposite number."""
        return -index if self.times.sign == 1 else 1 - index

    def wave(self, index: sp.Expr, p: int) -> sp.Expr:
        """Return the value of a harmonic where phase `p` begins."""
        return sp.exp(sp.I * self.times.harmonic(index) * omega_0 * self.times.start(p))

    def force(self, c: int) -> sp.IndexedBase:
        """Return the symbol of the harmonics of force `c`."""
        return self.table("f", c)

    def factor(self, q: Function) -> sp.Symbol:
        """Return the symbol of the coefficient of a function."""
        word = self.scene.phases[q.phase].name
        return sp.Symbol(self.contacts.name(f"c{q.n}", q.contact, word=word), real=True)

    def moment(self, r: int, c: int, d: int) -> sp.Expr:
        """Return ``Re sum lambda_j^r psi_j chi_j``: 0 for r = 0, the mobility for r = 1, ..."""
        if r < 2:
            return sp.Integer(0) if r == 0 else self.contacts.mobility(c, d)
        return self.table("Y", c, d)[r]

    def compliance(self, q: int, c: int, d: int) -> sp.Expr:
        """Return ``Re sum lambda_j^q psi_j z_j`` at contact `c` by harmonic n of force `d`."""
        turn = sp.I * self.times.harmonic(n) * omega_0
        moments = (turn ** (q - 1 - r) * self.moment(r, c, d) for r in range(q))
        return turn**q * self.table("H", c, d)[n] - sp.Add(*moments)

    def breaks(self) -> Iterator[tuple[int, int, int, sp.Expr]]:
        """Yield switch, n (0 for an impulse), contact and factor of functions and impulses."""
        for q in self.functions:
            yield q.phase, q.n, q.contact, self.factor(q)
        for p, c in self.impulses:
            yield p + 1, 0, c, joints.impulse(self.contacts, p, c)

    def aged(self, p: int, q: int, at_end: bool) -> tuple[int, sp.Expr]:
        """Return sign and age, over the cell, of a break at `p` at an end of phase `q`."""
        end = self.cell if q + at_end == len(self.phases) else self.times.start(q + at_end)
        begin = self.cell if p == len(self.phases) else self.times.start(p)
        wrapped = q < p
        return (self.times.sign if wrapped else 1), (end - begin) / self.cell + int(wrapped)

    def state(self, q: int, at_end: bool) -> sp.Expr:
        """Return the state of a pole by the breaks, where a phase begins or ends."""
        return self.table("w" if at_end else "z", phase=q)[j]

    def derivatives(self, p: int, at_end: bool, q: int) -> list[tuple[sp.Expr, ...]]:
        """Return ``Re sum lambda_j^r psi_j z_j`` of each contact, for r from q to q + 2."""
        derivatives, wave = [], self.wave(n, p + at_end)
        for c in range(self.count):
            parts = []
            for r in range(q, q + 3):
                by_force = (
                    self.compliance(r, c, d) * self.force(d)[n] for d in range(self.count)
                )
                total = sp.Sum(sp.Add(*by_force) * wave, (n, *self.limits))
                if self.has_breaks:
                    of_pole = pole[j] ** r * self.contacts.psi(c) * self.state(p, at_end)
                    total += self.contacts.summed(of_pole)
                parts.append(total)
            derivatives.append(tuple(parts))
        return derivatives

    def seen(self, p: int, at_end: bool, q: int = 0) -> list[sp.Expr]:
        """Return derivative q of the signals of forms where a phase begins or ends.

        Derivative q of the forces is 0; lower ones are those by the law of the phase.
        """
        parts = self.derivatives(p, at_end, q)
        angle, driven = self.times.angle(self.times.start(p + at_end)), sp.Integer(0)
        if self.times.frequency is not None:
            turn = (sp.I * self.times.frequency) ** q
            wave = turn * sp.exp(sp.I * angle)
            answers = self.contacts.of_response()
            parts = [
                tuple(a + sp.re(b * wave) for a, b in zip(derivatives, answer, strict=True))
                for derivatives, answer in zip(parts, answers, strict=True)
            ]
            driven = sp.cos(angle + q * sp.pi / 2) * self.times.frequency**q
        lower = [self.law(p, at_end, r) for r in range(q)]
        for c, part in enumerate(parts):
            added = (
                sp.Add(*(
                    self.moment(q + shift - 1 - r, c, d) * lower[r][d]
                    for r in range(q) for d in range(self.count)
                ))
                for shift in range(3)
            )  # fmt: skip
            parts[c] = tuple(a + b for a, b in zip(part, added, strict=True))
        return self.contacts.seen(parts, driven, sp.Integer(q == 0))

    def law(self, p: int, at_end: bool, q: int) -> list[sp.Expr]:
        """Return derivative q of the forces by the law of a phase, at its begin or end."""
        return self.contacts.by_law(p, self.seen(p, at_end, q))

    def constant(self, p: int) -> list[sp.Expr]:
        """Return the constant part of the forces in a phase, with that of memories."""
        nothing = [(sp.Integer(0),) * 3] * self.count
        return self.by_parts(p, nothing, one=1)

    def driven(self, p: int) -> list[sp.Expr]:
        """Return the complex amplitude of the forces in a phase by the forcing."""
        if self.times.frequency is None:
            return [sp.Integer(0)] * self.count
        return self.by_parts(p, self.contacts.of_response(), wave=1)

    def by_parts(
        self, p: int, parts: Sequence[tuple[sp.Expr, ...]], wave: int = 0, one: int = 0
    ) -> list[sp.Expr]:
        """Return the forces in a phase by displacements, velocities, accelerations alone.

        `wave` and `one` are put in place of the forcing and of 1.
        """
        signals = self.contacts.seen(parts, sp.Integer(wave), sp.Integer(one))
        return self.contacts.by_law(p, signals)
