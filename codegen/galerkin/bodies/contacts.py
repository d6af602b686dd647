"""The contacts of a body: their displacements by its poles, and the forces by their laws."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import sympy as sp

from ...scene import Scene, switches
from ...scene.bodies.body import Contact
from ...scene.bodies.law import body_of, form, law_rows, place
from ..condition import Times

#: The index of a pole, and the number of poles, one of each complex pair.
j, L = sp.symbols("j L", integer=True, positive=True)

pole = sp.IndexedBase("lambda")

#: The rate at which the velocity of a held contact returns to the prescribed one.
RATE = sp.Symbol("omega_r", positive=True)


@dataclass(frozen=True)
class Contacts:
    """The contacts of a scene's body: their symbols in the equations, and their laws.

    ``z_j' = lambda_j z_j + sum chi_j f`` and ``x = Re sum psi_j z_j + Re(X e^(i angle)) + D f``
    at each contact.  A force f adds ``Y f`` to the acceleration, with the mobility Y of the
    modes that are kept.
    """

    scene: Scene

    @cached_property
    def each(self) -> tuple[Contact, ...]:
        """The contacts."""
        return self.scene.contacts

    def name(self, letter: str, *which: int, word: str = "") -> str:
        """Return a letter with the names of contacts, if there are several, and a word."""
        names = [self.each[c].name for c in which] if len(self.each) > 1 else []
        return "_".join(filter(None, (letter, *names, word)))

    def psi(self, c: int) -> sp.Expr:
        """Return the displacement of contact `c` by a pole."""
        return sp.IndexedBase(self.name("psi", c))[j]

    def chi(self, c: int) -> sp.Expr:
        """Return the modal force of a force at contact `c` on a pole."""
        return sp.IndexedBase(self.name("chi", c))[j]

    def response(self, c: int) -> sp.Symbol:
        """Return the complex amplitude of contact `c` in the steady response to the forcing."""
        return sp.Symbol(self.name("X", c), complex=True)

    def mobility(self, c: int, d: int) -> sp.Symbol:
        """Return the acceleration at contact `c` by a unit force at `d`."""
        return sp.Symbol(self.name("Y", c, d), real=True)

    def static(self, c: int, d: int) -> sp.Expr:
        """Return the residual flexibility: displacement at `c` by a force at `d`."""
        return sp.Symbol(self.name("D", c, d), real=True) if self.gives else sp.Integer(0)

    @cached_property
    def gives(self) -> bool:
        """Whether modes left out add a flexibility: if no force jumps, without a memory."""
        if body_of(self.scene).modes is None or self.scene.memory:
            return False
        motions = self.scene.each_motion
        return all(switch.jumps > 2 for motion in motions for switch in switches(motion))

    def whole(self, c: int, d: int, held: bool) -> sp.Symbol:
        """Return the mobility of the whole body; before a held phase that of the modes kept."""
        if held or body_of(self.scene).modes is None:
            return self.mobility(c, d)
        return sp.Symbol(self.name("W", c, d), real=True)

    def seen(
        self, parts: Sequence[Sequence[sp.Expr]], wave: sp.Expr, one: sp.Expr
    ) -> list[sp.Expr]:
        """Return the signals of which forms are linear combinations, with zero forces.

        Parameters
        ----------
        parts : sequence of (Expr, Expr, Expr)
            Displacement, velocity and acceleration of each contact.
        wave, one : Expr
            In place of the forcing and of 1.
        """
        signals: dict[int, sp.Expr] = {2: wave, 3: one}
        for contact, values in zip(self.each, parts, strict=True):
            for symbol, value in zip((contact.x, contact.v, contact.a), values, strict=True):
                signals[place(self.scene, symbol)] = value
        width = 2 + 4 * len(self.each)
        memory = [q.symbol * one for q in self.scene.memory]
        return [signals.get(i, sp.Integer(0)) for i in range(width)] + memory

    def forced(
        self, without_forces: Sequence[sp.Expr], forces: Sequence[sp.Expr]
    ) -> list[sp.Expr]:
        """Return the signals with the forces, and with their direct effects, added."""
        scene, signals = self.scene, list(without_forces)
        for c, contact in enumerate(self.each):
            signals[place(scene, contact.force)] += forces[c]
            for d, force in enumerate(forces):
                signals[place(scene, contact.x)] += self.static(c, d) * force
                signals[place(scene, contact.a)] += self.mobility(c, d) * force
        return signals

    def of_response(self) -> list[tuple[sp.Expr, ...]]:
        """Return displacement, velocity, acceleration of the response to ``e^(i Omega t)``."""
        turn = sp.I * (self.scene.frequency or 0)
        return [
            tuple(self.response(c) * turn**q for q in range(3)) for c in range(len(self.each))
        ]

    def of_poles(self, state: sp.Expr, wave: sp.Expr) -> list[tuple[sp.Expr, ...]]:
        """Return the same for a given state of a pole, and the forcing as a complex wave."""
        motions = []
        for c, answers in enumerate(self.of_response()):
            sums = (self.summed(pole[j] ** q * self.psi(c) * state) for q in range(3))
            waves = (sp.re(answer * wave) for answer in answers)
            motions.append(tuple(a + b for a, b in zip(sums, waves, strict=True)))
        return motions

    @staticmethod
    def summed(of_pole: sp.Expr) -> sp.Expr:
        """Return the real part of a sum over the poles."""
        return sp.re(sp.Sum(of_pole, (j, 1, L)))

    def laws(self, p: int) -> list[tuple[sp.Expr, ...]]:
        """Return the laws of a phase as forms; a held contact returns to its velocity."""
        phase, rows = self.scene.cell[p], law_rows(self.scene.cell[p], self.scene)
        if phase.held is not None:
            a, v = (place(self.scene, q) for q in (self.each[0].a, self.each[0].v))
            row = [entry / rows[0][a] for entry in rows[0]]
            row[v] += RATE
            row[3] -= RATE * sp.sympify(phase.held)
            rows[0] = tuple(row)
        return rows

    def is_given(self, p: int) -> bool:
        """Return whether the laws of a phase prescribe its forces, whatever the motion."""
        symbols = (q for c in self.each for q in (c.x, c.v, c.a))
        moving = [2, *(place(self.scene, q) for q in symbols)]
        return all(row[i] == 0 for row in self.laws(p) for i in moving)

    def by_law(self, p: int, without_forces: Sequence[sp.Expr]) -> list[sp.Expr]:
        """Return the forces by the laws of a phase, from the signals without forces."""
        laws, count = self.laws(p), len(self.each)
        nothing = [sp.Integer(0)] * len(without_forces)
        columns = [
            self.forced(nothing, [sp.Integer(c == d) for d in range(count)])
            for c in range(count)
        ]
        direct = sp.Matrix(count, count, lambda c, d: dot(laws[c], columns[d]))
        unforced = sp.Matrix([dot(law, without_forces) for law in laws])
        return [sp.factor_terms(-q) for q in direct.LUsolve(unforced)]

    def form(self, expression: sp.Expr, memory: bool = True) -> tuple[sp.Expr, ...]:
        """Return the factors of a linear form of the scene."""
        return form(expression, self.scene, self.scene.name, memory)

    def impulses(self, p: int) -> Iterator[tuple[int, sp.Expr]]:
        """Yield the contacts with an impulse at the end of a phase, and their velocity then."""
        scene, (q, sign) = self.scene, self.scene.after(p)
        after = scene.phases[q]
        for c, contact in enumerate(self.each):
            law = sp.sympify(scene.phases[p].ends.jump.get(contact.v, contact.v))
            if c == 0 and after.held is not None:
                law = sign * sp.sympify(after.held)
            if law != contact.v:
                yield c, law


class OfForces:
    """Scene, times and contacts of an expansion of contact forces, and symbols of tables."""

    def __init__(self, scene: Scene) -> None:
        self.scene, self.times, self.contacts = scene, Times.of(scene), Contacts(scene)
        self.count, self.phases = len(self.contacts.each), range(len(scene.phases))

    def table(self, letter: str, *which: int, phase: int | None = None) -> sp.IndexedBase:
        """Return the symbol of a table, with the names of contacts and of a phase."""
        word = "" if phase is None else self.scene.phases[phase].name
        return sp.IndexedBase(self.contacts.name(letter, *which, word=word))


def dot(row: Sequence[sp.Expr], values: Sequence[sp.Expr]) -> sp.Expr:
    """Return the value of a form: the sum of factors times values."""
    return sp.Add(*(a * b for a, b in zip(row, values, strict=True)))
