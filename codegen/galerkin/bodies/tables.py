"""What the conditions on harmonics look up: compliances, integrals, answers to breaks."""

from collections.abc import Iterator
from functools import cache

import sympy as sp

from .. import force_harmonics, harmonics
from ..condition import Table
from .contacts import L, j, pole
from .terms import Terms, beta, l, m, n, omega_0, rho, t, u


@cache
def _formula(name: str) -> sp.Expr:
    """Return one of the closed forms that are emitted, by its name."""
    return next(q.value for q in force_harmonics.formulas() if q.name == name)


def tables(own: Terms) -> Iterator[Table]:
    """Yield what the conditions look up."""
    answer = _formula("answer")
    turn = own.times.harmonic(n) * omega_0
    for c in range(own.count):
        for d in range(own.count):
            one = answer.subs({force_harmonics.omega: turn, force_harmonics.s: pole[j]})
            other = one.subs(pole[j], sp.conjugate(pole[j]))
            product = own.contacts.psi(c) * own.contacts.chi(d)
            both = (product * one + sp.conjugate(product) * other) / 2
            words = "dynamic compliance: a harmonic of a displacement by that of a force"
            closed = sp.Sum(both, (j, 1, L))
            yield Table(own.table("H", c, d)[n], words, (closed,))
            top = max((q.n for q in own.functions), default=0)
            for r in range(2, top + 2):
                total = own.contacts.summed(
                    pole[j] ** r * own.contacts.psi(c) * own.contacts.chi(d)
                )
                words = "what a force adds to a higher derivative of a displacement"
                yield Table(own.moment(r, c, d), words, (total,))
    for p in own.phases:
        yield from _of_phase(own, p)
    if own.has_breaks:
        yield from _of_breaks(own)


def _of_phase(own: Terms, p: int) -> Iterator[Table]:
    name = own.scene.phases[p].name
    ends = own.times.start(p), own.times.start(p + 1)
    wave = sp.exp(sp.I * l * omega_0 * t)
    mean = sp.Integral(wave, (t, *ends)) / own.cell
    closed = wave.subs(t, ends[1]) - wave.subs(t, ends[0])
    words = f"integral of a harmonic over {name}, over the cell"
    sides = mean, closed / (sp.I * l * omega_0 * own.cell)
    entry = own.table("I", phase=p)
    yield Table(entry[l], words, sides, "`l != 0`")
    yield Table(entry[0], words, (own.times.durations[p] / own.cell,))
    if own.contacts.is_given(p):
        return
    for d in range(own.count):
        parts = [tuple(own.compliance(q, c, d) for q in range(3)) for c in range(own.count)]
        for c, force in enumerate(own.by_parts(p, parts)):
            words = f"what the law in {name} makes of a harmonic of the force"
            yield Table(own.table("G", c, d, phase=p)[n], words, (force,))


def _answer(own: Terms, k: int, age: sp.Expr) -> sp.Expr:
    """Return what a pole answers in every cell to an impulse, or to ``beta_k``."""
    kappa = pole[j] * own.cell
    alone = sp.exp(kappa * age) / (1 - own.times.sign * sp.exp(kappa))
    return rho(k, age, j) if k else alone


def _answers(own: Terms) -> Iterator[Table]:
    """Yield the functions, and what a pole answers to them: their derivatives' integral."""
    if not own.functions:
        return
    kappa, k = pole[j] * own.cell, sp.Symbol("k", integer=True, positive=True)
    function = harmonics.beta(k, u, own.times.sign)
    mean = 1 / kappa if own.times.sign == 1 else sp.Integer(0)
    where = "`0 <= u <= 1`"
    yield Table(beta(k, u), "function with a break at `u = 0`", (function,), where)
    words = "what pole j answers in every cell to the derivative of the first function"
    yield Table(rho(0, u, j), words, (own.cell * (_answer(own, 0, u) + mean),), where)
    words = "what it answers to a function"
    closed = (rho(k - 1, u, j) - own.cell * beta(k, u)) / kappa
    yield Table(rho(k, u, j), words, (closed,), where)


def _of_breaks(own: Terms) -> Iterator[Table]:
    """Yield what impulses and functions make of the poles, and of the rows."""
    test = own.times.harmonic(m) * omega_0
    yield from _answers(own)
    for q in own.functions:
        closed = _formula("harmonic").subs(
            {force_harmonics.omega: test * own.cell, force_harmonics.n: q.n}
        )
        shifted = closed / own.wave(m, q.phase)
        where = "`m != 0`, else 0" if own.times.sign == 1 else ""
        if q.contact == 0:
            entry = own.table("b", phase=q.phase)[q.n, m]
            yield Table(entry, f"harmonic of beta_{q.n}", (shifted,), where)
    for p in own.phases:
        name = own.scene.phases[p].name
        for at_end in (False, True):
            total = []
            for place, k, c, factor in own.breaks():
                sign, age = own.aged(place, p, at_end)
                total.append(sign * factor * own.contacts.chi(c) * _answer(own, k, age))
            words = "ends" if at_end else "begins"
            title = f"what impulses and functions make of a pole where {name} {words}"
            yield Table(own.state(p, at_end), title, (sp.Add(*total),))
        if own.contacts.is_given(p):
            continue
        forced = []
        for c in range(own.count):
            here = [q for q in own.functions if q.contact == c]
            if not here:
                continue
            wave = sp.exp(-sp.I * test * t)
            ends = own.times.start(p), own.times.start(p + 1)
            parts = []
            for q in here:
                sign, age = own.aged(q.phase, p, False)
                age += (t - own.times.start(p)) / own.cell
                integral = sp.Integral(beta(q.n, age) * wave, (t, *ends))
                parts.append(sign * own.factor(q) * integral / own.cell)
            entry = own.table("F", c, phase=p)[m]
            yield Table(entry, f"the functions in {name}, tested", (sp.Add(*parts),))
            forced.append(own.contacts.chi(c) * entry)
        start, end = (own.state(p, side) / own.wave(m, p + side) for side in (False, True))
        answer = {force_harmonics.omega: test, force_harmonics.s: pole[j]}
        tested = _formula("answer").subs(answer)
        tested *= sp.Add(*forced) - (end - start) / own.cell
        entry = own.table("y", phase=p)
        yield Table(entry[m, j], f"a pole in {name}, tested, of these", (tested,))
        parts = [
            tuple(pole[j] ** r * own.contacts.psi(c) for r in range(3))
            for c in range(own.count)
        ]
        for c, weight in enumerate(own.by_parts(p, parts)):
            both = weight * entry[m, j]
            other = sp.conjugate(weight * entry[own.mirrored(m), j])
            words = f"what the law in {name} makes of these, tested"
            total_ = sp.Sum((both + other) / 2, (j, 1, L))
            yield Table(own.table("B", c, phase=p)[m], words, (total_,))
