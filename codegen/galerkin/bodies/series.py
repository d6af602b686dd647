"""The force series: Galerkin projection of contact forces onto Legendre polynomials.

A force that the laws prescribe is one constant.  Any other has N + 1 unknown coefficients, and
its law is tested with as many polynomials.  The integrals are those of `force_series`.
"""

from collections.abc import Iterator

import sympy as sp

from ...scene import Scene
from ...system import Equation, ShiftedLegendre, line
from .. import force_series
from ..condition import Block, BodyConditions, Condition, N
from ..force_series import kappa
from . import joints
from .contacts import OfForces, dot, j, pole

m, n = sp.symbols("m n", integer=True, nonnegative=True)

#: Local time of a phase, and the earlier one at which a force acts.
u, y = sp.symbols("u y", nonnegative=True)


def derive(scene: Scene, method: str, title: str) -> BodyConditions:
    """Return the conditions of a body in the force series."""
    series = _Series(scene)
    rows = (
        *(row for p in series.phases for row in series.tested(p)),
        *joints.conditions(scene, series.times, series.seen),
    )
    fields = (
        tuple(series.blocks()),
        series.times,
        rows,
        tuple(series.expansion()),
        tuple(series.tables()),
    )
    return BodyConditions(scene, method, title, *fields)


class _Series(OfForces):
    """The symbols and conditions of the force series of one scene."""

    def force(self, p: int, c: int) -> sp.IndexedBase:
        """Return the coefficients of a force in a phase."""
        word = self.scene.phases[p].name
        return sp.IndexedBase(self.contacts.name("f", c, word=word), real=True)

    def last(self, p: int) -> sp.Expr:
        """Return the degree of the forces in a phase."""
        return sp.Integer(0) if self.contacts.is_given(p) else N

    def blocks(self) -> Iterator[Block]:
        """Yield the unknown coefficients."""
        for p, phase in enumerate(self.scene.phases):
            for c, contact in enumerate(self.contacts.each):
                what = f"force at {contact.name} in {phase.name} in Legendre polynomials"
                yield Block(self.force(p, c), self.last(p) + 1, what)
        yield from joints.blocks(self.scene)

    def expansion(self) -> Iterator[Equation]:
        """Yield the forces in each phase, at its local time."""
        for p, phase in enumerate(self.scene.phases):
            for c, contact in enumerate(self.contacts.each):
                series = sp.Sum(
                    self.force(p, c)[n] * ShiftedLegendre(n, u), (n, 0, self.last(p))
                )
                entry = sp.Function(self.contacts.name("f", c))(u)
                words = f"force at {contact.name} in {phase.name}, at its local time"
                yield line(words, (entry, series.doit(deep=False)), "`0 <= u <= 1`")

    def wave(self, p: int) -> sp.Expr:
        """Return the forcing where phase `p` begins, as a complex wave."""
        return sp.exp(sp.I * self.times.angle(self.times.start(p)))

    def seen(self, p: int, at_end: bool) -> list[sp.Expr]:
        """Return the signals of forms at the begin or end of a phase, with zero forces."""
        q, letter = (p + 1, "w") if at_end else (p, "z")
        state, wave = self.table(letter, phase=p)[j], self.wave(q)
        parts = self.contacts.of_poles(state, wave if self.times.frequency else sp.Integer(0))
        return self.contacts.seen(parts, self.times.forcing(self.times.start(q)), sp.S.One)

    def tested(self, p: int) -> Iterator[Condition]:
        """Yield the Galerkin conditions of the laws of a phase."""
        name, last = self.scene.phases[p].name, self.last(p)
        wave, cosine = sp.Integer(0), sp.Integer(0)
        if self.times.frequency is not None:
            wave = self.wave(p) * self.table("nu", phase=p)[m]
            cosine = sp.re(wave)
        parts = self.contacts.of_poles(self.table("y", phase=p)[m, j], wave)
        signals = self.contacts.seen(parts, cosine, sp.KroneckerDelta(m, 0))
        forces = [self.force(p, c)[m] / (2 * m + 1) for c in range(self.count)]
        values = self.contacts.forced(signals, forces)
        for contact, law in zip(self.contacts.each, self.contacts.laws(p), strict=True):
            title = f"the law at {contact.name} in {name}, tested with `P*_m`"
            row = dot(law, values)
            if last == 0:
                yield Condition(f"law_{contact.name}_{name}", title, row.subs(m, 0))
            else:
                yield Condition(f"law_{contact.name}_{name}", title, row, m, sp.S.Zero, N + 1)

    def tables(self) -> Iterator[Equation]:
        """Yield the tables that the conditions use."""
        yield from integrals()
        phases = self.scene.phases
        cell, sign = self.times.cell, self.times.sign
        for p, phase in enumerate(phases):
            s = self.times.durations[p]
            gain = self._by_forces(p, (-1) ** n * self.table("a", phase=p)[n, j])
            of_phase = sp.Integral(ShiftedLegendre(m, u) * sp.exp(pole[j] * s * u), (u, 0, 1))
            words = f"what a pole makes in {phase.name} of its state"
            yield line(words, (self.table("a", phase=p)[m, j], of_phase, a_at(m, pole[j] * s)))
            words = f"what a pole makes in {phase.name} of a force"
            yield line(words, (self.table("Z", phase=p)[m, n, j], Z_at(m, n, pole[j] * s)))
            if self.times.frequency is not None:
                words = f"the forcing in {phase.name}, tested"
                turned = sp.I * self.times.frequency * s
                yield line(words, (self.table("nu", phase=p)[m], a_at(m, turned)))
            words = f"what the force in {phase.name} adds to a pole"
            yield line(words, (self.table("g", phase=p)[j], s * gain))
        words = f"state of a pole where {phases[0].name} begins: the motion repeats"
        repeated = sign * self._added() / (1 - sign * sp.exp(pole[j] * cell))
        yield line(words, (self.table("z", phase=0)[j], repeated))
        for p, phase in enumerate(phases):
            s = self.times.durations[p]
            z, w = self.table("z", phase=p)[j], self.table("w", phase=p)[j]
            words = f"state of a pole where {phase.name} ends"
            end = sp.exp(pole[j] * s) * z + self.table("g", phase=p)[j]
            yield line(words, (w, end))
            if p + 1 < len(phases):
                words = f"state of a pole where {phases[p + 1].name} begins"
                yield line(words, (self.table("z", phase=p + 1)[j], w + self._pushed(p)))
        for p, phase in enumerate(phases):
            s = self.times.durations[p]
            forced = self._by_forces(p, self.table("Z", phase=p)[m, n, j])
            tested = self.table("a", phase=p)[m, j] * self.table("z", phase=p)[j] + s * forced
            words = f"state of a pole in {phase.name}, tested with `P*_m`"
            yield line(words, (self.table("y", phase=p)[m, j], tested))

    def _by_forces(self, p: int, weight: sp.Expr) -> sp.Expr:
        """Return the modal force on a pole by weighted coefficients of forces in a phase."""
        limits = n, 0, self.last(p)
        sums = (
            sp.Sum(weight * self.force(p, c)[n], limits).doit(deep=False)
            for c in range(self.count)
        )
        return sp.Add(*(self.contacts.chi(c) * total for c, total in enumerate(sums)))

    def _pushed(self, p: int) -> sp.Expr:
        """Return the jump of a pole's state by the impulses at the end of a phase."""
        contacts = self.contacts
        hit = (c for c, _ in contacts.impulses(p))
        return sp.Add(*(contacts.chi(c) * joints.impulse(contacts, p, c) for c in hit))

    def _added(self) -> sp.Expr:
        """Return the state of a pole after a cell that begins at 0."""
        parts = []
        for p in self.phases:
            remaining = sp.Add(*self.times.durations[p + 1 :])
            added = self.table("g", phase=p)[j] + self._pushed(p)
            parts.append(sp.exp(pole[j] * remaining) * added)
        return sp.Add(*parts)


#: ``a_m``, ``b_n`` and ``Z_mn`` as functions of kappa, for display.
a_at, b_at, Z_at = map(sp.Function, "abZ")


def integrals() -> Iterator[Equation]:
    """Yield the two integrals of `force_series` and their emitted recurrences."""
    formulas = {q.name: q.value for q in force_series.formulas()}
    before, here = force_series.before, force_series.here
    indices = force_series.m, force_series.n
    common = {force_series.grown: sp.exp(kappa), force_series.inverse: 1 / kappa}

    def put(name: str, values: dict[sp.Symbol, sp.Expr]) -> sp.Expr:
        return formulas[name].subs(dict(zip(indices, (m, n), strict=True)) | common | values)

    power = sp.Integral(ShiftedLegendre(m, u) * sp.exp(kappa * u), (u, 0, 1))
    yield line("what a pole makes of its state", (a_at(m, kappa), power))
    yield line("its first entry", (a_at(0, kappa), put("moment_0", {})))
    yield line("its second entry", (a_at(1, kappa), put("moment_1", {here: a_at(0, kappa)})))
    recurrence = put("next_moment", {before: a_at(m - 1, kappa), here: a_at(m, kappa)})
    yield line("its recurrence", (a_at(m + 1, kappa), recurrence), "`m > 0`")
    words = (
        "what a pole keeps of a force: the inner integral is `b_n e^(kappa u)` and a polynomial"
    )
    yield line(words, (b_at(0, kappa), put("answer_0", {})))
    yield line("its second entry", (b_at(1, kappa), put("answer_1", {here: b_at(0, kappa)})))
    recurrence = put("next_answer", {before: b_at(n - 1, kappa), here: b_at(n, kappa)})
    yield line("its recurrence", (b_at(n + 1, kappa), recurrence), "`n > 0`")
    inner = sp.Integral(sp.exp(kappa * (u - y)) * ShiftedLegendre(n, y), (y, 0, u))
    double_integral = sp.Integral(ShiftedLegendre(m, u) * inner, (u, 0, 1))
    yield line("what a pole makes of a force", (Z_at(m, n, kappa), double_integral))
    product = a_at(m, kappa) * b_at(n, kappa)
    yield line("below the diagonal", (Z_at(m, n, kappa), product), "`m > n`")
    yield line("above it", (Z_at(n, m, kappa), (-1) ** (m + n) * Z_at(m, n, kappa)), "`m > n`")
    entry = put("response_0", {here: a_at(0, kappa), force_series.after: a_at(1, kappa)})
    yield line("its first entry", (Z_at(0, 0, kappa), entry))
    values = {before: Z_at(n, n - 1, kappa), force_series.after: Z_at(n + 1, n, kappa)}
    yield line("on the diagonal", (Z_at(n, n, kappa), put("same_response", values)), "`n > 0`")
