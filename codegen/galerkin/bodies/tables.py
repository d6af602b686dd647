"""The tables of the conditions on harmonics: compliances, integrals, responses to breaks."""

from collections.abc import Iterator
from functools import cache

import sympy as sp

from ...system import Equation, line
from .. import force_harmonics, harmonics
from .contacts import L, j, pole
from .terms import Terms, beta, l, m, n, omega_0, rho, t, u


@cache
def _formula(name: str) -> sp.Expr:
    """Return an emitted closed form by its name."""
    return next(q.value for q in force_harmonics.formulas() if q.name == name)


def tables(terms: Terms) -> Iterator[Equation]:
    """Yield the tables that the conditions use."""
    answer = _formula("answer")
    turn = terms.times.harmonic(n) * omega_0
    for c in range(terms.count):
        for d in range(terms.count):
            at_pole = answer.subs({force_harmonics.omega: turn, force_harmonics.s: pole[j]})
            at_conjugate = at_pole.subs(pole[j], sp.conjugate(pole[j]))
            product = terms.contacts.psi(c) * terms.contacts.chi(d)
            compliance = (product * at_pole + sp.conjugate(product) * at_conjugate) / 2
            words = "dynamic compliance: a harmonic of a displacement by that of a force"
            closed = sp.Sum(compliance, (j, 1, L))
            yield line(words, (terms.table("H", c, d)[n], closed))
            top = max((q.n for q in terms.functions), default=0)
            for r in range(2, top + 2):
                total = terms.contacts.summed(
                    pole[j] ** r * terms.contacts.psi(c) * terms.contacts.chi(d)
                )
                words = "what a force adds to a higher derivative of a displacement"
                yield line(words, (terms.moment(r, c, d), total))
    for p in terms.phases:
        yield from _of_phase(terms, p)
    if terms.has_breaks:
        yield from _of_breaks(terms)


def _of_phase(terms: Terms, p: int) -> Iterator[Equation]:
    name = terms.scene.phases[p].name
    ends = terms.times.start(p), terms.times.start(p + 1)
    wave = sp.exp(sp.I * l * omega_0 * t)
    mean = sp.Integral(wave, (t, *ends)) / terms.cell
    closed = wave.subs(t, ends[1]) - wave.subs(t, ends[0])
    words = f"integral of a harmonic over {name}, over the cell"
    entry = terms.table("I", phase=p)
    sides = entry[l], mean, closed / (sp.I * l * omega_0 * terms.cell)
    yield line(words, sides, "`l != 0`")
    yield line(words, (entry[0], terms.times.durations[p] / terms.cell))
    if terms.contacts.is_given(p):
        return
    for d in range(terms.count):
        parts = [tuple(terms.compliance(q, c, d) for q in range(3)) for c in range(terms.count)]
        for c, force in enumerate(terms.by_parts(p, parts)):
            words = f"what the law in {name} makes of a harmonic of the force"
            yield line(words, (terms.table("G", c, d, phase=p)[n], force))


def _answer(terms: Terms, k: int, age: sp.Expr) -> sp.Expr:
    """Return the periodic response of a pole to an impulse, or for k > 0 to ``beta_k``."""
    kappa = pole[j] * terms.cell
    by_impulse = sp.exp(kappa * age) / (1 - terms.times.sign * sp.exp(kappa))
    return rho(k, age, j) if k else by_impulse


def _answers(terms: Terms) -> Iterator[Equation]:
    """Yield the functions ``beta_k``, and the periodic responses of a pole to them."""
    if not terms.functions:
        return
    kappa, k = pole[j] * terms.cell, sp.Symbol("k", integer=True, positive=True)
    function = harmonics.beta(k, u, terms.times.sign)
    mean = 1 / kappa if terms.times.sign == 1 else sp.Integer(0)
    where = "`0 <= u <= 1`"
    yield line("function with a break at `u = 0`", (beta(k, u), function), where)
    words = "what pole j answers in every cell to the derivative of the first function"
    yield line(words, (rho(0, u, j), terms.cell * (_answer(terms, 0, u) + mean)), where)
    words = "what it answers to a function"
    closed = (rho(k - 1, u, j) - terms.cell * beta(k, u)) / kappa
    yield line(words, (rho(k, u, j), closed), where)


def _of_breaks(terms: Terms) -> Iterator[Equation]:
    """Yield the terms of impulses and functions: in the states of poles, and in the rows."""
    test = terms.times.harmonic(m) * omega_0
    yield from _answers(terms)
    for q in terms.functions:
        closed = _formula("harmonic").subs(
            {force_harmonics.omega: test * terms.cell, force_harmonics.n: q.n}
        )
        shifted = closed / terms.wave(m, q.phase)
        where = "`m != 0`, else 0" if terms.times.sign == 1 else ""
        if q.contact == 0:
            entry = terms.table("b", phase=q.phase)[q.n, m]
            yield line(f"harmonic of beta_{q.n}", (entry, shifted), where)
    for p in terms.phases:
        name = terms.scene.phases[p].name
        for at_end in (False, True):
            summands = []
            for place, k, c, factor in terms.breaks():
                sign, age = terms.aged(place, p, at_end)
                summands.append(sign * factor * terms.contacts.chi(c) * _answer(terms, k, age))
            words = "ends" if at_end else "begins"
            title = f"what impulses and functions make of a pole where {name} {words}"
            yield line(title, (terms.state(p, at_end), sp.Add(*summands)))
        if terms.contacts.is_given(p):
            continue
        forced = []
        for c in range(terms.count):
            functions = [q for q in terms.functions if q.contact == c]
            if not functions:
                continue
            wave = sp.exp(-sp.I * test * t)
            ends = terms.times.start(p), terms.times.start(p + 1)
            parts = []
            for q in functions:
                sign, age = terms.aged(q.phase, p, False)
                age += (t - terms.times.start(p)) / terms.cell
                integral = sp.Integral(beta(q.n, age) * wave, (t, *ends))
                parts.append(sign * terms.factor(q) * integral / terms.cell)
            entry = terms.table("F", c, phase=p)[m]
            yield line(f"the functions in {name}, tested", (entry, sp.Add(*parts)))
            forced.append(terms.contacts.chi(c) * entry)
        start, end = (terms.state(p, side) / terms.wave(m, p + side) for side in (False, True))
        arguments = {force_harmonics.omega: test, force_harmonics.s: pole[j]}
        tested = _formula("answer").subs(arguments)
        tested *= sp.Add(*forced) - (end - start) / terms.cell
        entry = terms.table("y", phase=p)
        yield line(f"a pole in {name}, tested, of these", (entry[m, j], tested))
        parts = [
            tuple(pole[j] ** r * terms.contacts.psi(c) for r in range(3))
            for c in range(terms.count)
        ]
        for c, weight in enumerate(terms.by_parts(p, parts)):
            direct = weight * entry[m, j]
            mirrored = sp.conjugate(weight * entry[terms.mirrored(m), j])
            words = f"what the law in {name} makes of these, tested"
            pole_sum = sp.Sum((direct + mirrored) / 2, (j, 1, L))
            yield line(words, (terms.table("B", c, phase=p)[m], pole_sum))
